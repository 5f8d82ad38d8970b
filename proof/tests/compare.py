"""Compares the verdicts of the proved checker, of check.py and of `sweep-cdt verify`, on right and altered results.

    python3 compare.py SWEEP_CDT [ALTERED]

SWEEP_CDT is the command; ALTERED says how many altered results are made of each right one (5). The inputs are
those of tests/data, generated ones that are small and degenerate, and polygons. proof/run builds the checker before.
"""

import json
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

PROOF = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(PROOF), str(PROOF / "tests")]

import certify  # noqa: E402
import check  # noqa: E402
import polygons  # noqa: E402

KINDS = "uniform integers lattice rows columns circle parabola-up comb fans asterisk segments parcels contours".split()


def inputs(command, folder):
    data = PROOF.parent / "tests/data"
    for name in ("formats/ten.json", "formats/ten.poly", "formats/split.poly", "isolines_small.poly"):
        yield name, data / name
    for line in (data / "hard.jsonl").read_text().splitlines():
        case = json.loads(line)
        if len(case["points"]) <= 3000:
            path = folder / "hard.json"
            path.write_text(json.dumps({"points": case["points"], "edges": case["edges"]}))
            yield case["name"], path
    for kind in KINDS:
        for size in (12, 60):
            path = folder / "kind.json"
            subprocess.run([command, "generate", kind, str(size), "-o", path], check=True, capture_output=True)
            yield f"{kind} {size}", path


def alter(result, rng):
    """A copy of the result with one thing changed, and what that is."""
    triangles = [list(t) for t in result["triangles"]]
    chains = [list(c) for c in result["chains"]]
    edges = [list(e) for e in result["edges"]]
    vertices = range(len(result["points"]))
    k = rng.randrange(len(triangles))
    points, _ = certify.integers([[float(c) for c in p[:2]] for p in result["points"]])
    kind = rng.choice(["flip", "flip", "flip", "drop", "twice", "corner", "swap", "edge"])
    if kind == "flip":
        # The third corners of the triangles at each side, by the side's direction.
        third = {(t[i], t[(i + 1) % 3]): (n, t[(i + 2) % 3]) for n, t in enumerate(triangles) for i in range(3)}
        inner = [(p, q) for p, q in third if (q, p) in third]
        if inner:
            p, q = rng.choice(sorted(inner))
            (n, r), (m, s) = third[p, q], third[q, p]
            triangles[n], triangles[m] = [p, s, r], [s, q, r]
    elif kind == "drop":
        del triangles[k]
    elif kind == "twice":
        triangles.append(triangles[k])
    elif kind == "corner":
        triangles[k][rng.randrange(3)] = rng.choice(vertices)
    elif kind == "swap":
        p, q = rng.sample(vertices, 2)
        triangles = [[{p: q, q: p}.get(v, v) for v in t] for t in triangles]
    else:
        p, q = rng.sample(vertices, 2)
        a, b = sorted((points[p], points[q]))
        on = {points[v]: v for v in vertices if a < points[v] < b and check.orient(a, b, points[v]) == 0}
        through = [on[point] for point in sorted(on, reverse=points[p] > points[q])]
        edges.append([p, q])
        chains.append([p, *through, q])
    if all(check.orient(*(points[v] for v in t)) < 0 for t in triangles):
        triangles = [t[::-1] for t in triangles]  # `verify` takes triangles that are all clockwise as they are
    return kind, result | {"triangles": triangles, "chains": chains, "edges": edges}


def verdicts(command, result, folder):
    """What each judge says of the result, at the level of any right triangulation and at the canonical one."""
    cert, graph, answer = folder / "x.cert", folder / "x.json", folder / "y.json"
    text = certify.certificate(result)
    cert.write_text(text)
    graph.write_text(json.dumps({"points": result["points"], "edges": result["edges"]}))
    answer.write_text(json.dumps({"triangles": result["triangles"]}))
    said = {"proved": [], "check.py": [], "verify": []}
    for plain in (True, False):
        program = subprocess.run(
            [PROOF / "build/check", *["--plain"] * plain, cert], capture_output=True, text=True, check=False
        )
        said["proved"].append(program.returncode)
        try:
            check.judge(*check.read(text.splitlines()), plain)
            said["check.py"].append(0)
        except check.Refused:
            said["check.py"].append(1)
        level = "delaunay" if plain else "canonical"
        program = subprocess.run([command, "verify", graph, answer, "--level", level], capture_output=True, check=False)
        said["verify"].append(program.returncode)
    return said


