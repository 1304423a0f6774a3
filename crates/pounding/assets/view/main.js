// The page: state, runs, and what is shown of them.

import { Refusal, Runner, call, readState, takeToken, writeState } from "./api.js";
import { Chart } from "./charts.js";
import { element, short } from "./draw.js";
import { Knobs } from "./knobs.js";
import { Row, gapsOf } from "./row.js";

const token = takeToken();
/** @param {string} id @returns {any} */
const find = (id) => document.getElementById(id);
const state = readState();
let about = { record_bytes: 0, file: null, guides: [] };
let shown = null;
/** When the knob moved that the next picture answers; the time to that picture stands in an attribute for measurements. */
let asked = null;
/** The timer that tells of a long run. */
let soon;

const time = find("time");
const row = new Row(find("row"), find("scale"));
const charts = {
  displacements: new Chart({ title: "Displacement", unit: "mm", height: 190, seek, zoom }),
  gaps: new Chart({ title: "Open gap", unit: "mm", height: 130, seek, zoom }),
  impacts: new Chart({ title: "Impulses", unit: "kN·s", height: 120, seek, zoom }),
};
find("charts").append(...Object.values(charts).map((chart) => chart.place));
const knobs = new Knobs(find("knobs"), (id, value) => {
  state.knobs[id] = value;
  turned();
});

function turned() {
  asked ??= performance.now();
  find("told").textContent = "";
  writeState(state);
  runner.ask({ ...state, knobs: { ...state.knobs } });
}

const runner = new Runner(async (wanted, signal) => {
  try {
    const answer = await (await call(token, "run", wanted, { signal })).json();
    if (wanted.guide === state.guide) show(answer);
  } catch (error) {
    fail(error);
  }
}, (busy) => {
  document.body.ariaBusy = String(busy);
  clearTimeout(soon);
  document.body.classList.remove("late");
  if (busy) soon = setTimeout(() => document.body.classList.add("late"), 400);
});

/** Tells of an error, unless something later took its place. */
function fail(error) {
  if (error.name === "AbortError" || error.status === 409) return;
  const lost = error instanceof Refusal ? error.message : "The program has ended, or cannot be reached: start `pounding view` again.";
  find("fault").textContent = lost;
  find("fault").hidden = false;
  find("fault").scrollIntoView({ block: "nearest" });
  asked = null;
}

function show([fact, run]) {
  const first = shown === null;
  shown = run;
  find("fault").hidden = true;
  find("fact").textContent = fact ?? "";
  find("fact").hidden = !fact;
  const { player, summary } = run;
  find("title").textContent = summary.scene.name;
  document.title = `${summary.scene.name} – pounding`;
  showAnswer(run);
  row.show(player, gapsOf(summary), run.knobs.find((knob) => knob.id === "direction").value);
  if (summary.scene.arrivals_s) find("scale").textContent += " The bases move apart, too: the panel of gaps shows it, and the row does not.";
  find("shaking").textContent = summary.record.file ? `Record: ${summary.record.file}.` : "A motion from a formula.";
  knobs.show(run.knobs, about.guides.find((one) => one.key === state.guide)?.knobs ?? []);
  if (first) start(player);
  const { duration_s: duration } = summary.method;
  instant = Math.min(instant, duration);
  zoom(range && range[1] <= duration ? range : null);
  requestAnimationFrame(() => {
    if (asked !== null) document.body.dataset.latency = (performance.now() - asked).toFixed(1);
    document.body.dataset.runs = String(Number(document.body.dataset.runs ?? 0) + 1);
    asked = null;
  });
}

/** The sentence of the answer stands first, with the widths that gaps need; the other parts follow the panels. */
function showAnswer({ answer, gaps }) {
  const parts = new DOMParser().parseFromString(answer, "text/html").body;
  const title = (part) => part.querySelector(":scope > h3")?.textContent;
  const sections = [...parts.children];
  const verdict = sections.filter((part) => title(part) === "Answer");
  verdict.forEach((part) => part.querySelector("h3").remove());
  find("verdict").replaceChildren(...verdict);
  find("details").replaceChildren(...sections.filter((part) => !verdict.includes(part) && title(part) !== "More"));
  find("needs").replaceChildren(...gaps.map((gap) => element("li", { class: gap.is_enough ? "enough" : "narrow" }, gap.says)));
}

function showCharts({ player, summary, exact_um: exact }) {
  const { interval_s: interval } = player;
  const span = range ?? [0, summary.method.duration_s];
  const scaled = (values) => values.map((one) => one * 1e-3);
  const roofs = player.structures.map((_, one) => player.floors.findLastIndex((floor) => floor.structure === one && !floor.is_wall)).filter((one) => one >= 0);
  const lines = roofs.map((roof, hue) => ({ name: player.floors[roof].name, values: scaled(player.floors[roof].displacement_um), hue }));
  const beside = exact ? roofs.map((roof, hue) => ({ name: `${player.floors[roof].name}, exact,`, values: scaled(exact[roof]), hue, dashed: true })) : [];
  charts.displacements.show({ interval, range: span, series: [...lines, ...beside] });
  // Of every contact the pair of floors that comes closest.
  const openings = player.pairs.map((pair) => pair.opening_um.reduce((least, one) => Math.min(least, one), Infinity));
  const gaps = gapsOf(summary).map((_, contact) => player.pairs.reduce((best, pair, index) => (pair.contact === contact && (best < 0 || openings[index] < openings[best]) ? index : best), -1)).filter((pair) => pair >= 0);
  charts.gaps.show({ interval, range: span, series: gaps.map((pair, hue) => ({ name: player.pairs[pair].name, values: scaled(player.pairs[pair].opening_um), hue })) });
  const stems = player.collisions.map(({ pair, start_s: start, impulse_n_s: impulse, peak_force_n: force }) => ({
    time: start,
    value: 1e-3 * impulse,
    hue: player.pairs[pair].contact,
    words: `${start.toFixed(3)} s, ${player.pairs[pair].name}: ${short(1e-3 * impulse)} kN·s${force === undefined ? ", impulsive" : `, ${Number((1e-3 * force).toPrecision(2))} kN`}`,
  }));
  charts.impacts.show({ interval, range: span, stems });
}

