// Delaunator: points. `npm install delaunator`
import Delaunator from "delaunator";
import { serve, threes } from "./lines.mjs";

serve("delaunator", ({ points }) => threes(Delaunator.from(points).triangles));
