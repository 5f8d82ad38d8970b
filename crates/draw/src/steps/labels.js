// The numbers of vertices. None covers another one, so that not all are shown; those of the step always are.

const CELL = 48;
const LINE_HEIGHT = 15;
/** With more vertices in sight than this, only those of the step are named. */
const MOST_LABELLED = 1500;

class Labels {
  constructor(context, width, height) {
    Object.assign(this, { context, width, height });
    this.cells = new Map();
    /** The vertices that are named, and the boxes of their numbers: left, top, right, bottom. */
    this.placed = [];
  }

  /** Names vertices, each with its place: those that must be named, then others as there is room. */
  draw(named, others) {
    const { context } = this;
    context.lineJoin = "round";
    context.strokeStyle = colour("paper");
    context.fillStyle = colour("ink");
    context.font = "bold 13px system-ui, sans-serif";
    named.forEach(([v, place]) => this.put(v, place, 12));
    context.font = "12px system-ui, sans-serif";
    others.forEach(([v, place]) => this.put(v, place, 1));
  }

  /** Writes the number of a vertex at the nearest free place, at most so many rings away from it. */
  put(v, [x, y], rings) {
    const width = String(v).length * 8 + 4;
    for (let ring = 0; ring < rings; ring++) {
      const off = 7 + ring * LINE_HEIGHT;
      const [right, left, up, down] = [x + off, x - off - width, y - off - 10, y + off - 2];
      const middle = [x - width / 2, y - LINE_HEIGHT / 2];
      const places = [[right, up], [left, up], [right, down], [left, down]];
      const farther = [[middle[0], up], [middle[0], down], [right, middle[1]], [left, middle[1]]];
      for (const [at, top] of ring ? [...places, ...farther] : places) {
        const box = [at, top, at + width, top + LINE_HEIGHT];
        if (this.isFree(box, ring > 0 || rings > 1)) {
          this.write(v, box, ring > 0 ? [x, y] : null);
          return;
        }
      }
    }
  }

  cellsOf([left, top, right, bottom]) {
    const cells = [];
    for (let column = Math.floor(left / CELL); column <= right / CELL; column++) {
      for (let row = Math.floor(top / CELL); row <= bottom / CELL; row++) {
        cells.push(`${column} ${row}`);
      }
    }
    return cells;
  }

  isFree(box, mustBeInside) {
    const [left, top, right, bottom] = box;
    if (mustBeInside && (left < 0 || top < 0 || right > this.width || bottom > this.height)) {
      return false;
    }
    const covers = ([l, t, r, b]) => left < r && l < right && top < b && t < bottom;
    return !this.cellsOf(box).some((cell) => this.cells.get(cell)?.some(covers));
  }

  write(v, box, from) {
    const [left, top, , bottom] = box;
    for (const cell of this.cellsOf(box)) {
      this.cells.set(cell, [...(this.cells.get(cell) ?? []), box]);
    }
    this.placed.push([v, ...box]);
    const { context } = this;
    if (from) {
      context.save();
      [context.strokeStyle, context.lineWidth] = [colour("slate"), 1];
      context.beginPath();
      context.moveTo(...from);
      context.lineTo((left + box[2]) / 2, (top + bottom) / 2);
      context.stroke();
      context.restore();
    }
    context.lineWidth = 3.5;
    context.strokeText(v, left + 2, bottom - 3);
    context.fillText(v, left + 2, bottom - 3);
  }
}
