// Small helpers for elements, SVG and numbers.

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes and children; text becomes text, never markup. */
export function element(name, attributes = {}, ...children) {
  return filled(document.createElement(name), attributes, children);
}

/** The same of SVG. */
export function svg(name, attributes = {}, ...children) {
  return filled(document.createElementNS(SVG, name), attributes, children);
}

function filled(made, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, "");
    else if (value !== false && value !== undefined) made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

/** A number with at most this many significant digits, and the real minus sign. */
export function short(value, digits = 4) {
  if (value === 0) return "0";
  const text = Math.abs(value) >= 10 ** digits ? Math.round(value).toString() : Number(value.toPrecision(digits)).toString();
  return text.replace("-", "\u2212");
}

/** Round values for an axis from `least` to `most`. */
export function ticks(least, most, count) {
  const rough = (most - least) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= rough);
  const found = [];
  for (let n = Math.ceil(least / step); n * step <= most; n += 1) found.push(Number((n * step).toPrecision(12)));
  return found;
}

/** A value of a history at an instant, linear between states. */
export function at(history, place) {
  const before = Math.min(Math.max(Math.floor(place), 0), history.length - 1);
  const after = Math.min(before + 1, history.length - 1);
  return history[before] + (history[after] - history[before]) * Math.min(Math.max(place - before, 0), 1);
}
