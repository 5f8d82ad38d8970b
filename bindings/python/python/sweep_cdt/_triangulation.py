"""`triangulate` and its result, and `triangulate_inside`."""

from __future__ import annotations

import functools
import json
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _convert, _native, _places, _refine, _voronoi
from ._errors import CrossingEdgesError
from ._geometries import HEIGHT
from ._graph import as_input
from ._input import Input, as_count, as_fractions, called
from ._remarks import Remark, say, told

if TYPE_CHECKING:
    from ._crossings import Split

# With more triangles a notebook shows pixels in place of lines.
MOST_LINES = 3000
# With more it shows a line of text.
MOST_PIXELS = 2_000_000


def triangulate(
    points: Any,
    edges: Any = None,
    *,
    polygons: Any = None,
    holes: Any = None,
    inside: str | None = None,
    height_property: str | None = None,
    split_crossings: bool = False,
    threads: int | None = None,
    strict: bool = False,
) -> Triangulation:
    """The constrained Delaunay triangulation of points and edges.

    The triangles cover the convex hull of the points. Every edge is a side of triangles, or a chain of sides. No point
    inside the circumcircle of a triangle is visible from that triangle, where edges block the view. Every decision is
    exact: there is no tolerance, and every input ends in a right triangulation or in an `Error`.

    Parameters
    ----------
    points : array_like of shape (n, 2), or an object that has points
        Doubles, single precision, whole numbers, `Fraction` or `Decimal`: all exact. Where they are no doubles, a
        whole number, numerator or denominator has at most 10,000 digits, and an exponent is from -400 to 400; what is
        beyond raises `TooLargeError`. No point may be masked or missing. Of frames of pandas and polars and tables of
        pyarrow the names of the columns tell x, y and `heights`, as those of a file do, in any order; without such names
        they count as arrays.
        Or geometries: of shapely, a GeoDataFrame, GeoSeries or its array, GeoJSON as a dictionary, what has
        `__geo_interface__`, and lists and arrays of them; or a dictionary of `triangle`. These bring their edges,
        polygons and holes, and `heights` and `crs`. In a list with geometries may be arrays, also of shape (n, 3), and
        frames: each row is a point with its height. So contour lines, a border and a survey are one terrain. An array of doubles of which the rows follow each other in memory is
        not copied: no other thread may write to it during the call, and whoever writes to it later changes the result's
        points.
    edges : array_like of int of shape (m, 2), optional
        Pairs of positions in `points`. Edges may come in any order, repeat, overlap, pass through points, and have no
        length.
    polygons : list, optional
        Polygons with holes: each a list of rings, the outline first. A ring is a list of positions in `points`, or of
        coordinates, which are added to the points. Or polygons as geometries. The sides are edges, after `edges`.
    holes : array_like of shape (k, 2), or points as geometries, optional
        For each hole a point in it, as of `triangle`.
    inside : str, optional
        Which triangles are inside: ``hull`` (all), ``polygons`` (what the polygons cover), ``holes`` (what is reached
        neither from outside nor from a hole without crossing an edge), ``hull-without-holes``, ``even-odd``,
        ``nonzero``, ``positive``, ``negative``, or ``at-least-2`` and so on, by the winding number of edges that run
        around. The default is ``holes`` if there are holes, ``polygons`` if there are polygons, otherwise ``hull``.
    height_property : str, optional
        The column or property that has the `heights`, of a GeoDataFrame, GeoJSON or frame. The default is the first of
        z, elevation, elev, height and such names; of geometries, for points and lines without a z.
    split_crossings : bool, optional
        Whether edges that cross are split where they do. Otherwise they are an error.
    threads : int, optional
        How many threads work, 0 for as many as there are cores. The default is one. The triangles are the same, but
        several threads number them otherwise, and take up to half more memory. Few points are left to one thread.
    strict : bool, optional
        Whether it is an error if something of the input would get lost. Otherwise `RemarkWarning` says so.

    Returns
    -------
    Triangulation

    Raises
    ------
    Error
        One of its kinds, with the offenders as attributes: `CrossingEdgesError`, `NonFiniteError`,
        `EdgeOutOfRangeError`, `ShapeError`, `KindError`, `OpenRingError`, `SeedError`, `TooLargeError`,
        `OutOfMemoryError`, `RemarkError`.

    Examples
    --------
    >>> import sweep_cdt
    >>> result = sweep_cdt.triangulate([[0, 0], [4, 0], [4, 4], [0, 4], [1, 1]], [[0, 2]])
    >>> result
    <Triangulation of 5 points and 1 edge: 4 triangles>
    >>> result.canonical().tolist()
    [[0, 1, 4], [0, 4, 3], [1, 2, 4], [2, 3, 4]]
    >>> result.edge_chain(0).tolist()
    [0, 4, 2]

    Edges that cross are an error, which names them:

    >>> try:
    ...     sweep_cdt.triangulate([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 2], [1, 3]])
    ... except sweep_cdt.CrossingEdgesError as error:
    ...     error.edges
    (0, 1)

    A square with a square hole:

    >>> outline, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[3, 3], [6, 3], [6, 6], [3, 6]]
    >>> result = sweep_cdt.triangulate([], polygons=[[outline, hole]])
    >>> len(result.triangles), result.area
    (8, 72.0)
    """
    given = as_input(points, edges, polygons, holes, height_property)
    return told(made(given, inside, split_crossings, threads, None), strict)


