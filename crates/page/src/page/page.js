// What the controls do.

const element = (id) => document.getElementById(id);
const computer = new Computer();
const view = new View(element("canvas"), element("tools"));
const input = new Input();
/** The answer that is drawn. */
let answer = null;
/** Whether a picture is being computed, and whether another one is wanted after it. */
let [isBusy, isStale] = [false, false];
/** Whether the steps shown are those of the input and the settings. */
let hasSteps = false;

const settings = () => {
  const form = new FormData(element("settings"));
  return { ...Object.fromEntries(form), split: form.has("split") };
};
const ask = (wanted) => {
  const doing = setTimeout(() => {
    element("doing").textContent = "Computing …";
    element("stop").hidden = false;
  }, 300);
  return computer.ask({ input: input.given, settings: settings(), wanted }, input.files).finally(() => {
    clearTimeout(doing);
    element("doing").textContent = "";
    element("stop").hidden = true;
  });
};

/** Computes and draws; of many changes meanwhile only the last one is computed. */
async function compute({ isNew = false } = {}) {
  hasSteps = false;
  if (isBusy) {
    isStale = isStale || { isNew };
    isStale.isNew ||= isNew;
    return;
  }
  isBusy = true;
  const given = input.given;
  const found = await ask("picture");
  isBusy = false;
  if (found.status === 0) {
    answer = new Answer(found.output);
    if (given === input.given) {
      input.learn(answer);
    }
    if (isNew && answer.summary.points) {
      view.frame(answer.points());
    }
  } else if (isNew && given === input.given) {
    // What stood there before stays.
    input.undo();
  }
  describe(found);
  draw();
  if (isStale) {
    const next = isStale;
    isStale = false;
    await compute(next);
  } else if (!element("steps").hidden) {
    await showSteps();
  }
}

function describe(found) {
  const refused = found.status === 0 ? answer.summary.domain_refused : failure(found);
  say("notice", refused ?? "");
  element("undo").disabled = !input.past.length;
  if (found.status !== 0) {
    return;
  }
  element("doing").textContent = `Computed in ${found.milliseconds.toFixed(0)} ms`;
  element("summary").textContent = summaryOf(answer);
  say("crossings", crossingsOf(answer));
  const remarks = answer.summary.remarks.map((words) => {
    const item = document.createElement("li");
    item.textContent = words;
    return item;
  });
  element("remarks").replaceChildren(...remarks);
  const rows = countersOf(answer).map(([name, value]) => {
    const row = document.createElement("tr");
    const [head, cell] = [document.createElement("th"), document.createElement("td")];
    [head.scope, head.textContent, cell.textContent] = ["row", name, value];
    row.append(head, cell);
    return row;
  });
  element("counts").querySelector("tbody").replaceChildren(...rows);
  element("hint").textContent = input.points
    ? "Click for a point, drag for an edge, or drop a file here."
    : `More than ${MOST_DRAWN.toLocaleString("en")} points are too many to change by hand.`;
}

/** Shows a text where there is one. */
function say(id, words) {
  element(id).hidden = !words;
  element(id).textContent = words;
}

function draw(line) {
  if (answer) {
    view.draw(answer, line);
  }
}

let [isAwaited, lastLine] = [false, null];

/** Draws with the next frame of the screen, however often it is called until then. */
function drawSoon(line) {
  lastLine = line;
  if (!isAwaited) {
    isAwaited = true;
    requestAnimationFrame(() => {
      isAwaited = false;
      draw(lastLine);
    });
  }
}

/** The steps, in the page that the command writes. */
async function showSteps() {
  if (hasSteps) {
    return;
  }
  hasSteps = true;
  const found = await ask({ trace: "html" });
  const isThere = found.status === 0;
  const isCut = isThere && answer && !answer.summary.stats;
  say("steps-notice", isCut ? "These are the steps up to the first edges that the sweep finds to cross." : isThere ? "" : failure(found));
  const player = element("player");
  player.hidden = !isThere;
  URL.revokeObjectURL(player.src);
  player.src = isThere ? address(found.output, "text/html;charset=utf-8") : "about:blank";
}

const address = (bytes, type) => URL.createObjectURL(new Blob([bytes], { type }));

/** The file of the kind and format that is chosen: its name, and the answer that holds it. */
async function chosenFile() {
  const [kind, format] = element("format").value.split(" ");
  const found = await ask({ [kind]: format });
  return [`${input.state.stem}.${format}`, found];
}

