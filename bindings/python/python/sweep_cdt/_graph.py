"""Inputs from what users have: arrays, polygons, shapely's geometries, GeoDataFrames, and dictionaries of `triangle`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ._errors import Error, KindError, ShapeError
from ._input import Input, as_edges, as_points


def as_input(given: Any, edges: Any = None, polygons: Any = None, holes: Any = None) -> Input:
    """The input that is given as points, or as an object that says more than that."""
    regions: Any = None
    attributes: Sequence[float] = ()
    rings: Sequence[tuple[int, bool]] = ()
    ring_of: np.ndarray | None = None
    if isinstance(given, dict):
        if "vertices" not in given:
            raise KindError("a dictionary has no 'vertices'")
        edges = given.get("segments") if edges is None else edges
        holes = given.get("holes") if holes is None else holes
        regions, attributes = _regions(given.get("regions"))
        given = given["vertices"]
    elif (geometries := as_geometries(given)) is not None:
        found = of_geometries(geometries)
        if edges is None and polygons is None:
            found.holes = Input(found.points, holes=holes).holes
            return found
        raise Error("edges and polygons go with points; put all shapes in one list of geometries")
    points = as_points(given)
    edges = as_edges(edges)
    if polygons is not None:
        points, edges, rings, ring_of = _with_polygons(points, edges, polygons)
    return Input(points, edges, rings, ring_of, holes, regions, attributes)


def _regions(given: Any) -> tuple[Any, Sequence[float]]:
    """The seeds of regions and their attributes, as `triangle` has them: x, y, attribute, greatest area."""
    if given is None or not len(_listed(given, "regions")):
        return None, ()
    try:
        rows = np.asarray(given, dtype=float)
    except (ValueError, TypeError):
        raise KindError("regions is no array of numbers") from None
    if rows.ndim != 2 or rows.shape[1] < 3:
        raise ShapeError(f"regions has the shape {rows.shape}, not (k, 4)", shape=rows.shape)
    return rows[:, :2], rows[:, 2].tolist()


def as_geometries(given: Any) -> np.ndarray | None:
    """Shapely's geometries, if these are some: one, a list, an array, a GeoSeries or a GeoDataFrame."""
    if type(given).__module__.startswith("geopandas"):
        return np.asarray(given.geometry, dtype=object)
    if _is_geometry(given):
        return np.array([given], dtype=object)
    if isinstance(given, (list, tuple)) and given and all(map(_is_geometry, given)):
        array = np.empty(len(given), dtype=object)
        array[:] = given
        return array
    if isinstance(given, np.ndarray) and given.dtype == object and given.ndim == 1 and given.size:
        return given if all(map(_is_geometry, given)) else None
    return None


def _is_geometry(given: Any) -> bool:
    return type(given).__module__.partition(".")[0] == "shapely" and hasattr(given, "geom_type")


def of_geometries(geometries: np.ndarray) -> Input:
    """The input of geometries: points, lines as edges, polygons with their holes. Equal positions are one vertex."""
    import shapely

    features = np.flatnonzero([g is not None for g in geometries])
    parts = geometries[features]
    # Collections may hold collections.
    while any(g.geom_type in COLLECTIONS for g in parts):
        parts, of = shapely.get_parts(parts, return_index=True)
        features = features[of]
    kinds = np.array([g.geom_type for g in parts], dtype=object)
    is_polygon = kinds == "Polygon"
    is_line = (kinds == "LineString") | (kinds == "LinearRing")
    is_point = kinds == "Point"

    places = [shapely.get_coordinates(parts[is_point])]
    lines, ends = _chains(parts[is_line], len(places[0]))
    rings, ring_polygon = shapely.get_rings(parts[is_polygon], return_index=True)
    ring_places, ring_ends = _chains(rings, len(places[0]) + len(lines))
    places += [lines, ring_places]
    edges = np.concatenate([ends[0], ring_ends[0]])
    ring_of = np.concatenate([np.full(len(ends[0]), -1), ring_ends[1]]).astype(np.int64)
    is_hole = np.r_[False, ring_polygon[1:] == ring_polygon[:-1]][: len(ring_polygon)]
    points, vertex = _distinct(np.concatenate(places))
    return Input(
        points,
        np.ascontiguousarray(vertex[edges].reshape(-1, 2), dtype=np.uintp),
        list(zip(ring_polygon.tolist(), is_hole.tolist())),
        ring_of,
        features=features[is_polygon].tolist(),
    )


