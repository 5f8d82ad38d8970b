"""Tables with and without names, in every order of their columns: as frames, and as files of the command."""

import json
import subprocess

import hypothesis
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweep_cdt

# Names of x, of y, and of heights, as people write them.
PAIRS = [("x", "y"), ("X", "Y"), ("Point_X", "Point_Y"), ("Easting", "Northing"), ("lon", "lat"), ("E", "N")]
PAIRS += [("x (m)", "y (m)"), ("east_ft", "north_ft"), ("xcoord", "ycoord"), ("LNG", "LATITUDE")]
HEIGHTS = ["z", "elev", "ELEV_M", "Height", "alt [ft]", "hoehe"]
OTHERS = ["id", "girth", "code", "t"]
# Files last for a test; each example writes its own over them.
shared = hypothesis.settings(suppress_health_check=[hypothesis.HealthCheck.function_scoped_fixture])


@st.composite
def tables(draw):
    """A table as columns in an order, with the names of x, y and perhaps z among them."""
    x, y = draw(st.sampled_from(PAIRS))
    z = draw(st.sampled_from([*HEIGHTS, None]))
    others = draw(st.lists(st.sampled_from(OTHERS), unique=True, max_size=3))
    names = draw(st.permutations([x, y, *others, *([] if z is None else [z])]))
    count = draw(st.integers(3, 6))
    numbers = st.lists(st.integers(0, 99), min_size=count, max_size=count)
    return {name: draw(numbers) for name in names}, x, y, z


def frames(columns):
    """The table in all libraries that are there."""
    for library, make in (
        ("pandas", lambda pandas: pandas.DataFrame(columns)),
        ("pandas", lambda pandas: pandas.DataFrame(columns).convert_dtypes()),
        ("polars", lambda polars: polars.DataFrame(columns)),
        ("pyarrow", lambda pyarrow: pyarrow.table(columns)),
        ("numpy", lambda numpy: numpy.rec.fromarrays(list(columns.values()), names=list(columns))),
        ("numpy", lambda numpy: numpy.rec.fromarrays(list(columns.values()), names=list(columns)).view(numpy.ndarray)),
    ):
        try:
            yield make(pytest.importorskip(library))
        except pytest.skip.Exception:
            continue


@given(tables())
def test_names_tell_the_columns(table):
    columns, x, y, z = table
    plain = sweep_cdt.triangulate(np.column_stack([columns[x], columns[y]]))
    wanted = None
    if z is not None:
        first = {v: of for v, of in plain.duplicates.tolist()}
        wanted = [columns[z][first.get(v, v)] for v in range(len(columns[z]))]
    for frame in frames(columns):
        result = sweep_cdt.triangulate(frame)
        assert result.points.tolist() == plain.points.tolist()
        assert (None if result.heights is None else result.heights.tolist()) == wanted
        assert sweep_cdt.verify(frame, plain)
        places = plain.find_simplex(frame)
        assert places.tolist() == plain.find_simplex(plain.points).tolist()


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["number", "height"], "there is `height` but no `x` and no `y`"),
        (["number", "easting"], "there is `easting` but no `northing`"),
    ],
)
def test_half_a_pair_of_names_is_refused(names, message):
    hill = sweep_cdt.triangulate([[0, 0], [4, 0], [0, 4]])
    for frame in frames({name: [1, 2, 3] for name in names}):
        for call in (sweep_cdt.triangulate, hill.find_simplex, lambda frame: hill.interpolate([1, 2, 3], frame)):
            with pytest.raises(sweep_cdt.Error, match=message):
                call(frame)


def test_a_field_that_is_masked_is_refused():
    fields = np.array([(0, 0, 1.5), (4, 0, 2.5), (0, 4, 3.5)], dtype=[("x", "f8"), ("y", "i4"), ("z", "f4")])
    assert sweep_cdt.triangulate(fields).heights.tolist() == [1.5, 2.5, 3.5]
    mask = np.zeros(3, dtype=[("x", bool), ("y", bool), ("z", bool)])
    mask["z"][0] = True
    assert np.isnan(sweep_cdt.triangulate(np.ma.array(fields, mask=mask)).heights).tolist() == [True, False, False]
    mask["y"][1] = True
    with pytest.raises(sweep_cdt.KindError, match=r"points\[1, 1\] is masked or missing"):
        sweep_cdt.triangulate(np.ma.array(fields, mask=mask))


