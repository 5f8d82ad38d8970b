// The controls: which step is shown, and which part of the plane. And the legend.

const element = (id) => document.getElementById(id);
const view = new View(element("picture"));
let number = BEFORE;
let scene = sceneAt(number);
let timer = null;
let addressTimer = null;

/** Shows a step; the address follows a little later, since browsers limit how often it may change. */
function show(wanted) {
  const before = number;
  number = Math.min(Math.max(Math.round(wanted) || BEFORE, BEFORE), LAST);
  scene = sceneAt(number, scene, before);
  view.follow(scene.step);
  describe();
  view.draw(scene);
  addressTimer ??= setTimeout(() => {
    addressTimer = null;
    history.replaceState(null, "", `#step=${number}`);
  }, 200);
}

/** Shows the words of the current step, and the list of the steps around it. */
function describe() {
  const [heading, sentence] = textOf(number);
  element("position").textContent = `Step ${number} of ${trace.total}`;
  element("heading").textContent = heading;
  element("sentence").textContent = sentence;
  element("slider").value = number;
  const rows = element("steps");
  const count = Math.max(Math.floor(rows.clientHeight / 26), 0);
  const start = Math.max(Math.min(number - Math.floor(count / 3), LAST + 1 - count), BEFORE);
  const numbers = Array.from({ length: count }, (_, row) => start + row);
  rows.replaceChildren(...numbers.filter((step) => step <= LAST).map(row));
}

function row(step) {
  const [item, button, label, text] = ["li", "button", "b", "span"].map((name) =>
    document.createElement(name),
  );
  label.textContent = step;
  text.textContent = textOf(step)[1];
  button.title = text.textContent;
  button.append(label, text);
  button.onclick = () => show(step);
  if (step === number) {
    button.setAttribute("aria-current", "step");
  }
  item.append(button);
  return item;
}

function textOf(step) {
  if (step > BEFORE) {
    const [heading, sentence] = trace.steps[step - trace.first];
    return [trace.headings[heading], sentence];
  }
  const input = `${trace.points.length} vertices and ${trace.edges.length} edges.`;
  return BEFORE === 0 ? ["Input", input] : ["Before the first step of this page", input];
}

/** The next step in a direction that begins a point event, an edge event or a part of the algorithm. */
function nextEvent(direction) {
  const begins = (change) => ["sweep", "swept", "edge", "end"].includes(change[0]);
  let at = number + direction;
  while (at > BEFORE && at < LAST && !trace.steps[at - trace.first][2].some(begins)) {
    at += direction;
  }
  return at;
}

function play(wanted = timer === null) {
  clearInterval(timer);
  timer = null;
  if (wanted) {
    if (number === LAST) {
      show(BEFORE);
    }
    const advance = () => (number < LAST ? show(number + 1) : play(false));
    timer = setInterval(advance, 1000 / element("speed").value);
  }
  element("play").textContent = timer === null ? "Play" : "Pause";
}

/** Shows the step that the address names, as in `#step=120`. */
function followAddress() {
  const step = /^#step=(\d+)$/.exec(location.hash);
  show(step ? Number(step[1]) : number);
}

function look(move) {
  move();
  view.draw(scene);
}

/** The legend, drawn in the same styles as the picture. */
function drawLegend(list) {
  for (const style of trace.styles.filter(({ meaning }) => meaning)) {
    const item = document.createElement("li");
    const sample = document.createElement("canvas");
    [sample.width, sample.height] = [68, 36];
    const painter = Object.create(View.prototype);
    Object.assign(painter, { context: sample.getContext("2d"), spacing: 1, scale: 100 });
    painter.context.scale(2, 2);
    if (style.fill || style.hatch) {
      painter.stroke(style, [[3, 15], [31, 15], [17, 3]], true);
    } else if (["legal", "illegal"].includes(style.name)) {
      painter.context.arc(17, 9, 7.5, 0, 2 * Math.PI);
      painter.paint(style);
    } else {
      painter.stroke(style, [[3, 9], [31, 9]]);
    }
    item.append(sample, style.meaning);
    list.append(item);
  }
}

const ACTIONS = {
  first: () => show(BEFORE),
  "event-before": () => show(nextEvent(-1)),
  before: () => show(number - 1),
  play: () => play(),
  after: () => show(number + 1),
  "event-after": () => show(nextEvent(1)),
  last: () => show(LAST),
  nearer: () => look(() => view.zoom(1.4)),
  farther: () => look(() => view.zoom(1 / 1.4)),
  "near-step": () => look(() => view.showStep(scene.step)),
  whole: () => look(() => view.showAll()),
};
const KEYS = {
  Home: "first", PageUp: "event-before", ArrowLeft: "before", " ": "play", ArrowRight: "after",
  PageDown: "event-after", End: "last", "+": "nearer", "=": "nearer", "-": "farther", z: "near-step", 0: "whole",
};

for (const [id, act] of Object.entries(ACTIONS)) {
  element(id).onclick = act;
}
document.addEventListener("keydown", (event) => {
  const action = KEYS[event.key];
  const isTaken = event.ctrlKey || event.metaKey || event.altKey || event.target.matches("select");
  if (action && !isTaken) {
    event.preventDefault();
    ACTIONS[action]();
  }
});
element("slider").oninput = (event) => show(event.target.valueAsNumber);
element("speed").onchange = () => play(timer !== null);
window.addEventListener("hashchange", followAddress);
new ResizeObserver(() => look(() => (view.resize(), describe()))).observe(element("picture"));

const fingers = new Map();
const canvas = element("picture");
canvas.onpointerdown = (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
};
canvas.onpointermove = (event) => {
  const from = fingers.get(event.pointerId);
  if (!from) {
    return;
  }
  const to = [event.offsetX, event.offsetY];
  fingers.set(event.pointerId, to);
  const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
  const apart = (place) => Math.hypot(place[0] - other[0], place[1] - other[1]) || 1;
  look(() => (other ? view.zoom(apart(to) / apart(from), other) : view.pan(to[0] - from[0], to[1] - from[1])));
};
canvas.onpointerup = canvas.onpointercancel = (event) => fingers.delete(event.pointerId);
canvas.onwheel = (event) => {
  event.preventDefault();
  look(() => view.zoom(Math.exp(-event.deltaY / 400), [event.offsetX, event.offsetY]));
};

Object.assign(element("slider"), { min: BEFORE, max: LAST });
if (trace.steps.length < trace.total) {
  element("notice").hidden = false;
  element("notice").textContent =
    `This page holds steps ${trace.first} to ${LAST} of ${trace.total}.`;
}
if (innerWidth <= 860) {
  element("legend").open = false;
}
drawLegend(element("legend").querySelector("ul"));
followAddress();
