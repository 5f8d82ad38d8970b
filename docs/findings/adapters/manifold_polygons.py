"""Manifold: polygons with holes. `pip install manifold3d`"""
import manifold3d
import numpy
from lines import serve


def triangulate(question):
    chains = [ring for polygon in question["polygons"] for ring in polygon]
    vertices = [v for ring in chains for v in ring]
    found = manifold3d.triangulate([numpy.array([question["points"][v] for v in ring]) for ring in chains])
    return [[vertices[corner] for corner in t] for t in found]


serve("manifold3d", triangulate)
