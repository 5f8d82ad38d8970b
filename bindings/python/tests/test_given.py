"""What is handed in: masks, nullable columns and frames in every argument, and geometries in every wrapping.

Each form has the meaning of the plain array or list that it stands for; what is no number is refused by name, or
missing.
"""

import decimal
import pathlib
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as npst
from test_properties import JUNK, ends_well

import sweep_cdt

SQUARE = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
RING = [[0, 1], [1, 2], [2, 3], [3, 0]]
TRIANGLES = [[0, 1, 2], [0, 2, 3]]
HILL = sweep_cdt.triangulate([*SQUARE, [2.0, 1.0]])
# Each argument that must have its numbers: the name in messages, an array that is taken, and a call.
NEEDED = {
    "points": (SQUARE, sweep_cdt.triangulate),
    "edges": (np.array(RING), lambda given: sweep_cdt.triangulate(SQUARE, given)),
    "holes": (np.array([[2.0, 1.0], [1.0, 2.0]]), lambda given: sweep_cdt.triangulate(SQUARE, RING, holes=given)),
    "polygons[0][0]": (SQUARE, lambda given: sweep_cdt.triangulate([], polygons=[[given]])),
    "polygons[0][1]": (np.arange(4), lambda given: sweep_cdt.triangulate(SQUARE, polygons=[[[0, 1, 2], given]])),
    "regions": (np.ones((1, 4)), lambda given: sweep_cdt.triangulate({"vertices": SQUARE, "regions": given})),
    "simplices": (np.array(TRIANGLES), lambda given: sweep_cdt.verify(SQUARE, given)),
    "triangles": (np.array(TRIANGLES), lambda given: sweep_cdt.verify({"vertices": SQUARE, "triangles": given})),
}  # fmt: skip


def masks(shape):
    return npst.arrays(bool, shape, elements=st.booleans())


@pytest.mark.parametrize("name", NEEDED)
@given(data=st.data())
def test_a_masked_number_is_refused_where_it_is_needed(name, data):
    array, call = NEEDED[name]
    mask = data.draw(masks(array.shape))
    forms = [np.ma.array(array, mask=mask)]
    if array.ndim == 2:
        forms.append([np.ma.array(row, mask=of_row) for row, of_row in zip(array, mask)])
    for form in forms:
        if not mask.any():
            call(form)
            continue
        with pytest.raises(sweep_cdt.KindError, match="masked or missing") as caught:
            call(form)
        position = tuple(np.argwhere(mask)[0].tolist())
        assert caught.value.position == position
        assert str(caught.value).startswith(f"{name}[{', '.join(map(str, position))}] ")


@given(masks(5), masks((3, 2)))
def test_masked_values_and_places_are_missing(of_values, of_places):
    values, places = np.arange(5.0), np.array([[2.0, 1.0], [1.0, 0.5], [4.0, 2.0]])
    gaps = np.where(of_values, np.nan, values)
    wanted = HILL.interpolate(gaps, np.where(of_places, np.nan, places))
    masked = np.ma.array(values, mask=of_values), np.ma.array(places, mask=of_places)
    assert np.array_equal(HILL.interpolate(*masked), wanted, equal_nan=True)
    x, y = masked[1].T
    assert np.array_equal(HILL.interpolate(gaps, (x, y)), wanted, equal_nan=True)
    exactly = np.ma.array([[Fraction(c) for c in p] for p in places.tolist()], mask=of_places)
    assert np.array_equal(HILL.interpolate(gaps, exactly), wanted, equal_nan=True)
    held = HILL.find_simplex(masked[1]) >= 0
    assert held.tolist() == (~of_places.any(axis=1)).tolist()
    options = [None if gap else value for gap, value in zip(of_values, values.tolist())]
    assert np.array_equal(HILL.interpolate(options, places), HILL.interpolate(gaps, places), equal_nan=True)


def nullable(pandas):
    """Types of columns that can hold NA."""
    names = ["Float64", "Float32", "Int64", "Int16", "UInt8"]
    try:
        import pyarrow  # noqa: F401
    except ImportError:
        return names
    return [*names, "float64[pyarrow]", "int32[pyarrow]"]