def triangulate_inside(points: Any, edges: Any = None, *, polygons: Any = None, inside: str = "even-odd") -> np.ndarray:
    """The triangles inside of polygons, where nothing else is asked for.

    They are those of `triangulate`. Of rings that neither touch nor cross only the inside is triangulated, by the rules
    ``even-odd`` and ``nonzero`` (where rings in one another run in opposite directions): that takes less time. All other
    input is triangulated as a whole.

    Parameters
    ----------
    points, edges, polygons
        As of `triangulate`. What each ring is counts for nothing: the rule says what is inside.
    inside : str
        ``even-odd``, ``nonzero``, ``positive``, ``negative``, ``at-least-2`` and so on, or ``hull``.

    Returns
    -------
    ndarray of int32 of shape (u, 3)
        The corners of each triangle, counter-clockwise, the lowest first; sorted, as of `Triangulation.canonical`.

    Examples
    --------
    >>> import sweep_cdt
    >>> outline, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[3, 3], [6, 3], [6, 6], [3, 6]]
    >>> sweep_cdt.triangulate_inside([], polygons=[[outline, hole]])[:2].tolist()
    [[0, 1, 5], [0, 4, 3]]
    """
    given = as_input(points, edges, polygons, None)
    say(given.remarks)
    return called(_native.triangulate_inside, given, inside)


def made(
    given: Input,
    inside: str | None,
    split_crossings: bool,
    threads: int | None,
    settings: tuple[str, str, str] | None,
) -> Triangulation:
    """The triangulation of an input."""
    rule = given.rule(inside)
    split = None
    if split_crossings:
        from ._crossings import split_input

        split = split_input(given)
        given = split.as_input()
    count = as_count(1 if threads is None else threads, "threads")
    try:
        core = called(_native.triangulate, given, rule, count, settings)
    except CrossingEdgesError as error:
        raise CrossingEdgesError(f"{error} (split_crossings=True splits them)", **error.__dict__) from None
    return Triangulation(core, given, rule, count, settings, split)


