// Drawing with a mouse, a pen or fingers. One finger uses the tool, two move and zoom the picture.

/** How near to a vertex or an edge is at it, in pixels; and how far a pointer moves before it drags. */
const [NEAR_POINT, NEAR_EDGE, SLIP] = [14, 8, 6];

class Pointer {
  /** `changed` is called after each change of the input, `looked` where the picture alone changes. */
  constructor(view, input, { changed, looked }) {
    Object.assign(this, { view, input, changed, looked, fingers: new Map(), gesture: null });
    const { canvas } = view;
    canvas.onpointerdown = (event) => this.down(event);
    canvas.onpointermove = (event) => this.move(event);
    canvas.onpointerup = (event) => this.up(event);
    canvas.onpointercancel = (event) => this.cancel(event);
    canvas.onwheel = (event) => {
      event.preventDefault();
      view.zoom(Math.exp(-event.deltaY / 400), place(event));
      looked();
    };
  }

  get tool() {
    return document.querySelector("[name=tool]:checked").value;
  }

  down(event) {
    if (event.button !== 0) {
      return;
    }
    this.view.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, place(event));
    const start = place(event);
    this.gesture = this.fingers.size === 1 ? { start, vertex: this.vertexAt(start), isDrag: false } : null;
    this.looked();
  }

  move(event) {
    const from = this.fingers.get(event.pointerId);
    if (!from) {
      return;
    }
    const to = place(event);
    this.fingers.set(event.pointerId, to);
    const { gesture, view } = this;
    if (!gesture) {
      const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        view.zoom((distance(to, other) || 1) / (distance(from, other) || 1), other);
        this.looked();
      }
      return;
    }
    gesture.isDrag ||= distance(gesture.start, to) > SLIP;
    if (!gesture.isDrag) {
      return;
    }
    if (this.tool === "draw" && this.input.points) {
      const end = this.vertexAt(to);
      this.looked([this.pixelOf(gesture.vertex) ?? gesture.start, this.pixelOf(end) ?? to]);
    } else if (this.tool === "move" && gesture.vertex !== null) {
      this.moveVertex(gesture, view.place(to));
    } else {
      view.pan(to[0] - from[0], to[1] - from[1]);
      this.looked();
    }
  }

  up(event) {
    const { gesture, input } = this;
    this.cancel(event);
    if (!gesture || !input.points) {
      return;
    }
    const end = place(event);
    if (this.tool === "draw") {
      this.drawTo(gesture, end);
    } else if (this.tool === "erase" && !gesture.isDrag) {
      this.erase(end);
    }
  }

  cancel(event) {
    this.fingers.delete(event.pointerId);
    this.gesture = null;
    this.looked();
  }

  /** A click makes a point; a drag an edge, with points at its ends where there are none. */
  drawTo({ start, vertex, isDrag }, pixel) {
    const { input, view } = this;
    const last = this.vertexAt(pixel);
    const points = [...input.points];
    const at = (v, where) => v ?? points.push(view.place(where)) - 1;
    if (isDrag) {
      const edge = [at(vertex, start), at(last, pixel)];
      if (edge[0] === edge[1]) {
        return;
      }
      input.draw(points, [...input.edges, edge]);
    } else if (last === null) {
      at(null, pixel);
      input.draw(points, input.edges);
    } else {
      return;
    }
    this.changed();
  }

  /** Moves a vertex; the whole drag is one change for undo. */
  moveVertex(gesture, to) {
    const { input } = this;
    const points = [...input.points];
    points[gesture.vertex] = to;
    input.draw(points, input.edges, { isContinued: gesture.hasMoved });
    gesture.hasMoved = true;
    this.changed();
  }

  erase(pixel) {
    const { input } = this;
    const vertex = this.vertexAt(pixel);
    const edge = this.edgeAt(pixel);
    if (vertex !== null) {
      input.erasePoint(vertex);
    } else if (edge !== null) {
      input.eraseEdge(edge);
    } else {
      return;
    }
    this.changed();
  }

  pixelOf(vertex) {
    return vertex === null ? null : this.view.pixel(...this.input.points[vertex]);
  }

  vertexAt(pixel) {
    const points = this.input.points ?? [];
    return nearest(points, (_, v) => distance(this.pixelOf(v), pixel), NEAR_POINT);
  }

  edgeAt(pixel) {
    const away = (ends) => distanceFromLine(pixel, ends.map((v) => this.pixelOf(v)));
    return nearest(this.input.edges, away, NEAR_EDGE);
  }
}

const place = ({ offsetX, offsetY }) => [offsetX, offsetY];
const distance = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

/** The position of what is nearest, if it is near enough. */
function nearest(list, away, limit) {
  let [best, least] = [null, limit];
  list.forEach((item, position) => {
    const distance = away(item, position);
    if (distance < least) {
      [best, least] = [position, distance];
    }
  });
  return best;
}

function distanceFromLine([x, y], [[ax, ay], [bx, by]]) {
  const [ux, uy] = [bx - ax, by - ay];
  const share = ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy || 1);
  const along = Math.min(Math.max(share, 0), 1);
  return distance([x, y], [ax + along * ux, ay + along * uy]);
}
