"""The last line of a report: what was found, and what to do, in words.

Why it can be trusted: an argument is named only if the verifier, called with it, has accepted the result. A change of
the result is named only if the changed result has passed. Cost: of a right result, nothing. A wrong one is verified
again for each domain that it may fill, and for each change that is tried.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import Error
from ._report import TITLES, Report

if TYPE_CHECKING:
    from ._verify import Question

# Depths up to these come from rounding doubles, and from rounding to single precision.
ROUNDING = 1e-12
SINGLE = 1e-5
LEVELS = list(TITLES)


class _Fit:
    """Arguments with which a result is accepted."""

    def __init__(self, rule: str, answer: dict[str, Any], asked: Question) -> None:
        self.rule, self.answer, self.asked = rule, answer, asked
        if answer["is_right"]:
            self.how = "right"
        elif answer["measured"] == answer["found"] and answer["deepest"] <= SINGLE:
            self.how = "shallow"
        else:
            self.how = "lower" if answer["reached"] is not None else "none"

    def rank(self) -> tuple[bool, int, int]:
        """Better ones come first. Triangles that tile what was asked for tile nothing else."""
        level = LEVELS.index(self.answer["reached"]) if self.how == "lower" else 0
        return self.rule != self.asked.rule, ["right", "shallow", "lower"].index(self.how), -level

    def arguments(self) -> str:
        """The arguments as they are written."""
        parts = [f'domain="{self.rule}"'] if self.rule != self.asked.rule else []
        if self.how == "shallow":
            decade = math.floor(math.log10(self.answer["deepest"])) + 1
            parts.append(f"max_depth={max(ROUNDING, float(f'1e{decade}')):g}")
        if self.how == "lower":
            parts.append(f'level="{self.answer["reached"]}"')
        return ", ".join(parts)

    def words(self) -> str:
        place = "" if self.rule == self.asked.rule else " of the hull" if self.rule == "hull" else " of the interior"
        found, deepest = self.answer["found"], self.answer["deepest"]
        if self.how == "right":
            return f"this is a right triangulation{place}: {self.arguments()}"
        if self.how == "shallow":
            what = "rounding" if deepest <= ROUNDING else "rounding to single precision"
            prefix = f"as a triangulation{place} " if place else ""
            if found == 1:
                which = f"the only violation is of the size of {what} (depth {deepest:.1e})"
                return f"{prefix}{which}: {self.arguments()} accepts it"
            which = f"all {found} violations are of the size of {what} (deepest {deepest:.1e})"
            return f"{prefix}{which}: {self.arguments()} accepts them"
        return f"this is {TITLES[self.answer['reached']]}{place}, but {self._but()}: {self.arguments()} accepts it"

    def _but(self) -> str:
        if self.answer["reached"] == "delaunay":
            return "not the canonical one"
        if self.answer["reached"] == "constrained":
            return "not Delaunay"
        name, edges = self.answer["violations"][0][0], self.answer["violations"][0][4]
        if edges:
            what = "not straight" if name == "bent-edge" else "missing"
            return f"without all edges of the input (edge {edges[0]} is {what})"
        return "with wrong attributes of regions"


def advice(asked: Question, report: Report) -> str:
    """The line."""
    if report.verdict == "correct":
        return "correct: nothing to do" + ("; the triangles run clockwise" if report.is_clockwise else "")
    if report.verdict == "within-max-depth":
        return "right but for rounding, as max_depth allows: nothing to do"
    try:
        fit = _best(asked, asked.triangles)
    except Error as error:
        return f"the input has no triangulation with its edges: {error}"
    if fit is not None and fit.how != "lower":
        return fit.words()
    change = _counted_from_one(asked) or _turned_over(asked) or _left_out(asked)
    if change:
        return change
    return fit.words() if fit is not None else _without_advice(asked, report)


def _best(asked: Question, triangles: np.ndarray) -> _Fit | None:
    """The arguments that accept these triangles, with the fewest violations."""
    from ._triangulation import made

    # Edges that cross leave no domain at all.
    made(asked.own(), "hull", False, None, None)
    rules = ["hull"]
    if asked.given.rings:
        rules.append("polygons")
    if len(asked.given.holes):
        rules += ["holes", "hull-without-holes", "even-odd", "nonzero"]
    else:
        rules += ["even-odd", "nonzero", "holes"]
    fits = []
    for rule in [asked.rule, *(rule for rule in rules if rule != asked.rule)]:
        is_asked = rule == asked.rule
        try:
            if not is_asked and rule != "hull" and asked.added_from is None:
                inside = made(asked.given, rule, False, None, None)
                if not len(triangles) or len(inside.triangles) != len(triangles):
                    continue
            answer = asked.answer(rule=rule, triangles=triangles, max_depth=0.0, limit=1)
        except Error:
            if is_asked or rule == "hull":
                raise
            continue
        fit = _Fit(rule, answer, asked)
        if fit.how != "none":
            fits.append(fit)
    return min(fits, key=_Fit.rank, default=None)


def _then(asked: Question, change: str, triangles: np.ndarray) -> str | None:
    """A change of the result in words, with the arguments that accept the changed triangles."""
    fit = _best(asked, triangles)
    if fit is None:
        return None
    arguments = fit.arguments()
    return f"{change}, and add {arguments}" if arguments else change


def _counted_from_one(asked: Question) -> str | None:
    """Corners that run from 1 to the number of points."""
    triangles, count = asked.triangles, len(asked.given.points)
    if not triangles.size or triangles.min() != 1 or triangles.max() != count:
        return None
    return _then(asked, "corners are numbered from 1 and not from 0: subtract 1 from each", triangles - 1)


def _turned_over(asked: Question) -> str | None:
    """Triangles of which some run clockwise."""
    all_of = _all_of(asked, "reversed-triangle")
    if not all_of:
        return None
    fewer = [triangles[0] for *_, triangles in all_of]
    changed = asked.triangles.copy()
    changed[fewer] = changed[fewer][:, [0, 2, 1]]
    if len(fewer) == 1:
        change = f"triangle {fewer[0]} runs the other way round than all others: swap two of its corners"
    else:
        change = (
            f"{len(fewer)} triangles run the other way round than the others, the first is {fewer[0]}: "
            "swap two corners of each"
        )
    return _then(asked, change, changed)


def _left_out(asked: Question) -> str | None:
    """Vertices that no triangle has, if nothing else is wrong."""
    all_of = _all_of(asked, "unused-point")
    if not all_of or any(name != "unused-point" for name, *_ in all_of):
        return None
    vertex = all_of[0][3][0]
    if len(all_of) == 1:
        return (
            f"vertex {vertex} of the input is used by no triangle, and nothing else is wrong: remove it from the input, "
            "and run the program again"
        )
    return (
        f"{len(all_of)} vertices of the input are used by no triangle, the first is {vertex}, and nothing else is wrong: "
        "remove them from the input, and run the program again"
    )


def _all_of(asked: Question, name: str) -> list[Any]:
    """All violations of this name, if the first one has it; for unused points all of any name."""
    first = asked.answer(limit=1)
    if not first["violations"] or first["violations"][0][0] != name:
        return []
    found = asked.answer(limit=first["found"])["violations"]
    if name == "unused-point":
        return found
    return [violation for violation in found if violation[0] == name]


def _without_advice(asked: Question, report: Report) -> str:
    if not len(asked.triangles):
        what = "the result has no triangles"
    elif (asked.triangles >= len(asked.given.points)).any():
        what = "corners are no vertices of the input: perhaps this is the result of another one"
    else:
        violations = report._answer["violations"]
        first = f", the first violation is {violations[0][0]}" if violations else ""
        what = f"no argument accepts this{first}"
    return f"{what}: report.plot() shows where it is wrong"
