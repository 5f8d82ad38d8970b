"""VisPy: polygons with holes. `pip install vispy`"""
import numpy
from lines import by_place, serve, turned
from vispy.geometry.triangulation import Triangulation


def triangulate(question):
    at = question["points"]
    for polygon in question["polygons"]:
        used = [v for ring in polygon for v in ring]
        edges = [[used.index(a), used.index(b)] for ring in polygon for a, b in zip(ring, ring[1:] + ring[:1])]
        work = Triangulation(numpy.array([at[v] for v in used]), numpy.array(edges))
        work.triangulate()
        yield from turned(question, by_place(question, [[work.pts[v] for v in t] for t in work.tris]))


serve("vispy", triangulate, AssertionError)
