// Panels over time: histories as lines, collisions as stems. A line follows the time; the pointer reads values anywhere, and picks a range.

import { at, element, short, svg, ticks } from "./draw.js";

const LEFT = 52;
const RIGHT = 16;
const TOP = 8;
const BOTTOM = 26;
/** A press that moves less is a click [px]. */
const CLICK = 6;

/** @typedef {{name: string, values: number[], hue: number, dashed?: boolean}} Series Values in the unit of the panel. */

export class Chart {
  title; unit; height; width; interval; cursor; pointer; picked; hovered; from = null; time = 0; range = [0, 0];
  /** @type {Series[]} */ series = [];
  /** @type {Array<{time: number, value: number, hue: number, words: string}>} */ stems = [];

  /** @param {{title: string, unit: string, height: number, seek: (time: number) => void, zoom: (range: [number, number]) => void}} about */
  constructor({ title, unit, height, seek, zoom }) {
    Object.assign(this, { title, unit, height });
    this.readout = element("span", { class: "readout" });
    this.legend = element("span", { class: "legend" });
    this.canvas = element("div", { class: "canvas" });
    this.place = element("figure", { class: "chart" }, element("figcaption", {}, element("strong", {}, title), this.legend, this.readout), this.canvas);
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons !== 1) this.from = null;
      this.read(this.under(event));
    });
    this.canvas.addEventListener("pointerdown", (event) => {
      this.from = this.under(event);
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener("pointerup", (event) => {
      const [from, to] = [this.from, this.under(event)];
      this.from = null;
      if (from === null) return;
      if (Math.abs(this.x(to) - this.x(from)) < CLICK) seek(to);
      else zoom([Math.min(from, to), Math.max(from, to)]);
    });
    for (const end of ["pointerleave", "pointercancel"]) this.canvas.addEventListener(end, () => { this.from = null; this.read(null); });
  }

  /** @param {{interval: number, range: [number, number], series?: Series[], stems?: Array<{time: number, value: number, hue: number, words: string}>}} data */
  show({ interval, range, series = [], stems = [] }) {
    Object.assign(this, { interval, range, series, stems });
    const named = series.filter((one) => !one.dashed);
    this.legend.replaceChildren(...named.map((one) => element("span", { class: `key hue${one.hue % 4}` }, one.name)), ...(named.length < series.length ? [element("span", {}, "dashed: exact")] : []));
    this.draw();
  }

  draw() {
    const width = this.canvas.clientWidth;
    const [start, end] = this.range;
    if (!width || end <= start) return;
    this.width = width;
    const { height, interval } = this;
    const first = Math.max(0, Math.floor(start / interval));
    const series = this.series.map((one) => ({ ...one, values: one.values.slice(first, Math.ceil(end / interval) + 1) }));
    const inside = this.stems.filter(({ time }) => time >= start && time <= end);
    let [least, most] = [0, 0];
    for (const { values } of series) for (const value of values) [least, most] = [Math.min(least, value), Math.max(most, value)];
    for (const { value } of inside) most = Math.max(most, value);
    if (most <= least) most = least + 1;
    const y = (value) => TOP + ((most - value) / (most - least)) * (height - TOP - BOTTOM);
    const marks = ticks(least, most, height > 130 ? 5 : 3).flatMap((value) => [
      svg("path", { class: value === 0 ? "axis" : "grid", d: `M${LEFT} ${y(value)}H${width - RIGHT}` }),
      svg("text", { x: LEFT - 6, y: y(value) + 4, class: "left" }, short(value, 3)),
    ]);
    const times = ticks(start, end, Math.max(3, width / 110)).map((time) => svg("text", { x: this.x(time), y: height - 8, class: "middle" }, `${short(time)} s`));
    const lines = series.map(({ values, hue, dashed }) => svg("path", { class: `line hue${hue % 4}${dashed ? " dashed" : ""}`, d: this.path(values, first, y) }));
    const stems = inside.map(({ time, value, hue }) => svg("path", { class: `stem hue${hue % 4}`, d: `M${this.x(time)} ${y(0)}V${y(value)}` }));
    this.cursor = svg("path", { class: "cursor" });
    this.pointer = svg("path", { class: "pointer" });
    this.picked = svg("path", { class: "picked" });
    const words = `${this.title} in ${this.unit} over time`;
    this.canvas.replaceChildren(svg("svg", { class: "film", width, height, role: "img", "aria-label": words }, ...marks, ...times, this.picked, ...lines, ...stems, this.cursor, this.pointer));
    this.frame(this.time);
  }

  /** A line through the least and the largest value of every pixel. */
  path(values, first, y) {
    const perPixel = Math.max(1, Math.floor(values.length / (this.width - LEFT - RIGHT)));
    let path = "";
    for (let from = 0; from < values.length; from += perPixel) {
      let [low, high] = [from, from];
      for (let index = from; index < Math.min(from + perPixel, values.length); index += 1) {
        if (values[index] < values[low]) low = index;
        if (values[index] > values[high]) high = index;
      }
      for (const index of low < high ? [low, high] : low > high ? [high, low] : [low]) {
        path += `${path ? "L" : "M"}${this.x((first + index) * this.interval).toFixed(1)} ${y(values[index]).toFixed(1)}`;
      }
    }
    return path;
  }

  x(time) {
    const [start, end] = this.range;
    return LEFT + Math.min(Math.max((time - start) / (end - start), 0), 1) * (this.width - LEFT - RIGHT);
  }

  under(event) {
    const x = event.clientX - this.canvas.getBoundingClientRect().left;
    const [start, end] = this.range;
    return start + Math.min(Math.max((x - LEFT) / (this.width - LEFT - RIGHT), 0), 1) * (end - start);
  }

  /** Moves the line to an instant. */
  frame(time) {
    this.time = time;
    if (!this.cursor) return;
    this.cursor.setAttribute("d", `M${this.x(time)} ${TOP}V${this.height - BOTTOM}`);
    if (!this.hovered) this.readout.textContent = this.words(time);
  }

  read(time) {
    this.hovered = time !== null;
    this.pointer?.setAttribute("d", this.hovered ? `M${this.x(time)} ${TOP}V${this.height - BOTTOM}` : "");
    this.picked?.setAttribute("d", this.from === null ? "" : `M${this.x(this.from)} ${TOP}H${this.x(time)}V${this.height - BOTTOM}H${this.x(this.from)}Z`);
    this.readout.textContent = this.words(time ?? this.time);
  }

  /** What the panel shows at an instant. */
  words(time) {
    if (this.stems.length) {
      const near = this.stems.reduce((best, one) => (Math.abs(one.time - time) < Math.abs(best.time - time) ? one : best));
      return near.words;
    }
    const values = this.series.map(({ name, values: own }) => `${name} ${short(at(own, time / this.interval), 3)}`);
    return this.series.length ? `${time.toFixed(2)} s: ${values.join(", ")} ${this.unit}` : "none";
  }
}
