// delaunay-fast: points. `npm install delaunay-fast`
import Delaunay from "delaunay-fast";
import { serve, threes, turned } from "./lines.mjs";

serve("delaunay-fast", ({ points }) => turned(points, threes(Delaunay.triangulate(points))));
