// Constrainautor: points with edges. `npm install @kninnug/constrainautor delaunator`
import Constrainautor from "@kninnug/constrainautor";
import Delaunator from "delaunator";
import { serve, threes } from "./lines.mjs";

serve("@kninnug/constrainautor", ({ points, edges }) => {
  const delaunay = Delaunator.from(points);
  new Constrainautor(delaunay, edges);
  return threes(delaunay.triangles);
});
