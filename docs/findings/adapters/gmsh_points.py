"""Gmsh: points. `pip install gmsh`"""
import gmsh
from lines import serve, turned


def triangulate(question):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    found = gmsh.algorithm.triangulate([c for p in question["points"] for c in p], [])
    gmsh.finalize()
    return turned(question, [[int(v) - 1 for v in found[k : k + 3]] for k in range(0, len(found), 3)])


serve("gmsh", triangulate)
