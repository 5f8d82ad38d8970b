"""Programs in Python as the judge asks them: `python3 adapters.py NAME`, after `pip install PACKAGE`.

A question comes as a line of JSON, triangles go out as one. The name of a function below, with the package, is a NAME.
"""
import contextlib
import importlib.metadata
import json
import sys
from fractions import Fraction

ADAPTERS = {}


class Refused(Exception):
    """The program does not take this."""


def adapter(package):
    """Registers a function that makes triangles of a question."""
    def register(function):
        ADAPTERS[function.__name__.replace("_", "-")] = package, function
        return function
    return register


@contextlib.contextmanager
def refusing(*errors):
    try:
        yield
    except errors as error:
        raise Refused(f"{type(error).__name__}: {error}".split("\n")[0])


def rings(question):
    """For each polygon its rings, as lists of coordinates."""
    return [[[question["points"][v] for v in ring] for ring in polygon] for polygon in question["polygons"]]


def turned(question, triangles):
    """Triangles of a program that promises no sense of rotation, turned counter-clockwise."""
    at = question["points"]
    turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return [t if turn(*(at[v] for v in t)) > 0 else t[::-1] for t in triangles]


def by_place(question, triangles):
    """The numbers of corners that are given as coordinates."""
    number = {tuple(p): v for v, p in enumerate(question["points"])}
    return [[number[float(x), float(y)] for x, y in t] for t in triangles]


def cdt(package, question):
    """PythonCDT and ConDelTri are bindings of CDT with one interface."""
    import numpy
    cdt = importlib.import_module(package)
    with refusing(RuntimeError, ValueError):
        result = cdt.Triangulation(cdt.VertexInsertionOrder.AUTO, cdt.IntersectingConstraintEdges.NOT_ALLOWED, 0.0)
        result.insert_vertices(numpy.array(question["points"]))
        if question["edges"]:
            result.insert_edges(numpy.array(question["edges"], dtype="uintc"))
        result.erase_super_triangle()
        return result.triangles_array()["vertices"]


@adapter("pythoncdt")
def pythoncdt_edges(question):
    return cdt("pythoncdt", question)


@adapter("condeltri")
def condeltri_edges(question):
    return cdt("condeltri", question)


@adapter("gmsh")
def gmsh_points(question):
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    found = gmsh.algorithm.triangulate([c for p in question["points"] for c in p], [])
    gmsh.finalize()
    return turned(question, [[int(v) - 1 for v in found[k : k + 3]] for k in range(0, len(found), 3)])


@adapter("manifold3d")
def manifold_polygons(question):
    import manifold3d
    import numpy
    chains = [ring for polygon in question["polygons"] for ring in polygon]
    vertices = [v for ring in chains for v in ring]
    found = manifold3d.triangulate([numpy.array([question["points"][v] for v in ring]) for ring in chains])
    return [[vertices[corner] for corner in t] for t in found]


@adapter("mapbox_earcut")
def mapbox_earcut_polygons(question):
    import mapbox_earcut
    import numpy
    for polygon in question["polygons"]:
        vertices = [v for ring in polygon for v in ring]
        places = numpy.array([question["points"][v] for v in vertices]).reshape(-1, 2)
        ends = numpy.cumsum([len(ring) for ring in polygon])
        for t in mapbox_earcut.triangulate_float64(places, ends).reshape(-1, 3):
            yield [vertices[corner] for corner in t]


@adapter("matplotlib")
def matplotlib_points(question):
    from matplotlib.tri import Triangulation
    with refusing(RuntimeError, ValueError):
        return Triangulation(*zip(*question["points"])).triangles


@adapter("pyvista")
def pyvista_points(question):
    import numpy
    import pyvista
    places = numpy.array([[x, y, 0.0] for x, y in question["points"]])
    return turned(question, pyvista.PolyData(places).delaunay_2d(tol=0.0).faces.reshape(-1, 4)[:, 1:])


@adapter("scipy")
def scipy_points(question):
    from scipy.spatial import Delaunay, QhullError
    with refusing(QhullError, ValueError):
        return Delaunay(question["points"]).simplices


@adapter("sect")
def sect_points(question):
    from ground.base import get_context
    from sect.triangulation import Triangulation
    context = get_context()
    points = [context.point_cls(*map(Fraction, p)) for p in question["points"]]
    found = Triangulation.delaunay(points, context=context).triangles()
    return by_place(question, [[(p.x, p.y) for p in t.vertices] for t in found])


@adapter("sect")
def sect_polygons(question):
    from ground.base import get_context
    from sect.triangulation import Triangulation
    context = get_context()
    contour = lambda ring: context.contour_cls([context.point_cls(*map(Fraction, p)) for p in ring])
    polygons = [context.polygon_cls(contour(r[0]), list(map(contour, r[1:]))) for r in rings(question)]
    found = [t for p in polygons for t in Triangulation.constrained_delaunay(p, context=context).triangles()]
    return by_place(question, [[(p.x, p.y) for p in t.vertices] for t in found])


@adapter("shapely")
def shapely_points(question):
    import shapely
    with refusing(shapely.GEOSException):
        found = shapely.delaunay_triangles(shapely.MultiPoint(question["points"])).geoms
    return by_place(question, [list(t.exterior.coords)[:3] for t in found])


@adapter("shapely")
def shapely_polygons(question):
    import shapely
    with refusing(shapely.GEOSException):
        polygons = shapely.MultiPolygon([shapely.Polygon(r[0], r[1:]) for r in rings(question)])
        found = shapely.constrained_delaunay_triangles(polygons).geoms
    return by_place(question, [list(t.exterior.coords)[:3] for t in found])


@adapter("startinpy")
def startinpy_points(question):
    import startinpy
    result = startinpy.DT()
    result.snap_tolerance = 1e-300
    result.insert([[x, y, 0.0] for x, y in question["points"]])
    return by_place(question, [[result.points[v][:2] for v in t] for t in result.triangles])


@adapter("triangle")
def triangle_edges(question):
    import triangle
    given = {"vertices": question["points"]}
    if question["edges"]:
        given["segments"] = question["edges"]
    with refusing(RuntimeError):
        return triangle.triangulate(given, "pc" if question["edges"] else "").get("triangles", [])


@adapter("tripy")
def tripy_polygons(question):
    import tripy
    if any(len(polygon) > 1 for polygon in question["polygons"]):
        raise Refused("a polygon has holes")
    return by_place(question, [t for r in rings(question) for t in tripy.earclip([tuple(p) for p in r[0]])])


@adapter("vispy")
def vispy_polygons(question):
    import numpy
    from vispy.geometry.triangulation import Triangulation
    at = question["points"]
    for polygon in question["polygons"]:
        used = [v for ring in polygon for v in ring]
        edges = [[used.index(a), used.index(b)] for ring in polygon for a, b in zip(ring, ring[1:] + ring[:1])]
        work = Triangulation(numpy.array([at[v] for v in used]), numpy.array(edges))
        with refusing(AssertionError):
            work.triangulate()
        yield from turned(question, by_place(question, [[work.pts[v] for v in t] for t in work.tris]))


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in ADAPTERS:
        sys.exit(f"usage: python3 adapters.py NAME, one of {', '.join(ADAPTERS)}")
    package, triangulate = ADAPTERS[sys.argv[1]]
    program = f"{package} {importlib.metadata.version(package)}"
    for line in sys.stdin:
        try:
            answer = {"triangles": [[int(v) for v in t] for t in triangulate(json.loads(line))]}
        except Refused as error:
            answer = {"refused": str(error)}
        print(json.dumps(answer | {"program": program}), flush=True)


main()
