"""Two workers of Dask on this machine give the triangles in memory."""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

dask_distributed = pytest.importorskip("dask.distributed")
pytest.importorskip("dask.dataframe")

import sweep_cdt
from sweep_cdt import distributed


@pytest.fixture(scope="module")
def client():
    workers = dask_distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
    )
    with workers as cluster, dask_distributed.Client(cluster) as client:
        yield client


def sorted_rows(triangles):
    """Each triangle from its least corner on, in order."""
    triangles = np.asarray(triangles, np.int64)
    first = triangles.argmin(axis=1)[:, None]
    turned = np.take_along_axis(triangles, (first + np.arange(3)) % 3, axis=1)
    return turned[np.lexsort(turned.T[::-1])]


def read(files):
    """The triangles of all files."""
    tables = [np.fromfile(file, f"<u{int(file.suffix[2:]) // 8}") for file in files]
    return sorted_rows(np.concatenate(tables).reshape(-1, 3))


def some_edges(points, rng):
    """A fifth of the sides of a triangulation, and a fan of long edges that pierces the others' gaps."""
    sides = sweep_cdt.triangulate(points).triangles[:, :2]
    chosen = sides[rng.random(len(sides)) < 0.2]
    return np.concatenate([chosen, chosen[:3, ::-1], [[0, 0]]]).astype("<u8")


def long_edges(count):
    """Points at the ends of edges that cross no other: each leads from the lowest band to the highest one."""
    x = np.arange(count, dtype=float)
    points = np.concatenate([np.stack([x, np.zeros(count)], 1), np.stack([x + 0.5, np.full(count, 9.0)], 1)])
    points = np.concatenate([points, np.stack([x[:-1] + 0.75, 1.0 + x[:-1] % 7], 1)])
    return points, np.stack([np.arange(count), np.arange(count) + count], 1).astype("<u8")


RNG = np.random.default_rng(58)
CLOUDS = {
    "uniform": RNG.random((3000, 2)),
    # Many points of one y, and points twice.
    "lattice": RNG.integers(0, 40, (3000, 2)).astype(float),
    "rows": np.stack([RNG.random(900) - 0.5, RNG.integers(0, 3, 900) * -0.0], axis=1),
    "clusters": np.concatenate([RNG.normal(k, 1e-3 * 10.0**k, (500, 2)) for k in range(4)]),
    "circle": np.stack([np.cos(np.arange(600.0)), np.sin(np.arange(600.0))], axis=1),
    "one point": np.zeros((1, 2)),
}


@pytest.mark.parametrize("band", [90, 1000])
@pytest.mark.parametrize("kind", CLOUDS)
def test_the_triangles_are_those_in_memory(client, tmp_path, kind, band):
    points = CLOUDS[kind]
    edges = some_edges(points, RNG) if len(points) > 1 else np.empty((0, 2), "<u8")
    # Two files, of which the first one ends in the middle of a piece.
    begin = len(points) // 3
    points[:begin].astype("<f8").tofile(tmp_path / "a.f64")
    points[begin:].astype("<f8").tofile(tmp_path / "b.f64")
    edges.tofile(tmp_path / "edges.u64")
    files = distributed.triangulate(
        [tmp_path / "a.f64", tmp_path / "b.f64"],
        edges=tmp_path / "edges.u64",
        folder=tmp_path / "out",
        band=band,
        client=client,
    )
    whole = sweep_cdt.triangulate(points, edges.astype(int))
    np.testing.assert_array_equal(read(files), sorted_rows(whole.triangles))
    assert len(files) > 1 or len(points) < 2 * band or kind == "rows"


def test_edges_that_pass_bands(client, tmp_path):
    points, edges = long_edges(200)
    points.astype("<f8").tofile(tmp_path / "points.f64")
    edges.tofile(tmp_path / "edges.u64")
    files = distributed.triangulate(
        tmp_path / "points.f64", edges=tmp_path / "edges.u64", folder=tmp_path / "out", band=50, client=client
    )
    whole = sweep_cdt.triangulate(points, edges.astype(int))
    np.testing.assert_array_equal(read(files), sorted_rows(whole.triangles))


def test_bands_of_the_command(client, tmp_path, command):
    points, edges = CLOUDS["clusters"], some_edges(CLOUDS["clusters"], RNG)
    points.astype("<f8").tofile(tmp_path / "points.f64")
    edges.tofile(tmp_path / "edges.u64")
    subprocess.run(
        [command, "stream", "points.f64", "--edges", "edges.u64", "--band", "300", "-o", "bands"],
        cwd=tmp_path,
        check=True,
    )
    bands = sorted((tmp_path / "bands").iterdir())
    assert len(bands) == 7
    files = distributed.join(bands, folder=tmp_path / "out", client=client)
    whole = sweep_cdt.triangulate(points, edges.astype(int))
    np.testing.assert_array_equal(read(files), sorted_rows(whole.triangles))
    with pytest.raises(sweep_cdt.Error, match="next one begins"):
        distributed.join(bands[:2] + bands[3:], folder=tmp_path / "gap", client=client)
    bands[1].write_bytes(bands[1].read_bytes()[:-9] + b"\1" + bands[1].read_bytes()[-8:])
    with pytest.raises(sweep_cdt.Error):
        distributed.join(bands, folder=tmp_path / "damaged", client=client)