def test_heights_are_asked_for_by_their_name():
    columns = {"x": [0, 4, 0], "z": [1, 1, 1], "y": [0, 0, 4], "level": [7, 8, 9]}
    for frame in frames(columns):
        assert sweep_cdt.triangulate(frame, height_property="level").heights.tolist() == [7, 8, 9]
        with pytest.warns(sweep_cdt.RemarkWarning, match="no property or column with heights is called `depth`"):
            assert sweep_cdt.triangulate(frame, height_property="depth").heights is None
    with pytest.warns(sweep_cdt.RemarkWarning, match="is called `level`"):
        sweep_cdt.triangulate([[0, 0], [4, 0], [0, 4]], height_property="level")
    shapely = pytest.importorskip("shapely")
    shapes = [shapely.Point(0, 0, 5), shapely.box(1, 1, 2, 2), shapely.Point(3, 0)]
    collection = {"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"level": level, "z": 1}, "geometry": shape.__geo_interface__}
        for shape, level in zip(shapes, [7, 8, 9])
    ]}  # fmt: skip
    given = [collection, [collection]]
    try:
        import geopandas

        given.append(geopandas.GeoDataFrame({"level": [7, 8, 9], "z": [1, 1, 1]}, geometry=shapes))
    except ImportError:
        pass
    for shape in given:
        with pytest.warns(sweep_cdt.RemarkWarning, match="heights are the property `level` of 3 features"):
            found = sweep_cdt.triangulate(shape, height_property="level")
        heights = dict(zip(map(tuple, found.points.tolist()), found.heights.tolist()))
        assert heights == {(0, 0): 7, (3, 0): 9, **{(x, y): 8 for x in (1, 2) for y in (1, 2)}}


@shared
@given(table=tables())
def test_the_command_reads_the_same(command, tmp_path, table):
    pytest.importorskip("pandas")
    columns, *_ = table
    frame = next(frames(columns))
    frame.to_csv(tmp_path / "table.csv", index=False)
    read, _ = read_by(command, tmp_path)
    result = sweep_cdt.triangulate(frame)
    assert [p[:2] for p in read["points"]] == result.points.tolist()
    if result.heights is not None:
        # The command writes what the table says of points that equal others, too, though it does not count.
        equal = set(result.duplicates[:, 0].tolist())
        heights = enumerate(zip(read["points"], result.heights))
        assert all(v in equal or place[2] == height for v, (place, height) in heights)


@shared
@given(table=tables(), data=st.data())
def test_without_names_columns_are_chosen(command, tmp_path, table, data):
    """Three columns are x, y and z. Of more the command says which it takes, and others can be chosen."""
    pandas = pytest.importorskip("pandas")
    columns, *_ = table
    pandas.DataFrame(columns).to_csv(tmp_path / "table.csv", index=False, header=False)
    frame = pandas.read_csv(tmp_path / "table.csv", header=None)
    x, y, *_ = chosen = data.draw(st.permutations(range(len(columns))))
    result = sweep_cdt.triangulate(frame[[x, y]])
    asked = [str(place + 1) for place in chosen[:2]]
    read, said = read_by(command, tmp_path, "--columns", ",".join(asked))
    assert [p[:2] for p in read["points"]] == result.points.tolist() == frame[[x, y]].to_numpy().tolist()
    assert "none has a name" not in said
    if len(columns) == 2:
        assert sweep_cdt.triangulate(frame).points.tolist() == frame.to_numpy().tolist()
        return
    with pytest.raises(sweep_cdt.ShapeError, match="name two of its columns x and y"):
        sweep_cdt.triangulate(frame)
    read, said = read_by(command, tmp_path)
    assert [p[:2] for p in read["points"]] == frame[[0, 1]].to_numpy().tolist()
    words = f"x is column 1, y is column 2, z is column 3 of {len(columns)}: none has a name"
    assert (words in said) == (len(columns) > 3)


def read_by(command, folder, *options):
    """The points that the command reads, as it writes them, and what it says."""
    options = [*options, "-o", "read.json"]
    ran = subprocess.run([command, "triangulate", "table.csv", *options], cwd=folder, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return json.loads((folder / "read.json").read_text()), ran.stderr


def test_names_that_tell_too_much():
    pandas = pytest.importorskip("pandas")
    rows = [[0, 0, 1, 9], [4, 0, 2, 9], [0, 4, 3, 9]]
    with pytest.raises(sweep_cdt.Error, match="the columns `x` and `X` may both be x: rename one"):
        sweep_cdt.triangulate(pandas.DataFrame(rows, columns=["x", "y", "z", "X"]))
    # What is called so is better than what has a unit, and attributes that are given count before a column.
    frame = pandas.DataFrame(rows, columns=["y", "x", "z", "x_ft"])
    assert sweep_cdt.triangulate(frame).points.tolist() == [[0, 0], [0, 4], [4, 0]]
    given = {"vertices": frame, "vertex_attributes": [[5], [6], [7]]}
    assert sweep_cdt.triangulate(given).heights.tolist() == [5, 6, 7]
    gap = sweep_cdt.triangulate(frame.assign(z=[1, None, 3]))
    assert np.array_equal(gap.heights, [1, np.nan, 3], equal_nan=True)
    # Edges have no places.
    edges = pandas.DataFrame({"y": [0], "x": [1]})
    assert sweep_cdt.triangulate(frame, edges).edges.tolist() == [[0, 1]]
