"""Inputs from what users have: arrays, polygons, geometries, and dictionaries of `triangle`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from . import _native
from ._arrays import as_array, as_values, by_names, listed
from ._errors import Error, KindError, ShapeError
from ._geometries import agree, as_geometries, as_places, of_geometries, rings_of
from ._input import Input, as_doubles, as_edges, as_points


def as_input(
    given: Any, edges: Any = None, polygons: Any = None, holes: Any = None, height: str | None = None
) -> Input:
    """The input that is given as points, or as an object that says more than that."""
    holes = listed(holes)
    seeds = None if holes is None else as_geometries(holes, "holes")
    found = _as_input(given, edges, polygons, holes if seeds is None else as_places(seeds, "holes"), height)
    if seeds is not None:
        agree(found.crs, seeds.crs, "holes")
    if found.heights is None:
        return found
    return found.changed(remarks=(*found.remarks, *_native.voids(found.heights)))


def _as_input(given: Any, edges: Any, polygons: Any, holes: Any, height: str | None) -> Input:
    given, polygons = listed(given), listed(polygons)
    if (geometries := as_geometries(given, height=height)) is not None:
        if edges is None and polygons is None:
            found = of_geometries(geometries, height)
            return found if holes is None else found.changed(holes=Input(found.points, holes=holes).holes)
        raise Error("edges and polygons go with points; put all shapes in one list of geometries")
    regions: Any = None
    attributes: Sequence[float] = ()
    areas: Sequence[float] = ()
    heights = markers = None
    if isinstance(given, dict):
        if "vertices" not in given:
            raise KindError("a dictionary has no 'vertices', as of `triangle`, and is no GeoJSON: geopandas reads other maps")
        edges = given.get("segments") if edges is None else edges
        holes = given.get("holes") if holes is None else holes
        regions, attributes, areas = _regions(given.get("regions"))
        heights, markers = given.get("vertex_attributes"), given.get("segment_markers")
        given = given["vertices"]
    places, z = by_names(given, height)
    points = as_points(places)
    if heights is not None:
        # The first attribute, as of .node files.
        heights = first_column(heights, len(points), "vertex_attributes")
    elif z is not None:
        heights = first_column(z, len(points), "the column of heights")
    remarks = _native.height_property(height, 0) if height is not None and z is None else []
    edges = as_edges(edges)
    if markers is not None:
        markers = _markers(markers, len(edges))
    whole = Input(
        points,
        edges,
        holes=holes,
        regions=regions,
        attributes=attributes,
        areas=areas,
        heights=heights,
        markers=markers,
        remarks=remarks,
    )
    return whole if polygons is None else _with_polygons(whole, polygons)


def first_column(given: Any, count: int, name: str) -> np.ndarray | None:
    """The first of the numbers of each row, if they have any."""
    rows = as_values(given, count, name)
    rows = rows.reshape(count, -1) if count else np.empty((0, 0))
    return np.ascontiguousarray(rows[:, 0]) if rows.shape[1] else None


def _markers(given: Any, count: int) -> np.ndarray:
    """A whole number for each edge."""
    rows = as_array(given, "segment_markers", columns=None)
    if rows.dtype.kind not in "iu" or rows.size != count:
        message = f"segment_markers has the shape {rows.shape}: it is a whole number for each edge"
        raise ShapeError(message, shape=rows.shape)
    return rows.reshape(count).astype(np.int64)


def _regions(given: Any) -> tuple[Any, Sequence[float], Sequence[float]]:
    """The seeds of regions, their attributes and areas, as `triangle` has them: x, y, attribute, greatest area, which
    is none where it is not above 0."""
    if given is None or not len(_listed(given, "regions")):
        return None, (), ()
    rows = as_values(as_array(given, "regions"), None, "regions")
    if rows.ndim != 2 or rows.shape[1] < 3:
        raise ShapeError(f"regions has the shape {rows.shape}, not (k, 4)", shape=rows.shape)
    areas = rows[:, 3] if rows.shape[1] > 3 else np.zeros(0)
    has_area = areas > 0
    return rows[:, :2], rows[:, 2].tolist(), np.where(has_area, areas, np.inf).tolist() if has_area.any() else ()


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
    points = given.points if added is None else np.concatenate(added)
    edges = np.concatenate(sides)
    remarks = list(given.remarks)
    if geometries is not None and geometries.is_on_globe:
        remarks += _native.half_of_the_globe(as_doubles(points), edges)
    new = np.zeros(sum(map(len, sides)) - len(given.edges), dtype=np.int64)
    return given.changed(
        points=points,
        edges=edges,
        rings=rings,
        ring_of=np.concatenate(ring_of) if rings else None,
        features=features,
        markers=None if given.markers is None else np.r_[given.markers, new],
        heights=None if np.isnan(known).all() else known,
        crs=crs,
        remarks=tuple(remarks),
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
