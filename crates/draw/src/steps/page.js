// The controls: which step is shown, and which part of the plane. And the legend.

let number = BEFORE;
let scene = sceneAt(number);
const view = new View(element("picture"));
let timer = null;
let addressTimer = null;

/** Shows a step; the address follows a little later, since browsers limit how often it may change. */
function show(wanted) {
  number = Math.min(Math.max(Math.round(wanted) || BEFORE, BEFORE), LAST);
  number = stepAt(positionOf(number));
  scene = sceneAt(number);
  say("");
  view.follow(scene.step);
  describe(scene);
  view.draw(scene);
  addressTimer ??= setTimeout(() => {
    addressTimer = null;
    history.replaceState(null, "", `#step=${number}`);
  }, 200);
}

/** Shows the step so many positions farther. */
function move(positions) {
  show(stepAt(Math.min(positionOf(number) + positions, positionOf(LAST))));
}

/** The next step in a direction that begins a point event, an edge event or a part of the algorithm. */
function nextEvent(direction) {
  const begins = (change) => ["sweep", "swept", "edge", "end"].includes(change[0]);
  let at = number + direction;
  while (at > SORTED && at < LAST && !changesOf(at).some(begins)) {
    at += direction;
  }
  // The sorting has no events.
  return direction < 0 && at <= SORTED ? BEFORE : Math.max(at, Math.min(SORTED + 1, LAST));
}

function play(wanted = timer === null) {
  clearInterval(timer);
  timer = null;
  if (wanted) {
    if (number === LAST) {
      show(BEFORE);
    }
    const advance = () => (number < LAST ? move(1) : play(false));
    timer = setInterval(advance, 1000 / element("speed").value);
  }
  element("play").textContent = timer === null ? "Play" : "Pause";
}

/** Shows the step that the address names, as in `#step=120`. */
function followAddress() {
  const step = /^#step=(\d+)$/.exec(location.hash);
  show(step ? Number(step[1]) : number === BEFORE ? trace.start : number);
}

function look(move) {
  move();
  view.draw(scene);
}

/** The legend, drawn in the same styles as the picture. */
function drawLegend(list) {
  list.replaceChildren();
  for (const style of trace.styles.filter(({ meaning }) => meaning)) {
    const item = document.createElement("li");
    const sample = document.createElement("canvas");
    [sample.width, sample.height] = [68, 36];
    sample.setAttribute("aria-hidden", "true");
    const painter = new Painter(sample.getContext("2d"), 100);
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
  before: () => move(-1),
  play: () => play(),
  after: () => move(1),
  "event-after": () => show(nextEvent(1)),
  last: () => show(LAST),
  nearer: () => look(() => view.zoom(1.4)),
  farther: () => look(() => view.zoom(1 / 1.4)),
  spread: () => {
    isSpread = !isSpread;
    show(number);
  },
  "near-step": () => look(() => view.showStep(scene.step)),
  whole: () => look(() => view.showAll()),
  search: () => element("search").focus(),
};

const KEYS = {
  Home: "first", PageUp: "event-before", ArrowLeft: "before", " ": "play", ArrowRight: "after",
  PageDown: "event-after", End: "last", "+": "nearer", "=": "nearer", "-": "farther", z: "near-step", 0: "whole", "/": "search",
};

for (const [id, act] of Object.entries(ACTIONS).filter(([id]) => id !== "search")) {
  element(id).onclick = act;
}
document.addEventListener("keydown", (event) => {
  const action = KEYS[event.key];
  const isTyped = event.target.matches("select, input:not([type=range], [type=checkbox])");
  const isPressed = [" ", "Enter"].includes(event.key) && event.target.matches("button, summary, [type=checkbox]");
  const isTaken = event.ctrlKey || event.metaKey || event.altKey || isTyped || isPressed;
  if (action && !isTaken) {
    event.preventDefault();
    ACTIONS[action]();
  }
});
element("slider").oninput = (event) => show(stepAt(event.target.valueAsNumber));
element("follow").onchange = (event) => {
  view.isFollowing = event.target.checked;
  show(number);
};
element("searching").onsubmit = (event) => {
  event.preventDefault();
  search(element("search").value);
};
element("speed").onchange = () => play(timer !== null);
window.addEventListener("hashchange", followAddress);
new ResizeObserver(() => look(() => (view.resize(), describe(scene)))).observe(element("picture"));

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

element("notice").hidden = trace.notices.length === 0;
element("notice").textContent = trace.notices.join(" ");
for (const wide of document.querySelectorAll("details")) {
  wide.open = innerWidth > 860 && wide.id === "legend";
}
listSections(element("sections").querySelector("ul"));
drawLegend(element("legend").querySelector("ul"));
dark.addEventListener("change", () => {
  drawLegend(element("legend").querySelector("ul"));
  view.draw(scene);
});
followAddress();
