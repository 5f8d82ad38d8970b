"""Arguments as arrays: points as doubles or as exact numbers, edges and rings as positions.

Doubles are exact numbers too, and so are whole numbers up to 2**53 in size. So only larger whole numbers, fractions and
decimals take the exact arithmetic of fractions, which is some five times as slow. The result is the same. Their limits
are those of files, in Rust: beyond them a number could take all time and memory.
"""

from __future__ import annotations

import decimal
import fractions
import numbers
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeVar

import numpy as np

from . import _native
from ._errors import EdgeOutOfRangeError, Error, KindError, NonFiniteError, ShapeError

T = TypeVar("T")

# Whole numbers up to this size are doubles.
WHOLE = 2**53

NO_EDGES = np.empty((0, 2), dtype=np.uintp)


def as_points(given: Any, name: str = "points") -> Any:
    """Points as an array of doubles of shape (n, 2), or as exact points.

    An array of the doubles of this machine, aligned and row by row in memory, is not copied.
    """
    if isinstance(given, _native.ExactPoints):
        return given
    if isinstance(given, np.ndarray):
        return _of_array(given, name)
    if hasattr(given, "__array__"):
        return _of_array(np.asarray(given), name)
    if isinstance(given, (str, bytes)) or not isinstance(given, Iterable):
        raise KindError(f"{name} is no array but {_kind(given)}")
    rows = given if isinstance(given, Sequence) else list(given)
    try:
        array = np.asarray(rows)
    except ValueError:
        raise _ragged(rows, name) from None
    except (TypeError, OverflowError) as error:
        raise KindError(f"{name} is no array of numbers: {error}") from None
    if array.size == 0 and array.ndim == 1:
        return np.empty((0, 2))
    if array.dtype.kind == "f":
        # NumPy rounds whole numbers beside doubles.
        objects = np.asarray(rows, dtype=object)
        if any(isinstance(x, numbers.Integral) and abs(int(x)) > WHOLE for x in objects.flat):
            return _exact(objects, name)
    return _of_array(array, name)


def _of_array(array: np.ndarray, name: str) -> Any:
    if array.ndim != 2 or array.shape[1] != 2:
        if array.ndim == 2 and array.shape[1] == 3:
            hint = f": of heights in a third column, pass {name}[:, :2]"
        else:
            hint = ""
        raise ShapeError(f"{name} has the shape {array.shape}, not (n, 2){hint}", shape=array.shape)
    kind = array.dtype.kind
    if kind == "f" and array.dtype.itemsize <= 8:
        return _rows(array, np.float64)
    if kind in "iu":
        if array.dtype.itemsize < 8 or array.size == 0 or _fits(array):
            return _rows(array, np.float64)
        return _exact(array, name)
    if kind in "fO":
        return _exact(array, name)
    raise KindError(f"{name} has the type {array.dtype}, which is no type of coordinates")


def _rows(array: np.ndarray, dtype: Any) -> np.ndarray:
    """The array as Rust reads it: row by row, aligned, and with its bytes in the order of the machine."""
    return np.require(np.asarray(array), dtype, ["C", "A"])


def _fits(array: np.ndarray) -> bool:
    return int(array.max()) <= WHOLE and int(array.min()) >= -WHOLE


def _exact(array: np.ndarray, name: str) -> Any:
    """Exact points from whole numbers, fractions, decimals and doubles."""
    if array.ndim != 2 or array.shape[1] != 2:
        raise ShapeError(f"{name} has the shape {array.shape}, not (n, 2)", shape=array.shape)
    found = []
    for at, value in enumerate(array.flat):
        try:
            found.append(_number(value))
        except (ValueError, OverflowError):
            vertex, axis = divmod(at, 2)
            message = f"{name}[{vertex}, {axis}] is {value}, which is not finite"
            raise NonFiniteError(message, vertex=vertex, axis=axis) from None
        except TypeError:
            position = divmod(at, 2)
            message = f"{name}[{position[0]}, {position[1]}] is no number but {_kind(value)}"
            raise KindError(message, position=position) from None
    return _native.ExactPoints.of_numbers(found, name)


def _number(value: Any) -> tuple[int, int] | str:
    """A numerator and a denominator, or the text of a decimal, whose exponent may be one that no memory holds."""
    if isinstance(value, (bool, np.bool_)):
        raise TypeError
    if isinstance(value, numbers.Rational):
        return int(value.numerator), int(value.denominator)
    if isinstance(value, decimal.Decimal):
        if not value.is_finite():
            raise ValueError
        # `str` writes 12e400 as 1.2E+401.
        digits, *exponent = str(value).split("E")
        return f"{digits.replace('.', '')}e{value.as_tuple().exponent}" if exponent else digits
    if isinstance(value, (float, np.floating)):
        numerator, denominator = value.as_integer_ratio()
        return int(numerator), int(denominator)
    raise TypeError


def _kind(value: Any) -> str:
    return f"of the type {type(value).__name__}"


def _ragged(rows: Sequence[Any], name: str) -> ShapeError:
    for position, row in enumerate(rows):
        length = len(row) if hasattr(row, "__len__") else None
        if length != 2:
            what = "is no pair" if length is None else f"has {length} numbers, not 2"
            return ShapeError(f"{name}[{position}] {what}", position=position)
    return ShapeError(f"{name} is no list of pairs")


