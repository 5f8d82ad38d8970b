"""mapbox_earcut: polygons with holes. `pip install mapbox_earcut`"""
import mapbox_earcut
import numpy
from lines import serve


def triangulate(question):
    for polygon in question["polygons"]:
        vertices = [v for ring in polygon for v in ring]
        places = numpy.array([question["points"][v] for v in vertices]).reshape(-1, 2)
        ends = numpy.cumsum([len(ring) for ring in polygon])
        for t in mapbox_earcut.triangulate_float64(places, ends).reshape(-1, 3):
            yield [vertices[corner] for corner in t]


serve("mapbox_earcut", triangulate)
