// SPDX-License-Identifier: MIT
// The list of joints: a tree while nothing is searched, with each joint's colour and share of all weight.
import { $ } from "./elements.js";

function depth(joints, joint) {
  let d = 0;
  for (let j = joints[joint].parent; j >= 0; j = joints[j].parent) ++d;
  return d;
}

// Parents before children, children in the file's order.
export function treeOrder(joints) {
  const children = joints.map(() => []);
  const stack = [];
  joints.forEach(({ parent }, j) => (parent < 0 ? stack : children[parent]).push(j));
  stack.reverse();
  const order = [];
  while (stack.length > 0) {
    const j = stack.pop();
    order.push(j);
    stack.push(...children[j].reverse());
  }
  return order;
}

function shareText(share, isOff) {
  if (isOff) return "off";
  if (share === 0) return "–";
  return share < 0.001 ? "<0.1 %" : `${(share * 100).toFixed(1)} %`;
}

export class JointList {
  /** @type {(...of: any[]) => any} */
  onPick = () => {}; // joint, whether beside the chosen one
  /** @type {any} */
  #character = null;

  constructor() {
    $("joints").onclick = (event) => {
      const li = event.target.closest("li");
      if (li?.dataset.joint !== undefined) this.onPick(Number(li.dataset.joint), event.ctrlKey || event.metaKey || event.shiftKey);
    };
    $("joints").onkeydown = $("search").onkeydown = (event) => {
      const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      this.#step(by);
    };
    $("search").oninput = () => this.#character && this.#fill();
  }

  // character: with its result where it is bound; selected, also: see mark().
  show(character, selected, also) {
    this.#character = character;
    this.#fill();
    this.mark(selected, also);
  }

  // selected: the chosen joint, or -1 for all; also: a Set of those beside it.
  mark(selected, also) {
    this.selected = selected;
    this.also = also;
    for (const li of $("joints").children) li.ariaSelected = String(Number(li.dataset.joint) === selected || also.has(Number(li.dataset.joint)));
    const chosen = $(`joint-${selected}`);
    $("joints").setAttribute("aria-activedescendant", chosen?.id ?? "");
    chosen?.scrollIntoView({ block: "nearest" });
  }

  #fill() {
    const { joints } = this.#character;
    const search = $("search").value.trim();
    const wanted = search.toLowerCase();
    const items = treeOrder(joints)
      .filter((j) => joints[j].name.toLowerCase().includes(wanted))
      .map((j) => this.#item(j, wanted === "" ? Math.min(8, depth(joints, j)) : 0));
    if (wanted === "") items.unshift(item(-1, "All bones", 0, "conic-gradient(#e66,#ee6,#6c6,#6cc,#66e,#e6e,#e66)"));
    if (items.length === 0) items.push(Object.assign(document.createElement("li"), { className: "none", textContent: `No bone is called “${search}”` }));
    $("joints").replaceChildren(...items);
    if (this.also) this.mark(this.selected, this.also);
  }

  #item(joint, indent) {
    const { joints, result, vertices, source } = this.#character;
    const { name, colour } = joints[joint];
    const li = item(joint, name, indent, `rgb(${colour.join(" ")})`);
    if (!result) return li;
    const share = result.jointWeights[joint] / vertices;
    const isOff = result.off.includes(joint);
    li.classList.toggle("unused", share === 0);
    li.classList.toggle("off", isOff);
    li.classList.toggle("locked", Boolean(source.locked?.has(name)));
    li.append(Object.assign(document.createElement("span"), { className: "share", textContent: shareText(share, isOff), title: "share of all weight" }));
    return li;
  }

  #step(by) {
    const shown = [...$("joints").children].filter((li) => li.dataset.joint !== undefined).map((li) => Number(li.dataset.joint));
    if (shown.length === 0) return;
    const at = shown.indexOf(this.selected);
    this.onPick(shown[Math.min(shown.length - 1, Math.max(0, at < 0 ? 0 : at + by))], false);
  }
}

function item(joint, name, indent, background) {
  const li = document.createElement("li");
  li.role = "option";
  li.id = `joint-${joint}`;
  li.dataset.joint = joint;
  li.title = name;
  li.style.paddingLeft = `${6 + indent * 9}px`;
  const swatch = document.createElement("i");
  swatch.style.background = background;
  li.append(swatch, Object.assign(document.createElement("span"), { className: "name", textContent: name }));
  return li;
}
