// Draws an answer on a canvas.

/** A colour of the page by its name. */
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
/** Vertices get numbers where they are so far apart, in pixels. */
const ROOM_FOR_NUMBERS = 30;
/** So many triangles are filled; of more, the sides alone are drawn. */
const MOST_FILLED = 20_000;
/** What is left free at each side, in pixels, and below, where the hint stands. */
const [MARGIN, BELOW] = [30, 36];

class View {
  /** `tools` stand above the picture. */
  constructor(canvas, tools) {
    Object.assign(this, { canvas, tools });
    this.context = canvas.getContext("2d");
    this.frame([[0, 0], [1000, 700]]);
  }

  /** Shows a box of the plane, given by two corners or more points. */
  frame(points) {
    const [low, high] = [[Infinity, Infinity], [-Infinity, -Infinity]];
    for (const point of points) {
      for (const axis of [0, 1]) {
        low[axis] = Math.min(low[axis], point[axis]);
        high[axis] = Math.max(high[axis], point[axis]);
      }
    }
    // Halves, since the extent of numbers may be no number.
    const half = [0, 1].map((axis) => high[axis] / 2 - low[axis] / 2);
    this.middle = [0, 1].map((axis) => low[axis] / 2 + high[axis] / 2);
    this.unit = Math.max(...half);
    this.size = half.map((side) => side / this.unit);
    if (!(this.unit > 0)) {
      // One place only, or places too near to each other for doubles to be halved.
      this.unit = Math.max(...this.middle.map(Math.abs), 1);
      this.size = [1, 1];
    }
    this.showAll();
  }

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
    const above = this.tools.offsetTop + this.tools.offsetHeight + 20;
    const room = [this.width - 2 * MARGIN, this.height - above - BELOW];
    const scales = [0, 1].map((axis) => Math.max(room[axis], 50) / (2 * this.size[axis]));
    this.scale = Math.min(...scales, 1e6);
    this.centre = [0, (above - BELOW) / 2 / this.scale];
    this.isMoved = false;
  }

  zoom(factor, [x, y] = [this.width / 2, this.height / 2]) {
    const from = this.scale;
    this.scale = Math.min(Math.max(from * factor, 20), 1e9);
    const change = 1 / from - 1 / this.scale;
    this.centre[0] += (x - this.width / 2) * change;
    this.centre[1] -= (y - this.height / 2) * change;
    this.isMoved = true;
  }

  pan(right, down) {
    this.centre[0] -= right / this.scale;
    this.centre[1] += down / this.scale;
    this.isMoved = true;
  }

  /** The pixel of a place in the plane. */
  pixel(x, y) {
    const across = (x - this.middle[0]) / this.unit - this.centre[0];
    const up = (y - this.middle[1]) / this.unit - this.centre[1];
    return [this.width / 2 + across * this.scale, this.height / 2 - up * this.scale];
  }

  /** The place of a pixel, in as few digits as tell pixels apart. */
  place([x, y]) {
    const places = [
      this.middle[0] + this.unit * (this.centre[0] + (x - this.width / 2) / this.scale),
      this.middle[1] + this.unit * (this.centre[1] - (y - this.height / 2) / this.scale),
    ];
    const step = Math.floor(Math.log10(this.unit / this.scale));
    const rounded = (place) => Number(`${Math.round(place / 10 ** step)}e${step}`);
    return places.map((place) => (Number.isFinite(rounded(place)) ? rounded(place) : place));
  }

  /** Draws; `line` is an edge that is being drawn, as two pixels. */
  draw(answer, line = null) {
    const { context } = this;
    context.clearRect(0, 0, this.width, this.height);
    [context.lineCap, context.lineJoin] = ["round", "round"];
    const { vertices, edges, triangles, summary } = answer;
    this.at = new Float64Array(vertices.length);
    for (let v = 0; v < vertices.length; v += 2) {
      [this.at[v], this.at[v + 1]] = this.pixel(vertices[v], vertices[v + 1]);
    }
    this.room = (2 * this.scale) / Math.sqrt(Math.max(summary.vertices, 4));
    if (summary.triangles <= MOST_FILLED) {
      this.fill(triangles);
    }
    const width = (share, least, most) => Math.min(Math.max(this.room * share, least), most);
    this.lines(answer.inner, colour("grey"), width(0.05, 0.25, 1.2));
    this.lines(answer.border, colour("orange"), width(0.1, 1, 3.5));
    this.lines(edges, colour("blue"), width(0.12, 0.5, 3));
    const crossing = [...answer.crossing].flatMap((edge) => [edges[2 * edge], edges[2 * edge + 1]]);
    context.setLineDash([7, 6]);
    this.lines(crossing, colour("vermilion"), width(0.15, 1.5, 3.5));
    context.setLineDash([]);
    this.dots(summary);
    this.crosses(answer.crossings);
    if (line) {
      context.beginPath();
      line.forEach(([x, y]) => context.lineTo(x, y));
      this.stroke(colour("blue"), 2);
    }
  }

  fill(triangles) {
    const { context, at } = this;
    context.beginPath();
    for (let corner = 0; corner < triangles.length; corner++) {
      const v = 2 * triangles[corner];
      if (corner % 3 === 0) {
        context.moveTo(at[v], at[v + 1]);
      } else {
        context.lineTo(at[v], at[v + 1]);
      }
    }
    context.fillStyle = colour("sand");
    context.fill("nonzero");
  }

  /** Lines between vertices, given by ends one after the other; those outside of the picture are left out. */
  lines(ends, style, width) {
    const { context, at } = this;
    context.beginPath();
    for (let end = 0; end < ends.length; end += 2) {
      const [a, b] = [2 * ends[end], 2 * ends[end + 1]];
      const isOut = (axis, most) =>
        Math.max(at[a + axis], at[b + axis]) < 0 || Math.min(at[a + axis], at[b + axis]) > most;
      if (!isOut(0, this.width) && !isOut(1, this.height)) {
        context.moveTo(at[a], at[a + 1]);
        context.lineTo(at[b], at[b + 1]);
      }
    }
    this.stroke(style, width);
  }

  stroke(style, width) {
    [this.context.strokeStyle, this.context.lineWidth] = [style, width];
    this.context.stroke();
  }

  dots({ points, vertices }) {
    if (this.room < 5) {
      return;
    }
    const { context, at } = this;
    const radius = Math.min(Math.max(this.room * 0.06, 1.2), 3.6);
    const [ink, paper, vermilion] = ["ink", "paper", "vermilion"].map(colour);
    context.font = "12px system-ui, sans-serif";
    for (let v = 0; v < vertices; v++) {
      const [x, y] = [at[2 * v], at[2 * v + 1]];
      if (x < -20 || y < -20 || x > this.width + 20 || y > this.height + 20) {
        continue;
      }
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.fillStyle = v < points ? ink : vermilion;
      context.fill();
      if (this.room > ROOM_FOR_NUMBERS) {
        [context.lineWidth, context.strokeStyle] = [3.5, paper];
        context.strokeText(v, x + 6, y - 6);
        context.fillText(v, x + 6, y - 6);
      }
    }
  }

  /** Rings where edges cross. */
  crosses(places) {
    const { context } = this;
    context.beginPath();
    for (let at = 0; at < places.length; at += 2) {
      const [x, y] = this.pixel(places[at], places[at + 1]);
      context.moveTo(x + 7, y);
      context.arc(x, y, 7, 0, 2 * Math.PI);
    }
    this.stroke(colour("vermilion"), 2);
  }
}
