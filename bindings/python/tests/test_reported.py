"""Inputs of public reports on other programs, each with the result that its reporter wants.

They were made anew with the same geometry or form. Those with a file have it in `tests/data/reports`.
"""

import pathlib
import pickle
import subprocess
from fractions import Fraction
from itertools import combinations

import exact
import numpy as np
import pytest
from test_heights import values_in_fractions

import sweep_cdt

SQUARE = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]
NAN = float("nan")
REPORTS = pathlib.Path(__file__).resolve().parents[3] / "tests/data/reports"


def table(name):
    """The rows of a table with names, as doubles."""
    return np.loadtxt(REPORTS / name, delimiter=",", skiprows=1)


def said(command, folder, *arguments):
    """What the command prints, and what it says."""
    ran = subprocess.run([command, *arguments], cwd=folder, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout, ran.stderr


def test_corners_and_sides_of_a_star():
    """scipy#9737, PDAL#4155, observablehq/plot#2035: NaN at the corners and on the sides of a polygon."""
    shapely = pytest.importorskip("shapely")
    arm = [(3.0, 0.0), (7.375, 3.0625), (2.125, 2.125), (3.0625, 7.375)]
    turned = lambda p, k: [p, (-p[1], p[0]), (-p[0], -p[1]), (p[1], -p[0])][k]
    outline = [turned(p, k) for k in range(4) for p in arm]
    star = shapely.Polygon([(x, y, 10.0 + v) for v, (x, y) in enumerate(outline)])
    result = sweep_cdt.triangulate([star])
    assert result.interpolate(result.heights, result.points).tolist() == result.heights.tolist()
    middles = [(values + np.roll(values, -1, axis=0)) / 2 for values in (result.points, result.heights)]
    assert result.interpolate(result.heights, middles[0]).tolist() == middles[1].tolist()


def test_values_of_a_needle_at_its_own_points():
    """scipy#9737, Stoeoef/spade#124, CesiumGS/cesium#9175: points that are nearly on a line."""
    points = [
        [151222.42204363, 26485.646681210004],
        [151223.51948470186, 26486.01249490062],
        [151329.030055822, 26521.182685273998],
        [151350.89366048513, 26528.470553495048],
        [151584.05696185713, 26606.191653952377],
        [151766.44948816442, 26666.98916272147],
    ]
    result = sweep_cdt.triangulate(points)
    assert (result.find_simplex(points) >= 0).all()
    assert result.interpolate([0, 10, 20, 30, 40, 50], points).tolist() == [0, 10, 20, 30, 40, 50]


def test_equal_points_and_missing_neighbours():
    """hugoledoux/startinpy#16: the first of two equal points has no height; a triangle beside has a gap."""
    double = sweep_cdt.triangulate([[0, 0], [0, 0], [4, 0], [0, 4]])
    assert double.interpolate([NAN, 5, 5, 5], [[0, 0]]).tolist() == [5]
    gap = sweep_cdt.triangulate([*SQUARE, [9, 9]])
    assert gap.interpolate([1, 1, 1, 1, NAN], [[4, 4], [2, 4]]).tolist() == [1, 1]


def test_x_and_y_as_scipy_has_them():
    """The call of SciPy's interpolators: a tuple of x and y is no list of two points."""
    x, y = np.array([1.0, 2.0]), np.array([0.5, 1.0])
    result = sweep_cdt.triangulate([[0, 0], [4, 0], [0, 4]])
    assert result.interpolate([0, 4, 8], (x, y)).tolist() == [2, 4]
    interpolate = pytest.importorskip("scipy.interpolate")
    theirs = interpolate.LinearNDInterpolator(result.points, [0, 4, 8])
    assert theirs((x, y)).tolist() == theirs(x, y).tolist() == [2, 4]
    grid = np.meshgrid([0, 1, 2], [0, 1])
    assert result.interpolate([0, 4, 8], tuple(grid)).tolist() == theirs(*grid).tolist()
    with pytest.raises(sweep_cdt.ShapeError, match="x has the shape"):
        result.interpolate([0, 4, 8], ([0, 1], [0, 1, 2]))


def test_masked_arrays():
    """Open-MSS/MSS#811, SciTools/iris#58: masked arrays as of netCDF4. Their fill values count for nothing."""
    heights = np.ma.masked_values([10.0, 10.0, 10.0, 10.0, -9999.0], -9999.0)
    hill = sweep_cdt.triangulate([*SQUARE, [2.0, 2.0]])
    assert np.isnan(hill.interpolate(heights, [[2, 1]])).all()
    assert hill.interpolate(heights, [[2, 0]]).tolist() == [10]
    with pytest.raises(sweep_cdt.KindError, match=r"points\[4, 0\] is masked"):
        sweep_cdt.triangulate(np.ma.masked_values([*SQUARE, [-999.0, -999.0]], -999.0))
    with pytest.raises(sweep_cdt.KindError, match=r"edges\[1, 0\] is masked"):
        sweep_cdt.triangulate(SQUARE, np.ma.masked_array([[0, 1], [2, 3]], mask=[[0, 0], [1, 1]]))
    with pytest.raises(sweep_cdt.KindError, match=r"simplices\[1, 0\] is masked"):
        sweep_cdt.verify(SQUARE, np.ma.masked_array([[0, 1, 2], [0, 2, 3]], mask=[[0] * 3, [1] * 3]))
    far = sweep_cdt.triangulate([*SQUARE, [1e6, 1e6]])
    value = far.interpolate(np.ma.array([0, 0, 0, 0, 1e9], mask=[0, 0, 0, 0, 1]), [[3e5, 3e5]])
    assert np.isnan(value).all()


def test_lines_of_three_dimensions():
    """qgis/QGIS#27048, jblindsay/whitebox-tools#180, shapely#1844: heights of lines are dropped."""
    shapely = pytest.importorskip("shapely")
    lines = [[(0, 0, 10), (10, 0, 10), (10, 10, 10)], [(2, 3, 20), (6, 3, 20), (6, 8, 20)]]
    result = sweep_cdt.triangulate([shapely.LineString(line) for line in lines])
    assert result.heights.tolist() == [10, 10, 10, 20, 20, 20]
    with pytest.raises(sweep_cdt.ShapeError, match=r"pass points\[:, :2\]"):
        sweep_cdt.triangulate(np.array(lines[0]))


def test_forms_of_geopandas():
    """modflowpy/flopy#2085, geopandas#193 and #1137: arrays, subclasses, and frames without geometries."""
    geopandas = pytest.importorskip("geopandas")
    import shapely

    square, other = shapely.box(0, 0, 2, 2), shapely.MultiPolygon([shapely.box(5, 0, 6, 1)])
    series = geopandas.GeoSeries([square, None, shapely.Polygon(), other])
    for form in (series, series.values, series.to_numpy(), series.tolist(), (g for g in series.dropna())):
        assert sweep_cdt.triangulate(form).area == 5
    assert sweep_cdt.triangulate(other.geoms).area == 1
    with pytest.raises(sweep_cdt.KindError, match="without a column of geometries"):
        sweep_cdt.triangulate(geopandas.GeoDataFrame({"a": [1]}))


def test_nullable_columns():
    """holoviz/holoviews#6142: doubles in columns that can hold NA are doubles, and positions are positions."""
    pandas = pytest.importorskip("pandas")
    plain = pandas.DataFrame(np.random.default_rng(0).random((1000, 2)), columns=["x", "y"])
    one, other = sweep_cdt.triangulate(plain), sweep_cdt.triangulate(plain.astype("Float64"))
    assert other.points.dtype == float and (one.simplices == other.simplices).all()
    edges = pandas.DataFrame({"a": [0], "b": [1]}).convert_dtypes()
    assert sweep_cdt.triangulate(SQUARE, edges).edges.tolist() == [[0, 1]]


def test_all_results_go_to_another_process():
    """startinpy#17, isl-org/Open3D#218: what cannot be pickled."""
    crossing = [[0, 2], [1, 3]]
    split, crossings = sweep_cdt.split(SQUARE, crossing), sweep_cdt.crossings(SQUARE, crossing)
    cloud = np.random.default_rng(5).random((30, 2))
    trace, report = sweep_cdt.trace(cloud, heuristics="off"), sweep_cdt.verify(SQUARE, [[0, 1, 2], [0, 2, 3]])
    result = sweep_cdt.triangulate(SQUARE, [[0, 2]])
    for thing in (split, crossings, trace, trace.show(), report, result, sweep_cdt.measure(SQUARE)):
        again = pickle.loads(pickle.dumps(thing))
        assert type(again) is type(thing) and repr(again) == repr(thing)
    assert pickle.loads(pickle.dumps(crossings)).exact(0) == (2, 2)
    assert list(pickle.loads(pickle.dumps(trace))) == list(trace) != list(sweep_cdt.trace(cloud))
    assert pickle.loads(pickle.dumps(split)).edges.tolist() == split.edges.tolist()
    assert str(pickle.loads(pickle.dumps(report))) == str(report)


def test_a_result_of_three_decimals():
    """What `%.3f` writes of a cloud: the vertex that is farthest off, and the least tolerance, as of the command."""
    meshio = pytest.importorskip("meshio")
    points = np.array(
        [
            [269.0821757359716, 171.63543490666922],
            [184.53361989768914, 187.24838279394118],
            [493.7224950932333, 316.37813630357306],
            [337.1619652522468, 164.98172769272918],
            [339.95883058201116, 61.48618744359502],
        ]
    )
    triangles = sweep_cdt.triangulate(points).simplices
    rounded = meshio.Mesh(points.round(3), [("triangle", triangles)])
    with pytest.raises(sweep_cdt.MatchError, match="vertex 4 of the result.*tolerance=0.0005 accepts it") as caught:
        sweep_cdt.verify(points, rounded)
    assert caught.value.vertex == caught.value.nearest == 4
    assert sweep_cdt.verify(points, rounded, tolerance=0.0005)


def judged_near_sides(points, values, places):
    """A place has a value if a triangle holds it exactly, and a remark counts the others. Returns the number of those."""
    result = sweep_cdt.triangulate(points)
    wanted = [values_in_fractions(points, result.simplices, values, place) for place in places]
    outside = [not found for found in wanted]
    with pytest.warns(sweep_cdt.RemarkWarning) as caught:
        found = result.interpolate(values, places)
    assert caught[0].message.remark.numbers == {"missing": sum(outside), "places": len(places)}
    assert np.isnan(found).tolist() == outside
    for value, of_triangles in zip(found.tolist(), wanted):
        assert all(abs(value - float(height)) <= 1e-11 * np.ptp(values) for height in of_triangles)
    return sum(outside)


def test_places_on_a_side_but_for_rounding(command):
    """scipy#22831, python-adaptive#181: a place that rounding moves off the hull has no value, and a word; or the value
    of the nearest place within a distance that is asked for."""
    corners, places = table("thin_triangle.csv"), table("on_its_side.csv")
    assert judged_near_sides(corners[:, :2], corners[:, 2], places) == 7
    out, words = said(command, REPORTS, "heights", "thin_triangle.csv", "--at", "on_its_side.csv")
    assert "on_its_side.csv: 7 of 19 points have no height" in words and out.count(",\n") == 7
    axis, line = np.linspace(-0.5000000000000001, 0.49999999999999983, 6), np.linspace(-0.5, 0.5, 11)
    grids = [np.stack(np.meshgrid(a, a), axis=-1).reshape(-1, 2) for a in (axis, line)]
    assert judged_near_sides(grids[0], np.arange(36.0), grids[1]) == 21
    # The long side is from 10 to 30. On the grid the value is six times x and y, in steps of the grid.
    for within in (1e-15, 1e-3):
        found = sweep_cdt.triangulate(corners[:, :2]).interpolate(corners[:, 2], places, within=within)
        assert np.abs(found - (10 + 20 * places[:, 0] / 3)).max() <= 1e-12
        out, words = said(command, REPORTS, "heights", "thin_triangle.csv", "--at", "on_its_side.csv", "--within", str(within))
        assert not words and [float(row.split(",")[2]) for row in out.split()[1:]] == found.tolist()
        found = sweep_cdt.triangulate(grids[0]).interpolate(np.arange(36.0), grids[1], within=within)
        assert np.abs(found - 5 * (grids[1] + 0.5) @ [1, 6]).max() <= 1e-12
    with pytest.warns(sweep_cdt.RemarkWarning, match="21 of 121"):
        assert np.isnan(sweep_cdt.triangulate(grids[0]).interpolate(np.ones(36), grids[1], within=1e-18)).sum() == 21
    for within in (-1.0, float("nan"), float("inf")):
        with pytest.raises(sweep_cdt.Error, match="within is"):
            sweep_cdt.triangulate(grids[0]).interpolate(np.ones(36), grids[1], within=within)


def test_equal_points_and_missing_neighbours_by_the_command(command, tmp_path):
    (tmp_path / "gap.csv").write_text("x,y,z\n0,0,1\n4,0,1\n4,4,1\n0,4,1\n9,9,\n")
    (tmp_path / "at.csv").write_text("x,y\n4,4\n2,4\n")
    assert said(command, tmp_path, "heights", "gap.csv", "--at", "at.csv")[0] == "x,y,z\n4,4,1\n2,4,1\n"


def test_names_and_features_of_places_are_kept(command, tmp_path):
    """Columns of words and properties, of tables and maps that get heights; a loss elsewhere is said."""
    (tmp_path / "terr.csv").write_text("x,y,z\n0,0,1\n10,0,2\n10,10,3\n0,10,4\n")
    (tmp_path / "trees.csv").write_text('id,name,x,y,girth\n1,oak,2,3,1.5\n2,"elm, old",7,7,0.9\n')
    well = '{"type": "Feature", "properties": {"depth": 30}, "geometry": {"type": "Point", "coordinates": [2, 3]}}'
    (tmp_path / "wells.geojson").write_text(well)
    for places, words in (("trees.csv", "1 column `name`"), ("wells.geojson", "1 property `depth`")):
        heights = ["heights", "terr.csv", "--at", places]
        out, note = said(command, tmp_path, *heights)
        assert not note and "2.1" in out and ("elm, old" in out or '"depth": 30' in out)
        out, note = said(command, tmp_path, *heights, "-o", "out.xyz")
        assert note == f"note: {places}: ignored: {words}\n"


def in_fractions(ring):
    """The area of a closed ring."""
    ring = [[Fraction(x) for x in place] for place in ring]
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:])) / 2


