// tess2: polygons with holes. `npm install tess2`
import Tess2 from "tess2";
import { serve, threes } from "./lines.mjs";

serve("tess2", ({ points, polygons }) => {
  const rings = polygons.flat();
  const { elements, vertexIndices } = Tess2.tesselate({
    contours: rings.map((ring) => ring.flatMap((v) => points[v])),
    windingRule: Tess2.WINDING_ODD, elementType: Tess2.POLYGONS, polySize: 3, vertexSize: 2, normal: [0, 0, 1],
  });
  return threes(elements.map((e) => rings.flat()[vertexIndices[e]] ?? -1));
});
