// Draws a scene on a canvas. The styles of lines and areas come with the steps.

const STYLES = Object.fromEntries(trace.styles.map((style) => [style.name, style]));
/** A colour of the page by its name. */
const colour = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const [INK, GREY, BLUE, PAPER] = ["ink", "grey", "blue", "paper"].map(colour);
/** Vertices get numbers where they are so far apart, in pixels. */
const ROOM_FOR_NUMBERS = 24;
/** What the buttons take on the left, in pixels. */
const BUTTONS = 56;

class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.spacing = trace.spacing;
    this.resize();
  }

  /** Fits the canvas to its place on the page. */
  resize() {
    const ratio = window.devicePixelRatio || 1;
    [this.width, this.height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(this.height * ratio);
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (!this.isMoved) {
      this.showAll();
    }
  }

  showAll() {
    const [width, height] = trace.size;
    const margin = Math.min(60, 0.1 * Math.min(this.width, this.height));
    const across = (this.width - 2 * Math.max(margin, BUTTONS)) / Math.max(width, 1e-9);
    const up = (this.height - 2 * margin) / Math.max(height, 1e-9);
    this.scale = Math.max(Math.min(across, up, 1e6), 1);
    this.middle = [width / 2, height / 2];
    this.isMoved = false;
  }

  /** Shows the vertices of a step and what is around them. */
  showStep(changes) {
    const places = changes.flatMap((change) => this.places(change.slice(1)));
    if (places.length) {
      const range = (axis) => {
        const values = places.map((place) => place[axis]);
        return [Math.min(...values), Math.max(...values)];
      };
      const [[left, right], [top, bottom]] = [range(0), range(1)];
      this.pan(this.width / 2 - (left + right) / 2, this.height / 2 - (top + bottom) / 2);
      const extent = Math.max(right - left, bottom - top, 2 * this.spacing * this.scale);
      this.zoom((0.35 * Math.min(this.width, this.height)) / extent);
    }
  }

  /** Zooms, and keeps the place under a pixel where it is. */
  zoom(factor, [x, y] = [this.width / 2, this.height / 2]) {
    const from = this.scale;
    this.scale = Math.min(Math.max(from * factor, 50), 1e9);
    const change = 1 / from - 1 / this.scale;
    this.middle[0] += (x - this.width / 2) * change;
    this.middle[1] -= (y - this.height / 2) * change;
    this.isMoved = true;
  }

  pan(right, down) {
    this.middle[0] -= right / this.scale;
    this.middle[1] += down / this.scale;
    this.isMoved = true;
  }

  /** Moves so that at least one of the vertices of a step is visible. */
  follow(changes) {
    const places = changes.flatMap((change) => this.places(change.slice(1)));
    const isVisible = ([x, y]) => x >= 0 && y >= 0 && x <= this.width && y <= this.height;
    if (this.isMoved && places.length && !places.some(isVisible)) {
      const mean = (axis) => places.reduce((sum, place) => sum + place[axis], 0) / places.length;
      this.pan(this.width / 2 - mean(0), this.height / 2 - mean(1));
    }
  }

  draw(scene) {
    const [left, right] = [-10, this.width + 10];
    this.context.clearRect(0, 0, this.width, this.height);
    for (const border of ["upper", "lower"]) {
      this.lines(border, scene[border], scene[border].length > 2);
    }
    scene.pierced.forEach((corners) => this.lines("pierced", corners, true));
    const triangles = [...scene.triangles.values()];
    for (const corners of triangles.filter((corners) => Math.min(...corners) >= 0)) {
      this.lines("triangle", corners, true);
    }
    for (const corners of triangles.filter((corners) => Math.min(...corners) < 0)) {
      for (const [x, y] of this.places(corners)) {
        for (const [end, far] of [[LEFT, left], [RIGHT, right]]) {
          if (corners.includes(end)) {
            this.stroke("ray", [[x, y], [far, y]]);
          }
        }
      }
    }
    const added = scene.step.filter(([name]) => name === "add");
    added.forEach(([, ...corners]) => this.lines("added", corners, true));
    const front = this.places(scene.front);
    if (front.length) {
      this.stroke("front", [[left, front[0][1]], ...front, [right, front.at(-1)[1]]]);
    }
    trace.edges.forEach((ends) => this.lines("input", ends));
    scene.fixed.forEach((ends) => this.lines("constraint", ends));
    if (scene.sweep !== null) {
      const [, y] = this.place(scene.sweep);
      this.stroke("sweep", [[left, y], [right, y]]);
    }
    if (scene.edge) {
      this.lines("inserted", scene.edge);
      this.arrowHead(...this.places(scene.edge));
    }
    this.vertices(scene);
    this.highlights(scene.step);
  }

  highlights(changes) {
    const isFlip = changes.some(([name]) => name === "gone");
    for (const [name, ...vertices] of changes) {
      const [a, b, p, q] = vertices;
      if (name === "line") {
        this.lines(isFlip ? "came" : "line", vertices);
      } else if (name === "gone") {
        this.lines("gone", vertices);
      } else if (name === "vertex") {
        this.ring(a, 9);
      } else if (["legal", "illegal", "fixed"].includes(name)) {
        this.lines("quad", [p, a, q, b], true);
        if (name !== "fixed" && Math.min(...vertices) >= 0) {
          this.circle(name, this.places([a, b, p]));
        }
        const { stroke, dash } = name === "fixed" ? STYLES.line : STYLES[name];
        this.stroke({ stroke, dash, width: 4 }, this.places([a, b]));
        this.ring(q, 7);
      }
    }
  }

  vertices(scene) {
    const isNumbered = this.spacing * this.scale > ROOM_FOR_NUMBERS;
    const radius = Math.min(Math.max(this.spacing * this.scale * 0.08, 0.9), 3.6);
    const sweep = scene.sweep === null ? null : trace.points[scene.sweep];
    const { context } = this;
    context.font = "12px system-ui, sans-serif";
    trace.points.forEach(([px, py], v) => {
      const [x, y] = this.place(v);
      if (x < -20 || y < -20 || x > this.width + 20 || y > this.height + 20) {
        return;
      }
      const isBelow = sweep && (py < sweep[1] || (py === sweep[1] && px <= sweep[0]));
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.fillStyle = isBelow || scene.isSwept ? INK : PAPER;
      context.fill();
      context.lineWidth = 1.2;
      context.strokeStyle = isBelow || scene.isSwept ? INK : GREY;
      context.stroke();
      if (isNumbered) {
        context.lineWidth = 3.5;
        context.strokeStyle = PAPER;
        context.strokeText(v, x + 7, y - 7);
        context.fillStyle = INK;
        context.fillText(v, x + 7, y - 7);
      }
    });
  }

  ring(v, radius) {
    for (const [x, y] of this.places([v])) {
      this.context.beginPath();
      this.context.arc(x, y, radius, 0, 2 * Math.PI);
      this.context.lineWidth = 2;
      this.context.strokeStyle = INK;
      this.context.stroke();
    }
  }

  /** The circle through three places; a circle that is all but straight is drawn as a line. */
  circle(style, [[ax, ay], [bx, by], [cx, cy]]) {
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
      const far = (this.width + this.height) / Math.hypot(ux, uy);
      this.stroke(style, [[ax - ux * far, ay - uy * far], [ax + ux * far, ay + uy * far]]);
    }
  }

  arrowHead([fromX, fromY], [x, y]) {
    const turn = Math.atan2(y - fromY, x - fromX);
    const tip = (angle) => [x - 15 * Math.cos(turn + angle), y - 15 * Math.sin(turn + angle)];
    this.stroke({ stroke: BLUE, width: 2, fill: BLUE }, [[x, y], tip(0.4), tip(-0.4)], true);
  }

  /** Lines through vertices, without the artificial ones. */
  lines(style, vertices, isClosed = false) {
    const places = this.places(vertices);
    if (places.length > 1) {
      this.stroke(style, places, isClosed);
    }
  }

  stroke(style, places, isClosed = false) {
    const { context } = this;
    context.beginPath();
    places.forEach(([x, y]) => context.lineTo(x, y));
    if (isClosed) {
      context.closePath();
    }
    this.paint(typeof style === "string" ? STYLES[style] : style, isClosed);
  }

  paint({ stroke, width, dash = [], alpha = 1, fill, fillAlpha = 1, hatch }, isClosed = false) {
    const { context } = this;
    // Where triangles are small, their sides are thin and the front is narrow.
    const room = this.spacing * this.scale;
    const most = width <= 1.2 ? Math.max(0.05 * room, 0.3) : Math.max(0.2 * room, 4);
    context.save();
    context.setLineDash(dash);
    context.lineWidth = Math.min(width, most);
    [context.lineCap, context.lineJoin] = ["round", "round"];
    context.strokeStyle = stroke;
    if (isClosed && (fill || hatch)) {
      context.globalAlpha = hatch ? 1 : fillAlpha;
      context.fillStyle = hatch ? hatching(context, stroke, fillAlpha, hatch) : fill;
      context.fill();
    }
    context.globalAlpha = alpha;
    context.stroke();
    context.restore();
  }

  place(v) {
    const [x, y] = trace.points[v];
    const across = (x - this.middle[0]) * this.scale;
    const up = (y - this.middle[1]) * this.scale;
    return [this.width / 2 + across, this.height / 2 - up];
  }

  places(vertices) {
    return vertices.filter((v) => v >= 0).map((v) => this.place(v));
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