@pytest.mark.parametrize(
    "ring",
    [
        # gadomski/antimeridian#201: sides along the line of 180 degrees, and a double beside it.
        "(180 -16.1, 179.99999999999997 -16.4, 180 -16.7, 179.1 -16.9, 178.6 -16.3, 180 -16.1)",
        # elalish/manifold#564: corners that rounding moves off a line, and two that are nearly one.
        "(0 0, 0.1 0.1, 0.30000000000000004 0.3, 0.30000000000000004 0.30000000000000004, 0.2 0.4,"
        " 0.1 0.20000000000000004, 0 0)",
    ],
)
def test_areas_of_outlines_that_are_nearly_degenerate(ring):
    judged_area(pytest.importorskip("shapely").from_wkt(f"POLYGON ({ring})"))


def test_walls_that_are_thin():
    """mapbox/earcut.hpp#100."""
    shapely = pytest.importorskip("shapely")
    wall = shapely.from_wkt((REPORTS / "thin_wall.wkt").read_text())
    assert abs(judged_area(wall) - 0.6102) < 1e-15


def judged_area(polygon):
    """The area of the triangles inside, which is that of the rings in fractions; verified."""
    result = sweep_cdt.triangulate(polygon)
    outline, *holes = (abs(in_fractions(ring.coords)) for ring in [polygon.exterior, *polygon.interiors])
    wanted = outline - sum(holes)
    assert abs(Fraction(result.area) - wanted) <= wanted / 10**14
    corners = result.points[result.triangles].tolist()
    assert sum(in_fractions([*three, three[0]]) for three in corners) == wanted
    assert sweep_cdt.verify(result).is_canonical
    return result.area