def test_snakemake_and_slurm_run_the_command(tmp_path, command):
    """The files of `examples/bands`, under Snakemake and under a stand-in for Slurm that runs each task at once."""
    examples = pathlib.Path(__file__).resolve().parents[3] / "examples/bands"
    snakemake = pathlib.Path(sys.executable).with_name("snakemake")
    if not snakemake.exists():
        pytest.skip("Snakemake is not installed")
    tools = tmp_path / "tools"
    tools.mkdir()
    (tools / "sweep-cdt").symlink_to(pathlib.Path(command).absolute())
    (tools / "sbatch").write_text(
        """#!/bin/sh
        for last; do :; done
        case "$*" in
            *--array=*) for k in $(seq $(ls bands | wc -l)); do SLURM_ARRAY_TASK_ID=$k sh -ec "$last"; done; echo 7 ;;
            *--dependency=afterok:7*) sh -ec "$last" ;;
        esac
        """
    )
    (tools / "sbatch").chmod(0o755)
    points = RNG.random((3000, 2))
    runs = {"slurm": ["sh", examples / "slurm.sh", "points.f64", "400"]}
    runs["snakemake"] = [snakemake, "-s", examples / "Snakefile", "--cores", "1", "--config", "size=400"]
    for name, run in runs.items():
        (tmp_path / name).mkdir()
        points.tofile(tmp_path / name / "points.f64")
        path = f"{tools}{os.pathsep}{os.environ['PATH']}"
        subprocess.run(run, cwd=tmp_path / name, check=True, env=os.environ | {"PATH": path}, capture_output=True)
        whole = sorted_rows(sweep_cdt.triangulate(points).triangles)
        np.testing.assert_array_equal(read([tmp_path / name / "triangles.u32"]), whole)


def test_a_worker_is_killed_twice(client, tmp_path):
    points = np.random.default_rng(1).random((200_000, 2))
    points.astype("<f8").tofile(tmp_path / "points.f64")
    out, killed = tmp_path / "out", []

    def kill():
        for count in (2, 15):
            while len(list(tmp_path.glob(".out.*/[0-9]*"))) < count:
                time.sleep(0.01)
            worker = next(iter(client.run(os.getpid).values()))
            os.kill(worker, signal.SIGKILL)
            killed.append(worker)

    killer = threading.Thread(target=kill)
    killer.start()
    files = distributed.triangulate(tmp_path / "points.f64", folder=out, band=5000, client=client)
    killer.join()
    assert len(set(killed)) == 2
    np.testing.assert_array_equal(read(files), sorted_rows(sweep_cdt.triangulate(points).triangles))
    assert sorted(out.iterdir()) == files
    assert not list(tmp_path.glob(".out.*"))


def test_what_is_refused(client, tmp_path):
    points, edges, out = tmp_path / "points.f64", tmp_path / "edges.u64", tmp_path / "out"
    square = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
    square.tofile(points)

    def run(*, of=points, band=2):
        return distributed.triangulate(of, edges=edges, folder=out, band=band, client=client)

    np.array([[0, 1], [0, 4]], "<u8").tofile(edges)
    with pytest.raises(sweep_cdt.EdgeOutOfRangeError, match="edge 1 ends at vertex 4") as refused:
        run()
    assert (refused.value.edge, refused.value.vertex) == (1, 4)
    np.array([[0, 2], [1, 3]], "<u8").tofile(edges)
    with pytest.raises(sweep_cdt.CrossingEdgesError, match="cross") as refused:
        run()
    assert sorted(refused.value.edges) == [0, 1]
    edges.write_bytes(b"12345678")
    with pytest.raises(sweep_cdt.ShapeError, match="8 bytes too long"):
        run()
    np.array([[0, 1]], "<u8").tofile(edges)
    np.array([[0.0, 1.0], [2.0, np.nan]]).tofile(points)
    with pytest.raises(sweep_cdt.NonFiniteError) as refused:
        run(band=1)
    assert (refused.value.vertex, refused.value.axis) == (1, 1)
    with pytest.raises(sweep_cdt.Error, match="at least one point"):
        run(band=0)
    points.write_bytes(b"")
    with pytest.raises(sweep_cdt.Error, match="no points in them"):
        run()
    with pytest.raises(sweep_cdt.Error, match="no files"):
        run(of=[])
    with pytest.raises(sweep_cdt.Error, match="stream .*points.csv --band"):
        run(of="points.csv")
    with pytest.raises(sweep_cdt.Error, match="no bands"):
        distributed.join([], folder=out, client=client)
    # Nothing is left of all these runs.
    assert sorted(path.name for path in tmp_path.iterdir()) == ["edges.u64", "points.f64"]
    square.tofile(points)
    out.mkdir()
    (out / "0.u32").touch()
    with pytest.raises(sweep_cdt.Error, match="not empty"):
        run()
