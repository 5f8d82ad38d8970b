"""`triangulate`, judged by the repository's second judge, by SciPy's conventions, and by definitions."""

import decimal
import pickle
from fractions import Fraction

import exact
import numpy as np
import pytest

import sweep_cdt

SQUARE = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]


def random_points(count, seed=1):
    return np.random.default_rng(seed).random((count, 2))


def is_delaunay(result, edges=()):
    """Whether the second judge finds the highest level."""
    points = [tuple(p) for p in result.points.tolist()]
    reached, _ = exact.level(points, [list(e) for e in edges], result.simplices.tolist())
    return reached == "delaunay"


@pytest.mark.parametrize("count", [3, 10, 200])
def test_random_points_are_delaunay(count):
    assert is_delaunay(sweep_cdt.triangulate(random_points(count)))


def test_edges_are_chains_of_sides():
    points = [[0, 0], [8, 0], [8, 6], [0, 6], [4, 3], [1, 2], [7, 5]]
    edges = [[0, 2], [5, 6]]
    with pytest.raises(sweep_cdt.CrossingEdgesError):
        sweep_cdt.triangulate(points, [*edges, [1, 3], [5, 4], [3, 1], [1, 6], [0, 6], [6, 5], [2, 5]])
    result = sweep_cdt.triangulate(points, [[0, 2]])
    assert is_delaunay(result, [[0, 2]])
    assert result.edge_chain(0).tolist() == [0, 4, 2]
    assert sweep_cdt.triangulate(points, [[2, 0]]).edge_chain(0).tolist() == [2, 4, 0]
    assert {frozenset(s) for s in result.constrained_sides.tolist()} == {frozenset((0, 4)), frozenset((4, 2))}


@pytest.mark.parametrize("kind", [np.float64, np.float32, np.int8, np.int64, np.uint16])
def test_kinds_of_numbers(kind):
    points = np.random.default_rng(3).integers(0, 100, (60, 2)).astype(kind)
    expected = sweep_cdt.triangulate(points.astype(float)).canonical()
    assert (sweep_cdt.triangulate(points).canonical() == expected).all()
    assert (sweep_cdt.triangulate(points.tolist()).canonical() == expected).all()
    assert (sweep_cdt.triangulate(points[::-1]).canonical() != expected).any()


def unaligned(array):
    """The array, one byte off where the processor reads numbers best."""
    array = np.asarray(array)
    return np.frombuffer(b"." + array.tobytes(), array.dtype, offset=1).reshape(array.shape)


@pytest.mark.parametrize("kind", [">f8", "<f8", ">f4", ">i8", "<i8", ">u8", ">i4"])
def test_bytes_in_any_order_and_at_any_place(kind):
    swapped = np.array(SQUARE, dtype=kind)
    whole = kind.replace("f", "i")
    edges, triangles = np.array([[0, 2]], dtype=whole), np.array([[0, 1, 2], [0, 2, 3]], dtype=whole)
    for place in (np.asarray, unaligned):
        result = sweep_cdt.triangulate(place(swapped), place(edges))
        assert result.canonical().tolist() == triangles.tolist() and result.points.tolist() == SQUARE
        assert sweep_cdt.verify(place(swapped), place(triangles), place(edges))
        assert (result.find_simplex(place(swapped)) >= 0).all()


def test_exact_numbers_decide_where_doubles_cannot():
    third = Fraction(1, 3)
    # (1/3, 1/3) lies on the diagonal; the double nearest to a third does not, in both coordinates at once.
    points = [[0, 0], [1, 0], [1, 1], [0, 1], [third, third]]
    result = sweep_cdt.triangulate(points, [[0, 2]])
    assert result.edge_chain(0).tolist() == [0, 4, 2]
    assert result.points[4, 0] == third
    assert result.area == 1 and isinstance(result.area, Fraction)
    tiny = Fraction(1, 10**40)
    moved = sweep_cdt.triangulate([*points[:4], [third + tiny, third]], [[0, 2]])
    assert moved.edge_chain(0).tolist() == [0, 2]


