"""Exact constrained Delaunay triangulation, and an exact verifier of triangulations of any program.

`triangulate` makes the constrained Delaunay triangulation of points and edges by the sweep-line algorithm of Domiter and
Žalik (2008), exactly for every input. `verify` proves the result of any library right, or says what is wrong with it.
`DynamicTriangulation` is one that changes.
`crossings` and `split` find and split edges that cross. `trace` and `measure` show how the sweep works.
"""

from ._crossings import Crossings, Split, crossings, split
from ._dynamic import Change, DynamicTriangulation
from ._errors import (
    CrossingEdgesError,
    EdgeOutOfRangeError,
    Error,
    InternalError,
    KindError,
    MatchError,
    MissingError,
    NonFiniteError,
    NotDelaunayError,
    OpenRingError,
    OutOfMemoryError,
    PointInUseError,
    RemarkError,
    SeedError,
    ShapeError,
    TooLargeError,
)
from ._measure import fronts, measure
from ._native import __version__
from ._remarks import Remark, RemarkWarning
from ._report import Report
from ._trace import Trace, trace
from ._triangulation import Triangulation, triangulate, triangulate_inside
from ._verify import assert_valid, verify
from ._voronoi import Voronoi

__all__ = [
    "Change",
    "CrossingEdgesError",
    "Crossings",
    "DynamicTriangulation",
    "EdgeOutOfRangeError",
    "Error",
    "InternalError",
    "KindError",
    "MatchError",
    "MissingError",
    "NonFiniteError",
    "NotDelaunayError",
    "OpenRingError",
    "OutOfMemoryError",
    "PointInUseError",
    "Remark",
    "RemarkError",
    "RemarkWarning",
    "Report",
    "SeedError",
    "ShapeError",
    "Split",
    "TooLargeError",
    "Trace",
    "Triangulation",
    "Voronoi",
    "__version__",
    "assert_valid",
    "crossings",
    "fronts",
    "measure",
    "split",
    "trace",
    "triangulate",
    "triangulate_inside",
    "verify",
]