def domains(command, title, path, result, folder):
    """How many rules have an interior, which must be that of the command; with a wrong value nothing is correct."""
    cert, output = folder / "x.cert", folder / "inside.json"
    found = 0
    for rule in ("even-odd", "nonzero"):
        text = certify.certificate(result, rule)
        said = []
        triangles = [line.split(" ") for line in text.splitlines() if line.startswith("t ")]
        first = " ".join(triangles[0])
        *rest, value = triangles[0]
        wrong = text.replace(first + "\n", " ".join([*rest, str(1 + int(value))]) + "\n")
        for case in (text, wrong):
            cert.write_text(case)
            program = subprocess.run([PROOF / "build/check", cert], capture_output=True, check=False).returncode
            try:
                check.judge(*check.read(case.splitlines()), False)
                judge = 0
            except check.Refused:
                judge = 1
            said.append((program, judge))
        output.unlink(missing_ok=True)
        subprocess.run([command, "triangulate", path, "--inside", rule, "-o", output], capture_output=True, check=False)
        expected = (0, 0) if output.exists() else (1, 1)  # edges that are no closed rings have no interior
        inside = sorted(sorted(map(int, t[1:4])) for t in triangles if int(t[5]) != 0)
        if said != [expected, (1, 1)]:
            sys.exit(f"{title}, {rule}: {said}")
        if output.exists():
            found += 1
            if inside != sorted(sorted(t) for t in json.loads(output.read_text())["triangles"]):
                sys.exit(f"{title}, {rule}: another interior")
    return found


def certified(command, title, path, result, folder):
    """The certificate that the command writes of its own result must be of this input, and accepted by both."""
    cert = folder / "own.cert"
    subprocess.run([command, "triangulate", path, "--inside", "hull", "-o", cert], capture_output=True, check=True)
    program = subprocess.run([PROOF / "build/check", cert], capture_output=True, check=False).returncode
    with cert.open() as lines:
        check.judge(*check.read(lines), False)
    if program:
        sys.exit(f"{title}: the command's own certificate is refused")
    _, points, edges = polygons.declarations(cert.read_text())
    ends = [[int(edge[i]) for i in (0, -1)] for edge in edges]
    if points != [[Fraction(float(x)) for x in point[:2]] for point in result["points"]] or ends != result["edges"]:
        sys.exit(f"{title}: the command's own certificate has other points or edges")


def streamed(command, title, result, folder, window):
    """The certificate of a stream must be of the same points and edges, and accepted by both."""
    graph, cert = folder / "x.poly", folder / "stream.cert"
    points, edges = ([p[:2] for p in result["points"]], result["edges"])
    lines = [f"{len(points)} 2 0 0", *(f"{n} {x!r} {y!r}" for n, (x, y) in enumerate(points))]
    lines += [f"{len(edges)} 0", *(f"{n} {a} {b}" for n, (a, b) in enumerate(edges)), "0"]
    graph.write_text("\n".join([*lines, ""]))
    call = [command, "stream", graph, "--window", str(window), "-o", cert]
    subprocess.run(call, capture_output=True, check=True)
    text = cert.read_text()
    if polygons.judged(PROOF / "build/check", text, cert) != [0, 0]:
        sys.exit(f"{title}: the certificate of the stream is refused; see {graph}")
    _, places, chains = polygons.declarations(text)
    places = [tuple(place) for place in places]
    exact = [tuple(Fraction(float(x)) for x in point) for point in points]
    both = [[(p[a], p[b]) for a, b in l] for p, l in ((exact, edges), (places, [map(int, (c[0], c[-1])) for c in chains]))]
    ends = [sorted(tuple(sorted(pair)) for pair in pairs if pair[0] != pair[1]) for pairs in both]
    if sorted(set(exact)) != sorted(places) or ends[0] != ends[1]:
        sys.exit(f"{title}: the certificate of the stream has other points or edges")


def main(command, altered=5):
    rng = random.Random(1)
    rights = wrongs = ties = interiors = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for title, path in inputs(command, folder):
            output = folder / "result.json"
            output.unlink(missing_ok=True)
            call = [command, "triangulate", path, "--inside", "hull", "-o", output]
            subprocess.run(call, capture_output=True, check=False)
            if not output.exists():
                continue  # edges that cross
            result = json.loads(output.read_text())
            certified(command, title, path, result, folder)
            for window in (1, 30):
                streamed(command, title, result, folder, window)
            cases = [("right", result)]
            if result["triangles"] and len(result["points"]) < 5000:
                interiors += domains(command, title, path, result, folder)
                cases += [alter(result, rng) for _ in range(altered)]
            for kind, case in cases:
                said = verdicts(command, case, folder)
                same = said["proved"] == said["check.py"] == said["verify"]
                if not same or (kind == "right" and any(said["proved"])):
                    (PROOF / "build/differs.cert").write_text((folder / "x.cert").read_text())
                    sys.exit(f"{title}, {kind}: {said}; see build/differs.cert")
                if kind == "right":
                    rights += 1
                elif said["proved"][0]:
                    wrongs += 1
                else:
                    ties += said["proved"][1]
        accepted, refused = polygons.compare(command, PROOF / "build/check", rng, folder, 100, streamed)
    print(f"{rights} right results accepted and {wrongs} altered ones refused by all; {ties} refused as ties alone")
    print(f"{interiors} interiors are those of sweep-cdt, and none is accepted with a wrong value")
    print(f"{accepted} interiors of polygons accepted and {refused} altered ones refused by all")


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
