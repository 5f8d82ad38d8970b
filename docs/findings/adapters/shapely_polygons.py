"""Shapely (GEOS): polygons with holes. `pip install shapely`"""
import shapely
from lines import by_place, rings, serve


def triangulate(question):
    polygons = shapely.MultiPolygon([shapely.Polygon(r[0], r[1:]) for r in rings(question)])
    found = shapely.constrained_delaunay_triangles(polygons).geoms
    return by_place(question, [list(t.exterior.coords)[:3] for t in found])


serve("shapely", triangulate, shapely.GEOSException)
