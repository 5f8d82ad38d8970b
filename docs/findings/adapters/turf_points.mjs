// @turf/tin: points. `npm install @turf/tin`
import { tin } from "@turf/tin";
import { serve } from "./lines.mjs";

// No sense of rotation is promised: all triangles are turned counter-clockwise (exact for integers of 20 bits).
const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
serve("@turf/tin", ({ points }) => {
  const number = new Map(points.map((p, v) => [String(p), v]));
  const feature = (coordinates) => ({ type: "Feature", properties: {}, geometry: { type: "Point", coordinates } });
  const found = tin({ type: "FeatureCollection", features: points.map(feature) }).features;
  return found.map((t) => t.geometry.coordinates[0].slice(0, 3).map((p) => number.get(String(p.slice(0, 2)))))
    .map(([a, b, c]) => (turn(points[a], points[b], points[c]) < 0 ? [a, c, b] : [a, b, c]));
});
