"""Judges a certificate (certificate.md) in Python's integers, without a proof, and by another way than the proved one.

    python3 check.py [--plain] FILE

The proved checker lays the triangles on a front and counts. Here sides are looked up in a table, the border is
compared with a hull made anew, and areas are compared. So no order of the triangles and no lower hull is needed, and
these hints are not looked at. Exit status: 0 correct, 1 refused, 2 unreadable.
"""

import sys
from collections import Counter


class Refused(Exception):
    pass


def demand(condition, message):
    if not condition:
        raise Refused(message)


def read(lines):
    """The domain, the points, the edges as lists of points, and the triangles with their marks and values."""
    lines = iter(lines)

    def words():
        return next(lines).rstrip("\n").split(" ")

    def many(name, lines_of=lambda n: n):
        word, count = words()
        if word != name:
            raise ValueError(f"{name} expected, not {word}")
        return [words() for _ in range(lines_of(int(count)))]

    if words() != ["sweep-cdt-certificate", "1"]:
        raise ValueError("not a certificate of version 1")
    many("exponent", lambda n: 0)
    (_, domain) = words()
    if domain not in ("hull", "even-odd", "nonzero"):
        raise ValueError(f"domain {domain}")
    points = [(integer(x), integer(y)) for x, y in many("points")]

    def place(word):
        index = int(word)
        if index < 0:
            raise ValueError(f"negative index {index}")
        return points[index]

    edges = [[place(w) for w in edge] for edge in many("edges")]
    if any(len(edge) < 2 for edge in edges):
        raise ValueError("an edge of one point")
    for (word,) in many("lower", lambda n: n + 1 if n else 0):
        place(word)
    triangles = []
    for a, b, c, m, *value in many("triangles"):
        if len(value) != (domain != "hull") or m not in "01234567":
            raise ValueError("not a triangle")
        triangles.append(((place(a), place(b), place(c)), int(m), integer(value[0]) if value else 0))
    if words() != ["end"] or next(lines, None) is not None:
        raise ValueError("the end expected")
    return domain, points, edges, triangles


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


def judge_values(domain, edges, values):
    """Across each side the value changes by the edges along it."""
    along = Counter()
    for edge in edges:
        along.update(zip(edge, edge[1:]))
    for p, q in {*along, *values, *((q, p) for p, q in values)}:
        rise = values.get((p, q), 0) - values.get((q, p), 0) - along[p, q] + along[q, p]
        demand(rise % 2 == 0 if domain == "even-odd" else rise == 0, f"the value across side {p} {q} is wrong")


def judge(domain, points, edges, triangles, plain):
    if not triangles:
        distinct = sorted(set(points))
        demand(all(orient(distinct[0], distinct[-1], p) == 0 for p in distinct), "there are no triangles")
        return
    opposite, marks, values, area = {}, {}, {}, 0
    for (a, b, c), mark, value in triangles:
        demand(orient(a, b, c) > 0, f"triangle {a} {b} {c} does not turn left")
        area += orient(a, b, c)
        for bit, (p, q, r) in enumerate(((a, b, c), (b, c, a), (c, a, b))):
            demand((p, q) not in opposite, f"side {p} {q} is there twice")
            opposite[p, q] = r
            marks[p, q] = mark >> bit & 1
            values[p, q] = value
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
        judge_values(domain, edges, values)
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
    except (OSError, ValueError, IndexError, StopIteration) as error:
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
