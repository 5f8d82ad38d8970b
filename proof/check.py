"""Judges a certificate (certificate.md) in Python's integers, without a proof, and by another way than the proved one.

    python3 check.py [--plain] FILE

The proved checker lays the triangles on a front and counts. Here sides are looked up in a table, the border is
compared with a hull made anew, areas are compared, and edges are counted below each triangle. No order of the triangles
is needed, no lower hull, and no rings at sides: these hints are not looked at. All is in memory. Exit status: 0 correct, 1 refused, 2 unreadable.
"""

import sys
from bisect import bisect_left
from collections import Counter, defaultdict


class Refused(Exception):
    pass


def demand(condition, message):
    if not condition:
        raise Refused(message)


def read(lines):
    """The domain, its polygons, the points, the edges as lists of points, their rings, the triangles with marks and values."""
    lines = iter(lines)

    def words():
        return next(lines).rstrip("\n").split(" ")

    def count(name):
        word, number = words()
        if word != name:
            raise ValueError(f"{name} expected, not {word}")
        return int(number)

    if words() != ["sweep-cdt-certificate", "3"]:
        raise ValueError("not a certificate of version 3")
    count("exponent")
    (_, domain) = words()
    if domain not in ("hull", "even-odd", "nonzero", "polygons"):
        raise ValueError(f"domain {domain}")
    roles = defaultdict(set)  # for each ring, its polygons, and whether it is a hole there
    for number, (outlines, *rest) in enumerate([words() for _ in range(count("polygons"))] if domain == "polygons" else []):
        holes = rest.index("holes")
        if outlines != "outlines":
            raise ValueError("not a polygon")
        for ring in rest[:holes]:
            roles[integer(ring)].add((number, False))
        for ring in rest[holes + 1 :]:
            roles[integer(ring)].add((number, True))
    points, edges, rings, triangles = [], [], [], []
    named = {}  # the points that may be named

    def place(word):
        return named[int(word)]

    def triangle(a, b, c, m, *value):
        if domain == "polygons":
            value, names = value[:1], value[1:]
            heads = [w for w in names if w in ("ab", "bc")]
            numbers = [integer(w) for w in names if w not in ("ab", "bc")]
            if value not in (("0",), ("1",)) or heads not in ([], ["ab"], ["bc"], ["ab", "bc"]):
                raise ValueError("not a triangle")
            if names and names[0] not in heads or numbers and not heads:
                raise ValueError("rings of no side")
        if len(value) != (domain != "hull") or m not in "01234567":
            raise ValueError("not a triangle")
        return (place(a), place(b), place(c)), int(m), *map(integer, value or ["0"])

    while (line := words()) != ["end"]:
        match line:
            case ["p", x, y]:
                named[len(points)] = (integer(x), integer(y))
                points.append(named[len(points)])
            case ["e", *edge]:
                ring = edge.pop(0) if domain == "polygons" else "0"
                rings.append(None if ring == "-" else integer(ring))
                edges.append([place(w) for w in edge])
                if len(edge) < 2:
                    raise ValueError("an edge of one point")
            case ["l", a, b]:
                place(a), place(b)
            case ["t", *rest]:
                triangles.append(triangle(*rest))
            case ["f", *numbers]:
                for n in numbers:
                    named.pop(int(n), None)
            case _:
                raise ValueError("not a record")
    if next(lines, None) is not None:
        raise ValueError("the end expected")
    return (domain, roles), points, edges, rings, triangles


def integer(word):
    return int(word, 16 if "x" in word else 10)


