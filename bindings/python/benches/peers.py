#!/usr/bin/env python3
"""The package beside other libraries for Python, and beside its own call in Rust: from NumPy's arrays to NumPy's arrays.

    python bindings/python/benches/peers.py [--rounds 7] [--only WORD] [--programs NAME...]

runs each program on each data set in processes of its own, in turn with the others. A process times one call, its first
on that data, after a small one: by the time of the processor, so that other work on the machine disturbs less. (All
programs work on one thread.) Medians count, of a program's time and of its share of sweep_cdt's time in the same round;
after ± stands the largest distance from the median. Bytes are the peak
beyond the input, a point. The answer of each program is verified once. The call in Rust is that of `rust_call.rs`,
which is built here with the profile of the wheel. Libraries that are not installed are left out.
"""

import argparse
import importlib.util
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]


def uniform(count):
    return np.random.default_rng(1).random((count, 2)), np.empty((0, 2), dtype=np.int64)


def segments(count):
    """Short edges that do not cross: one in each other row and column of a lattice that is shaken."""
    side = int((count // 2) ** 0.5)
    dice = np.random.default_rng(2)
    column, row = np.meshgrid(np.arange(side), np.arange(side))
    middle = np.stack([column, row], axis=-1).reshape(-1, 2) + 0.5
    angle = dice.random(len(middle)) * np.pi
    half = 0.45 * np.stack([np.cos(angle), np.sin(angle)], axis=1) * dice.random((len(middle), 1))
    ends = np.stack([middle - half, middle + half], axis=1)
    # In random order, as programs may get them.
    points = ends[dice.permutation(len(ends))].reshape(-1, 2)
    return points, np.arange(len(points)).reshape(-1, 2)


def polygon(count):
    """A star around the middle, at random distances."""
    dice = np.random.default_rng(3)
    turn = 2 * np.pi * (np.arange(count) + 0.5 * dice.random(count)) / count
    far = 0.6 + 0.4 * dice.random(count)
    position = np.arange(count)
    return np.stack([far * np.cos(turn), far * np.sin(turn)], axis=1), np.stack([position, (position + 1) % count], 1)


DATA = {
    "uniform 1e5": lambda: uniform(100_000),
    "uniform 1e6": lambda: uniform(1_000_000),
    "segments 2e5": lambda: segments(200_000),
    "polygon 1e4": lambda: polygon(10_000),
}


def sweep_cdt(points, edges, kind):
    import sweep_cdt

    if kind == "polygon":
        return lambda: sweep_cdt.triangulate(points, edges, inside="even-odd").triangles
    return lambda: sweep_cdt.triangulate(points, edges).simplices


def scipy(points, edges, kind):
    from scipy.spatial import Delaunay

    return lambda: Delaunay(points).simplices


def triangle(points, edges, kind):
    import triangle

    if kind == "uniform":
        return lambda: triangle.triangulate({"vertices": points})["triangles"]
    given = {"vertices": points, "segments": edges}
    return lambda: triangle.triangulate(given, "p" if kind == "polygon" else "pc")["triangles"]


def shapely(points, edges, kind):
    import shapely

    if kind == "polygon":
        whole = shapely.Polygon(points)
        return lambda: shapely.get_coordinates(shapely.constrained_delaunay_triangles(whole)).reshape(-1, 4, 2)
    cloud = shapely.MultiPoint(points)
    return lambda: shapely.get_coordinates(shapely.delaunay_triangles(cloud)).reshape(-1, 4, 2)


def mapbox_earcut(points, edges, kind):
    import mapbox_earcut

    ends = np.array([len(points)], dtype=np.uint32)
    return lambda: mapbox_earcut.triangulate_float64(points, ends).reshape(-1, 3)


def cdt(name):
    def prepare(points, edges, kind):
        module = importlib.import_module(name)
        order, crossing = module.VertexInsertionOrder.AUTO, module.IntersectingConstraintEdges.NOT_ALLOWED
        pairs = edges.astype(np.uint32)

        def call():
            result = module.Triangulation(order, crossing, 0.0)
            result.insert_vertices(points)
            if len(pairs):
                result.insert_edges(pairs)
            if kind == "polygon":
                result.erase_outer_triangles_and_holes()
            else:
                result.erase_super_triangle()
            return np.ascontiguousarray(result.triangles_array()["vertices"])

        return call

    return prepare


# What each library is asked.
PROGRAMS = {
    "sweep_cdt": (sweep_cdt, ("uniform", "segments", "polygon")),
    "scipy": (scipy, ("uniform",)),
    "triangle": (triangle, ("uniform", "segments", "polygon")),
    "shapely": (shapely, ("uniform", "polygon")),
    "mapbox_earcut": (mapbox_earcut, ("polygon",)),
    "pythoncdt": (cdt("pythoncdt"), ("uniform", "segments", "polygon")),
    "condeltri": (cdt("condeltri"), ("uniform", "segments", "polygon")),
}

# The call in Rust fills the hull.
RUST = ("uniform", "segments")


def peak():
    """The most bytes that this process has held in memory."""
    try:
        lines = pathlib.Path("/proc/self/status").read_text().splitlines()
    except OSError:
        return 0
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith("VmHWM:"))


def cell(name, kind, folder):
    """Times one call, and prints what came of it."""
    prepare, _ = PROGRAMS[name]
    points, edges = np.load(folder / "points.npy"), np.load(folder / "edges.npy")
    # A first call loads what the library loads late.
    few, ring = polygon(12)
    prepare(few, ring if kind != "uniform" else edges[:0], kind)()
    call = prepare(points, edges, kind)
    try:
        pathlib.Path("/proc/self/clear_refs").write_text("5")
    except OSError:
        pass
    before = peak()
    start = time.process_time()
    triangles = call()
    seconds = time.process_time() - start
    np.save(folder / "triangles.npy", triangles)
    print(json.dumps([seconds, peak() - before, triangles.nbytes]))


def rust():
    """Builds the call in Rust."""
    manifest = str(HERE.parent / "Cargo.toml")
    command = ["cargo", "build", "--release", "--locked", "--example", "rust_call", "--manifest-path", manifest]
    text = subprocess.run([*command, "--message-format", "json"], check=True, capture_output=True, text=True).stdout
    built = [json.loads(line) for line in text.splitlines()]
    return next(each["executable"] for each in built if each.get("executable"))


def run(name, kind, folder, program):
    if name == "Rust":
        out = subprocess.run([program, folder / "points.bin", folder / "edges.bin"], capture_output=True, text=True)
        seconds, memory, _ = out.stdout.split()
        return float(seconds), int(memory), 0
    command = [sys.executable, __file__, "--cell", name, kind, folder]
    # NumPy's BLAS would start a thread that waits in a loop, whose time would count.
    alone = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    out = subprocess.run(command, capture_output=True, text=True, env=alone)
    if out.returncode:
        sys.exit(f"{name}: {out.stderr}")
    return json.loads(out.stdout)


def verdict(points, edges, kind, triangles):
    """What the verifier says of an answer."""
    import sweep_cdt

    if triangles.ndim == 3:
        corners = np.ascontiguousarray(triangles[:, :3].reshape(-1, 2))
        triangles = sweep_cdt._matching.find(corners, points).reshape(-1, 3)
    domain = "even-odd" if kind == "polygon" else "hull"
    report = sweep_cdt.verify(points, triangles.astype(np.int64), edges, domain=domain, max_depth=1e-12)
    if report.verdict == "wrong" and report.reached in ("constrained", "tiling"):
        return "not Delaunay"
    return {"correct": "", "within-max-depth": "near", "wrong": "WRONG"}[report.verdict]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--only", default="")
    parser.add_argument("--programs", nargs="*", help="these alone, beside sweep_cdt")
    parser.add_argument("--cell", nargs=3)
    arguments = parser.parse_args()
    if arguments.cell:
        name, kind, folder = arguments.cell
        return cell(name, kind, pathlib.Path(folder))
    program = rust()
    names = ["Rust", *(name for name in PROGRAMS if importlib.util.find_spec(name))]
    if arguments.programs is not None:
        names = [name for name in names if name in ("sweep_cdt", *arguments.programs)]
    for data, make in DATA.items():
        if arguments.only not in data:
            continue
        kind = data.split()[0]
        asked = [name for name in names if kind in (RUST if name == "Rust" else PROGRAMS[name][1])]
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            points, edges = make()
            np.save(folder / "points.npy", points)
            np.save(folder / "edges.npy", edges)
            points.tofile(folder / "points.bin")
            edges.tofile(folder / "edges.bin")
            found, verdicts = {name: [] for name in asked}, {}
            for number in range(arguments.rounds):
                for name in asked:
                    found[name].append(run(name, kind, folder, program))
                    if number == 0 and name != "Rust":
                        verdicts[name] = verdict(points, edges, kind, np.load(folder / "triangles.npy"))
        print(f"\n{data}: {len(points)} points, {len(edges)} edges")
        print("| program | ns a point | times sweep_cdt | bytes a point | of these the array |\n|---|---:|---:|---:|---:|")
        for name in asked:
            seconds, memory, array = (statistics.median(column) for column in zip(*found[name]))
            spread = max(abs(row[0] / seconds - 1) for row in found[name])
            said = f", {verdicts[name]}" if verdicts.get(name) else ""
            each = 1e9 * seconds / len(points)
            times = statistics.median(row[0] / ours[0] for row, ours in zip(found[name], found["sweep_cdt"]))
            print(
                f"| {name} | {each:.0f} ±{100 * spread:.0f} %{said} | {times:.2f} "
                f"| {memory / len(points):.0f} | {array / len(points):.0f} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
