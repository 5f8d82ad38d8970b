"""The triangulation that changes: after any edits it is that of a fresh run, and what is refused changes nothing."""

import copy
import pickle
import threading
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweep_cdt

WALLS = [[0, 1], [1, 2], [2, 3], [3, 0]]
CORNERS = [[0, 0], [9, 0], [9, 6], [0, 6]]
PLACE = st.tuples(st.integers(0, 4), st.integers(0, 4))
# What an edit asks for: places that come, and draws of points and edges that go and of ends of edges that come.
STEP = st.tuples(
    st.lists(PLACE, max_size=4),
    *[st.lists(st.integers(0, 50), max_size=3)] * 2,
    st.lists(st.tuples(st.integers(0, 50), st.integers(0, 50)), max_size=2),
)


def state(dynamic):
    return [dynamic.triangles.tolist(), dynamic.points.tolist(), dynamic.edges.tolist(), dynamic.ends.tolist()]


def fresh(points, edges):
    """The triangles of a fresh run on what is there, by the numbers of the points."""
    numbers = sorted(points)
    ends = [[numbers.index(v) for v in pair] for pair in edges.values()]
    result = sweep_cdt.triangulate([points[v] for v in numbers], ends)
    return [[numbers[v] for v in corners] for corners in result.canonical().tolist()]


@pytest.mark.parametrize("kind", [float, Fraction])
@given(steps=st.lists(STEP, max_size=6))
def test_any_history_is_a_fresh_run(kind, steps):
    dynamic = sweep_cdt.DynamicTriangulation([[kind(0), kind(0)]])
    points, edges = {0: (0, 0)}, {}
    next_point, next_edge, triangles, is_distinct = 1, 0, [], True
    for places, gone, opened, pairs in steps:
        new = dict(enumerate(places, next_point))
        known = [*points, *new]
        gone = sorted({sorted(points)[n % len(points)] for n in gone}) if points else []
        opened = sorted({sorted(edges)[n % len(edges)] for n in opened}) if edges else []
        ends = [(known[a % len(known)], known[b % len(known)]) for a, b in pairs] if known else []
        before = state(dynamic)
        exact = [[kind(x), kind(y)] for x, y in places]
        try:
            change = dynamic.edit(points=exact, edges=ends, remove_points=gone, remove_edges=opened)
        except (sweep_cdt.CrossingEdgesError, sweep_cdt.PointInUseError):
            assert state(dynamic) == before
            continue
        points = {v: p for v, p in {**points, **new}.items() if v not in gone}
        edges = {e: p for e, p in {**edges, **dict(enumerate(ends, next_edge))}.items() if e not in opened}
        assert change.points.tolist() == list(new)
        assert change.edges.tolist() == list(range(next_edge, next_edge + len(ends)))
        next_point, next_edge = next_point + len(new), next_edge + len(ends)
        there = [sorted(points), sorted(edges), [list(edges[e]) for e in sorted(edges)]]
        assert state(dynamic) == [fresh(points, edges), *there]
        is_distinct, was_distinct = len(set(points.values())) == len(points), is_distinct
        if is_distinct and was_distinct:
            # No corner has got another name.
            lists = (triangles, change.gone, change.new, dynamic.triangles)
            old, gone_ones, new_ones, now = ({tuple(map(int, t)) for t in some} for some in lists)
            assert old - gone_ones | new_ones == now
        triangles = dynamic.triangles.tolist()
        # A copy goes on with the next numbers, and by itself.
        kept, dynamic = dynamic, [copy.copy, copy.deepcopy, lambda given: pickle.loads(pickle.dumps(given))][len(points) % 3](dynamic)
        assert state(dynamic) == state(kept)
        kept.insert([[kind(7), kind(7)]])
        assert state(dynamic) == [triangles, *there]
        assert dynamic.triangulation().canonical().tolist() == [
            [sorted(points).index(v) for v in corners] for corners in triangles
        ]


