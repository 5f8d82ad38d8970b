"""A second judge of triangulations: the definitions, checked one by one in exact arithmetic.

It knows nothing of `sweep-cdt verify` and goes another way where there is one. The verifier follows the boundary and
counts windings; this judge adds up areas, and looks at each pair of triangles that may overlap. All numbers are
integers: the doubles times the least common multiple of their denominators, found with `fractions`. It takes
quadratic time in the worst case, so it is for inputs of up to some thousand points.

`level(...)` names the highest level that a result reaches:

tiling       corners turn one way, no two triangles overlap, the areas sum up to that of the hull or domain, every
             triangle lies in it, every point of the input is a corner, and no corner lies inside a side
constrained  and every edge is a chain of sides
delaunay     and the circle of no triangle holds the corner beyond a side that is not of an edge
"""

import bisect
import collections
import fractions
import math

LEVELS = ["none", "tiling", "constrained", "delaunay"]

def integers(points):
    """The points times one number, as integers."""
    exact = [[fractions.Fraction(c) for c in p] for p in points]
    scale = math.lcm(*(c.denominator for p in exact for c in p))
    return [(int(x * scale), int(y * scale)) for x, y in exact]

def turn(a, b, c):
    """Twice the area of a triangle, negative if it is clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

def between(a, b, p):
    """Whether a point lies inside a segment."""
    return p not in (a, b) and turn(a, b, p) == 0 and min(a, b) < p < max(a, b)

def winds(ring, p, scale=1):
    """Whether a ring goes round a point an odd number of times; the point is `scale` times as large."""
    odd = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (scale * ay > p[1]) != (scale * by > p[1]):
            side = turn((scale * ax, scale * ay), (scale * bx, scale * by), p)
            odd ^= (side > 0) == (by > ay)
    return odd

def area(ring):
    """Twice the area of a ring, positive."""
    return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1])))

def hull(points):
    """The corners of the convex hull, counter-clockwise."""
    chains = []
    for order in (sorted(set(points)), sorted(set(points), reverse=True)):
        chain = []
        for p in order:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains += chain[:-1]
    return chains

def overlap(s, t):
    """Whether two counter-clockwise triangles share a part of the plane: no side of either separates them."""
    for one, other in ((s, t), (t, s)):
        for a, b in ((one[0], one[1]), (one[1], one[2]), (one[2], one[0])):
            if all(turn(a, b, p) <= 0 for p in other):
                return False
    return True

def overlapping(triangles):
    """Whether any two do, from left to right."""
    active = []
    for t in sorted(triangles, key=min):
        left, low, high = min(t)[0], min(p[1] for p in t), max(p[1] for p in t)
        active = [each for each in active if each[0] > left]
        if any(l < high and low < h and overlap(s, t) for _, l, h, s in active):
            return True
        active.append((max(t)[0], low, high, t))
    return False

class Places:
    """Distinct points from left to right."""

    def __init__(self, points):
        self.all = sorted(set(points))

    def inside(self, a, b):
        """The points inside a segment, from its lower end on."""
        a, b = min(a, b), max(a, b)
        start, end = bisect.bisect_right(self.all, a), bisect.bisect_left(self.all, b)
        return [p for p in self.all[start:end] if between(a, b, p)]

def sides(triangle):
    a, b, c = triangle
    return [(a, b), (b, c), (c, a)]

def tiles(points, rings, triangles, corners):
    """Whether they tile the hull of the points or, by even-odd, the rings. The triangles are counter-clockwise."""
    required = set(points)
    if not required <= corners or overlapping(triangles):
        return False
    if rings is None:
        whole = area(hull(points))
    else:
        depth = [sum(winds(r, ring[0]) for r in rings if r is not ring) for ring in rings]
        whole = sum(area(ring) * (-1) ** d for ring, d in zip(rings, depth))
        middle = lambda t: (sum(p[0] for p in t), sum(p[1] for p in t))
        if not all(sum(winds(ring, middle(t), 3) for ring in rings) % 2 for t in triangles):
            return False
    if sum(turn(*t) for t in triangles) != whole:
        return False
    places = Places(corners)
    return not any(places.inside(a, b) for t in triangles for a, b in sides(t))

def fixed(edges, corners, drawn):
    """The sides that the edges are made of; nothing, if an edge is no chain of sides."""
    places = Places(corners)
    made = set()
    for a, b in edges:
        if a != b:
            chain = [min(a, b), *places.inside(a, b), max(a, b)]
            for piece in zip(chain, chain[1:]):
                if frozenset(piece) not in drawn:
                    return None
                made.add(frozenset(piece))
    return made

def depth(a, b, c, d):
    """How far d lies in the circle of a counter-clockwise triangle: its power over the squared radius."""
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    (ax, ay), (bx, by), (cx, cy) = rows
    lifted = [x * x + y * y for x, y in rows]
    inside = lifted[0] * (bx * cy - cx * by) - lifted[1] * (ax * cy - cx * ay) + lifted[2] * (ax * by - bx * ay)
    if inside <= 0:
        return 0
    lengths = math.prod((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 for p, q in ((a, b), (b, c), (c, a)))
    return fractions.Fraction(4 * inside * turn(a, b, c), lengths)

def level(points, edges, triangles, rings=None, own=None):
    """The highest level reached, and how deep the deepest side that is not Delaunay is (0 without one).

    `rings` lists the vertices of each ring, for a domain by even-odd. Points from `own` on were added."""
    if any(not 0 <= v < len(points) for t in triangles for v in t):
        return "none", 0
    points = integers(points)
    listed = [tuple(points[v] for v in t) for t in triangles]
    turns = [turn(*t) for t in listed]
    if not turns or not (all(t > 0 for t in turns) or all(t < 0 for t in turns)):
        return "none", 0
    listed = [t if turns[0] > 0 else t[::-1] for t in listed]
    corners = {p for t in listed for p in t}
    drawn = {frozenset(side) for t in listed for side in sides(t)}
    made = fixed([(points[a], points[b]) for a, b in edges], corners, drawn)
    rings = rings and [[points[v] for v in ring] for ring in rings]
    # That all edges are there keeps triangles from reaching over a ring.
    if rings and made is None or not tiles(points[:own], rings, listed, corners):
        return "none", 0
    if made is None:
        return "tiling", 0
    beyond = collections.defaultdict(list)
    for t in listed:
        for a, b, c in (t, t[1:] + t[:1], t[2:] + t[:2]):
            beyond[frozenset((a, b))].append((a, b, c))
    deepest = 0
    for side, both in beyond.items():
        if len(both) == 2 and side not in made:
            (first, second) = both
            deepest = max(deepest, depth(*first, second[2]), depth(*second, first[2]))
    return ("constrained", deepest) if deepest else ("delaunay", 0)