async function save() {
  const [name, found] = await chosenFile();
  if (found.status !== 0) {
    say("notice", failure(found));
    return;
  }
  const link = document.createElement("a");
  Object.assign(link, { download: name, href: address(found.output, "application/octet-stream") });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

function undo() {
  if (input.past.length) {
    compute({ isNew: input.undo() });
  }
}

function showTab(name) {
  for (const tab of ["drawing", "steps"]) {
    element(tab).hidden = tab !== name;
    element(`show-${tab}`).setAttribute("aria-selected", tab === name);
    element(`show-${tab}`).tabIndex = tab === name ? 0 : -1;
  }
  if (name === "steps") {
    showSteps();
  }
}

async function openFiles(files) {
  if (files.length) {
    try {
      await input.open(files);
    } catch (error) {
      say("notice", `The file cannot be read: ${error.message}`);
      return;
    }
    await compute({ isNew: true });
  }
}

for (const tab of ["drawing", "steps"]) {
  element(`show-${tab}`).onclick = () => showTab(tab);
  element(`show-${tab}`).onkeydown = ({ key }) => {
    if (key === "ArrowLeft" || key === "ArrowRight") {
      const other = tab === "steps" ? "drawing" : "steps";
      showTab(other);
      element(`show-${other}`).focus();
    }
  };
}
new Pointer(view, input, { changed: () => compute(), looked: drawSoon });
new ResizeObserver(() => (view.resize(), draw())).observe(element("canvas"));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => draw());
element("settings").onchange = () => compute();
element("settings").onsubmit = (event) => event.preventDefault();
element("stop").onclick = () => computer.stop();
element("save").onclick = save;
element("fit").onclick = () => (view.showAll(), draw());
element("undo").onclick = undo;
element("clear").onclick = () => {
  input.draw([], [], { isReplaced: true });
  view.frame([[0, 0], [1000, 700]]);
  compute();
};
element("generate").onsubmit = (event) => {
  event.preventDefault();
  input.generate(element("kind").value, element("count").valueAsNumber, element("seed").valueAsNumber);
  compute({ isNew: true });
};
element("typed").onsubmit = (event) => {
  event.preventDefault();
  input.paste(element("text").value);
  compute({ isNew: true });
};
element("file").onchange = ({ target }) => openFiles(target.files);

// A file may be dropped anywhere; without this the browser would leave the page for it.
const picture = element("picture");
document.addEventListener("dragover", (event) => {
  event.preventDefault();
  picture.classList.add("dropping");
});
document.addEventListener("dragleave", ({ relatedTarget }) => {
  if (!relatedTarget) {
    picture.classList.remove("dropping");
  }
});
document.addEventListener("drop", (event) => {
  event.preventDefault();
  picture.classList.remove("dropping");
  openFiles(event.dataTransfer.files);
});
document.addEventListener("keydown", (event) => {
  if (event.key === "z" && (event.ctrlKey || event.metaKey) && !event.target.matches("input, textarea")) {
    event.preventDefault();
    undo();
  }
});
element("canvas").addEventListener("keydown", ({ key }) => {
  const moves = { "+": () => view.zoom(1.4), "-": () => view.zoom(1 / 1.4), 0: () => view.showAll() };
  const pans = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] };
  if (moves[key] || pans[key]) {
    (moves[key] ?? (() => view.pan(...pans[key])))();
    drawSoon();
  }
});

const EXAMPLE = {
  points: [
    [1, 0.6], [4.1, 0], [7.6, 0.9], [10.4, 0.3], [13.2, 1.2], [2.6, 2], [5.8, 2.3], [8.9, 2.6], [11.7, 2.9],
    [0.3, 3.3], [3.9, 3.7], [6.9, 4.1], [14.1, 3.8], [9.8, 4.7], [1.9, 5], [5.1, 5.6], [12.4, 5.5], [7.8, 6.2],
    [3.3, 6.9], [10.6, 7], [0.8, 7.3], [13.6, 7.5], [6, 7.9], [8.8, 8.4], [2.3, 8.7], [11.9, 8.9],
  ],
  edges: [[20, 4], [24, 23], [9, 2], [21, 16], [25, 17]],
};
input.draw(EXAMPLE.points, EXAMPLE.edges);
input.past = [];
compute({ isNew: true });
