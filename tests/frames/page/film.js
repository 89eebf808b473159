// Two films in step: the pictures of the two runs at one time, in four views.
"use strict";

const views = [
  { name: "side", title: "Side by side", help: "" },
  { name: "wipe", title: "Wipe", help: "Drag across the picture: A on the left, B on the right." },
  { name: "swap", title: "Swap", help: "Press the picture, or hold the key B, to see run B." },
  { name: "difference", title: "Difference", help: "Black where the two pictures are the same." },
];

const speeds = [["real time", 1], ["half speed", 0.5], ["a quarter", 0.25], ["a tenth", 0.1]];
const amplifications = [1, 2, 4, 8, 16, 32];

const letters = ["A", "B"];

// A film picture of one run: the picture, or words in its place.
class Screen {
  constructor(letter, run) {
    Object.assign(this, { letter, run });
    this.canvas = make("canvas", { role: "img", hidden: true });
    this.words = make("p", { class: "words" });
    this.element = make("figure", { class: `screen ${letter.toLowerCase()}` },
      make("figcaption", {}, make("b", {}, letter), " ", run.name), this.canvas, this.words);
  }

  // null where the run has no picture of that frame.
  address(frame) {
    if (!frame || frame.picture === null) return null;
    return `${this.run.pictures}/${encodeURIComponent(frame.picture)}`;
  }

  // Shows words if the bitmap is null.
  show(frame, bitmap) {
    this.canvas.hidden = bitmap === null;
    this.words.hidden = bitmap !== null;
    if (bitmap === null) this.words.textContent = this.#lack(frame);
    else this.#draw(frame, bitmap);
  }

  #draw(frame, bitmap) {
    const { width, height } = bitmap;
    Object.assign(this.canvas, { width, height });
    this.canvas.getContext("2d").drawImage(bitmap, 0, 0);
    this.canvas.dataset.picture = this.address(frame);
    this.canvas.setAttribute("aria-label",
      `Run ${this.letter}, frame ${frame.number}, t = ${number(frame.time)} s`);
  }

  #lack(frame) {
    if (!frame) return `${this.letter} has no such frame.`;
    if (frame.picture === null) return `${this.letter} has no picture of frame ${frame.number}.`;
    return `${frame.picture} of ${this.letter} cannot be shown: the file is missing or broken.`;
  }
}

