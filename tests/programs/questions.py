"""What the programs are asked: points, points with edges, and polygons with holes.

Points and edges are those of the hard inputs: `tests/data/hard.jsonl` and the folder that SWEEP_CDT_HARD names.
Polygons are the rings among them, and made ones. The points of a polygon's rings are numbered ring after ring, the
outer one counter-clockwise and first, then its holes, clockwise. A question may have several polygons.
"""

import dataclasses
import json
import math
import os
import pathlib
import random

import exact

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Inputs that no triangulation can be made of.
HOPELESS = {"nonfinite", "invalid_index", "crossing", "all_collinear", "too_few"}

@dataclasses.dataclass
class Question:
    name: str
    points: list
    edges: list = dataclasses.field(default_factory=list)
    # Of each polygon the ranges of its rings.
    polygons: list = dataclasses.field(default_factory=list)

    def rings(self):
        """The vertices of all rings."""
        return [list(ring) for polygon in self.polygons for ring in polygon]

    def seeds(self):
        """A point in each hole, found by its own coordinates: Triangle's way to name holes."""
        from shapely import Polygon

        rings = [[self.points[v] for v in ring] for ring in self.rings()]
        found = []
        for polygon in self.polygons:
            for hole in polygon[1:]:
                ring = [self.points[v] for v in hole]
                within = [r for r in rings if r != ring and Polygon(ring).contains(Polygon(r))]
                found.append(list(Polygon(ring, within).representative_point().coords[0]))
        return found

def hard():
    """The hard inputs by name."""
    lines = (ROOT / "tests/data/hard.jsonl").read_text().splitlines()
    inputs = {content["name"]: content for content in map(json.loads, lines)}
    if folder := os.environ.get("SWEEP_CDT_HARD"):
        for path in pathlib.Path(folder).glob("*.json"):
            inputs.setdefault(path.stem, json.loads(path.read_text()))
    for name, content in sorted(inputs.items()):
        points = [[float(x), float(y)] for x, y in content["points"]]
        yield name, points, content["edges"], content["expect"]

def polygons_of(name, rings):
    """Rings that do not touch as a question."""
    flat = iter(exact.integers([p for ring in rings for p in ring]))
    at = [[next(flat) for _ in ring] for ring in rings]
    around = [[o for o in range(len(rings)) if o != r and exact.winds(at[o], at[r][0])] for r in range(len(rings))]
    question = Question(name, [])
    for outer in range(len(rings)):
        if len(around[outer]) % 2 == 0:
            holes = [r for r in range(len(rings)) if len(around[r]) == len(around[outer]) + 1 and outer in around[r]]
            polygon = []
            for r in [outer, *holes]:
                twice = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(at[r], at[r][1:] + at[r][:1]))
                start = len(question.points)
                question.points += rings[r] if (twice > 0) == (r == outer) else rings[r][::-1]
                ring = range(start, len(question.points))
                question.edges += [[v, v + 1] for v in ring[:-1]] + [[ring[-1], start]]
                polygon.append(ring)
            question.polygons.append(polygon)
    return question

def rings_of(points, edges):
    """The rings that the edges form; nothing, if they form others too."""
    beside = {}
    for a, b in edges:
        beside.setdefault(a, []).append(b)
        beside.setdefault(b, []).append(a)
    if any(len(ends) != 2 for ends in beside.values()):
        return []
    rings = []
    while beside:
        ring = [next(iter(beside))]
        while ring[-1] in beside:
            ends = beside.pop(ring[-1])
            ring.append(ends[0] if ends[0] in beside else ends[1])
        rings.append([points[v] for v in ring[:-1]])
    return rings

def star(middle, radius, size, dice):
    """A ring of so many points around a middle, at random distances."""
    ring = []
    for k in range(size):
        turn = math.tau * (k + 0.5 * dice.random()) / size
        far = radius * (0.6 + 0.4 * dice.random())
        ring.append([middle[0] + far * math.cos(turn), middle[1] + far * math.sin(turn)])
    return ring

def square(middle, radius, size, dice):
    """A turned square with so many points on each side: rounding moves them off the line."""
    turn = math.tau * dice.random()
    corners = [complex(*middle) + radius * complex(math.cos(turn), math.sin(turn)) * 1j**k for k in range(4)]
    ring = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        ring += [a + (b - a) * (k / size) for k in range(size)]
    return [[p.real, p.imag] for p in ring]

def made():
    """Polygons with holes: in each cell of a board one hole, and islands in some holes."""
    for seed in range(20):
        dice = random.Random(seed)
        cells = dice.randint(1, 5)
        unit = 10.0 ** dice.randint(-3, 3)
        corner = dice.choice([0.0, 1.0, 1e6]) * unit
        shape = [star, square][seed % 2]
        rings = [square([corner + unit * cells / 2] * 2, unit * cells, 2 + seed, dice)]
        for k in range(cells * cells):
            middle = [corner + unit * (k % cells + 0.5), corner + unit * (k // cells + 0.5)]
            rings.append(shape(middle, 0.45 * unit, dice.randint(5, 12), dice))
            if k % 3 == 0:
                rings.append(shape(middle, 0.1 * unit, dice.randint(3, 8), dice))
        yield f"made_{shape.__name__}s_{seed}", rings

def questions():
    """All of them by kind: points, edges, polygons."""
    asked = {"points": [], "edges": [], "polygons": []}
    for name, points, edges, expect in hard():
        at = None if expect == "nonfinite" else exact.integers(points)
        if at and len(exact.hull(at)) > 2:
            asked["points"].append(Question(name, points))
        if edges and expect not in HOPELESS:
            asked["edges"].append(Question(name, points, edges))
        if expect == "valid" and (rings := rings_of(points, edges)):
            asked["polygons"].append(polygons_of(name, rings))
    asked["polygons"] += [polygons_of(name, rings) for name, rings in made()]
    return asked