def orient(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def in_circle(a, b, c, d):
    """Positive if d is strictly inside the circle through a, b, c, which turn left: d lifted to the paraboloid."""
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    (ax, ay), (bx, by), (cx, cy) = rows
    a2, b2, c2 = (x * x + y * y for x, y in rows)
    return ax * (by * c2 - b2 * cy) - ay * (bx * c2 - b2 * cx) + a2 * (bx * cy - by * cx)


def hull(points):
    """The sides of the convex hull, counterclockwise, with all points that lie on it (Andrew's chains)."""

    def chain(points):
        stack = []
        for p in points:
            while len(stack) > 1 and orient(stack[-2], stack[-1], p) < 0:
                stack.pop()
            stack.append(p)
        return list(zip(stack, stack[1:]))

    ordered = sorted(set(points))
    return set(chain(ordered) + chain(ordered[::-1]))


def pieces(edges):
    """The pieces of all edges, each as a set of its two ends."""
    found = set()
    for edge in edges:
        a, b = edge[0], edge[-1]
        if a == b:
            continue
        forward = edge if a < b else edge[::-1]
        for p, q in zip(forward, forward[1:]):
            demand(p < q and orient(a, b, q) == 0, f"the points of an edge are not in order on one line: {edge}")
            found.add(frozenset((p, q)))
    return found


def rank(p):
    """The order of the rule of the first corner: the leftmost, the upper one of two."""
    return (p[0], -p[1])


def judge_values(domain, roles, edges, rings, triangles):
    """Rings are closed, and a value is what a ray down from the middle of the triangle crosses of each."""
    ends, below = Counter(), [Counter() for _ in triangles]
    middles = sorted((sum(p[0] for p in t), sum(p[1] for p in t), n) for n, (t, _, _) in enumerate(triangles))
    for edge, ring in zip(edges, rings):
        if ring is None:
            continue
        p, q = ((3 * x, 3 * y) for x, y in (edge[0], edge[-1]))
        (a, b), right = ((p, q), 1) if p < q else ((q, p), -1)
        ends[ring, p] += 1
        ends[ring, q] -= 1
        for x, y, n in middles[bisect_left(middles, a[:1]) : bisect_left(middles, b[:1])]:
            if orient(a, b, (x, y)) > 0:
                below[n][ring] += right
    wrong = (lambda n: n != 0) if domain == "nonzero" else (lambda n: n % 2 != 0)
    demand(not any(wrong(n) for n in ends.values()), "a ring is not closed")
    for (t, _, value), count in zip(triangles, below):
        if domain == "polygons":
            around = {role for ring, n in count.items() if wrong(n) for role in roles[ring]}
            is_right = value == any((polygon, True) not in around for polygon, is_hole in around if not is_hole)
        else:
            is_right = not wrong(value - count[0])
        demand(is_right, f"the value of triangle {t} is wrong")


def judge(rule, points, edges, rings, triangles, plain):
    domain, roles = rule
    if not triangles:
        distinct = sorted(set(points))
        demand(all(orient(distinct[0], distinct[-1], p) == 0 for p in distinct), "there are no triangles")
        return
    opposite, marks, area = {}, {}, 0
    for (a, b, c), mark, _ in triangles:
        demand(orient(a, b, c) > 0, f"triangle {a} {b} {c} does not turn left")
        area += orient(a, b, c)
        for bit, (p, q, r) in enumerate(((a, b, c), (b, c, a), (c, a, b))):
            demand((p, q) not in opposite, f"side {p} {q} is there twice")
            opposite[p, q] = r
            marks[p, q] = mark >> bit & 1
    demand({p for t, _, _ in triangles for p in t} == set(points), "the corners are not the points")
    border = {(p, q) for p, q in opposite if (q, p) not in opposite}
    sides = hull(points)
    demand(border == sides, "the border is not the hull")
    demand(area == sum(p[0] * q[1] - p[1] * q[0] for p, q in sides), "the areas do not add up to the hull")
    constrained = pieces(edges)
    for (p, q), mark in marks.items():
        demand(mark == (frozenset((p, q)) in constrained), f"the mark of side {p} {q} is wrong")
    demand(all(tuple(s) in opposite or tuple(s)[::-1] in opposite for s in constrained), "an edge is missing")
    if domain != "hull":
        judge_values(domain, roles, edges, rings, triangles)
    for (p, q), r in opposite.items():
        if p < q and (q, p) in opposite and not marks[p, q]:
            s = opposite[q, p]
            sign = in_circle(p, q, r, s)
            demand(sign <= 0, f"side {p} {q} is not Delaunay")
            if sign == 0 and not plain:
                demand(min((p, q, r, s), key=rank) in (p, q), f"side {p} {q} breaks the rule of the first corner")


def main(arguments):
    plain = "--plain" in arguments
    try:
        with open([a for a in arguments if a != "--plain"][0]) as lines:
            certificate = read(lines)
    except (OSError, ValueError, LookupError, TypeError, StopIteration) as error:
        print(f"unreadable: {error}")
        return 2
    try:
        judge(*certificate, plain)
    except Refused as reason:
        print(f"refused: {reason}")
        return 1
    print("correct: " + ("a constrained Delaunay triangulation" if plain else "the canonical triangulation"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