class Film {
  // pair: one of the report's; pictures: the page's Pictures; moved(frame): called whenever the time changes.
  constructor(pair, pictures, moved) {
    Object.assign(this, { pair, pictures, moved });
    this.frames = pair.frames;
    this.screens = pair.runs.map((run, i) => new Screen(letters[i], run));
    this.byNumber = pair.runs.map((run) =>
      new Map(run.frames.map((frame) => [frame.number, frame])));
    this.at = 0;
    this.direction = 1;
    this.element = make("section", { class: "film", "aria-label": "The two films in step" },
      this.#viewBar(), this.#stage(), this.#transport(), this.#facts());
    this.setView("side");
    this.goTo(0);
  }

  // --- time

  // To the frame with that index; beyond the ends, to the end.
  goTo(index) {
    if (this.frames.length === 0) {
      for (const screen of this.screens) screen.show(undefined, null);
      return;
    }
    const target = Math.max(0, Math.min(this.frames.length - 1, index));
    if (target !== this.at) this.direction = Math.sign(target - this.at);
    this.at = target;
    this.scrubber.value = target;
    this.#tell(this.frames[target]);
    this.#follow();
  }

  step(by) {
    this.pause();
    this.goTo(this.at + by);
  }

  goToTime(time) {
    this.pause();
    this.goTo(this.frames.indexOf(nearestInTime(this.frames, time)));
  }

  get playing() {
    return this.request !== undefined;
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  // From here to the end, and again from the start.
  play() {
    if (this.frames.length < 2) return;
    const last = this.frames.length - 1, time = (i) => this.frames[i].time;
    let shown = time(this.at === last ? 0 : this.at), before;
    const tick = (now) => {
      shown += (Number(this.speed.value) * (now - (before ?? now))) / 1000;
      before = now;
      // The last frame stays as long as the one before it.
      if (shown >= time(last) + (time(last) - time(last - 1))) shown = time(0);
      const later = this.frames.findIndex((frame) => frame.time > shown);
      this.goTo(later < 0 ? last : later - 1);
      this.request = requestAnimationFrame(tick);
    };
    this.request = requestAnimationFrame(tick);
    this.#labelPlay("❚❚", "Pause");
  }

  pause() {
    if (!this.playing) return;
    cancelAnimationFrame(this.request);
    this.request = undefined;
    this.#labelPlay("▶", "Play");
  }

  #labelPlay(sign, words) {
    this.playButton.textContent = sign;
    this.playButton.setAttribute("aria-label", words);
  }

  // --- views

  setView(name) {
    this.view = name;
    this.stage.dataset.view = name;
    for (const button of this.viewButtons)
      button.setAttribute("aria-pressed", button.dataset.view === name);
    this.help.textContent = views.find((view) => view.name === name).help;
    this.amplifyLabel.hidden = name !== "difference";
    this.hold(false);
  }

  // Shows B instead of A as long as it is held.
  hold(isHeld) {
    if (isHeld && this.view !== "swap") this.setView("swap");
    this.stage.classList.toggle("held", isHeld);
  }

  // --- pictures

  // Shows the wanted frame as soon as both of its pictures are decoded, so that the two films never differ in
  // time. Meanwhile another frame may be wanted.
  async #follow() {
    if (this.following) return;
    this.following = true;
    while (this.shown !== this.at) {
      const index = this.at, frames = this.#framesAt(index);
      await this.pictures.use(this.#addressesAt(index), (bitmaps) =>
        this.screens.forEach((screen, i) => screen.show(frames[i], bitmaps[i])));
      this.shown = index;
    }
    this.following = false;
    this.#prepareAround(this.at);
  }

