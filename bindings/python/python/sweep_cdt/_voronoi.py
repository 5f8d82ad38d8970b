"""Voronoi diagrams, with the names of SciPy, and cells as polygons."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native
from ._arrays import as_array, listed
from ._errors import KindError, ShapeError
from ._geometries import agree, as_geometries
from ._input import as_doubles, as_fractions, as_points, called
from ._remarks import say

if TYPE_CHECKING:
    from ._triangulation import Triangulation


def voronoi(self: Triangulation) -> Voronoi:
    """The Voronoi diagram of the points. Edges must not keep the triangulation from being Delaunay.

    Returns
    -------
    Voronoi

    Raises
    ------
    Error
        `NotDelaunayError`, if an edge does.

    Examples
    --------
    >>> import sweep_cdt
    >>> cells = sweep_cdt.triangulate([[0, 0], [4, 0], [4, 4], [0, 4], [8, 2]]).voronoi()
    >>> cells.vertices.tolist(), cells.regions[cells.point_region[1]]
    ([[2.0, 2.0], [5.5, 2.0]], [-1, 1, 0])
    """
    return Voronoi(self)


class Voronoi:
    """A Voronoi diagram; `Triangulation.voronoi` makes it. Its attributes have the names and meanings of SciPy's.

    Attributes
    ----------
    points : ndarray of shape (n, 2)
        The points.
    vertices : ndarray of shape (v, 2)
        The centres of empty circles through three points or more, each once: exact where the points are, and otherwise
        rounded once.
    ridge_points : ndarray of int of shape (r, 2)
        The two points whose cells a ridge separates.
    ridge_vertices : list of list of int
        The ends of each ridge as positions in `vertices`; -1 where it goes on for ever.
    ridge_directions : ndarray of shape (r, 2)
        The direction of each ridge towards its open end: a right angle to the way between its points, and as long.
    regions : list of list of int
        The vertices around each cell, counter-clockwise; the first is -1 of a cell without bounds.
    point_region : ndarray of int of shape (n,)
        The region of each point. Equal points share one.
    """

    def __init__(self, triangulation: Triangulation) -> None:
        if not hasattr(triangulation, "_core"):
            raise KindError("a Voronoi diagram is made of a triangulation: triangulate(points).voronoi()")
        self._of = triangulation
        found = called(_native.voronoi, triangulation._input, triangulation._core)
        vertices, ridge_points, ridge_vertices, directions, self._cells, self._begins = found
        self.points = triangulation.points
        self.vertices, self.ridge_directions = _places(vertices), _places(directions)
        self.ridge_points = ridge_points.view(np.intp)
        # As of SciPy, an end that is not there comes first.
        self.ridge_vertices = np.sort(ridge_vertices, axis=1).tolist() if len(ridge_vertices) else []
        self._is_open = np.unique(ridge_points[(ridge_vertices < 0).any(axis=1)])

    def __reduce__(self) -> tuple[Any, ...]:
        # The diagram depends on the triangulation alone.
        return Voronoi, (self._of,)

    def __repr__(self) -> str:
        return f"<Voronoi diagram of {len(self.points)} points: {len(self.vertices)} vertices>"

    @functools.cached_property
    def point_region(self) -> np.ndarray:
        first = np.arange(len(self.points))
        duplicates = self._of.duplicates
        first[duplicates[:, 0]] = duplicates[:, 1]
        return np.unique(first, return_inverse=True)[1].astype(np.intp)

    @functools.cached_property
    def regions(self) -> list[list[int]]:
        _, owners = np.unique(self.point_region, return_index=True)
        is_open = set(self._is_open.tolist())
        around = [self._cells[self._begins[v] : self._begins[v + 1]].tolist() for v in owners]
        return [[-1, *cell] if v in is_open else cell for v, cell in zip(owners.tolist(), around)]

    def cells(self, within: Any = None) -> np.ndarray:
        """The cells as polygons of shapely, cut to a box or to polygons.

        Parameters
        ----------
        within : tuple of x and y of two corners, or polygons as geometries, optional
            The box by its lower left and its upper right corner, as `bounds` of shapely; or any polygons with holes. The
            default is the box around the points, a tenth of its longer side larger on all sides.

        Returns
        -------
        ndarray of shape (n,)
            The polygon of each point, a multipolygon where it has several parts, and an empty one where nothing is left
            of it. Corners are rounded once. Equal points share a cell, with a `RemarkWarning`.

        Raises
        ------
        Error
            `ShapeError`, if `within` is neither four numbers nor polygons; `Error`, if it has another CRS.

        Examples
        --------
        >>> import shapely, sweep_cdt
        >>> shops = sweep_cdt.triangulate([[1, 1], [5, 1]]).voronoi()
        >>> [cell.bounds for cell in shops.cells(shapely.box(0, 0, 6, 4))]
        [(0.0, 0.0, 3.0, 4.0), (3.0, 0.0, 6.0, 4.0)]
        """
        given = self._of._input
        found, remarks = called(_native.cells, given, self._of._core, self._within(within))
        say(remarks)
        import shapely

        cells = np.full(len(self.points), shapely.Polygon(), dtype=object)
        for point, polygons in found:
            rings = [[as_doubles(ring) for ring in polygon] for polygon in polygons if len(polygon[0])]
            parts = [shapely.Polygon(outline, holes) for outline, *holes in rings]
            if parts:
                cells[point] = parts[0] if len(parts) == 1 else shapely.MultiPolygon(parts)
        duplicates = self._of.duplicates
        cells[duplicates[:, 0]] = cells[duplicates[:, 1]]
        return cells

    def to_geodataframe(self, within: Any = None) -> Any:
        """The cells as a `geopandas.GeoDataFrame` with the `crs` of the points: a row for each point.

        Parameters
        ----------
        within
            As of `cells`.
        """
        import geopandas

        return geopandas.GeoDataFrame(geometry=list(self.cells(within)), crs=self._of.crs)

    def _within(self, within: Any) -> Any:
        if within is None:
            return None
        if (geometries := as_geometries(listed(within), "within")) is None:
            box = as_array(listed(within), "within", columns=None)
            if box.shape != (4,) or box.dtype.kind not in "iuf":
                raise ShapeError(f"within has the shape {box.shape}: it is four numbers, or polygons", shape=box.shape)
            return box.astype(float).tolist()
        from ._triangulation import made
        from ._graph import as_input

        agree(self._of.crs, geometries.crs, "within")
        if any(getattr(of, "geom_type", None) == "LinearRing" for of in geometries.features):
            raise KindError("within is a ring, which bounds nothing: pass shapely.Polygon(ring)")
        domain = as_input(within)
        if self._of._input.is_exact and not domain.is_exact:
            domain = domain.changed(points=as_points(domain.points.astype(object)))
        result = made(domain, "polygons", False, None, None)
        return domain, result._core, result.rule


def _places(points: Any) -> np.ndarray:
    return points if isinstance(points, np.ndarray) else as_fractions(points)
