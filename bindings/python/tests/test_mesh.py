"""Meshes within bounds: refined, judged in fractions, verified, and handed to other libraries with what goes along."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweep_cdt

PLATE = [[0, 0], [9, 0], [9, 1], [0, 6]]
RING = [[0, 1], [1, 2], [2, 3], [3, 0]]
# Two regions, the right one with a seed in its middle, and a hole.
PARTS = {
    "vertices": [[0, 0], [4, 0], [8, 0], [8, 4], [4, 4], [0, 4], [1, 1], [2, 1], [2, 2], [1, 2]],
    "segments": [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4], [6, 7], [7, 8], [8, 9], [9, 6]],
    "segment_markers": [[3], [1], [2], [1], [3], [4], [5], [6], [6], [6], [6]],
    "holes": [[1.5, 1.5]],
    "regions": [[3, 3, 10, 0], [6, 2, 20, 0]],
}


ALL = {"min_angle": 30, "max_area": 4, "max_side": 5}


def broken(points, triangles, bounds):
    """The triangles that break bounds, in fractions: an angle of 30 degrees at least has a squared cosine of 3/4."""
    found = []
    for t, corners in enumerate(triangles.tolist()):
        a, b, c = ([Fraction(x) for x in points[v]] for v in corners)
        square = lambda p, q: (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2
        sides = [square(b, c), square(c, a), square(a, b)]
        dots = [(sides[k - 1] + sides[k - 2] - sides[k]) / 2 for k in range(3)]
        sharp = any(d > 0 and d * d > Fraction(3, 4) * sides[k - 1] * sides[k - 2] for k, d in enumerate(dots))
        area = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
        names = {"min_angle": sharp, "max_area": "max_area" in bounds and area > bounds["max_area"]}
        names["max_side"] = "max_side" in bounds and max(sides) > Fraction(bounds["max_side"]) ** 2
        found += [(t, name) for name in bounds if names[name]]
    return found


@pytest.mark.parametrize("kind", [float, Fraction])
@given(
    st.lists(st.tuples(st.integers(0, 12), st.integers(0, 12)), min_size=4, max_size=8),
    st.sampled_from([{"min_angle": 30}, {"max_area": 2}, {"max_side": 3}, ALL]),
)
def test_no_triangle_breaks_a_bound_but_those_that_are_left(kind, points, bounds):
    result = sweep_cdt.triangulate([[kind(x), kind(y)] for x, y in points])
    mesh = result.refine(**bounds, max_points=200)
    left = {(t, name) for t, name, _ in mesh.left.tolist()}
    found = broken(mesh.points, mesh.triangles, bounds)
    assert {t for t, _ in left} == {t for t, _ in found} and left <= set(found)
    assert mesh.points[: len(points)].tolist() == result.points.tolist() and mesh.added_from == len(points)
    assert abs(float(mesh.area) - float(result.area)) < 1e-9
    if "min_angle" not in bounds:
        assert not len(mesh.left)
    report = sweep_cdt.verify(mesh, **bounds)
    names = {"min_angle": "small-angle", "max_area": "large-area", "max_side": "long-side"}
    listed = zip(report.violations["triangles"][:, 0].tolist(), report.violations["name"].tolist())
    assert sorted(listed) == sorted((t, names[name]) for t, name in found) and bool(report) == (not found)
    assert sweep_cdt.verify(mesh).is_canonical


def test_parts_are_those_of_their_edges():
    mesh = sweep_cdt.triangulate(PARTS).refine(30, max_side=1)
    assert len(mesh.left) == 0 and len(mesh.edge_of) == len(mesh.edges)
    for edge, (a, b) in enumerate(PARTS["segments"]):
        chain = mesh.edge_chain(edge)
        assert (chain[0], chain[-1]) == (a, b)
        parts = mesh.edges[mesh.edge_of == edge]
        assert np.stack([chain[:-1], chain[1:]], axis=1).tolist() == parts.tolist()
        assert set(mesh.markers[mesh.edge_of == edge]) == {PARTS["segment_markers"][edge][0]}
    with pytest.raises(IndexError):
        mesh.edge_chain(len(PARTS["segments"]))
    twice = mesh.refine(max_area=0.05)
    assert twice.added_from == len(mesh.points) and set(twice.edge_of) == set(range(11))
    again = pickle.loads(pickle.dumps(twice))
    for name in ("points", "edges", "edge_of", "triangles", "region", "markers", "left"):
        assert np.array_equal(getattr(again, name), getattr(twice, name)), name


def _areas(mesh):
    corners = mesh.points[mesh.triangles]
    (ux, uy), (vx, vy) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
    return (ux * vy - uy * vx) / 2


def test_regions_keep_their_numbers_though_a_vertex_takes_the_place_of_a_seed():
    mesh = sweep_cdt.triangulate(PARTS).refine(max_side=1, region_areas=[np.nan, 0.125])
    x = mesh.points[mesh.triangles].mean(axis=1)[:, 0]
    region = mesh.region[mesh.inside]
    assert ((x > 4) == (region == 1)).all() and set(region) == {0, 1}
    area = _areas(mesh)
    assert area[region == 1].max() <= 0.125 < area[region == 0].max() and abs(area.sum() - 31) < 1e-12
    crossed = {**PARTS, "segments": [*PARTS["segments"], [2, 4]], "segment_markers": None}
    split = sweep_cdt.triangulate({**crossed, "regions": [[6, 1, 20, 0]]}, split_crossings=True).refine(25, 0.1)
    assert len(split.left) == 0 and len(split.boundary()) == 2 and sweep_cdt.verify(split)


def test_areas_of_a_dictionary_count_as_those_of_a_file():
    plate = {"vertices": PARTS["vertices"][:6], "segments": PARTS["segments"][:7]}
    plate["regions"] = [[3, 3, 10, 0], [6, 2, 20, 0.125]]
    mesh = sweep_cdt.triangulate(plate, inside="holes").refine()
    areas, region = _areas(mesh), mesh.region[mesh.inside]
    assert areas[region == 1].max() <= 0.125 < 1 < areas[region == 0].max()
    coarse = sweep_cdt.triangulate(plate, inside="holes").refine(region_areas=[np.nan, 2])
    assert 0.125 < _areas(coarse)[coarse.region[coarse.inside] == 1].max() <= 2
    with pytest.warns(sweep_cdt.RemarkWarning, match="1 area of a region is not used: the rule hull has no regions"):
        mesh = sweep_cdt.triangulate(plate).refine()
    assert mesh.remarks[0].numbers == {"areas": 1, "rule": "hull"}
    with pytest.raises(sweep_cdt.RemarkError):
        sweep_cdt.triangulate(plate).refine(30, strict=True)
    for wrong in ([1], [1, 1, 1], [[1, 1]]):
        with pytest.raises(sweep_cdt.ShapeError, match="a number for each region, of which there are 2"):
            sweep_cdt.triangulate(plate, inside="holes").refine(region_areas=wrong)


def test_the_least_angle_is_20_where_there_is_no_bound():
    mesh = sweep_cdt.triangulate(PLATE, RING, inside="even-odd").refine()
    assert mesh.points.tolist() == sweep_cdt.triangulate(PLATE, RING, inside="even-odd").refine(20).points.tolist()
    assert not sweep_cdt.verify(sweep_cdt.triangulate(PLATE, RING), min_angle=20) and len(mesh.points) > 4


def test_features_have_areas_of_their_own():
    geopandas = pytest.importorskip("geopandas")
    import shapely

    boxes = [shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(3, 0, 4, 1)]), None, shapely.box(1, 0, 3, 1)]
    fields = geopandas.GeoSeries(boxes, crs=2056)
    frame = sweep_cdt.triangulate(fields).refine(region_areas=[0.02, 1, 0.25]).to_geodataframe()
    assert frame.crs.to_epsg() == 2056
    largest = frame.area.groupby(frame.region).max()
    assert largest[0] <= 0.02 and 0.02 < largest[2] <= 0.25
    with pytest.raises(sweep_cdt.ShapeError):
        sweep_cdt.triangulate(PLATE).refine(region_areas=[1])


def test_heights_of_new_vertices_are_linear():
    shapely = pytest.importorskip("shapely")
    slope = lambda x, y: 100 + 2 * x - 3 * y
    roof = shapely.Polygon([(x, y, slope(x, y)) for x, y in PLATE])
    with pytest.warns(sweep_cdt.RemarkWarning, match="heights are interpolated"):
        mesh = sweep_cdt.triangulate(roof).refine(28)
    assert np.abs(mesh.heights - slope(*mesh.points.T)).max() < 1e-11 and len(mesh.heights) > 6
    assert mesh.to_meshio().points[:, 2].tolist() == mesh.heights.tolist()


def test_an_area_by_place():
    fine = sweep_cdt.triangulate(PLATE).refine(max_area=lambda x, y: 0.01 if x < 7 else np.inf)
    area, x = _areas(fine), fine.points[fine.triangles].mean(axis=1)[:, 0]
    assert area[x < 7].max() <= 0.01 and area.max() > 0.02


def test_great_angles_need_a_limit_of_points():
    with pytest.raises(sweep_cdt.Error, match="pass max_points"):
        sweep_cdt.triangulate(PLATE).refine(36)


def test_functions_of_the_user_may_end_the_call():
    seen = []
    mesh = sweep_cdt.triangulate(PLATE).refine(30, 0.05, progress=lambda *counts: seen.append(counts))
    assert seen[-1] == (len(mesh.points), 0) and len(seen) > 2

    def fails(*_):
        raise ZeroDivisionError("on purpose")

    for options in ({"max_area": fails}, {"min_angle": 30, "progress": fails}):
        with pytest.raises(ZeroDivisionError, match="on purpose"):
            sweep_cdt.triangulate(PLATE).refine(**options)
    with pytest.raises(TypeError):
        sweep_cdt.triangulate(PLATE).refine(max_area=lambda x, y: "much")


def test_what_stays_is_said_with_its_reason():
    needle = [[0, 0], [9, 0], [9, 1]]
    result = sweep_cdt.triangulate(needle, [[0, 1], [1, 2], [2, 0]])
    with pytest.warns(sweep_cdt.RemarkWarning, match="break.* a bound still: a sharp corner of the input"):
        mesh = result.refine(25)
    assert set(mesh.left["bound"]) == {"min_angle"} and set(mesh.left["reason"]) == {"a sharp corner of the input"}
    with pytest.raises(sweep_cdt.RemarkError, match="sharp corner"):
        result.refine(25, strict=True)
    whole = sweep_cdt.triangulate(PLATE).refine(max_side=1, keep_boundary=True)
    assert len(whole.edges) == 4 and "the boundary is kept" in set(whole.left["reason"])
    few = result.refine(max_area=0.01, max_points=20)
    assert len(few.points) <= 20 and set(few.left["reason"]) == {"the limit of points"}


@pytest.mark.parametrize(
    "wrong",
    [{"min_angle": 60}, {"min_angle": 40}, {"min_angle": "a"}, {"max_area": 0}, {"max_side": -1}, {"max_side": np.nan}],
)
def test_bounds_that_are_none(wrong):
    with pytest.raises(sweep_cdt.Error):
        sweep_cdt.triangulate(PLATE).refine(**wrong)
    if wrong != {"min_angle": 40}:
        with pytest.raises(sweep_cdt.Error):
            sweep_cdt.verify(PLATE, [[0, 1, 2], [0, 2, 3]], **wrong)


def test_reports_name_the_triangles_that_break_bounds():
    points = [[0, 0], [4, 0], [4, 1], [0, 1]]
    right = sweep_cdt.triangulate(points).simplices
    report = sweep_cdt.verify(points, right, min_angle=20, max_side=4)
    assert not report and report.found == 4 and report.reached == "canonical"
    assert report.violations["triangles"][:, 0].tolist() == [0, 0, 1, 1]
    assert report.headline.endswith("but 2 of 2 triangles break the bounds") and report.advice.startswith("only bounds")
    assert "small-angle: triangle 0 has an angle of 14" in str(report)
    with pytest.raises(AssertionError, match="long-side") as caught:
        sweep_cdt.assert_valid(points, right, max_side=4)
    assert caught.value.report.violations["name"].tolist() == ["long-side"] * 2
    assert len(sweep_cdt.verify(points, right, min_angle=20, limit=1).violations) == 1
    # sqrt(17) is no double: the one below it is too short, and the one above it is not.
    root = 17**0.5
    near = sorted({root, np.nextafter(root, 0), np.nextafter(root, 9)})
    assert [bool(sweep_cdt.verify(points, right, max_side=s)) for s in near] == [
        Fraction(float(s)) ** 2 >= 17 for s in near
    ]


def test_markers_and_regions_go_to_meshio_and_back(tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh = sweep_cdt.triangulate(PARTS).refine(25, max_area=0.3)
    mesh.to_meshio().write(tmp_path / "parts.vtu")
    read = meshio.read(tmp_path / "parts.vtu")
    assert sweep_cdt.verify(read, domain="holes", holes=PARTS["holes"], min_angle=25, max_area=0.3)
    lines, marker = read.cells_dict["line"], read.cell_data_dict["marker"]["line"]
    edges = read.cell_data_dict["edge"]["line"]
    assert (marker == np.ravel(PARTS["segment_markers"])[edges]).all() and set(marker) == {1, 2, 3, 4, 5, 6}
    for (a, b), edge in zip(lines, edges):
        chain = mesh.edge_chain(edge).tolist()
        assert abs(chain.index(a) - chain.index(b)) in (1, len(chain) - 1)
    assert read.cell_data_dict["region"]["triangle"].tolist() == mesh.region[mesh.inside].tolist()


def test_the_marker_of_a_side_is_that_of_the_first_edge_with_one():
    pytest.importorskip("meshio")
    segments, markers = [[0, 2], [1, 0], [1, 2], [2, 3]], [0, 5, 0, 7]
    points = [[0, 0], [2, 0], [4, 0], [0, 3]]
    result = sweep_cdt.triangulate({"vertices": points, "segments": segments, "segment_markers": markers})
    wanted = {(0, 1): (0, 5), (1, 2): (0, 0), (2, 3): (3, 7)}
    mesh = result.to_meshio()
    rows = zip(
        mesh.cells_dict["line"].tolist(), mesh.cell_data_dict["edge"]["line"], mesh.cell_data_dict["marker"]["line"]
    )
    assert {(*sorted(side),): (edge, marker) for side, edge, marker in rows} == wanted
    written = result.to_triangle()
    rows = zip(written["segments"].tolist(), written["segment_markers"].ravel().tolist())
    of_hull = {(0, 3): (-1, 0)}
    assert dict(((*side,), m) for side, m in rows) == {side: m for side, (_, m) in {**wanted, **of_hull}.items()}


def test_markers_and_attributes_go_to_triangle_and_back():
    triangle = pytest.importorskip("triangle")
    mesh = sweep_cdt.triangulate(PARTS).refine(25, max_area=0.3)
    written = mesh.to_triangle()
    assert set(written["triangle_attributes"].ravel()) == {10, 20}
    assert sweep_cdt.verify(PARTS, written, steiner=True, max_depth=1e-12, min_angle=25)
    theirs = triangle.triangulate(written, "p")
    assert {*theirs["segment_markers"].ravel()} == {1, 2, 3, 4, 5, 6}
    pairs = lambda d: {(*sorted(s), m) for s, m in zip(d["segments"].tolist(), d["segment_markers"].ravel().tolist())}
    assert pairs(written) == pairs(theirs)
    again = sweep_cdt.triangulate(written)
    assert again.markers.tolist() == written["segment_markers"].ravel().tolist()
    with pytest.raises(sweep_cdt.ShapeError, match="segment_markers"):
        sweep_cdt.triangulate({**PARTS, "segment_markers": [1]})
