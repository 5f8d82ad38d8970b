"""VisPy: polygons with holes. `pip install vispy`"""
import numpy
from lines import by_place, serve
from vispy.geometry.triangulation import Triangulation


def triangulate(question):
    at = question["points"]
    # No sense of rotation is promised: all triangles are turned counter-clockwise.
    turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    for polygon in question["polygons"]:
        used = [v for ring in polygon for v in ring]
        edges = [[used.index(a), used.index(b)] for ring in polygon for a, b in zip(ring, ring[1:] + ring[:1])]
        work = Triangulation(numpy.array([at[v] for v in used]), numpy.array(edges))
        work.triangulate()
        for t in by_place(question, [[work.pts[v] for v in t] for t in work.tris]):
            yield t if turn(*(at[v] for v in t)) >= 0 else t[::-1]


serve("vispy", triangulate, AssertionError)
