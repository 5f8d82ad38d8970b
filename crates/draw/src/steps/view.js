// Draws a scene on a canvas, and moves over it.

/** Vertices are named where they are so far apart, in pixels. */
const ROOM_FOR_NUMBERS = 14;
/** What the buttons take on the left, in pixels. */
const BUTTONS = 56;

class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.ground = new Ground();
    this.isFollowing = true;
    this.resize();
  }

  /** How far apart neighbours are, in pixels. */
  get room() {
    return trace.spacing * this.scale;
  }

  /** Fits the canvas to its place on the page. */
  resize() {
    this.ratio = window.devicePixelRatio || 1;
    [this.width, this.height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    this.canvas.width = Math.round(this.width * this.ratio);
    this.canvas.height = Math.round(this.height * this.ratio);
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
    const places = this.placesOf(changes);
    if (places.length) {
      const [left, top, right, bottom] = box(places);
      this.pan(this.width / 2 - (left + right) / 2, this.height / 2 - (top + bottom) / 2);
      const extent = Math.max(right - left, bottom - top, 2 * this.room);
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

  /** Moves no farther than it takes to have all vertices of a step in sight, and zooms out if it must. */
  follow(changes) {
    const places = this.placesOf(changes);
    const edge = Math.min(40, 0.1 * Math.min(this.width, this.height));
    const size = [this.width, this.height];
    if (!this.isFollowing || !this.isMoved || !places.length || this.sees(places, edge)) {
      return;
    }
    const [left, top, right, bottom] = box(places);
    const extents = [right - left, bottom - top];
    if (extents.some((extent, axis) => extent > size[axis] - 2 * edge)) {
      this.showStep(changes);
      return;
    }
    const shift = (low, high, length) => Math.max(edge - low, 0) + Math.min(length - edge - high, 0);
    this.pan(shift(left, right, this.width), shift(top, bottom, this.height));
  }

  /** Whether all places are on the picture, so far from its edge. */
  sees(places, edge = 0) {
    const [right, bottom] = [this.width - edge, this.height - edge];
    return places.every(([x, y]) => x >= edge && y >= edge && x <= right && y <= bottom);
  }

  draw(scene) {
    const { context, width, height } = this;
    if (!width || !height) {
      return;
    }
    this.ground.show(this, scene);
    const [below, above] = this.ground.layers;
    const stack = ({ canvas }) => {
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.drawImage(canvas, 0, 0);
      context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    };
    this.painter = new Painter(context, this.room);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    stack(below);
    this.artificial(scene);
    for (const border of ["upper", "lower"]) {
      this.lines(border, scene[border], scene[border].length > 2);
    }
    scene.pierced.forEach((corners) => this.lines("pierced", corners, true));
    const added = scene.step.filter(([name, ...corners]) => name === "add" && Math.min(...corners) >= 0);
    added.forEach(([, ...corners]) => this.lines("added", corners, true));
    const front = this.places(scene.front);
    if (front.length) {
      this.painter.stroke("front", [[-10, front[0][1]], ...front, [width + 10, front.at(-1)[1]]]);
    }
    stack(above);
    if (scene.sweep !== null) {
      const [, y] = this.place(scene.sweep);
      this.painter.stroke("sweep", [[-10, y], [width + 10, y]]);
    }
    if (scene.edge) {
      this.lines("inserted", scene.edge);
      this.painter.arrowHead(...this.places(scene.edge));
    }
    this.highlights(scene.step);
    this.name(scene);
  }

  /** Triangles with P-1 or P-2, which are directions: they reach to the edge of the picture. */
  artificial({ number, step }) {
    const isNew = (corners) => step.some(([name, ...added]) => name === "add" && key(added) === key(corners));
    for (const triangle of past.artificial.filter((triangle) => past.isThere(triangle, number))) {
      const corners = past.corners[triangle];
      const area = this.reaching(corners);
      if (area.length > 2) {
        this.painter.stroke(isNew(corners) ? "added" : "ray", area, true);
      }
    }
  }

  /** The outline of a triangle with P-1 or P-2. */
  reaching(corners) {
    const [left, right, bottom] = [-10, this.width + 10, this.height + 10];
    const places = this.places(corners);
    const far = corners.includes(LEFT) ? left : right;
    if (places.length === 2) {
      const [[a, aY], [b, bY]] = places;
      return [[a, aY], [b, bY], [far, bY], [far, aY]];
    }
    // Both artificial points: all that is below.
    return places.flatMap(([x, y]) => [[left, y], [x, y], [right, y], [right, bottom], [left, bottom]]);
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
        this.lines({ stroke, dash, width: 4 }, [a, b]);
        this.ring(q, 7);
      }
    }
  }

  /** The numbers of the vertices of the step, and of others. */
  name({ step }) {
    const labels = new Labels(this.context, this.width, this.height);
    const isSeen = ([, place]) => this.sees([place]);
    const withPlaces = (list) => list.map((v) => [v, this.place(v)]).filter(isSeen);
    const named = withPlaces(verticesOf(step));
    let others = [];
    if (this.room > ROOM_FOR_NUMBERS) {
      const numbers = new Set(named.map(([v]) => v));
      others = withPlaces([...trace.points.keys()].filter((v) => trace.points[v] && !numbers.has(v)));
    }
    labels.draw(named, others.length > MOST_LABELLED ? [] : others);
    this.labels = labels.placed;
  }

  ring(v, radius) {
    this.places([v]).forEach((place) => this.painter.ring(place, radius));
  }

  circle(style, places) {
    this.painter.circle(style, places, this.width + this.height);
  }

  /** Lines through vertices, without the artificial ones. */
  lines(style, vertices, isClosed = false) {
    const places = this.places(vertices);
    if (places.length > 1) {
      this.painter.stroke(style, places, isClosed);
    }
  }

  place(v) {
    const [x, y] = trace.points[v];
    const across = (x - this.middle[0]) * this.scale;
    const up = (y - this.middle[1]) * this.scale;
    return [this.width / 2 + across, this.height / 2 - up];
  }

  /** The places of vertices, without the artificial ones and those that the page lacks. */
  places(vertices) {
    return vertices.filter((v) => v >= 0 && trace.points[v]).map((v) => this.place(v));
  }

  placesOf(changes) {
    return this.places(verticesOf(changes));
  }
}

/** The vertices of changes, each once. */
function verticesOf(changes) {
  const ends = ([name, ...vertices]) => (name === "about" ? [] : vertices);
  return [...new Set(changes.flatMap(ends))].filter((v) => v >= 0);
}
