"""Objects of other libraries, in both directions. Each library's result gets the right verdict at the first try."""

import numpy as np
import pytest

import sweep_cdt

POINTS = np.random.default_rng(11).random((400, 2))
OUTLINE = [(0, 0), (9, 0), (9, 9), (4, 7), (0, 9)]
HOLE = [(3, 3), (6, 3), (6, 6), (3, 6)]


def test_scipy():
    spatial = pytest.importorskip("scipy.spatial")
    assert sweep_cdt.verify(spatial.Delaunay(POINTS))
    assert sweep_cdt.verify(POINTS, spatial.Delaunay(POINTS))
    with pytest.raises(sweep_cdt.Error):
        sweep_cdt.verify(spatial.Delaunay(np.random.default_rng(1).random((9, 3))))


def test_matplotlib():
    tri = pytest.importorskip("matplotlib.tri")
    theirs = tri.Triangulation(*POINTS.T)
    assert sweep_cdt.verify(theirs)
    theirs.set_mask(np.arange(len(theirs.triangles)) == 3)
    assert not sweep_cdt.verify(theirs)
    ours = sweep_cdt.triangulate(POINTS).to_matplotlib()
    assert sweep_cdt.verify(ours) and np.isfinite(tri.LinearTriInterpolator(ours, POINTS[:, 0])(0.5, 0.5))
    with pytest.raises(sweep_cdt.Error, match="no triangles"):
        sweep_cdt.triangulate([]).to_matplotlib()


def test_plot():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.figure()
    axes = sweep_cdt.triangulate(POINTS, [[0, 1]]).plot()
    assert axes is pyplot.gca() and len(axes.collections) == 1
    assert sweep_cdt.triangulate([]).plot(pyplot.figure().gca()).lines[:] == []


def test_triangle():
    triangle = pytest.importorskip("triangle")
    edges = [[v, (v + 1) % 5] for v in range(5)] + [[5 + v, 5 + (v + 1) % 4] for v in range(4)]
    given = {"vertices": OUTLINE + HOLE, "segments": edges, "holes": [[4, 4]]}
    for options in ("p", "pc"):
        theirs = triangle.triangulate(given, options)
        assert sweep_cdt.verify(theirs) and sweep_cdt.verify(given, theirs), options
        plain = {"vertices": OUTLINE + HOLE, "segments": edges}
        assert sweep_cdt.verify(plain, triangle.triangulate(plain, options)), options
    assert not sweep_cdt.verify(given, triangle.triangulate(given, "pc"), domain="holes")
    assert sweep_cdt.verify(given, triangle.triangulate(given, "pqa0.5"), steiner=True)
    assert sweep_cdt.verify(triangle.triangulate({"vertices": POINTS}))
    # Vertices that were added on edges are rounded.
    for name in ("A", "la", "face"):
        sample = triangle.get_data(name)
        mesh = triangle.triangulate(sample, "pq")
        report = sweep_cdt.verify(sample, mesh, steiner=True, max_depth=1e-12)
        assert report and (report.deepest or 0) < 1e-14, (name, str(report))
        if report.found:
            again = sweep_cdt.verify(sample, mesh, steiner=True)
            assert not again and "max_depth=1e-12 accepts" in again.advice
    # The hole takes all triangles.
    box = triangle.get_data("box")
    assert sweep_cdt.verify(box, triangle.triangulate(box, "p"))
    ours = sweep_cdt.triangulate(given)
    assert ours.rule == "holes" and sweep_cdt.verify(given, ours)
    back = ours.to_triangle()
    assert sweep_cdt.verify(sweep_cdt.triangulate(given, inside="hull").to_triangle())
    assert sweep_cdt.verify(sweep_cdt.triangulate([], polygons=[[OUTLINE, HOLE]]).to_triangle())
    assert sweep_cdt.verify(back) and sweep_cdt.verify(given, back)
    sides = lambda triangles, neighbors: {
        (frozenset(corners), corners[i], frozenset(triangles[n].tolist()) if n >= 0 else None)
        for corners, across in zip(triangles.tolist(), neighbors.tolist())
        for i, n in enumerate(across)
    }
    # Without ties the triangles are the same.
    theirs, ours = triangle.triangulate({"vertices": POINTS}, "n"), sweep_cdt.triangulate(POINTS)
    assert sides(ours.simplices, ours.neighbors) == sides(theirs["triangles"], theirs["neighbors"])


def test_shapely():
    shapely = pytest.importorskip("shapely")
    cloud = shapely.MultiPoint(POINTS)
    assert sweep_cdt.verify(shapely.delaunay_triangles(cloud))
    assert sweep_cdt.verify(POINTS, shapely.delaunay_triangles(cloud))
    assert sweep_cdt.verify(cloud, shapely.delaunay_triangles(cloud))
    polygon = shapely.Polygon(OUTLINE, [HOLE])
    theirs = shapely.constrained_delaunay_triangles(polygon)
    report = sweep_cdt.verify(polygon, theirs)
    assert report and report.domain == "polygons"
    ours = sweep_cdt.triangulate(polygon)
    assert ours.area == polygon.area and sweep_cdt.verify(polygon, ours.to_shapely())
    assert len(ours.to_shapely().geoms) == len(theirs.geoms)
    for wrong in (shapely.Point(0, 0), [polygon], [shapely.LineString([(0, 0), (1, 1)])]):
        with pytest.raises(sweep_cdt.Error):
            sweep_cdt.verify(POINTS, wrong)


