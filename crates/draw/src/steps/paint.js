// Colours, lines and areas, in the styles that come with the steps.

const STYLES = Object.fromEntries(trace.styles.map((style) => [style.name, style]));
const dark = matchMedia("(prefers-color-scheme: dark)");

/** A colour of the styles on the paper of this page. */
function shade(colour) {
  const found = trace.colours.find(([, light]) => light === colour);
  return found && dark.matches ? found[2] : colour;
}
/** A colour of the page by its name. */
const colour = (name) => shade(trace.colours.find(([other]) => other === name)[1]);

const MOST_IN_A_PATH = 200;

/** Draws on a canvas where neighbours are `room` pixels apart; broad lines are never less than `least` pixels. */
class Painter {
  constructor(context, room, least = 4) {
    Object.assign(this, { context, room, least });
  }

  /** A line, or an area, through places. */
  stroke(style, places, isClosed = false) {
    this.strokes(style, [places], isClosed);
  }

  /** Many of them, some hundred in a path: browsers take long to fill paths of many corners. */
  strokes(style, lists, isClosed = false) {
    for (let from = 0; from < lists.length; from += MOST_IN_A_PATH) {
      this.path(style, lists.slice(from, from + MOST_IN_A_PATH), isClosed);
    }
  }

  path(style, lists, isClosed) {
    const { context } = this;
    context.beginPath();
    for (const places of lists) {
      const [x, y] = places[0];
      context.moveTo(x, y);
      for (let at = 1; at < places.length; at++) {
        context.lineTo(places[at][0], places[at][1]);
      }
      if (isClosed) {
        context.closePath();
      }
    }
    this.paint(typeof style === "string" ? STYLES[style] : style, isClosed);
  }

  paint({ stroke, width, dash = [], alpha = 1, fill, fillAlpha = 1, hatch }, isClosed = false) {
    const { context, room, least } = this;
    // Where triangles are small, their sides are thin and the front is narrow.
    const most = width <= 1.2 ? Math.max(0.05 * room, 0.3) : Math.max(0.2 * room, least);
    context.save();
    context.lineWidth = Math.min(width, most);
    context.strokeStyle = shade(stroke);
    // Ends and dashes do not show where lines are short, and take long.
    if (room > 10) {
      context.setLineDash(dash);
      [context.lineCap, context.lineJoin] = ["round", "round"];
    }
    if (isClosed && (fill || hatch)) {
      context.globalAlpha = hatch ? 1 : fillAlpha;
      context.fillStyle = hatch ? hatching(context, shade(stroke), fillAlpha, hatch) : shade(fill);
      context.fill();
    }
    context.globalAlpha = alpha;
    context.stroke();
    context.restore();
  }

  ring([x, y], radius) {
    const { context } = this;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.lineWidth = 2;
    context.strokeStyle = colour("ink");
    context.stroke();
  }

  /** The circle through three places; one that is all but straight is drawn as a line `far` both ways. */
  circle(style, [[ax, ay], [bx, by], [cx, cy]], far) {
    const [ux, uy, vx, vy] = [bx - ax, by - ay, cx - ax, cy - ay];
    const area = 2 * (ux * vy - uy * vx);
    const [u2, v2] = [ux * ux + uy * uy, vx * vx + vy * vy];
    const [x, y] = [(vy * u2 - uy * v2) / area, (ux * v2 - vx * u2) / area];
    const radius = Math.hypot(x, y);
    if (radius < 1e5) {
      this.context.beginPath();
      this.context.arc(ax + x, ay + y, radius, 0, 2 * Math.PI);
      this.paint(STYLES[style]);
    } else {
      const share = far / Math.hypot(ux, uy);
      this.stroke(style, [[ax - ux * share, ay - uy * share], [ax + ux * share, ay + uy * share]]);
    }
  }

  arrowHead([fromX, fromY], [x, y]) {
    const turn = Math.atan2(y - fromY, x - fromX);
    const tip = (angle) => [x - 15 * Math.cos(turn + angle), y - 15 * Math.sin(turn + angle)];
    const { stroke } = STYLES.inserted;
    this.stroke({ stroke, width: 2, fill: stroke }, [[x, y], tip(0.4), tip(-0.4)], true);
  }
}

/** The pattern of an area: pale, with lines in this direction. */
function hatching(context, stroke, alpha, direction) {
  const tile = new OffscreenCanvas(8, 8);
  const lines = tile.getContext("2d");
  [lines.fillStyle, lines.globalAlpha] = [stroke, alpha];
  lines.fillRect(0, 0, 8, 8);
  [lines.strokeStyle, lines.globalAlpha] = [stroke, 1];
  lines.lineWidth = 1.2;
  const [from, to] = direction === "/" ? [8, 0] : [0, 8];
  for (const shift of [-8, 0, 8]) {
    lines.moveTo(shift, from);
    lines.lineTo(shift + 8, to);
  }
  lines.stroke();
  return context.createPattern(tile, "repeat");
}
