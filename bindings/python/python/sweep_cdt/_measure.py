"""Runs that are counted, and the structures for the advancing front."""

from __future__ import annotations

from typing import Any

from . import _native
from ._graph import as_input
from ._remarks import told
from ._triangulation import Triangulation, made


def fronts() -> list[str]:
    """The names of the search structures for the advancing front; the default comes first.

    Examples
    --------
    >>> import sweep_cdt
    >>> sweep_cdt.fronts()
    ['hash', 'skip-list', 'linear']
    """
    return _native.fronts()


def measure(
    points: Any,
    edges: Any = None,
    *,
    front: str = "hash",
    heuristics: str = "fast",
    algorithm: str = "auto",
    strict: bool = False,
) -> Triangulation:
    """Triangulates as `triangulate` does, on one thread, and counts the work.

    Parameters
    ----------
    points, edges, strict
        As of `triangulate`.
    front : str, optional
        One of `fronts`: where the sweep looks for the place of a point.
    heuristics : {'fast', 'paper', 'off'}, optional
        The triangles that a point makes beyond those that it needs.
    algorithm : {'auto', 'sweep', 'divide-and-conquer'}, optional
        By default the sweep gives up where it flips too many sides; ``sweep`` never does.

    Returns
    -------
    Triangulation
        Its `stats` have the times of the three phases in seconds, ``memory`` in bytes, ``counters``, and under
        ``front`` the work of the search structure, where that counts any.

    Examples
    --------
    >>> import numpy, sweep_cdt
    >>> points = numpy.random.default_rng(1).random((1000, 2))
    >>> for front in sweep_cdt.fronts():
    ...     stats = sweep_cdt.measure(points, front=front).stats
    ...     print(front, stats["triangles"], stats["counters"]["point_events"])
    hash 1982 999
    skip-list 1982 999
    linear 1982 999
    """
    return told(made(as_input(points, edges), None, False, None, (front, heuristics, algorithm)), strict)
