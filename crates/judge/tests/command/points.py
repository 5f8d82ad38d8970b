"""The triangulation by its definition, in integers: right for points with whole coordinates, none equal.

The argument is a fault to plant in the answers, or none.
"""
import itertools
import json
import sys
import time

def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

def inside(a, b, c, d):
    """Whether d lies in the circle; of four points on it the leftmost, upper one is lowered."""
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    lift = [x * x + y * y for x, y in rows]
    cross = [rows[i][0] * rows[j][1] - rows[i][1] * rows[j][0] for i, j in ((1, 2), (2, 0), (0, 1))]
    sign = sum(l * c for l, c in zip(lift, cross))
    if sign:
        return sign > 0
    least = min((a, b, c, d), key=lambda p: (p[0], -p[1]))
    others = {a: (b, c, d), b: (c, a, d), c: (a, b, d)}
    return least == d or turn(*others[least]) < 0

def triangulate(points):
    triangles = []
    for t in itertools.combinations(range(len(points)), 3):
        a, b, c = t if turn(*(points[v] for v in t)) > 0 else (t[0], t[2], t[1])
        corners = [points[v] for v in (a, b, c)]
        if turn(*corners) > 0 and not any(inside(*corners, p) for p in points if p not in corners):
            triangles.append([a, b, c])
    return triangles

fault = sys.argv[1] if len(sys.argv) > 1 else ""
for number, line in enumerate(sys.stdin):
    question = json.loads(line)
    points = [(int(x), int(y)) for x, y in question["points"]]
    triangles = triangulate(points)
    if fault == "drop" and len(points) > 4:
        triangles = triangles[1:]
    if fault == "flip":
        for s, t in itertools.combinations(triangles, 2):
            a, b = set(s) & set(t) if len(set(s) & set(t)) == 2 else (0, 0)
            p, q = (set(s) | set(t)) - {a, b} if a != b else (0, 0)
            if a != b and turn(points[p], points[a], points[q]) * turn(points[p], points[b], points[q]) < 0:
                turned = lambda *t: list(t) if turn(*(points[v] for v in t)) > 0 else [t[0], t[2], t[1]]
                triangles = [u for u in triangles if u not in (s, t)] + [turned(p, q, a), turned(p, q, b)]
                break
    if len(points) > 4:
        if fault == "hang":
            time.sleep(1000)
        if fault == "crash":
            sys.exit("an assertion failed")
        if fault == "garbage":
            print("warning: something is odd")
            triangles = None
        if fault == "refuse":
            print(json.dumps({"refused": "too many points"}), flush=True)
            continue
    print(json.dumps({"triangles": triangles, "program": "points.py 1"}), flush=True)
    if fault == "once":
        break
