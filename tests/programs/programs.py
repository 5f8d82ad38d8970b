"""Other programs behind one signature: a question in, triangles out.

Programs in Python are imported when they are first asked. Programs in Rust are run by `benches/peers`. What a program
raises is how it refuses; it may also crash or never end, so that `run.py` asks it in a process of its own.
"""

import dataclasses
import importlib.metadata
import os
import pathlib
import struct
import subprocess
import tempfile
import typing

import exact

ROOT = pathlib.Path(__file__).resolve().parents[2]
PEERS = ROOT / "benches/peers"

@dataclasses.dataclass
class Answer:
    """Triangles by the numbers of their vertices: the question's, or `points`. Or by coordinates, without numbers."""

    triangles: list
    points: list | None = None
    by_coordinates: bool = False

@dataclasses.dataclass
class Program:
    name: str
    # What has its version: a package of Python, or a crate of benches/peers.
    package: str
    # What it is asked: points, edges, polygons.
    kind: str
    # What it promises, and what the triangles are to fill.
    level: str
    domain: str
    call: typing.Callable
    adds_points: bool = False
    is_crate: bool = False
    # Whether its triangles run both ways: they are turned before they are judged.
    is_mixed: bool = False
    takes_holes: bool = True

    def answer(self, question):
        """The answer of a program, or what it raises."""
        answer = self.call(question)
        if self.is_mixed:
            at = exact.integers(question.points)
            answer.triangles = [t if exact.turn(*(at[v] for v in t)) > 0 else t[::-1] for t in answer.triangles]
        return answer

    def questions(self, asked):
        """What it is asked of all questions."""
        asked = asked[self.kind]
        return asked if self.takes_holes else [q for q in asked if all(len(p) == 1 for p in q.polygons)]

    def version(self):
        """The version of a program; nothing, if it is not installed."""
        if self.is_crate:
            lines = iter((PEERS / "Cargo.lock").read_text().splitlines())
            return next(next(lines).split('"')[1] for line in lines if line == f'name = "{self.package}"')
        try:
            return importlib.metadata.version(self.package)
        except importlib.metadata.PackageNotFoundError:
            return None

def each_polygon(ask):
    """Asks for one polygon after the other: its points, and where each ring ends."""

    def run(question):
        triangles = []
        for polygon in question.polygons:
            start = polygon[0].start
            points = question.points[start : polygon[-1].stop]
            found = ask(points, [ring.stop - start for ring in polygon])
            triangles += [[int(v) + start for v in t] for t in found]
        return Answer(triangles)

    return run

def crate(name):
    """A crate, through the binary files of crates/testing/src/binary.rs."""

    def ask(points, edges):
        data = struct.pack("<3Q", 1, len(points), len(edges))
        data += b"".join(struct.pack("<2d", *p) for p in points)
        data += b"".join(struct.pack("<2Q", *e) for e in edges)
        with tempfile.TemporaryDirectory() as folder:
            question, answer = pathlib.Path(folder, "question"), pathlib.Path(folder, "answer")
            question.write_bytes(data)
            command = [PEERS / "target/release/sweep-cdt-peers", "cell", name, question, "1", answer]
            run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "RUST_BACKTRACE": "0"})
            if run.returncode < 0:
                raise ChildProcessError(f"signal {-run.returncode}")
            if run.returncode:
                said = [line for line in run.stderr.splitlines() if line and not line.startswith("note: ")][-1]
                refused = "an input that the program takes: "
                raise ValueError(said.removeprefix(refused)) if said.startswith(refused) else ChildProcessError(said)
            count, *corners = struct.unpack(f"<{answer.stat().st_size // 8}Q", answer.read_bytes())
            return [corners[3 * t : 3 * t + 3] for t in range(count)]

    def inside(points, ends):
        starts = [0, *ends[:-1]]
        edges = [[v, v + 1 if v + 1 < end else start] for start, end in zip(starts, ends) for v in range(start, end)]
        return ask(points, edges)

    whole = lambda question: Answer(ask(question.points, question.edges))
    return lambda question: each_polygon(inside)(question) if question.polygons else whole(question)

def scipy(question):
    from scipy.spatial import Delaunay

    return Answer(Delaunay(question.points).simplices.tolist())

def matplotlib(question):
    from matplotlib.tri import Triangulation

    return Answer(Triangulation(*zip(*question.points)).triangles.tolist())

def triangle(options):
    def run(question):
        import triangle

        given = {"vertices": question.points}
        if question.edges:
            given["segments"] = question.edges
        if seeds := question.seeds():
            given["holes"] = seeds
        result = triangle.triangulate(given, options)
        return Answer(result["triangles"].tolist(), result["vertices"].tolist())

    return run