@given(st.data())
def test_nullable_columns_are_doubles(data):
    pandas = pytest.importorskip("pandas")
    kinds = st.sampled_from(nullable(pandas))
    cells = st.one_of(st.integers(0, 100), st.none()) if data.draw(st.booleans()) else st.integers(0, 100)
    rows = data.draw(st.lists(st.tuples(cells, cells), min_size=1, max_size=12))
    frame = pandas.DataFrame(rows, columns=["x", "y"], dtype=object)
    frame = frame.astype({"x": data.draw(kinds), "y": data.draw(kinds)})
    gaps = [(v, axis) for v, row in enumerate(rows) for axis, cell in enumerate(row) if cell is None]
    values = np.array([[np.nan if cell is None else cell for cell in row] for row in rows])
    places = sweep_cdt.triangulate(np.random.default_rng(1).random((len(rows), 2)))
    if len(places.simplices):
        middle = places.points[places.simplices[0]].mean(axis=0)
        for given, plain in ((frame, values), (frame.x, values[:, 0]), (frame.y.array, values[:, 1])):
            found = places.interpolate(given, middle)
            assert np.array_equal(found, places.interpolate(plain, middle), equal_nan=True)
    if gaps:
        with pytest.raises(sweep_cdt.KindError) as caught:
            sweep_cdt.triangulate(frame)
        assert caught.value.position == gaps[0]
    else:
        result = sweep_cdt.triangulate(frame)
        assert result.points.dtype == float and result.points.tolist() == values.tolist()


def test_edges_and_triangles_of_nullable_columns():
    pandas = pytest.importorskip("pandas")
    ring = pandas.DataFrame(RING).convert_dtypes()
    assert sweep_cdt.triangulate(SQUARE, ring).edges.tolist() == RING
    assert sweep_cdt.verify(SQUARE, pandas.DataFrame(TRIANGLES).convert_dtypes())
    with pytest.raises(sweep_cdt.KindError) as caught:
        sweep_cdt.triangulate(SQUARE, ring.mask(ring == 3))
    assert caught.value.position == (2, 1)


def test_whole_numbers_beside_doubles_are_not_rounded():
    big = 2**60
    rows = [[0.5, big], [0.5, big + 1], [1.5, big]]
    frames = [
        lambda: pytest.importorskip("pandas").DataFrame(rows),
        lambda: pytest.importorskip("pandas").DataFrame(rows).convert_dtypes(),
    ]
    frames += [lambda: pytest.importorskip("polars").DataFrame(rows, orient="row")]
    frames += [lambda: pytest.importorskip("pyarrow").table(dict(zip("xy", zip(*rows))))]
    made = []
    for frame in frames:
        try:
            made.append(frame())
        except pytest.skip.Exception:
            continue
    for form in [rows, *made]:
        assert sweep_cdt.triangulate(form).points.tolist() == rows, type(form)


def test_a_row_that_is_masked_is_refused():
    with pytest.raises(sweep_cdt.ShapeError, match=r"points\[4\] is no pair"):
        sweep_cdt.triangulate([*SQUARE, np.ma.masked])
    room = sweep_cdt.DynamicTriangulation(SQUARE)
    for numbers in (np.ma.array([0, 1], mask=[0, 1]), [0, np.ma.masked], [0, None]):
        with pytest.raises(sweep_cdt.KindError, match="remove_points"):
            room.remove(numbers)
    assert len(room.points) == 4


def test_a_column_of_objects():
    pandas = pytest.importorskip("pandas")
    rows = [[0.5, 0], [1, 0.25], [np.float64(0.1), np.int64(7)]]
    result = sweep_cdt.triangulate(pandas.DataFrame(rows, columns=["x", "y"], dtype=object))
    assert result.points.dtype == float and result.points.tolist() == rows
    with pytest.raises(sweep_cdt.KindError, match=r"points\[1, 1\] is masked or missing"):
        sweep_cdt.triangulate(pandas.DataFrame([[0, 1], [1, None]], dtype=object))
    with pytest.raises(sweep_cdt.KindError, match=r"points\[0, 0\] is no number but of the type bool"):
        sweep_cdt.triangulate(pandas.DataFrame({"x": [True, False], "y": [0, 1]}))


def test_decimals_of_a_column():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"x": [decimal.Decimal("0.1"), decimal.Decimal(1)], "y": [0, 1]})
    assert sweep_cdt.triangulate(frame).points[0, 0] == Fraction(1, 10)


@pytest.mark.parametrize("values", ["abcde", ["a"] * 5, [1j] * 5, 7, None, [[1]] * 4, [1, 2, 3, 4, "x"]])
def test_values_that_are_no_numbers(values):
    with pytest.raises(sweep_cdt.Error, match="values"):
        HILL.interpolate(values, [[1, 1]])


# Geometries.


SQUARE_OF_3 = [(0, 0), (3, 0), (3, 3), (0, 3)]
# For each kind of a part its rings or other places, how many points and edges it has, and its area.
KINDS = {
    "point": ([[(0, 0)]], (1, 0), 0),
    "line": ([[(0, 0), (1, 2), (2, 1)]], (3, 2), 0),
    "ring": ([[(0, 0), (2, 0), (0, 2)]], (3, 3), 0),
    "polygon": ([SQUARE_OF_3], (4, 4), 9),
    "holed": ([SQUARE_OF_3, [(1, 1), (1, 2), (2, 1)]], (7, 7), 8.5),
}


