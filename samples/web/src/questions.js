// SPDX-License-Identifier: MIT
// The list of doubtful parts: questions with their alternatives, and the answers that were taken. It says what the
// pointer, else the keyboard, is on; the page shows that on the mesh.

export const kinds = { proposed: 0, rigid: 1 }; // of sinew_answer_kind, those that the page itself makes
const meanings = {
  proposed: "Keeps the weights as they are and closes the question",
  rigid: "The whole part moves with this bone",
  soft: "Blends over a wide area",
  hard: "Each vertex follows only its strongest bone",
  softer: "As it is, blended twice as softly",
  host: "Moves like the surface below it: a badge on a coat",
};
const words = { proposed: "keep as it is", soft: "swing", hard: "in pieces", softer: "softer", host: "with the surface below" };
const percent = (share) => `${Math.round(100 * share)} %`;

// What an answer means, in the page's words: follow chest, swing.
export const answerText = (answer) => (answer.startsWith("rigid:") ? `follow ${answer.slice(6)}` : (words[answer] ?? answer));
// What a part is called: by its mesh in the file, else by what it is near.
export const partName = ({ mesh, joint, parts }) => `${mesh || (parts > 1 ? "parts" : "part")} near ${joint}`;
const nowText = ({ share, joint }) => `now ${share > 0.995 ? "" : `${percent(share)} `}with ${joint}`;
export function questionText(question) {
  const alike = question.parts > 1 ? ` · ${question.parts} similar` : "";
  return `${partName(question)}${alike} · ${nowText(question)}`;
}

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}
const button = (className, text, properties) => element("button", { type: "button", className, ...properties }, text);

export class Questions {
  /** @type {(...of: any[]) => any} */
  onLook = () => {}; // null, a question: {question}, an alternative: {question, kind, joint, answer}, or what was taken
  /** @type {(...of: any[]) => any} */
  onTake = () => {}; // {question, kind, joint, answer}
  /** @type {(...of: any[]) => any} */
  onTakeBack = () => {}; // what was taken
  /** @type {(...of: any[]) => any} */
  pictureOf = () => null; // of a question: an image's address

  #host;
  #joints = [];
  #hovered = null;
  #tapped = null; // an answer that a finger was on
  #focused = null; // of the two the later one counts

