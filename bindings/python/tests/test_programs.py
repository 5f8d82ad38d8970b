"""Results of other libraries on the inputs of tests/programs: the first try gives the verdict of the command.

Each library is asked for its own object, which `verify` takes as it is; the command gets the same triangles in a file.
The inputs, and how libraries are asked, are those of tests/programs.
"""

import json

import numpy as np
import programs
import pytest
import questions
from test_command import Files

import sweep_cdt

ASKED = questions.questions()


@pytest.fixture
def files(command, tmp_path):
    return Files(command, tmp_path)


def scipy(question):
    from scipy.spatial import Delaunay

    result = Delaunay(question.points)
    return (result,), programs.Answer(result.simplices.tolist())


def matplotlib(question):
    from matplotlib.tri import Triangulation

    result = Triangulation(*zip(*question.points))
    return (result,), programs.Answer(result.triangles.tolist())


def meshio(question):
    import meshio

    triangles = scipy(question)[1].triangles
    return (meshio.Mesh(question.points, [("triangle", triangles)]),), programs.Answer(triangles)


def pyvista(question):
    import pyvista

    places = np.column_stack([question.points, np.zeros(len(question.points))])
    # By default its points are of single precision, and points that are near become one.
    result = pyvista.PolyData(places).delaunay_2d(tol=0.0)
    return (result,), programs.Answer(result.regular_faces.tolist())


def triangle_points(question):
    import triangle

    result = triangle.triangulate({"vertices": question.points})
    return (result,), programs.Answer(result["triangles"].tolist(), result["vertices"].tolist())


def shapely_points(question):
    import shapely

    cloud = shapely.MultiPoint(question.points)
    result = shapely.delaunay_triangles(cloud)
    return (cloud, result), programs.by_coordinates(result)


def triangle_polygons(question):
    import triangle

    given = {"vertices": question.points, "segments": question.edges}
    if seeds := question.seeds():
        given["holes"] = seeds
    result = triangle.triangulate(given, "p")
    return (given, result), programs.Answer(result["triangles"].tolist(), result["vertices"].tolist())


def triangle_alone(question):
    (_, result), answer = triangle_polygons(question)
    return (result,), answer


def shapely_polygons(question):
    import shapely

    rings = lambda polygon: [[question.points[v] for v in ring] for ring in polygon]
    given = shapely.MultiPolygon([shapely.Polygon(r[0], r[1:]) for r in map(rings, question.polygons)])
    result = shapely.constrained_delaunay_triangles(given)
    return (given, result), programs.by_coordinates(result)


def earcut(question):
    answer = programs.mapbox_earcut(question)
    return (question.points, np.array(answer.triangles).ravel()), answer


# What is asked, the library's package, and the arguments of `verify` beside the object.
LIBRARIES = [
    ("points", "scipy", scipy, {}),
    ("points", "matplotlib", matplotlib, {}),
    ("points", "meshio", meshio, {}),
    ("points", "pyvista", pyvista, {}),
    ("points", "triangle", triangle_points, {}),
    ("points", "shapely", shapely_points, {}),
    ("polygons", "triangle", triangle_polygons, {}),
    ("polygons", "triangle", triangle_alone, {}),
    ("polygons", "shapely", shapely_polygons, {}),
    ("polygons", "mapbox_earcut", earcut, {"level": "constrained", "domain": "even-odd"}),
]


def verdict_of_command(files, question, answer, points, level, domain):
    """The certificate for an answer in a file."""
    files.write("in.json", points=points, edges=question.edges)
    if domain == "holes":
        content = {"points": points, "edges": question.edges, "holes": question.seeds()}
        (files.folder / "in.json").write_text(json.dumps(content))
    if answer.by_coordinates:
        ring = lambda t: ", ".join(f"{float(x)!r} {float(y)!r}" for x, y in [*t, t[0]])
        name = "result.wkt"
        text = ", ".join(f"(({ring(t)}))" for t in answer.triangles)
        (files.folder / name).write_text(f"MULTIPOLYGON ({text})\n")
    else:
        name = "result.json"
        content = {"triangles": answer.triangles}
        content |= {} if answer.points is None else {"points": answer.points}
        (files.folder / name).write_text(json.dumps(content))
    run = files.run("verify", "in.json", name, "--json", "--domain", domain, "--level", level, "--max-depth", "1e-12")
    assert run.stdout, run.stderr
    return json.loads(run.stdout)


@pytest.mark.parametrize(("kind", "package", "ask", "options"), LIBRARIES, ids=lambda each: getattr(each, "__name__", ""))
def test_the_first_try_gives_the_verdict_of_the_command(files, kind, package, ask, options):
    pytest.importorskip(package)
    asked = ASKED[kind]
    assert len(asked) == {"points": 120, "polygons": 82}[kind]
    answered, verdicts = 0, {}
    for question in asked:
        try:
            given, answer = ask(question)
        except Exception:
            # The library refuses the input.
            continue
        answered += 1
        if ask is earcut:
            options = {**options, "edges": question.edges}
        report = sweep_cdt.verify(*given, max_depth=1e-12, **options)
        # pyvista's points are what it made of the question's.
        points = given[0].points[:, :2].astype(float).tolist() if ask is pyvista else question.points
        domain = {"triangle": "holes"}.get(package, "even-odd") if kind == "polygons" else "hull"
        theirs = verdict_of_command(files, question, answer, points, report.level, domain)
        assert (report.verdict, report.reached or "none", report.found) == (
            theirs["verdict"],
            theirs["highest_level"],
            theirs["violations_found"],
        ), question.name
        verdicts[report.verdict] = verdicts.get(report.verdict, 0) + 1
    print(f"{ask.__name__}: {len(asked)} asked, {answered} answered: {verdicts}")
    assert answered >= 115 if kind == "points" else answered == 82
