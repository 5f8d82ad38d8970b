"""Writes the certificate (certificate.md) of a result of `sweep-cdt triangulate IN -o OUT.json`.

    python3 certify.py OUT.json OUT.cert [even-odd | nonzero]

Coordinates are doubles. The points of each edge are those of `chains`. Triangles that cannot be laid come last, so that
the certificate of a wrong result holds all of it.
"""

import collections
import json
import sys


def before(p, q):
    return p < q  # pairs: by x, then by y


def integers(points):
    """The coordinates as integers, and the exponent of two that they share."""
    ratios = [[c.as_integer_ratio() for c in p] for p in points]
    shift = max((d.bit_length() - 1 for p in ratios for _, d in p), default=0)
    return [tuple(n << (shift - d.bit_length() + 1) for n, d in p) for p in ratios], -shift


def order(points, triangles):
    """The triangles from below, leftmost first, and the lower hull."""
    rotated = []
    for t in triangles:
        k = min(range(3), key=lambda i: points[t[i]])
        rotated.append((t[k], t[(k + 1) % 3], t[(k + 2) % 3]))
    above = {}  # the triangle above a side from left to right, by coordinates
    for n, (a, b, c) in enumerate(rotated):
        for p, q in ((a, b), (b, c), (c, a)):
            if before(points[p], points[q]):
                above[points[p], points[q]] = n
    covered = set()  # sides with a triangle below
    count = [0] * len(rotated)
    for a, b, c in rotated:
        for p, q in ((a, b), (b, c), (c, a)):
            side = (points[q], points[p])
            if before(*side) and side in above:
                covered.add(side)
                count[above[side]] += 1
    low = {}
    for a, b, c in rotated:
        for p, q in ((a, b), (b, c), (c, a)):
            if before(points[p], points[q]) and (points[p], points[q]) not in covered:
                low[points[p]] = (p, q)
    chain = []
    if low:
        p, q = low[min(low)]
        chain = [p, q]
        while points[q] in low and len(chain) <= len(points):
            q = low[points[q]][1]
            chain.append(q)
    stack = []
    for p, q in reversed(list(zip(chain, chain[1:]))):
        n = above[points[p], points[q]]
        if count[n] == 0 and points[rotated[n][0]] == points[p]:
            stack.append(n)
    listed = []
    while stack and len(listed) < len(rotated):
        n = stack.pop()
        listed.append(n)
        a, b, c = rotated[n]
        upper = [(p, q) for p, q in ((b, c), (c, a)) if before(points[q], points[p])]
        for p, q in upper:  # the right one is met first
            m = above.get((points[q], points[p]))
            if m is not None:
                count[m] -= 1
                if count[m] == 0:
                    stack.append(m)
    rest = set(range(len(rotated))) - set(listed)
    return [rotated[n] for n in listed + sorted(rest)], chain


def values(points, edges, triangles):
    """How often the edges go round each triangle, spread from the border across sides; 0 where nothing spreads to."""
    along = collections.Counter()
    for edge in edges:
        along.update((points[a], points[b]) for a, b in zip(edge, edge[1:]))
    left = {}
    for n, t in enumerate(triangles):
        for p, q in zip(t, t[1:] + t[:1]):
            left[points[p], points[q]] = n
    found = {}
    queue = collections.deque((n, along[p, q] - along[q, p]) for (p, q), n in left.items() if (q, p) not in left)
    while queue:
        n, value = queue.popleft()
        if n in found:
            continue
        found[n] = value
        for p, q in zip(triangles[n], triangles[n][1:] + triangles[n][:1]):
            p, q = points[p], points[q]
            if (q, p) in left:
                queue.append((left[q, p], value + along[q, p] - along[p, q]))
    return [found.get(n, 0) for n in range(len(triangles))]


def edges_of(data):
    """The points of each edge, from its first end."""
    return [c if len(c) > 1 else c * 2 for c in data["chains"]]


def certificate(data, domain="hull", rings=(), polygons=()):
    """The text. With domain polygons: `rings` has the ring of each edge or None, `polygons` outlines and holes."""
    points, exponent = integers([[float(c) for c in p[:2]] for p in data["points"]])
    edges = edges_of(data)
    marked = {frozenset((points[a], points[b])) for c in edges for a, b in zip(c, c[1:])}
    triangles, chain = order(points, data["triangles"])
    out = ["sweep-cdt-certificate 3", f"exponent {exponent}", f"domain {domain}"]
    first = [[]] * len(edges)
    if domain == "polygons":
        out.append(f"polygons {len(polygons)}")
        out += [" ".join(map(str, ["outlines", *outlines, "holes", *holes])) for outlines, holes in polygons]
        first = [["-" if ring is None else ring] for ring in rings]
    out += [f"p {x} {y}" for x, y in points]
    out += [" ".join(map(str, ["e", *ring, *edge])) for ring, edge in zip(first, edges)]
    out += [f"l {a} {b}" for a, b in zip(chain, chain[1:])]
    for (a, b, c), value in zip(triangles, claims(domain, points, edges, rings, polygons, triangles)):
        mark = sum(
            1 << i for i, (p, q) in enumerate(((a, b), (b, c), (c, a))) if frozenset((points[p], points[q])) in marked
        )
        out.append(" ".join(map(str, ["t", a, b, c, mark, *value])))
    return "\n".join(out + ["end", ""])


def claims(domain, points, edges, rings, polygons, triangles):
    """For each triangle the words that say whether it is inside; by polygons also the rings along its lower sides."""
    if domain == "hull":
        return [[]] * len(triangles)
    if domain != "polygons":
        return [[value % 2 if domain == "even-odd" else value] for value in values(points, edges, triangles)]
    found, along = [set() for _ in triangles], collections.defaultdict(set)
    for ring in sorted(set(rings) - {None}):
        of_ring = [edge for edge, other in zip(edges, rings) if other == ring]
        for value, around in zip(values(points, of_ring, triangles), found):
            around |= {ring} if value % 2 else set()
        for edge in of_ring:
            for a, b in zip(edge, edge[1:]):
                along[frozenset((points[a], points[b]))] ^= {ring}
    claimed = []
    for (a, b, c), around in zip(triangles, found):
        words = [int(any(around & set(outlines) and not around & set(holes) for outlines, holes in polygons))]
        for name, (p, q) in (("ab", (a, b)), ("bc", (b, c))):
            here = along.get(frozenset((points[p], points[q])))
            if here and before(points[p], points[q]):
                words += [name, *sorted(here)]
        claimed.append(words)
    return claimed


if __name__ == "__main__":
    with open(sys.argv[1]) as source, open(sys.argv[2], "w") as target:
        target.write(certificate(json.load(source), *sys.argv[3:]))
