// The knobs: the server says which there are, what they may be, and what they are.

import { element, short } from "./draw.js";

const STEPS = 1000;

/** The controls of a list of knobs. They stay while the list keeps its shape, so that a slider is not lost under the hand. */
export class Knobs {
  /** @param {HTMLElement} place @param {(id: string, value: number|string|null) => void} turned */
  constructor(place, turned) {
    this.place = place;
    this.turned = turned;
    this.shape = "";
    this.controls = new Map();
  }

  /** @param {Array<object>} knobs @param {string[]} first Those of a guide, which come first. */
  show(knobs, first) {
    const shape = JSON.stringify([first, knobs.map((knob) => [knob.id, knob.group, knob.options, knob.least, knob.most])]);
    if (shape !== this.shape) this.build(knobs, first);
    this.shape = shape;
    for (const knob of knobs) this.controls.get(knob.id)(knob);
  }

  build(knobs, first) {
    const focused = document.activeElement?.id;
    this.controls.clear();
    const group = (title, own, open) => {
      const rows = own.map((knob) => this.control(knob, title !== knob.group));
      return element("details", { open }, element("summary", {}, title), ...rows);
    };
    const shown = first.flatMap((id) => knobs.filter((knob) => knob.id === id));
    const others = knobs.filter((knob) => !first.includes(knob.id));
    const titles = [...new Set(others.map((knob) => knob.group))];
    const narrow = matchMedia("(max-width: 60rem)").matches;
    const groups = titles.map((title) => group(title, others.filter((knob) => knob.group === title), first.length === 0 && (!narrow || title === titles[0])));
    this.place.replaceChildren(...(shown.length ? [group("Turn these", shown, true)] : []), ...groups);
    if (focused) document.getElementById(focused)?.focus();
  }

  control(knob, named) {
    const id = `knob-${knob.id}`;
    const label = element("label", { for: id }, named && knob.group !== "Method" ? `${knob.label}, ${knob.group.toLowerCase()}` : knob.label);
    return knob.kind === "choice" ? this.choice(knob, id, label) : this.number(knob, id, label);
  }

  choice(knob, id, label) {
    const options = knob.options.map(([value, text]) => element("option", { value }, text));
    const select = element("select", { id, onchange: () => this.turned(knob.id, select.value) }, ...options);
    this.controls.set(knob.id, (now) => { select.value = now.value; });
    return element("div", { class: "knob" }, label, select);
  }

  number(knob, id, label) {
    const { least, most, factor, logarithmic, beyond } = knob;
    const last = beyond ? STEPS + 1 : STEPS;
    const value = (place) => {
      if (place > STEPS) return null;
      const share = place / STEPS;
      return Number((logarithmic ? least * (most / least) ** share : least + (most - least) * share).toPrecision(4));
    };
    const inside = (number) => Math.min(Math.max(number, least), most);
    const place = (number) => {
      if (number === null) return last;
      return Math.round(STEPS * (logarithmic ? Math.log(number / least) / Math.log(most / least) : (number - least) / (most - least)));
    };
    const unit = knob.unit ? ` ${knob.unit}` : "";
    const words = (number) => (number === null ? beyond : `${short(number * factor)}${unit}`);
    const exact = element("input", {
      type: "text", inputmode: "decimal", class: "exact", "aria-label": `${label.textContent}${unit}`, size: 7,
      onchange: () => {
        const text = exact.value.replace(unit.trim() || " ", "").trim();
        const number = text === beyond ? null : Number((Number(text.replace("\u2212", "-").replace(",", ".")) / factor).toPrecision(12));
        // 1,800 may be 1.8 or 1800.
        const isClear = text !== "" && !/,\d{3}$/.test(text);
        const runs = number === null || (isClear && inside(number) === number);
        exact.setCustomValidity(runs ? "" : `${text}: allowed is ${words(least)} to ${words(most)}${beyond ? `, or ${beyond}` : ""}`);
        if (!exact.reportValidity()) exact.value = words(current).replace(unit, "");
        else this.turned(knob.id, number);
      },
      oninput: () => exact.setCustomValidity(""),
    });
    let current = null;
    const told = (number) => {
      slider.setAttribute("aria-valuetext", words(number));
      if (document.activeElement !== exact) exact.value = number === null ? beyond : short(number * factor);
    };
    const slider = element("input", {
      id, type: "range", min: 0, max: last, step: 1,
      oninput: () => {
        const number = value(Number(slider.value));
        told(number);
        this.turned(knob.id, number === null ? null : inside(number));
      },
    });
    this.controls.set(knob.id, (now) => {
      const number = current = now.value ?? null;
      if (document.activeElement !== slider) slider.value = place(number);
      told(number);
    });
    return element("div", { class: "knob" }, label, slider, element("span", {}, exact, element("span", { class: "unit" }, unit)));
  }
}
