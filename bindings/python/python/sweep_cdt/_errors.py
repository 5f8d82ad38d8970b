"""The exceptions: what cannot be triangulated, and which points and edges are to blame.

All but `InternalError` are kinds of `Error`, which is a `ValueError`. Each has the offenders as attributes, by their
positions in the arrays that were passed.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._remarks import Remark


class Error(ValueError):
    """What was passed cannot be used. The attributes of each kind name the offenders."""

    def __init__(self, message: str = "", **offenders: Any) -> None:
        super().__init__(message)
        self.__dict__.update(offenders)

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuilt, (type(self), self.args, self.__dict__)


def _rebuilt(kind: type[Error], args: tuple[Any, ...], offenders: dict[str, Any]) -> Error:
    return kind(*args, **offenders)


class ShapeError(Error):
    """An array has another shape than is asked for: `shape`, or `position` of the row that is too long or short."""

    shape: tuple[int, ...]
    position: int


class KindError(Error, TypeError):
    """An array holds, or an argument is, what is no number, or no number of this kind: `position`, if it is in an array."""

    position: tuple[int, ...]


class NonFiniteError(Error):
    """A coordinate is NaN or infinite: `vertex` and `axis`, and the `feature` where geometries were passed."""

    vertex: int
    axis: int
    feature: int | None


class EdgeOutOfRangeError(Error, IndexError):
    """An end of an edge is no point: `edge` and `vertex`."""

    edge: int
    vertex: int


class CrossingEdgesError(Error):
    """Two edges cross at a point that is none of the points: `edges`, a pair, and the `place`, rounded to doubles.

    `features` are their geometries or polygons, where such were passed. `split_crossings=True` splits them.
    """

    edges: tuple[int, int]
    place: tuple[float, float]
    features: tuple[int | None, int | None]


class OpenRingError(Error):
    """The edges are no closed rings, so that they bound nothing: they do not go on at `vertex`, which is at `place`.

    `feature` is its geometry, where geometries were passed.
    """

    vertex: int
    place: tuple[float, float]
    feature: int | None


class SeedError(Error):
    """The seed of a `hole` or `region` does not tell in which face it lies."""

    hole: int
    region: int


class MatchError(Error):
    """A vertex of a result is none of the input: `vertex`, its place `at`, and the `nearest` one of the input; or it may
    be two of the input, the `candidates`. An attribute that says nothing is `None`."""

    vertex: int
    at: tuple[float, float]
    nearest: int
    candidates: tuple[int, int]


class MissingError(Error, IndexError):
    """There is no `point` or `edge` of a number: it was removed, or is yet to come."""

    point: int
    edge: int


class PointInUseError(Error):
    """An `edge` ends at a `point` that is to be removed."""

    point: int
    edge: int


class NotDelaunayError(Error):
    """An edge keeps a `side`, a pair of points, from being Delaunay, so that there is no Voronoi diagram."""

    side: tuple[int, int]


class TooLargeError(Error):
    """There are more points, edges or crossings than the `limit`, or a number that is taken exactly has more digits, or a
    greater exponent: `vertex` and `axis`."""

    limit: int
    vertex: int
    axis: int


class OutOfMemoryError(Error, MemoryError):
    """There is less memory than the triangulation takes: some `bytes`."""

    bytes: int


class RemarkError(Error):
    """Something of the input would get lost, and ``strict=True`` refuses that: the `remarks` on it."""

    remarks: tuple[Remark, ...]


class InternalError(RuntimeError):
    """A bug of sweep-cdt. Please report it, with the input."""

    def __init__(self, message: str = "") -> None:
        super().__init__(message)


def check_distance(name: str, value: Any) -> None:
    """Refuses a distance that is none. `None` is not asked for."""
    if value is not None and not 0 <= value < math.inf:
        raise Error(f"{name} is {value}, not a finite number from 0 on")


# The kinds are known by the package, not by this file.
for _kind in list(globals().values()):
    if isinstance(_kind, type) and issubclass(_kind, Exception):
        _kind.__module__ = __package__