def test_large_whole_numbers_are_not_rounded():
    big = 2**60
    # As doubles all of them are one point.
    points = [[big, big], [big + 1, big], [big, big + 1]]
    assert sweep_cdt.triangulate(points).simplices.shape == (1, 3)
    assert sweep_cdt.triangulate(np.array(points)).simplices.shape == (1, 3)
    assert sweep_cdt.triangulate([[10**400, 0], [0, 1], [0, 0]]).simplices.shape == (1, 3)
    assert sweep_cdt.triangulate([[big, 0.5], [big + 1, 0.5], [big, 1.5]]).simplices.shape == (1, 3)


def test_decimals_mean_what_they_say():
    tenth = decimal.Decimal("0.1")
    result = sweep_cdt.triangulate([[0, 0], [1, 0], [1, 1], [0, 1], [tenth, tenth]], [[0, 2]])
    assert result.points[4, 0] == Fraction(1, 10)


def test_neighbors_are_opposite_as_of_scipy():
    scipy_spatial = pytest.importorskip("scipy.spatial")
    points = random_points(50)
    ours, theirs = sweep_cdt.triangulate(points), scipy_spatial.Delaunay(points)

    def described(simplices, neighbors):
        sides = {}
        for t, corners in enumerate(simplices.tolist()):
            for i in range(3):
                across = neighbors[t, i]
                other = frozenset(simplices[across].tolist()) if across >= 0 else None
                sides[frozenset(corners), corners[i]] = other
        return sides

    assert described(ours.simplices, ours.neighbors) == described(theirs.simplices, theirs.neighbors)
    begins, ends = points[ours.convex_hull[:, 0]], points[ours.convex_hull[:, 1]]
    # Counter-clockwise: the area on the left is that of the hull.
    area = (begins[:, 0] * ends[:, 1] - begins[:, 1] * ends[:, 0]).sum() / 2
    assert abs(area - ours.area) < 1e-12
    hull = lambda sides: {frozenset(side) for side in sides.tolist()}
    assert hull(ours.convex_hull) == hull(theirs.convex_hull)
    queries = np.random.default_rng(2).random((500, 2)) * 1.2 - 0.1
    corners = lambda result, found: [set(result.simplices[t].tolist()) if t >= 0 else None for t in found]
    assert corners(ours, ours.find_simplex(queries)) == corners(theirs, theirs.find_simplex(queries))


def test_find_simplex_on_sides_and_corners():
    result = sweep_cdt.triangulate(SQUARE, [[0, 2]])
    for query, corners in [([2, 2], {0, 2}), ([0, 0], {0}), ([4, 4], {2}), ([3, 1], {0, 1, 2})]:
        assert corners <= set(result.simplices[result.find_simplex(query)].tolist())
    assert result.find_simplex([[5, 0], [np.nan, 0], [np.inf, 1]]).tolist() == [-1, -1, -1]
    assert result.find_simplex(np.empty((0, 2))).shape == (0,)
    assert result.find_simplex(np.zeros((2, 3, 2))).shape == (2, 3)
    third = Fraction(1, 3)
    assert result.find_simplex([[third, 2 * third]]) >= 0
    fractional = sweep_cdt.triangulate([[0, 0], [third, 0], [0, third]])
    assert fractional.find_simplex([[0.1, 0.1], [0.3, 0.3]]).tolist() == [0, -1]


def test_nothing_to_triangulate():
    for points in ([], np.empty((0, 2)), [[1, 1]], [[0, 0], [1, 1]], [[0, 0], [1, 1], [2, 2]], [[1, 1]] * 4):
        result = sweep_cdt.triangulate(points)
        assert result.simplices.shape == (0, 3) and result.neighbors.shape == (0, 3)
        assert result.convex_hull.shape == (0, 2) and result.area == 0
        assert result.find_simplex([[0, 0]]).tolist() == [-1]
        assert np.isnan(result.interpolate(np.zeros(len(points)), [[0, 0]])).all()
    assert sweep_cdt.triangulate([[1, 1], [0, 0], [1, 1]]).duplicates.tolist() == [[2, 0]]


def test_points_are_not_copied():
    points = random_points(100)
    result = sweep_cdt.triangulate(points)
    assert np.shares_memory(result.points, points)
    assert not result.points.flags.writeable and points.flags.writeable
    turned = sweep_cdt.triangulate(np.asfortranarray(points))
    assert (turned.canonical() == result.canonical()).all()
    assert (sweep_cdt.triangulate(points[::2]).points == points[::2]).all()


