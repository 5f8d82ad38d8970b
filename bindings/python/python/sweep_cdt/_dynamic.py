"""The triangulation that changes: points and edges come and go."""

from __future__ import annotations

import dataclasses
import fractions
import math
from typing import Any

import numpy as np

from . import _native
from ._arrays import as_array, as_values, listed
from ._errors import KindError, ShapeError
from ._graph import as_input
from ._input import NO_EDGES, Input, as_edges, as_fractions, as_points, called
from ._places import as_queries
from ._remarks import say
from ._triangulation import Triangulation, made


@dataclasses.dataclass(frozen=True, eq=False)
class Change:
    """What edits changed.

    Attributes
    ----------
    points, edges : ndarray of int
        The numbers of the points and edges that came.
    gone, new : ndarray of int of shape (k, 3)
        The triangles that are gone, and those that are new, by the numbers of their corners: the lowest first, sorted.
    """

    points: np.ndarray
    edges: np.ndarray
    gone: np.ndarray
    new: np.ndarray


class DynamicTriangulation:
    """A constrained Delaunay triangulation that changes.

    After any edits the triangles are those that `triangulate` makes of the points and edges that are there. Points and
    edges have numbers from 0, in the order in which they came; a number is never used again. Equal points share a corner,
    which has the lowest of their numbers. An edit is made as a whole, or refused with an error, and then nothing has
    changed. Threads may share a triangulation. Copies and pickles keep the numbers.

    Parameters
    ----------
    points, edges : optional
        As of `triangulate`. With `Fraction` among the points all that come later are taken exactly, too. Polygons among
        them tell what is inside, for `triangulation`.

    Attributes
    ----------
    triangles : ndarray of int of shape (t, 3)
        The triangles of the hull, each with its lowest corner first; sorted.
    points : ndarray of int of shape (n,)
        The numbers of the points that are there.
    edges : ndarray of int of shape (m,)
        The numbers of the edges that are there.
    ends : ndarray of int of shape (m, 2)
        The ends of these edges, as numbers of points.

    Examples
    --------
    A pillar moves in a room:

    >>> import sweep_cdt
    >>> walls = [[0, 1], [1, 2], [2, 3], [3, 0]]
    >>> room = sweep_cdt.DynamicTriangulation([[0, 0], [9, 0], [9, 6], [0, 6]], walls)
    >>> pillar = room.insert([[5, 4]]).points
    >>> room.triangles.tolist()
    [[0, 1, 4], [0, 4, 3], [1, 2, 4], [2, 3, 4]]
    >>> change = room.edit(points=[[2, 4]], remove_points=pillar)
    >>> change.points.tolist(), change.new.tolist()
    ([5], [[0, 1, 5], [0, 5, 3], [1, 2, 5], [2, 3, 5]])

    What is free between the walls and an obstacle:

    >>> box = room.insert([[3, 1], [4, 1], [4, 2], [3, 2]], [[6, 7], [7, 8], [8, 9], [9, 6]])
    >>> room.triangulation(inside="even-odd").area
    53.0
    """

    def __init__(self, points: Any = (), edges: Any = None) -> None:
        given = as_input(points, edges)
        self._core = _native.Dynamic(given.is_exact)
        self._is_exact = given.is_exact
        # Of each edge that is a side of a polygon its ring and its polygon, each with the number of the first edge that
        # came with it, and whether the ring is a hole.
        self._ring_of: dict[int, tuple[tuple[int, int], tuple[int, int], bool]] = {}
        self._holes = given.holes
        say(given.remarks)
        self._changed(given, called(lambda given: self._core.edit(given.points, given.edges, NO_EDGES, [], []), given))

    def __repr__(self) -> str:
        return f"<DynamicTriangulation of {len(self.points)} points and {len(self.edges)} edges>"

    def __len__(self) -> int:
        """The number of triangles."""
        return len(self.triangles)

    def __getstate__(self) -> dict[str, Any]:
        numbers, (edges, ends) = self._core.numbers(), self._core.edges()
        given = Input(self._core.places(numbers), ends)
        return {**self.__dict__, "_core": (given, numbers, edges, self._core.next_numbers())}

    def __setstate__(self, state: dict[str, Any]) -> None:
        given, numbers, edges, (next_point, next_edge) = state["_core"]
        # What is gone had numbers, too: it comes as points that equal others and edges of no length, and goes again.
        of_point, ends = np.zeros(next_point, dtype=np.intp), np.zeros((next_edge, 2), dtype=np.uintp)
        of_point[numbers], ends[edges] = np.arange(len(numbers)), given.edges
        if len(numbers):
            places = given.places(of_point.tolist())
        else:
            places = as_points(np.zeros((next_point, 2), dtype=object if given.is_exact else float))
        core = _native.Dynamic(given.is_exact)
        core.edit(places, ends, NO_EDGES, [], [])
        gone = (np.setdiff1d(np.arange(count), of).tolist() for count, of in ((next_point, numbers), (next_edge, edges)))
        core.edit(given.places([]), NO_EDGES, NO_EDGES, *gone)
        self.__dict__.update(state, _core=core)

    def edit(self, *, points: Any = (), edges: Any = None, remove_points: Any = (), remove_edges: Any = ()) -> Change:
        """Makes all edits at once, or none. What is removed goes first.

        Parameters
        ----------
        points : array_like of shape (n, 2), or an object that has points, optional
            Points that come; they have the next numbers. Objects are those of `triangulate`, and bring their own edges,
            which come before `edges`.
        edges : array_like of int of shape (m, 2), optional
            Edges that come, as numbers of points, the new ones among them.
        remove_points : array_like of int, optional
            Numbers of points that go. No edge that stays or comes may end there; one that passes through closes over.
        remove_edges : array_like of int, optional
            Numbers of edges that go.

        Returns
        -------
        Change

        Raises
        ------
        Error
            `MissingError`, if there is no such point or edge; `PointInUseError`, if an edge ends at a point that goes;
            `CrossingEdgesError`, if edges would cross; `NonFiniteError`, and others as of `triangulate`.
        """
        given = as_input(points)
        if len(given.holes):
            raise KindError("the holes of a dictionary are those of the first points, of the constructor")
        say(given.remarks)
        gone = _numbers(remove_points, "remove_points"), _numbers(remove_edges, "remove_edges")
        found = self._core.edit(self._exactly(given.points), given.edges, as_edges(edges), *gone)
        for edge in gone[1]:
            self._ring_of.pop(edge, None)
        return self._changed(given, found)

    def _changed(self, given: Input, found: tuple[Any, ...]) -> Change:
        """What an edit changed; the sides of polygons that came are noted."""
        (first, last), (first_edge, last_edge), gone, new = found
        for side, ring in enumerate(() if given.ring_of is None else given.ring_of.tolist()):
            if ring >= 0:
                polygon, is_hole = given.rings[ring]
                self._ring_of[first_edge + side] = (first_edge, ring), (first_edge, polygon), is_hole
        return Change(np.arange(first, last), np.arange(first_edge, last_edge), gone.view(np.intp), new.view(np.intp))

    def insert(self, points: Any = (), edges: Any = None) -> Change:
        """Inserts points, and edges between points: `edit` without removals."""
        return self.edit(points=points, edges=edges)

    def remove(self, points: Any = (), edges: Any = ()) -> Change:
        """Removes points and edges by their numbers: `edit` without insertions."""
        return self.edit(remove_points=points, remove_edges=edges)

    @property
    def triangles(self) -> np.ndarray:
        return self._core.triangles().view(np.intp)

    @property
    def points(self) -> np.ndarray:
        return self._core.numbers().view(np.intp)

    @property
    def edges(self) -> np.ndarray:
        return self._core.edges()[0].view(np.intp)

    @property
    def ends(self) -> np.ndarray:
        return self._core.edges()[1].view(np.intp)

    def places(self, points: Any) -> np.ndarray:
        """The places of points by their numbers: an array of shape (k, 2), or (2,) of one number.

        Raises
        ------
        Error
            `MissingError`, if there is no such point.
        """
        numbers = np.array(_numbers(points, "points"), dtype=np.uintp)
        found = self._core.places(numbers)
        places = found if isinstance(found, np.ndarray) else as_fractions(found)
        return places if np.ndim(points) else places[0]

    def edge_chain(self, edge: int) -> np.ndarray:
        """The numbers of the points along an edge, as of `Triangulation.edge_chain`.

        Raises
        ------
        Error
            `MissingError`, if there is no such edge.
        """
        (number,) = _numbers([edge], "edge")
        return np.array(self._core.chain(number), dtype=np.intp)

    def last_sweeps(self) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """The regions that the last edit swept: their steps are the steps of the edit.

        Returns
        -------
        list of tuples
            The places of the vertices of a region; its border and the parts of edges in it, as an array of shape (k, 2)
            of positions in these; and the numbers of the vertices. Empty after an edit that was refused.

        Examples
        --------
        A page to walk through the steps of an edit:

        >>> import sweep_cdt
        >>> square = sweep_cdt.DynamicTriangulation([[0, 0], [9, 0], [9, 9], [0, 8]])
        >>> change = square.insert([[7, 4]])
        >>> [(points, edges, numbers)] = square.last_sweeps()
        >>> len(points), len(edges), max(numbers.tolist())
        (5, 4, 4)
        >>> page = sweep_cdt.trace(points, edges).to_html()
        """
        swept = self._core.last_sweeps()
        return [(self.places(numbers), edges.view(np.intp), numbers.view(np.intp)) for numbers, edges in swept]

    def nearest(self, xi: Any) -> np.ndarray:
        """The number of the point nearest to each place, decided exactly; of several the lowest one.

        Parameters
        ----------
        xi : array_like of shape (..., 2), or points as geometries
            The places.

        Returns
        -------
        ndarray of int of shape (...)
            -1 where there is none, and for places that are not finite, masked or missing.
        """
        _, places, finite, shape = as_queries(xi, "xi", Input(self._exactly(np.empty((0, 2)))))
        found = np.full(len(finite), -1, dtype=np.intp)
        found[finite] = self._core.nearest(places)
        return found.reshape(shape)

    def natural_neighbors(self, place: Any) -> tuple[np.ndarray, np.ndarray]:
        """The natural neighbours of a place, each with its weight (Sibson 1981): the part that the Voronoi cell of the place
        would take from its cell. For smooth interpolation: the sum of `weights * values[numbers]`.

        Parameters
        ----------
        place : array_like of shape (2,)
            The place.

        Returns
        -------
        numbers : ndarray of int of shape (k,)
            The numbers of the neighbours. None outside of the hull, and if there are no triangles.
        weights : ndarray of shape (k,)
            They add up to 1: doubles but for rounding, and `Fraction` objects where the points are these.

        Raises
        ------
        Error
            There is an edge: natural neighbours are those of points alone.

        Examples
        --------
        >>> square = DynamicTriangulation([[0, 0], [4, 0], [4, 4], [0, 4]])
        >>> square.natural_neighbors([2, 2])
        (array([0, 1, 2, 3]), array([0.25, 0.25, 0.25, 0.25]))
        """
        _, places, finite, shape = as_queries(place, "place", Input(self._exactly(np.empty((0, 2)))))
        if shape != ():
            raise ShapeError(f"place has the shape {(*shape, 2)}, not (2,)", shape=(*shape, 2))
        if not finite.all():
            return np.empty(0, dtype=np.intp), np.empty(0)
        numbers, weights = self._core.natural_neighbors(places)
        if not isinstance(weights, np.ndarray):
            weights = np.array([fractions.Fraction(*parts) for parts in weights], dtype=object)
        return numbers.astype(np.intp), weights

    def interpolate(self, values: Any, xi: Any) -> np.ndarray:
        """Values at places, by the weights of their natural neighbours: smooth but at the points.

        Parameters
        ----------
        values : array_like of shape (n,) or (n, k)
            Values by the numbers of the points: those that are not there count for nothing.
        xi : array_like of shape (..., 2), or points as geometries
            The places.

        Returns
        -------
        ndarray of shape (...) or (..., k)
            NaN outside of the hull, and where a value that counts is not there. A `RemarkWarning` counts these places.

        Raises
        ------
        Error
            There is an edge: natural neighbours are those of points alone.

        Examples
        --------
        >>> square = DynamicTriangulation([[0, 0], [4, 0], [4, 4], [0, 4]])
        >>> square.interpolate([1, 1, 3, 3], [[2, 2], [1, 3]]).tolist()
        [2.0, 2.5]
        """
        values = as_values(values, None)
        count = 1 + int(self.points.max(initial=-1))
        if len(values) < count:
            message = f"values has the shape {values.shape}, but points have numbers below {count}"
            raise ShapeError(message, shape=values.shape)
        rest = values.shape[1:]
        columns = np.ascontiguousarray(values.reshape(len(values), math.prod(rest)))
        _, places, finite, shape = as_queries(xi, "xi", Input(self._exactly(np.empty((0, 2)))))
        result = np.full((len(finite), columns.shape[1]), np.nan)
        result[finite] = self._core.interpolate(columns, places).reshape(len(places), columns.shape[1])
        say(_native.off_terrain(int(np.isnan(result[finite]).any(axis=1).sum()), len(places)))
        return result.reshape(shape + rest)

    def triangulation(self, inside: str | None = None) -> Triangulation:
        """The `Triangulation` of what is there: with what is inside, pictures, and for other libraries.

        Parameters
        ----------
        inside : str, optional
            Which triangles are inside, and the default, as of `triangulate`. Polygons are those that came whose sides
            are there still, in their order.

        Returns
        -------
        Triangulation
            Its points are those of `points`, and its edges those of `edges`, counted from 0.
        """
        numbers = self.points
        places = self._core.places(numbers.astype(np.uintp))
        ends = np.searchsorted(numbers, self.ends).astype(np.uintp)
        sides = [self._ring_of.get(edge) for edge in self.edges.tolist()] if self._ring_of else []
        there = sorted({side for side in sides if side is not None})
        ring_at = {ring: at for at, (ring, _, _) in enumerate(there)}
        polygon_at = {polygon: at for at, polygon in enumerate(sorted({polygon for _, polygon, _ in there}))}
        given = Input(
            places,
            np.ascontiguousarray(ends),
            rings=[(polygon_at[polygon], is_hole) for _, polygon, is_hole in there],
            ring_of=np.array([-1 if side is None else ring_at[side[0]] for side in sides], dtype=np.int64),
            holes=self._holes,
        )
        return made(given, inside, False, None, None)

    def _exactly(self, points: Any) -> Any:
        if isinstance(points, np.ndarray) == self._is_exact:
            if not self._is_exact:
                raise KindError("the points are doubles, and these are not: begin with a Fraction")
            return as_points(points.astype(object)) if len(points) else _native.ExactPoints([], [])
        return points


def _numbers(given: Any, name: str) -> list[int]:
    """Numbers of points or edges, or one of them."""
    array = np.atleast_1d(as_array(listed(given), name, columns=None))
    if array.size and (array.dtype.kind not in "iu" or array.ndim != 1):
        raise KindError(f"{name} is no list of whole numbers")
    # A negative number becomes a very large one, which there is not either.
    return array.astype(np.int64).astype(np.uintp).tolist()
