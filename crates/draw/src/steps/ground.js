// What changes little from step to step: triangles below, edges and vertices above. Both are kept as pictures, and
// only what lies where a step changed something is drawn anew.

/** After more steps than this everything is drawn. */
const MOST_STEPS = 400;

class Ground {
  constructor() {
    this.layers = [0, 1].map(() => document.createElement("canvas").getContext("2d"));
    this.look = "";
    this.scene = { number: 0 };
  }

  /** Brings the pictures of a view to a scene. */
  show(view, scene) {
    const { width, height, ratio } = view;
    const look = [width, height, ratio, view.scale, view.middle, dark.matches].join();
    const tiles = new Tiles(width, height);
    if (look !== this.look || !this.changed(view, this.scene.number, scene.number, tiles)) {
      tiles.markAll();
    }
    if (look !== this.look) {
      for (const { canvas } of this.layers) {
        [canvas.width, canvas.height] = [view.canvas.width, view.canvas.height];
      }
    }
    [this.look, this.scene] = [look, scene];
    if (!tiles.isEmpty) {
      this.redraw(view, tiles);
    }
  }

  /** Marks where the picture after one step differs from that after another one; false if that may be everywhere. */
  changed(view, from, to, tiles) {
    const [low, high] = [Math.min(from, to), Math.max(from, to)];
    if (high - low > MOST_STEPS || (low < past.isSweptFrom) !== (high < past.isSweptFrom)) {
      return false;
    }
    const among = (list, step) => {
      const [start, end] = [low, high].map((at) => after(list.length, (i) => step(list[i], i), at));
      return list.slice(start, end);
    };
    const shapes = [
      ...among(past.corners, (_, triangle) => past.born[triangle]),
      ...among(past.dead, (triangle) => past.died[triangle]).map((triangle) => past.corners[triangle]),
      ...among(past.fixed, (_, at) => past.fixedAt[at]),
      ...among(past.sweeps, (v) => past.sweptAt[v]).map((v) => [v]),
    ];
    shapes.forEach((shape) => tiles.mark(view.places(shape)));
    return true;
  }

  redraw(view, tiles) {
    const { scale, middle, width, height } = view;
    const { number } = this.scene;
    const [right, down] = [width / 2 - middle[0] * scale, height / 2 + middle[1] * scale];
    /** The places of a shape, if it may be seen. */
    const seen = (vertices) => {
      // Most are far away: nothing is made for these.
      let left = Infinity;
      let top = Infinity;
      let most = -Infinity;
      let bottom = -Infinity;
      for (let at = 0; at < vertices.length; at++) {
        const point = vertices[at] < 0 ? undefined : trace.points[vertices[at]];
        if (point) {
          const x = point[0] * scale + right;
          const y = down - point[1] * scale;
          left = Math.min(left, x);
          top = Math.min(top, y);
          most = Math.max(most, x);
          bottom = Math.max(bottom, y);
        }
      }
      return tiles.meets(left, top, most, bottom) ? view.places(vertices) : null;
    };
    const [below, above] = this.layers.map((context) => {
      const painter = new Painter(context, view.room, 1);
      context.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
      context.save();
      tiles.clip(context);
      return painter;
    });

    const areas = [];
    for (let triangle = 0; triangle < past.born.length && past.born[triangle] <= number; triangle++) {
      if (number < past.died[triangle]) {
        const corners = past.corners[triangle];
        const places = corners[0] >= 0 && corners[1] >= 0 && corners[2] >= 0 ? seen(corners) : null;
        if (places?.length === 3) {
          areas.push(places);
        }
      }
    }
    below.strokes("triangle", areas, true);
    const lines = (list, is = () => true) =>
      list.filter((ends, at) => is(at)).map(seen).filter((places) => places?.length > 1);
    above.strokes("input", lines(trace.edges));
    above.strokes("constraint", lines(past.fixed, (at) => past.fixedAt[at] <= number));
    this.dots(above, view, seen);
    this.layers.forEach((context) => context.restore());
  }

  /** The vertices: those that are swept are full. */
  dots({ context }, view, seen) {
    const radius = Math.min(Math.max(view.room * 0.08, 0.9), 3.6);
    const [full, empty] = [[], []];
    trace.points.forEach((_, v) => {
      const places = seen([v]);
      if (places) {
        (this.isSwept(v) ? full : empty).push(places[0]);
      }
    });
    for (const [list, fill, stroke] of [[empty, "paper", "grey"], [full, "ink", "ink"]]) {
      context.beginPath();
      for (const [x, y] of list) {
        if (radius < 1.5) {
          context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
        } else {
          context.moveTo(x + radius, y);
          context.arc(x, y, radius, 0, 2 * Math.PI);
        }
      }
      // A dot too small for an outline has the colour of its outline.
      context.fillStyle = colour(radius < 1.5 ? stroke : fill);
      [context.strokeStyle, context.lineWidth] = [colour(stroke), 1.2];
      context.fill();
      if (radius >= 1.5) {
        context.stroke();
      }
    }
  }

  /** Whether the sweep line has passed a vertex. */
  isSwept(v) {
    const { sweep, isSwept } = this.scene;
    if (sweep === null || !trace.points[sweep]) {
      return isSwept;
    }
    const [[x, y], [atX, atY]] = [trace.points[v], trace.points[sweep]];
    return y < atY || (y === atY && x <= atX);
  }
}

/** The box around some places. */
function box(places) {
  const range = (axis) => {
    const values = places.map((place) => place[axis]);
    return [Math.min(...values), Math.max(...values)];
  };
  const [[left, right], [top, bottom]] = [range(0), range(1)];
  return [left, top, right, bottom];
}