def test_threads_give_the_same_triangles():
    points = random_points(200_000)
    one = sweep_cdt.triangulate(points).canonical()
    for threads in (0, 2, 3):
        assert (sweep_cdt.triangulate(points, threads=threads).canonical() == one).all()


@pytest.mark.parametrize("points", [SQUARE, [[0, 0], [Fraction(1, 3), 0], [0, 10**30]]])
def test_pickle(points):
    result = sweep_cdt.triangulate(points, [[0, 2]])
    again = pickle.loads(pickle.dumps(result))
    assert (again.simplices == result.simplices).all() and (again.points == result.points).all()
    polygon = sweep_cdt.triangulate([], polygons=[[SQUARE, [[1, 1], [2, 1], [1, 2]]]])
    again = pickle.loads(pickle.dumps(polygon))
    assert again.rule == "polygons" and (again.triangles == polygon.triangles).all()
    split = sweep_cdt.triangulate(SQUARE, [[0, 2], [1, 3]], split_crossings=True)
    again = pickle.loads(pickle.dumps(split))
    assert again.edge_chain(1).tolist() == split.edge_chain(1).tolist() == [1, 4, 3]


def test_repr_repeats_no_array():
    assert len(repr(sweep_cdt.triangulate(random_points(100_000)))) < 100


def test_polygons_by_positions_and_by_coordinates():
    hole = [[1, 1], [2, 1], [1, 2]]
    ring = [0, 1, 2, 3]
    by_position = sweep_cdt.triangulate(SQUARE + hole, polygons=[[ring, [4, 5, 6]]])
    closed = sweep_cdt.triangulate(SQUARE + hole, polygons=[[[*ring, 0], [4, 5, 6, 4]]])
    mixed = sweep_cdt.triangulate(SQUARE, polygons=[[ring, [*hole, hole[0]]]])
    for result in (by_position, closed, mixed):
        assert result.area == 15.5 and result.rule == "polygons" and len(result.edges) == 7
        assert [len(chain) for chain in result.boundary()] == [4, 3]
        assert (result.region[result.inside] == 0).all()
    assert sweep_cdt.triangulate(SQUARE, polygons=[[ring]], inside="hull").inside.all()


def test_a_dictionary_keeps_its_regions_beside_polygons():
    given = {"vertices": SQUARE, "segments": [[0, 2]], "regions": [[3, 1, 7, 0]]}
    result = sweep_cdt.triangulate(given, polygons=[[[0, 1, 2, 3]]], inside="holes")
    assert sorted(result.region.tolist()) == [-1, 0]


def test_rules_for_what_is_inside():
    inner = [[1, 1], [3, 1], [3, 3], [1, 3]]
    edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]]
    area = lambda **more: sweep_cdt.triangulate(SQUARE + inner, edges, **more).area
    assert area() == area(inside="hull") == 16
    assert area(inside="even-odd") == 12
    assert area(inside="nonzero") == area(inside="positive") == 16
    assert area(inside="negative") == 0
    assert area(inside="at-least-2") == 4
    assert area(holes=[[2, 2]]) == area(holes=[[2, 2]], inside="hull-without-holes") == 12
    assert area(inside="holes") == 16
    with pytest.raises(ValueError, match='rule "odd" is not one of'):
        area(inside="odd")
    with pytest.raises(sweep_cdt.Error, match="no polygons"):
        area(inside="polygons")


