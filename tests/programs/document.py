"""Writes the page from what `run.py` found."""

import collections
import textwrap

OPENING = """\
# Programs judged

`python3 tests/programs/run.py` asks other programs for triangulations, judges them with `sweep-cdt verify`, and writes
this page. It needs nothing but a clone with Rust and Python: it builds what is in Rust and installs what is in Python.
Named programs are asked alone, and the page gets their rows.

Asked are {points} sets of points and {edges} of points with edges, from `tests/data/hard.jsonl`: inputs that broke
programs before, and tests of theirs. (`SWEEP_CDT_HARD` may name a folder of more.) And {polygons} polygons, {holed} of
them with holes: the rings among these inputs, and made ones. Only valid rings are asked as polygons; among the other
inputs are equal points, points on edges and edges that overlap.

Each program is judged by what it promises: a *level* and a *domain* of `sweep-cdt verify`. Its answer

- *keeps* the promise, by exact arithmetic;
- is *near*, if no violation is deeper than {max_depth}: rounding;
- *breaks* it;
- or there is none: it *refuses* (which is right, if it says that it takes no equal points), *crashes* (or panics), or
  *hangs* for {patience} s.

Every answer that does not keep the promise, and every one that does in at most {judged} triangles, was judged a second
time by `tests/programs/exact.py`, in big integers and without any code of this crate: {second} answers. On each of them
both judges found the same level, and depths that differ by less than 1e-9 of themselves. Where they do not agree, the
run fails.

*Deepest* is the greatest depth of a violation that has one.
"""

NOTES = """\
What to know before blaming a program:

- Coordinates of added points are rounded. One on an edge then lies off it, in doubles, and the boundary is not the given
  one. All wrong answers of `triangle pq` and `meshpy, angles` have added points on the boundary.
- `mapbox_earcut` and `earcut` leave out points on straight lines, or nearly so. The area is right, to 1e-19 of it, but
  triangles do not meet side to side. `earcutr` and `geo` keep slivers outside of the polygon, of at most 1e-10 of its
  area. `vtk ContourTriangulator` leaves gaps, up to most of the polygon.
- `vtk Delaunay2D` and `gmsh triangulate` leave dents in the hull. Their triangles run both ways, and are turned before
  they are judged. VTK is asked for tolerance 0, `geo` for no snapping, `startinpy` for a tolerance of 1e-300.
- `libigl` is wrong only where points are equal, and `PythonCDT` refuses these inputs, as it says.
- `i_triangle` works on a grid of its own, whose points are taken for those of the input.
- Where a crate panics, that is counted as a crash. The crashes of `triangle` with edges are on inputs with equal points,
  and differ from run to run.
"""

KINDS = [("rounded", "near"), ("broken", "breaks"), ("refuses", "refuses"), ("crashes", "crashes"), ("hangs", "hangs")]

def depths(rows):
    found = [row["depth"] for row in rows.values() if row.get("depth") is not None]
    return f"{max(found):.1e}" if found else ""

def lists(program, result):
    """The inputs that a program did not keep its promise on, by what is wrong first."""
    groups = collections.defaultdict(list)
    for name, row in result["rows"].items():
        for kind, verb in KINDS:
            if row["verdict"] == kind:
                groups[verb, row["first"] if kind in ("rounded", "broken") else ""].append(name)
    if not groups:
        return []
    lines = ["", f"### {program.name}", ""]
    for (verb, first), names in sorted(groups.items()):
        title = f"{verb}, `{first}`" if first else verb
        text = f"- {title} ({len(names)}): {', '.join(f'`{name}`' for name in names)}"
        lines += textwrap.wrap(text, 120, subsequent_indent="  ", break_on_hyphens=False, break_long_words=False)
    return lines

def document(programs, results, asked, max_depth, patience, judged):
    """The page."""
    seconds = sum(row.get("judged", False) for result in results.values() for row in result["rows"].values())
    holed = sum(any(len(polygon) > 1 for polygon in q.polygons) for q in asked["polygons"])
    counts = {kind: len(questions) for kind, questions in asked.items()}
    lines = [OPENING.format(**counts, holed=holed, max_depth=max_depth, patience=patience, judged=judged, second=seconds)]
    lines.append("| program | version | asked | promise | of | keeps | near | breaks | refuses | crashes | hangs | deepest |")
    lines.append("|---|---|---|---|" + "---:|" * 8)
    for program in programs:
        if result := results.get(program.name):
            verdicts = collections.Counter(row["verdict"] for row in result["rows"].values())
            numbers = [len(result["rows"]), *(verdicts[kind] for kind in ["kept", *(kind for kind, _ in KINDS)])]
            domain = program.domain + (", added points" if program.adds_points else "")
            cells = [program.name, result["version"], program.kind, f"{program.level}, {domain}"]
            cells += [str(n) if n else "" for n in numbers] + [depths(result["rows"])]
            lines.append("| " + " | ".join(cells) + " |")
    lines += ["", NOTES, "## Which inputs", "", "By what the command lists first."]
    for program in programs:
        if result := results.get(program.name):
            lines += lists(program, result)
    return "\n".join(lines) + "\n"
