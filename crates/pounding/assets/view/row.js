// The row to scale: heights in one scale, displacements and gaps in another that is a round number of times as large.

import { at, svg } from "./draw.js";

const WIDE = 84;
const TALL = 200;
const MARGIN = 46;
const ABOVE = 30;
const BELOW = 40;
/** Largest displacement and widest gap in the picture. */
const SWAY = 44;
const OPEN = 70;
/** How far a link reaches into a structure, and how far below its floor it is drawn. */
const HELD = 14;
const UNDER = 8;
const TIMES = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
/** How long a flash stays after floors part [s]. */
const GLOW = 0.35;

export class Row {
  /** @param {HTMLElement} place @param {HTMLElement} caption */
  constructor(place, caption) {
    this.place = place;
    this.caption = caption;
  }

  /** Takes a run, the gaps of its contacts [m] and the direction of shaking in words. */
  show(player, gaps, direction) {
    this.player = player;
    const moving = player.floors.filter((floor) => !floor.is_wall);
    const up = TALL / Math.max(...moving.map((floor) => floor.elevation_m));
    const largest = moving.reduce((most, floor) => floor.displacement_um.reduce((far, one) => Math.max(far, Math.abs(one)), most), 1) * 1e-6;
    const widest = Math.max(0, ...gaps);
    const fits = Math.min(SWAY / largest, widest > 0 ? OPEN / widest : Infinity) / up;
    this.times = TIMES.filter((times) => times <= fits).pop() ?? 1;
    this.across = this.times * up;
    this.lefts = [MARGIN];
    for (let one = 1; one < player.structures.length; one += 1) {
      this.lefts.push(this.lefts[one - 1] + WIDE + this.across * (gaps[one - 1] ?? 0.05));
    }
    this.height = (floor) => ABOVE + TALL - up * floor.elevation_m;
    this.build();
    this.caption.textContent = `Displacements and gaps are drawn ${this.times === 1 ? "in the scale of" : `${this.times} times as large as`} heights. A flash grows with the impulse.${player.links.length ? " Blue lines are links." : ""} Shaken ${direction}; the answer has both directions.${player.left_out ? ` ${player.left_out} more collisions are not drawn.` : ""}`;
  }

  build() {
    const { player, lefts } = this;
    const width = lefts.at(-1) + WIDE + MARGIN;
    const ground = ABOVE + TALL;
    const tops = player.structures.map((_, one) => Math.min(...player.floors.filter((floor) => floor.structure === one).map(this.height)));
    const walls = new Set(player.floors.filter((floor) => floor.is_wall).map((floor) => floor.structure));
    const drawnWalls = [...walls].map((one) => svg("rect", { class: "wall", x: lefts[one], y: tops[one], width: WIDE, height: ground - tops[one] }));
    this.storeys = [];
    const below = new Map();
    player.floors.forEach((floor, index) => {
      if (floor.is_wall) return;
      const shape = svg("path", { class: "storey" });
      const slab = svg("path", { class: "slab" });
      this.storeys.push({ index, shape, slab, below: below.get(floor.structure) });
      below.set(floor.structure, index);
    });
    this.links = player.links.map((ends) => ({ ends, line: svg("path", { class: "link" }) }));
    this.flashes = player.pairs.map(() => svg("circle", { class: "flash", r: 0 }));
    const names = player.structures.map((name, one) => svg("text", { x: lefts[one] + WIDE / 2, y: ground + 18, class: "name" }, name.length > 15 ? `${name.slice(0, 14)}…` : name));
    this.clock = svg("text", { x: width / 2, y: ground + 35, class: "clock" });
    const drawn = svg(
      "svg",
      { viewBox: `0 0 ${width} ${ground + BELOW}`, role: "img", "aria-label": `The row: ${player.structures.join(", ")}` },
      ...drawnWalls,
      ...this.storeys.flatMap(({ shape, slab }) => [shape, slab]),
      svg("path", { class: "ground", d: `M0 ${ground}H${width}` }),
      ...this.links.map(({ line }) => line),
      ...this.flashes,
      ...names,
      this.clock,
    );
    drawn.style.maxWidth = `${2.1 * width}px`;
    this.place.replaceChildren(drawn);
    this.hardest = Math.max(...player.collisions.map((one) => one.impulse_n_s), 1e-9);
  }

  /** Draws an instant. */
  frame(time) {
    const { player, across, lefts } = this;
    const place = time / player.interval_s;
    const moved = player.floors.map((floor) => across * 1e-6 * at(floor.displacement_um, place));
    for (const { index, shape, slab, below } of this.storeys) {
      const floor = player.floors[index];
      const left = lefts[floor.structure];
      const foot = below === undefined ? 0 : moved[below];
      const low = below === undefined ? ABOVE + TALL : this.height(player.floors[below]);
      const top = this.height(floor);
      const x = (side, by) => (left + side * WIDE + by).toFixed(2);
      shape.setAttribute("d", `M${x(0, foot)} ${low}H${x(1, foot)}L${x(1, moved[index])} ${top}H${x(0, moved[index])}Z`);
      slab.setAttribute("d", `M${x(0, moved[index])} ${top}H${x(1, moved[index])}`);
    }
    for (const { ends: [one, other], line } of this.links) {
      const isInside = one.structure === other.structure;
      const end = (own, atRight) => {
        const x = lefts[own.structure] + (atRight ? WIDE - HELD : HELD) + (moved[own.floor] ?? 0);
        return `${x.toFixed(2)} ${this.height(own) + (own.elevation_m > 0 ? UNDER : 0)}`;
      };
      line.setAttribute("d", `M${end(one, !isInside)}L${end(other, isInside)}`);
    }
    this.flash(time, moved);
    this.clock.textContent = `${time.toFixed(2)} s`;
  }

  flash(time, moved) {
    const { player } = this;
    const lit = new Map();
    for (const one of player.collisions) {
      if (one.start_s > time) break;
      const glow = time <= one.end_s ? 1 : 1 - (time - one.end_s) / GLOW;
      const strength = glow * Math.sqrt(one.impulse_n_s / this.hardest);
      if (glow > 0 && strength > (lit.get(one.pair) ?? 0)) lit.set(one.pair, strength);
    }
    this.flashes.forEach((flash, pair) => {
      const { floor, at_right: right } = player.pairs[pair];
      const strength = lit.get(pair) ?? 0;
      flash.setAttribute("cx", this.lefts[player.floors[floor].structure] + (right ? WIDE : 0) + moved[floor]);
      flash.setAttribute("cy", this.height(player.floors[floor]));
      flash.setAttribute("r", strength > 0 ? (4 + 15 * strength).toFixed(1) : 0);
      flash.setAttribute("opacity", (0.25 + 0.7 * strength).toFixed(2));
    });
  }
}

/** The gaps of a run as the server tells them [m]. */
export function gapsOf(summary) {
  return (summary.scene.contacts ?? []).map((contact) => contact.gap_m);
}
