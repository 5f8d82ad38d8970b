"""Which vertex of a result is which point of the input: by the rules of the command, in docs/verifying.md.

Vertices are the input's exactly, in any order; or rounded to single precision, or to the significant digits that they
have, by number if there are as many, or else each the only point of the input that is rounded to it. Everything else is
refused: the nearest point is never taken for the right one. Fixed decimals, which the command knows by the text of a
file, are refused too where small numbers have fewer than six of these digits: doubles tell no text.
"""

from __future__ import annotations

import decimal
from typing import Any

import numpy as np

from ._errors import MatchError
from ._input import as_fractions

# Fewer digits than these are not taken for rounding.
LEAST_DIGITS = 6


class Matched:
    """How vertices were matched, and the position in the input of each vertex of the result."""

    def __init__(self, why: str, places: np.ndarray | None, difference: float | None) -> None:
        self.why = why
        # `None`, if the numbers are the same.
        self.places = places
        self.difference = difference

    def words(self) -> str:
        """The line of a report."""
        by = "number" if self.why in ("unplaced", "rounded", "near", "asked") else "coordinates"
        why = {
            "unplaced": "the result has no coordinates",
            "rounded": "coordinates are rounded",
            "printed": "coordinates are rounded",
            "single": "coordinates are of single precision",
            "near": "within the tolerance",
            "within": "within the tolerance",
            "asked": "as was asked for",
        }.get(self.why)
        if self.why == "own":
            return "the points are those of the result"
        difference = "" if not self.difference else f", greatest difference {self.difference:g}"
        return f"vertices matched by {by}{'' if why is None else ': ' + why}{difference}"


def find(points: np.ndarray, among: np.ndarray) -> np.ndarray:
    """For each point the lowest position of an equal one, or -1."""
    if not len(among):
        return np.full(len(points), -1)
    keys, wanted = _keys(among), _keys(points)
    order = np.argsort(keys, kind="stable")
    at = np.minimum(np.searchsorted(keys[order], wanted), len(order) - 1)
    found = order[at]
    return np.where(keys[found] == wanted, found, -1)


def _keys(points: np.ndarray) -> np.ndarray:
    """Numbers that are ordered as the points: by x, then y."""
    keys = np.empty(len(points), dtype=np.complex128)
    # Zeros of both signs are equal.
    keys.real, keys.imag = points[:, 0] + 0.0, points[:, 1] + 0.0
    return keys


def match(points: Any, own: np.ndarray, is_soup: bool, tolerance: float | None, by_number: bool) -> Matched:
    """Matches the vertices of a result with the points of the input."""
    is_single = points.dtype == np.float32 if isinstance(points, np.ndarray) else False
    points = np.asarray(points, dtype=np.float64)
    has_numbers = not is_soup and len(points) == len(own)
    if by_number and not is_soup:
        both = min(len(points), len(own))
        return Matched("asked", None, _greatest(points[:both], own[:both]))
    if has_numbers and (points == own).all():
        return Matched("equal", None, 0.0)
    found = find(points, own)
    if (found >= 0).all():
        return Matched("equal", found, 0.0)

    near = _Nearness(points, own, tolerance, is_single)
    if has_numbers and near.by_number():
        why = "rounded" if tolerance is None else "near"
        return Matched(why, None, _greatest(points, own))
    for why, places in near.by_place(found):
        if places is not None:
            return Matched(why, places, _greatest(points, own[places]))
    raise _refusal(points, own, found, has_numbers and near.far)


def match_exactly(points: Any, own: Any, by_number: bool) -> Matched:
    """Matches vertices with points where both are fractions, which nobody has rounded."""
    if by_number:
        return Matched("asked", None, None)
    vertices, among = ([tuple(row) for row in as_fractions(given)] for given in (points, own))
    if vertices == among:
        return Matched("equal", None, None)
    lowest = {place: position for position, place in reversed([*enumerate(among)])}
    for vertex, (x, y) in enumerate(vertices):
        if (x, y) not in lowest:
            message = f"vertex {vertex} of the result, at ({x}, {y}), is none of the input"
            raise MatchError(f"{message} (by_number=True ignores coordinates)", vertex=vertex, at=(x, y))
    return Matched("equal", np.array([lowest[place] for place in vertices], dtype=np.intp), None)


def _greatest(points: np.ndarray, own: np.ndarray) -> float:
    return float(np.abs(points - own).max()) if len(points) else 0.0


