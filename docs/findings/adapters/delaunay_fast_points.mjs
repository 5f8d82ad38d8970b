// delaunay-fast: points. `npm install delaunay-fast`
import Delaunay from "delaunay-fast";
import { serve, threes } from "./lines.mjs";

// No sense of rotation is promised: all triangles are turned counter-clockwise (exact for integers of 20 bits).
const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
serve("delaunay-fast", ({ points }) =>
  threes(Delaunay.triangulate(points)).map(([a, b, c]) =>
    turn(points[a], points[b], points[c]) < 0 ? [a, c, b] : [a, b, c]));
