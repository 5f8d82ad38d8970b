"""The report of `verify`: true or false, in words, as an array of records, and as pictures."""

from __future__ import annotations

import functools
import html
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native
from ._input import as_doubles

if TYPE_CHECKING:
    from ._verify import Question

RECORD = np.dtype(
    [
        ("name", "U24"),
        ("depth", "f8"),
        ("vertices", "i8", (4,)),
        ("edge", "i8"),
        ("triangles", "i8", (2,)),
        ("message", "U200"),
    ]
)

# How many violations are listed in words.
LISTED = 5


class Report:
    """What `verify` found: true, if the triangles are right.

    Attributes
    ----------
    verdict : {'correct', 'within-max-depth', 'wrong'}
        Of the second, each violation is no deeper than `max_depth`: the report is true.
    headline : str
        The verdict in words.
    level, domain : str
        What was asked for.
    reached : str or None
        The highest level that the triangles reach: ``tiling``, ``constrained``, ``delaunay`` or ``canonical``.
    is_canonical : bool
        Whether the triangles are those that `triangulate` makes.
    is_clockwise : bool
        Whether the triangles run clockwise, all of them; they are judged as they are.
    counts : dict
        Points, edges, triangles and sides of each kind.
    found : int
        How many violations there are.
    deepest : float or None
        The greatest depth of a violation that has one.
    decades : dict
        How many violations are how deep: by exponents of ten.
    matched : str
        How vertices were matched with those of the input.
    """

    def __init__(self, question: Question, answer: dict[str, Any]) -> None:
        self._question = question
        self._answer = answer
        self.level = question.level
        self.domain = question.rule
        self.reached = answer["reached"]
        self.is_canonical = answer["is_canonical"]
        self.is_clockwise = answer["is_clockwise"]
        self.counts = answer["counts"]
        self.found = answer["found"]
        self.deepest = answer["deepest"]
        self.decades = answer["decades"]
        self.matched = question.matched
        self.verdict = answer["verdict"]
        self.headline = answer["headline"]

    def __bool__(self) -> bool:
        return self.verdict != "wrong"

    def __repr__(self) -> str:
        return f"<Report: {self.headline}>"

    def __str__(self) -> str:
        lines = [self.headline, self.matched]
        for record in self.violations[:LISTED]:
            lines.append(f"{record['name']}: {record['message']}{_by(record['depth'])}")
        if self.found > LISTED:
            lines.append(f"and {self.found - LISTED} more")
        return "\n".join([*lines, self.advice])

    @functools.cached_property
    def advice(self) -> str:
        """The last line of the report: what was found, and what to do.

        What it names was tried, and accepts the result.
        """
        return self._question.ask(_native.advise, self._answer["unbounded"], self.verdict, self.is_clockwise)

    @functools.cached_property
    def violations(self) -> np.ndarray:
        """The violations as records.

        Returns
        -------
        ndarray
            With the fields ``name``, ``depth`` (NaN where there is none), ``vertices`` (up to four), ``edge``,
            ``triangles`` (up to two) and ``message``. Positions that there are not are -1.
        """
        records = np.zeros(len(self._answer["violations"]), dtype=RECORD)
        for record, violation in zip(records, self._answer["violations"]):
            name, message, depth, vertices, edges, triangles = violation
            record["name"], record["message"] = name, message
            record["depth"] = np.nan if depth is None else depth
            record["vertices"] = _padded(vertices, 4)
            record["edge"] = _padded(edges, 1)[0]
            record["triangles"] = _padded(triangles, 2)
        return records

    def worst(self, most: int = 5) -> np.ndarray:
        """The deepest violations, and then those without a depth, of those at vertices or triangles of the result."""
        listed = self.violations
        has_place = [bool(len(self._corners(record))) for record in listed]
        listed = listed[np.array(has_place, dtype=bool)]
        depths = np.where(np.isnan(listed["depth"]), -1.0, listed["depth"])
        return listed[np.argsort(-depths, kind="stable")][:most]

    def _corners(self, record: np.void) -> np.ndarray:
        """The vertices of a violation, those of its triangles and its edge among them."""
        question = self._question
        count = len(question.given.points)
        vertices = [v for v in record["vertices"] if 0 <= v < count]
        for t in record["triangles"]:
            if 0 <= t < len(question.triangles):
                vertices += [v for v in question.triangles[t].tolist() if v < count]
        if 0 <= record["edge"] < len(question.given.edges):
            vertices += [v for v in question.given.edges[record["edge"]].tolist() if v < count]
        return np.unique(np.array(vertices, dtype=np.intp))

    def plot(self, most: int = 5) -> Any:
        """Draws the triangles, and close-ups of the worst violations.

        Parameters
        ----------
        most : int, optional
            How many close-ups there are at most.

        Returns
        -------
        matplotlib.figure.Figure
        """
        import matplotlib.pyplot
        from matplotlib.collections import LineCollection

        question = self._question
        points = as_doubles(question.given.points)
        triangles = question.triangles[(question.triangles < len(points)).all(axis=1)].astype(np.intp)
        edges = question.given.edges[(question.given.edges < len(points)).all(axis=1)].astype(np.intp)
        worst = self.worst(most)
        figure, axes = matplotlib.pyplot.subplots(
            1, 1 + len(worst), figsize=(3.2 * (1 + len(worst)), 3.6), squeeze=False, layout="constrained"
        )
        titles = [self.verdict, *(f"{r['name']}{_by(r['depth'])}" for r in worst)]
        for ax, title in zip(axes[0], titles):
            ax.add_collection(LineCollection(list(points[triangles[:, [0, 1, 2, 0]]]), colors="0.7", linewidths=0.5))
            ax.add_collection(LineCollection(list(points[edges]), colors="C0", linewidths=1))
            ax.autoscale_view()
            ax.set_aspect("equal", adjustable="datalim")
            ax.set_title(title, fontsize="small")
            ax.tick_params(labelsize="x-small")
        for number, (ax, record) in enumerate(zip(axes[0, 1:], worst), 1):
            corners = points[self._corners(record)]
            for each in (axes[0, 0], ax):
                each.plot(*corners.T, "o", color="C3", markersize=4)
            axes[0, 0].annotate(str(number), corners.mean(axis=0), color="C3")
            for t in record["triangles"]:
                if 0 <= t < len(question.triangles) and (question.triangles[t] < len(points)).all():
                    ax.fill(*points[question.triangles[t].astype(np.intp)].T, color="C3", alpha=0.2)
            low, high = corners.min(axis=0), corners.max(axis=0)
            margin = 0.3 * max((high - low).max(), np.finfo(float).tiny) + 1e-9 * np.abs(high).max()
            ax.set_xlim(low[0] - margin, high[0] + margin)
            ax.set_ylim(low[1] - margin, high[1] + margin)
        return figure

    def _repr_html_(self) -> str:
        colour = {"correct": "#197b30", "within-max-depth": "#8a6d00", "wrong": "#b3261e"}[self.verdict]
        rows = [("vertices", self.matched), ("highest level", self.reached or "none")]
        rows += [(name.replace("_", " "), f"{count:,}") for name, count in self.counts.items() if count]
        if self.deepest is not None:
            rows.append(("the deepest violation", f"{self.deepest:.1e}"))
        cells = "".join(f"<tr><td>{html.escape(n)}</td><td>{html.escape(v)}</td></tr>" for n, v in rows)
        items = "".join(
            f"<li><b>{r['name']}</b>: {html.escape(str(r['message']))}{_by(r['depth'])}</li>"
            for r in self.violations[:LISTED]
        )
        more = f"<p>and {self.found - LISTED} more</p>" if self.found > LISTED else ""
        return (
            f'<p style="color: {colour}"><b>{html.escape(self.headline)}</b></p><table>{cells}</table>'
            f"<ul>{items}</ul>{more}<p>{html.escape(self.advice)}</p>"
        )


def _by(depth: float) -> str:
    return "" if np.isnan(depth) else f" (by {depth:.1e})"


def _padded(numbers: list[int], length: int) -> list[int]:
    # A negative corner came as a very large number.
    signed = [n - 2**64 if n >= 2**63 else n for n in numbers]
    return (signed + [-1] * length)[:length]
