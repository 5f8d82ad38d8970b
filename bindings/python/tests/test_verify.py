"""`verify`: of arrays, of results by coordinates, and its report."""

import re
import types
from fractions import Fraction

import numpy as np
import pytest

import sweep_cdt

SQUARE = np.array([[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 3.0]])
RIGHT = [[0, 1, 3], [1, 2, 3]]
WRONG = [[0, 1, 2], [0, 2, 3]]


def random_result(count=500, seed=7):
    points = np.random.default_rng(seed).random((count, 2))
    return points, sweep_cdt.triangulate(points)


def test_a_right_one():
    points, result = random_result()
    report = sweep_cdt.verify(points, result.simplices)
    assert report and report.verdict == "correct" and report.is_canonical and report.reached == "canonical"
    assert report.counts["triangles"] == len(result.simplices) and report.found == 0
    assert len(report.violations) == 0 and report.advice == "correct: nothing to do"
    assert sweep_cdt.verify(result) and sweep_cdt.verify(points, result)


def test_both_diagonals():
    assert sweep_cdt.verify(SQUARE, RIGHT)
    report = sweep_cdt.verify(SQUARE, WRONG)
    assert not report and report.reached == "constrained"
    (record,) = report.violations
    assert record["name"] == "not-delaunay" and record["depth"] > 0.1
    assert sorted(record["vertices"]) == [0, 1, 2, 3] and sorted(record["triangles"]) == [0, 1]
    assert sweep_cdt.verify(SQUARE, WRONG, level="constrained")
    assert sweep_cdt.verify(SQUARE, WRONG, [[0, 2]])
    missing = sweep_cdt.verify(SQUARE, RIGHT, [[0, 2]])
    assert missing.violations["name"].tolist() == ["missing-edge"] and missing.violations["edge"].tolist() == [0]
    assert "edge 0 is missing" in missing.advice and 'level="tiling"' in missing.advice


def test_seeds_in_doubles_beside_a_result_in_fractions():
    given = {"vertices": SQUARE, "segments": [[0, 1], [1, 2], [2, 3], [3, 0]], "holes": np.empty((0, 2))}
    middle = [Fraction(2), Fraction(1)]
    corners = [[Fraction(x) for x in p] for p in SQUARE.tolist()]
    triangles = sweep_cdt.triangulate([*corners, middle]).simplices
    result = {"vertices": [*corners, middle], "triangles": triangles}
    assert sweep_cdt.verify(given, result, steiner=True, domain="holes")
    assert not sweep_cdt.verify({**given, "holes": [[2.0, 2.0]]}, result, steiner=True)


def test_clockwise_triangles_are_judged_as_they_are():
    report = sweep_cdt.verify(SQUARE, [t[::-1] for t in RIGHT])
    assert report and report.is_clockwise and "run clockwise" in report.advice
    mixed = sweep_cdt.verify(SQUARE, [RIGHT[0], RIGHT[1][::-1]])
    assert not mixed and "runs the other way round" in mixed.advice


def test_rounding_is_told_from_what_is_wrong():
    points = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0 - 1e-15], [0.0, 1.0]])
    report = sweep_cdt.verify(points, RIGHT)
    assert not report and report.deepest < 1e-14
    assert report.advice.endswith("max_depth=1e-12 accepts it")
    allowed = sweep_cdt.verify(points, RIGHT, max_depth=1e-12)
    assert allowed and allowed.verdict == "within-max-depth" and "nothing to do" in allowed.advice
    assert not sweep_cdt.verify(points, RIGHT, max_depth=1e-16)
    for depth in (-1, np.nan, np.inf):
        with pytest.raises(sweep_cdt.Error, match="max_depth"):
            sweep_cdt.verify(points, RIGHT, max_depth=depth)


def test_exact_points():
    third = Fraction(1, 3)
    points = [[0, 0], [1, 0], [1, 1], [0, 1], [third, third]]
    result = sweep_cdt.triangulate(points, [[0, 2]])
    assert sweep_cdt.verify(points, result.simplices, [[0, 2]])
    assert sweep_cdt.verify(points, result, [[0, 2]]) and sweep_cdt.verify(result)
    # As doubles the last one is beside the diagonal.
    tiny = Fraction(1, 10**40)
    moved = [*points[:4], [third + tiny, third]]
    assert not sweep_cdt.verify(moved, result.simplices, [[0, 2]])


