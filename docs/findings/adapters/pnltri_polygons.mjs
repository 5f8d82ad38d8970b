// pnltri: polygons with holes. `npm install pnltri`
import PNLTRI from "pnltri";
import { serve } from "./lines.mjs";

serve("pnltri", ({ points, polygons }) =>
  polygons.flatMap((rings) => {
    const vertices = rings.flat();
    const chains = rings.map((ring) => ring.map((v) => ({ x: points[v][0], y: points[v][1] })));
    const found = new PNLTRI.Triangulator().triangulate_polygon(chains);
    if (!found) throw new Error("no list of triangles");
    return found.map((t) => t.map((corner) => vertices[corner]));
  }));