COLLECTIONS = {"MultiPoint", "MultiLineString", "MultiPolygon", "GeometryCollection"}


def _chains(lines: np.ndarray, first: int) -> tuple[np.ndarray, tuple[np.ndarray, np.ndarray]]:
    """The coordinates of lines, numbered from `first`, and their steps with the line of each."""
    import shapely

    places, line = shapely.get_coordinates(lines, return_index=True)
    step = np.flatnonzero(line[1:] == line[:-1])
    edges = np.stack([step, step + 1], axis=1) + first
    return places, (edges, line[step])


def _distinct(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The distinct ones in the order in which they come, and for each place its number."""
    _, first, inverse = np.unique(places + 0.0, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return np.ascontiguousarray(places[first[order]]), rank[inverse.ravel()]


def _with_polygons(
    points: Any, edges: np.ndarray, polygons: Any
) -> tuple[Any, np.ndarray, list[tuple[int, bool]], np.ndarray]:
    """Points and edges with those of polygons, then the rings, and the ring of each edge.

    Polygons are lists of rings, the outline first, of positions or of coordinates; or shapely's.
    """
    if isinstance(points, np.ndarray):
        added = [points]
    else:
        added = None
    count, sides, ring_of = len(points), [edges], [np.full(len(edges), -1, dtype=np.int64)]
    rings: list[tuple[int, bool]] = []
    for polygon, given in enumerate(_rings(polygons)):
        for position, ring in enumerate(given):
            name = f"polygons[{polygon}][{position}]"
            vertices, places = _ring(ring, name)
            if places is not None:
                if added is None:
                    raise KindError(f"{name} has coordinates, but the points are exact: add them to the points")
                added.append(places)
                vertices = np.arange(count, count + len(places))
                count += len(places)
            if len(vertices) > 1 and vertices[0] == vertices[-1]:
                vertices = vertices[:-1]
            if vertices.size and (vertices.min() < 0):
                raise ShapeError(f"{name} names vertex {vertices.min()}, which does not exist")
            sides.append(np.stack([vertices, np.roll(vertices, -1)], axis=1).astype(np.uintp))
            ring_of.append(np.full(len(vertices), len(rings), dtype=np.int64))
            rings.append((polygon, position > 0))
    points = points if added is None else np.concatenate(added)
    return points, np.concatenate(sides), rings, np.concatenate(ring_of)


def _rings(polygons: Any) -> list[Any]:
    """The rings of each polygon."""
    geometries = as_geometries(polygons)
    if geometries is None:
        for polygon, rings in enumerate(_listed(polygons, "polygons")):
            _listed(rings, f"polygons[{polygon}]")
        return list(polygons)
    import shapely

    parts = shapely.get_parts(geometries)
    if any(g.geom_type != "Polygon" for g in parts):
        raise KindError("polygons has geometries that are no polygons: pass these with the points")
    rings = [[p.exterior, *p.interiors] for p in parts]
    return [[np.asarray(ring.coords)[:, :2] for ring in polygon] for polygon in rings]


def _listed(given: Any, name: str) -> Any:
    """What is given, which must be a list of something."""
    if isinstance(given, (str, bytes, dict)) or not hasattr(given, "__len__") or not hasattr(given, "__getitem__"):
        raise KindError(f"{name} is no list but of the type {type(given).__name__}")
    return given


def _ring(ring: Any, name: str) -> tuple[np.ndarray, np.ndarray | None]:
    """A ring as positions, or as coordinates without the first one again at the end."""
    try:
        array = np.asarray(ring)
    except (ValueError, TypeError, OverflowError):
        raise ShapeError(f"{name} is neither positions of points nor coordinates") from None
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