@pytest.mark.parametrize(
    "lines",
    [
        # jupedsim#1045: two halls, and a corridor through both of them.
        ["(0 0, 10 0, 10 8, 0 8, 0 0)", "(9 2, 19 2, 19 6, 9 6, 9 2)", "(-1 3, 20 3, 20 5, -1 5, -1 3)"],
        # CGAL/cgal#3314: the outline of a roof with its ridges, in metres of UTM.
        [
            "(431210.37 5411002.81, 431221.93 5411006.44, 431218.12 5411018.59, 431206.55 5411014.95, 431210.37 5411002.81)",
            "(431216.15 5411003.1, 431212.34 5411017.9)",
            "(431207.1 5411008.88, 431221.7 5411012.517, 431209.4 5411005.3)",
        ],
    ],
)
def test_lines_that_cross_are_split_where_they_do(lines):
    shapely = pytest.importorskip("shapely")
    lines = shapely.from_wkt([f"LINESTRING {line}" for line in lines])
    sides = [tuple(map(tuple, side)) for line in lines for side in zip(line.coords, line.coords[1:])]
    ends = exact.integers([place for side in sides for place in side])
    crossings = set()
    for (p, q), (r, s) in combinations(list(zip(ends[::2], ends[1::2])), 2):
        one, other = exact.turn(p, q, r), exact.turn(p, q, s)
        if one * other < 0 and exact.turn(r, s, p) * exact.turn(r, s, q) < 0:
            crossings.add(tuple(a + Fraction(one, one - other) * (b - a) for a, b in zip(r, s)))
    with pytest.raises(sweep_cdt.CrossingEdgesError):
        sweep_cdt.triangulate(lines)
    result = sweep_cdt.triangulate(lines, split_crossings=True)
    places = {place for side in sides for place in side}
    assert len(crossings) > 4 and len(result.points) == len(places) + len(crossings)
    assert sweep_cdt.verify(result).is_canonical
