"""The triangulation that changes: points and edges come and go."""

from __future__ import annotations

import dataclasses
import fractions
from typing import Any

import numpy as np

from . import _native
from ._errors import KindError, ShapeError
from ._graph import as_input
from ._input import Input, as_edges, as_fractions, as_points, called
from ._places import as_queries
from ._remarks import say
from ._triangulation import Triangulation, made


@dataclasses.dataclass(frozen=True)
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
    changed. Threads may share a triangulation.

    Parameters
    ----------
    points, edges : optional
        As of `triangulate`. With `Fraction` among the points all that come later are taken exactly, too.

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
    """

    def __init__(self, points: Any = (), edges: Any = None) -> None:
        given = as_input(points, edges)
        say(given.remarks)
        self._core = _native.Dynamic(given.is_exact)
        self._is_exact = given.is_exact
        none: list[int] = []
        called(lambda given: self._core.edit(given.points, given.edges, none, none), given)

    def __repr__(self) -> str:
        return f"<DynamicTriangulation of {len(self.points)} points and {len(self.edges)} edges>"

    def __len__(self) -> int:
        return len(self.triangles)

    def edit(self, *, points: Any = (), edges: Any = None, remove_points: Any = (), remove_edges: Any = ()) -> Change:
        """Makes all edits at once, or none. What is removed goes first.

        Parameters
        ----------
        points : array_like of shape (n, 2), optional
            Points that come; they have the next numbers.
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
        found = self._core.edit(
            self._exactly(as_points(points)),
            as_edges(edges),
            _numbers(remove_points, "remove_points"),
            _numbers(remove_edges, "remove_edges"),
        )
        (first, last), (first_edge, last_edge), gone, new = found
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
        """The places of points by their numbers: an array of shape (k, 2).

        Raises
        ------
        Error
            `MissingError`, if there is no such point.
        """
        numbers = np.array(_numbers(points, "points"), dtype=np.uintp)
        found = self._core.places(numbers)
        return found if isinstance(found, np.ndarray) else as_fractions(found)

    def edge_chain(self, edge: int) -> np.ndarray:
        """The numbers of the points along an edge, as of `Triangulation.edge_chain`.

        Raises
        ------
        Error
            `MissingError`, if there is no such edge.
        """
        (number,) = _numbers([edge], "edge")
        return np.array(self._core.chain(number), dtype=np.intp)

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

    def triangulation(self) -> Triangulation:
        """The `Triangulation` of what is there: with pictures, and for other libraries. Its points are those of `points`,
        counted from 0."""
        numbers = self.points
        places = self._core.places(numbers.astype(np.uintp))
        ends = np.searchsorted(numbers, self.ends).astype(np.uintp)
        return made(Input(places, np.ascontiguousarray(ends)), "hull", False, None, None)

    def _exactly(self, points: Any) -> Any:
        if isinstance(points, np.ndarray) == self._is_exact:
            if not self._is_exact:
                raise KindError("the points are doubles, and these are not: begin with a Fraction")
            return as_points(points.astype(object)) if len(points) else _native.ExactPoints([], [])
        return points


def _numbers(given: Any, name: str) -> list[int]:
    """Numbers of points or edges."""
    array = np.asarray(given)
    if array.size and (array.dtype.kind not in "iu" or array.ndim != 1):
        raise KindError(f"{name} is no list of whole numbers")
    # A negative number becomes a very large one, which there is not either.
    return array.astype(np.int64).astype(np.uintp).tolist()
