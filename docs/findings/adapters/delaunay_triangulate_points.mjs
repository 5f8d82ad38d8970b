// delaunay-triangulate: points. `npm install delaunay-triangulate`
import triangulate from "delaunay-triangulate";
import { serve } from "./lines.mjs";

// No sense of rotation is promised: all triangles are turned counter-clockwise (exact for integers of 20 bits).
const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
serve("delaunay-triangulate", ({ points }) =>
  triangulate(points).map(([a, b, c]) => (turn(points[a], points[b], points[c]) < 0 ? [a, c, b] : [a, b, c])));