def test_errors_name_what_is_in_the_way_and_change_nothing():
    room = sweep_cdt.DynamicTriangulation(CORNERS, WALLS)
    change = room.insert([[5, 4]], [[0, 4]])
    assert change.points.tolist() == [4] and change.edges.tolist() == [4]
    before = state(room)
    with pytest.raises(sweep_cdt.CrossingEdgesError) as caught:
        room.insert(edges=[[1, 3]])
    assert caught.value.edges == (4, 5)
    with pytest.raises(sweep_cdt.PointInUseError) as caught:
        room.remove([4])
    assert (caught.value.point, caught.value.edge) == (4, 4)
    with pytest.raises(sweep_cdt.MissingError) as caught:
        room.remove(edges=[7])
    assert caught.value.edge == 7 and isinstance(caught.value, IndexError)
    for numbers in ([5], [-1]):
        with pytest.raises(sweep_cdt.MissingError):
            room.remove(numbers)
        with pytest.raises(sweep_cdt.MissingError):
            room.places(numbers)
        with pytest.raises(sweep_cdt.MissingError):
            room.edge_chain(numbers[0])
    with pytest.raises(sweep_cdt.NonFiniteError) as caught:
        room.insert([[1, 1], [np.nan, 0]])
    assert caught.value.vertex == 6
    for wrong in (["a"], [0.5], [[1]]):
        with pytest.raises(sweep_cdt.KindError):
            room.remove(wrong)
    with pytest.raises(sweep_cdt.KindError, match="Fraction"):
        room.insert([[Fraction(1, 3), 1]])
    assert state(room) == before
    assert room.remove([4], [4]).gone.tolist() == [[0, 1, 4], [0, 4, 3], [1, 2, 4], [2, 3, 4]]


EIGHTHS = st.integers(-8, 40).map(lambda n: n / 8)


@given(st.lists(PLACE, max_size=9), st.lists(st.tuples(EIGHTHS, EIGHTHS), min_size=1, max_size=9))
def test_the_nearest_point_is_that_of_all_distances(points, places):
    result = sweep_cdt.triangulate(points)
    distance = lambda p, q: sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(p, q))
    wanted = [min(range(len(points)), key=lambda v: distance(points[v], q), default=-1) for q in places]
    assert result.nearest(places).tolist() == wanted
    exactly = sweep_cdt.triangulate([[Fraction(x), Fraction(y)] for x, y in points])
    assert exactly.nearest(places).tolist() == wanted
    assert result.nearest([[Fraction(x), Fraction(1, 3) + Fraction(y)] for x, y in places]).tolist() == [
        min(range(len(points)), key=lambda v: distance(points[v], (q[0], Fraction(1, 3) + Fraction(q[1]))), default=-1)
        for q in places
    ]
    assert sweep_cdt.DynamicTriangulation(points).nearest(places).tolist() == wanted


def test_places_that_are_none_have_no_nearest_point():
    assert sweep_cdt.triangulate(CORNERS).nearest([[np.nan, 0], [1, 1]]).tolist() == [-1, 0]
    assert sweep_cdt.triangulate(CORNERS).nearest([8, 1]).tolist() == 1


