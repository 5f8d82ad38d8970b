// Programs in JavaScript as the judge asks them: `node adapters.mjs NAME` in this folder, after `npm install PACKAGE`.
//
// A question comes as a line of JSON, triangles go out as one. What the program throws counts as refused.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";

// A flat list of corners, in threes.
const threes = (corners) =>
  Array.from({ length: Math.floor(corners.length / 3) }, (_, t) => Array.from(corners.slice(3 * t, 3 * t + 3)));

// Triangles of a program that promises no sense of rotation, turned counter-clockwise (exact for integers of 20 bits).
const turned = (points, triangles) =>
  triangles.map(([a, b, c]) => {
    const [[ax, ay], [bx, by], [cx, cy]] = [points[a], points[b], points[c]];
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0 ? [a, c, b] : [a, b, c];
  });

// The numbers of corners that are given as coordinates.
const byPlace = (points) => {
  const number = new Map(points.map((p, v) => [String(p), v]));
  return (triangles) => triangles.map((t) => t.map((p) => number.get(String(p.slice(0, 2)))));
};

const xy = (points) => (v) => ({ x: points[v][0], y: points[v][1], v });

// For each name its package, and what makes triangles of a question with the modules of the package and of others.
const adapters = {
  "cdt2d-edges": ["cdt2d", ({ default: cdt2d }) => ({ points, edges }) => cdt2d(points, edges)],

  "cdt2d-polygons": ["cdt2d", ({ default: cdt2d }) => ({ points, polygons }) => {
    const edges = polygons.flat().flatMap((ring) => ring.map((v, k) => [v, ring[(k + 1) % ring.length]]));
    return cdt2d(points, edges, { exterior: false });
  }],

  "constrainautor-edges": ["@kninnug/constrainautor", ({ default: Constrainautor }, { default: Delaunator }) =>
    ({ points, edges }) => {
      const delaunay = Delaunator.from(points);
      new Constrainautor(delaunay, edges);
      return threes(delaunay.triangles);
    }, "delaunator"],

  "d3-delaunay-points": ["d3-delaunay", ({ Delaunay }) => ({ points }) => threes(Delaunay.from(points).triangles)],

  "delaunator-points": ["delaunator", ({ default: Delaunator }) => ({ points }) =>
    threes(Delaunator.from(points).triangles)],

  "delaunay-fast-points": ["delaunay-fast", ({ default: Delaunay }) => ({ points }) =>
    turned(points, threes(Delaunay.triangulate(points)))],

  "delaunay-triangulate-points": ["delaunay-triangulate", ({ default: triangulate }) => ({ points }) =>
    turned(points, triangulate(points))],

  "earcut-polygons": ["earcut", ({ default: earcut }) => ({ points, polygons }) => polygons.flatMap((rings) => {
    const vertices = rings.flat();
    const holes = rings.slice(1).map((_, k) => rings.slice(0, k + 1).flat().length);
    return threes(earcut(vertices.flatMap((v) => points[v]), holes).map((corner) => vertices[corner]));
  })],

  "faster-delaunay-points": ["faster-delaunay", ({ default: Delaunay }) => ({ points }) =>
    turned(points, byPlace(points)(threes(new Delaunay(points.map((p) => [...p])).triangulate())))],

  "libtess-polygons": ["libtess", ({ default: libtess }) => ({ points, polygons }) => {
    const { gluEnum, windingRule } = libtess;
    const tess = new libtess.GluTesselator();
    tess.gluTessCallback(gluEnum.GLU_TESS_VERTEX_DATA, (v, corners) => corners.push(v));
    tess.gluTessCallback(gluEnum.GLU_TESS_EDGE_FLAG, () => {});
    tess.gluTessCallback(gluEnum.GLU_TESS_COMBINE, (place, [v]) => v);
    tess.gluTessProperty(gluEnum.GLU_TESS_WINDING_RULE, windingRule.GLU_TESS_WINDING_ODD);
    tess.gluTessNormal(0, 0, 1);
    const corners = [];
    tess.gluTessBeginPolygon(corners);
    for (const ring of polygons.flat()) {
      tess.gluTessBeginContour();
      for (const v of ring) tess.gluTessVertex([...points[v], 0], v);
      tess.gluTessEndContour();
    }
    tess.gluTessEndPolygon();
    return threes(corners);
  }],

  "pnltri-polygons": ["pnltri", ({ default: PNLTRI }) => ({ points, polygons }) => polygons.flatMap((rings) => {
    const vertices = rings.flat();
    const found = new PNLTRI.Triangulator().triangulate_polygon(rings.map((ring) => ring.map(xy(points))));
    if (!found) throw new Error("no list of triangles");
    return found.map((t) => t.map((corner) => vertices[corner]));
  })],

  "poly2tri-polygons": ["poly2tri", ({ default: poly2tri }) => ({ points, polygons }) => polygons.flatMap((rings) => {
    const [outline, ...holes] = rings.map((ring) => ring.map(xy(points)));
    const context = new poly2tri.SweepContext(outline).addHoles(holes).triangulate();
    return context.getTriangles().map((t) => t.getPoints().map((p) => p.v));
  })],

  "tess2-polygons": ["tess2", ({ default: Tess2 }) => ({ points, polygons }) => {
    const rings = polygons.flat();
    const { elements, vertexIndices } = Tess2.tesselate({
      contours: rings.map((ring) => ring.flatMap((v) => points[v])),
      windingRule: Tess2.WINDING_ODD, elementType: Tess2.POLYGONS, polySize: 3, vertexSize: 2, normal: [0, 0, 1],
    });
    return threes(elements.map((e) => rings.flat()[vertexIndices[e]] ?? -1));
  }],

  "turf-points": ["@turf/tin", ({ tin }) => ({ points }) => {
    const feature = (coordinates) => ({ type: "Feature", properties: {}, geometry: { type: "Point", coordinates } });
    const found = tin({ type: "FeatureCollection", features: points.map(feature) }).features;
    return turned(points, byPlace(points)(found.map((t) => t.geometry.coordinates[0].slice(0, 3))));
  }],
};

const [name, prepare, ...others] = adapters[process.argv[2]] ?? [];
if (!name) {
  console.error(`usage: node adapters.mjs NAME, one of ${Object.keys(adapters).join(", ")}`);
  process.exit(2);
}
const triangulate = prepare(...await Promise.all([name, ...others].map((each) => import(each))));
const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`));
for await (const line of createInterface({ input: process.stdin })) {
  let answer;
  try {
    answer = { triangles: triangulate(JSON.parse(line)) };
  } catch (error) {
    answer = { refused: String(error).split("\n")[0].slice(0, 200) };
  }
  console.log(JSON.stringify({ ...answer, program: `${name} ${version}` }));
}
