"""`verify`: is it a constrained Delaunay triangulation?"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from . import _native
from ._errors import Error, KindError, check_distance
from ._foreign import Result, as_result
from ._graph import as_input
from ._input import Input, as_count, as_indices, called
from ._refine import as_bounds
from ._remarks import say
from ._report import Report
from ._triangulation import made

T = TypeVar("T")


@dataclasses.dataclass
class Question:
    """What is verified, and what is asked of it."""

    given: Input
    triangles: np.ndarray
    rule: str
    level: str
    max_depth: float | None
    # How many points are the input's own, if others may be added.
    added_from: int | None
    limit: int
    attributes: list[float] | None
    threads: int
    # The bounds on triangles.
    bounds: dict[str, float | None]
    # How vertices were matched, in words.
    matched: str
    # Whether the input is what the result tells, and whether nothing but the bounds is asked.
    is_alone: bool
    only_bounds: bool

    def ask(self, function: Callable[..., T], *arguments: Any) -> T:
        """Calls a function in Rust with the question."""
        has_regions = self.attributes is not None and self.given.attributes
        asked = {
            "rule": self.rule,
            "level": self.level,
            "max_depth": self.max_depth,
            "added_from": self.added_from,
            "limit": self.limit,
            "attributes": self.attributes if has_regions else None,
            "threads": self.threads,
            "bounds": self.bounds,
            "is_alone": self.is_alone,
            "only_bounds": self.only_bounds,
        }
        return called(function, self.given, self.triangles, asked, *arguments)


def verify(
    result_or_points: Any,
    simplices: Any = None,
    edges: Any = None,
    *,
    polygons: Any = None,
    holes: Any = None,
    domain: str | None = None,
    level: str = "delaunay",
    max_depth: float | None = None,
    min_angle: float | None = None,
    max_area: float | None = None,
    max_side: float | None = None,
    tolerance: float | None = None,
    by_number: bool = False,
    steiner: bool = False,
    limit: int = 1000,
    threads: int | None = None,
    strict: bool = False,
) -> Report:
    """Proves by exact arithmetic that triangles are a constrained Delaunay triangulation, or says what is wrong.

    In a right one the triangles tile the convex hull of the points (or what is inside, by `domain`), every point there
    is a corner, every edge there is a side or a chain of sides, and every other side is locally Delaunay.

    Parameters
    ----------
    result_or_points
        A result alone: of this package, a `scipy.spatial.Delaunay`, a `matplotlib.tri.Triangulation`, what
        `triangle.triangulate` returns, a `meshio.Mesh`, a `pyvista.PolyData`, or triangles of shapely. The result is
        judged by its own points, and by its own edges where it has some. With bounds, and nothing else that is asked,
        it is judged by these alone, as the command judges a file by itself, but a result of this package and a
        dictionary of `triangle`, which tell their domain. Or the points that the result was made of, or an object that
        says more, all as of `triangulate`.
    simplices : array_like of int of shape (t, 3) or (3 t,), or a result, optional
        The corners of the triangles, from 0; or any of the results above, whose vertices are then matched with the
        points: exactly and in any order, or rounded to single precision or to as many significant digits as they have.
    edges, polygons, holes, strict : optional
        As of `triangulate`.
    domain : str, optional
        What the triangles must tile, as `inside` of `triangulate`. The default is that of a result of this package that
        is given alone; of a dictionary of `triangle` with segments ``holes``, or ``hull-without-holes`` where the hull
        is closed by segments (its option ``c``); and otherwise that of `triangulate`.
    level : {'tiling', 'constrained', 'delaunay', 'canonical'}, optional
        What the triangles must reach. Each level includes those before it.
    max_depth : float, optional
        How deep violations may be that count as rounding: 1e-12 accepts what doubles do.
    min_angle, max_area, max_side : float, optional
        Bounds on each triangle, in degrees and in the units of the points: the least angle, the greatest area, and the
        longest side, decided by exact signs. A triangle that breaks one is a violation: ``small-angle``, ``large-area``
        or ``long-side``.
    tolerance : float, optional
        By how much a coordinate of the result may differ from the input's.
    by_number : bool, optional
        Whether vertices are matched by number, whatever their coordinates.
    steiner : bool, optional
        Whether the result may have vertices that the input lacks. Those on edges are rounded by most programs, so that
        they lie beside them: `max_depth` says how far they may.
    limit : int, optional
        How many violations are listed; all are counted.
    threads : int, optional
        How many threads work, 0 for as many as there are cores. The default is one.

    Returns
    -------
    Report
        True if the triangles are right, and false if not; it says what is wrong and what to do.

    Raises
    ------
    Error
        If what is given cannot be read; `MatchError`, if a vertex of the result is none of the input;
        `CrossingEdgesError` and others, if the input has no triangulation, with other domains than ``hull``.

    Examples
    --------
    >>> import sweep_cdt
    >>> points = [[0, 0], [4, 0], [5, 3], [0, 3]]
    >>> report = sweep_cdt.verify(points, [[0, 1, 2], [0, 2, 3]])
    >>> bool(report), report.violations["name"].tolist()
    (False, ['not-delaunay'])
    >>> print(report.advice)
    this is a constrained triangulation, but not Delaunay: level="constrained" accepts it
    >>> bool(sweep_cdt.verify(points, [[0, 1, 3], [1, 2, 3]]))
    True
    """
    check_distance("max_depth", max_depth)
    check_distance("tolerance", tolerance)
    if simplices is None:
        result = as_result(result_or_points)
        if result is None:
            raise KindError("this is no triangulation that is known: pass its triangles as the second argument")
        given, matched = _own(result, edges, polygons, holes)
    else:
        given = as_input(result_or_points, edges, polygons, holes)
        if isinstance(simplices, dict) and "vertices" in simplices:
            # `triangle` leaves out the triangles where there are none: a hole takes all.
            simplices = {"triangles": [], **simplices}
        result = as_result(simplices)
        if result is None:
            result = Result(as_indices(simplices, 3, "simplices"))
        matched = None
    added_from = None
    if matched is None:
        given, result, matched, added_from = _matched(given, result, tolerance, by_number, steiner)
    say(given.remarks, strict)
    bounds = as_bounds(min_angle, max_area, max_side)
    # A mesh that tells nothing of its input is judged as the command judges a file by itself.
    says_nothing = simplices is None and result.rule is None
    is_asked_more = any(asked is not None for asked in (domain, edges, polygons, holes, max_depth))
    only_bounds = says_nothing and not is_asked_more and any(bound is not None for bound in bounds.values())
    rule = given.rule(_rule_of_result(result, given, simplices is None) if domain is None else domain)
    question = Question(
        given,
        result.triangles,
        rule,
        level,
        max_depth,
        added_from,
        as_count(limit, "limit"),
        result.attributes,
        as_count(1 if threads is None else threads, "threads"),
        bounds,
        matched,
        simplices is None,
        only_bounds,
    )
    answer = question.ask(_native.verify)
    say(answer["remarks"], strict)
    return Report(question, answer)


def _rule_of_result(result: Result, given: Input, is_alone: bool) -> str | None:
    """The rule that a result tells, if it tells one."""
    if is_alone:
        return result.rule
    if result.rule != "holes" or result.own is None or result.own.rings or not len(given.edges):
        return None
    # A dictionary of `triangle`: with its option `c` the sides of the hull are segments, too.
    try:
        whole = made(result.own, "hull", False, None, None)
    except Error:
        return "holes"
    is_closed = whole.constrained[whole.neighbors < 0].all()
    return "hull-without-holes" if is_closed else "holes"


def _own(result: Result, edges: Any, polygons: Any, holes: Any) -> tuple[Input, str]:
    """The input that a result tells."""
    words = "the points are those of the result"
    if result.own is not None:
        given = result.own
        if edges is not None or polygons is not None or holes is not None:
            given = as_input(given.points, given.edges if edges is None else edges, polygons, holes)
        return given, words
    if result.points is None:
        raise KindError("the result has no points: pass the points first, and then the result")
    # The corners of triangles that are given by coordinates; zeros of both signs are equal.
    _, first, number = np.unique(result.points + 0.0, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    given = as_input(result.points[first[order]], edges, polygons, holes)
    result.triangles = np.argsort(order)[number].reshape(-1, 3).astype(np.uintp)
    return given, words


def _matched(
    given: Input, result: Result, tolerance: float | None, by_number: bool, steiner: bool
) -> tuple[Input, Result, str, int | None]:
    """The input, the result by its points, how they were matched, and where added points begin."""
    count = len(given.points)
    if result.points is None:
        words = "vertices matched by number: the result has no coordinates"
        return given, result, words, count if steiner else None
    if by_number and result.is_soup:
        raise KindError("the triangles of the result are coordinates: their vertices have no numbers (by_number)")
    asked = {"is_soup": result.is_soup, "tolerance": tolerance, "by_number": by_number, "steiner": steiner}
    matched = _native.match_vertices(result.points, given.points, asked)
    if steiner:
        given = given.changed(points=matched["points"])
    if matched["places"] is not None:
        result.triangles = _renumbered(result.triangles, matched["places"], len(given.points))
    return given, result, matched["words"], count if steiner else None


def _renumbered(triangles: np.ndarray, places: np.ndarray, count: int) -> np.ndarray:
    """Corners by their places; those that are no vertices stay out of range."""
    known = triangles < len(places)
    corners = np.where(known, triangles, 0)
    if not len(places):
        return np.full_like(triangles, count)
    return np.ascontiguousarray(np.where(known, places[corners].astype(np.uintp), np.uintp(count)))


def assert_valid(
    result_or_points: Any, simplices: Any = None, edges: Any = None, **options: Any
) -> Report:
    """Fails a test if `verify` says no; takes the same arguments.

    Raises
    ------
    AssertionError
        The report in words, and as the attribute ``report``.

    Examples
    --------
    >>> import sweep_cdt
    >>> points = [[0, 0], [4, 0], [4, 3], [0, 3]]
    >>> report = sweep_cdt.assert_valid(points, [[0, 1, 3], [1, 2, 3]])
    """
    __tracebackhide__ = True
    report = verify(result_or_points, simplices, edges, **options)
    if not report:
        error = AssertionError(str(report))
        error.report = report  # type: ignore[attr-defined]
        raise error
    return report
