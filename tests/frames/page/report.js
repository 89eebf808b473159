// The report: one section for each pair of runs, the worst first, and the keys.
"use strict";

const severity = { different: 2, equivalent: 1, identical: 0 };

const worstDistance = (pair) => Math.max(0, ...pair.frames.map((frame) => frame.worst_mm ?? 0));

const worstFirst = (a, b) =>
  severity[b.verdict] - severity[a.verdict] || worstDistance(b) - worstDistance(a);

// out/first and out/second become first and second: directories that all names share are left out.
function shortenNames(pairs) {
  const runs = pairs.flatMap((pair) => pair.runs), paths = runs.map((run) => run.name.split("/"));
  const shortest = Math.min(...paths.map((path) => path.length));
  let shared = 0;
  while (shared < shortest - 1 && paths.every((path) => path[shared] === paths[0][shared])) ++shared;
  runs.forEach((run, i) => { run.name = paths[i].slice(shared).join("/"); });
}

// --- the head

function title(pairs) {
  const differ = pairs.filter((pair) => pair.verdict === "different").length;
  if (pairs.length !== 1) return `${differ} of ${pairs.length} runs differ from the first`;
  return pairs[0].runs.map((run) => run.name).join(" and ");
}

function inputTable(pair) {
  if (pair.inputs.length === 0)
    return make("p", { class: "quiet" }, "Nothing differs in run.toml.");
  const head = make("tr", {}, make("th", {}, "in run.toml"), make("th", { class: "a" }, "A"),
    make("th", { class: "b" }, "B"));
  const cells = (values) => values.map((value) => make("td", {}, value));
  const rows = pair.inputs.map(({ key, values }) =>
    make("tr", {}, make("th", { scope: "row" }, key), ...cells(values)));
  return make("div", { class: "wide" },
    make("table", { class: "inputs" }, make("thead", {}, head), make("tbody", {}, ...rows)));
}

const noteList = (notes) =>
  make("ul", { class: "notes" }, ...notes.map((note) => make("li", {}, note)));

function commands(pair) {
  const all = pair.runs.map((run, i) => [`reproduce ${letters[i]}`, run.reproduce]);
  all.push(["accept B as the new A", pair.accept]);
  return make("div", { class: "commands" },
    ...all.filter(([, command]) => command).map(([label, command]) => commandLine(label, command)));
}

// --- curves

// A series of a run's own values, over its own times; or of values of the pairs.
const ofRuns = (pair, key) => pair.runs.map((run, i) => ({
  name: letters[i], kind: letters[i].toLowerCase(),
  points: run.frames.map((frame) => ({ time: frame.time, value: frame[key] })),
}));
const ofFrames = (pair, name, kind, value) =>
  ({ name, kind, points: pair.frames.map((frame) => ({ time: frame.time, value: value(frame) })) });

const allCurves = (pair) => [
  { title: "Distance", unit: "mm", series: [
    ofFrames(pair, "worst", "worst", (frame) => frame.worst_mm),
    ofFrames(pair, "RMS", "rms", (frame) => frame.rms_mm)] },
  { title: "Pixels of the cloth that differ", unit: "%", series: [
    ofFrames(pair, "", "worst", ({ pixels, of }) => (pixels ? (100 * pixels) / of : pixels))] },
  { title: "Energy", unit: "J", series: ofRuns(pair, "energy") },
  { title: "Largest stretch", unit: "", series: ofRuns(pair, "stretch") },
  { title: "Lowest point", unit: "m", series: ofRuns(pair, "lowest") },
  { title: "Iterations since the start", unit: "", series: ofRuns(pair, "iterations") },
];

function curvesOf(pair, seek) {
  const times = limits(pair.runs.flatMap((run) => run.frames.map((frame) => frame.time)));
  const first = pair.first_difference === null ? null : pair.frames[pair.first_difference].time;
  return allCurves(pair).filter(Curve.saysSomething).map((about) =>
    new Curve(about, times, first, seek));
}

// --- a pair

const pictures = new Pictures();

let active = null;  // the film that the keys move

function fill(section, pair) {
  let film = null;
  const curves = curvesOf(pair, (time) => { if (film.frames.length > 0) film.goToTime(time); });
  film = new Film(pair, pictures, (frame) => curves.forEach((curve) => curve.mark(frame.time)));
  const activate = () => {
    if (active && active !== film) active.pause();
    active = film;
    for (const each of document.querySelectorAll(".pair"))
      each.classList.toggle("active", each === section);
  };
  for (const event of ["pointerdown", "focusin"]) section.addEventListener(event, activate);
  if (!active) activate();
  section.append(inputTable(pair), noteList(pair.notes), film.element,
    make("p", { class: "legend quiet" }, make("i", { class: "now" }), "the time of the pictures",
      make("i", { class: "first" }), "the first difference", " · a click on a curve goes there"),
    make("div", { class: "curves" }, ...curves.map((curve) => curve.element)), commands(pair));
}

// The pictures of a folded pair are loaded when it is opened.
function pairSection(pair, isOpen) {
  const [a, b] = pair.runs.map((run, i) => make("span", { class: letters[i].toLowerCase() }, run.name));
  const section = make("details", { class: "pair", open: isOpen },
    make("summary", {}, verdictBadge(pair.verdict), make("span", { class: "who" }, a, " | ", b),
      make("span", { class: "sentence" }, pair.summary)));
  const fillOnce = () => {
    if (!section.open) return;
    section.removeEventListener("toggle", fillOnce);
    fill(section, pair);
  };
  if (isOpen) fill(section, pair);
  else section.addEventListener("toggle", fillOnce);
  return section;
}

// --- keys

// These have keys of their own.
const takesKeys = (target, key) =>
  target.matches("select, input:not(.scrubber)") ||
  (key === " " && target.matches("button, summary"));

const keys = {
  " ": () => active.toggle(),
  ArrowLeft: () => active.step(-1),
  ArrowRight: () => active.step(1),
  Home: () => active.step(-Infinity),
  End: () => active.step(Infinity),
  b: () => active.hold(true),
};
views.forEach((view, i) => { keys[i + 1] = () => active.setView(view.name); });

const nameOfKey = (event) => (event.key.length === 1 ? event.key.toLowerCase() : event.key);

addEventListener("keydown", (event) => {
  const act = keys[nameOfKey(event)];
  if (!act || !active || event.ctrlKey || event.altKey || event.metaKey) return;
  if (takesKeys(event.target, event.key)) return;
  event.preventDefault();
  act();
});
addEventListener("keyup", (event) => { if (nameOfKey(event) === "b") active?.hold(false); });

// --- the page

const pairs = theData().pairs.sort(worstFirst);
shortenNames(pairs);
document.title = document.getElementById("title").textContent = title(pairs);
document.getElementById("pairs").append(...pairs.map((pair) =>
  pairSection(pair, pairs.length === 1 || pair.verdict === "different")));
