"""PythonCDT and ConDelTri, bindings of CDT with one interface: points with edges. `pip install pythoncdt condeltri`

The argument is the package: `pythoncdt` or `condeltri`.
"""
import importlib
import sys

import numpy
from lines import serve

package = sys.argv[1]
cdt = importlib.import_module(package)


def triangulate(question):
    result = cdt.Triangulation(cdt.VertexInsertionOrder.AUTO, cdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0)
    result.insert_vertices(numpy.array(question["points"]))
    if question["edges"]:
        result.insert_edges(numpy.array(question["edges"], dtype="uintc"))
    result.erase_super_triangle()
    return result.triangles_array()["vertices"]


serve(package, triangulate, (RuntimeError, ValueError))