// ---- Time ----

let playing = false;
let last = null;
/** The instant that is shown [s]; the slider knows it in its steps alone. */
let instant = 0;
/** The range that is zoomed to [s]; without it the whole run. */
let range = null;

/** Begins shortly before the hardest collision: moving, unless less motion is asked for. */
function start(player) {
  const hardest = player.collisions.reduce((best, one) => (best && best.impulse_n_s >= one.impulse_n_s ? best : one), null);
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  instant = hardest ? Math.max(hardest.start_s - (still ? 0 : 1.5), 0) : 0;
  play(!still);
}

function play(on) {
  playing = on;
  last = null;
  find("play").textContent = on ? "Pause" : "Play";
  if (on) requestAnimationFrame(tick);
}

function tick(now) {
  if (!playing || !shown) return;
  const passed = last === null ? 0 : (now - last) / 1000;
  last = now;
  const next = instant + passed * Number(find("speed").value);
  seek(next >= Number(time.max) ? Number(time.min) : next);
  requestAnimationFrame(tick);
}

function seek(to) {
  instant = to;
  time.value = to;
  if (!shown) return;
  row.frame(to);
  for (const chart of Object.values(charts)) chart.frame(to);
  time.setAttribute("aria-valuetext", charts.displacements.words(to));
}

/** Shows a range of the histories, through which the slider and the motion go, too. */
function zoom(to) {
  range = to && to[1] - to[0] < shown.summary.method.duration_s ? to : null;
  [time.min, time.max] = range ?? [0, shown.summary.method.duration_s];
  find("whole").hidden = !range;
  showCharts(shown);
  seek(range && (instant < range[0] || instant > range[1]) ? range[0] : instant);
}

find("whole").addEventListener("click", () => { zoom(null); find("closer").focus(); });
find("closer").addEventListener("click", () => {
  const half = (time.max - time.min) / 4;
  const middle = Math.min(Math.max(instant, Number(time.min) + half), time.max - half);
  zoom([middle - half, middle + half]);
});

time.addEventListener("input", () => { play(false); seek(Number(time.value)); });
find("play").addEventListener("click", () => play(!playing));

// ---- Guides and buttons ----

function showGuide() {
  const guide = about.guides.find((one) => one.key === state.guide);
  find("guide").replaceChildren(...(guide ? [element("h2", {}, guide.title), ...guide.text.map((line) => element("p", {}, line))] : []));
  for (const link of find("guides").children) link.setAttribute("aria-current", link.dataset.key === state.guide ? "page" : "false");
  find("save").hidden = Boolean(state.guide) || !about.file;
}

function go(guide) {
  Object.assign(state, { guide, record: null, knobs: {} });
  [shown, range] = [null, null];
  showGuide();
  turned();
}

/** Does what a button asks for, and says how it went. */
function button(id, work) {
  find(id).addEventListener("click", async () => {
    try {
      find("told").textContent = "…";
      find("told").textContent = await work();
      find("fault").hidden = true;
    } catch (error) {
      if (error.status !== 409) find("told").textContent = "";
      fail(error);
    }
  });
}

button("save", async () => `Saved as ${await (await call(token, "save", state)).text()}.`);
button("python", async () => {
  const text = await (await call(token, "python", state)).text();
  await navigator.clipboard.writeText(text);
  return "Copied.";
});
button("report", async () => {
  const page = await (await call(token, "report", state)).blob();
  const link = element("a", { href: URL.createObjectURL(page), download: "report.html" });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  return "The report is in your downloads.";
});
find("reset").addEventListener("click", () => go(state.guide));
window.addEventListener("pagehide", () => { call(token, "stop", { guide: "", knobs: {} }, { keepalive: true }).catch(() => {}); });
window.addEventListener("hashchange", () => { Object.assign(state, readState()); showGuide(); turned(); });

// ---- A record from the user's disk ----

/** Records that were dropped: the last one counts, whichever is read first. */
let drops = 0;

async function shakeUnder(file) {
  try {
    if (file.size > about.record_bytes) throw new Refusal(413, `${file.name} has more than ${short(about.record_bytes / 1e6, 2)} MB: name it in the scene instead.`);
    const { guide } = state;
    const own = ++drops;
    const record = await (await call(token, "record", state, { file })).text();
    if (guide !== state.guide || own !== drops) return;
    state.record = record;
    turned();
  } catch (error) {
    fail(error);
  }
}

for (const name of ["dragover", "drop"]) {
  document.addEventListener(name, (/** @type {any} */ event) => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    if (name === "drop") shakeUnder(event.dataTransfer.files[0]);
  });
}
find("choose").addEventListener("click", () => find("file").click());
find("file").addEventListener("change", () => {
  if (find("file").files.length) shakeUnder(find("file").files[0]);
  find("file").value = "";
});

try {
  about = await (await call(token, "guides", { guide: "", knobs: {} })).json();
  const pages = [{ key: "", title: about.file ?? "Demo" }, ...about.guides];
  find("guides").append(...pages.map(({ key, title }) => element("button", { type: "button", "data-key": key, onclick: () => go(key) }, title)));
  if (!pages.some((page) => page.key === state.guide)) state.guide = "";
  showGuide();
  turned();
} catch (error) {
  fail(error);
}
