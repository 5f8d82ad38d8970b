// Which tiles of a picture must be drawn anew.

const TILE = 16;
/** Lines and dots reach so many pixels beyond their places. */
const BORDER = 6;

class Tiles {
  constructor(width, height) {
    this.columns = Math.ceil(width / TILE);
    this.rows = Math.ceil(height / TILE);
    /** For each row the first column that is marked, and the one behind the last. */
    this.spans = Array.from({ length: this.rows }, () => [this.columns, 0]);
  }

  /** Marks what a point, a line or a triangle touches. */
  mark(places) {
    places.forEach(([x, y], at) => {
      const [toX, toY] = places[(at + 1) % places.length];
      const [low, high] = [Math.min(y, toY) - BORDER, Math.max(y, toY) + BORDER];
      const [first, last] = [Math.max(Math.floor(low / TILE), 0), Math.min(Math.floor(high / TILE), this.rows - 1)];
      for (let row = first; row <= last; row++) {
        // The part of this side in the row, and a border around it.
        const at = (height) => {
          const share = toY === y ? 0 : (height - y) / (toY - y);
          return x + Math.min(Math.max(share, 0), 1) * (toX - x);
        };
        const ends = [at(row * TILE - BORDER), at((row + 1) * TILE + BORDER), ...(toY === y ? [toX] : [])];
        const span = this.spans[row];
        span[0] = Math.max(Math.min(span[0], Math.floor((Math.min(...ends) - BORDER) / TILE)), 0);
        span[1] = Math.min(Math.max(span[1], Math.floor((Math.max(...ends) + BORDER) / TILE) + 1), this.columns);
      }
    });
  }

  markAll() {
    this.spans.forEach((span) => Object.assign(span, [0, this.columns]));
  }

  get isEmpty() {
    return this.spans.every(([from, to]) => from >= to);
  }

  /** Whether a box may reach into a marked tile. */
  meets(left, top, right, bottom) {
    const first = Math.max(Math.floor((top - BORDER) / TILE), 0);
    const last = Math.min(Math.floor((bottom + BORDER) / TILE), this.rows - 1);
    for (let row = first; row <= last; row++) {
      const [from, to] = this.spans[row];
      if (from < to && left - BORDER <= to * TILE && right + BORDER >= from * TILE) {
        return true;
      }
    }
    return false;
  }

  /** Lets a canvas draw on marked tiles only, and clears these. */
  clip(context) {
    context.beginPath();
    this.spans.forEach(([from, to], row) => {
      if (from < to) {
        context.rect(from * TILE, row * TILE, (to - from) * TILE, TILE);
      }
    });
    context.clip();
    context.clearRect(0, 0, this.columns * TILE, this.rows * TILE);
  }
}
