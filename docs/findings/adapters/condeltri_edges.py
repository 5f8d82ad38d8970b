"""ConDelTri: points with edges. `pip install condeltri`"""
import numpy
import condeltri as cdt
from lines import serve


def triangulate(question):
    result = cdt.Triangulation(cdt.VertexInsertionOrder.AUTO, cdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0)
    result.insert_vertices(numpy.array(question["points"]))
    if question["edges"]:
        result.insert_edges(numpy.array(question["edges"], dtype="uintc"))
    result.erase_super_triangle()
    return result.triangles_array()["vertices"]


serve("condeltri", triangulate, (RuntimeError, ValueError))
