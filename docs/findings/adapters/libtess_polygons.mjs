// libtess: polygons with holes. `npm install libtess`
import libtess from "libtess";
import { serve, threes } from "./lines.mjs";

const { gluEnum, windingRule } = libtess;
serve("libtess", ({ points, polygons }) => {
  const tess = new libtess.GluTesselator();
  tess.gluTessCallback(gluEnum.GLU_TESS_VERTEX_DATA, (v, corners) => corners.push(v));
  tess.gluTessCallback(gluEnum.GLU_TESS_EDGE_FLAG, () => {});
  tess.gluTessCallback(gluEnum.GLU_TESS_COMBINE, (place, [v]) => v);
  tess.gluTessProperty(gluEnum.GLU_TESS_WINDING_RULE, windingRule.GLU_TESS_WINDING_ODD);
  tess.gluTessNormal(0, 0, 1);
  const corners = [];
  tess.gluTessBeginPolygon(corners);
  for (const ring of polygons.flat()) {
    tess.gluTessBeginContour();
    for (const v of ring) tess.gluTessVertex([...points[v], 0], v);
    tess.gluTessEndContour();
  }
  tess.gluTessEndPolygon();
  return threes(corners);
});
