"""What users would write from the README alone, in as few lines as they would; and the same by the command."""

import json
import subprocess

import numpy as np
import pytest

import sweep_cdt

SURVEY = """101,4017.250,9811.400,102.41,EP
102,4031.800,9822.150,102.77,EP
103,4024.310,9846.900,103.05,GS
104,4002.940,9839.020,102.18,GS
105,4015.000,9829.500,102.60,TREE
"""


def told(command, folder, *arguments):
    ran = subprocess.run([command, *map(str, arguments)], cwd=folder, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout, ran.stderr


@pytest.mark.parametrize("has_z", [True, False])
def test_contour_lines_to_a_tin_and_heights_of_wells(command, tmp_path, monkeypatch, has_z):
    """Contour lines of a map, with a z or with a column of heights."""
    geopandas = pytest.importorskip("geopandas")
    import shapely

    monkeypatch.chdir(tmp_path)
    z = [" Z", " 400", " 430"] if has_z else ["", "", ""]
    lines = [f"LINESTRING{z[0]} (0 0{z[1]}, 90 0{z[1]})", f"LINESTRING{z[0]} (0 60{z[2]}, 90 50{z[2]})"]
    elevation = {} if has_z else {"ELEV_M": [400, 430]}
    geopandas.GeoDataFrame(elevation, geometry=shapely.from_wkt(lines), crs=2056).to_file("contours.geojson")
    wells = geopandas.GeoSeries.from_xy([30, 45, 200], [20, 55, 0], crs=2056)
    geopandas.GeoDataFrame({"name": list("abc")}, geometry=wells).to_file("wells.geojson")

    wells = geopandas.read_file("wells.geojson")
    tin = sweep_cdt.triangulate(geopandas.read_file("contours.geojson"))
    wells["height"] = tin.interpolate(tin.heights, wells)
    tin.to_geodataframe().to_file("tin.geojson")

    assert wells.height.round(2).tolist()[:2] == [411.67, 430.0] and np.isnan(wells.height[2])
    assert wells.name.tolist() == ["a", "b", "c"]
    back = geopandas.read_file("tin.geojson")
    assert back.crs.to_epsg() == 2056 and back.has_z.all() and len(back) == len(tin.triangles) == 2
    assert [str(remark) for remark in tin.remarks] == (
        [] if has_z else ["heights are the property `ELEV_M` of 2 features"]
    )
    _, said = told(command, tmp_path, "heights", "contours.geojson", "--at", "wells.geojson", "-o", "heights.geojson")
    assert all(str(remark) in said for remark in tin.remarks)
    features = json.loads((tmp_path / "heights.geojson").read_text())["features"]
    theirs = [feature["geometry"]["coordinates"] for feature in features]
    assert [place[2] for place in theirs[:2]] == wells.height.tolist()[:2] and len(theirs[2]) == 2
    told(command, tmp_path, "triangulate", "contours.geojson", "-o", "theirs.geojson")
    theirs = geopandas.read_file("theirs.geojson")
    assert theirs.crs.to_epsg() == 2056 and theirs.area.sum() == back.area.sum()


def test_a_raster_with_no_data(command, tmp_path, monkeypatch):
    rasterio = pytest.importorskip("rasterio")
    monkeypatch.chdir(tmp_path)
    heights = np.add.outer(np.arange(4.0), np.arange(5.0))
    heights[2, 3] = -9999
    form = {"driver": "GTiff", "width": 5, "height": 4, "count": 1, "dtype": "float64", "nodata": -9999}
    form |= {"crs": "EPSG:2056", "transform": rasterio.Affine(10, 0, 500, 0, -10, 900)}
    with rasterio.open("dem.tif", "w", **form) as file:
        file.write(heights, 1)

    with rasterio.open("dem.tif") as raster:
        band = raster.read(1, masked=True)
        x, y = raster.xy(*np.indices(band.shape).reshape(2, -1))
    terrain = sweep_cdt.triangulate(np.column_stack([x, y]))
    found = terrain.interpolate(band.ravel(), [[510, 890], [540, 875], [533, 873]])

    assert found[0] == 1 and np.isnan(found[1:]).all()
    # The command reads what `gdal_translate -of XYZ` writes.
    np.savetxt("dem.xyz", np.column_stack([x, y, heights.ravel()]), fmt="%.1f")
    (tmp_path / "at.csv").write_text("x,y\n510,890\n540,875\n533,873\n")
    out, said = told(command, tmp_path, "heights", "dem.xyz", "--no-value", "-9999", "--at", "at.csv")
    assert out == "x,y,z\n510,890,1\n540,875,\n533,873,\n" and "1 number is -9999 and counted as missing" in said


def test_a_table_of_a_surveyor(command, tmp_path, monkeypatch):
    pandas = pytest.importorskip("pandas")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "survey.csv").write_text(SURVEY)

    table = pandas.read_csv("survey.csv", names=["point", "northing", "easting", "elev", "code"])
    tin = sweep_cdt.triangulate(table)
    height = tin.interpolate(tin.heights, [[9830, 4016]])

    assert tin.points[0].tolist() == [9811.4, 4017.25] and tin.heights.tolist() == table.elev.tolist()
    (tmp_path / "at.csv").write_text("x,y\n9830,4016\n")
    out, _ = told(command, tmp_path, "heights", "survey.csv", "--columns", "3,2,4", "--at", "at.csv")
    assert float(out.split(",")[-1]) == height[0]