def test_exact_vertices_are_matched_exactly():
    third = Fraction(1, 3)
    points = [[0, 0], [third, 0], [0, third]]
    result = sweep_cdt.triangulate([points[2], points[0], points[1]])
    report = sweep_cdt.verify(points, result)
    assert report and report.matched == "vertices matched by coordinates: greatest difference 0"
    # Rounded to doubles, the vertices are the same.
    tiny = Fraction(1, 10**40)
    moved = sweep_cdt.triangulate([points[0], points[1], [tiny, third]])
    with pytest.raises(sweep_cdt.MatchError, match="vertex 2 of the result") as caught:
        sweep_cdt.verify(points, moved)
    assert caught.value.vertex == 2 and caught.value.at == (1e-40, 1 / 3)
    assert sweep_cdt.verify(points, moved, by_number=True).matched.startswith("vertices matched by number, as was asked for")
    assert sweep_cdt.verify(points, moved, tolerance=1e-9)


def test_corners_that_are_counted_from_1():
    report = sweep_cdt.verify(SQUARE, np.array(RIGHT) + 1)
    assert not report and "subtract 1 from each" in report.advice


def test_corners_that_are_no_points():
    report = sweep_cdt.verify(SQUARE, [[0, 1, 9], [-1, 2, 3]])
    assert not report and report.violations["name"][0] == "triangle-out-of-range"
    assert report.violations["vertices"][1].tolist() == [-1, -1, -1, -1]
    assert "no vertices of the input" in report.advice


def test_points_that_are_left_out():
    points, result = random_result()
    twice = np.concatenate([points, [[0.5, 0.5]]])
    report = sweep_cdt.verify(twice, result.simplices)
    assert not report and "vertex 500 of the input, at (0.5, 0.5), is used by no triangle" in report.advice


def test_no_triangles():
    assert sweep_cdt.verify([[0, 0], [1, 1]], [])
    report = sweep_cdt.verify(SQUARE, [])
    assert not report and report.advice.startswith("the result has no triangles")


def test_flat_lists_of_corners():
    assert sweep_cdt.verify(SQUARE, np.array(RIGHT).ravel())
    with pytest.raises(sweep_cdt.ShapeError):
        sweep_cdt.verify(SQUARE, [0, 1])
    with pytest.raises(sweep_cdt.KindError):
        sweep_cdt.verify(SQUARE, [[0.0, 1.0, 3.0]])
    with pytest.raises(sweep_cdt.KindError, match="second argument"):
        sweep_cdt.verify(SQUARE)


def test_domains():
    outline, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[3, 3], [6, 3], [6, 6], [3, 6]]
    result = sweep_cdt.triangulate([], polygons=[[outline, hole]])
    assert sweep_cdt.verify(result) and sweep_cdt.verify(result).domain == "polygons"
    points, edges = result.points, result.edges
    assert sweep_cdt.verify(points, result.triangles, edges, domain="even-odd")
    assert sweep_cdt.verify(points, result.triangles, edges, holes=[[4, 5]])
    report = sweep_cdt.verify(points, result.triangles, edges)
    assert not report and report.advice == 'this is a right triangulation of the interior: domain="even-odd"'
    assert sweep_cdt.verify(points, result.simplices, edges)
    assert not sweep_cdt.verify(points, result.simplices, edges, domain="even-odd")
    with pytest.raises(sweep_cdt.CrossingEdgesError):
        sweep_cdt.verify(points, result.triangles, [[0, 2], [1, 3]], domain="even-odd")
    crossing = sweep_cdt.verify(points, result.triangles, [[0, 2], [1, 3]])
    assert "edges 0 and 1 cross" in crossing.advice


def as_dictionary(points, result):
    return {"vertices": points, "triangles": result.simplices}


def test_vertices_in_another_order_are_matched():
    points, result = random_result()
    order = np.random.default_rng(1).permutation(len(points))
    shuffled = {"vertices": points[order], "triangles": np.argsort(order)[result.simplices]}
    report = sweep_cdt.verify(points, shuffled)
    assert report and report.matched == "vertices matched by coordinates: greatest difference 0"
    assert not sweep_cdt.verify(points, shuffled["triangles"])


