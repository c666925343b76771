// SPDX-License-Identifier: MIT
// The page's keys. Where one types or chooses, keys are the field's.

// actions: by key, lower case; onUndo: called with whether it is redo; onEscape.
export function listenForKeys(actions, { onUndo, onEscape }) {
  addEventListener("keydown", (event) => {
    const typing = event.target.matches("input[type=search], input[type=text], input[type=number], select");
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && !typing) {
      event.preventDefault();
      return onUndo(event.shiftKey);
    }
    if (event.key === "Escape") return onEscape();
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const action = actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
