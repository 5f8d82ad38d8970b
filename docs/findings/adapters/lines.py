"""The lines of an adapter in Python: a question in, triangles out. What is refused is raised as `refused`."""
import importlib.metadata
import json
import sys


def serve(package, triangulate, refused=()):
    """Answers each question with what `triangulate` returns."""
    program = f"{package} {importlib.metadata.version(package)}"
    for line in sys.stdin:
        try:
            answer = {"triangles": [[int(v) for v in t] for t in triangulate(json.loads(line))]}
        except refused as error:
            answer = {"refused": f"{type(error).__name__}: {error}".split("\n")[0]}
        print(json.dumps(answer | {"program": program}), flush=True)


def rings(question):
    """For each polygon its rings, as lists of coordinates."""
    return [[[question["points"][v] for v in ring] for ring in polygon] for polygon in question["polygons"]]


def turned(question, triangles):
    """Triangles of a program that promises no sense of rotation, turned counter-clockwise."""
    at = question["points"]
    turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return [t if turn(*(at[v] for v in t)) > 0 else t[::-1] for t in triangles]


def by_place(question, triangles):
    """The numbers of corners that are given as coordinates."""
    number = {tuple(p): v for v, p in enumerate(question["points"])}
    return [[number[float(x), float(y)] for x, y in t] for t in triangles]
