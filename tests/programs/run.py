#!/usr/bin/env python3
"""Judges the results of other programs: which keep what they promise, and on which inputs they do not.

    python3 tests/programs/run.py [--here] [PROGRAM...]

asks the programs of `programs.py` (or those named) the questions of `questions.py`, judges each answer with
`sweep-cdt verify`, and writes target/programs/own/programs.md, with all programs asked so far. With further inputs,
in a folder that SWEEP_CDT_HARD names, the page goes to target/programs/further. It builds the command and the crates
of benches/peers, and installs packages in target/programs/venv; with --here it does not, and asks those that this
Python has. Answers that are wrong, and right ones of at most JUDGED triangles, are judged a second time, by
`exact.py`. Where the two do not agree, the run says so and ends with status 1.

Programs are asked in processes of their own, which get PATIENCE seconds for each question: some crash, or never end.
"""

import collections
import json
import os
import pathlib
import select
import signal
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
VENV = ROOT / "target/programs/venv"
FOLDER = ROOT / "target/programs" / ("further" if "SWEEP_CDT_HARD" in os.environ else "own")
DOCUMENT = FOLDER / "programs.md"
COMMAND = pathlib.Path(os.environ.get("SWEEP_CDT", ROOT / "target/release/sweep-cdt"))
PACKAGES = "numpy scipy matplotlib shapely vtk gmsh libigl startinpy PythonCDT triangle cgal meshpy manifold3d mapbox_earcut"
PATIENCE = 10
# And so many more for the first one after a start.
START = 60
JUDGED = 300
# Violations that are no deeper count as rounding.
MAX_DEPTH = "1e-12"

def prepare():
    """Builds and installs, and goes on in the Python that has the packages."""
    for arguments in ([], ["--manifest-path", "benches/peers/Cargo.toml"]):
        subprocess.run(["cargo", "build", "--release", "--locked", *arguments], cwd=ROOT, check=True)
    python = VENV / "bin/python"
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", VENV], check=True)
        # One by one: what cannot be installed is left out.
        for package in PACKAGES.split():
            subprocess.run([python, "-m", "pip", "install", "--quiet", package])
    os.execv(python, [python, __file__, "--here", *sys.argv[1:]])

def write(answer, target):
    """Writes a result; triangles by coordinates as .wkt, others as .json."""
    if answer.by_coordinates:
        ring = lambda t: ", ".join(f"{float(x)!r} {float(y)!r}" for x, y in [*t, t[0]])
        text = ", ".join(f"(({ring(t)}))" for t in answer.triangles)
        target.with_suffix(".wkt").write_text(f"MULTIPOLYGON ({text})\n")
    else:
        content = {"triangles": answer.triangles}
        if answer.points is not None:
            content["points"] = answer.points
        target.with_suffix(".json").write_text(json.dumps(content))

def worker(name):
    """Answers questions, by their numbers, until there are no more."""
    import programs
    import questions

    # What libraries print is not for the caller.
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    program = next(each for each in programs.PROGRAMS if each.name == name)
    asked = program.questions(questions.questions())
    for line in sys.stdin:
        try:
            write(program.answer(asked[int(line)]), FOLDER / "answer")
            said = "answers"
        except ChildProcessError as error:
            said = f"crashes: {error}"
        except BaseException as error:
            said = f"refuses: {type(error).__name__}: {error}".replace("\n", " ")
        print(said, file=out, flush=True)

class Asked:
    """A program in a process of its own, which is started again when it has crashed."""

    def __init__(self, name):
        self.name = name
        self.process = None

    def ask(self, number):
        """What the program says."""
        for suffix in (".json", ".wkt"):
            (FOLDER / "answer").with_suffix(suffix).unlink(missing_ok=True)
        is_new = self.process is None
        if is_new:
            command = [sys.executable, __file__, "--worker", self.name]
            pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
            self.process = subprocess.Popen(command, text=True, start_new_session=True, **pipes)
        print(number, file=self.process.stdin, flush=True)
        ready, _, _ = select.select([self.process.stdout], [], [], PATIENCE + START * is_new)
        if line := ready and self.process.stdout.readline():
            return line.strip()
        if not ready:
            self.end()
            return f"hangs for {PATIENCE} s"
        status = self.process.wait()
        self.process = None
        return f"crashes: signal {-status}"

    def end(self):
        if self.process:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
            self.process = None

def source_of(question, program):
    """Writes the input: a .poly where holes have seeds."""
    if program.domain != "holes":
        source = FOLDER / "input.json"
        source.write_text(json.dumps({"points": question.points, "edges": question.edges}))
        return source
    source, seeds = FOLDER / "input.poly", question.seeds()
    rows = lambda items: [f"{k} {' '.join(map(repr, item))}" for k, item in enumerate(items)]
    lines = [f"{len(question.points)} 2 0 0", *rows(question.points)]
    lines += [f"{len(question.edges)} 0", *rows(question.edges), f"{len(seeds)}", *rows(seeds)]
    source.write_text("\n".join(lines) + "\n")
    return source

