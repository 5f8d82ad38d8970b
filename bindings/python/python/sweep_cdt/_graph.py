"""Inputs from what users have: arrays, polygons, geometries, and dictionaries of `triangle`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ._arrays import as_array, as_values, listed
from ._errors import Error, KindError, ShapeError
from ._geometries import agree, as_geometries, as_places, of_geometries, rings_of
from ._input import Input, as_edges, as_points


def as_input(given: Any, edges: Any = None, polygons: Any = None, holes: Any = None) -> Input:
    """The input that is given as points, or as an object that says more than that."""
    given, polygons = listed(given), listed(polygons)
    if holes is not None and (seeds := as_geometries(listed(holes), "holes")) is not None:
        holes = as_places(seeds, "holes")
    if (geometries := as_geometries(given)) is not None:
        if edges is None and polygons is None:
            found = of_geometries(geometries)
            return found if holes is None else found.changed(holes=Input(found.points, holes=holes).holes)
        raise Error("edges and polygons go with points; put all shapes in one list of geometries")
    regions: Any = None
    attributes: Sequence[float] = ()
    heights = None
    if isinstance(given, dict):
        if "vertices" not in given:
            raise KindError("a dictionary has no 'vertices', as of `triangle`, and is no GeoJSON")
        edges = given.get("segments") if edges is None else edges
        holes = given.get("holes") if holes is None else holes
        regions, attributes = _regions(given.get("regions"))
        heights = given.get("vertex_attributes")
        given = given["vertices"]
    points = as_points(given)
    if heights is not None:
        # The first attribute, as of .node files.
        heights = first_column(heights, len(points), "vertex_attributes")
    whole = Input(points, as_edges(edges), holes=holes, regions=regions, attributes=attributes, heights=heights)
    return whole if polygons is None else _with_polygons(whole, polygons)


def as_queries(given: Any, name: str, own: Input) -> tuple[Any, Any, np.ndarray, tuple[int, ...]]:
    """Points to look for, in an array of any shape or as geometries: the finite ones, and the points of the input in the
    same arithmetic; which ones are finite, and the shape."""
    given = listed(given)
    if (geometries := as_geometries(given, name)) is not None:
        agree(own.crs, geometries.crs, name)
        array = as_places(geometries, name)
    else:
        array = as_array(given, name, missing=True)
    if array.ndim == 0 or array.shape[-1] != 2:
        raise ShapeError(f"{name} has the shape {array.shape}, not (..., 2)", shape=array.shape)
    rows = array.reshape(-1, 2)
    if rows.dtype.kind == "O":
        is_finite = [not (isinstance(x, float) and not np.isfinite(x)) for x in rows.flat]
        finite = np.array(is_finite, dtype=bool).reshape(-1, 2).all(axis=1)
    else:
        finite = np.isfinite(rows).all(axis=1) if rows.dtype.kind == "f" else np.ones(len(rows), dtype=bool)
    queries, points = as_points(rows if finite.all() else rows[finite], name), own.points
    # Doubles on a grid are looked up as doubles, others are converted to the kind of the points.
    if isinstance(queries, np.ndarray) and own.is_exact:
        queries = as_points(queries.astype(object), name)
    elif not isinstance(queries, np.ndarray) and not own.is_exact:
        points = as_points(points.astype(object))
    return points, queries, finite, array.shape[:-1]


def stacked(xi: Any) -> Any:
    """A tuple of x and y as points, and anything else as it is."""
    if not isinstance(xi, tuple) or len(xi) != 2 or as_geometries(xi) is not None:
        return xi
    x, y = (as_array(listed(axis), "xi", missing=True, columns=None) for axis in xi)
    try:
        return np.stack(np.broadcast_arrays(x, y), axis=-1)
    except ValueError:
        raise ShapeError(f"x has the shape {x.shape}, and y {y.shape}", shape=x.shape) from None


def first_column(given: Any, count: int, name: str) -> np.ndarray | None:
    """The first of the numbers of each row, if they have any."""
    rows = as_values(given, count, name)
    rows = rows.reshape(count, -1) if count else np.empty((0, 0))
    return np.ascontiguousarray(rows[:, 0]) if rows.shape[1] else None


def _regions(given: Any) -> tuple[Any, Sequence[float]]:
    """The seeds of regions and their attributes, as `triangle` has them: x, y, attribute, greatest area."""
    if given is None or not len(_listed(given, "regions")):
        return None, ()
    rows = as_values(as_array(given, "regions"), None, "regions")
    if rows.ndim != 2 or rows.shape[1] < 3:
        raise ShapeError(f"regions has the shape {rows.shape}, not (k, 4)", shape=rows.shape)
    return rows[:, :2], rows[:, 2].tolist()


def _with_polygons(given: Input, polygons: Any) -> Input:
    """The input with the rings of polygons: lists of rings, the outline first, of positions or of coordinates; or
    geometries."""
    rings_of_polygons, features, crs = polygons, None, given.crs
    if (geometries := as_geometries(polygons, "polygons")) is not None:
        rings_of_polygons, features = rings_of(geometries, "polygons")
        crs = geometries.crs
    added = [given.points] if isinstance(given.points, np.ndarray) else None
    count = len(given.points)
    heights = [np.full(count, np.nan) if given.heights is None else given.heights]
    sides, ring_of = [given.edges], [np.full(len(given.edges), -1, dtype=np.int64)]
    rings: list[tuple[int, bool]] = []
    for polygon, rings_given in enumerate(_listed(rings_of_polygons, "polygons")):
        for position, ring in enumerate(_listed(rings_given, f"polygons[{polygon}]")):
            name = f"polygons[{polygon}][{position}]"
            if geometries is not None:
                ring, z = ring[:, :2], ring[:, 2]
            vertices, places = _ring(ring, name)
            if places is not None:
                if added is None:
                    raise KindError(f"{name} has coordinates, but the points are exact: add them to the points")
                added.append(places)
                heights.append(np.full(len(places), np.nan) if geometries is None else z)
                vertices = np.arange(count, count + len(places))
                count += len(places)
            if len(vertices) > 1 and vertices[0] == vertices[-1]:
                vertices = vertices[:-1]
            if vertices.size and (vertices.min() < 0):
                raise ShapeError(f"{name} names vertex {vertices.min()}, which does not exist")
            sides.append(np.stack([vertices, np.roll(vertices, -1)], axis=1).astype(np.uintp))
            ring_of.append(np.full(len(vertices), len(rings), dtype=np.int64))
            rings.append((polygon, position > 0))
    known = np.concatenate(heights)
    return given.changed(
        points=given.points if added is None else np.concatenate(added),
        edges=np.concatenate(sides),
        rings=rings,
        ring_of=np.concatenate(ring_of) if rings else None,
        features=features,
        heights=None if np.isnan(known).all() else known,
        crs=crs,
    )


def _listed(given: Any, name: str) -> Any:
    """What is given, which must be a list of something."""
    if isinstance(given, (str, bytes, dict)) or not hasattr(given, "__len__") or not hasattr(given, "__getitem__"):
        raise KindError(f"{name} is no list but of the type {type(given).__name__}")
    return given


def _ring(ring: Any, name: str) -> tuple[np.ndarray, np.ndarray | None]:
    """A ring as positions, or as coordinates without the first one again at the end."""
    array = as_array(listed(ring), name)
    if array.ndim == 1 and (array.dtype.kind in "iu" or array.size == 0):
        return array.astype(np.int64), None
    if array.ndim != 2 or array.shape[1] != 2:
        raise ShapeError(f"{name} is neither positions of points nor coordinates", shape=array.shape)
    places = as_points(array, name)
    if not isinstance(places, np.ndarray):
        raise KindError(f"{name} has exact coordinates: add them to the points, and name their positions")
    if len(places) > 1 and (places[0] == places[-1]).all():
        places = places[:-1]
    return np.empty(0, dtype=np.int64), places
