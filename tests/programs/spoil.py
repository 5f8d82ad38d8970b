#!/usr/bin/env python3
"""Spoils right answers and has both judges look at them: `sweep-cdt verify` and `exact.py` must find the same level.

    cargo build --release
    pip install shapely
    python3 tests/programs/spoil.py [ANSWERS] [SEED]

The command triangulates questions of `questions.py` with fewer than POINTS points. In each answer one thing is changed:
a triangle is missing, doubled, reversed or cut in three, a side is flipped, two vertices change places, one takes the
place of another, or nothing. Prints how often each change gave which level. Ends with status 1 if the two do not agree.
"""

import collections
import json
import random
import subprocess
import sys

import programs
import questions
import run

POINTS = 150
SQUARE = [[0, 0], [2, 0], [2, 2], [0, 2]]
# Answers that only one check of `exact.py` refuses each: points, triangles, level.
KNOWN = [
    ("overlap", SQUARE, [[0, 1, 2], [0, 1, 3]], "none"),
    ("corner_in_side", [*SQUARE, [1, 1]], [[0, 1, 2], [0, 4, 3], [4, 2, 3]], "none"),
    ("unused", [*SQUARE, [1, 0.5]], [[0, 1, 2], [0, 2, 3]], "none"),
    ("gap", SQUARE, [[0, 1, 2], [0, 2, 3]][:1], "none"),
    ("not_delaunay", [*SQUARE[:2], [3, 2], [0, 2]], [[0, 1, 2], [0, 2, 3]], "constrained"),
    ("right", SQUARE, [[0, 1, 2], [0, 2, 3]], "delaunay"),
]

def drop(triangles, _, dice):
    del triangles[dice.randrange(len(triangles))]

def double(triangles, _, dice):
    triangles.append(dice.choice(triangles))

def reverse(triangles, _, dice):
    dice.choice(triangles).reverse()

def flip(triangles, _, dice):
    beyond = {(t[k - 2], t[k - 1]): (t, t[k]) for t in triangles for k in range(3)}
    if inner := [side for side in beyond if side[::-1] in beyond]:
        a, b = dice.choice(inner)
        (one, c), (other, d) = beyond[a, b], beyond[b, a]
        one[:], other[:] = [c, a, d], [d, b, c]

def flips(triangles, points, dice):
    for _ in range(5):
        flip(triangles, points, dice)

def cut(triangles, points, dice):
    a, b, c = triangles.pop(dice.randrange(len(triangles)))
    v = dice.randrange(points)
    triangles += [[a, b, v], [b, c, v], [c, a, v]]

def swap(triangles, points, dice):
    a, b = dice.randrange(points), dice.randrange(points)
    triangles[:] = [[{a: b, b: a}.get(v, v) for v in t] for t in triangles]

def replace(triangles, points, dice):
    a, b = dice.randrange(points), dice.randrange(points)
    moved = [[b if v == a else v for v in t] for t in triangles]
    triangles[:] = [t for t in moved if len(set(t)) == 3]

def nothing(*_):
    pass

def judged(question, kind, domain, triangles):
    """The level that the command finds, and what the second judge says against it."""
    for path in run.FOLDER.glob("answer.*"):
        path.unlink()
    run.write(programs.Answer(triangles), run.FOLDER / "answer")
    row, against = run.judge(question, programs.Program("", "", kind, "delaunay", domain, None))
    return row["reached"], against

def main():
    answers, seed = [int(word) for word in (*sys.argv[1:], "500", "1")[:2]]
    run.FOLDER.mkdir(parents=True, exist_ok=True)
    asked = [(kind, q) for kind, list in questions.questions().items() for q in list if len(q.points) < POINTS]
    dice = random.Random(seed)
    found = collections.Counter()
    disagreements = 0
    for name, points, triangles, right in KNOWN:
        level, against = judged(questions.Question(name, points), "points", "hull", triangles)
        if against or level != right:
            disagreements += 1
            print(f"{name:44} the command finds {level}, right is {right}; {against}")
    for _ in range(answers):
        kind, question = dice.choice(asked)
        domain = dice.choice(["even-odd", "nonzero", "holes"]) if kind == "polygons" else "hull"
        source = run.source_of(question, programs.Program("", "", kind, "", domain, None))
        command = [run.COMMAND, "triangulate", source, "-o", run.FOLDER / "right.json", "--inside", domain]
        subprocess.run(command, check=True, capture_output=True)
        triangles = json.loads((run.FOLDER / "right.json").read_text())["triangles"]
        change = dice.choice([drop, double, reverse, flip, flips, cut, swap, replace, nothing])
        change(triangles, len(question.points), dice)
        level, against = judged(question, kind, domain, triangles)
        found[change.__name__, level] += 1
        if against:
            disagreements += 1
            print(f"{question.name:44} {domain:8} {change.__name__:8} {against}")
    for (change, level), count in sorted(found.items()):
        print(f"{change:8} {level:12} {count}")
    if disagreements:
        sys.exit(f"the two judges do not agree on {disagreements} answers")

if __name__ == "__main__":
    main()
