"""The steps of the sweep, as data and as a page to walk through them."""

from __future__ import annotations

import html
import json
from collections.abc import Sequence
from typing import Any, overload

from . import _native
from ._graph import as_input
from ._input import Input, called
from ._remarks import say


def trace(points: Any, edges: Any = None, *, heuristics: str = "fast", strict: bool = False) -> Trace:
    """Triangulates, and keeps every step of the sweep.

    Parameters
    ----------
    points, edges, strict
        As of `triangulate`.
    heuristics : {'fast', 'paper', 'off'}, optional
        As of `measure`.

    Returns
    -------
    Trace

    Examples
    --------
    >>> import sweep_cdt
    >>> steps = sweep_cdt.trace([[0, 0], [2, 0], [0, 1]])
    >>> len(steps)
    22
    >>> [(step["vertex"], step["case"]) for step in steps if step["event"] == "point"]
    [(1, 'middle'), (2, 'left')]
    >>> print(steps.words(3))
    triangle 0 P-1 P-2 (first)
    """
    given = as_input(points, edges)
    say(given.remarks, strict)
    return _traced(given, heuristics)


def _traced(given: Input, heuristics: str) -> Trace:
    return Trace(called(_native.trace, given, heuristics), given, heuristics)


class Trace(Sequence[dict[str, Any]]):
    """The steps of a run; `trace` makes it.

    Each step is a dictionary with the ``event`` and what belongs to it, as the crate's lines of JSON have them: the
    vertices by their positions, or ``P-1`` and ``P-2`` for the artificial points.
    """

    def __init__(self, steps: _native.Steps, given: Input, heuristics: str) -> None:
        self._steps = steps
        self._input = given
        self._heuristics = heuristics

    def __reduce__(self) -> tuple[Any, ...]:
        # The steps depend on the input alone.
        return _traced, (self._input, self._heuristics)

    def __len__(self) -> int:
        return len(self._steps)

    @overload
    def __getitem__(self, at: int) -> dict[str, Any]: ...
    @overload
    def __getitem__(self, at: slice) -> list[dict[str, Any]]: ...
    def __getitem__(self, at: int | slice) -> Any:
        if isinstance(at, slice):
            return [self[number] for number in range(len(self))[at]]
        return json.loads(self._steps.step(range(len(self))[at]))

    def __repr__(self) -> str:
        return f"<Trace of {len(self)} steps>"

    def __str__(self) -> str:
        return self._steps.text()

    def words(self, number: int) -> str:
        """A step as its line in the text of a trace."""
        return self._steps.words(range(len(self))[number])

    def to_html(self, around: int | None = None) -> str:
        """A page to walk through the steps: one file that loads nothing. `around` is the step to show first."""
        return self._steps.page(self._input, None if around is None else around + 1)

    def to_svg(self, first: int = 0, last: int | None = None, most: int = 60) -> str:
        """Pictures of the steps from `first` up to `last`, at most so many."""
        last = len(self) if last is None else last
        return self._steps.sheet(self._input, first + 1, last, most)

    def show(self, around: int | None = None, height: int = 600) -> Page:
        """The page, which a notebook shows.

        Parameters
        ----------
        around : int, optional
            The step to show first.
        height : int, optional
            The height in pixels.
        """
        return Page(self.to_html(around), height)


class Page:
    """A page that a notebook shows in a frame.

    Attributes
    ----------
    text : str
        The page as HTML.
    """

    def __init__(self, text: str, height: int) -> None:
        self.text = text
        self._height = height

    def __repr__(self) -> str:
        return f"<Page of {len(self.text)} characters>"

    def _repr_html_(self) -> str:
        text = html.escape(self.text, quote=True)
        return f'<iframe srcdoc="{text}" width="100%" height="{self._height}" style="border: 0"></iframe>'