  constructor(host) {
    this.#host = host;
    host.closest("details").addEventListener("toggle", () => this.#fillPictures());
    const lookOf = (target) => {
      for (let at = target; at && at !== host; at = at.parentElement) if (at.look) return at.look;
      return null;
    };
    // Moves alone: a list that changes under a pointer that lies still is no wish of the user's.
    host.addEventListener("pointermove", ({ target }) => this.#hover(lookOf(target)));
    host.addEventListener("pointerleave", () => this.#hover(null));
    host.addEventListener("focusin", ({ target }) => this.#focus(lookOf(target)));
    host.addEventListener("focusout", () => this.#focus(null));
    host.addEventListener("keydown", (event) => this.#key(event));
  }

  // questions: as the engine lists them. answers: {question, answer, byStyle}, in the order taken. focus: of a part,
  // where the keyboard goes: it was on something that is gone.
  show({ questions, answers, joints, focus }) {
    this.#joints = joints;
    this.#hovered = this.#focused = null;
    const taken = answers.map((answer) => this.#answered(answer));
    const asked = questions.map((question) => this.#question(question));
    const none = element("li", { className: "none" }, "No questions");
    this.#host.replaceChildren(...taken, ...asked, ...(asked.length === 0 ? [none] : []));
    this.#fillPictures();
    if (focus === undefined) return;
    (this.#host.querySelector(`[data-part="${focus}"] button`) ?? this.#host.querySelector("button"))?.focus();
  }

  // The first one with its alternatives, for the keyboard.
  openFirst() {
    const head = this.#host.querySelector(".question");
    if (!head) return;
    this.#open(head, true);
    head.focus();
  }

  // Pictures are made when they are looked at.
  #fillPictures() {
    if (!this.#host.closest("details").open) return;
    for (const picture of this.#host.querySelectorAll(".question img:not([src])")) {
      const made = this.pictureOf(picture.closest(".question").look.question);
      if (made) picture.src = made;
      else picture.remove();
    }
  }

  // Closes the open question; false where none is.
  close() {
    const open = this.#host.querySelector("[aria-expanded=true]");
    if (!open) return false;
    this.#open(open, false);
    open.focus();
    return true;
  }

  #hover(look) {
    if (look === this.#hovered) return;
    this.#hovered = look;
    this.onLook(look ?? this.#focused);
  }

  #focus(look) {
    this.#focused = look;
    this.onLook(look ?? this.#hovered);
  }

  // Up and down go from button to button, as they do in the list of joints.
  #key(event) {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by === undefined || event.target.tagName === "SELECT") return;
    event.preventDefault();
    const stops = [...this.#host.querySelectorAll("button, select")].filter((at) => !at.disabled);
    const next = stops[stops.indexOf(event.target) + by];
    next?.focus();
    next?.scrollIntoView({ block: "nearest" });
  }

  #answered(answer) {
    const name = partName(answer.question);
    const by = answer.byStyle ? " · from style" : "";
    const back = button("back", "Take back", { ariaLabel: `Take back ${name}: ${answerText(answer.answer)}`, onclick: () => this.onTakeBack(answer) });
    const item = element("li", { className: "answered", look: answer, title: questionText(answer.question) });
    item.append(element("span", { className: "name" }, `${name} · ${answerText(answer.answer)}${by}`), back);
    item.dataset.part = answer.question.part;
    return item;
  }

  #question(question) {
    const now = nowText(question);
    const head = button("question", "", { ariaExpanded: "false", look: { question }, title: `${question.vertices} vertices; part ${question.part} of sinew bind --questions` });
    head.append(element("img", { alt: "", width: 72, height: 54 }), element("span", {}, questionText(question).slice(0, -now.length), element("span", { className: "now" }, now)));
    head.onclick = () => this.#open(head, head.ariaExpanded !== "true");
    const item = element("li", {}, head);
    item.dataset.part = question.part;
    return item;
  }

  #open(head, open) {
    for (const other of this.#host.querySelectorAll("[aria-expanded=true]")) {
      other.ariaExpanded = "false";
      other.nextElementSibling.remove();
    }
    if (!open) return;
    head.ariaExpanded = "true";
    head.after(this.#alternatives(head.look.question));
    head.nextElementSibling.scrollIntoView({ block: "nearest" });
  }

  // A finger cannot point without a tap: the first one shows what the answer changes, the second takes it.
  #take(look, { pointerType }) {
    if (pointerType === "touch" && this.#tapped !== look) {
      this.#tapped = look;
      return this.#focus(look);
    }
    this.onTake(look);
  }

  #alternatives(question) {
    const list = element("div", { className: "alternatives", role: "group", ariaLabel: `How does ${partName(question)} move?` });
    const add = (text, look, share) => {
      const one = button("alternative", answerText(text), { look, title: meanings[look.answer.split(":")[0]], onclick: (event) => this.#take(look, event) });
      if (share !== undefined) one.append(element("span", { className: "share", title: "of the part's weight moves to another bone" }, percent(share)));
      list.append(one);
    };
    for (const { answer, kind, joint, change } of question.alternatives) add(answer, { question, answer, kind, joint }, change / 2);
    add("proposed", { question, answer: "proposed", kind: kinds.proposed, joint: 0 });
    list.append(this.#anyJoint(question));
    return list;
  }

  // Keys step through the joints, so that it is the button beside them that takes one.
  #anyJoint(question) {
    const choice = element("select", { ariaLabel: `Bone that ${partName(question)} follows` });
    choice.append(new Option("follow another bone…", ""), ...this.#joints.map(({ name }, j) => new Option(name, String(j))));
    const take = button("take", "Take", { disabled: true, title: meanings.rigid });
    const row = element("div", { className: "any" }, choice, take);
    choice.onchange = () => {
      take.disabled = choice.value === "";
      const joint = Number(choice.value);
      row.look = take.disabled ? null : { question, answer: `rigid:${this.#joints[joint].name}`, kind: kinds.rigid, joint };
      this.#focus(row.look);
    };
    take.onclick = () => this.onTake(row.look);
    return row;
  }
}
