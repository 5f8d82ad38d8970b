"""Measures which regions of `src/` the corpora reach.

The program of `fuzz/properties` is built with the instrumentation of rustc. It runs every property on its corpus.
"""

import concurrent.futures
import json
import os
import shutil

from . import processes
from .processes import FUZZ

# Modules whose coverage is measured; the report lists every file of them.
COVERED = ["sweep/", "front/", "mesh/", "scalar/", "verify/", "stream/", "crossings/", "triangulation/", "trace/",
           "bucket.rs"]
# The kind of a region that is code, in what llvm-cov exports.
CODE = 0
# The target folder of the instrumented program, and the program.
FOLDER = FUZZ / "target/coverage"
PROGRAM = FOLDER / "release/sweep-cdt-properties"


def build():
    """Builds the program, with the messages of cargo."""
    environment = {**os.environ, "RUSTFLAGS": "-C instrument-coverage", "CARGO_TARGET_DIR": str(FOLDER),
                   "LLVM_PROFILE_FILE": os.devnull}
    processes.must(["cargo", "build", "--release", "-p", "sweep-cdt-properties"], shown=True, env=environment)


def measure(targets, jobs, tools, out):
    """File, regions and missed regions, for each file and in all. What is missed is listed in coverage.txt."""
    profile = out / "profile"
    shutil.rmtree(profile, ignore_errors=True)
    profile.mkdir()

    def run(target):
        raw = profile / f"{target.name}.profraw"
        if processes.stopped.is_set():
            return raw
        processes.run([PROGRAM, "run", target.name, target.corpus],
                      env={**os.environ, "LLVM_PROFILE_FILE": str(raw)})
        processes.say(f"  {target.name}")
        return raw

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        raw = [file for file in pool.map(run, targets) if file.exists()]
    if processes.stopped.is_set():
        raise processes.Failed("the campaign was stopped meanwhile")
    merged = profile / "all.profdata"
    processes.must([tools[0], "merge", "-sparse", *raw, "-o", merged])
    source = FUZZ.parent / "src"
    sources = [path for path in sorted(source.rglob("*.rs")) if is_covered(os.path.relpath(path, source))]
    measured = [PROGRAM, f"-instr-profile={merged}"]
    (out / "coverage.txt").write_text(
        processes.must([tools[1], "show", *measured, "-show-instantiations=false", "-show-regions", *sources]))
    rows = count(json.loads(processes.must([tools[1], "export", *measured])), source)
    return [*rows, ("TOTAL", sum(regions for _, regions, _ in rows), sum(missed for _, _, missed in rows))]


def is_covered(name):
    """Whether the coverage of this file of `src/` is measured."""
    return any(name.startswith(part) for part in COVERED)


def count(exported, source):
    """File, regions and missed regions, out of what llvm-cov exports. A region of a generic function counts once, and is
    reached if it is for any type."""
    reached = {}
    for function in exported["data"][0]["functions"]:
        names = [os.path.relpath(file, source) for file in function["filenames"]]
        for *place, executions, file, _, kind in function["regions"]:
            if kind == CODE and is_covered(names[file]):
                regions = reached.setdefault(names[file], {})
                regions[tuple(place)] = regions.get(tuple(place), False) or executions > 0
    return [(name, len(regions), list(regions.values()).count(False)) for name, regions in sorted(reached.items())]
