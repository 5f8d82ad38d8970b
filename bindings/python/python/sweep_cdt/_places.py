"""Where points lie, and values there: methods of `Triangulation`. The crate finds and interpolates them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native
from ._arrays import as_array, as_values, by_names, listed
from ._errors import KindError, ShapeError, check_distance
from ._geometries import agree, as_geometries, as_places, gathered
from ._input import NO_EDGES, Input, as_points
from ._remarks import Remark, say

if TYPE_CHECKING:
    from ._triangulation import Triangulation


def find_simplex(self: Triangulation, xi: Any, bruteforce: bool = False, tol: float | None = None) -> np.ndarray:
    """The triangles that hold points, exactly.

    Parameters
    ----------
    xi : array_like of shape (..., 2), or points as geometries
        The points, in the units of the triangulation. Of a point on a side or at a corner one of its triangles is
        found. Geometries are those of shapely and geopandas, of which a CRS is that of the triangulation.
    bruteforce, tol : optional
        Not used: SciPy has them.

    Returns
    -------
    ndarray of int32 of shape (...)
        Positions in `simplices`; -1 outside of the hull, and for points that are not finite, masked or missing.

    Raises
    ------
    Error
        `ShapeError` and `KindError`, if `xi` has no points; `Error`, if it has another CRS.

    Examples
    --------
    >>> import sweep_cdt
    >>> result = sweep_cdt.triangulate([[0, 0], [4, 0], [0, 4]])
    >>> result.find_simplex([[1, 1], [0, 4], [3, 3]]).tolist()
    [0, 0, -1]
    """
    del bruteforce, tol
    points, queries, finite, shape = as_queries(xi, "xi", self._input)
    found = np.full(len(finite), -1, dtype=np.int32)
    found[finite] = self._core.locate(points, queries)
    return found.reshape(shape)


def interpolate(
    self: Triangulation, values: Any, xi: Any, *, within: float | None = None, strict: bool = False
) -> np.ndarray:
    """Values at points, interpolated linearly in each triangle that is inside.

    Parameters
    ----------
    values : array_like of shape (n,) or (n, k)
        A value for each point: `heights`, for instance. One that is not finite, masked or missing is not there.
    xi : array_like of shape (..., 2), points as geometries, or a tuple of x and y
        Where to interpolate, in the units of the triangulation. A tuple has an array of x and one of y, as of SciPy.
        Geometries are those of shapely and geopandas, of which a CRS is that of the triangulation.
    within : float, optional
        A point outside has the value of the nearest place on the border that is at most so far away, in the units of
        the triangulation. Points that lie on the border but for rounding need a distance greater than that.
    strict : bool, optional
        As of `triangulate`.

    Returns
    -------
    ndarray of shape (...) or (..., k)
        In the units of the values. NaN where no triangle is inside, and where a value that counts is not there. Where a
        point lies is decided exactly; on a side the values of its two ends count, at a corner that of the corner
        alone. A `RemarkWarning` counts the points without a value. Equal points are one corner, with the first value
        that one of them has; a `RemarkWarning` names the first other one.

    Raises
    ------
    Error
        `ShapeError` and `KindError`, if there is not a value for each point, or if `xi` has no points; `Error`, if it
        has another CRS, or `within` is no finite number from 0 on.

    Examples
    --------
    >>> import sweep_cdt
    >>> hill = sweep_cdt.triangulate([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]])
    >>> hill.interpolate([0, 0, 0, 0, 8], [[2, 1], [2, 2], [9, 9]]).tolist()
    [4.0, 8.0, nan]
    >>> hill.interpolate([0, 0, 4, 4, 8], [[4, 3], [4 + 1e-15, 3]], within=1e-9).tolist()
    [3.0, 3.0]
    """
    check_distance("within", within)
    if values is None:
        raise KindError("values is None, as `heights` is where no point has one")
    count = len(self._input.points)
    values = as_values(values, count)
    rest = values.shape[1:]
    points, queries, finite, shape = as_queries(_stacked(xi), "xi", self._input)
    columns = np.ascontiguousarray(values.reshape(count, math.prod(rest)))
    for column in columns.T:
        if len(self.duplicates):
            say(of_equal(self, column, "values")[1], strict)
        if self.heights is None or not np.array_equal(column, self.heights, equal_nan=True):
            say(_native.voids(np.ascontiguousarray(column)))
    result = np.full((len(finite), columns.shape[1]), np.nan)
    found = self._core.interpolate(self._input, self.rule, columns, (points, queries), within)
    result[finite] = found = found.reshape(len(queries), columns.shape[1])
    say(_native.off_terrain(int(np.isnan(found).any(axis=1).sum()), len(found)))
    return result.reshape(shape + rest)


def nearest(self: Triangulation, xi: Any) -> np.ndarray:
    """The point nearest to each place, decided exactly; of several the first.

    Parameters
    ----------
    xi : array_like of shape (..., 2), or points as geometries
        The places, as of `find_simplex`.

    Returns
    -------
    ndarray of int of shape (...)
        Positions in `points`; -1 where there is none, and for places that are not finite, masked or missing.

    Examples
    --------
    >>> import sweep_cdt
    >>> shops = sweep_cdt.triangulate([[0, 0], [8, 0], [8, 6]])
    >>> shops.nearest([[9, 2], [4, 3]]).tolist()
    [1, 0]
    """
    points, places, finite, shape = as_queries(xi, "xi", self._input)
    found = np.full(len(finite), -1, dtype=np.intp)
    found[finite] = _dynamic(self, points).nearest(places)
    return found.reshape(shape)


def _dynamic(self: Triangulation, points: Any) -> _native.Dynamic:
    """The points alone, in the arithmetic of what is looked for; kept where that is their own."""
    if points is self._input.points and self._points_alone is not None:
        return self._points_alone
    found = _native.Dynamic(not isinstance(points, np.ndarray))
    found.edit(points, NO_EDGES, NO_EDGES, [], [])
    if points is self._input.points:
        self._points_alone = found
    return found


def of_equal(self: Triangulation, values: np.ndarray, name: str) -> tuple[np.ndarray, list[Remark]]:
    """Values of which equal points have one, and the remark on other ones."""
    if not len(self.duplicates):
        return values, []
    first = np.arange(len(values))
    first[self.duplicates[:, 0]] = self.duplicates[:, 1]
    shared, remarks = gathered(values, first, len(values), name)
    return shared[first], remarks


def as_queries(given: Any, name: str, own: Input) -> tuple[Any, Any, np.ndarray, tuple[int, ...]]:
    """The points of an input, and those to look for in the same arithmetic, without those that are not finite; which are
    finite, and the shape of what is handed in: an array or geometries."""
    given = listed(given)
    if (geometries := as_geometries(given, name)) is not None:
        agree(own.crs, geometries.crs, name)
        array = as_places(geometries, name)
    else:
        array = as_array(by_names(given)[0], name, missing=True)
    if array.ndim == 0 or array.shape[-1] != 2:
        raise ShapeError(f"{name} has the shape {array.shape}, not (..., 2)", shape=array.shape)
    rows = array.reshape(-1, 2)
    is_finite = np.ones(rows.shape, dtype=bool)
    if rows.dtype.kind == "O":
        of_each = [not (isinstance(x, float) and not np.isfinite(x)) for x in rows.flat]
        is_finite = np.array(of_each, dtype=bool).reshape(rows.shape)
    elif rows.dtype.kind == "f":
        is_finite = np.isfinite(rows)
    finite = is_finite[:, 0] & is_finite[:, 1]
    queries, points = as_points(rows if finite.all() else rows[finite], name), own.points
    # Doubles on a grid are looked up as doubles, others are converted to the kind of the points.
    if isinstance(queries, np.ndarray) and own.is_exact:
        queries = as_points(queries.astype(object), name)
    elif not isinstance(queries, np.ndarray) and not own.is_exact:
        points = as_points(points.astype(object))
    return points, queries, finite, array.shape[:-1]


def _stacked(xi: Any) -> Any:
    """A tuple of x and y as points, and anything else as it is."""
    if not isinstance(xi, tuple) or len(xi) != 2 or as_geometries(xi) is not None:
        return xi
    x, y = (as_array(listed(axis), "xi", missing=True, columns=None) for axis in xi)
    try:
        return np.stack(np.broadcast_arrays(x, y), axis=-1)
    except ValueError:
        raise ShapeError(f"x has the shape {x.shape}, and y {y.shape}", shape=x.shape) from None
