"""Meshes of good angles: a method of `Triangulation`. The crate refines, and the engine carries what goes along."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native
from ._arrays import as_values
from ._errors import Error, ShapeError
from ._input import Input, as_count, called
from ._remarks import told

if TYPE_CHECKING:
    from ._triangulation import Triangulation

LEFT = np.dtype([("triangle", "i8"), ("bound", "U16"), ("reason", "U64")])


def as_bounds(min_angle: Any, max_area: Any, max_side: Any) -> dict[str, float | None]:
    """Bounds as Rust takes them."""
    given = {"min_angle": min_angle, "max_area": max_area, "max_side": max_side}
    try:
        return {name: None if bound is None else float(bound) for name, bound in given.items()}
    except (TypeError, ValueError, OverflowError):
        raise Error("min_angle, max_area and max_side are numbers") from None


def refine(
    self: Triangulation,
    min_angle: float | None = None,
    max_area: float | Callable[[float, float], float] | None = None,
    max_side: float | None = None,
    *,
    region_areas: Any = None,
    max_points: int | None = None,
    keep_boundary: bool = False,
    progress: Callable[[int, int], object] | None = None,
    strict: bool = False,
) -> Triangulation:
    """Adds points until no triangle inside breaks a bound.

    Bounds are decided by exact signs. Points keep their numbers, and new ones follow them. Edges are split into parts,
    which keep what belongs to their edge; heights of new points are linear along edges and in triangles.

    Parameters
    ----------
    min_angle : float, optional
        The least angle in degrees, below 60. Above 34 degrees it need not end: give `max_points`. Without any bound it
        is 20 degrees.
    max_area : float, or a function of x and y, optional
        The greatest area of a triangle, in the square of the units of the points. A function gives that for triangles
        with their centroid at (x, y); where it is not above 0, no area is too great.
    max_side : float, optional
        The greatest length of a side, in the units of the points.
    region_areas : array_like of shape (k,), optional
        The greatest area in each region, by the numbers of `region`; NaN or missing where there is none. They count in
        place of those that the ``regions`` of a dictionary have, which else count by themselves.
    max_points : int, optional
        Ends with so many points.
    keep_boundary : bool, optional
        Whether the sides between inside and outside stay whole.
    progress : callable, optional
        Called after each round, with how many points there are, and how many triangles wait. What it raises ends the
        call.
    strict : bool, optional
        Whether it is an error if a triangle breaks a bound still. Otherwise a `RemarkWarning` says so.

    Returns
    -------
    Triangulation
        Of all points, and of the parts as edges. `added_from`, `edge_of` and `left` say what is new, of which edge each
        part is, and what could not be better. The `rule` is ``holes`` where the hull was refined: sides of the hull are
        edges then, since rounding may put new points beside them.

    Raises
    ------
    Error
        If an angle, area or side is no bound; `RemarkError` with `strict`.

    Examples
    --------
    >>> import sweep_cdt
    >>> plate = sweep_cdt.triangulate([], polygons=[[[[0, 0], [9, 0], [9, 1], [0, 6]]]])
    >>> mesh = plate.refine(min_angle=28, max_area=2)
    >>> bool(sweep_cdt.verify(mesh, min_angle=28, max_area=2)), mesh.added_from, len(mesh.left)
    (True, 4, 0)
    >>> bool((mesh.edge_chain(1) == mesh.edges[mesh.edge_of == 1, 0].tolist() + [2]).all())
    True
    """
    given = self._input.changed(heights=self.heights)
    how: dict[str, Any] = {
        "bounds": as_bounds(min_angle, None if callable(max_area) else max_area, max_side),
        "region_areas": [] if region_areas is None else _areas(self, as_values(region_areas, None, "region_areas")),
        "area_at": max_area if callable(max_area) else None,
        "most_points": None if max_points is None else as_count(max_points, "max_points"),
        "keep_boundary": bool(keep_boundary),
        "progress": progress,
    }
    points, edges, parts, seeds, heights, left, remarks = called(_native.refine, given, self._core, self.rule, how)
    parts = parts.view(np.intp)
    mesh = given.changed(
        points=points,
        regions=seeds,
        heights=heights,
        remarks=remarks,
        **given.of_pieces(edges, parts),
    )
    rule = "holes" if self.rule in ("hull", "hull-without-holes") else self.rule
    return told(refined(mesh, rule, (len(given.points), self.edge_of[parts], self._edge_count, left)), strict)


def refined(mesh: Input, rule: str, history: tuple[Any, ...]) -> Triangulation:
    """The triangulation of a mesh that was refined."""
    from ._triangulation import made

    result = made(mesh, rule, False, None, None)
    result._refined = history
    return result


def records(result: Triangulation, left: list[tuple[list[int], str, str]]) -> np.ndarray:
    """Triangles that break a bound still, by their positions in `triangles`."""
    turned = [np.roll(corners, -int(np.argmin(corners))) for corners in result.triangles] if left else []
    places = {tuple(corners.tolist()): place for place, corners in enumerate(turned)}
    listed = [(places[tuple(corners)], bound, reason) for corners, bound, reason in left]
    return np.array(sorted(listed), dtype=LEFT)


def _areas(self: Triangulation, areas: np.ndarray) -> list[tuple[int, float]]:
    """The greatest areas of regions or features, by their numbers."""
    given = self._input
    if self.region is None:
        raise ShapeError(f"there are no regions by the rule {self.rule} (region_areas)", shape=areas.shape)
    numbers: Sequence[int] = range(len(given.regions))
    if self.rule == "polygons":
        numbers = given.features or [polygon for polygon, _ in given.rings]
    # A feature without polygons may have a number, too.
    count = 1 + max(numbers, default=-1)
    most = max(count, *(1 + of.max(initial=-1) for of in given.feature_of or ()), 0)
    if areas.ndim != 1 or not count <= len(areas) <= most:
        wanted = f"it is a number for each region, of which there are {count}"
        raise ShapeError(f"region_areas has the shape {areas.shape}: {wanted}", shape=areas.shape)
    return [(number, areas[number]) for number in sorted(set(numbers)) if not np.isnan(areas[number])]