class Triangulation:
    """A constrained Delaunay triangulation; `triangulate` makes it.

    Arrays are made when they are first asked for, and are read-only.

    The triangles are numbered in the order in which the sweep left them. As a set they depend on the points and edges
    alone. Of equal points only the first occurs in triangles.

    Attributes
    ----------
    points : ndarray of shape (n, 2)
        The points; doubles, or `Fraction` objects where these were given.
    edges : ndarray of int of shape (m, 2)
        The edges, those of polygons included.
    heights : ndarray of float of shape (n,), or None
        The z of geometries, in their units; where points and lines have none, the column or property of their feature
        that is called z, elevation or so; such a column of a frame; the first of the ``vertex_attributes`` of a
        dictionary. For each point, NaN where it has none; `None`, if no point has one. Equal points have the first that
        one of them has; where edges were split, the height is that along the first edge.
    crs : object or None
        The coordinate system of a GeoDataFrame or GeoSeries.
    simplices : ndarray of int32 of shape (t, 3)
        The corners of each triangle of the hull, counter-clockwise, as of SciPy.
    triangles : ndarray of int32 of shape (u, 3)
        Those of `simplices` that are inside.
    neighbors : ndarray of int32 of shape (t, 3)
        The triangle opposite each corner, -1 where there is none, as of SciPy.
    convex_hull : ndarray of int32 of shape (h, 2)
        The sides of the hull, counter-clockwise, as of SciPy.
    constrained : ndarray of bool of shape (t, 3)
        Whether the side opposite each corner is an edge or a piece of one.
    constrained_sides : ndarray of int32 of shape (c, 2)
        Those sides, each once.
    duplicates : ndarray of int32 of shape (d, 2)
        The points that equal one before them, and this one.
    inside : ndarray of bool of shape (t,)
        Whether each triangle is inside.
    depth : ndarray of int32 of shape (t,)
        How many polygons cover each triangle; by the rules of winding how often the edges go round it.
    region : ndarray of int32 of shape (t,), or None
        The polygon or feature (the first of several) or the region of each triangle, -1 where there is none.
    area : float or Fraction
        The area of what is inside.
    rule : str
        The rule for what is inside.
    split : Split or None
        How edges were split, if `split_crossings` was asked for. Then `points` and `edges` are those of the pieces.
    edge_of : ndarray of int of shape (m,)
        The edge that each of `edges` is a part of, where edges were split or refined; otherwise itself. -1 for sides of
        the hull that refinement made edges.
    added_from : int
        Points from this position on were added by `refine`.
    left : ndarray
        Triangles that break a bound of `refine` still: records of ``triangle`` (a position in `triangles`), ``bound``
        and ``reason``.
    markers : ndarray of int of shape (m,), or None
        The ``segment_markers`` of a dictionary, also those of parts; 0 for edges without one.
    remarks : tuple of Remark
        What was ignored, merged or decided, and what is missing.
    stats : dict
        How many points, edges and triangles there are; of `measure` also times and counters.
    """

    def __init__(
        self,
        core: _native.Core,
        given: Input,
        rule: str,
        threads: int,
        settings: tuple[str, str, str] | None,
        split: Split | None,
    ) -> None:
        self._core = core
        self._input = given
        self.rule = rule
        self._threads = threads
        self._settings = settings
        self.split = split
        # The points alone, once the nearest of them was asked for.
        self._points_alone: _native.Dynamic | None = None
        # How a mesh was refined: how many points there were, the edge of each part, how many edges, and what is left.
        self._refined: tuple[Any, ...] | None = None

    def __repr__(self) -> str:
        points, edges, inside = len(self._input.points), len(self._input.edges), ""
        if self.rule != "hull":
            inside = f", {int(self.inside.sum())} of them inside ({self.rule})"
        of_edges = f" and {_count(edges, 'edge')}" if edges else ""
        return f"<Triangulation of {_count(points, 'point')}{of_edges}: {_count(len(self._core), 'triangle')}{inside}>"

    def __reduce__(self) -> tuple[Any, ...]:
        # The result depends on the input alone, so that it need not be stored.
        return _again, (self._input, self.rule, self._threads, self._settings, self.split, self._refined)

    @functools.cached_property
    def points(self) -> np.ndarray:
        if self._input.is_exact:
            return _fixed(as_fractions(self._input.points))
        return _fixed(self._input.points.view())

    @property
    def edges(self) -> np.ndarray:
        return _fixed(self._input.edges.view(np.intp))

    @property
    def heights(self) -> np.ndarray | None:
        return self._shared[0]

    @functools.cached_property
    def _shared(self) -> tuple[np.ndarray | None, list[Remark]]:
        """The heights, and the remarks on those of equal points."""
        heights = self._input.heights
        if heights is None:
            return None, []
        shared, remarks = _places.of_equal(self, heights, HEIGHT)
        return _fixed(shared.view()), remarks

    @functools.cached_property
    def remarks(self) -> tuple[Remark, ...]:
        return (*self._input.remarks, *self._shared[1], *self._core.remarks())

    @property
    def crs(self) -> Any:
        return self._input.crs

    @functools.cached_property
    def simplices(self) -> np.ndarray:
        return _fixed(self._core.simplices())

    @functools.cached_property
    def triangles(self) -> np.ndarray:
        return self.simplices if self.rule == "hull" else _fixed(self.simplices[self.inside])

    @functools.cached_property
    def neighbors(self) -> np.ndarray:
        return _fixed(self._core.neighbors())

    @functools.cached_property
    def convex_hull(self) -> np.ndarray:
        hull = self._core.hull()
        return _fixed(np.stack([hull, np.roll(hull, -1)], axis=1))

    @functools.cached_property
    def constrained(self) -> np.ndarray:
        return _fixed(self._core.constrained())

    @functools.cached_property
    def constrained_sides(self) -> np.ndarray:
        return _fixed(self._core.constrained_sides())

    @functools.cached_property
    def duplicates(self) -> np.ndarray:
        return _fixed(self._core.duplicates())

    @functools.cached_property
    def inside(self) -> np.ndarray:
        return _fixed(self._core.inside())

    @functools.cached_property
    def depth(self) -> np.ndarray:
        return _fixed(self._core.depth())

    @functools.cached_property
    def region(self) -> np.ndarray | None:
        region = self._core.region()
        if region is None:
            return None
        if self.rule == "polygons" and self._input.features is not None:
            # A number of -1 takes the last one.
            region = np.asarray([*self._input.features, -1], dtype=np.int32)[region]
        return _fixed(region)

    @functools.cached_property
    def area(self) -> Any:
        if self._input.is_exact:
            points, total = self.points, 0
            for chain in self.boundary():
                x, y = points[chain].T
                total += (x * (np.roll(y, -1)) - y * np.roll(x, -1)).sum()
            return total / 2
        a, b, c = (self._input.points[self.triangles[:, i]] for i in range(3))
        (ux, uy), (vx, vy) = (b - a).T, (c - a).T
        return float((ux * vy - uy * vx).sum() / 2)

    @functools.cached_property
    def stats(self) -> dict[str, Any]:
        if self._core.stats is not None:
            return json.loads(self._core.stats)
        return {
            "points": len(self._input.points),
            "duplicates": len(self.duplicates),
            "edges": len(self._input.edges),
            "triangles": len(self._core),
            "hull": len(self.convex_hull),
        }

    @functools.cached_property
    def edge_of(self) -> np.ndarray:
        if self._refined is not None:
            parts = self._refined[1]
            return _fixed(np.r_[parts, np.full(len(self.edges) - len(parts), -1)])
        return _fixed(np.arange(len(self.edges)) if self.split is None else self.split.pieces_of.copy())

    @property
    def _edge_count(self) -> int:
        if self._refined is not None:
            return self._refined[2]
        return len(self.edges) if self.split is None else self.split.count

    @property
    def added_from(self) -> int:
        return len(self._input.points) if self._refined is None else self._refined[0]

    @functools.cached_property
    def left(self) -> np.ndarray:
        return _refine.records(self, [] if self._refined is None else self._refined[3])

    @property
    def markers(self) -> np.ndarray | None:
        return self._input.markers

    def canonical(self) -> np.ndarray:
        """The triangles inside in the order that the command writes: each with its lowest corner first, sorted.

        Returns
        -------
        ndarray of int32 of shape (u, 3)
        """
        return self._core.canonical(self.rule != "hull")

    def edge_chain(self, edge: int) -> np.ndarray:
        """The vertices along an edge: both ends, and what lies between them.

        Parameters
        ----------
        edge : int
            The position of the edge: of those given, then of the sides of polygons. With `split_crossings` the edges
            are those before they were split.

        Returns
        -------
        ndarray of int32
            From the first end to the second. A single vertex, if the ends are equal.
        """
        count = self._edge_count
        if not -count <= edge < count:
            raise IndexError(f"there is no edge {edge}: there are {count}")
        edge %= count
        # Edges without one before them come last.
        first, last = np.searchsorted(self.edge_of[self.edge_of >= 0], [edge, edge + 1])
        return self._core.chain(int(first), int(last))

    def boundary(self) -> list[np.ndarray]:
        """The closed chains of vertices around what is inside: outlines counter-clockwise, holes clockwise.

        Returns
        -------
        list of ndarray of int32
            Chains do not repeat their first vertex.
        """
        return self._core.boundary(self._input, self.rule)

    # Where points lie, and values there.
    find_simplex = _places.find_simplex
    interpolate = _places.interpolate
    nearest = _places.nearest

    # Meshes and diagrams of the triangulation.
    refine = _refine.refine
    voronoi = _voronoi.voronoi

    # To other libraries.
    to_geodataframe = _convert.to_geodataframe
    to_matplotlib = _convert.to_matplotlib
    to_meshio = _convert.to_meshio
    to_pyvista = _convert.to_pyvista
    to_shapely = _convert.to_shapely
    to_triangle = _convert.to_triangle
    plot = _convert.plot

    def to_svg(self) -> str:
        """A picture as SVG: triangles grey, edges blue, the border of what is inside orange."""
        return _native.picture(self._core, self._input, self.rule, False).decode()

    def to_png(self) -> bytes:
        """The picture of `to_svg` as PNG."""
        return _native.picture(self._core, self._input, self.rule, True)

    def _repr_svg_(self) -> str | None:
        return self.to_svg() if len(self._core) <= MOST_LINES else None

    def _repr_png_(self) -> bytes | None:
        return self.to_png() if MOST_LINES < len(self._core) <= MOST_PIXELS else None


def _again(
    given: Input,
    rule: str,
    threads: int,
    settings: tuple[str, str, str] | None,
    split: Split | None,
    refined: tuple[Any, ...] | None,
) -> Triangulation:
    result = made(given, rule, False, threads, settings)
    result.split, result._refined = split, refined
    return result


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _fixed(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array
