// cdt2d: polygons with holes. `npm install cdt2d`
import cdt2d from "cdt2d";
import { serve } from "./lines.mjs";

serve("cdt2d", ({ points, polygons }) => {
  const edges = polygons.flat().flatMap((ring) => ring.map((v, k) => [v, ring[(k + 1) % ring.length]]));
  return cdt2d(points, edges, { exterior: false });
});
