// faster-delaunay: points. `npm install faster-delaunay`
import Delaunay from "faster-delaunay";
import { serve, threes } from "./lines.mjs";

// No sense of rotation is promised: all triangles are turned counter-clockwise (exact for integers of 20 bits).
const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
serve("faster-delaunay", ({ points }) => {
  const number = new Map(points.map((p, v) => [String(p), v]));
  const corners = new Delaunay(points.map((p) => [...p])).triangulate();
  return threes(corners.map((p) => number.get(String(p)))).map(([a, b, c]) =>
    turn(points[a], points[b], points[c]) < 0 ? [a, c, b] : [a, b, c]);
});