def test_geometries_of_all_kinds():
    shapely = pytest.importorskip("shapely")
    island = shapely.Polygon([(4, 4), (5, 4), (4, 5)])
    polygon = shapely.MultiPolygon([shapely.Polygon(OUTLINE, [HOLE]), island])
    line = shapely.MultiLineString([[(1, 1), (2, 2), (1, 5)], [(7, 7), (8, 1)]])
    more = shapely.GeometryCollection([shapely.Point(1, 2), shapely.MultiPoint([(2, 1), (8, 8)]), shapely.Polygon()])
    result = sweep_cdt.triangulate([polygon, shapely.GeometryCollection([line, more])])
    assert result.area == polygon.area and len(result.edges) == 5 + 4 + 3 + 3
    assert len(result.duplicates) == 0 and len(result.points) == 5 + 4 + 3 + 5 + 3
    assert set(result.region[result.inside]) == {0}
    with_more = sweep_cdt.triangulate(POINTS * 9, polygons=polygon)
    assert abs(with_more.area - polygon.area) < 1e-9
    assert len(sweep_cdt.triangulate(shapely.MultiPoint())._input.points) == 0
    with pytest.raises(sweep_cdt.Error, match="one list"):
        sweep_cdt.triangulate(polygon, [[0, 1]])


def test_geopandas():
    geopandas = pytest.importorskip("geopandas")
    import shapely

    boxes = [shapely.box(x, 0, x + 1, 1) for x in range(3)]
    frame = geopandas.GeoDataFrame({"name": list("abcd")}, geometry=[boxes[0], None, boxes[1], boxes[2]])
    for given in (frame, frame.geometry):
        result = sweep_cdt.triangulate(given)
        assert result.area == 3 and len(result.points) == 8
        assert sorted(result.region.tolist()) == [0, 0, 2, 2, 3, 3]
        assert sweep_cdt.verify(given, result)


def test_meshio(tmp_path):
    meshio = pytest.importorskip("meshio")
    ours = sweep_cdt.triangulate(POINTS, [[0, 1]]).to_meshio(POINTS[:, 0])
    assert ours.points.shape == (400, 3) and sweep_cdt.verify(ours)
    for name in ("mesh.vtu", "mesh.obj", "mesh.stl", "mesh.ply", "mesh.off"):
        # A line is not written to most of them.
        meshio.Mesh(ours.points, ours.cells[:1]).write(tmp_path / name)
        report = sweep_cdt.verify(POINTS, meshio.read(tmp_path / name), level="constrained")
        assert report, (name, str(report))
    with pytest.raises(sweep_cdt.ShapeError):
        sweep_cdt.verify(meshio.Mesh([[0.0], [1.0], [2.0]], [("triangle", [[0, 1, 2]])]))


def test_pyvista():
    pyvista = pytest.importorskip("pyvista")
    single = np.column_stack([POINTS.astype(np.float32), np.zeros(400, dtype=np.float32)])
    # Of single precision, as it is made by default.
    mesh = pyvista.PolyData(single)
    ours = sweep_cdt.triangulate(single[:, :2])
    mesh.faces = np.column_stack([np.full(len(ours.simplices), 3), ours.simplices]).ravel()
    assert mesh.points.dtype == np.float32 and sweep_cdt.verify(mesh)
    doubles = sweep_cdt.triangulate(POINTS, [[0, 1], [0, 2]]).to_pyvista()
    assert doubles.n_cells > 700 and sweep_cdt.verify(doubles)
    assert sweep_cdt.verify(POINTS, doubles, [[0, 1], [0, 2]])
    rounded = sweep_cdt.triangulate(POINTS).to_pyvista()
    rounded.points = rounded.points.astype(np.float32)
    assert sweep_cdt.verify(POINTS, rounded).matched.startswith("vertices matched by number, because coordinates are rounded")
    with pytest.raises(sweep_cdt.ShapeError, match="not all triangles"):
        sweep_cdt.verify(pyvista.Plane(i_resolution=1, j_resolution=1))
    grid = sweep_cdt.triangulate(POINTS).to_pyvista().cast_to_unstructured_grid()
    assert sweep_cdt.verify(grid)


def test_earcut():
    earcut = pytest.importorskip("mapbox_earcut")
    vertices = np.array(OUTLINE + HOLE, dtype=float)
    corners = earcut.triangulate_float64(vertices, np.array([5, 9], dtype=np.uint32))
    polygon = [[list(range(5)), list(range(5, 9))]]
    assert sweep_cdt.verify(vertices, corners, polygons=polygon, level="constrained")
    assert not sweep_cdt.verify(vertices, corners[:-3], polygons=polygon, level="constrained")
