#!/usr/bin/env python3
"""Exchanges triangulations with other programs: they read what the command writes, and it reads what they write.

    cargo build --release
    pip install meshio vtk trimesh gmsh shapely
    python3 tests/programs/exchange.py

Each reader must find the triangles that the command wrote as .json, by their coordinates. Of each writer the command
must read the file, as the result of the input, and call it correct. Prints one line for each, and ends with status 1 if
one of them fails. A package that is missing is an error.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

import gmsh
import meshio
import numpy
import shapely
import trimesh
import vtk
from vtk.util import numpy_support

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = pathlib.Path(os.environ.get("SWEEP_CDT", ROOT / "target/release/sweep-cdt"))

def with_meshio(path):
    mesh = meshio.read(path)
    return mesh.points, mesh.cells_dict["triangle"]

def with_trimesh(path):
    mesh = trimesh.load(path, process=False)
    return mesh.vertices, mesh.faces

def with_vtk(kind):
    def read(path):
        reader = getattr(vtk, kind)()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        cells = grid.GetCells() if "UnstructuredGrid" in kind else grid.GetPolys()
        corners = numpy_support.vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)
        return numpy_support.vtk_to_numpy(grid.GetPoints().GetData()), corners

    return read

def with_gmsh(path):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(str(path))
    tags, at, _ = gmsh.model.mesh.getNodes()
    _, corners = gmsh.model.mesh.getElementsByType(2)
    gmsh.finalize()
    place = {int(tag): n for n, tag in enumerate(tags)}
    return at.reshape(-1, 3), numpy.array([place[int(v)] for v in corners]).reshape(-1, 3)

def with_shapely(read):
    def parse(path):
        shapes = shapely.get_parts(read(path.read_text()))
        corners = numpy.array([shape.exterior.coords[:3] for shape in shapes])
        return corners.reshape(-1, corners.shape[-1]), numpy.arange(3 * len(shapes)).reshape(-1, 3)

    return parse

READERS = [
    *(("meshio", e, with_meshio) for e in ("vtk", "vtu", "ply", "off", "obj", "stl", "msh")),
    *(("trimesh", e, with_trimesh) for e in ("ply", "off", "obj", "stl")),
    ("vtk", "vtk", with_vtk("vtkUnstructuredGridReader")),
    ("vtk", "vtu", with_vtk("vtkXMLUnstructuredGridReader")),
    ("vtk", "ply", with_vtk("vtkPLYReader")),
    ("vtk", "obj", with_vtk("vtkOBJReader")),
    ("vtk", "stl", with_vtk("vtkSTLReader")),
    ("gmsh", "msh", with_gmsh),
    ("gmsh", "stl", with_gmsh),
    ("shapely", "wkt", with_shapely(shapely.from_wkt)),
    ("shapely", "geojson", with_shapely(shapely.from_geojson)),
]
# These hold coordinates in single precision.
SINGLE = {("vtk", "ply"), ("vtk", "obj"), ("vtk", "stl"), ("trimesh", "stl")}

def by_meshio(**options):
    return lambda path, points, corners: meshio.Mesh(points, [("triangle", corners)]).write(path, **options)

def by_trimesh(**options):
    return lambda path, points, corners: trimesh.Trimesh(points, corners, process=False).export(path, **options)

def by_vtk(kind, is_binary, mode=None):
    def write(path, points, corners):
        at = vtk.vtkPoints()
        at.SetDataTypeToDouble()
        for p in points:
            at.InsertNextPoint(*p)
        cells = vtk.vtkCellArray()
        for corner in corners:
            cells.InsertNextCell(3, corner)
        mesh = vtk.vtkPolyData() if "Poly" in kind or "STL" in kind else vtk.vtkUnstructuredGrid()
        mesh.SetPoints(at)
        mesh.SetPolys(cells) if "Poly" in kind or "STL" in kind else mesh.SetCells(vtk.VTK_TRIANGLE, cells)
        writer = getattr(vtk, kind)()
        writer.SetFileName(str(path))
        if mode:
            getattr(writer, f"SetDataModeTo{mode}")()
        else:
            writer.SetFileTypeToBinary() if is_binary else writer.SetFileTypeToASCII()
        writer.SetInputData(mesh)
        writer.Write()

    return write

def by_gmsh(path, points, corners):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    surface = gmsh.model.addDiscreteEntity(2)
    gmsh.model.mesh.addNodes(2, surface, range(1, len(points) + 1), points.flatten())
    gmsh.model.mesh.addElementsByType(surface, 2, [], corners.flatten() + 1)
    gmsh.write(str(path))
    gmsh.finalize()

def polygons(points, corners):
    return shapely.MultiPolygon([shapely.Polygon(points[t, :2]) for t in corners])

WRITERS = [
    ("meshio", "vtk", "binary, version 5.1", by_meshio(file_format="vtk")),
    ("meshio", "vtk", "text, version 4.2", by_meshio(file_format="vtk42", binary=False)),
    ("meshio", "ply", "binary", by_meshio()),
    ("meshio", "ply", "text", by_meshio(binary=False)),
    ("meshio", "off", "", by_meshio()),
    ("meshio", "obj", "", by_meshio()),
    ("meshio", "stl", "text", by_meshio()),
    ("meshio", "msh", "text, version 2.2", by_meshio(file_format="gmsh22", binary=False)),
    ("meshio", "msh", "text, version 4.1", by_meshio(file_format="gmsh", binary=False)),
    ("gmsh", "msh", "text, version 4.1", by_gmsh),
    ("meshio", "vtu", "zlib", by_meshio()),
    ("meshio", "vtu", "base 64 alone", by_meshio(compression=None)),
    ("trimesh", "ply", "binary", by_trimesh()),
    ("trimesh", "ply", "text, --tolerance 1e-7", by_trimesh(encoding="ascii")),
    ("trimesh", "off", "", by_trimesh(digits=17)),
    ("trimesh", "obj", "", by_trimesh(digits=17)),
    ("trimesh", "stl", "binary", by_trimesh()),
    ("vtk", "vtk", "polygons, binary", by_vtk("vtkPolyDataWriter", True)),
    ("vtk", "vtk", "polygons, text", by_vtk("vtkPolyDataWriter", False)),
    ("vtk", "vtk", "grid, binary", by_vtk("vtkUnstructuredGridWriter", True)),
    ("vtk", "vtk", "grid, text", by_vtk("vtkUnstructuredGridWriter", False)),
    *(("vtk", "vtu", m.lower(), by_vtk("vtkXMLUnstructuredGridWriter", True, m)) for m in ("Ascii", "Binary", "Appended")),
    ("vtk", "stl", "binary", by_vtk("vtkSTLWriter", True)),
    ("shapely", "wkt", "", lambda path, *mesh: path.write_text(shapely.to_wkt(polygons(*mesh), rounding_precision=20))),
    ("shapely", "geojson", "", lambda path, *mesh: path.write_text(shapely.to_geojson(polygons(*mesh)))),
]

def shape(points, corners, single):
    """Triangles as sets of coordinates."""
    kind = numpy.float32 if single else numpy.float64
    return {frozenset((kind(points[v][0]), kind(points[v][1])) for v in t) for t in corners}

def main():
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        source = folder / "input.json"
        # Coordinates of 17 digits.
        flat = numpy.random.default_rng(1).random((100, 2))
        source.write_text(json.dumps({"points": flat.tolist(), "edges": [[0, 1]]}))
        written = {e: folder / f"out.{e}" for e in ("json", *dict.fromkeys(e for _, e, _ in READERS))}
        outputs = [word for path in written.values() for word in ("-o", path)]
        subprocess.run([COMMAND, "triangulate", source, *outputs], check=True, capture_output=True)
        corners = numpy.array(json.loads(written["json"].read_text())["triangles"])
        points = numpy.c_[flat, numpy.zeros(len(flat))]
        for program, extension, read in READERS:
            is_single = (program, extension) in SINGLE
            try:
                same = shape(*read(written[extension]), is_single) == shape(points, corners, is_single)
                said = "the same triangles" if same else "OTHER TRIANGLES"
            except Exception as error:
                same, said = False, f"REFUSED: {type(error).__name__}: {error}"
            failures += not same
            print(f"{program:8} reads  .{extension:8} {said}")
        for program, extension, form, write in WRITERS:
            path = folder / f"theirs.{extension}"
            write(path, points, corners)
            # Single precision, rounded again as text.
            options = form.split()[1:] if "--tolerance" in form else []
            run = subprocess.run([COMMAND, "verify", source, path, *options], capture_output=True, text=True)
            lines = (run.stdout or run.stderr).replace(f"{folder}/", "").splitlines()
            failures += run.returncode != 0
            said = f"correct: {lines[1]}" if run.returncode == 0 else lines[0]
            print(f"{program:8} writes .{extension:8} {form:26} {said}")
    if failures:
        sys.exit(f"{failures} failed")

if __name__ == "__main__":
    main()
