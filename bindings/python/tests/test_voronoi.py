"""Voronoi diagrams: beside those of SciPy, and cells judged by distances in fractions."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweep_cdt


def by_points(diagram):
    """For each pair of points with a ridge its ends: places, and None where there is none."""
    place = lambda v: tuple(diagram.vertices[v].round(9)) if v >= 0 else None
    ends = (tuple(map(place, pair)) for pair in diagram.ridge_vertices)
    return {frozenset(pair): frozenset(of) for pair, of in zip(np.asarray(diagram.ridge_points).tolist(), ends)}


@pytest.mark.parametrize("seed", range(5))
def test_the_diagram_is_that_of_scipy(seed):
    spatial = pytest.importorskip("scipy.spatial")
    points = np.random.default_rng(seed).random((200, 2))
    ours, theirs = sweep_cdt.triangulate(points).voronoi(), spatial.Voronoi(points)
    assert np.allclose(*(np.array(sorted(d.vertices.tolist())) for d in (ours, theirs)), rtol=1e-7)
    assert {frozenset(p) for p in ours.ridge_points.tolist()} == {frozenset(p) for p in theirs.ridge_points.tolist()}
    near = points[(np.abs(points - 0.5) < 0.3).all(axis=1)]
    one, other = by_points(ours), by_points(theirs)
    inner = [pair for pair, ends in other.items() if None not in ends and np.abs(list(ends)).max() < 2]
    assert len(near) > 20 and len(inner) > 300 and all(one[pair] == other[pair] for pair in inner)
    assert sum(None in ends for ends in one.values()) == sum(None in ends for ends in other.values())
    for v in range(len(points)):
        around = [d.regions[d.point_region[v]] for d in (ours, theirs)]
        assert len(around[0]) == len(around[1]) and (-1 in around[0]) == (-1 in around[1])


GRID = st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=1, max_size=8)


@given(GRID)
def test_cells_tile_the_domain_and_hold_what_is_nearest(points):
    shapely = pytest.importorskip("shapely")
    domain = shapely.Polygon([(-1, -1), (6, -1), (6, 6), (3, 2), (-1, 6)], [[(1, 0), (2, 0), (1, 1)]])
    for given in (points, [[Fraction(x), Fraction(y)] for x, y in points]):
        result = sweep_cdt.triangulate(given)
        cells = result.voronoi().cells(domain)
        first = [points.index(p) for p in points]
        assert all(cells[v].equals(cells[of]) for v, of in enumerate(first))
        assert abs(sum(cells[v].area for v in set(first)) - domain.area) < 1e-9
        for v in set(first):
            if not cells[v].is_empty:
                place = cells[v].representative_point().coords[0]
                distance = lambda w: sum((Fraction(a) - b) ** 2 for a, b in zip(place, points[w]))
                assert distance(v) == min(map(distance, first))


def test_equal_points_share_a_cell():
    pytest.importorskip("shapely")
    diagram = sweep_cdt.triangulate([[0, 0], [4, 0], [0, 0], [0, 4]]).voronoi()
    assert diagram.point_region.tolist() == [0, 1, 0, 2] and len(diagram.regions) == 3
    with pytest.warns(sweep_cdt.RemarkWarning, match="1 point equals another one, and shares its cell"):
        cells = diagram.cells((-1, -1, 5, 5))
    assert cells[0].equals(cells[2]) and sum(cell.area for cell in cells[[0, 1, 3]]) == 36
    again = pickle.loads(pickle.dumps(diagram))
    assert again.regions == diagram.regions and again.vertices.tolist() == diagram.vertices.tolist() == [[2, 2]]


def test_no_triangles():
    diagram = sweep_cdt.triangulate([[0, 0], [4, 0], [2, 0]]).voronoi()
    assert diagram.ridge_vertices == [[-1, -1]] * 2 and diagram.regions == [[-1]] * 3
    assert len(diagram.vertices) == 0 and np.abs(diagram.ridge_directions).tolist() == [[0, 2], [0, 2]]
    assert sweep_cdt.triangulate([]).voronoi().regions == []


def test_fractions_stay_fractions():
    third = Fraction(1, 3)
    assert sweep_cdt.triangulate([[0, 0], [third, 0], [0, third]]).voronoi().vertices.tolist() == [[third / 2] * 2]


def test_what_has_no_diagram_of_its_own():
    with pytest.raises(sweep_cdt.KindError, match=r"triangulate\(points\).voronoi\(\)"):
        sweep_cdt.Voronoi([[0, 0], [1, 0]])
    shapely = pytest.importorskip("shapely")
    shops = sweep_cdt.triangulate([[0, 0], [8, 0], [8, 6]]).voronoi()
    ring = shapely.LinearRing([(0, 0), (9, 0), (9, 9)])
    with pytest.raises(sweep_cdt.KindError, match=r"pass shapely.Polygon\(ring\)"):
        shops.cells(ring)
    assert shops.cells(shapely.Polygon(ring))[1].area > 0


def test_what_has_no_diagram():
    kite = [[0, 0], [4, -1], [8, 0], [4, 1]]
    with pytest.raises(sweep_cdt.NotDelaunayError) as caught:
        sweep_cdt.triangulate(kite, [[0, 2]]).voronoi()
    assert caught.value.side == (0, 2)
    diagram = sweep_cdt.triangulate(kite).voronoi()
    for wrong in ((0, 0, 1), (1, 1, 0, 0), (0, 0, 1, np.nan), "abcd"):
        with pytest.raises(sweep_cdt.Error):
            diagram.cells(wrong)


def test_cells_have_the_coordinate_system_of_the_points():
    geopandas = pytest.importorskip("geopandas")
    shops = geopandas.GeoSeries.from_xy([0, 4, 1], [0, 1, 5], crs=2056)
    diagram = sweep_cdt.triangulate(shops).voronoi()
    assert diagram.to_geodataframe().crs.to_epsg() == 2056
    town = geopandas.GeoSeries.from_wkt(["POLYGON ((0 0, 5 0, 0 5, 0 0))"], crs=4326)
    with pytest.raises(sweep_cdt.Error, match="EPSG:2056 and EPSG:4326"):
        diagram.cells(town)
    assert abs(diagram.to_geodataframe(town.set_crs(2056, allow_override=True)).area.sum() - 12.5) < 1e-12
