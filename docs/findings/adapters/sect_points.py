"""sect: points. `pip install sect`"""
from fractions import Fraction

from ground.base import get_context
from lines import by_place, serve
from sect.triangulation import Triangulation

context = get_context()
point = lambda place: context.point_cls(*map(Fraction, place))


def triangulate(question):
    found = Triangulation.delaunay([point(p) for p in question["points"]], context=context).triangles()
    return by_place(question, [[(p.x, p.y) for p in t.vertices] for t in found])


serve("sect", triangulate)