def meshpy(adds_points):
    def run(question):
        from meshpy.triangle import MeshInfo, build

        info = MeshInfo()
        info.set_points(question.points)
        info.set_facets(question.edges)
        if seeds := question.seeds():
            info.set_holes(seeds)
        angle = {"min_angle": 20} if adds_points else {"quality_meshing": False}
        mesh = build(info, **angle)
        return Answer([list(t) for t in mesh.elements], [list(p) for p in mesh.points])

    return run

def by_coordinates(collection):
    return Answer([list(t.exterior.coords)[:3] for t in collection.geoms], by_coordinates=True)

def geos(question):
    import shapely

    return by_coordinates(shapely.delaunay_triangles(shapely.MultiPoint(question.points)))

def geos_constrained(question):
    import shapely

    rings = lambda polygon: [[question.points[v] for v in ring] for ring in polygon]
    polygons = [shapely.Polygon(r[0], r[1:]) for r in map(rings, question.polygons)]
    return by_coordinates(shapely.constrained_delaunay_triangles(shapely.MultiPolygon(polygons)))

@each_polygon
def mapbox_earcut(points, ends):
    import numpy
    from mapbox_earcut import triangulate_float64

    corners = triangulate_float64(numpy.array(points), numpy.array(ends, dtype="uint32"))
    return corners.reshape(-1, 3)

def manifold(question):
    import manifold3d
    import numpy

    rings = [numpy.array([question.points[v] for v in ring]) for ring in question.rings()]
    return Answer(manifold3d.triangulate(rings).tolist())

def vtk_data(question, lines):
    """Points of VTK in doubles, with lines through these vertices."""
    import vtk

    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for x, y in question.points:
        points.InsertNextPoint(x, y, 0)
    cells = vtk.vtkCellArray()
    for line in lines:
        cells.InsertNextCell(len(line))
        for v in line:
            cells.InsertCellPoint(v)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(cells)
    return data

def vtk_answer(worker):
    from vtk.util.numpy_support import vtk_to_numpy

    worker.Update()
    cells = worker.GetOutput().GetPolys()
    return Answer(vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3).tolist())

def vtk_delaunay(question):
    import vtk

    worker = vtk.vtkDelaunay2D()
    worker.SetTolerance(0)
    worker.SetInputData(vtk_data(question, []))
    if question.edges:
        worker.SetSourceData(vtk_data(question, question.edges))
    return vtk_answer(worker)

def vtk_contours(question):
    import vtk

    worker = vtk.vtkContourTriangulator()
    worker.SetInputData(vtk_data(question, [[*ring, ring[0]] for ring in question.rings()]))
    return vtk_answer(worker)

def gmsh_plain(question):
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    flat = [c for p in question.points for c in p]
    edges = [v + 1 for edge in question.edges for v in edge]
    corners = gmsh.algorithm.triangulate(flat, edges)
    gmsh.finalize()
    return Answer([[int(v) - 1 for v in corners[t : t + 3]] for t in range(0, len(corners), 3)])

def gmsh_mesh(question):
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    # By Delaunay triangles; edges are not split.
    gmsh.option.setNumber("Mesh.Algorithm", 5)
    kernel = gmsh.model.geo
    corners = [kernel.addPoint(x, y, 0) for x, y in question.points]
    lines = [kernel.addLine(corners[a], corners[b]) for a, b in question.edges]
    for polygon in question.polygons:
        loops = [kernel.addCurveLoop([lines[v] for v in ring]) for ring in polygon]
        kernel.addPlaneSurface(loops)
    for line in lines:
        kernel.mesh.setTransfiniteCurve(line, 2)
    kernel.synchronize()
    gmsh.model.mesh.generate(2)
    tags, at, _ = gmsh.model.mesh.getNodes()
    place = {int(tag): n for n, tag in enumerate(tags)}
    _, found = gmsh.model.mesh.getElementsByType(2)
    gmsh.finalize()
    points = [[float(at[3 * n]), float(at[3 * n + 1])] for n in range(len(tags))]
    numbers = [place[int(tag)] for tag in found]
    return Answer([numbers[t : t + 3] for t in range(0, len(numbers), 3)], points)

def cdt_cpp(question):
    import numpy
    import pythoncdt as cdt

    result = cdt.Triangulation(cdt.VertexInsertionOrder.AUTO, cdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0)
    result.insert_vertices(numpy.array(question.points))
    if question.edges:
        result.insert_edges(numpy.array(question.edges, dtype="uintc"))
    if question.polygons:
        result.erase_outer_triangles_and_holes()
    else:
        result.erase_super_triangle()
    return Answer(result.triangles_array()["vertices"].tolist())

