"""Results of other libraries: their triangles, their points if they have any, and the input that they tell.

An object is known by what it has, so that no library is imported here.
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ._arrays import as_array
from ._errors import KindError, ShapeError
from ._geometries import Geometries, as_geometries, parts_of
from ._graph import as_input, first_column
from ._input import Input, as_edges, as_indices, as_points
from ._triangulation import Triangulation


@dataclasses.dataclass
class Result:
    """Triangles of some program."""

    # The corners, as positions in `points`, or in the input where there are none.
    triangles: np.ndarray
    # The points of the result; `None` without any.
    points: Any = None
    # Whether the triangles are given by coordinates: their corners have no numbers.
    is_soup: bool = False
    # What the result says of its input: the input, and the rule for what is inside.
    own: Input | None = None
    rule: str | None = None
    # The attribute of each triangle.
    attributes: list[float] | None = None


def as_result(given: Any) -> Result | None:
    """The result that an object is; `None`, if it is none that is known."""
    if isinstance(given, Triangulation):
        triangles = as_indices(given.triangles, 3, "triangles")
        return Result(triangles, given._input.points, own=given._input, rule=given.rule)
    if isinstance(given, dict) and "triangles" in given:
        return _of_dictionary(given)
    if all(hasattr(given, name) for name in ("simplices", "points", "neighbors")):
        return _of_arrays(given.points, given.simplices)
    if hasattr(given, "get_masked_triangles"):
        points = np.column_stack([given.x, given.y])
        return _of_arrays(points, given.get_masked_triangles())
    if all(hasattr(given, name) for name in ("points", "cells_dict")):
        cells = given.cells_dict
        # pyvista names kinds of cells by VTK's numbers: 3 are lines, 5 triangles.
        kinds = ((5, "triangle"), (3, "line"))
        faces, lines = (next((cells[kind] for kind in names if kind in cells), None) for names in kinds)
        return _of_arrays(_flat(given.points), faces, lines)
    if all(hasattr(given, name) for name in ("points", "faces", "lines")):
        return _of_arrays(_flat(given.points), _cells(given.faces, 3, "faces"), _cells(given.lines, 2, "lines"))
    if (geometries := as_geometries(given)) is not None:
        return _of_geometries(geometries)
    return None


def _of_arrays(points: Any, triangles: Any, lines: Any = None) -> Result:
    own = Input(as_points(points), as_edges(lines, "lines"))
    return Result(as_indices(triangles, 3, "triangles"), own.points, own=own)


def _flat(points: Any) -> np.ndarray:
    """Points of a mesh without their heights."""
    points = as_array(points, "points")
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ShapeError(f"the points of the mesh have the shape {points.shape}", shape=points.shape)
    return points[:, :2]


def _of_dictionary(given: dict[str, Any]) -> Result:
    """A dictionary of `triangle`: what its segments enclose without the holes, if it has segments."""
    triangles = as_indices(given["triangles"], 3, "triangles")
    attributes = None
    if (of_triangles := given.get("triangle_attributes")) is not None:
        first = first_column(of_triangles, len(triangles), "triangle_attributes")
        attributes = [] if first is None else first.tolist()
    if "vertices" not in given:
        return Result(triangles, attributes=attributes)
    own = as_input(given)
    return Result(triangles, own.points, own=own, rule="holes" if len(own.edges) else "hull", attributes=attributes)


def _cells(cells: Any, size: int, name: str) -> np.ndarray | None:
    """Cells of VTK: their size before each, one after the other."""
    flat = as_array(cells, name)
    if size == 2:
        # Lines may be longer: their steps count.
        steps, at = [], 0
        while at < len(flat):
            line = flat[at + 1 : at + 1 + flat[at]]
            steps.append(np.stack([line[:-1], line[1:]], axis=1))
            at += 1 + int(flat[at])
        return np.concatenate(steps) if steps else None
    if flat.size % (size + 1) or (flat[:: size + 1] != size).any():
        raise ShapeError(f"the {name} of the mesh are not all triangles")
    return flat.reshape(-1, size + 1)[:, 1:]


def _of_geometries(geometries: Geometries) -> Result:
    """Triangles as polygons of shapely."""
    import shapely

    parts, _ = parts_of(geometries)
    kinds = {g.geom_type for g in parts}
    if kinds - {"Polygon"}:
        raise KindError(f"the result has geometries that are no polygons: {', '.join(sorted(kinds - {'Polygon'}))}")
    corners = shapely.get_num_coordinates(parts)
    if (corners != 4).any():
        triangle = int(np.argmax(corners != 4))
        raise ShapeError(f"polygon {triangle} of the result is no triangle", position=triangle)
    points = shapely.get_coordinates(parts).reshape(-1, 4, 2)[:, :3].reshape(-1, 2)
    triangles = np.arange(len(points), dtype=np.uintp).reshape(-1, 3)
    return Result(triangles, np.ascontiguousarray(points), is_soup=True)
