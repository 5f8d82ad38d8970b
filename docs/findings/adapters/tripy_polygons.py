"""tripy: polygons without holes. `pip install tripy`"""
import tripy
from lines import by_place, rings, serve


class Holes(Exception):
    """Only outlines are claimed."""


def triangulate(question):
    if any(len(polygon) > 1 for polygon in question["polygons"]):
        raise Holes("a polygon has holes")
    return by_place(question, [t for r in rings(question) for t in tripy.earclip([tuple(p) for p in r[0]])])


serve("tripy", triangulate, Holes)