def as_indices(given: Any, columns: int, name: str) -> np.ndarray:
    """Positions as an array of whole numbers of shape (m, columns); of a flat one the rows follow each other."""
    if given is None:
        return np.empty((0, columns), dtype=np.uintp)
    try:
        array = np.asarray(given)
    except (ValueError, TypeError, OverflowError):
        raise ShapeError(f"{name} is no array of shape (m, {columns})") from None
    if array.size == 0:
        return np.empty((0, columns), dtype=np.uintp)
    if columns == 3 and array.ndim == 1 and array.size % 3 == 0:
        array = array.reshape(-1, 3)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ShapeError(f"{name} has the shape {array.shape}, not (m, {columns})", shape=array.shape)
    if array.dtype.kind not in "iu":
        raise KindError(f"{name} has the type {array.dtype}, not one of whole numbers")
    # A negative number becomes a very large one, which is no position either.
    return _rows(array, np.intp if array.dtype.kind == "i" else np.uintp).view(np.uintp)


def as_edges(given: Any, name: str = "edges") -> np.ndarray:
    """Edges as positions; none of them negative."""
    edges = as_indices(given, 2, name)
    if edges.size and (signed := edges.view(np.intp)).min() < 0:
        edge, end = divmod(int(np.argmax(signed.ravel() < 0)), 2)
        vertex = int(signed[edge, end])
        message = f"edge {edge} ends at vertex {vertex}, which does not exist"
        raise EdgeOutOfRangeError(message, edge=edge, vertex=vertex)
    return edges


def as_count(given: Any, name: str) -> int:
    """A number of threads or of violations."""
    if not isinstance(given, numbers.Integral) or given < 0:
        raise Error(f"{name} is {given}, not a whole number from 0 on")
    return min(int(given), sys.maxsize)


def as_fractions(points: Any) -> np.ndarray:
    """Exact points as an array of fractions."""
    fraction = fractions.Fraction
    array = np.empty(2 * len(points), dtype=object)
    array[:] = [fraction(n, d) for n, d in zip(*points.parts())]
    return array.reshape(-1, 2)


def as_doubles(points: Any) -> np.ndarray:
    """Points as doubles, rounded where they are exact."""
    if isinstance(points, np.ndarray):
        return points
    rounded = [_rounded(n, d) for n, d in zip(*points.parts())]
    return np.array(rounded, dtype=np.float64).reshape(-1, 2)


def _rounded(numerator: int, denominator: int) -> float:
    try:
        return numerator / denominator
    except OverflowError:
        return float("inf") if numerator > 0 else float("-inf")


class Input:
    """Points, edges, and what bounds an interior: rings of polygons, seeds of holes and of regions."""

    def __init__(
        self,
        points: Any,
        edges: np.ndarray = NO_EDGES,
        rings: Sequence[tuple[int, bool]] = (),
        ring_of: np.ndarray | None = None,
        holes: Any = None,
        regions: Any = None,
        attributes: Sequence[float] = (),
        features: Sequence[int] | None = None,
    ) -> None:
        self.points = points
        self.edges = edges
        # The polygon of each ring, and whether the ring is a hole in it.
        self.rings = list(rings)
        # For each edge its ring, or -1; nothing, if there are no rings.
        self.ring_of = ring_of if self.rings else None
        self.holes = _seeds(holes, "holes")
        self.regions = _seeds(regions, "regions")
        # The attribute of each region.
        self.attributes = list(attributes)
        # The feature of each polygon, if a feature may have several.
        self.features = features
        self._alike()

    def _alike(self) -> None:
        """Makes all points exact if some are."""
        names = ("points", "holes", "regions")
        if any(isinstance(getattr(self, name), _native.ExactPoints) for name in names):
            for name in names:
                points = getattr(self, name)
                if isinstance(points, np.ndarray):
                    setattr(self, name, _exact(points, name))

    @property
    def is_exact(self) -> bool:
        """Whether the points are fractions."""
        return isinstance(self.points, _native.ExactPoints)

    def rule(self, name: str | None) -> str:
        """The rule for what is inside: the one that is asked for, or the default."""
        return _native.inside(name, len(self.holes) > 0, len(self.rings) > 0)

    def __getstate__(self) -> dict[str, Any]:
        state = dict(self.__dict__)
        for name in ("points", "holes", "regions"):
            if isinstance(state[name], _native.ExactPoints):
                state[name] = state[name].parts()
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        for name in ("points", "holes", "regions"):
            if isinstance(state[name], tuple):
                state[name] = _native.ExactPoints(*state[name])
        self.__dict__.update(state)


def _seeds(given: Any, name: str) -> Any:
    return np.empty((0, 2)) if given is None else as_points(given, name)


def called(function: Callable[..., T], given: Input, *arguments: Any) -> T:
    """Calls a function in Rust with an input. The error for a point that is not finite tells which coordinate it is."""
    try:
        return function(given, *arguments)
    except NonFiniteError as error:
        row = given.points[error.vertex]
        axis = int(np.argmin(np.isfinite(row)))
        message = f"points[{error.vertex}, {axis}] is {row[axis]}, which is not finite"
        raise NonFiniteError(message, vertex=error.vertex, axis=axis) from None