@pytest.mark.parametrize("rule", ["even-odd", "nonzero", "positive", "negative", "at-least-2", "hull"])
def test_the_inside_alone_is_that_of_the_whole(rule):
    hole = [[1, 1], [2, 1], [2, 2], [1, 2]]
    touching = [[0, 0], [2, 0], [1, 1]]
    for polygon in [SQUARE], [SQUARE, hole], [SQUARE, hole[::-1]], [SQUARE, touching]:
        whole = sweep_cdt.triangulate([], polygons=[polygon], inside=rule)
        alone = sweep_cdt.triangulate_inside([], polygons=[polygon], inside=rule)
        assert alone.tolist() == whole.canonical().tolist()
    with pytest.raises(sweep_cdt.OpenRingError):
        sweep_cdt.triangulate_inside(SQUARE, [[0, 1]])
    with pytest.raises(sweep_cdt.CrossingEdgesError):
        sweep_cdt.triangulate_inside(SQUARE, [[0, 2], [2, 1], [1, 3], [3, 0]])
    with pytest.raises(sweep_cdt.Error, match="asks for more than edges"):
        sweep_cdt.triangulate_inside(SQUARE, [[0, 1], [1, 2], [2, 0]], inside="holes")


def test_split_crossings():
    result = sweep_cdt.triangulate(SQUARE, [[0, 2], [1, 3]], split_crossings=True)
    assert result.points[4].tolist() == [2, 2] and result.split.rounds == 1
    assert [result.edge_chain(e).tolist() for e in (0, 1, -1)] == [[0, 4, 2], [1, 4, 3], [1, 4, 3]]
    exactly = sweep_cdt.triangulate([[0, 0], [3, Fraction(1)], [0, 1], [2, 0]], [[0, 1], [2, 3]], split_crossings=True)
    assert exactly.points[4].tolist() == [Fraction(6, 5), Fraction(2, 5)]
    polygon = [[0, 0], [4, 4], [4, 0], [0, 4]]
    bow = sweep_cdt.triangulate([], polygons=[[polygon]], split_crossings=True)
    assert bow.area == 8


def test_interpolation_is_linear():
    points = random_points(300)
    result = sweep_cdt.triangulate(points)
    queries = np.random.default_rng(5).random((1000, 2))
    found = result.interpolate(np.column_stack([points @ [2, -3] + 1, points[:, 0]]), queries)
    held = result.find_simplex(queries) >= 0
    assert np.isnan(found[~held]).all() and held.sum() > 900
    assert np.abs(found[held, 0] - (queries[held] @ [2, -3] + 1)).max() < 1e-12
    assert np.abs(found[held, 1] - queries[held, 0]).max() < 1e-12
    with pytest.raises(sweep_cdt.ShapeError):
        result.interpolate([1, 2], queries)


def test_interpolation_is_exact_at_corners_and_in_slivers():
    # In doubles the weights in this triangle have no digit.
    result = sweep_cdt.triangulate([[0.1, 0.1], [0.7, 0.7], [0.3, 0.30000000000000004]])
    found = result.interpolate([1, 2, 3], [*result.points, [0.2, 0.2], [0.3, 0.3]])
    assert found[:3].tolist() == [1, 2, 3] and np.allclose(found[3:], [7 / 6, 4 / 3])
    outline, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[3, 3], [6, 3], [6, 6], [3, 6]]
    result = sweep_cdt.triangulate([], polygons=[[outline, hole]])
    found = result.interpolate(result.points @ [1, 10], [*hole, [3, 4], [6, 4.5], [4, 4]])
    assert found[:-1].tolist() == [33, 36, 66, 63, 43, 51] and np.isnan(found[-1])
    # Queries of another kind than the points.
    third = Fraction(1, 3)
    assert result.interpolate(result.points @ [3, 0], [[third, 1]]).tolist() == [1]
    exact = sweep_cdt.triangulate([[0, 0], [third, 0], [0, third]])
    found = exact.interpolate([[0, 1], [1, 1], [0, 1]], [[0.25, 0], [np.nan, 0], [9, 9]])
    assert np.allclose(found[0], [0.75, 1]) and np.isnan(found[1:]).all()


def test_pictures():
    result = sweep_cdt.triangulate(SQUARE, [[0, 2]])
    assert result._repr_svg_().startswith("<svg ") and result._repr_png_() is None
    assert result.to_png().startswith(b"\x89PNG")
    large = sweep_cdt.triangulate(random_points(3000))
    assert large._repr_svg_() is None and large._repr_png_().startswith(b"\x89PNG")
    assert sweep_cdt.triangulate([[0, 0], [10**400, 0], [0, 1]])._repr_svg_().startswith("<svg ")
    assert sweep_cdt.triangulate([])._repr_svg_().startswith("<svg ")
