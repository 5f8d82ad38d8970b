// The state of the sweep after any step, rebuilt from copies kept at regular intervals.

const trace = JSON.parse(document.getElementById("trace").textContent);
/** The number of the step before the first one of this page, and of its last one. */
const BEFORE = trace.first - 1;
const LAST = BEFORE + trace.steps.length;
const LEFT = -1;
const RIGHT = -2;
const COPY_EVERY = 250;

class Scene {
  constructor() {
    this.triangles = new Map();
    this.front = [LEFT, RIGHT];
    this.fixed = new Map();
    this.sweep = null;
    this.isSwept = false;
    this.edge = null;
    this.pierced = [];
    this.upper = [];
    this.lower = [];
    /** What the last step changed. */
    this.step = [];
  }

  copy() {
    const copy = Object.assign(new Scene(), this);
    copy.triangles = new Map(this.triangles);
    copy.fixed = new Map(this.fixed);
    for (const list of ["front", "pierced", "upper", "lower"]) {
      copy[list] = [...this[list]];
    }
    return copy;
  }

  advance(changes) {
    this.step = changes;
    for (const [name, ...vertices] of changes) {
      this.change(name, vertices);
    }
  }

  change(name, vertices) {
    const [v, after] = vertices;
    switch (name) {
      case "sweep":
        this.sweep = v;
        this.edge = null;
        break;
      case "swept":
        this.sweep = this.edge = null;
        this.isSwept = true;
        break;
      case "end":
        this.front = [];
        break;
      case "add":
        this.triangles.set(key(vertices), vertices);
        break;
      case "pierce":
        this.pierced.push(vertices);
        this.triangles.delete(key(vertices));
        break;
      case "remove":
        this.triangles.delete(key(vertices));
        break;
      case "join":
        this.front.splice(this.front.indexOf(after) + 1, 0, v);
        break;
      case "leave":
        this.front.splice(this.front.indexOf(v), 1);
        break;
      case "edge":
        this.edge = vertices;
        this.forgetPolygons();
        break;
      case "upper":
      case "lower":
        this[name].push(v);
        break;
      case "fix":
        this.fixed.set(key(vertices), vertices);
        this.forgetPolygons();
        break;
    }
  }

  forgetPolygons() {
    this.pierced = [];
    this.upper = [];
    this.lower = [];
  }
}

/** The same for vertices in any order. */
function key(vertices) {
  return [...vertices].sort((a, b) => a - b).join();
}

const copies = [new Scene()];
copies[0].advance(trace.base);
copies[0].step = [];

/** The state after a step. Reuses `current`, the state after step `currentNumber`, if that is earlier. */
function sceneAt(number, current, currentNumber) {
  const wanted = number - BEFORE;
  let at = Math.min(Math.floor(wanted / COPY_EVERY), copies.length - 1) * COPY_EVERY;
  let scene;
  const currentAt = current ? currentNumber - BEFORE : -1;
  if (currentAt >= at && currentAt <= wanted) {
    [scene, at] = [current, currentAt];
  } else {
    scene = copies[at / COPY_EVERY].copy();
  }
  while (at < wanted) {
    scene.advance(trace.steps[at][2]);
    at += 1;
    if (at === copies.length * COPY_EVERY) {
      copies.push(scene.copy());
    }
  }
  return scene;
}
