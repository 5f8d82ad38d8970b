// What the page says of a step: its sentence, its counters, its section, and the steps around it.

const element = (id) => document.getElementById(id);
/** Steps that start with the sorting: one for all of it, unless it is spread out. */
let isSpread = false;

/** The position of a step on the slider, and the step at a position. */
const hidden = () => (isSpread ? 0 : Math.max(SORTED - BEFORE - 1, 0));
const positionOf = (step) => (step <= BEFORE ? 0 : Math.max(step - BEFORE - hidden(), 1));
const stepAt = (position) => (position <= 0 ? BEFORE : position + BEFORE + hidden());

/** The heading of a step as it is shown, its sentence, and the position of its section. */
function wordsOf(step) {
  const words = textOf(step);
  if (isSpread || step <= BEFORE || step > SORTED) {
    return words;
  }
  const some = trace.sorted.slice(0, 12).join(", ");
  const dots = trace.sorted.length > 12 ? ", …" : "";
  const sentence = `The ${trace.sorted.length} vertices are put in sweep order, by y and then by x: ${some}${dots}.`;
  return [words[0], sentence, words[2]];
}

/** The number of a step, or the numbers of all that sort. */
function nameOf(step) {
  const isAll = !isSpread && step === SORTED && SORTED > trace.first;
  return isAll ? `${trace.first}–${SORTED}` : `${step}`;
}

/** Shows the words of a scene, and the list of the steps around it. */
function describe(scene) {
  const { number } = scene;
  const [heading, sentence, section] = wordsOf(number);
  element("position").textContent = `Step ${nameOf(number)} of ${trace.total}`;
  const [what, where] = heading.split(" · ");
  element("heading").textContent = where ? `${what} · ` : what;
  if (where) {
    element("heading").append(toSection(where));
  }
  element("sentence").textContent = sentence;
  element("picture").setAttribute("aria-label", `The triangulation after this step: ${heading}. ${sentence}`);
  Object.assign(element("slider"), { max: positionOf(LAST), value: positionOf(number) });
  element("slider").setAttribute("aria-valuetext", `Step ${nameOf(number)} of ${trace.total}: ${sentence}`);
  element("spread").hidden = trace.sorted.length < 2 || number > SORTED;
  element("spread").textContent = isSpread ? "Sorting as one step" : "Sorting step by step";
  count(scene);
  element("sections").querySelectorAll("button").forEach((button, at) => {
    button.toggleAttribute("aria-current", at === section);
  });
  const rows = element("steps");
  const most = Math.max(Math.floor(rows.clientHeight / 27), 0);
  const [position, last] = [positionOf(number), positionOf(LAST)];
  const start = Math.max(Math.min(position - Math.floor(most / 3), last + 1 - most), 0);
  const positions = Array.from({ length: Math.min(most, last + 1 - start) }, (_, row) => start + row);
  rows.replaceChildren(...positions.map((at) => row(stepAt(at), number)));
}

/** A way from a step's heading to its section in the list of the paper's sections. */
function toSection(name) {
  const button = document.createElement("button");
  button.textContent = name;
  button.title = "Show this section among those of the paper";
  button.onclick = () => {
    element("sections").open = true;
    element("sections").querySelector("[aria-current]")?.focus();
  };
  return button;
}

/** The counters after a step, and by how much the point event or edge event has raised them so far. */
function count({ number, front, begun }) {
  const [at, start] = [number - BEFORE, Math.max(begun - 1, BEFORE) - BEFORE];
  const counted = (list) => `${list[at]} (+${list[at] - list[start]})`;
  const segments = front.length ? front.length - 1 : 0;
  element("front").textContent = segments;
  element("triangles").textContent = past.triangles[at];
  element("tests").textContent = counted(past.tests);
  element("flips").textContent = counted(past.flips);
}

function row(step, number) {
  const [item, button, label, text] = ["li", "button", "b", "span"].map((name) =>
    document.createElement(name),
  );
  label.textContent = nameOf(step);
  text.textContent = wordsOf(step)[1];
  button.title = text.textContent;
  button.append(label, text);
  button.onclick = () => show(step);
  if (step === number) {
    button.setAttribute("aria-current", "step");
  }
  item.append(button);
  return item;
}

/** The sections of the paper, each a way to its next step. */
function listSections(list) {
  trace.sections.forEach(({ number, title, figures }, section) => {
    const [item, button, name, figure] = ["li", "button", "span", "small"].map((tag) =>
      document.createElement(tag),
    );
    name.textContent = `${number} ${title}`;
    figure.textContent = figures;
    button.append(name, figure);
    const isOf = (step) => step > BEFORE && textOf(step)[2] === section;
    button.title = "To the next step that this section describes";
    button.onclick = () => {
      const step = found(isOf, scene.number);
      return step === null ? say(`No step on this page is of section ${number}.`) : show(step);
    };
    item.append(button);
    list.append(item);
  });
}

/** The first step after another one that is wanted; from the start again after the end. */
function found(isWanted, from) {
  for (let step = Math.max(from, hidden() ? SORTED : 0) + 1; step <= LAST; step++) {
    if (isWanted(step)) {
      return step;
    }
  }
  for (let step = stepAt(1); step <= Math.min(from, LAST); step++) {
    if (isWanted(step)) {
      return step;
    }
  }
  return null;
}

/** Goes to the event of a vertex (`17`, `vertex 17`) or an edge (`edge 4`), or to a step (`step 120`). */
function search(words) {
  const [, what, digits] = /^\s*(v|vertex|e|edge|s|step)?[\s:]*(\d+)\s*$/i.exec(words) ?? [];
  const number = Number(digits);
  if (digits === undefined) {
    say("Type a vertex (17), an edge (edge 4) or a step (step 120).");
  } else if (/^s/i.test(what ?? "")) {
    show(number);
  } else {
    const name = /^e/i.test(what ?? "") ? "about" : "sweep";
    const step = found((at) => changesOf(at).some(([is, v]) => is === name && v === number), BEFORE);
    const kind = name === "about" ? "edge" : "vertex";
    step === null ? say(`No event on this page is of ${kind} ${number}.`) : show(step);
  }
}

/** Tells why a search found nothing. */
function say(words) {
  element("found").textContent = words;
}
