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


def roof(shapely):
    """A polygon with heights and a hole, and a triangulation of it."""
    with_heights = lambda ring: [(x, y, 10.0 + x + 2 * y) for x, y in ring]
    polygon = shapely.Polygon(with_heights(OUTLINE), [with_heights(HOLE)])
    return polygon, sweep_cdt.triangulate(polygon)


@pytest.mark.parametrize("options", ["", "p", "pc", "pr", "pq", "prq", "pra0.5", "prA"])
def test_triangle_takes_what_is_made_for_it(options):
    triangle = pytest.importorskip("triangle")
    shapely = pytest.importorskip("shapely")
    _, result = roof(shapely)
    for ours in (result, sweep_cdt.triangulate(POINTS, [[0, 1]]), sweep_cdt.triangulate(OUTLINE, [[0, 3]])):
        theirs = triangle.triangulate(ours.to_triangle(), options)
        if options.startswith("pr") and options[-1] not in "q5":
            # Nothing is to be refined.
            sets = [{frozenset(t) for t in triangles.tolist()} for triangles in (theirs["triangles"], ours.triangles)]
            assert sets[0] == sets[1]
        if "p" in options:
            area = sweep_cdt.triangulate(theirs["vertices"], polygons=[[t] for t in theirs["triangles"]]).area
            assert abs(area - ours.area) < 1e-9
        if ours.heights is not None:
            x, y = theirs["vertices"].T
            assert np.allclose(theirs["vertex_attributes"][:, 0], 10 + x + 2 * y)


def test_geopandas_takes_what_is_made_for_it():
    geopandas = pytest.importorskip("geopandas")
    import shapely

    polygon, _ = roof(shapely)
    land = geopandas.GeoDataFrame({"name": ["roof"]}, geometry=[polygon], crs=2056)
    triangles = sweep_cdt.triangulate(land).to_geodataframe()
    assert triangles.to_crs(4326).crs.to_epsg() == 4326 and triangles.geometry.union_all().area == polygon.area
    assert set(triangles.sjoin(land, predicate="within").name) == {"roof"}
    assert triangles.geometry.force_2d().has_z.sum() == 0 and triangles.has_z.all()
    assert len(geopandas.GeoDataFrame.from_features(triangles.__geo_interface__)) == len(triangles)
    assert len(sweep_cdt.triangulate(land, inside="negative").to_geodataframe()) == 0


def test_rasterio_takes_what_is_made_for_it():
    pytest.importorskip("rasterio")
    rasterio = pytest.importorskip("rasterio.features")
    shapely = pytest.importorskip("shapely")
    polygon, result = roof(shapely)
    parts = result.to_shapely().geoms
    by_triangle = rasterio.rasterize(((part, n + 1) for n, part in enumerate(parts)), (9, 9))
    whole = rasterio.rasterize([(polygon, 1)], (9, 9))
    assert ((by_triangle > 0) == (whole > 0)).all() and by_triangle.max() <= len(result.triangles)


def test_a_raster_of_rasterio_is_terrain():
    rasterio = pytest.importorskip("rasterio")
    heights = np.arange(20, dtype=np.float32).reshape(4, 5)
    heights[1, 2] = -9999
    form = {"driver": "GTiff", "width": 5, "height": 4, "count": 1, "dtype": "float32", "nodata": -9999}
    with rasterio.MemoryFile() as file:
        with file.open(transform=rasterio.transform.from_origin(0, 4, 1, 1), **form) as raster:
            raster.write(heights, 1)
        with file.open() as raster:
            band = raster.read(1, masked=True)
            x, y = raster.xy(*np.indices(band.shape).reshape(2, -1))
    with pytest.raises(sweep_cdt.KindError, match=r"points\[1, 2\] is masked"):
        sweep_cdt.triangulate(band)
    points, is_known = np.column_stack([x, y]), ~np.ma.getmaskarray(band).ravel()
    # The gap is closed by what is around it, or it stays.
    assert sweep_cdt.triangulate(points[is_known]).interpolate(band.compressed(), [[2.5, 2.5]]).tolist() == [7]
    found = sweep_cdt.triangulate(points).interpolate(band.ravel(), [[2.5, 2.5], [0.75, 3.25]])
    assert np.isnan(found[0]) and found[1] == 1.5


def test_meshio_and_pyvista_take_heights(tmp_path):
    shapely = pytest.importorskip("shapely")
    polygon, result = roof(shapely)
    heights = result.heights
    meshio, pyvista = pytest.importorskip("meshio"), pytest.importorskip("pyvista")
    for mesh in (result.to_meshio(), result.to_pyvista()):
        assert np.asarray(mesh.points)[:, 2].tolist() == heights.tolist()
    result.to_meshio().write(tmp_path / "roof.vtu")
    again = meshio.read(tmp_path / "roof.vtu")
    assert again.points[:, 2].tolist() == heights.tolist() and sweep_cdt.verify(polygon, again)
    mesh = result.to_pyvista()
    assert mesh.bounds[4:] == (heights.min(), heights.max()) and mesh.triangulate().n_cells >= len(result.triangles)
    assert mesh.elevation().n_points == len(heights)
    assert isinstance(mesh.contour([15.0], scalars=mesh.points[:, 2]), pyvista.PolyData)
    masked = np.ma.array(heights, mask=heights > 20)
    assert np.isnan(result.to_meshio(masked).points[:, 2]).sum() == (heights > 20).sum()
    for wrong in ([1, 2], np.zeros((len(heights), 2))):
        with pytest.raises(sweep_cdt.ShapeError, match="z has the shape"):
            result.to_meshio(wrong)


def test_scipy_takes_the_arrays_of_a_result():
    sparse, graphs = pytest.importorskip("scipy.sparse"), pytest.importorskip("scipy.sparse.csgraph")
    interpolate, spatial = pytest.importorskip("scipy.interpolate"), pytest.importorskip("scipy.spatial")
    shapely = pytest.importorskip("shapely")
    _, result = roof(shapely)
    place = [[2.0, 1.0], [7.5, 2.0]]
    wanted = result.interpolate(result.heights, place)
    for theirs in (interpolate.LinearNDInterpolator, interpolate.NearestNDInterpolator):
        assert np.isfinite(theirs(result.points, result.heights)(place)).all()
    assert np.allclose(interpolate.LinearNDInterpolator(result.points, result.heights)(place), wanted)
    assert spatial.cKDTree(result.points).query(result.points)[1].tolist() == list(range(len(result.points)))
    # The frontage of the hull is theirs, as positions.
    assert set(spatial.ConvexHull(result.points).vertices) == set(result.convex_hull.ravel())
    ends = np.concatenate([result.simplices[:, [i, (i + 1) % 3]] for i in range(3)])
    graph = sparse.coo_array((np.ones(len(ends)), ends.T), shape=(len(result.points),) * 2)
    assert graphs.connected_components(graph)[0] == 1


def test_earcut():
    earcut = pytest.importorskip("mapbox_earcut")
    vertices = np.array(OUTLINE + HOLE, dtype=float)
    corners = earcut.triangulate_float64(vertices, np.array([5, 9], dtype=np.uint32))
    polygon = [[list(range(5)), list(range(5, 9))]]
    assert sweep_cdt.verify(vertices, corners, polygons=polygon, level="constrained")
    assert not sweep_cdt.verify(vertices, corners[:-3], polygons=polygon, level="constrained")
