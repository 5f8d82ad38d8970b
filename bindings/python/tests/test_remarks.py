"""Remarks: each is a warning, in the list of the result, and with `strict` an error, in the words of the command."""

import json
import pathlib
import pickle
import subprocess
import warnings

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweep_cdt

CLOUD = {"vertices": [[0, 0], [4, 0], [0, 4], [0, 0]], "vertex_attributes": [[1], [2], [3], [99]]}
WORDS = "vertex 0 has two numbers for z, 1 and 99: 1 counts"


def lines(shapely, z):
    """Two lines that cross at (2, 2), the second with a height of z there."""
    return [shapely.LineString([(0, 0, 0), (4, 4, 8)]), shapely.LineString([(0, 4, z), (4, 0, z)])]


def test_a_conflict_is_a_warning_of_the_line_that_calls():
    with pytest.warns(sweep_cdt.RemarkWarning, match=WORDS) as caught:
        result = sweep_cdt.triangulate(CLOUD)
    (warning,) = caught
    assert warning.filename == __file__
    (remark,) = result.remarks
    assert warning.message.remark == remark and str(remark) == WORDS and remark.kind == "conflict" and remark.is_loss
    assert remark.numbers == {"column": "z", "vertex": 0, "values": [1, 99], "count": 1}
    assert result.heights.tolist() == [1, 2, 3, 1]
    assert pickle.loads(pickle.dumps(result)).remarks == result.remarks
    with pytest.raises(sweep_cdt.RemarkError, match=WORDS) as refused:
        sweep_cdt.triangulate(CLOUD, strict=True)
    assert refused.value.remarks == result.remarks and isinstance(refused.value, sweep_cdt.Error)
    with warnings.catch_warnings():
        warnings.simplefilter("error", sweep_cdt.RemarkWarning)
        with pytest.raises(sweep_cdt.RemarkWarning):
            sweep_cdt.triangulate(CLOUD)


def test_values_that_contradict_each_other():
    """startinpy#16: two equal points with 1 and 99."""
    result = sweep_cdt.triangulate(CLOUD["vertices"])
    assert result.remarks == ()
    with pytest.warns(sweep_cdt.RemarkWarning, match="vertex 0 has two numbers for values, 1 and 99: 1 counts"):
        assert result.interpolate([1, 2, 3, 99], [[0, 0]]).tolist() == [1]
    with pytest.raises(sweep_cdt.RemarkError, match="values"):
        result.interpolate([1, 2, 3, 99], [[0, 0]], strict=True)
    assert result.interpolate([np.nan, 2, 3, 99], [[0, 0]], strict=True).tolist() == [99]


def test_values_outside_are_counted():
    result = sweep_cdt.triangulate(CLOUD["vertices"][:3])
    with pytest.warns(sweep_cdt.RemarkWarning, match="2 of 3 points have no height") as caught:
        result.interpolate([1, 2, 3], [[9, 9], [1, 1], [-1, 0], [np.nan, 0]])
    assert caught[0].message.remark.numbers == {"missing": 2, "places": 3}
    with warnings.catch_warnings():
        warnings.simplefilter("error", sweep_cdt.RemarkWarning)
        result.interpolate([1, 2, 3], [[1, 1], [np.nan, 0]])


def test_geometries_and_crossings_that_contradict_each_other():
    shapely = pytest.importorskip("shapely")
    with pytest.warns(sweep_cdt.RemarkWarning, match="vertex 4 has two numbers for z, 4 and 5: 4 counts"):
        result = sweep_cdt.triangulate(lines(shapely, 5), split_crossings=True)
    assert result.heights[4] == 4 and len(result.remarks) == len(result.split.remarks) == 1
    with pytest.raises(sweep_cdt.RemarkError):
        sweep_cdt.split(lines(shapely, 5), strict=True)
    assert sweep_cdt.split(lines(shapely, 4), strict=True).remarks == ()
    points = [shapely.Point(0, 0, 1), shapely.Point(1, 0, 2), shapely.Point(0, 0, 3)]
    calls = [sweep_cdt.triangulate, sweep_cdt.crossings, sweep_cdt.trace, sweep_cdt.measure, sweep_cdt.split]
    for call in [*calls, lambda points, **options: sweep_cdt.verify(points, [], **options)]:
        with pytest.raises(sweep_cdt.RemarkError):
            call(points, strict=True)
        with pytest.warns(sweep_cdt.RemarkWarning, match="vertex 0 has two numbers for z, 1 and 3: 1 counts"):
            call(points)


