// @turf/tin: points. `npm install @turf/tin`
import { tin } from "@turf/tin";
import { serve, turned } from "./lines.mjs";

serve("@turf/tin", ({ points }) => {
  const number = new Map(points.map((p, v) => [String(p), v]));
  const feature = (coordinates) => ({ type: "Feature", properties: {}, geometry: { type: "Point", coordinates } });
  const found = tin({ type: "FeatureCollection", features: points.map(feature) }).features;
  const corners = (t) => t.geometry.coordinates[0].slice(0, 3).map((p) => number.get(String(p.slice(0, 2))));
  return turned(points, found.map(corners));
});