def cgal(question):
    from CGAL.CGAL_Kernel import Point_2
    from CGAL.CGAL_Triangulation_2 import Constrained_Delaunay_triangulation_2

    result = Constrained_Delaunay_triangulation_2()
    points = [Point_2(x, y) for x, y in question.points]
    for p in points:
        result.insert(p)
    for a, b in question.edges:
        result.insert_constraint(points[a], points[b])
    corners = [[face.vertex(k).point() for k in range(3)] for face in result.finite_faces()]
    return Answer([[(p.x(), p.y()) for p in t] for t in corners], by_coordinates=True)

def libigl(question):
    import igl.copyleft.cgal
    import numpy

    return Answer(igl.copyleft.cgal.delaunay_triangulation(numpy.array(question.points)).tolist())

def startin(question):
    import startinpy

    result = startinpy.DT()
    result.snap_tolerance = 1e-300
    result.insert([[x, y, 0] for x, y in question.points])
    # Its vertex 0 is at infinity.
    points = [[x, y] for x, y, _ in result.points[1:].tolist()]
    return Answer([[int(v) - 1 for v in t] for t in result.triangles], points)

P, E, R = "points", "edges", "polygons"
PROGRAMS = [
    Program("scipy", "scipy", P, "delaunay", "hull", scipy),
    Program("matplotlib", "matplotlib", P, "delaunay", "hull", matplotlib),
    Program("shapely", "shapely", P, "delaunay", "hull", geos),
    Program("vtk Delaunay2D", "vtk", P, "delaunay", "hull", vtk_delaunay, is_mixed=True),
    Program("gmsh triangulate", "gmsh", P, "delaunay", "hull", gmsh_plain, is_mixed=True),
    Program("libigl with CGAL", "libigl", P, "delaunay", "hull", libigl),
    Program("startinpy", "startinpy", P, "delaunay", "hull", startin),
    Program("PythonCDT", "PythonCDT", P, "delaunay", "hull", cdt_cpp),
    Program("triangle", "triangle", P, "delaunay", "hull", triangle("")),
    Program("triangle i", "triangle", P, "delaunay", "hull", triangle("i")),
    Program("triangle F", "triangle", P, "delaunay", "hull", triangle("F")),
    Program("vtk Delaunay2D, edges", "vtk", E, "constrained", "hull", vtk_delaunay, is_mixed=True),
    Program("gmsh triangulate, edges", "gmsh", E, "constrained", "hull", gmsh_plain, is_mixed=True),
    Program("PythonCDT, edges", "PythonCDT", E, "delaunay", "hull", cdt_cpp),
    Program("cgal", "cgal", E, "delaunay", "hull", cgal),
    Program("triangle pc", "triangle", E, "delaunay", "hull", triangle("pc")),
    Program("triangle pci", "triangle", E, "delaunay", "hull", triangle("pci")),
    Program("triangle pcF", "triangle", E, "delaunay", "hull", triangle("pcF")),
    Program("triangle p", "triangle", R, "delaunay", "holes", triangle("p")),
    Program("triangle pq", "triangle", R, "delaunay", "holes", triangle("pq"), adds_points=True),
    Program("meshpy", "meshpy", R, "delaunay", "holes", meshpy(False)),
    Program("meshpy, angles", "meshpy", R, "delaunay", "holes", meshpy(True), adds_points=True),
    Program("gmsh mesh", "gmsh", R, "constrained", "even-odd", gmsh_mesh, adds_points=True),
    Program("shapely constrained", "shapely", R, "delaunay", "even-odd", geos_constrained),
    Program("PythonCDT, inside", "PythonCDT", R, "delaunay", "even-odd", cdt_cpp),
    Program("mapbox_earcut", "mapbox_earcut", R, "constrained", "even-odd", mapbox_earcut),
    Program("manifold3d", "manifold3d", R, "constrained", "nonzero", manifold),
    Program("vtk ContourTriangulator", "vtk", R, "constrained", "nonzero", vtk_contours),
]
# Crates of benches/peers, by the names they have there.
PROGRAMS += [
    Program(name, package, kind, level, "even-odd" if kind == R else "hull", crate(name), is_crate=True, **more)
    for name, package, kind, level, more in [
        ("delaunator", "delaunator", P, "delaunay", {}),
        ("cdt", "cdt", P, "delaunay", {}),
        ("ghx", "ghx_constrained_delaunay", P, "delaunay", {}),
        ("spade", "spade", E, "delaunay", {}),
        ("cdt inside", "cdt", R, "delaunay", {}),
        ("ghx inside", "ghx_constrained_delaunay", R, "delaunay", {}),
        ("geo", "geo", R, "delaunay", {}),
        ("i_triangle grid", "i_triangle", R, "delaunay", {}),
        ("poly2tri-rs", "poly2tri-rs", R, "delaunay", {"takes_holes": False}),
        ("earcut", "earcut", R, "constrained", {}),
        ("earcut refined", "earcut", R, "delaunay", {}),
        ("earcutr", "earcutr", R, "constrained", {}),
    ]
]
