// The input: a file, generated data, or a drawing, which is a file that the page writes.

/** So many points can be drawn or changed by hand. */
const MOST_DRAWN = 20_000;
/** So many changes can be undone. */
const MOST_UNDONE = 50;

class Input {
  constructor() {
    this.past = [];
    this.draw([], []);
  }

  /** Takes another state. What stood before can be had again, but for that inside of one drag. */
  become(state, { isReplaced = false, isContinued = false } = {}) {
    if (this.state && !isContinued) {
      this.past.push({ state: this.state, isReplaced });
      this.past.splice(0, this.past.length - MOST_UNDONE);
    }
    this.state = state;
  }

  /** Takes the state before the last change back. Whether that was a replacement of the whole. */
  undo() {
    const { state, isReplaced } = this.past.pop() ?? { state: this.state, isReplaced: false };
    this.state = state;
    return isReplaced;
  }

  get given() {
    return this.state.given;
  }

  get files() {
    return this.state.files;
  }

  /** The points and edges, if they can be changed by hand. */
  get points() {
    return this.state.points;
  }

  get edges() {
    return this.state.edges;
  }

  /** Takes files: one to read, and maybe the `.node` beside a `.poly`. */
  async open(files) {
    const extension = ({ name }) => /[^.]*$/.exec(name)[0].toLowerCase();
    const list = [...files];
    const main = list.find((file) => extension(file) !== "node") ?? list[0];
    const node = list.find((file) => file !== main && extension(file) === "node");
    const parts = [main, node].filter(Boolean);
    const bytes = await Promise.all(parts.map(async (file) => new Uint8Array(await file.arrayBuffer())));
    this.become(file(main.name, extension(main), bytes[0], node && [node.name, bytes[1]]), { isReplaced: true });
  }

  /** Takes text of any of these formats, by its first letters. */
  paste(words) {
    const start = words.trim();
    const isMap = start.startsWith("{") && /"type"\s*:/.test(start);
    const format = isMap ? "geojson" : start.startsWith("{") ? "json" : /^[a-z]/i.test(start) ? "wkt" : "poly";
    this.become(file("text", format, new TextEncoder().encode(words)), { isReplaced: true });
  }

  generate(kind, points, seed) {
    const given = { generated: { kind, points, seed } };
    const state = { given, files: new Uint8Array(), stem: kind, points: null, edges: null };
    this.become(state, { isReplaced: true });
  }

  /** What was read, so that it can be changed. */
  learn(answer) {
    if (!this.points && answer.summary.points <= MOST_DRAWN) {
      Object.assign(this.state, { points: answer.points(), edges: pairs(answer.edges) });
    }
  }

  /** Takes other points and edges. */
  draw(points, edges, how) {
    const text = JSON.stringify({ points, edges });
    const drawn = file("drawing.json", "json", new TextEncoder().encode(text));
    this.become({ ...drawn, points, edges }, how);
  }

  /** Without a vertex, whose edges go with it; those after it move up. */
  erasePoint(gone) {
    const moved = (v) => (v > gone ? v - 1 : v);
    const edges = this.edges.filter((ends) => !ends.includes(gone)).map((ends) => ends.map(moved));
    this.draw(this.points.filter((_, v) => v !== gone), edges);
  }

  eraseEdge(gone) {
    this.draw(this.points, this.edges.filter((_, edge) => edge !== gone));
  }
}

/** A state: a file, and maybe the `.node` beside it. */
function file(name, format, bytes, node = null) {
  const [nodeName, nodeBytes] = node ?? [null, new Uint8Array()];
  const files = new Uint8Array(bytes.length + nodeBytes.length);
  files.set(bytes);
  files.set(nodeBytes, bytes.length);
  const given = {
    file: { name, format, bytes: bytes.length, node: node && [nodeName, nodeBytes.length] },
  };
  return { given, files, stem: name.replace(/\.[^.]*$/, ""), points: null, edges: null };
}
