"""Arrays and columns of all kinds as plain arrays: the one place that reads masks, nullable columns and frames.

A masked entry and a missing one (NA of pandas, None) are one thing: there is no number. Where a number must be, they
are refused by name. Among values, and where values are asked for, they are NaN.
"""

from __future__ import annotations

import numbers
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from . import _native
from ._errors import KindError, ShapeError

# Whole numbers up to this size are doubles.
WHOLE = 2**53


def by_names(given: Any, height: str | None = None) -> tuple[Any, Any]:
    """Of a frame, or of an array with fields, that names x and y, as a table does in its first row: these columns, and the
    one of heights, if it names one, or has the one that is asked for. Anything else as it is."""
    if has_fields(given):
        names = list(given.dtype.names)
    elif _is_frame(given):
        names = [str(name) for name in getattr(given, "column_names", given.columns)]
    else:
        return given, None
    places = _native.named_columns(names)
    if places is None:
        return given, None
    heights = places[2:]
    if height is not None:
        heights = [at for at in range(len(names)) if names[at] == height and at not in places[:2]][:1]
    return picked(given, places[:2]), picked(given, heights) if heights else None


def _is_frame(given: Any) -> bool:
    """Whether this is a frame of pandas or polars, or a table of pyarrow."""
    return hasattr(given, "columns") and hasattr(given, "__array__")


def has_fields(given: Any) -> bool:
    return isinstance(given, np.ndarray) and bool(given.dtype.names)


def picked(given: Any, places: list[int]) -> Any:
    """Some columns of a frame, or fields of an array."""
    if has_fields(given):
        return given[[given.dtype.names[at] for at in places]]
    if hasattr(given, "iloc"):
        return given.iloc[:, places]
    return given.select(places) if hasattr(given, "column_names") else given[:, places]


def as_array(given: Any, name: str, missing: bool = False, columns: int | None = 2) -> np.ndarray:
    """An array without a mask, of rows with so many columns. Where `missing` allows them, missing entries are NaN."""
    try:
        array, mask = _read(given)
    except ValueError:
        raise _ragged(given, name, columns) from None
    except (TypeError, OverflowError) as error:
        raise KindError(f"{name} is no array of numbers: {error}") from None
    if missing and array.dtype.kind == "O":
        of_objects = np.array([is_missing(x) for x in array.flat], dtype=bool).reshape(array.shape)
        mask = of_objects if mask is None else mask | of_objects
    if mask is None or not mask.any():
        return array
    if not missing:
        position = tuple(int(at) for at in np.argwhere(mask)[0])
        where = ", ".join(map(str, position))
        raise KindError(f"{name}[{where}] is masked or missing, so that it is no number", position=position)
    # NaN is no whole number; exact numbers stay what they are.
    array = array.astype(object if array.dtype.kind == "O" or not fits(array) else float)
    array[mask] = np.nan
    return array


def _ragged(rows: Any, name: str, columns: int | None) -> ShapeError:
    """The error for rows of several lengths: the first that has not so many numbers."""
    for position, row in enumerate(rows if columns else ()):
        # A masked row has no length, though it has the method.
        length = len(row) if hasattr(row, "__len__") and row is not np.ma.masked else None
        if length != columns:
            what = (
                f"is no {'pair' if columns == 2 else 'triple'}"
                if length is None
                else f"has {length} numbers, not {columns}"
            )
            return ShapeError(f"{name}[{position}] {what}", position=position)
    return ShapeError(f"{name} is no array: its rows differ in length")


def as_values(given: Any, count: int | None, name: str = "values") -> np.ndarray:
    """Values as doubles, of `count` rows; NaN where one is missing."""
    array = as_array(listed(given), name, missing=True, columns=None)
    if array.dtype.kind == "O":
        try:
            array = np.array([float(x) for x in array.flat], dtype=float).reshape(array.shape)
        except (ValueError, TypeError, OverflowError) as error:
            raise KindError(f"{name} is no array of numbers: {error}") from None
    if array.dtype.kind not in "biuf":
        raise KindError(f"{name} has the type {array.dtype}, which is no type of numbers")
    if array.ndim == 0 or count is not None and len(array) != count:
        raise ShapeError(f"{name} has the shape {array.shape}, not ({count}, ...)", shape=array.shape)
    return array.astype(float, copy=False)


