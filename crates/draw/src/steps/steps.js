// The steps of the page: their words, what they change, and when each thing is there.

const trace = JSON.parse(document.getElementById("trace").textContent);
/** The number of the step before the first one of this page, of the last one that sorts, and of its last one. */
const BEFORE = trace.first - 1;
const SORTED = BEFORE + trace.sorted.length;
const LAST = SORTED + trace.steps.length;
const LEFT = -1;
const RIGHT = -2;
const NEVER = 2 ** 31 - 1;

/** A list at its places in the input. */
function placed(list, numbers) {
  const all = [];
  numbers?.forEach((number, at) => (all[number] = list[at]));
  return numbers ? all : list;
}
trace.points = placed(trace.points, trace.pointNumbers);
trace.edges = placed(trace.edges, trace.edgeNumbers);
const BLANKS = trace.sentences.map((sentence) => sentence.split("#").length - 1);

/** The changes in a list of numbers, from a position on: each its name and its vertices. */
function decoded(codes, from = 0) {
  const changes = [];
  for (let at = from; at < codes.length; ) {
    const [name, count] = trace.kinds[codes[at]];
    changes.push([name, ...codes.slice(at + 1, at + 1 + count)]);
    at += 1 + count;
  }
  return changes;
}

/** What a step changes. */
function changesOf(step) {
  if (step <= SORTED) {
    return step > BEFORE ? [["vertex", trace.sorted[step - trace.first]]] : [];
  }
  const codes = trace.steps[step - SORTED - 1];
  return decoded(codes, 2 + BLANKS[codes[1]]);
}

/** The heading of a step, its sentence, and the position of its section. */
function textOf(step) {
  if (step <= BEFORE) {
    const [vertices, edges] = trace.counts;
    const input = `${vertices} vertices and ${edges} edges.`;
    return [BEFORE === 0 ? "Input" : "Before the first step of this page", input, null];
  }
  const codes = step <= SORTED ? [0, 0, trace.sorted[step - trace.first]] : trace.steps[step - SORTED - 1];
  const [heading, section] = trace.headings[codes[0]];
  let at = 2;
  return [heading, trace.sentences[codes[1]].replaceAll("#", () => codes[at++]), section];
}

/** From which step to which everything is there. */
class History {
  constructor() {
    /** Triangles in the order in which they appear: corners, and the steps at which they come and go. */
    this.corners = [];
    this.born = [];
    this.died = [];
    /** Triangles in the order in which they go. */
    this.dead = [];
    /** Triangles with a corner at P-1 or P-2. */
    this.artificial = [];
    /** Constraints and the steps at which they are fixed. */
    this.fixed = [];
    this.fixedAt = [];
    /** The step at which each vertex is swept, and the vertices in this order. */
    this.sweptAt = [];
    this.sweeps = [];
    /** What else lasts for some steps: its step, its name, its vertices. */
    this.marks = [];
    this.isSweptFrom = this.endsAt = NEVER;
    /** How many tests and flips there are up to each step, and how many triangles after it. */
    const counts = () => new Uint32Array(LAST - BEFORE + 1);
    [this.tests, this.flips, this.triangles] = [counts(), counts(), counts()];
    [this.tests[0], this.flips[0]] = trace.counted;
    this.front = new Front();
    const alive = new Map();
    decoded(trace.base).forEach((change) => this.note(BEFORE, change, alive));
    // A large input's page lacks triangles that its steps are not about.
    const absent = trace.counted[2] - alive.size;
    this.triangles[0] = trace.counted[2];
    for (let step = BEFORE + 1; step <= LAST; step++) {
      const at = step - BEFORE;
      [this.tests[at], this.flips[at]] = [this.tests[at - 1], this.flips[at - 1]];
      for (const change of step > SORTED ? changesOf(step) : []) {
        this.note(step, change, alive);
      }
      this.triangles[at] = alive.size + absent;
    }
    this.front.finish();
  }

  note(step, [name, ...vertices], alive) {
    const at = step - BEFORE;
    const [v] = vertices;
    switch (name) {
      case "add":
        alive.set(key(vertices), this.born.length);
        if (Math.min(...vertices) < 0) {
          this.artificial.push(this.born.length);
        }
        this.corners.push(vertices);
        this.born.push(step);
        this.died.push(NEVER);
        break;
      case "pierce":
      case "remove": {
        const triangle = alive.get(key(vertices));
        alive.delete(key(vertices));
        this.died[triangle] = step;
        this.dead.push(triangle);
        break;
      }
      case "join":
        this.front.join(step, v, vertices[1]);
        break;
      case "leave":
        this.front.leave(step, v);
        break;
      case "fix":
        this.fixed.push(vertices);
        this.fixedAt.push(step);
        break;
      case "sweep":
        this.sweptAt[v] = step;
        this.sweeps.push(v);
        break;
      case "swept":
        this.isSweptFrom = step;
        break;
      case "end":
        this.endsAt = step;
        break;
      case "legal":
      case "illegal":
      case "fixed":
        this.tests[at] += 1;
        break;
      case "gone":
        this.flips[at] += 1;
        break;
    }
    if (["sweep", "swept", "edge", "upper", "lower", "pierce", "fix"].includes(name)) {
      this.marks.push([step, name, vertices]);
    }
  }

  isThere(triangle, step) {
    return this.born[triangle] <= step && step < this.died[triangle];
  }

  /** The triangles after a step. */
  trianglesAt(step) {
    const end = after(this.born.length, (at) => this.born[at], step);
    return [...Array(end).keys()].filter((triangle) => step < this.died[triangle]);
  }
}

/** The same for vertices in any order. */
function key(vertices) {
  return [...vertices].sort((a, b) => a - b).join();
}

/** The first position whose value is more than `wanted`; values do not decrease. */
function after(length, value, wanted) {
  let [low, high] = [0, length];
  while (low < high) {
    const middle = (low + high) >> 1;
    [low, high] = value(middle) <= wanted ? [middle + 1, high] : [low, middle];
  }
  return low;
}