class _Nearness:
    """Vertices that may be rounded, or differ by a tolerance."""

    def __init__(self, points: np.ndarray, own: np.ndarray, tolerance: float | None, is_single: bool) -> None:
        self.points, self.own, self.tolerance = points, own, tolerance
        with np.errstate(over="ignore"):
            self.single = own.astype(np.float32).astype(np.float64)
            are_singles = is_single or bool((points.astype(np.float32) == points).all())
        self.rules = ["single"] if is_single else ["printed", "single"] if are_singles else ["printed"]
        # The first vertex that is not near the point of its number.
        self.far: int | None = None

    def by_number(self) -> bool:
        """Whether each vertex is near the point of its number."""
        if self.tolerance is not None:
            close = np.abs(self.points - self.own) <= self.tolerance
        else:
            close = self.points == self.own
            if "single" in self.rules:
                close |= self.points == self.single
            if "printed" in self.rules:
                for at, axis in np.argwhere(~close):
                    low, high = printed_range(self.points[at, axis])
                    if not low <= self.own[at, axis] <= high:
                        break
                    close[at, axis] = True
        if close.all():
            return True
        self.far = int(np.argmax(~close.all(axis=1)))
        return False

    def by_place(self, found: np.ndarray):
        """For each rule the only points that the vertices may be, if there are."""
        if self.tolerance is not None:
            ranges = lambda at: [(x - self.tolerance, x + self.tolerance) for x in self.points[at]]
            yield "within", self._only(ranges)
            return
        for rule in self.rules:
            if rule == "single":
                yield rule, self._only_singles()
            else:
                yield rule, self._only(lambda at: [printed_range(x) for x in self.points[at]])

    def _only_singles(self) -> np.ndarray | None:
        # Points that differ but are rounded alike tell no vertex from another.
        distinct = np.unique(self.own + 0.0, axis=0)
        with np.errstate(over="ignore"):
            rounded = _keys(distinct.astype(np.float32).astype(np.float64))
        values, counts = np.unique(rounded, return_counts=True)
        at = np.minimum(np.searchsorted(values, _keys(self.points)), len(values) - 1)
        if not len(values) or (counts[at] != 1).any():
            return None
        places = find(self.points, self.single)
        return places if (places >= 0).all() else None

    def _only(self, ranges) -> np.ndarray | None:
        order = np.lexsort((self.own[:, 1], self.own[:, 0]))
        x = self.own[order, 0]
        places = np.empty(len(self.points), dtype=np.intp)
        taken: dict[int, tuple[float, float]] = {}
        for at in range(len(self.points)):
            (left, right), (low, high) = ranges(at)
            candidates = order[np.searchsorted(x, left) : np.searchsorted(x, right, side="right")]
            y = self.own[candidates, 1]
            candidates = candidates[(low <= y) & (y <= high)]
            if not len(candidates) or (self.own[candidates] != self.own[candidates[0]]).any():
                return None
            place = int(candidates.min())
            # Vertices at two places are not one vertex.
            if taken.setdefault(place, tuple(self.points[at])) != tuple(self.points[at]):
                return None
            places[at] = place
        return places


def printed_range(value: float) -> tuple[float, float]:
    """The doubles that are printed as this one, with as many digits as it has."""
    number = decimal.Decimal(repr(float(value)))
    if not number.is_finite():
        return value, value
    _, digits, power = number.normalize().as_tuple()
    exponent = int(power) - max(0, LEAST_DIGITS - len(digits))
    half = decimal.Decimal((0, (5,), exponent - 1))
    context = decimal.Context(prec=60)
    low, high = context.subtract(number, half), context.add(number, half)
    return float(low), float(high)


def _refusal(points: np.ndarray, own: np.ndarray, found: np.ndarray, far: Any) -> MatchError:
    """The error for a vertex that is none of the input's."""
    at = int(np.argmax(found < 0)) if (found < 0).any() else int(far or 0)
    x, y = (float(c) for c in points[at])
    message = f"vertex {at} of the result, at ({x}, {y}), is none of the input"
    if not len(own) or not np.isfinite(points[at]).all():
        return MatchError(message, vertex=at, at=(x, y))
    apart = np.abs(own - points[at]).max(axis=1)
    nearest = int(np.nanargmin(apart))
    message += (
        f": the nearest is vertex {nearest}, {apart[nearest]:g} away"
        " (tolerance= allows for a difference, steiner=True for added vertices, by_number=True ignores coordinates)"
    )
    return MatchError(message, vertex=at, at=(x, y), nearest=nearest)
