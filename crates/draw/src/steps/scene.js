// The state of the sweep after any step.

/** The advancing front: its moves, each of which can be taken back, and copies of it between them. */
class Front {
  constructor() {
    /** Each move: its step, the vertex, the one left of it, and whether it joins. */
    this.moves = [];
    this.vertices = [LEFT, RIGHT];
    this.copies = [[0, [LEFT, RIGHT]]];
    this.done = 0;
  }

  join(step, v, left) {
    this.note([step, v, left, true]);
  }

  leave(step, v) {
    this.note([step, v, this.vertices[this.vertices.indexOf(v) - 1], false]);
  }

  note(move) {
    this.moves.push(move);
    this.turn(move, true);
    this.done += 1;
    const [at, copy] = this.copies.at(-1);
    if (this.done - at > Math.max(500, copy.length)) {
      this.copies.push([this.done, [...this.vertices]]);
    }
  }

  /** Takes a move, or takes it back. */
  turn([, v, left, joins], isForward) {
    if (joins === isForward) {
      this.vertices.splice(this.vertices.indexOf(left) + 1, 0, v);
    } else {
      this.vertices.splice(this.vertices.indexOf(v), 1);
    }
  }

  finish() {
    this.goTo(0);
  }

  /** Brings it to the state after so many moves. */
  goTo(wanted) {
    const copy = this.copies[after(this.copies.length, (at) => this.copies[at][0], wanted) - 1];
    if (Math.abs(wanted - this.done) > wanted - copy[0]) {
      [this.done, this.vertices] = [copy[0], [...copy[1]]];
    }
    while (this.done < wanted) {
      this.turn(this.moves[this.done++], true);
    }
    while (this.done > wanted) {
      this.turn(this.moves[--this.done], false);
    }
  }

  /** Its vertices after a step, from P-1 to P-2. */
  at(step) {
    this.goTo(after(this.moves.length, (at) => this.moves[at][0], step));
    return this.vertices;
  }
}

const past = new History();

/** The state after a step, with what the step changed. */
function sceneAt(number) {
  const scene = {
    number,
    front: number >= past.endsAt ? [] : past.front.at(number),
    isSwept: number >= past.isSweptFrom,
    sweep: null,
    edge: null,
    pierced: [],
    upper: [],
    lower: [],
    step: changesOf(number),
    /** The step that began the point event or edge event. */
    begun: BEFORE,
  };
  let at = after(past.marks.length, (mark) => past.marks[mark][0], number);
  let hasPolygons = true;
  while (at > 0) {
    const [step, name, vertices] = past.marks[--at];
    if (name === "sweep" || name === "swept") {
      scene.begun = Math.max(scene.begun, step);
      scene.sweep = name === "sweep" && !scene.isSwept ? vertices[0] : null;
      break;
    } else if (name === "edge") {
      scene.begun = Math.max(scene.begun, step);
      scene.edge ??= vertices;
      hasPolygons = false;
    } else if (name === "fix") {
      hasPolygons = false;
    } else if (hasPolygons) {
      scene[name === "pierce" ? "pierced" : name].unshift(name === "pierce" ? vertices : vertices[0]);
    }
  }
  return scene;
}
