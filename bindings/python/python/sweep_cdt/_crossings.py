"""Edges that cross: all pairs, and edges split where they do."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from . import _native
from ._graph import as_input
from ._input import Input, as_fractions, called
from ._remarks import Remark, say, told


def crossings(points: Any, edges: Any = None, *, strict: bool = False) -> Crossings:
    """All pairs of edges that cross at a point that is none of the points.

    Parameters
    ----------
    points, edges, strict
        As of `triangulate`.

    Returns
    -------
    Crossings

    Examples
    --------
    >>> import sweep_cdt
    >>> found = sweep_cdt.crossings([[0, 0], [3, 1], [0, 1], [3, 0]], [[0, 1], [2, 3]])
    >>> found.edges.tolist(), found.points.tolist()
    ([[0, 1]], [[1.5, 0.5]])
    >>> found.exact(0)
    (Fraction(3, 2), Fraction(1, 2))
    """
    given = as_input(points, edges)
    say(given.remarks, strict)
    return _found(given)


def _found(given: Input) -> Crossings:
    return Crossings(called(_native.crossings, given), given)


class Crossings:
    """The edges that cross; `crossings` finds them.

    Attributes
    ----------
    edges : ndarray of int of shape (k, 2)
        The two edges of each crossing, lower one first, sorted.
    points : ndarray of shape (k, 2)
        The double nearest to the place of each.
    """

    def __init__(self, found: _native.Crossings, given: Input) -> None:
        self._found = found
        self._input = given

    def __reduce__(self) -> tuple[Any, ...]:
        # Crossings depend on the input alone.
        return _found, (self._input,)

    def __len__(self) -> int:
        return len(self._found)

    def __repr__(self) -> str:
        return f"<Crossings: {len(self)}>"

    @functools.cached_property
    def edges(self) -> np.ndarray:
        return self._found.edges().view(np.intp)

    @functools.cached_property
    def points(self) -> np.ndarray:
        return self._found.points()

    def exact(self, number: int) -> tuple[Fraction, Fraction]:
        """The exact place of a crossing."""
        x, y = self._found.exact(range(len(self))[number])
        return Fraction(*x), Fraction(*y)


def split(points: Any, edges: Any = None, *, strict: bool = False) -> Split:
    """Splits edges where they cross, so that they can be triangulated.

    Fractions are split exactly. With doubles each place is rounded to the nearest double, and edges that then cross are
    split again, until none do.

    Parameters
    ----------
    points, edges, strict
        As of `triangulate`.

    Returns
    -------
    Split

    Raises
    ------
    Error
        As of `triangulate`; `TooLargeError`, if there are too many crossings, or too many rounds.

    Examples
    --------
    >>> import sweep_cdt
    >>> pieces = sweep_cdt.split([[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 2], [1, 3]])
    >>> pieces.points[4].tolist(), pieces.edges.tolist()
    ([1.0, 1.0], [[0, 4], [4, 2], [1, 4], [4, 3]])
    >>> pieces.pieces_of.tolist(), pieces.rounds, pieces.displacement
    ([0, 0, 1, 1], 1, 0.0)
    """
    return told(split_input(as_input(points, edges)), strict)


def split_input(given: Input) -> Split:
    """Splits the edges of an input."""
    return Split(given, *called(_native.split, given))


class Split:
    """Edges that are split where they cross; `split` makes it.

    Attributes
    ----------
    points : ndarray of shape (n + k, 2)
        The points given, and then those where edges cross.
    edges : ndarray of int of shape (p, 2)
        The pieces; those of one edge follow each other from its first end to its second.
    pieces_of : ndarray of int of shape (p,)
        The edge of each piece.
    rounds : int
        How many rounds of splitting and rounding it took; none, if no edges cross.
    displacement : float
        How many units in the last place an edge moved at most.
    heights : ndarray of float of shape (n + k,), or None
        The heights of the points, as of `Triangulation.heights`.
    remarks : tuple of Remark
        What was ignored, or decided.
    """

    def __init__(
        self,
        given: Input,
        points: Any,
        edges: np.ndarray,
        pieces_of: np.ndarray,
        rounds: int,
        displacement: float,
        heights: np.ndarray | None,
        remarks: Sequence[Remark],
    ) -> None:
        self._given = given
        self._points = points
        self._edges = edges
        self.pieces_of = pieces_of.view(np.intp)
        self.rounds = rounds
        self.displacement = displacement
        self.heights = heights
        self.remarks = (*given.remarks, *remarks)

    def __repr__(self) -> str:
        return f"<Split of {self.count} edges into {len(self._edges)} pieces>"

    @property
    def count(self) -> int:
        """How many edges were given."""
        return len(self._given.edges)

    @property
    def points(self) -> np.ndarray:
        return self._points if isinstance(self._points, np.ndarray) else as_fractions(self._points)

    @property
    def edges(self) -> np.ndarray:
        return self._edges.view(np.intp)

    def as_input(self) -> Input:
        """The input with the pieces for edges."""
        given = self._given
        return given.changed(
            points=self._points,
            heights=self.heights,
            remarks=self.remarks,
            **given.of_pieces(self._edges, self.pieces_of),
        )
