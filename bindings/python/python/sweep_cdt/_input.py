"""Arguments as arrays: points as doubles or as exact numbers, edges and rings as positions.

Doubles are exact numbers too, and so are whole numbers up to 2**53 in size. So only larger whole numbers, fractions and
decimals take the exact arithmetic of fractions, which is some five times as slow. The result is the same. Their limits
are those of files, in Rust: beyond them a number could take all time and memory.
"""

from __future__ import annotations

import copy
import decimal
import fractions
import numbers
import os
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeVar

import numpy as np

from . import _native
from ._arrays import as_array, by_names, fits, listed
from ._errors import (
    CrossingEdgesError,
    EdgeOutOfRangeError,
    Error,
    KindError,
    NonFiniteError,
    OpenRingError,
    ShapeError,
)
from ._remarks import Remark

T = TypeVar("T")

NO_EDGES = np.empty((0, 2), dtype=np.uintp)


def as_points(given: Any, name: str = "points", missing: bool = False) -> Any:
    """Points as an array of doubles of shape (n, 2), or as exact points; missing ones are NaN where `missing` allows it.

    An array of the doubles of this machine, aligned and row by row in memory, is not copied.
    """
    if isinstance(given, _native.ExactPoints):
        return given
    given, _ = by_names(listed(given))
    if isinstance(given, (str, bytes)) or not (isinstance(given, Iterable) or hasattr(given, "__array__")):
        is_text = isinstance(given, (str, os.PathLike))
        hint = ": read a file with pandas or geopandas first, and WKT with shapely.from_wkt" if is_text else ""
        hint = ": shapely.from_wkb reads WKB" if isinstance(given, bytes) else hint
        raise KindError(f"{name} is no array but {_kind(given)}{hint}")
    array = as_array(given, name, missing)
    if array.size == 0 and array.ndim == 1:
        return np.empty((0, 2))
    if array.ndim and array.ndim < 3 and isinstance(first := array.flat[0] if array.size else None, (str, bytes)):
        if array.ndim == 1 or array.shape[1] != 2:
            reader = "wkb" if isinstance(first, bytes) else "wkt"
            raise KindError(f"{name} has texts, and no points: shapely.from_{reader} makes geometries of them")
    if array.ndim != 2 or array.shape[1] != 2:
        hint = ""
        if hasattr(given, "columns"):
            hint = ": name two of its columns x and y"
        elif array.ndim == 2 and array.shape[1] == 3:
            hint = f": of heights in a third column, pass {name}[:, :2]"
        raise ShapeError(f"{name} has the shape {array.shape}, not (n, 2){hint}", shape=array.shape)
    kind = array.dtype.kind
    if kind in "iuf" and array.dtype.itemsize <= 8 and fits(array):
        return _rows(array, np.float64)
    if kind in "iufO":
        return _exact(array, name)
    raise KindError(f"{name} has the type {array.dtype}, which is no type of coordinates")


def _rows(array: np.ndarray, dtype: Any) -> np.ndarray:
    """The array as Rust reads it: row by row, aligned, and with its bytes in the order of the machine."""
    return np.require(np.asarray(array), dtype, ["C", "A"])


def _exact(array: np.ndarray, name: str) -> Any:
    """Exact points from whole numbers, fractions, decimals and doubles, in an array of shape (n, 2)."""
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


