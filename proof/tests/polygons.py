"""Compares the verdicts of the proved checker, of check.py and of `sweep-cdt verify` on interiors of polygons.

Polygons, holes and lines have their corners on a lattice, of which all points are given, so that they may lie over each
other in any way: edges are upright, level, or along one diagonal, and two of them cross at points of the lattice alone.
What is inside is found by rays to the right, from the polygons as they were made. compare.py calls this.
"""

import json
import subprocess
import sys
from fractions import Fraction

import certify
import check


def made(rng):
    """The size of a lattice, polygons as lists of rings, the outline first, and lines. Rings are lists of corners."""
    size = rng.randint(2, 6)

    def ring():
        x, y = rng.randrange(size), rng.randrange(size)
        k = rng.randint(1, size - max(x, y))
        corners = rng.choice(
            [
                [(x, y), (rng.randint(x + 1, size), y)],
                [(x, y), (x + k, y), (x, y + k)],
                [(x + k, y + k), (x, y + k), (x + k, y)],
            ]
        )
        if len(corners) == 2:
            right, top = corners[1][0], rng.randint(y + 1, size)
            corners += [(right, top), (x, top)]
        return corners[:: rng.choice((1, -1))]

    polygons = [[ring() for _ in range(rng.randint(1, 3))] for _ in range(rng.randint(1, 4))]
    lines = [[(x, rng.randint(0, size)), (x, rng.randint(0, size))] for x in range(rng.randint(0, 2))]
    return size, polygons, [line for line in lines if line[0] != line[1]]


def well_known_text(size, polygons, lines):
    def positions(points):
        return "(" + ", ".join(f"{x} {y}" for x, y in points) + ")"

    shapes = [f"POLYGON ({', '.join(positions(ring + ring[:1]) for ring in rings)})" for rings in polygons]
    shapes += [f"LINESTRING {positions(line)}" for line in lines]
    shapes += [f"POINT ({x} {y})" for x in range(size + 1) for y in range(size + 1)]
    return "\n".join(shapes)


def goes_round(ring, x, y):
    """Whether a ray to the right from (x/3, y/3) crosses an odd number of sides."""
    odd = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (3 * ay > y) != (3 * by > y):
            left_of = (bx - ax) * (y - 3 * ay) - (x - 3 * ax) * (by - ay)
            odd ^= left_of > 0 if by > ay else left_of < 0
    return odd


def covered(polygons, corners):
    x, y = (sum(c) for c in zip(*corners))
    return any(goes_round(rings[0], x, y) and not any(goes_round(h, x, y) for h in rings[1:]) for rings in polygons)


def claimed(text):
    """The triangles that are inside by a certificate."""
    lines = [line.split(" ") for line in text.splitlines()]
    return [list(map(int, line[1:4])) for line in lines if line[0] == "t" and line[5] == "1"]


def declarations(text):
    """What is declared: the polygons, the points times the unit, and the edges."""
    lines = [line.split(" ") for line in text.splitlines()]
    unit = Fraction(2) ** int(lines[1][1])
    places = [[int(x, 0) * unit for x in line[1:]] for line in lines if line[0] == "p"]
    head = [line for line in lines[2:] if line[0] in ("domain", "polygons", "outlines")]
    return head, places, [line[1:] for line in lines if line[0] == "e"]


def altered(text, rng, others=()):
    """The certificate with one triangle moved out or in, or with another ring at a side."""
    lines = text.splitlines()
    n = rng.choice([n for n, line in enumerate(lines) if line[0] == "t" and (not others or "b" in line)])
    words = lines[n].split(" ")
    if others:
        names = [k for k, word in enumerate(words) if k > 5 and word not in ("ab", "bc")]
        words[rng.choice(names)] = others
    else:
        words[5] = "10"[int(words[5])]
    lines[n] = " ".join(words)
    return "\n".join([*lines, ""])


def without_an_edge(text, rng):
    """The certificate with an edge that is part of another ring or of none."""
    lines = text.splitlines()
    n = rng.choice([n for n, line in enumerate(lines) if line.startswith("e ")])
    lines[n] = " ".join(["e", rng.choice(["-", "0", "1"]), *lines[n].split(" ")[2:]])
    return "\n".join([*lines, ""])


def judged(program, text, cert):
    """What the proved checker and check.py say of a certificate."""
    cert.write_text(text)
    proved = subprocess.run([program, cert], capture_output=True, check=False).returncode
    try:
        check.judge(*check.read(text.splitlines()), False)
        return [proved, 0]
    except check.Refused:
        return [proved, 1]


def compare(command, program, rng, folder, count, streamed):
    """How many interiors were accepted and how many refused by all three. `streamed` judges streams of the same edges."""
    rights = wrongs = 0
    shapes, cert, answer = folder / "x.wkt", folder / "x.cert", folder / "y.json"
    hull, own = folder / "hull.json", folder / "own.cert"
    for number in range(count):
        size, polygons, lines = made(rng)
        shapes.write_text(well_known_text(size, polygons, lines))
        for rule, output in (("hull", hull), ("polygons", own)):
            call = [command, "triangulate", shapes, "--inside", rule, "-o", output]
            subprocess.run(call, check=True, capture_output=True)
        result = json.loads(hull.read_text())
        streamed(command, f"polygons {number}", result, folder, rng.randint(1, 20))

        sides = [list(zip(ring, ring[1:] + ring[:1])) for rings in polygons for ring in rings]
        rings = [n for n, ring in enumerate(sides) for _ in ring] + [None] * len(lines)
        expected = [side for ring in sides for side in ring] + [tuple(line) for line in lines]
        places = [tuple(map(int, p)) for p in result["points"]]
        numbers = iter(range(len(sides)))
        declared = [([next(numbers)], [next(numbers) for _ in rest]) for _, *rest in polygons]
        text = certify.certificate(result, "polygons", rings, declared)
        inside = [sorted(t) for t in result["triangles"] if covered(polygons, [places[v] for v in t])]

        def fail(what):
            (program.parent / "differs.wkt").write_text(shapes.read_text())
            (program.parent / "differs.cert").write_text(cert.read_text())
            sys.exit(f"polygons {number}: {what}; see build/differs.wkt and build/differs.cert")

        if expected != [tuple(places[v] for v in edge) for edge in result["edges"]]:
            fail("other edges")
        of_command = own.read_text()
        for name, case in (("certify.py", text), ("the command", of_command)):
            if judged(program, case, cert) != [0, 0]:
                fail(f"the certificate of {name} is refused")
            if sorted(map(sorted, claimed(case))) != sorted(inside):
                fail(f"another interior by {name}")
        if declarations(of_command) != declarations(text):
            fail("the command declares other polygons, points or edges")
        for case, verdict in ((text, 0), (altered(text, rng), 1)):
            said = judged(program, case, cert)
            if claimed(case):
                answer.write_text(json.dumps({"triangles": claimed(case)}))
                call = [command, "verify", shapes, answer, "--domain", "polygons"]
                said.append(subprocess.run(call, capture_output=True, check=False).returncode)
            if set(said) != {verdict}:
                fail(f"{said} in place of {verdict}")
            rights, wrongs = rights + (verdict == 0), wrongs + verdict
        said = judged(program, altered(text, rng, others="99"), cert)
        if said != [1, 0]:  # a hint, at which check.py does not look
            fail(f"a wrong ring at a side: {said}")
        said = judged(program, without_an_edge(text, rng), cert)
        if said[0] != said[1]:
            fail(f"an edge of another ring: {said}")
    return rights, wrongs
