// earcut: polygons with holes. `npm install earcut`
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import earcut from "earcut";

const { version } = JSON.parse(readFileSync("node_modules/earcut/package.json"));

for await (const line of createInterface({ input: process.stdin })) {
  const { points, polygons } = JSON.parse(line);
  const triangles = [];
  for (const rings of polygons) {
    const vertices = rings.flat();
    const holes = rings.slice(1).map((_, k) => rings.slice(0, k + 1).flat().length);
    const corners = earcut(vertices.flatMap((v) => points[v]), holes).map((corner) => vertices[corner]);
    for (let k = 0; k < corners.length; k += 3) triangles.push(corners.slice(k, k + 3));
  }
  console.log(JSON.stringify({ triangles, program: `earcut ${version}` }));
}
