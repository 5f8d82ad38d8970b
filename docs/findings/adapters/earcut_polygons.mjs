// earcut: polygons with holes. `npm install earcut`
import earcut from "earcut";
import { serve, threes } from "./lines.mjs";

serve("earcut", ({ points, polygons }) =>
  polygons.flatMap((rings) => {
    const vertices = rings.flat();
    const holes = rings.slice(1).map((_, k) => rings.slice(0, k + 1).flat().length);
    return threes(earcut(vertices.flatMap((v) => points[v]), holes).map((corner) => vertices[corner]));
  }));
