#!/usr/bin/env python3
"""Verifies what other programs answer: the Python packages `triangle` and `scipy` on hard inputs.

    cargo build --release
    pip install numpy scipy triangle
    python3 tests/peers.py [SECONDS]

Reads `tests/data/hard.jsonl` and the folder that SWEEP_CDT_HARD names, runs each program on each input in a
process of its own (it may crash, and it has SECONDS, 10 by default), writes its triangles to a file, and lets
`sweep-cdt verify` judge them. Prints one line for each answer that is not correct:

    program   input   what is wrong

and a summary. Where a package or the command is missing it says so and ends with status 0.
"""

import collections
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Inputs that no triangulation can be made of.
HOPELESS = {"nonfinite", "invalid_index", "crossing", "all_collinear", "too_few"}

def delaunay_by_scipy(points, _edges):
    from scipy.spatial import Delaunay

    return points, Delaunay(points).simplices.tolist()

def by_triangle(options):
    def run(points, edges):
        import triangle

        given = {"vertices": points}
        if edges:
            given["segments"] = edges
        result = triangle.triangulate(given, options if edges else options.replace("p", ""))
        return result["vertices"].tolist(), result["triangles"].tolist()

    return run

# Name: the package, whether it takes edges, the function, and the extension of what is written.
PROGRAMS = {
    "scipy": ("scipy", False, delaunay_by_scipy, "json"),
    "triangle pc": ("triangle", True, by_triangle("pc"), "ele"),
    "triangle pci": ("triangle", True, by_triangle("pci"), "ele"),
    "triangle pcF": ("triangle", True, by_triangle("pcF"), "ele"),
}

def read(path):
    """The points and edges of an input, and what is special about it."""
    content = json.loads(path.read_text())
    points = [[float(x), float(y)] for x, y in content["points"]]
    return points, content["edges"], content.get("expect", "valid")

def write(target, points, triangles):
    """Writes a result, numbered from 0; beside an .ele the vertices, to the last bit."""
    if target.suffix == ".json":
        target.write_text(json.dumps({"triangles": triangles}))
        return
    lines = [f"{len(triangles)} 3 0", *(f"{t} {a} {b} {c}" for t, (a, b, c) in enumerate(triangles))]
    target.write_text("\n".join(lines) + "\n")
    lines = [f"{len(points)} 2 0 0", *(f"{v} {x!r} {y!r}" for v, (x, y) in enumerate(points))]
    target.with_suffix(".node").write_text("\n".join(lines) + "\n")

def child(program, source, target):
    """Runs one program on one input, in a process of its own."""
    points, edges, _ = read(pathlib.Path(source))
    write(pathlib.Path(target), *PROGRAMS[program][2](points, edges))

def ask(program, source, target, seconds):
    """Why there is no answer, or nothing."""
    command = [sys.executable, __file__, "--child", program, source, target]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return f"does not end within {seconds} s"
    if run.returncode < 0:
        return f"crashes with signal {-run.returncode}"
    if run.returncode == 0:
        return None
    said = run.stderr.strip().splitlines() or [f"status {run.returncode}"]
    return "refuses: " + said[-1]

def judge(command, source, target):
    """What the verifier finds, or nothing."""
    run = subprocess.run(
        [command, "verify", source, target, "--clockwise", "--json"], capture_output=True, text=True
    )
    if not run.stdout:
        return run.stderr.strip()
    answer = json.loads(run.stdout)
    if answer["verdict"] == "correct":
        return None
    classes = collections.Counter(each["class"] for each in answer["violations"])
    first = answer["violations"][0]["message"]
    found = answer["violations_found"]
    return f"WRONG: {found} violations ({', '.join(classes)}), the first: {first}"

def main():
    command = ROOT / "target/release/sweep-cdt"
    command = pathlib.Path(os.environ.get("SWEEP_CDT", command))
    if not command.exists():
        print(f"{command} is missing: build it with `cargo build --release`")
        return
    missing = [name for name in ("numpy", "scipy", "triangle") if not importlib.util.find_spec(name)]
    if missing:
        print(f"missing packages: {', '.join(missing)}; try `pip install {' '.join(missing)}`")
        return
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 10
    lines = (ROOT / "tests/data/hard.jsonl").read_text().splitlines()
    texts = {json.loads(line)["name"]: line for line in lines}
    if further := os.environ.get("SWEEP_CDT_HARD"):
        texts.update((path.stem, path.read_text()) for path in pathlib.Path(further).glob("*.json"))
    totals = collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory() as folder:
        for name, text in sorted(texts.items()):
            source = pathlib.Path(folder) / f"{name}_input.json"
            source.write_text(text)
            _, edges, expect = read(source)
            if expect in HOPELESS:
                continue
            for program, (_, takes_edges, _, extension) in PROGRAMS.items():
                if edges and not takes_edges:
                    continue
                target = pathlib.Path(folder) / f"{name}.{extension}"
                fault = ask(program, source, target, seconds)
                fault = fault or judge(command, source, target)
                kind = fault.split()[0].rstrip(":").lower() if fault else "correct"
                totals[program][kind] += 1
                if fault:
                    print(f"{program:14} {name:44} {fault}", flush=True)
    print()
    for program, kinds in totals.items():
        print(f"{program}: {', '.join(f'{kind} {count}' for kind, count in sorted(kinds.items()))}")

if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        child(*sys.argv[2:])
    else:
        main()
