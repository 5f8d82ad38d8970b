"""Heights: z and coordinate systems go through every type of geometry, and values at points are those of fractions."""

import decimal
import json
import pickle
import subprocess
from fractions import Fraction

import exact
import hypothesis
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_given import features_of, parts, wrappings
from test_properties import NEAR, SMALL

import sweep_cdt

# Files last for a test; each example writes its own over them.
shared = hypothesis.settings(suppress_health_check=[hypothesis.HealthCheck.function_scoped_fixture])


def slope(x, y):
    return 100.0 + 2 * x - 3 * y


@given(parts(), st.lists(st.booleans(), min_size=4, max_size=4))
def test_every_geometry_keeps_its_heights(kinds, with_z):
    pytest.importorskip("geopandas")
    import shapely

    high, flat = features_of(shapely, kinds, slope), features_of(shapely, kinds)
    features = [one if has else other for one, other, has in zip(high, flat, with_z)]
    if not any(features):
        return
    for form in wrappings(shapely, features):
        result = sweep_cdt.triangulate(form)
        wanted = slope(*result.points.T)
        if not any(g is not None and shapely.has_z(g) for g in features):
            assert result.heights is None
            continue
        known = ~np.isnan(result.heights)
        assert (result.heights[known] == wanted[known]).all()
        places = shapely.get_coordinates([g for g in features if g is not None and shapely.has_z(g)])
        assert {tuple(p) for p in result.points[known].tolist()} == {tuple(p) for p in places.tolist()}


@given(parts(), st.sampled_from([2056, "EPSG:25832", None]))
def test_a_coordinate_system_goes_to_the_triangles(kinds, crs):
    geopandas = pytest.importorskip("geopandas")
    import shapely

    class Own(geopandas.GeoDataFrame):
        pass

    series = geopandas.GeoSeries(features_of(shapely, kinds, slope), crs=crs)
    for form in (
        series,
        series.values,
        geopandas.GeoDataFrame(geometry=series),
        Own(geometry=series),
        [series, series[:0]],
    ):
        result = sweep_cdt.triangulate(form)
        assert result.crs == series.crs
        frame = result.to_geodataframe()
        assert frame.crs == series.crs and len(frame) == len(result.triangles)
        assert (frame.geometry.area.sum() == result.area) and frame.has_z.all()
        if result.region is not None:
            assert frame.region.tolist() == result.region[result.inside].tolist()
        again = pickle.loads(pickle.dumps(result))
        assert again.crs == series.crs and np.array_equal(again.heights, result.heights)
    for corners, triangle in zip(result.triangles, result.to_shapely().geoms):
        assert shapely.get_coordinates(triangle, include_z=True)[:3, 2].tolist() == result.heights[corners].tolist()


def test_a_document_of_its_time_has_a_coordinate_system():
    geopandas = pytest.importorskip("geopandas")
    ring = [[0, 0, 1], [4, 0, 2], [0, 4, 3], [0, 0, 1]]
    feature = {"type": "Feature", "properties": None, "geometry": {"type": "Polygon", "coordinates": [ring]}}
    crs = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2056"}}
    result = sweep_cdt.triangulate({"type": "FeatureCollection", "crs": crs, "features": [feature]})
    assert result.heights.tolist() == [1, 2, 3] and result.to_geodataframe().crs.to_epsg() == 2056
    place = geopandas.GeoSeries.from_wkt(["POINT (1 1)"], crs=2056)
    assert result.interpolate(result.heights, place).tolist() == [1.75]
    for none in (None, {"type": "link"}, {"type": "name", "properties": None}):
        assert sweep_cdt.triangulate({**feature, "crs": none}).crs is None


NAMES = st.sampled_from(["z", "elev", "ELEV_M", "height", "contour", "girth", "name"])
PROPERTIES = st.dictionaries(
    NAMES, st.one_of(st.none(), st.integers(-9, 9), st.just("7"), st.just("oak"), st.booleans())
)


