// delaunay-triangulate: points. `npm install delaunay-triangulate`
import triangulate from "delaunay-triangulate";
import { serve, turned } from "./lines.mjs";

serve("delaunay-triangulate", ({ points }) => turned(points, triangulate(points)));