def as_indices(given: Any, columns: int, name: str) -> np.ndarray:
    """Positions as an array of whole numbers of shape (m, columns); of a flat one the rows follow each other."""
    if given is None:
        return np.empty((0, columns), dtype=np.uintp)
    array = as_array(listed(given), name, columns=columns)
    if array.size == 0:
        return np.empty((0, columns), dtype=np.uintp)
    if columns == 3 and array.ndim == 1 and array.size % 3 == 0:
        array = array.reshape(-1, 3)
    if array.dtype == object and hasattr(array.flat[0], "geom_type"):
        raise KindError(f"{name} has geometries, and no positions: put all shapes in one list, the first argument")
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
        areas: Sequence[float] = (),
        features: Sequence[int] | None = None,
        heights: np.ndarray | None = None,
        markers: np.ndarray | None = None,
        crs: Any = None,
        feature_of: tuple[np.ndarray, np.ndarray] | None = None,
        remarks: Sequence[Remark] = (),
    ) -> None:
        self.points = points
        self.edges = edges
        # The polygon of each ring, and whether the ring is a hole in it.
        self.rings = list(rings)
        # For each edge its ring, or -1; nothing, if there are no rings.
        self.ring_of = ring_of if self.rings else None
        self.holes = _seeds(holes, "holes")
        self.regions = _seeds(regions, "regions")
        # The attribute of each region, and its greatest area.
        self.attributes = list(attributes)
        self.areas = list(areas)
        # The feature of each polygon, if a feature may have several.
        self.features = features
        # The height of each point, if any has one; and the coordinate system.
        self.heights = heights
        # The marker of each edge, if they have any.
        self.markers = markers
        self.crs = crs
        # The feature of each point and of each edge, if the input is of geometries.
        self.feature_of = feature_of
        # What was ignored or decided when the input was read.
        self.remarks = tuple(remarks)
        self._alike()

    def changed(self, **attributes: Any) -> Input:
        """The input with other points, edges and so on."""
        other = copy.copy(self)
        other.__dict__.update(attributes)
        other._alike()
        return other

    def of_pieces(self, edges: np.ndarray, pieces_of: np.ndarray) -> dict[str, Any]:
        """What belongs to pieces of the edges, and to new edges behind them. Features of edges are asked for in errors of
        the input alone."""
        new = len(edges) - len(pieces_of)
        ring_of, markers = (
            None if of_edge is None else np.r_[of_edge[pieces_of], np.full(new, none, dtype=np.int64)]
            for of_edge, none in ((self.ring_of, -1), (self.markers, 0))
        )
        return {"edges": edges, "ring_of": ring_of, "markers": markers, "feature_of": None}

    def feature_of_edge(self, edge: int) -> int | None:
        """The feature or polygon of an edge."""
        if self.feature_of is not None:
            return int(self.feature_of[1][edge])
        ring = -1 if self.ring_of is None else int(self.ring_of[edge])
        if ring < 0:
            return None
        polygon = self.rings[ring][0]
        return polygon if self.features is None else self.features[polygon]

    def places(self, vertices: Sequence[int]) -> Any:
        """Some of the points."""
        if isinstance(self.points, np.ndarray):
            return self.points[list(vertices)]
        parts = [[part[2 * v + axis] for v in vertices for axis in (0, 1)] for part in self.points.parts()]
        return _native.ExactPoints(*parts)

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


def _seeds(given: Any, name: str) -> Any:
    return np.empty((0, 2)) if given is None else as_points(given, name)


def called(function: Callable[..., T], given: Input, *arguments: Any) -> T:
    """Calls a function in Rust with an input. Errors tell the place, and the geometry, that they come from."""
    try:
        return function(given, *arguments)
    except NonFiniteError as error:
        row = given.points[error.vertex]
        axis = int(np.argmin(np.isfinite(row)))
        where, feature = f"points[{error.vertex}, {axis}]", None
        if given.feature_of is not None:
            feature = int(given.feature_of[0][error.vertex])
            where = f"a coordinate of geometry {feature}"
        message = f"{where} is {row[axis]}, which is not finite"
        raise NonFiniteError(message, vertex=error.vertex, axis=axis, feature=feature) from None
    except CrossingEdgesError as error:
        ends = given.places(given.edges[list(error.edges)].ravel().tolist())
        place = _native.crossings(Input(ends, np.arange(4, dtype=np.uintp).reshape(2, 2))).points()[0]
        features = [given.feature_of_edge(edge) for edge in error.edges]
        message = f"{error}, at {_words(place)}{_of_features(given, features)}"
        raise CrossingEdgesError(
            message, edges=error.edges, place=tuple(place.tolist()), features=tuple(features)
        ) from None
    except OpenRingError as error:
        place = as_doubles(given.places([error.vertex]))[0]
        feature = None if given.feature_of is None else int(given.feature_of[0][error.vertex])
        message = f"{error}, at {_words(place)}{_of_features(given, [feature])}"
        raise OpenRingError(message, vertex=error.vertex, place=tuple(place.tolist()), feature=feature) from None


def _words(place: np.ndarray) -> str:
    return f"({place[0]}, {place[1]})"


def _of_features(given: Input, features: Sequence[int | None]) -> str:
    known = list(dict.fromkeys(str(feature) for feature in features if feature is not None))
    if not known:
        return ""
    names = ("polygon", "polygons") if given.feature_of is None else ("geometry", "geometries")
    return f", of {names[len(known) > 1]} {' and '.join(known)}"
