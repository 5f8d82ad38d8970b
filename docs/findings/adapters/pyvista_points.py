"""PyVista (VTK): points. `pip install pyvista`"""
import numpy
import pyvista
from lines import serve


def triangulate(question):
    places = numpy.array([[x, y, 0.0] for x, y in question["points"]])
    found = pyvista.PolyData(places).delaunay_2d(tol=0.0).faces.reshape(-1, 4)[:, 1:]
    # The triangles run both ways: all are turned counter-clockwise.
    turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return [t if turn(*(places[v] for v in t)) > 0 else t[::-1] for t in found]


serve("pyvista", triangulate)
