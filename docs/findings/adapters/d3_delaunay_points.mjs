// d3-delaunay: points. `npm install d3-delaunay`
import { Delaunay } from "d3-delaunay";
import { serve, threes } from "./lines.mjs";

serve("d3-delaunay", ({ points }) => threes(Delaunay.from(points).triangles));
