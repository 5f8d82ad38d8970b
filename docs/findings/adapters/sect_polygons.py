"""sect: polygons with holes. `pip install sect`"""
from fractions import Fraction

from ground.base import get_context
from lines import by_place, rings, serve
from sect.triangulation import Triangulation

context = get_context()
contour = lambda ring: context.contour_cls([context.point_cls(*map(Fraction, p)) for p in ring])


def triangulate(question):
    polygons = [context.polygon_cls(contour(r[0]), list(map(contour, r[1:]))) for r in rings(question)]
    found = [t for p in polygons for t in Triangulation.constrained_delaunay(p, context=context).triangles()]
    return by_place(question, [[(p.x, p.y) for p in t.vertices] for t in found])


serve("sect", triangulate)