def parts():
    """Parts of features: by a name and places, none of which touch those of another feature."""
    return st.lists(st.lists(st.sampled_from(sorted(KINDS)), max_size=3), min_size=1, max_size=4)


def features_of(shapely, kinds, z=None):
    """A geometry for each list of kinds: `None` or an empty one, a part, a part of several of its kind, or a collection."""
    make = {"point": lambda p: shapely.Point(p[0]), "line": shapely.LineString, "ring": shapely.LinearRing}
    of_many = {"point": shapely.MultiPoint, "polygon": shapely.MultiPolygon, "holed": shapely.MultiPolygon}
    features, x = [], 0
    for place, parts in enumerate(kinds):
        made = []
        for kind in parts:
            rings = [[(x + a, b) if z is None else (x + a, b, z(x + a, b)) for a, b in r] for r in KINDS[kind][0]]
            made.append(make.get(kind, shapely.Polygon)(rings[0], *([rings[1:]] if len(rings) > 1 else [])))
            x += 5
        if not made:
            features.append([None, shapely.Point(), shapely.Polygon(), shapely.GeometryCollection()][place % 4])
        elif len(made) == 1:
            features.append(made[0])
        elif len(set(parts)) == 1:
            features.append(of_many.get(parts[0], shapely.MultiLineString)(made))
        else:
            features.append(shapely.GeometryCollection([shapely.GeometryCollection(made[:1]), *made[1:]]))
    return features


def wrappings(shapely, features):
    """The features in all forms in which libraries hand them over."""
    import geopandas
    import pandas

    class Own(geopandas.GeoDataFrame):
        pass

    class Document:
        def __init__(self, geometry):
            self.__geo_interface__ = geometry.__geo_interface__

    series = geopandas.GeoSeries(features)
    array = series.to_numpy()
    yield from (series, series.values, array, series.tolist(), tuple(features), iter(features), (g for g in features))
    yield from (pandas.Series(array), pandas.DataFrame({"geometry": array}), geopandas.GeoDataFrame(geometry=series))
    # A column of another name, and what pandas has where a geometry is missing.
    yield pandas.DataFrame({"name": "a", "shape": array, "x": 1})
    yield [float("nan") if g is None else g for g in features]
    yield [pandas.NA if g is None else g for g in features]
    yield from (
        Own(geometry=series).rename_geometry("shape"),
        series.__geo_interface__,
        [series, geopandas.GeoSeries([])],
        np.array([array]),
    )
    yield [None if g is None else g.__geo_interface__ for g in features]
    yield [None if g is None else Document(g) for g in features]
    if all(features):
        # A collection in a collection is one feature.
        yield shapely.GeometryCollection(features).geoms


@given(parts())
def test_a_wrapping_changes_nothing(kinds):
    pytest.importorskip("geopandas")
    import shapely

    features = features_of(shapely, kinds)
    if not any(features):
        return
    wanted = sweep_cdt.triangulate(features)
    whole = [KINDS[kind] for of_feature in kinds for kind in of_feature]
    assert [len(wanted.points), len(wanted.edges)] == np.sum([counts for _, counts, _ in whole], axis=0).tolist()
    assert wanted.area == sum(area for *_, area in whole) or wanted.rule == "hull"
    for form in wrappings(shapely, features):
        result = sweep_cdt.triangulate(form)
        assert result.points.tolist() == wanted.points.tolist(), type(form)
        assert result.edges.tolist() == wanted.edges.tolist() and result.rule == wanted.rule
        if wanted.region is not None:
            assert result.region.tolist() == wanted.region.tolist(), type(form)
            owners = {n for n, of_feature in enumerate(kinds) if any(KINDS[kind][2] for kind in of_feature)}
            assert set(result.region[result.inside].tolist()) == owners


def test_polygons_seeds_and_places_may_be_geometries():
    pytest.importorskip("geopandas")
    import geopandas
    import shapely

    squares = geopandas.GeoSeries(
        [shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(3, 0, 4, 1)]), shapely.box(1, 0, 2, 1)]
    )
    result = sweep_cdt.triangulate([[9, 9]], polygons=squares.set_crs(2056))
    assert result.crs.to_epsg() == 2056
    assert result.area == 3 and sorted(result.region[result.inside].tolist()) == [0, 0, 0, 0, 1, 1]
    without = sweep_cdt.triangulate(SQUARE, RING, holes=geopandas.GeoSeries([shapely.Point(2, 1)]))
    assert without.area == 0
    places = geopandas.GeoSeries([None, shapely.Point(), shapely.Point(2, 1), shapely.Point(9, 9)])
    assert (HILL.find_simplex(places) >= 0).tolist() == [False, False, True, False]
    found = HILL.interpolate([0, 0, 0, 0, 8], places)
    assert np.array_equal(found, [np.nan, np.nan, 8, np.nan], equal_nan=True)
    with pytest.raises(sweep_cdt.KindError, match=r"xi\[0\] is no point but a Polygon"):
        HILL.find_simplex(squares[1:])