@pytest.mark.parametrize("shuffle", [False, True])
def test_single_precision(shuffle):
    points, result = random_result()
    order = np.random.default_rng(1).permutation(len(points)) if shuffle else np.arange(len(points))
    vertices = points[order].astype(np.float32)
    for kind in (np.float32, np.float64):
        given = {"vertices": vertices.astype(kind), "triangles": np.argsort(order)[result.simplices]}
        report = sweep_cdt.verify(points, given)
        assert report and ("single" if shuffle else "rounded") in report.matched


def test_points_that_single_precision_does_not_tell_apart():
    points = np.array([[0, 0], [1 + 1e-12, 0], [0, 1], [1 + 2e-12, 0]])
    result = {"vertices": np.array([[1, 0], [0, 1], [0, 0]], dtype=np.float32), "triangles": [[0, 1, 2]]}
    with pytest.raises(sweep_cdt.MatchError, match="vertex 0 of the result .* may be vertex 1 or 3") as caught:
        sweep_cdt.verify(points, result)
    assert caught.value.candidates == (1, 3)


@pytest.mark.parametrize("shuffle", [False, True])
@pytest.mark.parametrize("digits", [6, 9])
def test_printed_digits(shuffle, digits):
    points, result = random_result(60)
    order = np.random.default_rng(1).permutation(len(points)) if shuffle else np.arange(len(points))
    vertices = [[float(f"{x:.{digits}g}") for x in p] for p in points[order]]
    report = sweep_cdt.verify(points, {"vertices": vertices, "triangles": np.argsort(order)[result.simplices]})
    assert report and "rounded" in report.matched


def test_other_vertices_are_refused():
    points, result = random_result(60)
    moved = points.copy()
    moved[7, 0] += 0.0001
    with pytest.raises(sweep_cdt.MatchError, match="vertex 7 of the result") as caught:
        sweep_cdt.verify(points, as_dictionary(moved, result))
    assert caught.value.vertex == 7 and caught.value.nearest == 7
    assert sweep_cdt.verify(points, as_dictionary(moved, result), tolerance=0.001).matched.startswith("vertices")
    assert sweep_cdt.verify(points, as_dictionary(moved, result), by_number=True)
    with pytest.raises(sweep_cdt.MatchError):
        sweep_cdt.verify(points, as_dictionary(moved + 1, result))


def test_a_tolerance_is_offered_up_to_half_of_the_least_distance():
    points, result = random_result(60)
    order = np.random.default_rng(3).permutation(len(points))
    differences = np.abs(points[:, None] - points).max(axis=2)
    least = differences[differences > 0].min()
    for share, is_offered in ((0.3, True), (0.49, True), (0.6, False), (3.0, False)):
        noise = np.random.default_rng(4).choice([-1, 1], points.shape) * share * least
        moved = {"vertices": (points + noise)[order], "triangles": np.argsort(order)[result.simplices]}
        with pytest.raises(sweep_cdt.MatchError, match="none: the nearest is vertex") as caught:
            sweep_cdt.verify(points, moved)
        offered = re.search("tolerance=([^ ]*) accepts it", str(caught.value))
        assert (offered is not None) == is_offered
        if offered:
            tolerance = float(offered[1])
            assert tolerance < least / 2
            assert sweep_cdt.verify(points, moved, tolerance=tolerance)
            # To the last bit.
            exact = max(abs(Fraction(x) - Fraction(y)) for x, y in zip((points + noise).flat, points.flat))
            double = float(exact) if Fraction(float(exact)) >= exact else np.nextafter(float(exact), np.inf)
            assert sweep_cdt.verify(points, moved, tolerance=double)
            with pytest.raises(sweep_cdt.MatchError):
                sweep_cdt.verify(points, moved, tolerance=np.nextafter(double, 0))


def test_added_vertices_of_exact_points():
    side = Fraction(2, 3)
    points = [[0, 0], [side, 0], [side, side], [0, side]]
    result = {"vertices": [*points, [side / 2, side / 2]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]}
    report = sweep_cdt.verify(points, result, [[0, 2]], steiner=True)
    assert report and report.counts["added_points"] == 1
    result["triangles"].pop()
    report = sweep_cdt.verify(points, result, [[0, 2]], steiner=True)
    assert not report and report.advice


