"""PyVista (VTK): points. `pip install pyvista`"""
import numpy
import pyvista
from lines import serve, turned


def triangulate(question):
    places = numpy.array([[x, y, 0.0] for x, y in question["points"]])
    return turned(question, pyvista.PolyData(places).delaunay_2d(tol=0.0).faces.reshape(-1, 4)[:, 1:])


serve("pyvista", triangulate)