@pytest.mark.parametrize(
    "wrong",
    [
        {"type": "Feature"},
        {"type": "Polygon", "coordinates": [[0, 1]]},
        {"type": "FeatureCollection", "features": [1]},
        {"type": "Point", "coordinates": "ab"},
        {"type": "Curve", "coordinates": []},
    ],
)
def test_wrong_documents(wrong):
    pytest.importorskip("shapely")
    with pytest.raises(sweep_cdt.KindError, match="GeoJSON"):
        sweep_cdt.triangulate(wrong)


@given(JUNK)
def test_every_document_ends_well(junk):
    pytest.importorskip("shapely")
    for kind, member in (("FeatureCollection", "features"), ("Feature", "geometry"), ("Polygon", "coordinates")):
        ends_well(lambda: sweep_cdt.triangulate({"type": kind, member: junk}))


def test_what_is_among_geometries():
    shapely = pytest.importorskip("shapely")
    pandas = pytest.importorskip("pandas")
    text, shapes = "POINT (0 0)", [shapely.Point(0, 0)]
    for form in (text, [text], pandas.Series([text]), pandas.DataFrame({"geometry": [text]})):
        with pytest.raises(sweep_cdt.KindError, match=r"shapely\.from_wkt"):
            sweep_cdt.triangulate(form)
    for form in (shapes[0].wkb, [shapes[0].wkb]):
        with pytest.raises(sweep_cdt.KindError, match=r"shapely\.from_wkb"):
            sweep_cdt.triangulate(form)
    with pytest.raises(sweep_cdt.KindError, match="PosixPath|WindowsPath"):
        sweep_cdt.triangulate(pathlib.Path("map.geojson"))
    with pytest.raises(sweep_cdt.KindError, match="edges has geometries, and no positions"):
        sweep_cdt.triangulate(SQUARE, shapes)
    with pytest.raises(sweep_cdt.KindError, match="several columns of geometries"):
        sweep_cdt.triangulate(pandas.DataFrame({"a": shapes, "b": shapes}))
    with pytest.raises(sweep_cdt.KindError, match="values is None"):
        HILL.interpolate(HILL.heights, [[1, 1]])
    with pytest.raises(sweep_cdt.KindError, match=r"points\[1\] is no geometry but of the type list"):
        sweep_cdt.triangulate([shapely.Point(0, 0), [1, 2]])


def test_errors_name_the_place_and_the_feature():
    shapely = pytest.importorskip("shapely")
    lines = [None, shapely.LineString([(0, 0), (4, 4)]), shapely.LineString([(0, 4), (4, 0)])]
    with pytest.raises(sweep_cdt.CrossingEdgesError, match=r"at \(2.0, 2.0\), of geometries 1 and 2") as caught:
        sweep_cdt.triangulate(lines)
    assert caught.value.place == (2, 2) and caught.value.features == (1, 2)
    with pytest.raises(sweep_cdt.OpenRingError, match=r"at \(0.0, 0.0\), of geometry 1") as caught:
        sweep_cdt.triangulate(lines[:2], inside="even-odd")
    assert caught.value.place == (0, 0) and caught.value.feature == 1
    with np.errstate(invalid="ignore"):
        broken = shapely.from_wkt("LINESTRING (0 0, 1 nan)")
    with pytest.raises(sweep_cdt.NonFiniteError, match="a coordinate of geometry 1 is nan") as caught:
        sweep_cdt.triangulate([shapely.Point(5, 5), broken])
    assert caught.value.feature == 1
    shifted = (SQUARE + 2).tolist()
    with pytest.raises(sweep_cdt.CrossingEdgesError, match=r"at \(4.0, 2.0\), of polygons 0 and 1"):
        sweep_cdt.triangulate([], polygons=[[SQUARE], [shifted]])
    with pytest.raises(sweep_cdt.CrossingEdgesError, match=r"at \(0.5, 0.5\)"):
        sweep_cdt.triangulate([[0, 0], [1, 0], [1, 1], [0, Fraction(1)]], [[0, 2], [1, 3]])