def test_added_vertices():
    points = [[0, 0], [2, 0], [2, 2], [0, 2]]
    result = {"vertices": [*points, [1, 1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]}
    report = sweep_cdt.verify(points, result, [[0, 2]], steiner=True)
    assert report and report.counts["added_points"] == 1 and report.counts["split_edges"] == 1
    with pytest.raises(sweep_cdt.MatchError):
        sweep_cdt.verify(points, result, [[0, 2]])


def test_a_mesh_by_itself_is_judged_by_its_bounds():
    l = [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]]
    plate = [[l, [[0.5, 0.5], [1, 0.5], [1, 1]]]]
    mesh = sweep_cdt.triangulate([], polygons=plate).refine(28)
    back = types.SimpleNamespace(points=mesh.points, cells_dict={"triangle": mesh.triangles})
    report = sweep_cdt.verify(back, min_angle=20)
    is_mesh = f"correct: this is a mesh of {len(mesh.triangles)} triangles"
    assert report and report.headline == f"{is_mesh}, within the bounds"
    assert report.reached is None and not report.is_canonical and report.advice == "correct: nothing to do"
    report = sweep_cdt.verify(back, max_area=0.01)
    assert not report and set(report.violations["name"]) == {"large-area"} and "only bounds are broken" in report.advice
    report = sweep_cdt.verify(back)
    assert not report and "with those of its input verify(input, mesh, steiner=True) judges it" in report.advice
    assert sweep_cdt.verify([], back, polygons=plate, steiner=True, max_depth=1e-12)
    assert not sweep_cdt.verify(back, min_angle=20, domain="hull")


def test_nothing_is_asked_of_delaunay_where_all_sides_are_edges():
    points, triangles = [[0, 0], [4, 0], [5, 3], [0, 3]], [[0, 1, 2], [0, 2, 3]]
    with pytest.warns(sweep_cdt.RemarkWarning, match="of 1 side between two triangles each is an edge"):
        assert sweep_cdt.verify(points, triangles, [[0, 2]])
    sweep_cdt.verify(points, triangles, [[0, 2]], level="constrained", strict=True)
    sweep_cdt.verify(points[:3], triangles[:1], [[0, 2]], strict=True)


def test_attributes_of_regions():
    edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]
    regions = [[3.0, 1.0, 7.0, 0.0]]
    given = {"vertices": SQUARE, "segments": edges, "regions": regions}
    right = {"triangles": WRONG, "triangle_attributes": [[7], [0]]}
    assert sweep_cdt.verify(given, right, domain="holes")
    wrong = {"triangles": WRONG, "triangle_attributes": [[0], [7]]}
    report = sweep_cdt.verify(given, wrong, domain="holes")
    assert report.violations["name"].tolist() == ["wrong-region", "wrong-region"]


def test_several_threads_say_the_same():
    points, result = random_result(50_000)
    triangles = result.simplices.copy()
    triangles[100] = triangles[101]
    for threads in (None, 0, 2):
        report = sweep_cdt.verify(points, triangles, threads=threads)
        assert not report and report.found == sweep_cdt.verify(points, triangles).found


def test_many_violations_are_listed_up_to_a_limit():
    points, _ = random_result(300)
    report = sweep_cdt.verify(points, np.arange(300).reshape(-1, 3), limit=5)
    assert len(report.violations) == 5 < report.found
    assert f"and {report.found - 5} more" in str(report)


def test_unknown_names():
    for options in ({"level": "best"}, {"domain": "odd"}, {"domain": "polygons"}):
        with pytest.raises(sweep_cdt.Error):
            sweep_cdt.verify(SQUARE, RIGHT, **options)


def test_points_that_are_not_finite_are_violations():
    points = SQUARE.copy()
    points[2, 1] = np.nan
    assert sweep_cdt.verify(points, RIGHT).violations["name"][0] == "non-finite-coordinate"


def test_assert_valid():
    assert sweep_cdt.assert_valid(SQUARE, RIGHT)
    with pytest.raises(AssertionError, match="not-delaunay") as caught:
        sweep_cdt.assert_valid(SQUARE, WRONG)
    assert not caught.value.report


def test_pictures():
    pytest.importorskip("matplotlib").use("Agg")
    report = sweep_cdt.verify(SQUARE, WRONG, [[0, 1]])
    assert len(report.plot().axes) == 2
    assert "not-delaunay" in report._repr_html_()
    assert len(sweep_cdt.verify(SQUARE, RIGHT).plot().axes) == 1
    assert "correct" in sweep_cdt.verify(SQUARE, RIGHT)._repr_html_()
    assert len(sweep_cdt.verify(SQUARE, [[0, 1, 9], [-1, 2, 3]]).plot().axes) >= 1
    assert len(sweep_cdt.verify([], []).plot().axes) == 1