def test_heights_that_often_mean_that_there_is_none():
    """What rasters and netCDF write: the words of the command, for all that has heights, and for values."""
    shapely = pytest.importorskip("shapely")
    places, words = [(0, 0), (4, 0), (0, 4)], "height is -9999, which often means that there is none"
    fields = np.array([(*place, z) for place, z in zip(places, [1, -9999, 2])], dtype=[(name, float) for name in "xyz"])
    for form in (fields, {"vertices": places, "vertex_attributes": fields["z"]}, [shapely.Point(*row) for row in fields.tolist()]):
        with pytest.warns(sweep_cdt.RemarkWarning, match=f"1 {words} .NaN or a mask") as caught:
            (remark,) = sweep_cdt.triangulate(form).remarks
        assert remark.kind == "void" and not remark.is_loss and len(caught) == 1
        assert remark.numbers == {"value": -9999, "count": 1}
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = sweep_cdt.triangulate(fields)
        result.interpolate(result.heights, [[1, 1]])
    assert len(caught) == 1
    with pytest.warns(sweep_cdt.RemarkWarning, match="2 heights are 1e20"):
        result.interpolate([[1, 1e20], [2, 1e20], [3, 4]], [[1, 1]])
    with warnings.catch_warnings():
        warnings.simplefilter("error", sweep_cdt.RemarkWarning)
        result.interpolate(np.ma.masked_values([1, 1e20, 2], 1e20), [[0, 2]])


def test_measures_are_ignored_with_a_remark():
    shapely = pytest.importorskip("shapely")
    if not hasattr(shapely, "has_m"):
        pytest.skip("this shapely knows no measures")
    with pytest.warns(sweep_cdt.RemarkWarning, match="ignored: 3 measures"):
        result = sweep_cdt.triangulate(shapely.from_wkt(["LINESTRING M (0 0 5, 1 0 6)", "POINT ZM (0 1 2 3)"]))
    assert np.array_equal(result.heights, [2, np.nan, np.nan], equal_nan=True)


SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]


@pytest.mark.parametrize(
    ("given", "options", "kind", "words", "numbers"),
    [
        ([], {}, "no-triangles", "no triangles: there are no points", {"why": "no-points"}),
        ([[1, 1]] * 3, {}, "no-triangles", "no triangles: all points are one", {"why": "one-place"}),
        (
            [[0, 0], [1, 1], [2, 2]],
            {},
            "no-triangles",
            "no triangles: all points lie on one line",
            {"why": "one-line", "up": None},
        ),
        (
            SQUARE,
            {"edges": [[0, 2]] * 2, "inside": "even-odd"},
            "nothing-inside",
            "2 edges enclose nothing",
            {"edges": 2, "has_holes": False},
        ),
        (
            SQUARE,
            {"holes": [[2, 1]]},
            "nothing-inside",
            "argument inside: hull-without-holes keeps all",
            {"edges": 0, "has_holes": True},
        ),
        (
            [],
            {"polygons": [[SQUARE], [SQUARE]]},
            "covered-twice",
            "2 triangles are covered more than once",
            {"triangles": 2},
        ),
        (SQUARE, {"polygons": [[[0, 1, 2, 3, 0, 1, 2, 3]]]}, "traced-twice", "4 edges are traced twice", {"edges": 4}),
    ],
)
def test_what_the_engine_says_of_results(given, options, kind, words, numbers):
    with pytest.warns(sweep_cdt.RemarkWarning, match=words):
        result = sweep_cdt.triangulate(given, **options)
    (remark,) = (remark for remark in result.remarks if remark.kind == kind)
    assert words in str(remark) and remark.numbers == numbers and not remark.is_loss
    assert sweep_cdt.triangulate(given, **options, strict=True).remarks == result.remarks


