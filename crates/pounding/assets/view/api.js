// The token, the state in the address, and calls of the server. The server checks every value again.

const KEY = "pounding-token";

/** The token comes behind `#` in the address that the program prints. It leaves the address at once: an address that is copied has the state alone. */
export function takeToken() {
  const given = new URLSearchParams(location.hash.slice(1));
  const token = given.get("token");
  if (token) {
    given.delete("token");
    try { localStorage.setItem(KEY, token); } catch { /* A browser that keeps nothing: this window has it. */ }
    setAddress(given);
    return token;
  }
  try { return localStorage.getItem(KEY) ?? ""; } catch { return ""; }
}

/** @returns {{guide: string, record: string|null, knobs: Object<string, number|string|null>}} The record is the key of a dropped one. */
export function readState() {
  const given = new URLSearchParams(location.hash.slice(1));
  const guide = given.get("guide") ?? "";
  const record = given.get("record");
  /** @type {Object<string, number|string|null>} */
  const knobs = {};
  for (const [id, text] of given) {
    if (["guide", "record", "token"].includes(id)) continue;
    knobs[id] = text === "none" ? null : /^-?[\d.]+(e[-+]?\d+)?$/i.test(text) && !WORDS.test(id) ? Number(text) : text;
  }
  return { guide, record, knobs };
}

/** Knobs whose values are words, also where they look like numbers. */
const WORDS = /^(law|direction|method|step)\b/;

export function writeState({ guide, record, knobs }) {
  const state = new URLSearchParams();
  if (guide) state.set("guide", guide);
  if (record) state.set("record", record);
  for (const [id, value] of Object.entries(knobs)) state.set(id, value === null ? "none" : String(value));
  setAddress(state);
}

function setAddress(state) {
  const text = String(state);
  history.replaceState(null, "", text ? `#${text}` : location.pathname);
}

/** A refusal of the server, in its words. */
export class Refusal extends Error {
  constructor(status, words) {
    super(words);
    this.status = status;
  }
}

const drawn = crypto.getRandomValues(new Uint32Array(1))[0];

/**
 * Calls the server with the state; `signal` gives up waiting, `keepalive` outlives the page, `file` is a record.
 * @param {string} token
 * @param {string} name
 * @param {{guide: string, knobs: object, record?: string|null}} state
 * @param {{signal?: AbortSignal, keepalive?: boolean, file?: File}} more
 */
export async function call(token, name, { guide, knobs, record = null }, { signal, keepalive, file } = {}) {
  const state = JSON.stringify({ window: drawn, guide, knobs, record: file ? file.name : record });
  const body = file ? new Blob([state, "\n", file]) : state;
  const answer = await fetch(`/api/${name}`, { method: "POST", headers: { "X-Pounding-Token": token }, body, signal, keepalive });
  if (!answer.ok) throw new Refusal(answer.status, await answer.text());
  return answer;
}

/** Runs states one after the other; of those that come meanwhile only the latest runs, and stops a run that takes long. */
export class Runner {
  /**
   * @param {(state: object, signal: AbortSignal) => Promise<void>} run
   * @param {(busy: boolean) => void} tell
   */
  constructor(run, tell) {
    this.run = run;
    this.tell = tell;
    this.next = null;
    this.running = null;
  }

  ask(state) {
    this.next = state;
    if (!this.running) this.go();
    else setTimeout((run) => run.abort(), Math.max(0, this.since + PATIENCE - performance.now()), this.running);
  }

  async go() {
    while (this.next) {
      const state = this.next;
      this.next = null;
      this.running = new AbortController();
      this.since = performance.now();
      this.tell(true);
      await this.run(state, this.running.signal);
    }
    this.running = null;
    this.tell(false);
  }
}

/** How long a run may take before a later one stops it [ms]: shorter ones are shown, so that the picture follows the hand. */
const PATIENCE = 1000;
