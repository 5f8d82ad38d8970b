"""The command gives the same: triangles, what is inside, refusals, and verdicts."""

import json
import pathlib
import struct
import subprocess

import hypothesis
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_properties import NEAR, RATIONAL, SMALL, inputs

import sweep_cdt

HARD = pathlib.Path(__file__).resolve().parents[3] / "tests/data/hard.jsonl"
RULES = ["hull", "even-odd", "nonzero", "positive", "at-least-2", "holes"]
# Files last for a test; each example writes its own over them.
shared = hypothesis.settings(suppress_health_check=[hypothesis.HealthCheck.function_scoped_fixture])


class Files:
    """The command, and a folder for what it reads and writes."""

    def __init__(self, command, folder):
        self.command, self.folder = command, folder

    def run(self, *arguments):
        return subprocess.run([self.command, *arguments], cwd=self.folder, capture_output=True, text=True)

    def write(self, name, **content):
        text = lambda x: str(x) if not isinstance(x, (int, float)) else x
        if "points" in content:
            content["points"] = [[text(x) for x in p] for p in content["points"]]
        (self.folder / name).write_text(json.dumps(content))

    def triangles(self, points, edges, *options):
        """The triangles that the command writes, or `None` if it refuses the input."""
        self.write("in.json", points=points, edges=edges)
        run = self.run("triangulate", "in.json", "-o", "out.json", *options)
        assert run.returncode in (0, 1), run.stderr
        return None if run.returncode else json.loads((self.folder / "out.json").read_text())["triangles"]


@pytest.fixture
def files(command, tmp_path):
    return Files(command, tmp_path)


def ours(points, edges, **options):
    try:
        return sweep_cdt.triangulate(points, edges, **options).canonical().tolist()
    except sweep_cdt.Error:
        return None


def hard_inputs():
    return [json.loads(line) for line in HARD.read_text().splitlines()]


def test_hard_inputs(files):
    for content in hard_inputs():
        points, edges = content["points"], content["edges"]
        if content["expect"] == "nonfinite":
            with pytest.raises(sweep_cdt.Error):
                sweep_cdt.triangulate(np.array(points, dtype=float), edges)
        else:
            assert ours(points, edges) == files.triangles(points, edges), content["name"]


@shared
@given(question=st.one_of(inputs(SMALL), inputs(NEAR), inputs(RATIONAL)), rule=st.sampled_from(RULES))
def test_triangles_and_refusals(files, question, rule):
    points, edges = question
    # A file has fractions if one of its numbers is one.
    assert ours(points, edges, inside=rule) == files.triangles(points, edges, "--inside", rule)


@shared
@given(question=inputs(SMALL))
def test_split_crossings(files, question):
    points, edges = question
    assert ours(points, edges, split_crossings=True) == files.triangles(points, edges, "--split-crossings")


@shared
@given(
    question=st.one_of(inputs(SMALL), inputs(NEAR)),
    triangles=st.lists(st.tuples(*[st.integers(0, 8)] * 3), max_size=8),
    is_own=st.booleans(),
    flips=st.booleans(),
    domain=st.sampled_from(["hull", "even-odd", "holes"]),
    level=st.sampled_from(["tiling", "constrained", "delaunay", "canonical"]),
    max_depth=st.sampled_from([None, 0.0, 1e-12, 0.5]),
)
def test_verdicts(files, question, triangles, is_own, flips, domain, level, max_depth):
    points, edges = question
    if is_own and (own := ours(points, edges, inside=domain)):
        triangles = [t[::-1] for t in own] if flips else own[1:] + triangles[:1]
    files.write("in.json", points=points, edges=edges)
    files.write("result.json", triangles=triangles)
    options = ["--domain", domain, "--level", level, "--limit", "1000"]
    options += [] if max_depth is None else ["--max-depth", repr(max_depth)]
    run = files.run("verify", "in.json", "result.json", "--json", *options)
    try:
        report = sweep_cdt.verify(points, triangles, edges, domain=domain, level=level, max_depth=max_depth)
    except sweep_cdt.Error:
        assert run.returncode == 1 and not run.stdout
        return
    theirs = json.loads(run.stdout)
    assert report.verdict == theirs["verdict"]
    assert (report.reached or "none") == theirs["highest_level"]
    assert report.found == theirs["violations_found"] and report.is_clockwise == theirs["clockwise"]
    assert report.deepest == theirs["depths"]["greatest"]
    assert [str(name) for name in report.violations["name"]] == [v["class"] for v in theirs["violations"]]
    assert [str(m) for m in report.violations["message"]] == [v["message"] for v in theirs["violations"]]
    assert {**report.counts} == theirs["counts"]


def cloud(points, keys):
    """A `.las` of points, in thousandths, with keys of GeoTIFF that name its coordinate system."""
    numbers = struct.pack(f"<{len(keys)}H", *keys)
    record = struct.pack("<2x16sHH32x", b"LASF_Projection", 34735, len(numbers)) + numbers
    head = bytearray(227)
    head[:4] = b"LASF"
    head[24:26] = 1, 2
    struct.pack_into("<HIIBHI", head, 94, 227, 227 + len(record), 1, 0, 20, len(points))
    struct.pack_into("<3d", head, 131, 0.001, 0.001, 0.001)
    return bytes(head) + record + b"".join(struct.pack("<3i8x", *point) for point in points)


@pytest.mark.parametrize(
    ("keys", "system"),
    [([1024, 0, 1, 1, 3072, 0, 1, 25832], 25832), ([1024, 0, 1, 2, 2048, 0, 1, 4258], 4258)],
)
def test_a_grid_of_heights_lies_where_its_cloud_lies(files, keys, system):
    rasterio = pytest.importorskip("rasterio")
    points = [(0, 0, 0), (4000, 0, 4000), (0, 3000, 30_000), (4000, 3000, 34_000)]
    (files.folder / "a.las").write_bytes(cloud(points, [1, 1, 0, 2, *keys]))
    run = files.run("stream", "a.las", "--raster", "a.tif", "--cell", "0.5")
    if "a build" in run.stderr:
        pytest.skip("the command is built without the features las and geotiff")
    assert run.returncode == 0, run.stderr
    with rasterio.open(files.folder / "a.tif") as grid:
        assert grid.crs.to_epsg() == system
        assert grid.tags()["AREA_OR_POINT"] == "Area"
        assert np.isnan(grid.nodata)
        heights, shape = grid.read(1), grid.shape
        places = [grid.xy(row, column) for row in range(shape[0]) for column in range(shape[1])]
    for (x, y), height in zip(places, heights.ravel(), strict=True):
        is_inside = 0 <= x <= 4 and 0 <= y <= 3
        assert height == pytest.approx(x + 10 * y) if is_inside else np.isnan(height), (x, y)
    assert np.isfinite(heights).sum() == 8 * 6