@shared
@given(
    kinds=parts(), properties=st.lists(PROPERTIES, min_size=4, max_size=4), with_z=st.lists(st.booleans(), min_size=4)
)
def test_a_property_is_the_height_as_for_the_command(command, tmp_path, kinds, properties, with_z):
    shapely = pytest.importorskip("shapely")
    # GeoJSON has no rings by themselves.
    kinds = [[kind for kind in of_feature if kind != "ring"] for of_feature in kinds]
    high, flat = features_of(shapely, kinds, slope), features_of(shapely, kinds)
    shapes = [one if has else other for one, other, has in zip(high, flat, with_z)]
    features = [
        {"type": "Feature", "properties": of, "geometry": None if g is None else g.__geo_interface__}
        for g, of in zip(shapes, properties)
    ]
    document = {"type": "FeatureCollection", "features": features}
    (tmp_path / "map.geojson").write_text(json.dumps(document))
    arguments = [command, "triangulate", "map.geojson", "-o", "map.json"]
    ran = subprocess.run(arguments, cwd=tmp_path, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    theirs = json.loads((tmp_path / "map.json").read_text())["points"]
    for form in (document, features, [document]):
        result = sweep_cdt.triangulate(form)
        heights = np.full(len(result.points), np.nan) if result.heights is None else result.heights
        known = [None if np.isnan(height) else height for height in heights]
        assert dict(zip(map(tuple, result.points.tolist()), known)) == {
            (*place[:2],): place[2] if len(place) > 2 else None for place in theirs
        }
        for remark in result.remarks:
            assert remark.kind != "height-property" or str(remark) in ran.stderr


def test_a_column_is_the_height_of_points_and_lines():
    geopandas = pytest.importorskip("geopandas")
    import shapely

    polygon = "POLYGON ((5 5, 6 5, 5 6, 5 5))"
    shapes = shapely.from_wkt(["POINT (0 0)", "LINESTRING (4 0, 4 4)", "POINT Z (0 4 7)", polygon])
    frame = geopandas.GeoDataFrame({"name": list("abcd"), "Elev (m)": [1, None, 3, 4]}, geometry=shapes, crs=2056)
    result = sweep_cdt.triangulate(frame)
    gap = [np.nan] * 2
    assert np.array_equal(result.heights, [1, 7, *gap, *gap, np.nan], equal_nan=True)
    lost, remark = result.remarks
    assert remark.numbers == {"name": "Elev (m)", "count": 1} and not remark.is_loss
    # The third point has another z.
    assert str(lost) == "ignored: 1 property `Elev (m)`" and lost.is_loss
    both = sweep_cdt.triangulate([frame[:1], frame.geometry[1:]])
    assert np.array_equal(both.heights, result.heights, equal_nan=True)
    assert sweep_cdt.triangulate(frame[["name", "geometry"]][:2]).heights is None


@pytest.mark.parametrize("kind", ["text", "decimal", "object"])
def test_numbers_of_a_column_of_objects_are_heights(kind):
    """PostGIS has decimals, files of text have text; a number is missing where it is none."""
    geopandas = pytest.importorskip("geopandas")
    make = {"text": str, "decimal": decimal.Decimal, "object": float}[kind]
    column = np.array([make("1.5"), make("2.5"), None], dtype=object)
    frame = geopandas.GeoDataFrame({"elev": column}, geometry=geopandas.points_from_xy([0, 4, 0], [0, 0, 4]))
    result = sweep_cdt.triangulate(frame)
    assert np.array_equal(result.heights, [1.5, 2.5, np.nan], equal_nan=True)
    assert [str(remark) for remark in result.remarks] == ["heights are the property `elev` of 2 features"]
    asked = sweep_cdt.triangulate(frame.rename(columns={"elev": "rim"}), height_property="rim")
    assert np.array_equal(asked.heights, result.heights, equal_nan=True)


def test_a_column_beside_other_heights_is_said():
    """Lines of a shapefile with z of 0 everywhere, and their heights in a column."""
    geopandas = pytest.importorskip("geopandas")
    import shapely

    lines = shapely.from_wkt(["LINESTRING Z (0 0 0, 4 0 0)", "LINESTRING Z (0 4 0, 4 4 0)"])
    frame = geopandas.GeoDataFrame({"ELEV": [10, 20]}, geometry=lines)
    with pytest.warns(sweep_cdt.RemarkWarning, match="ignored: 2 properties `ELEV`"):
        assert sweep_cdt.triangulate(frame).heights.tolist() == [0] * 4
    with pytest.raises(sweep_cdt.RemarkError, match="`ELEV`"):
        sweep_cdt.triangulate(frame, strict=True)
    assert sweep_cdt.triangulate(frame, height_property="ELEV", strict=True).heights.tolist() == [10, 10, 20, 20]
    # Where both say the same, nothing is lost.
    assert sweep_cdt.triangulate(frame.assign(ELEV=0)).remarks == ()


def test_positions_of_a_document_need_not_be_alike(command, tmp_path):
    """A height may be null or not there, and measures are ignored, as by the command."""
    pytest.importorskip("shapely")
    line = {"type": "LineString", "coordinates": [[0, 0], [4, 0, 1, 9], [4, 4, None], [0, 4, 2, 7]]}
    whole = {"type": "GeometryCollection", "geometries": [line, {"type": "MultiPoint", "coordinates": [[9, 9, 3], [8, 9]]}]}
    (tmp_path / "map.geojson").write_text(json.dumps(whole))
    arguments = [command, "triangulate", "map.geojson", "-o", "map.json"]
    ran = subprocess.run(arguments, cwd=tmp_path, capture_output=True, text=True)
    theirs = json.loads((tmp_path / "map.json").read_text())["points"]
    wanted = {(*place[:2],): place[2] if len(place) > 2 else None for place in theirs}
    for form in (whole, [whole], {"type": "Feature", "properties": None, "geometry": whole}):
        with pytest.warns(sweep_cdt.RemarkWarning, match="ignored: 2 measures"):
            result = sweep_cdt.triangulate(form)
        heights = [None if np.isnan(z) else z for z in result.heights]
        assert dict(zip(map(tuple, result.points.tolist()), heights)) == wanted
    assert "ignored: 2 measures" in ran.stderr and wanted[8, 9] is None


def test_the_number_of_a_geometry_is_a_coordinate_system():
    """As PostGIS hands them out: `shapely.get_srid`."""
    geopandas = pytest.importorskip("geopandas")
    import shapely

    square, hole = shapely.set_srid(shapely.box(0, 0, 4, 4), 2056), shapely.Point(1, 1)
    for form in (square, [square], [None, square, shapely.box(5, 5, 6, 6)], np.array([square])):
        assert sweep_cdt.triangulate(form).to_geodataframe().crs.to_epsg() == 2056
    assert sweep_cdt.triangulate([square, geopandas.GeoSeries([hole], crs=2056)]).crs is not None
    with pytest.raises(sweep_cdt.Error, match="EPSG:2056 and EPSG:25832"):
        sweep_cdt.triangulate([square, shapely.set_srid(hole, 25832)])
    other = geopandas.GeoSeries([hole], crs=4326)
    with pytest.raises(sweep_cdt.Error, match="holes has two coordinate systems, EPSG:2056 and EPSG:4326"):
        sweep_cdt.triangulate(square, holes=other)
    with pytest.raises(sweep_cdt.Error, match="holes has two coordinate systems"):
        sweep_cdt.triangulate([], polygons=geopandas.GeoSeries([square], crs=2056), holes=other)


def test_tables_beside_geometries_are_points_of_one_terrain():
    geopandas = pytest.importorskip("geopandas")
    import pandas
    import shapely

    lines = shapely.from_wkt(["LINESTRING (0 0, 9 0)", "LINESTRING (0 9, 9 9)"])
    contours = geopandas.GeoDataFrame({"elev": [1, 19]}, geometry=lines, crs=2056)
    border = shapely.Polygon([(0, 0), (9, 0), (9, 9), (4, 6), (0, 9)])
    rows = np.array([[4, 2, 5], [6, 3, 7.5]])
    named = pandas.DataFrame({"h": rows[:, 2], "north": rows[:, 1], "east": rows[:, 0]})
    fields = np.rec.fromarrays(rows.T, names="x,y,z").view(np.ndarray)
    for table, places in [
        (rows, rows),
        (fields, rows),
        (np.ma.array(rows, mask=rows == 5), np.where(rows == 5, np.nan, rows)),
        (named, rows),
        (pandas.DataFrame(rows), rows),
        (rows[:, :2].astype(int), rows[:, :2].astype(int)),
    ]:
        for order in [(0, 1, 2), (2, 1, 0), (1, 2, 0)]:
            layers = [[contours, border, other] for other in (table, geopandas.GeoSeries(shapely.points(places)))]
            found, wanted = (sweep_cdt.triangulate([of[at] for at in order]) for of in layers)
            assert found.points.tolist() == wanted.points.tolist() and found.rule == wanted.rule == "polygons"
            assert np.array_equal(found.heights, wanted.heights, equal_nan=True)
            assert found.triangles.tolist() == wanted.triangles.tolist() and found.crs == contours.crs
    with pytest.raises(sweep_cdt.KindError, match=r"points\[1\] has exact coordinates"):
        sweep_cdt.triangulate([border, np.array([[Fraction(1, 3), 1]])])
    with pytest.raises(sweep_cdt.ShapeError, match=r"points\[0\] has the shape \(2, 4\)"):
        sweep_cdt.triangulate([np.zeros((2, 4)), border])
    # Arrays alone are no geometries.
    with pytest.raises(sweep_cdt.ShapeError):
        sweep_cdt.triangulate([rows, rows])


def test_two_coordinate_systems_are_refused():
    geopandas = pytest.importorskip("geopandas")
    import shapely

    one, other = (geopandas.GeoSeries([shapely.box(0, 0, 1, 1)], crs=crs) for crs in (2056, 4326))
    with pytest.raises(sweep_cdt.Error, match="EPSG:2056 and EPSG:4326"):
        sweep_cdt.triangulate([one, other])
    with pytest.raises(sweep_cdt.Error, match="EPSG:2056 and EPSG:4326"):
        sweep_cdt.triangulate(one).interpolate(np.zeros(4), other.representative_point())
    assert sweep_cdt.triangulate(one).find_simplex(one.representative_point()).tolist() != [-1]
    assert sweep_cdt.triangulate(one).find_simplex([shapely.Point(0.5, 0.25)]).tolist() != [-1]


def test_equal_places_have_one_height():
    shapely = pytest.importorskip("shapely")
    flat, high = shapely.Point(0, 0), shapely.LineString([(0, 0, 7), (4, 0, 1)])
    result = sweep_cdt.triangulate([flat, high, shapely.Point(0, 4)])
    assert np.array_equal(result.heights, [7, np.nan, 1], equal_nan=True)
    polygon = shapely.Polygon([(0, 0, 5), (4, 0, 6), (0, 4, 7)])
    result = sweep_cdt.triangulate([[0, 0], [9, 9]], polygons=polygon)
    assert result.duplicates.tolist() == [[2, 0]]
    assert np.array_equal(result.heights, [5, np.nan, 5, 6, 7], equal_nan=True)


def test_split_edges_have_the_heights_of_the_first():
    shapely = pytest.importorskip("shapely")
    lines = [shapely.LineString([(0, 0, 0), (4, 4, 8)]), shapely.LineString([(0, 4, 2), (4, 0, 6)])]
    result = sweep_cdt.triangulate(lines, split_crossings=True)
    assert result.points[4].tolist() == [2, 2] and result.heights.tolist() == [0, 8, 2, 6, 4]
    assert pickle.loads(pickle.dumps(result)).heights.tolist() == [0, 8, 2, 6, 4]
    assert sweep_cdt.split(lines).heights.tolist() == [0, 8, 2, 6, 4]


def test_a_dictionary_of_triangle_has_heights():
    given = {"vertices": [[0, 0], [4, 0], [0, 4]], "vertex_attributes": [[1, 9], [2, 9], [3, 9]]}
    result = sweep_cdt.triangulate(given)
    assert result.heights.tolist() == [1, 2, 3]
    assert result.to_triangle()["vertex_attributes"].tolist() == [[1], [2], [3]]
    with pytest.raises(sweep_cdt.ShapeError, match="vertex_attributes"):
        sweep_cdt.triangulate({**given, "vertex_attributes": [[1]]})
    assert sweep_cdt.triangulate({**given, "vertex_attributes": np.empty((3, 0))}).heights is None


def values_in_fractions(points, simplices, values, place):
    """All values that triangles which hold a place have there: one, if there are any."""
    x, y = map(Fraction, place)
    found = set()
    for corners in simplices:
        (ax, ay), (bx, by), (cx, cy) = ([Fraction(c) for c in points[v]] for v in corners)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
        c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
        if min(b, c, 1 - b - c) >= 0:
            weights = zip((1 - b - c, b, c), corners)
            found.add(sum(weight * Fraction(values[v]) for weight, v in weights))
    return found


HEIGHTS = st.one_of(st.integers(-1000, 1000).map(float), st.floats(-1e6, 1e6))
SHARES = st.sampled_from(
    [Fraction(0), Fraction(1, 2), Fraction(1, 4), Fraction(3, 8), Fraction(1, 3), Fraction(10**9 - 1, 10**9)]
)


def judged_values(points, values, shares, convert):
    """Compares values at corners, on sides and within triangles with those of fractions, to 1e-11 of their range."""
    result = sweep_cdt.triangulate(points)
    simplices = result.simplices.tolist()
    places = [list(p) for p in points]
    for a, b, c in simplices:
        for u, v in shares:
            corners = [[Fraction(x) for x in points[n]] for n in (a, b, c)]
            weights = (1 - u, u * (1 - v), u * v)
            places.append([convert(sum(w * p[axis] for w, p in zip(weights, corners))) for axis in (0, 1)])
    found = result.interpolate(values, places)
    # Equal points have the first value.
    shared = list(values)
    for v, first in result.duplicates.tolist():
        shared[v] = shared[first]
    used = [shared[v] for corners in simplices for v in corners] or [0.0]
    for place, value in zip(places, found.tolist()):
        wanted = values_in_fractions(points, simplices, shared, place)
        assert len(wanted) <= 1
        if not wanted:
            assert np.isnan(value)
            continue
        (height,) = wanted
        assert abs(Fraction(value) - height) <= Fraction(max(used) - min(used)) / 10**11 + abs(height) / 2**52


@pytest.mark.parametrize("convert", [float, Fraction])
@pytest.mark.parametrize("coordinate", [NEAR, SMALL, st.floats(-1e3, 1e3), st.floats(-1.7e308, 1.7e308)])
@given(data=st.data())
def test_values_are_those_of_fractions(coordinate, convert, data):
    points = data.draw(st.lists(st.tuples(coordinate, coordinate), min_size=3, max_size=7))
    values = data.draw(st.lists(HEIGHTS, min_size=len(points), max_size=len(points)))
    judged_values(points, values, data.draw(st.lists(st.tuples(SHARES, SHARES), max_size=3)), convert)


def test_values_at_all_corners_and_sides_of_a_polygon_with_holes():
    outline, hole = [[0, 0], [9, 0], [5, 4], [9, 9], [0, 9]], [[1, 1], [1, 6], [3, 3]]
    result = sweep_cdt.triangulate([], polygons=[[outline, hole]])
    values = slope(*result.points.T)
    sides = np.concatenate([np.stack([c, np.roll(c, -1)], axis=1) for c in result.boundary()])
    places = np.concatenate([result.points, result.points[sides].mean(axis=1)])
    assert result.interpolate(values, places).tolist() == slope(*places.T).tolist()
    assert exact.turn(*exact.integers(hole)) < 0 and np.isnan(result.interpolate(values, [np.mean(hole, axis=0)])).all()
