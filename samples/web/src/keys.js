// SPDX-License-Identifier: MIT
// The page's keys. Where one types or chooses, keys are the field's; on a button, a box or a line that opens, Space and Enter are theirs.

const typed = "input[type=search], input[type=text], input[type=number], select, textarea";
const pressed = "button, summary, a[href], input, select, [role=tab], [role=option]";

// Whether a key is the element's own, and none of the page's.
/** @param {Element} element @param {string} key */
export function isOwnKey(element, key) {
  if (element.matches(typed)) return true;
  if (key === " " || key === "Enter") return element.matches(pressed);
  return key.startsWith("Arrow") && element.matches("input, [role=listbox]");
}

// actions: by key, lower case; onUndo: called with whether it is redo; onEscape; onStep: with the number of a step, from 0.
/** @param {Record<string, () => any>} actions @param {{ onUndo: (forward: boolean) => any, onEscape: (event: KeyboardEvent) => any, onStep: (step: number) => any }} more */
export function listenForKeys(actions, { onUndo, onEscape, onStep }) {
  addEventListener("keydown", (event) => {
    const target = /** @type {Element} */ (event.target);
    const key = event.key.toLowerCase();
    if (document.querySelector("dialog:modal") && key !== "?" && key !== "escape") return; // what lies below it
    const typing = target.matches(typed) && !target.matches("select");
    if ((event.ctrlKey || event.metaKey) && !event.altKey && (key === "z" || key === "y") && !typing) {
      event.preventDefault();
      return onUndo(key === "y" || event.shiftKey);
    }
    if (event.key === "Escape") return onEscape(event);
    const step = /^Digit([1-5])$/.exec(event.code);
    if (step && (event.ctrlKey || event.metaKey || event.altKey)) {
      event.preventDefault();
      return onStep(Number(step[1]) - 1);
    }
    if (event.ctrlKey || event.metaKey || event.altKey || isOwnKey(target, event.key)) return;
    const action = actions[key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
