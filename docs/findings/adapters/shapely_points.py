"""Shapely (GEOS): points. `pip install shapely`"""
import shapely
from lines import by_place, serve


def triangulate(question):
    found = shapely.delaunay_triangles(shapely.MultiPoint(question["points"])).geoms
    return by_place(question, [list(t.exterior.coords)[:3] for t in found])


serve("shapely", triangulate, shapely.GEOSException)
