// cdt2d: points with edges. `npm install cdt2d`
import cdt2d from "cdt2d";
import { serve } from "./lines.mjs";

serve("cdt2d", ({ points, edges }) => cdt2d(points, edges));