def is_missing(value: Any) -> bool:
    """Whether an object stands for no value."""
    return value is None or value is np.ma.masked or type(value).__name__ in ("NAType", "NaTType")


def fits(array: np.ndarray) -> bool:
    """Whether all numbers are doubles, so far as their type tells."""
    if array.dtype.kind not in "iu" or array.dtype.itemsize < 8 or array.size == 0:
        return True
    return int(array.max()) <= WHOLE and int(array.min()) >= -WHOLE


def listed(given: Any) -> Any:
    """The argument; as a list, if it can be passed through once only."""
    if isinstance(given, (str, bytes, dict, Sequence)) or hasattr(given, "__array__") or hasattr(given, "__len__"):
        return given
    return list(given) if isinstance(given, Iterable) else given


def _read(given: Any) -> tuple[np.ndarray, np.ndarray | None]:
    """An array, and which of its entries are missing; nothing, if none can be."""
    if isinstance(given, (list, tuple)) and any(isinstance(row, np.ma.MaskedArray) for row in given):
        # NumPy would drop the masks.
        given = np.ma.array(given)
    if has_fields(given) or _is_frame(given):
        return _of_columns(given)
    if isinstance(given, np.ma.MaskedArray):
        return np.asarray(given.data), np.ma.getmaskarray(given)
    if hasattr(given, "isna") and hasattr(given, "to_numpy"):
        return _of_column(given)
    if isinstance(given, np.ndarray) or hasattr(given, "__array__"):
        return np.asarray(given), None
    array = np.asarray(given)
    if array.dtype.kind == "f":
        # NumPy rounds whole numbers beside doubles.
        objects = np.asarray(given, dtype=object)
        if any(isinstance(x, numbers.Integral) and abs(int(x)) > WHOLE for x in objects.flat):
            return objects, None
    return array, None


def _of_columns(given: Any) -> tuple[np.ndarray, np.ndarray | None]:
    """A frame, or an array with fields."""
    if has_fields(given):
        columns = [given[name] for name in given.dtype.names]
    elif hasattr(given, "iloc"):
        columns = [given.iloc[:, at] for at in range(given.shape[1])]
    else:
        columns = given.get_columns() if hasattr(given, "get_columns") else list(given.columns)
    read = [_of_column(column) for column in columns]
    arrays = [array for array, _ in read]
    if not arrays:
        return np.asarray(given), None
    kinds = {array.dtype.kind for array in arrays}
    if len(kinds) > 1 and ("b" in kinds or not all(map(fits, arrays))):
        # NumPy rounds whole numbers beside doubles, and makes numbers of true and false.
        arrays = [array.astype(object) for array in arrays]
    none = np.zeros(arrays[0].shape, dtype=bool)
    return np.stack(arrays, axis=-1), np.stack([none if mask is None else mask for _, mask in read], axis=-1)


def _of_column(given: Any) -> tuple[np.ndarray, np.ndarray | None]:
    """A column or an index. One of pandas that can hold NA has a type of its own, which names that of NumPy."""
    if isinstance(given, np.ma.MaskedArray):
        return np.asarray(given.data), np.ma.getmaskarray(given)
    kind = getattr(getattr(given, "dtype", None), "numpy_dtype", None)
    if kind is None:
        array = np.asarray(given)
        return _of_objects(array) if array.dtype == object else (array, None)
    mask = np.asarray(given.isna(), dtype=bool)
    # The number under a mask counts for nothing.
    filler = np.zeros(1, dtype=kind)[0] if kind.kind in "biuf" else None
    return given.to_numpy(dtype=kind, na_value=filler), mask


def _of_objects(array: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
    """A column of objects: doubles, where all that is there are doubles and whole numbers that are."""
    mask = np.array([is_missing(x) for x in array], dtype=bool)
    numbers_there = array[~mask]
    kinds = {type(x) for x in numbers_there}
    if not kinds <= {float, int, np.float64, np.int64} or any(abs(x) > WHOLE for x in numbers_there if type(x) is not float):
        return array, None
    doubles = np.full(len(array), np.nan)
    doubles[~mask] = numbers_there.astype(float)
    return doubles, mask