def test_heights_that_are_missing_where_they_are_passed_on():
    shapely = pytest.importorskip("shapely")
    result = sweep_cdt.triangulate([shapely.Polygon([(0, 0, 1), (4, 0, 2), (0, 4, 3)]), shapely.Point(1, 1)])
    assert result.remarks == ()
    with pytest.warns(sweep_cdt.RemarkWarning, match="1 of 4 vertices have no height"):
        result.to_shapely()


def test_what_spans_half_of_the_globe(command):
    """gadomski/antimeridian#29: a polygon across the line of 180 degrees, where degrees are known to be meant."""
    geopandas = pytest.importorskip("geopandas")
    import shapely

    path = pathlib.Path(__file__).resolve().parents[3] / "tests/data/reports/across_180.geojson"
    document = json.loads(path.read_text())
    polygon = shapely.geometry.shape(document)
    fields = geopandas.GeoSeries([polygon], crs=4326)
    ran = subprocess.run([command, "triangulate", path.name], cwd=path.parent, capture_output=True, text=True)
    as_crs = lambda crs: fields.set_crs(crs, allow_override=True)
    degrees = {**document, "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}}
    for form in (document, [document], degrees, fields, geopandas.GeoDataFrame(geometry=fields), [as_crs(4258)]):
        with pytest.warns(sweep_cdt.RemarkWarning, match="2 edges span more than 180 degrees") as caught:
            (remark,) = sweep_cdt.triangulate(form).remarks
        assert remark.kind == "half-of-the-globe" and remark.numbers == {"edges": 2} and not remark.is_loss
        assert caught[0].message.remark == remark and str(remark) in ran.stderr
    (remark,) = sweep_cdt.triangulate([[0, 0]], polygons=fields).remarks
    assert remark.numbers == {"edges": 2}

    class Own:
        __geo_interface__ = document

    metres = {**document, "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2056"}}}
    for form in (polygon, Own(), metres, as_crs(2056), as_crs(None), fields.translate(360)):
        assert sweep_cdt.triangulate(form).remarks == ()
    cut = shapely.MultiPolygon([shapely.box(179, -17, 180, -16), shapely.box(-180, -17, -179.5, -16)])
    assert sweep_cdt.triangulate(geopandas.GeoSeries([cut], crs=4326)).remarks == ()


HEIGHTS = st.lists(st.integers(0, 2), min_size=6, max_size=6)


@given(st.lists(st.tuples(st.integers(0, 1), st.integers(0, 1)), min_size=6, max_size=6), HEIGHTS)
def test_there_is_a_remark_where_equal_points_differ(points, heights):
    first = [points.index(p) for p in points]
    differ = [v for v, of in enumerate(first) if heights[v] != heights[of]]
    result = sweep_cdt.triangulate({"vertices": points, "vertex_attributes": heights})
    assert result.heights.tolist() == [heights[of] for of in first]
    conflicts = [remark.numbers for remark in result.remarks if remark.kind == "conflict"]
    assert len(conflicts) == (1 if differ else 0)
    for numbers in conflicts:
        assert numbers["count"] == len({first[v] for v in differ}) and numbers["vertex"] in {first[v] for v in differ}


def test_the_sentence_is_that_of_the_command(command, tmp_path):
    path = tmp_path / "cloud.csv"
    path.write_text("x,y,z\n0,0,1\n4,0,2\n0,4,3\n0,0,99\n")
    ran = subprocess.run([command, "triangulate", path, "-o", tmp_path / "cloud.obj"], capture_output=True, text=True)
    assert WORDS.removeprefix("vertex 0 ") in ran.stderr
