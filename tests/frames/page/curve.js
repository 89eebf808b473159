// A curve over time: one or two series, a mark where the film stands, and a mark at the first difference.
"use strict";

// About `count` round numbers between two limits: multiples of 1, 2 or 5 times a power of ten.
function ticks(low, high, count) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= raw);
  const all = [];
  const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
  for (let i = first; i <= last; ++i) all.push(i * step);
  return all;
}

// The least and the largest number of a list, with some room if they are the same.
function limits(numbers) {
  const low = Math.min(...numbers), high = Math.max(...numbers);
  const room = low === high ? Math.abs(low) / 10 || 1 : 0;
  return [low - room, high + room];
}

// Of a list that is not empty.
const nearestInTime = (points, time) =>
  points.reduce((best, p) => (Math.abs(p.time - time) < Math.abs(best.time - time) ? p : best));

class Curve {
  static height = 132;
  static margin = { left: 46, right: 18, top: 8, bottom: 20 };

  // about: { title, unit, series: [{ name, kind, points: [{ time, value }] }] }; a value may be null.
  // times: the limits of the axis; firstDifference: a time, or null; seek(time): called for a click.
  constructor(about, times, firstDifference, seek) {
    Object.assign(this, { about, times, firstDifference });
    this.values = about.series.map(() => make("b"));
    this.svg = draw("svg", { role: "img", height: Curve.height,
      "aria-label": `${about.title} over time. A click moves the film to that time.` });
    this.element = make("figure", { class: "curve" }, this.#legend(), this.svg);
    new ResizeObserver(() => this.#redraw()).observe(this.element);
    this.#follow(seek);
  }

  // A curve of nothing but zeros and gaps says nothing.
  static saysSomething(about) {
    return about.series.some((series) => series.points.some((point) => point.value));
  }

  // Moves the mark.
  mark(time) {
    this.time = time;
    this.about.series.forEach((series, i) => {
      this.values[i].textContent = number(nearestInTime(series.points, time).value);
    });
    this.#placeMark();
  }

  #legend() {
    const { title, unit, series } = this.about;
    const names = series.map(({ name, kind }, i) =>
      make("span", { class: `series ${kind}` }, name, " ", this.values[i]));
    return make("figcaption", {}, make("span", { class: "title" }, title),
      make("span", { class: "unit" }, unit), ...names);
  }

  #follow(seek) {
    const at = (event) => {
      const x = event.clientX - this.svg.getBoundingClientRect().left;
      const { left } = Curve.margin, [first, last] = this.times;
      seek(first + ((x - left) / this.#innerWidth()) * (last - first));
    };
    this.svg.addEventListener("pointerdown", (event) => {
      this.svg.setPointerCapture(event.pointerId);
      at(event);
    });
    this.svg.addEventListener("pointermove", (event) => { if (event.buttons & 1) at(event); });
  }

  #innerWidth() {
    return this.width - Curve.margin.left - Curve.margin.right;
  }

  #x(time) {
    const [first, last] = this.times;
    return Curve.margin.left + (this.#innerWidth() * (time - first)) / (last - first);
  }

  #y(value) {
    const { top, bottom } = Curve.margin, [low, high] = this.range;
    return Curve.height - bottom - ((Curve.height - top - bottom) * (value - low)) / (high - low);
  }

  #redraw() {
    this.width = this.element.clientWidth;
    const values = this.about.series.flatMap((series) => series.points.map((point) => point.value));
    this.range = limits(values.filter((value) => value !== null));
    this.pointer = this.#upright("mark");
    this.svg.setAttribute("width", this.width);
    this.svg.replaceChildren(...this.#axes(), ...this.#difference(),
      ...this.about.series.map((series) => this.#line(series)), this.pointer);
    this.#placeMark();
  }

  #placeMark() {
    if (this.pointer && this.time !== undefined) this.#moveTo(this.time, this.pointer);
  }

  // A line from the bottom to the top.
  #upright(name, ...children) {
    const { top, bottom } = Curve.margin;
    return draw("line", { class: name, y1: top, y2: Curve.height - bottom }, ...children);
  }

  #moveTo(time, line) {
    for (const end of ["x1", "x2"]) line.setAttribute(end, this.#x(time));
    return line;
  }

  #axes() {
    const { left, right } = Curve.margin, below = Curve.height - Curve.margin.bottom + 15;
    const rows = ticks(...this.range, 4).flatMap((value) => {
      const y = this.#y(value);
      return [
        draw("line", { class: "grid", x1: left, x2: this.width - right, y1: y, y2: y }),
        draw("text", { x: left - 6, y: y + 4, "text-anchor": "end" }, number(value)),
      ];
    });
    const columns = ticks(...this.times, Math.max(2, Math.floor(this.width / 110))).map((time) =>
      draw("text", { x: this.#x(time), y: below, "text-anchor": "middle" }, `${number(time)} s`));
    return [...rows, ...columns];
  }

  #difference() {
    if (this.firstDifference === null) return [];
    const words = draw("title", {}, "the first difference");
    return [this.#moveTo(this.firstDifference, this.#upright("first-difference", words))];
  }

  // A gap where a value is null.
  #line(series) {
    let pen = "M";
    const path = series.points.map(({ time, value }) => {
      const command = value === null ? "" : `${pen}${this.#x(time)},${this.#y(value)}`;
      pen = value === null ? "M" : "L";
      return command;
    });
    return draw("path", { class: `series ${series.kind}`, d: path.join("") });
  }
}