def verify(question, program):
    """The record of the command, or why it takes no result."""
    result = next(path for path in FOLDER.glob("answer.*"))
    options = ["--json", "--limit", "1", "--max-depth", MAX_DEPTH]
    options += ["--level", program.level, "--domain", program.domain]
    options += ["--steiner"] if program.adds_points else []
    command = [COMMAND, "verify", source_of(question, program), result, *options]
    run = subprocess.run(command, capture_output=True, text=True)
    return json.loads(run.stdout) if run.stdout else {"refused": run.stderr.strip()}

def second_opinion(question, program, record):
    """The level that `exact.py` finds, and the greatest depth."""
    import exact

    result = next(path for path in FOLDER.glob("answer.*"))
    points = [tuple(p) for p in question.points]
    if result.suffix == ".wkt":
        text = result.read_text()[len("MULTIPOLYGON (((") : -len(")))\n")]
        rings = [[tuple(map(float, p.split())) for p in t.split(", ")[:3]] for t in text.split(")), ((")]
        at = [p for ring in rings for p in ring]
        triangles = [list(range(v, v + 3)) for v in range(0, len(at), 3)]
    else:
        content = json.loads(result.read_text())
        triangles = content["triangles"]
        at = [tuple(p) for p in content.get("points", [])]
    if at and record.get("vertices_matched", {}).get("by") != "number":
        place = {p: v for v, p in reversed(list(enumerate(points)))}
        for p in at:
            if p not in place:
                if not program.adds_points:
                    return "none", 0
                place[p] = len(points)
                points.append(p)
        triangles = [[place[at[v]] for v in t] for t in triangles]
    rings = question.rings() if program.domain != "hull" else None
    return exact.level(points, question.edges, triangles, rings, len(question.points))

def judge(question, program):
    """What the command finds, as a row, and what the second judge says against it."""
    record = verify(question, program)
    if "refused" in record:
        row = {"verdict": "broken", "reached": "none", "first": "other vertices", "depth": None}
        if "where the input has none" not in record["refused"]:
            return row, "the command says " + record["refused"]
    else:
        kept = {"correct": "kept", "within-max-depth": "rounded", "wrong": "broken"}[record["verdict"]]
        first = record["violations"][0]["class"] if record["violations"] else None
        reached = record["highest_level"].replace("canonical", "delaunay")
        row = {"verdict": kept, "reached": reached, "first": first, "depth": record["depths"]["greatest"]}
        if row["verdict"] == "kept" and record["counts"]["triangles"] > JUDGED:
            return row, None
    level, deepest = second_opinion(question, program, record)
    row["judged"] = True
    if level != row["reached"]:
        return row, f"the second judge finds {level}, the command {row['reached']}"
    if deepest and program.level == "delaunay" and not abs(row["depth"] / float(deepest) - 1) < 1e-9:
        return row, f"the second judge finds a depth of {float(deepest)}, the command {row['depth']}"
    return row, None

def run(program, asked):
    """All rows of a program, and in how many the two judges do not agree."""
    rows, disagreements = {}, 0
    process = Asked(program.name)
    for number, question in enumerate(asked):
        said = process.ask(number)
        if said == "answers":
            row, against = judge(question, program)
        else:
            kind, why = said.split(maxsplit=1)
            row, against = {"verdict": kind.rstrip(":"), "first": why}, None
        rows[question.name] = row
        if row["verdict"] != "kept":
            print(f"{program.name:24} {question.name:44} {row['verdict']}: {row['first']}", flush=True)
        if against:
            disagreements += 1
            print(f"{program.name:24} {question.name:44} DISAGREEMENT: {against}", flush=True)
    process.end()
    return rows, disagreements

def main(names):
    import questions
    from document import document
    from programs import PROGRAMS

    FOLDER.mkdir(parents=True, exist_ok=True)
    asked = questions.questions()
    if unknown := set(names) - {p.name for p in PROGRAMS}:
        sys.exit(f"no such programs: {', '.join(sorted(unknown))}; there are: {', '.join(p.name for p in PROGRAMS)}")
    chosen = [p for p in PROGRAMS if not names or p.name in names]
    disagreements = 0
    for program in chosen:
        if not program.version():
            print(f"{program.name}: the package {program.package} is missing")
            continue
        rows, against = run(program, program.questions(asked))
        disagreements += against
        counts = collections.Counter(row["verdict"] for row in rows.values())
        print(f"{program.name}: {', '.join(f'{kind} {count}' for kind, count in sorted(counts.items()))}", flush=True)
        (FOLDER / f"{program.name}.result.json").write_text(json.dumps({"version": program.version(), "rows": rows}))
    results = {p.name: FOLDER / f"{p.name}.result.json" for p in PROGRAMS}
    results = {name: json.loads(path.read_text()) for name, path in results.items() if path.exists()}
    DOCUMENT.write_text(document(PROGRAMS, results, asked, MAX_DEPTH, PATIENCE, JUDGED))
    if disagreements:
        sys.exit(f"the two judges do not agree on {disagreements} answers")

if __name__ == "__main__":
    if sys.argv[1:2] == ["--worker"]:
        worker(sys.argv[2])
    elif sys.argv[1:2] == ["--here"]:
        main(sys.argv[2:])
    else:
        prepare()
