"""Gmsh: points. `pip install gmsh`"""
import gmsh
from lines import serve


def triangulate(question):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    found = gmsh.algorithm.triangulate([c for p in question["points"] for c in p], [])
    gmsh.finalize()
    at = question["points"]
    turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    # The triangles run both ways: all are turned counter-clockwise.
    triangles = [[int(v) - 1 for v in found[k : k + 3]] for k in range(0, len(found), 3)]
    return [t if turn(*(at[v] for v in t)) > 0 else t[::-1] for t in triangles]


serve("gmsh", triangulate)
