// poly2tri: polygons with holes. `npm install poly2tri`
import poly2tri from "poly2tri";
import { serve } from "./lines.mjs";

serve("poly2tri", ({ points, polygons }) =>
  polygons.flatMap((rings) => {
    const [outline, ...holes] = rings.map((ring) => ring.map((v) => ({ x: points[v][0], y: points[v][1], v })));
    const context = new poly2tri.SweepContext(outline).addHoles(holes).triangulate();
    return context.getTriangles().map((t) => t.getPoints().map((p) => p.v));
  }));