def test_threads_share_a_triangulation():
    shared = sweep_cdt.DynamicTriangulation()
    insert = lambda seed: [shared.insert(np.random.default_rng(seed + n).random((5, 2))) for n in range(40)]
    threads = [threading.Thread(target=insert, args=(seed,)) for seed in (0, 1000, 2000)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    places = shared.places(shared.points)
    assert len(places) == 600 and shared.triangles.tolist() == sweep_cdt.triangulate(places).canonical().tolist()


def test_natural_neighbours_weigh_planes_exactly():
    rng = np.random.default_rng(3)
    points = rng.integers(0, 50, (40, 2)).astype(float)
    edited = sweep_cdt.DynamicTriangulation(points)
    exact = sweep_cdt.DynamicTriangulation([[Fraction(int(x)), Fraction(int(y))] for x, y in points])
    for place in points.mean(axis=0) + rng.uniform(-10, 10, (20, 2)):
        numbers, weights = edited.natural_neighbors(place)
        assert len(numbers) >= 3 and (weights > 0).all()
        np.testing.assert_allclose(weights @ points[numbers], place, rtol=1e-13)
        again, also = exact.natural_neighbors([Fraction(x) for x in place])
        assert again.tolist() == numbers.tolist() and [float(w) for w in also] == weights.tolist()
        # Of fractions the weights are fractions, which add up to the place itself.
        assert sum(also) == 1 and (also @ exact.places(again)).tolist() == [Fraction(x) for x in place]
    assert exact.natural_neighbors([Fraction(-1), 0])[1].dtype == object
    assert edited.natural_neighbors([-1, 0])[0].tolist() == []
    with pytest.raises(sweep_cdt.ShapeError):
        edited.natural_neighbors([[1, 1]])
    edited.insert(edges=[[0, 1]])
    with pytest.raises(sweep_cdt.Error, match="there is edge 0"):
        edited.natural_neighbors([1, 1])


def test_what_is_inside_follows_polygons_that_come_and_go():
    shapely = pytest.importorskip("shapely")
    box = shapely.box
    plate = box(0, 0, 9, 6) - box(1, 1, 2, 2)
    room = sweep_cdt.DynamicTriangulation(plate)
    assert (room.triangulation().rule, room.triangulation().area) == ("polygons", 53)
    place = box(3, 1, 5, 2)
    old = room.insert(place)
    for place in (box(3, 3, 5, 5), box(6, 1, 8, 5) - box(7, 2, 7.5, 3)):
        old = room.edit(points=place, remove_points=old.points, remove_edges=old.edges)
        result = room.triangulation()
        area = lambda number: sum(
            shapely.Polygon(result.points[corners]).area
            for corners in result.simplices[result.inside & (result.region == number)]
        )
        assert result.area == 53 and result.depth.max() == 2 and area(0) == 53
        free = room.triangulation(inside="even-odd")
        assert free.area == (plate - place).area and room.triangulation("hull").area == 54
    inner = sweep_cdt.DynamicTriangulation([], None)
    inner.insert([[20, 20]])
    mixed = inner.insert(place, [[0, 0]])
    assert mixed.edges.tolist() == list(range(9)) and inner.ends[8].tolist() == [0, 0]
    assert inner.triangulation().area == place.area
    room.remove(edges=old.edges[:1])
    with pytest.raises(sweep_cdt.OpenRingError):
        room.triangulation()
    room.remove(edges=room.edges)
    assert room.triangulation().rule == "hull" and len({hash(old), hash(place)}) == 2
    first = int(room.points[0])
    assert room.places(first).tolist() == room.places([first])[0].tolist()
    assert room.remove(points=first).points.size == 0 and first not in room.points
    seeds = {"vertices": CORNERS, "segments": WALLS, "holes": [[1, 1]]}
    assert sweep_cdt.DynamicTriangulation(seeds).triangulation().rule == "holes"
    with pytest.raises(sweep_cdt.KindError, match="holes"):
        room.insert(seeds)


@pytest.mark.parametrize("kind", [float, Fraction])
def test_interpolation_adds_up_the_weights(kind):
    random = np.random.default_rng(5)
    points = [[kind(int(x)), kind(int(y))] for x, y in random.integers(0, 30, (40, 2))]
    hill = sweep_cdt.DynamicTriangulation([*points, [kind(-1), kind(-1)]])
    hill.remove(points=[40])
    values = random.random((41, 2))
    places = random.integers(0, 30, (6, 5, 2))
    with pytest.warns(sweep_cdt.RemarkWarning, match="have no height"):
        found = hill.interpolate(values, [*places.tolist(), [[np.nan, 0]] * 5])
    assert found.shape == (7, 5, 2) and np.isnan(found[6]).all()
    for place, value in zip(places.reshape(-1, 2), found[:6].reshape(-1, 2)):
        numbers, weights = hill.natural_neighbors(place)
        expected = weights.astype(float) @ values[numbers] if len(numbers) else [np.nan] * 2
        assert np.allclose(value, expected, rtol=1e-12, equal_nan=True)
    assert 0 < np.isnan(found[:6]).sum() < 60
    with pytest.raises(sweep_cdt.ShapeError, match="numbers below 40"):
        hill.interpolate(values[:39], [[1, 1]])
    with pytest.raises(sweep_cdt.Error, match="edge"):
        sweep_cdt.DynamicTriangulation(CORNERS, WALLS).interpolate([0] * 4, [[1, 1]])