def test_a_mesh_with_regions_read_by_meshio(command, tmp_path, monkeypatch):
    meshio = pytest.importorskip("meshio")
    monkeypatch.chdir(tmp_path)
    plate = {
        "vertices": [[0, 0], [4, 0], [8, 0], [8, 4], [4, 4], [0, 4]],
        "segments": [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4]],
        "segment_markers": [1, 1, 2, 3, 3, 4, 5],
        "regions": [[2, 2, 10, 0], [6, 2, 20, 0]],
    }
    mesh = sweep_cdt.triangulate(plate, inside="holes").refine(min_angle=25, region_areas=[0.5, 0.1])
    mesh.to_meshio().write("plate.vtu")
    read = meshio.read("plate.vtu")

    assert sweep_cdt.verify(read, min_angle=25, max_area=0.5)
    sides, markers = read.cells_dict["line"], read.cell_data_dict["marker"]["line"]
    middles = read.points[sides].mean(axis=1)
    for x, y, marker in zip(*middles.T[:2], markers):
        of_sides = [(y == 0, 1), (x == 8, 2), (y == 4, 3), (x == 0, 4), (x == 4, 5)]
        assert marker == next(m for is_there, m in of_sides if is_there)
    areas = {region: 0.0 for region in (0, 1)}
    for corners, region in zip(read.points[read.cells_dict["triangle"]], read.cell_data_dict["region"]["triangle"]):
        (ux, uy, _), (vx, vy, _) = corners[1:] - corners[0]
        areas[int(region)] += (ux * vy - uy * vx) / 2
    assert np.allclose(list(areas.values()), 16, rtol=1e-14)
    poly = ["6 2 0 0", *(f"{v} {x} {y}" for v, (x, y) in enumerate(plate["vertices"]))]
    marked = zip(plate["segments"], plate["segment_markers"])
    poly += ["7 1", *(f"{e} {a} {b} {m}" for e, ((a, b), m) in enumerate(marked))]
    poly += ["0", "2", "0 2 2 10 0", "1 6 2 20 0"]
    (tmp_path / "plate.poly").write_text("\n".join(poly))
    told(command, tmp_path, "refine", "plate.poly", "--inside", "holes", "--min-angle", 25, "-o", "theirs.msh")
    assert sweep_cdt.verify(meshio.read("theirs.msh"), min_angle=25)


def test_voronoi_cells_within_a_polygon_are_drawn():
    geopandas, pyplot = pytest.importorskip("geopandas"), pytest.importorskip("matplotlib.pyplot")
    import shapely

    shops = geopandas.GeoSeries.from_xy([1, 5, 3], [1, 1, 4], crs=2056)
    town = shapely.Polygon([(0, 0), (6, 0), (6, 5), (3, 3), (0, 5)])
    cells = sweep_cdt.triangulate(shops).voronoi().to_geodataframe(town)
    axes = cells.plot(edgecolor="black", ax=pyplot.figure().gca())

    assert len(axes.collections) == 1 and cells.crs.to_epsg() == 2056
    assert abs(cells.area.sum() - town.area) < 1e-12
    theirs = shapely.voronoi_polygons(shapely.MultiPoint(list(shops)), extend_to=town)
    for cell in cells.geometry:
        assert min(cell.symmetric_difference(part & town).area for part in theirs.geoms) < 1e-12


def test_an_obstacle_moves_through_a_room():
    ring = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    room = sweep_cdt.DynamicTriangulation([[0, 0], [9, 0], [9, 6], [0, 6]], ring)
    crate = np.array([[1, 2], [2, 2], [2, 3], [1, 3]])
    there = room.insert(crate, ring + 4)
    for step in range(1, 7):
        first = 4 + 4 * step
        there = room.edit(
            points=crate + [step, 0], edges=ring + first, remove_points=there.points, remove_edges=there.edges
        )
        fresh = sweep_cdt.triangulate([*room.places(room.points).tolist()], [*ring, *(ring + 4)])
        assert fresh.canonical().tolist() == np.searchsorted(room.points, room.triangles).tolist()
