"""mapbox_earcut: polygons with holes. `pip install mapbox_earcut`"""
import importlib.metadata
import json
import sys

import mapbox_earcut
import numpy

program = "mapbox_earcut " + importlib.metadata.version("mapbox_earcut")
for line in sys.stdin:
    question = json.loads(line)
    triangles = []
    for rings in question["polygons"]:
        vertices = [v for ring in rings for v in ring]
        places = numpy.array([question["points"][v] for v in vertices]).reshape(-1, 2)
        ends = numpy.cumsum([len(ring) for ring in rings])
        corners = mapbox_earcut.triangulate_float64(places, ends).reshape(-1, 3)
        triangles += [[vertices[corner] for corner in triangle] for triangle in corners]
    print(json.dumps({"triangles": triangles, "program": program}), flush=True)
