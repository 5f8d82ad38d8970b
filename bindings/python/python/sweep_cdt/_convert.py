"""A triangulation for other libraries: methods of `Triangulation`. Only what is inside is passed on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native
from ._arrays import as_values
from ._errors import Error, ShapeError
from ._input import as_doubles
from ._remarks import say

if TYPE_CHECKING:
    from ._triangulation import Triangulation


def to_matplotlib(self: Triangulation) -> Any:
    """The triangles inside as a `matplotlib.tri.Triangulation`: for `tripcolor`, `tricontour` and interpolators.

    Raises
    ------
    Error
        If no triangles are inside.

    Examples
    --------
    >>> import matplotlib, sweep_cdt
    >>> sweep_cdt.triangulate([[0, 0], [4, 0], [0, 4]]).to_matplotlib().triangles.tolist()
    [[2, 0, 1]]
    """
    import matplotlib.tri

    if not len(self.triangles):
        raise Error("there are no triangles inside, which matplotlib needs")
    x, y = as_doubles(self._input.points).T
    return matplotlib.tri.Triangulation(x, y, self.triangles)


def plot(self: Triangulation, ax: Any = None, **kwargs: Any) -> Any:
    """Draws the triangles inside, and the edges more heavily.

    Parameters
    ----------
    ax : matplotlib.axes.Axes, optional
        Where to draw. The default is the current axes.
    **kwargs
        For the lines of the triangles.

    Returns
    -------
    matplotlib.axes.Axes
    """
    import matplotlib.pyplot
    from matplotlib.collections import LineCollection

    ax = matplotlib.pyplot.gca() if ax is None else ax
    points = as_doubles(self._input.points)
    style = {"color": "0.6", "linewidth": 0.5, "zorder": 1, **kwargs}
    if len(self.triangles):
        ax.triplot(points[:, 0], points[:, 1], self.triangles, **style)
    ax.add_collection(LineCollection(points[self.constrained_sides], colors="C0", linewidths=1.5, zorder=2))
    ax.autoscale_view()
    ax.set_aspect("equal")
    return ax


def _places(self: Triangulation, z: Any) -> np.ndarray:
    points = as_doubles(self._input.points)
    heights = self.heights if z is None else as_values(z, len(points), "z")
    if heights is None:
        heights = np.zeros(len(points))
    elif heights.ndim != 1:
        raise ShapeError(f"z has the shape {heights.shape}, not ({len(points)},)", shape=heights.shape)
    say(_native.without_heights(heights))
    return np.column_stack([points, heights])


def to_meshio(self: Triangulation, z: Any = None) -> Any:
    """The triangles inside and the constrained sides as a `meshio.Mesh`.

    meshio writes all its formats of it but ``.msh``, of which it asks for more where there are lines: the command
    writes these. The ``cell_data`` are the ``region`` of each triangle, the ``edge`` of each line as of `edge_of`, and
    its ``marker``, where there are any; -1, and of markers 0, where a cell has none. Of several edges along a line the
    first counts, and for the marker the first with one.

    Parameters
    ----------
    z : array_like of shape (n,), optional
        The height of each point, in the units of the points. The default are `heights`; 0, if there are none.

    Raises
    ------
    Error
        `ShapeError` and `KindError`, if `z` has not a number for each point.

    Examples
    --------
    >>> import meshio, sweep_cdt
    >>> sweep_cdt.triangulate([[0, 0], [4, 0], [0, 4]]).to_meshio([1, 2, 3]).points.tolist()
    [[0.0, 0.0, 1.0], [4.0, 0.0, 2.0], [0.0, 4.0, 3.0]]
    """
    import meshio

    cells, data = [("triangle", self.triangles)], {}
    if self.region is not None:
        data["region"] = [self.region[self.inside]]
    if len(self.constrained_sides):
        cells.append(("line", self.constrained_sides))
        none = np.full(len(self.triangles), -1, dtype=np.int32)
        sides = self.constrained_sides
        for blocks in data.values():
            blocks.append(np.full(len(sides), -1, dtype=np.int32))
        edges = _edges_along(self, sides, np.arange(len(self.edges)))
        data["edge"] = [none, np.r_[self.edge_of, -1][edges].astype(np.int32)]
        if self.markers is not None:
            data["marker"] = [np.zeros_like(none), _markers_of(self, sides)]
    return meshio.Mesh(_places(self, z), cells, cell_data=data)


def _edges_along(self: Triangulation, sides: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """For each side the first of these edges that runs along it, -1 where there is none."""
    return self._core.edges_along(edges.astype(np.uintp), np.ascontiguousarray(sides, dtype=np.int32))


def _markers_of(self: Triangulation, sides: np.ndarray) -> np.ndarray:
    """The marker of each side, 0 where it has none: that of the first edge with a marker along it."""
    assert self.markers is not None
    marked = _edges_along(self, sides, np.flatnonzero(self.markers))
    # A number of -1 takes the last one.
    return np.r_[self.markers, 0][marked].astype(np.int32)


def to_pyvista(self: Triangulation, z: Any = None) -> Any:
    """The triangles inside and the constrained sides as a `pyvista.PolyData`, in doubles.

    Parameters
    ----------
    z : array_like of shape (n,), optional
        As of `to_meshio`.

    Raises
    ------
    Error
        As of `to_meshio`.

    Examples
    --------
    >>> import pyvista, sweep_cdt
    >>> sweep_cdt.triangulate([[0, 0], [4, 0], [0, 4]]).to_pyvista([1, 2, 3]).bounds[4:]
    (1.0, 3.0)
    """
    import pyvista

    def cells(rows: np.ndarray) -> np.ndarray:
        return np.column_stack([np.full(len(rows), rows.shape[1]), rows]).ravel()

    mesh = pyvista.PolyData(_places(self, z), faces=cells(self.triangles))
    if len(self.constrained_sides):
        mesh.lines = cells(self.constrained_sides)
    return mesh


def to_shapely(self: Triangulation) -> Any:
    """The triangles inside as a `shapely.GeometryCollection` of polygons, as `shapely.delaunay_triangles` has them.

    They have a z, if there are `heights`.

    Examples
    --------
    >>> import shapely, sweep_cdt
    >>> roof = shapely.Polygon([(0, 0, 1), (4, 0, 2), (0, 4, 3)])
    >>> print(sweep_cdt.triangulate(roof).to_shapely())
    GEOMETRYCOLLECTION Z (POLYGON Z ((0 4 3, 0 0 1, 4 0 2, 0 4 3)))
    """
    import shapely

    return shapely.GeometryCollection(list(_polygons(self)))


def _polygons(self: Triangulation) -> np.ndarray:
    """The triangles inside as polygons of shapely."""
    import shapely

    points = as_doubles(self._input.points) if self.heights is None else _places(self, None)
    return shapely.polygons(points[self.triangles[:, [0, 1, 2, 0]]])


def to_geodataframe(self: Triangulation) -> Any:
    """The triangles inside as a `geopandas.GeoDataFrame`, with the `crs`, and with a z, if there are `heights`.

    Returns
    -------
    geopandas.GeoDataFrame
        A row for each of `triangles`. If there are regions, the column ``region`` has those of `Triangulation.region`:
        of a GeoDataFrame the positions of its rows, so that ``frame.iloc[triangles.region]`` has their columns.

    Examples
    --------
    >>> import geopandas, shapely, sweep_cdt
    >>> boxes = [shapely.box(0, 0, 1, 1), shapely.box(1, 0, 2, 1)]
    >>> land = geopandas.GeoDataFrame({"name": ["a", "b"]}, geometry=boxes, crs=2056)
    >>> triangles = sweep_cdt.triangulate(land).to_geodataframe()
    >>> sorted(land.name.iloc[triangles.region]), triangles.crs.to_epsg()
    (['a', 'a', 'b', 'b'], 2056)
    """
    import geopandas

    columns = {} if self.region is None else {"region": self.region[self.inside]}
    return geopandas.GeoDataFrame(columns, geometry=_polygons(self), crs=self.crs)


def to_triangle(self: Triangulation) -> dict[str, np.ndarray]:
    """The dictionary that `triangle.triangulate` returns and takes: of the triangles inside.

    The dictionary has the vertices, triangles and segments, a point in each hole, and `heights` as attributes of the
    vertices; no neighbors, which `triangle` gives and does not take. The segments are the constrained sides; where all of
    the hull is inside, those of the hull too, as of triangle's option ``c``. The arrays are copies, which may be written
    to. Equal points stay, and may make `triangle` crash.

    Returns
    -------
    dict of ndarray
        ``vertices`` of shape (n, 2), ``triangles`` of shape (u, 3), ``segments`` of shape (s, 2), ``holes`` of shape
        (h, 2) and ``vertex_attributes`` of shape (n, 1). Where there are `markers`, ``segment_markers`` of shape (s, 1);
        where regions have attributes, ``triangle_attributes`` of shape (u, 1).

    Examples
    --------
    >>> import sweep_cdt
    >>> square = sweep_cdt.triangulate([[0, 0], [4, 0], [4, 4], [0, 4]])
    >>> {name: array.shape for name, array in square.to_triangle().items()}
    {'vertices': (4, 2), 'triangles': (2, 3), 'segments': (4, 2)}
    """
    segments = self.constrained_sides
    if self.rule == "hull":
        segments = np.unique(np.sort(np.concatenate([segments, self.convex_hull]), axis=1), axis=0)
    points = as_doubles(self._input.points)
    result = {"vertices": points, "triangles": self.triangles, "segments": segments}
    if len(seeds := _seeds_of_holes(self, points)):
        result["holes"] = seeds
    if self.heights is not None:
        result["vertex_attributes"] = self.heights[:, None]
    if self.markers is not None:
        result["segment_markers"] = _markers_of(self, segments)[:, None]
    if self._input.attributes and self.region is not None:
        # A number of -1 takes the last one.
        attributes = np.array([*self._input.attributes, 0.0])
        result["triangle_attributes"] = attributes[self.region[self.inside]][:, None]
    return {name: np.array(array, order="C") for name, array in result.items()}


def _seeds_of_holes(self: Triangulation, points: np.ndarray) -> np.ndarray:
    """For each face outside the middle of its largest triangle."""
    (ax, ay), (bx, by), (cx, cy) = (points[self.simplices[:, i]].T for i in range(3))
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    crosses = (self.neighbors >= 0) & ~self.constrained
    waiting, seeds = set(np.flatnonzero(~self.inside).tolist()), []
    while waiting:
        face = [waiting.pop()]
        for t in face:
            beyond = waiting.intersection(self.neighbors[t, crosses[t]].tolist())
            waiting -= beyond
            face.extend(beyond)
        largest = face[int(np.argmax(area[face]))]
        seeds.append(points[self.simplices[largest]].mean(axis=0))
    return np.array(seeds).reshape(-1, 2)
