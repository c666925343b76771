// SPDX-License-Identifier: MIT
// Motions to try, each a button with a tick, and the list of clips that the character has: all of them are exported.
import { shipped } from "./builtin_clips.js";
import { $ } from "./elements.js";

// builtin:person/walk is a walk too.
const isClip = (file, name) => file === `builtin:${name}` || (file.startsWith("builtin:") && file.endsWith(`/${name}`));
export const clipName = (file) => file.replace(/^builtin:/, "");

export class ClipList {
  /** @type {(...of: any[]) => any} */
  onTry = () => {}; // name, its file, whether it is wanted
  /** @type {(...of: any[]) => any} */
  onPlay = () => {}; // number of a clip
  /** @type {(...of: any[]) => any} */
  onRemove = () => {}; // file

  constructor() {
    $("clip-grid").append(
      ...shipped.map((name) => {
        const button = Object.assign(document.createElement("button"), { type: "button", ariaPressed: "false" });
        button.append(Object.assign(document.createElement("span"), { className: "picture" }), name[0].toUpperCase() + name.slice(1)); // see clip_pictures.js
        button.dataset.clip = name;
        button.onclick = () => this.onTry(name, button.dataset.file, button.ariaPressed !== "true");
        return button;
      }),
    );
    $("clip-search").oninput = () => {
      const wanted = $("clip-search").value.trim().toLowerCase();
      for (const button of $("clip-grid").children) button.hidden = !button.dataset.clip.includes(wanted);
    };
    $("clips").onclick = ({ target }) => {
      const { file, clip } = target.closest("li")?.dataset ?? {};
      if (target.closest(".remove")) this.onRemove(file);
      else if (target.closest("button")) this.onPlay(Number(clip));
    };
  }

  // motion: as MotionPlayer has it, or null; clip: the one that plays; enabled: the character is bound.
  show(motion, clip, enabled) {
    const files = motion?.files.map(({ file }) => file) ?? [];
    for (const button of $("clip-grid").children) {
      button.disabled = !enabled;
      const there = files.find((file) => isClip(file, button.dataset.clip));
      button.dataset.file = there ?? `builtin:${button.dataset.clip}`;
      button.ariaPressed = String(there !== undefined);
    }
    $("clips").hidden = !motion;
    $("clips").replaceChildren(...(motion?.clips ?? []).map((one, c) => row(one, c, clipName(files[one.file]), files[one.file], c === clip, motion.own)));
  }
}

function row({ name, seconds, file }, number, from, path, now, isOwn) {
  const li = document.createElement("li");
  li.dataset.clip = number;
  li.dataset.file = path;
  const play = Object.assign(document.createElement("button"), { type: "button", ariaPressed: String(now), title: `${name || "clip"}, of ${from}` });
  play.append(Object.assign(document.createElement("span"), { className: "name", textContent: name || `clip ${file + 1}` }), Object.assign(document.createElement("span"), { className: "share", textContent: `${seconds.toFixed(1)} s` }));
  const remove = Object.assign(document.createElement("button"), { type: "button", className: "remove", textContent: "×", ariaLabel: `Remove ${from}`, title: `Remove ${from}`, hidden: isOwn });
  li.append(play, remove);
  return li;
}
