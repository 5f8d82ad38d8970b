// faster-delaunay: points. `npm install faster-delaunay`
import Delaunay from "faster-delaunay";
import { serve, threes, turned } from "./lines.mjs";

serve("faster-delaunay", ({ points }) => {
  const number = new Map(points.map((p, v) => [String(p), v]));
  const corners = new Delaunay(points.map((p) => [...p])).triangulate();
  return turned(points, threes(corners.map((p) => number.get(String(p)))));
});
