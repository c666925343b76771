// SPDX-License-Identifier: MIT
// Cards of samples: a picture, which moves while the pointer or the keyboard is on it.
import { isStill } from "./elements.js";
import { MovingPicture } from "./moving_picture.js";
import { movingOf, samples, thumbOf } from "./samples.js";

/** @type {() => void} */
let end = () => {}; // of the card that moves

/** @param {HTMLElement} card @param {string} name */
async function begin(card, name) {
  end();
  if (isStill()) return;
  let isWanted = true;
  const canvas = document.createElement("canvas");
  end = () => {
    isWanted = false;
    card.className = "";
    canvas.remove();
  };
  try {
    card.append(canvas);
    const picture = await MovingPicture.of(name, canvas), started = performance.now();
    const next = (/** @type {number} */ now) => {
      if (!isWanted) return picture.dispose();
      card.className = "moves";
      picture.draw({ seconds: (now - started) / 1e3, bones: 0 });
      requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  } catch {
    canvas.remove(); // its picture stays
  }
}

/** @param {(sample: import("./samples.js").Sample) => any} onChoose */
export function cards(onChoose) {
  return samples.filter(({ shown }) => shown).map((sample) => {
    const card = Object.assign(document.createElement("button"), { type: "button", title: `Open ${sample.name}`, onclick: () => onChoose(sample) });
    const picture = document.createElement("span");
    picture.append(Object.assign(document.createElement("img"), { src: thumbOf(sample), alt: "", loading: "lazy" }));
    card.append(picture, sample.shown ?? "");
    for (const name of ["pointerenter", "focus"]) card.addEventListener(name, () => begin(picture, movingOf(sample)));
    for (const name of ["pointerleave", "blur"]) card.addEventListener(name, () => end());
    return card;
  });
}