  #framesAt(index) {
    return this.frames[index].numbers.map((n, i) => this.byNumber[i].get(n));
  }

  #addressesAt(index) {
    return this.#framesAt(index).map((frame, i) => this.screens[i].address(frame));
  }

  // Prepares frames ahead in the direction of the last move, and some behind, as many as fit.
  #prepareAround(index) {
    const fit = Math.floor(this.pictures.room / 2) - 1;
    const ahead = Math.floor(fit * 0.6), behind = Math.floor(fit * 0.3);
    for (let i = 1; i <= behind; ++i) this.#prepare(index - i * this.direction);
    for (let i = 1; i <= ahead; ++i) this.#prepare(index + i * this.direction);
  }

  #prepare(index) {
    if (index < 0 || index >= this.frames.length) return;
    for (const address of this.#addressesAt(index))
      if (address !== null) this.pictures.prepare(address);
  }

  // --- parts

  #viewBar() {
    this.viewButtons = views.map(({ name, title }) => {
      const button = make("button", { type: "button", "data-view": name }, title);
      button.addEventListener("click", () => this.setView(name));
      return button;
    });
    this.help = make("span", { class: "help" });
    this.amplify = make("select", {}, ...amplifications.map((n) =>
      make("option", { value: n, selected: n === 8 }, `× ${n}`)));
    this.amplify.addEventListener("change", () => this.#setAmplification());
    this.amplifyLabel = make("label", {}, "amplified ", this.amplify);
    return make("div", { class: "views" },
      make("div", { class: "choice", role: "group", "aria-label": "View" }, ...this.viewButtons),
      this.help, this.amplifyLabel);
  }

  #setAmplification() {
    this.stage.style.setProperty("--amplify", this.amplify.value);
  }

  #stage() {
    this.wipe = make("input", { type: "range", class: "wipe", min: 0, max: 100, step: 0.5,
      value: 50, "aria-label": "Wipe: how much of A is seen, in percent" });
    const both = make("div", { class: "screens" }, ...this.screens.map((screen) => screen.element));
    this.stage = make("div", { class: "stage" }, this.#names(), both,
      make("div", { class: "wipe-line" }), this.wipe);
    const setWipe = () => this.stage.style.setProperty("--wipe", this.wipe.value);
    this.wipe.addEventListener("input", setWipe);
    setWipe();
    this.#setAmplification();
    both.addEventListener("pointerdown", () => { if (this.view === "swap") this.hold(true); });
    for (const event of ["pointerup", "pointercancel", "blur"])
      addEventListener(event, () => this.hold(false));
    both.addEventListener("contextmenu", (event) => {
      if (this.view === "swap") event.preventDefault();
    });
    return this.stage;
  }

  // The names of both runs, for the views in which the pictures lie on each other.
  #names() {
    const names = this.screens.map(({ letter, run }) =>
      make("span", { class: letter.toLowerCase() }, make("b", {}, letter), " ", run.name));
    return make("div", { class: "names", "aria-hidden": "true" }, ...names);
  }

  #transport() {
    const last = Math.max(0, this.frames.length - 1);
    this.playButton = make("button", { type: "button", class: "play", disabled: last === 0 });
    this.#labelPlay("▶", "Play");
    this.playButton.addEventListener("click", () => this.toggle());
    this.scrubber = make("input", { type: "range", class: "scrubber", min: 0, max: last, step: 1,
      value: 0, disabled: last === 0, "aria-label": "Frame" });
    this.scrubber.addEventListener("input", () => {
      this.pause();
      this.goTo(Number(this.scrubber.value));
    });
    this.speed = make("select", { "aria-label": "Speed" }, ...speeds.map(([name, value]) =>
      make("option", { value }, name)));
    return make("div", { class: "transport" }, this.playButton,
      make("div", { class: "track" }, this.scrubber, this.#strip()), this.speed);
  }

  // The verdict of every frame, under the scrubber.
  #strip() {
    const cells = this.frames.map((frame, i) =>
      draw("rect", { class: frame.verdict, x: i - 0.5, width: 1, height: 1 }));
    return draw("svg", { class: "strip", "aria-hidden": "true", preserveAspectRatio: "none",
      viewBox: `-0.5 0 ${Math.max(1, this.frames.length)} 1` }, ...cells);
  }

  #facts() {
    const fact = (title) => {
      const value = make("dd");
      this.factList.append(make("div", {}, make("dt", {}, title), value));
      return value;
    };
    this.factList = make("dl", { class: "facts" });
    this.fact = {
      frame: fact("frame"),
      time: fact("time"),
      verdict: fact("verdict"),
      pixels: fact("pixels of the cloth that differ"),
      window: fact("densest 16 × 16"),
      rms: fact("RMS distance"),
      worst: fact("worst vertex"),
    };
    return this.factList;
  }

  #tell(frame) {
    const [a, b] = frame.numbers;
    const orDash = (value, words) => (value === null ? "–" : words);
    const which = frame.worst_mm ? `, number ${frame.worst_vertex}` : "";
    this.fact.frame.textContent = a === b ? String(a) : `${a} | ${b}`;
    this.fact.time.textContent = `${number(frame.time)} s`;
    this.fact.verdict.replaceChildren(verdictBadge(frame.verdict));
    this.fact.pixels.textContent = orDash(frame.pixels, `${frame.pixels} of ${frame.of}`);
    this.fact.window.textContent = orDash(frame.window, `${frame.window} of 256`);
    this.fact.rms.textContent = orDash(frame.rms_mm, `${number(frame.rms_mm)} mm`);
    this.fact.worst.textContent = orDash(frame.worst_mm, `${number(frame.worst_mm)} mm${which}`);
    this.scrubber.setAttribute("aria-valuetext",
      `frame ${this.fact.frame.textContent}, t = ${number(frame.time)} s, ${frame.verdict}`);
    this.moved(frame);
  }
}
