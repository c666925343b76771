// SPDX-License-Identifier: MIT
// What swings on the character behind its motions: chains of hair, tails, ears and skirts, each with a switch, and how stiff they are, how much they are
// damped and how heavy. What was chosen is the character's source.springs, null where nobody said anything: a file's own springs play then, found ones do not.
import { $, at, engine } from "./state.js";

/** @typedef {import("./types.js").Springs} Springs */
/** @typedef {{ name: string, kind: string, kept: boolean, certainty: number, own: boolean }} Chain */

/** @type {Springs} */
const unsaid = { on: false, switched: {}, stiffness: 1, drag: 1, gravity: 1 };
/** @type {("stiffness" | "drag" | "gravity")[]} */
const factors = ["stiffness", "drag", "gravity"];

// As sinew springs has it: --take, --drop and --value of it.
/** @param {Springs | null | undefined} springs @returns {import("./types.js").SpringWish} */
export function springWish(springs) {
  const { switched, ...numbers } = springs ?? unsaid;
  const chains = (/** @type {boolean} */ on) => Object.keys(switched).filter((name) => switched[name] === on);
  return { take: chains(true), drop: chains(false), values: factors.filter((name) => numbers[name] !== 1).map((name) => `*:${name}=x${numbers[name]}`) };
}

export class SpringPanel {
  /** @type {(name: string, change: () => Promise<void>) => any} */
  onChange = () => {}; // a step of the history
  /** @type {(...of: any[]) => any} */
  onSlide = () => {}; // the number changes, and will change more
  /** @type {(...of: any[]) => any} */
  onSlid = () => {};
  /** @type {Chain[]} */
  #chains = [];
  /** @type {import("./types.js").BindResult | null} */
  #of = null; // that they were found on
  /** @type {Springs | null} */
  #by = null; // and what was chosen then

  constructor() {
    $("springs-on").onchange = () => this.onChange(this.#wanted ? "springs off" : "springs on", () => this.set({ on: !this.#wanted }));
    $("spring-chains").onchange = (/** @type {any} */ { target }) => {
      const { name } = this.#chains[Number(target.dataset.chain)];
      this.onChange(`${name} ${target.checked ? "swings" : "does not swing"}`, () => this.set({ switched: { ...this.#chosen.switched, [name]: target.checked } }));
    };
    for (const name of factors) {
      const slider = $(`spring-${name}`);
      const slid = (/** @type {number} */ value) => {
        at.character.source.springs = { ...this.#chosen, [name]: value };
        this.#show();
      };
      slider.oninput = () => (slid(Number(slider.value)), this.onSlide());
      slider.onchange = () => this.onSlid(`${name} of springs`);
      slider.ondblclick = () => (slid(1), this.onSlide(), this.onSlid(`${name} of springs`));
    }
  }

  get #chosen() {
    return at.character?.source.springs ?? { ...unsaid, on: this.#chains.some(({ own }) => own) };
  }
  get #wanted() {
    return this.#chosen.on && this.#chains.length > 0;
  }
  // Whether something swings.
  get on() {
    return this.#of !== null && this.#of === at.character?.result && this.#wanted && this.#chains.some(({ kept }) => kept);
  }
  // What files are written with; null: what the character's own file has, or has not.
  get written() {
    const said = at.character.source.springs;
    if (said ? said.on : this.on) return springWish(said);
    return said && this.#chains.length > 0 ? { take: [], drop: ["*"], values: [] } : null;
  }

  /** @param {Partial<Springs>} change */
  async set(change) {
    at.character.source.springs = { ...this.#chosen, ...change };
    await this.again();
  }

  // Looks for them where that was not done for this bind and these wishes: in the step Motion, where something plays, and where the user said something.
  async again() {
    const { character } = at;
    const springs = character?.source.springs ?? null;
    const isAsked = Boolean(character?.result) && (at.step === "motion" || Boolean(at.player.motion) || springs !== null);
    if (!isAsked) return this.#found([], null, null);
    if (this.#of === character.result && this.#by === springs) return this.#show();
    const { chains } = await engine.call("springs", { wish: springWish(springs) });
    return this.#found(chains, character.result, springs);
  }

  /** @param {Chain[]} chains @param {import("./types.js").BindResult | null} of @param {Springs | null} by */
  #found(chains, of, by) {
    this.#chains = chains;
    this.#of = of;
    this.#by = by;
    this.#show();
  }

  #show() {
    const swinging = this.on ? this.#chains.filter(({ kept }) => kept).length : 0;
    $("springs-said").textContent = this.#chains.length === 0 ? "nothing swings" : swinging === 0 ? "off" : `${swinging} swing${swinging === 1 ? "s" : ""}`;
    $("springs-none").hidden = this.#chains.length > 0;
    $("springs-some").hidden = this.#chains.length === 0;
    $("springs-on").checked = this.#wanted;
    for (const name of factors) {
      const slider = $(`spring-${name}`), value = this.#chosen[name];
      slider.disabled = !this.#wanted;
      slider.value = String(value);
      slider.nextElementSibling.textContent = `${value} ×`;
      slider.setAttribute("aria-valuetext", `${value} times the value that was found`);
    }
    $("shake").disabled = $("bake-springs-field").hidden = !this.on;
    const list = $("spring-chains");
    if (list.childElementCount !== this.#chains.length || this.#chains.some(({ name }, c) => list.children[c].title !== name)) list.replaceChildren(...this.#chains.map(row));
    this.#chains.forEach(({ kept }, c) => {
      const box = list.children[c].querySelector("input");
      box.checked = kept;
      box.disabled = !this.#wanted;
    });
    at.drag.show();
  }
}

/** @param {Chain} chain @param {number} number */
function row({ name, kind, own, certainty }, number) {
  const li = document.createElement("li");
  li.title = name;
  const label = Object.assign(document.createElement("label"), { className: "check" });
  const box = Object.assign(document.createElement("input"), { type: "checkbox" });
  box.dataset.chain = String(number);
  label.append(box, Object.assign(document.createElement("span"), { className: "name", textContent: name }), Object.assign(document.createElement("span"), { className: "share", textContent: own ? `${kind}, from the file` : `${kind}, ${Math.round(100 * certainty)} % sure` }));
  li.append(label);
  return li;
}
