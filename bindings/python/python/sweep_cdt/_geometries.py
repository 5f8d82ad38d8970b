"""Geometries in every wrapping: of shapely and geopandas, in lists, arrays and columns, and of `__geo_interface__`.

A feature is a geometry by its place in what is handed in; it may have several parts, and parts of parts. An object is
known by what it has, so that shapely is imported where there are geometries.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from . import _native
from ._arrays import as_values, by_names, has_fields, is_missing, picked
from ._errors import Error, KindError
from ._input import Input, as_points
from ._remarks import Remark

# The types of GeoJSON, and the one that shapely has beside them.
GEOJSON = {"Feature", "FeatureCollection", "GeometryCollection", "LineString", "MultiLineString", "MultiPoint"} | {
    "MultiPolygon", "Point", "Polygon", "LinearRing"
}  # fmt: skip
# The name of the column of heights.
HEIGHT = "z"
COLLECTIONS = {"MultiPoint", "MultiLineString", "MultiPolygon", "GeometryCollection"}


@dataclasses.dataclass
class Geometries:
    """Geometries of shapely, `None` where a feature has none, and what is said of them."""

    features: np.ndarray
    crs: Any = None
    # Whether the coordinate system is known to be one of longitudes and latitudes.
    is_on_globe: bool = False
    # The height of each feature, NaN where it has none, and the name of the property that it is, if there are any.
    heights: np.ndarray | None = None
    height_name: str = HEIGHT
    # How many numbers stand behind the third of a position.
    measures: int = 0


def as_geometries(given: Any, name: str = "points", height: str | None = None) -> Geometries | None:
    """The geometries that are handed in, with the heights of a column or property that is asked for, or of one with a
    usual name; `None`, if it is something else."""
    if _is_of(given, "geopandas"):
        return _of_geopandas(given, name, height)
    if _is_geometry(given):
        return _of_shape(given)
    if (document := _document(given)) is not None:
        found = _of_document(document, name, height)
        # An object need not be of longitudes and latitudes.
        found.is_on_globe &= document is given
        return found
    if hasattr(given, "columns") and hasattr(given, "iloc"):
        # A frame of pandas, of which a column has geometries.
        columns = [given.iloc[:, at] for at in range(given.shape[1])]
        named = [column for column in columns if column.name == "geometry"]
        held = [inner for column in named or columns if (inner := _of_column(column, name)) is not None]
        if len(held) > 1:
            raise KindError(f"{name} has several columns of geometries: pass one of them")
        for inner in held:
            _raise(inner, given, height)
        return held[0] if held else None
    if hasattr(given, "dtype"):
        members = np.asarray(given).ravel() if given.dtype == object else ()
    else:
        has_members = (
            isinstance(given, Iterable) and hasattr(given, "__len__") and not isinstance(given, (str, bytes, dict))
        )
        members = given if has_members else ()
    first = next((member for member in members if not (_is_none(member) or _is_table(member))), None)
    if first is None or not (_is_of(first, "geopandas") or _is_geometry(first) or _document(first) is not None):
        return None
    return _of_members(members, name, height)


def _of_column(given: Any, name: str) -> Geometries | None:
    """The geometries in a column of pandas, if it has some."""
    return as_geometries(given, name) if str(given.dtype) in ("object", "geometry") else None


def _is_of(given: Any, library: str) -> bool:
    """Whether the class, or one that it is made of, is of this library."""
    return any(kind.__module__.partition(".")[0] == library for kind in type(given).__mro__)


def _is_geometry(given: Any) -> bool:
    return _is_of(given, "shapely") and hasattr(given, "geom_type")


def _is_none(given: Any) -> bool:
    """Whether it stands for no geometry: also the NaN that pandas has in a column of objects."""
    return is_missing(given) or isinstance(given, float) and math.isnan(given)


def _is_table(given: Any) -> bool:
    """Whether it is an array or a frame without geometries."""
    is_table = getattr(given, "ndim", 0) == 2 or has_fields(given)
    return is_table and not _is_of(given, "geopandas")


def _document(given: Any) -> dict[str, Any] | None:
    """The GeoJSON that an object is, or says of itself."""
    document = given if isinstance(given, dict) else getattr(given, "__geo_interface__", None)
    return document if isinstance(document, dict) and document.get("type") in GEOJSON else None


def _of_geopandas(given: Any, name: str, height: str | None) -> Geometries:
    frame = given
    if hasattr(given, "columns"):
        try:
            given = given.geometry
        except AttributeError:
            raise KindError(
                f"{name} is a GeoDataFrame without a column of geometries: set_geometry names one"
            ) from None
    found = Geometries(np.asarray(given, dtype=object), given.crs, getattr(given.crs, "is_geographic", False))
    if hasattr(frame, "columns"):
        _raise(found, frame, height)
    return found


def _raise(found: Geometries, frame: Any, height: str | None) -> None:
    """Gives geometries the heights of a column of their frame."""
    numbers = {}
    of_numbers = frame.select_dtypes("number").columns
    for at, label in enumerate(frame.columns):
        name, values = str(label), frame.iloc[:, at]
        if (name == height) if height is not None else _native.named_height([name]) is not None:
            # Databases and files of text have numbers as objects.
            doubles = as_values(values, len(frame), name) if label in of_numbers else np.array([*map(_number, values)])
            if np.isfinite(doubles).any():
                numbers[name] = doubles
    if (column := _height(numbers, height)) is not None:
        found.heights, found.height_name = numbers[column], column


def _height(numbers: dict[str, Any], asked: str | None) -> str | None:
    """The name of the property or column that is a height, as files have them."""
    if asked is not None:
        return asked if asked in numbers else None
    names = list(numbers)
    place = _native.named_height(names)
    return None if place is None else names[place]


def _of_document(document: dict[str, Any], name: str, height: str | None) -> Geometries:
    import shapely.geometry

    try:
        features = document["features"] if document["type"] == "FeatureCollection" else [document]
        geometries = [feature["geometry"] if feature["type"] == "Feature" else feature for feature in features]
        found = [None if geometry is None else _shape(geometry) for geometry in geometries]
        of_features = [feature.get("properties") or {} for feature in features]
        numbers = [{str(name): _number(x) for name, x in properties.items()} for properties in of_features]
    except (shapely.errors.ShapelyError, ValueError, TypeError, KeyError, AttributeError, IndexError, RecursionError) as error:
        raise KindError(f"{name} is no right GeoJSON: {type(error).__name__}: {error}") from None
    # RFC 7946 has longitudes and latitudes and no `crs`; programs that are older write one.
    crs = document.get("crs")
    name_of_crs = (crs.get("properties") or {}).get("name") if isinstance(crs, dict) else None
    known = [{column: x for column, x in of.items() if math.isfinite(x)} for of in numbers]
    names = [_height(of_feature, height) for of_feature in known]
    heights = np.array([np.nan if column is None else of[column] for column, of in zip(names, known)])
    first = next((column for column in names if column is not None), None)
    is_on_globe = crs is None or isinstance(name_of_crs, str) and _native.is_of_degrees(name_of_crs)
    measures = sum(max(len(p) - 3, 0) for g in geometries if g is not None for p in _positions(g))
    return Geometries(_array(found), name_of_crs, is_on_globe, None if first is None else heights, first or HEIGHT, measures)


def _shape(geometry: dict[str, Any]) -> Any:
    """A geometry of a document. A height that some positions lack, or that is null, is missing."""
    import shapely.geometry

    if geometry["type"] == "GeometryCollection":
        return shapely.GeometryCollection([_shape(inner) for inner in geometry["geometries"]])
    positions = list(_positions(geometry))
    width = max((len(position) for position in positions), default=0)
    if width > 3 or any(len(position) != width or position[-1] is None for position in positions):
        geometry = {**geometry, "coordinates": _padded(geometry["coordinates"])}
    return shapely.geometry.shape(geometry)


def _positions(given: Any) -> Iterator[Any]:
    """The positions of a geometry of a document."""
    if isinstance(given, dict):
        given = given["geometries"] if given["type"] == "GeometryCollection" else given["coordinates"]
    if isinstance(given, (list, tuple)) and given and isinstance(given[0], (list, tuple, dict)):
        for inner in given:
            yield from _positions(inner)
    elif not isinstance(given, (list, tuple)) or given:
        yield given


def _padded(given: Any) -> Any:
    """Lists of positions of three numbers each."""
    if not given or isinstance(given[0], (list, tuple)):
        return [_padded(inner) for inner in given]
    z = given[2] if len(given) > 2 else None
    return [*given[:2], math.nan if z is None else z]


def _number(value: Any) -> float:
    """A property that is a number, or a text with one; NaN of others."""
    try:
        return math.nan if isinstance(value, bool) else float(value)
    except (TypeError, ValueError, OverflowError):
        return math.nan


def _of_shape(given: Any) -> Geometries:
    """One geometry, which may have the number of a coordinate system."""
    import shapely

    srid = int(shapely.get_srid(given))
    crs = f"EPSG:{srid}" if srid > 0 else None
    return Geometries(_array([given]), crs, crs is not None and _native.is_of_degrees(crs))


def _of_members(members: Iterable[Any], name: str, height: str | None) -> Geometries:
    """The geometries of each member, which is one or has some."""
    found = []
    for position, member in enumerate(members):
        if _is_none(member):
            inner: Geometries | None = Geometries(_array([None]))
        else:
            inner = as_geometries(member, f"{name}[{position}]", height)
        if inner is None and _is_table(member):
            inner = _of_table(member, f"{name}[{position}]", height)
        if inner is None:
            raise KindError(
                f"{name}[{position}] is no geometry but of the type {type(member).__name__}", position=(position,)
            )
        found.append(inner)
    known = [one.crs for one in found if one.crs is not None]
    for crs in known:
        agree(known[0], crs, name)
    raised = [one.height_name for one in found if one.heights is not None]
    heights = [np.full(len(one.features), np.nan) if one.heights is None else one.heights for one in found]
    return Geometries(
        np.concatenate([one.features for one in found]),
        known[0] if known else None,
        any(one.is_on_globe for one in found),
        np.concatenate(heights) if raised else None,
        raised[0] if raised else HEIGHT,
        sum(one.measures for one in found),
    )


def _of_table(given: Any, name: str, height: str | None) -> Geometries:
    """Points of an array or a frame, each a geometry, with their heights."""
    import shapely

    places, z = by_names(given, height)
    if z is None and len(places.shape) == 2 and places.shape[1] == 3:
        places, z = picked(places, [0, 1]), picked(places, [2])
    points = as_points(places, name)
    if not isinstance(points, np.ndarray):
        raise KindError(f"{name} has exact coordinates, and geometries have doubles")
    if z is not None:
        points = np.column_stack([points, as_values(z, len(points), name).reshape(-1)])
    return Geometries(shapely.points(points))


def agree(one: Any, other: Any, name: str) -> None:
    """Refuses coordinates of two systems."""
    if one is not None and other is not None and _number_of(one) != _number_of(other):
        raise Error(f"{name} has two coordinate systems, {_named(one)} and {_named(other)}: to_crs makes them one")


def _number_of(crs: Any) -> Any:
    """The number of the EPSG in a name, or what is no such name as it is."""
    return crs.rpartition(":")[2] if isinstance(crs, str) and "EPSG:" in crs else crs


def _named(crs: Any) -> str:
    return str(getattr(crs, "srs", crs))


def _array(geometries: list[Any]) -> np.ndarray:
    array = np.empty(len(geometries), dtype=object)
    array[:] = geometries
    return array


def parts_of(given: Geometries) -> tuple[np.ndarray, np.ndarray]:
    """The points, lines and polygons that the features are made of, and the feature of each."""
    import shapely

    of = np.flatnonzero([g is not None for g in given.features])
    parts = given.features[of]
    # Collections may hold collections.
    while any(g.geom_type in COLLECTIONS for g in parts):
        parts, inner = shapely.get_parts(parts, return_index=True)
        of = of[inner]
    return parts, of


def as_places(given: Geometries, name: str) -> np.ndarray:
    """Points as coordinates, NaN where there is none."""
    import shapely

    places = np.full((len(given.features), 2), np.nan)
    for position, geometry in enumerate(given.features):
        if geometry is not None and geometry.geom_type != "Point":
            raise KindError(f"{name}[{position}] is no point but a {geometry.geom_type}", position=(position,))
    found, of = shapely.get_coordinates(given.features, return_index=True)
    places[of] = found
    return places


def rings_of(given: Geometries, name: str) -> tuple[list[list[np.ndarray]], list[int]]:
    """The rings of each polygon, of x, y and z, without the first place again at the end; and the feature of each."""
    import shapely

    parts, of = parts_of(given)
    if any(g.geom_type != "Polygon" for g in parts):
        raise KindError(f"{name} has geometries that are no polygons: pass these with the points")
    rings = [[polygon.exterior, *polygon.interiors] for polygon in parts]
    return [[shapely.get_coordinates(r, include_z=True)[:-1] for r in polygon] for polygon in rings], of.tolist()


def of_geometries(given: Geometries, asked: str | None = None) -> Input:
    """The input of geometries: points, lines as edges, polygons with their holes. Equal positions are one vertex.
    Heights that were asked for win, and those of areas have to be."""
    import shapely

    parts, of = parts_of(given)
    kinds = np.array([g.geom_type for g in parts], dtype=object)
    is_polygon, is_point = kinds == "Polygon", kinds == "Point"
    is_line = ~(is_polygon | is_point)
    rings, ring_polygon = shapely.get_rings(parts[is_polygon], return_index=True)
    # The part of each chain of coordinates: points, then lines, then rings.
    chains = np.concatenate([parts[is_point], parts[is_line], rings])
    chain_feature = np.concatenate([of[is_point], of[is_line], of[is_polygon][ring_polygon]])
    places, chain = shapely.get_coordinates(chains, include_z=True, return_index=True)
    step = np.flatnonzero(chain[1:] == chain[:-1])
    edge_ring = np.maximum(chain[step] - (len(chains) - len(rings)), -1)
    is_hole = np.r_[False, ring_polygon[1:] == ring_polygon[:-1]][: len(ring_polygon)]
    points, first, vertex = _distinct(places[:, :2])
    measures = shapely.get_num_coordinates(parts[shapely.has_m(parts)]).sum() if hasattr(shapely, "has_m") else 0
    heights, remarks = None, _native.ignored(int(measures) + given.measures, "measure", "measures")
    z, count = places[:, 2], 0
    if given.heights is not None:
        # Of points and lines that have none: the height of a building is not that of its ground.
        height = given.heights[chain_feature[chain]]
        is_free = np.isnan(z) & (chain < len(chains) - len(rings))
        is_raised = ~np.isnan(height) & (is_free | (asked is not None))
        is_lost = ~np.isnan(height) & (chain < len(chains) - len(rings)) & ~is_raised & (z != height)
        lost = len(np.unique(chain_feature[chain[is_lost]]))
        remarks += _native.ignored(lost, f"property `{given.height_name}`", f"properties `{given.height_name}`")
        z, count = np.where(is_raised, height, z), len(np.unique(chain_feature[chain[is_raised]]))
        remarks += _native.height_property(given.height_name, count) if count else []
    elif asked is not None:
        remarks += _native.height_property(asked, 0)
    if count or shapely.has_z(parts).any():
        heights, conflicts = gathered(z, vertex, len(points), HEIGHT)
        remarks += conflicts
    edges = np.ascontiguousarray(vertex[np.stack([step, step + 1], axis=1)].reshape(-1, 2), dtype=np.uintp)
    if given.is_on_globe:
        remarks += _native.half_of_the_globe(points, edges)
    return Input(
        points,
        edges,
        list(zip(ring_polygon.tolist(), is_hole.tolist())),
        edge_ring.astype(np.int64),
        features=of[is_polygon].tolist(),
        heights=heights,
        crs=given.crs,
        feature_of=(chain_feature[chain[first]], chain_feature[chain[step]]),
        remarks=remarks,
    )


def gathered(values: np.ndarray, vertices: np.ndarray, count: int, name: str) -> tuple[np.ndarray, list[Remark]]:
    """The value of each of so many vertices: the first that one of its places has. And the remark on other ones."""
    vertices = np.ascontiguousarray(vertices, dtype=np.uintp)
    return _native.gathered(np.ascontiguousarray(values), vertices, count, name)


def _distinct(places: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The distinct ones in the order in which they come, where each comes first, and for each place its number."""
    _, first, inverse = np.unique(places + 0.0, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return np.ascontiguousarray(places[first[order]]), first[order], rank[inverse.ravel()]
