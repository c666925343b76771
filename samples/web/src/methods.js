// SPDX-License-Identifier: MIT
// The switch between methods of retargeting while a motion plays, what each leaves to be mended, and whether contacts are shown.
import { $, all } from "./elements.js";
import { sentenceOf } from "./sentences.js";

export const motionMethods = { contacts: 0, copy: 1, referencePoints: 2, stream: 3 }; // methods of handles.js

const percent = (share, digits = 0) => `${(100 * share).toFixed(digits)} %`;

// Sums over limbs of a clip: {deep: share of the arms' frames in the body, slide: share of the height per frame that standing feet
// go, touch: share of the height that hands in touch are off}; null where there is none.
export function clipFigures({ frames, limbs }, when) {
  const arms = limbs.filter(({ leg }) => !leg);
  const weighted = (list) => {
    const contacts = list.reduce((sum, limb) => sum + limb[when].contactFrames, 0);
    return contacts === 0 ? null : list.reduce((sum, limb) => sum + limb[when].contactFrames * limb[when].error, 0) / contacts;
  };
  return {
    deep: arms.length === 0 ? null : arms.reduce((sum, limb) => sum + limb[when].deepFrames, 0) / (arms.length * frames),
    slide: weighted(limbs.filter(({ leg }) => leg)),
    touch: weighted(arms),
  };
}

// Each figure as it is, and as it was copied where that is another.
export function clipText(clip) {
  const [before, after] = [clipFigures(clip, "before"), clipFigures(clip, "after")];
  const parts = [];
  const add = (label, name, digits, unit) => {
    if (after[name] === null) return;
    const [now, copied] = [percent(after[name], digits), percent(before[name] ?? 0, digits)];
    parts.push(`${label} ${now}${unit}${now === copied ? "" : ` (copied ${copied})`}`);
  };
  add("arms inside the body", "deep", 0, " of frames");
  add("standing feet slide", "slide", 2, " of the height per frame");
  add("touching hands are off by", "touch", 1, " of the height");
  return parts.length === 0 ? "" : `${parts[0][0].toUpperCase()}${parts.join("; ").slice(1)}`;
}

export class MethodPanel {
  /** @type {(...of: any[]) => any} */
  onMethod = () => {}; // MotionMethod
  /** @type {(...of: any[]) => any} */
  onInPlace = () => {}; // boolean
  /** @type {(...of: any[]) => any} */
  onArmSpread = () => {}; // degrees
  /** @type {(...of: any[]) => any} */
  onSpots = () => {};

  constructor() {
    $("motion-method").onchange = ({ target }) => this.onMethod(Number(target.value));
    $("in-place").onchange = () => this.onInPlace($("in-place").checked);
    const slider = $("arm-spread");
    slider.oninput = () => this.#sayArmSpread();
    slider.onchange = () => this.onArmSpread(Number(slider.value));
    slider.ondblclick = () => this.onArmSpread(0);
    $("show-spots").onchange = () => this.onSpots();
  }

  get spotsShown() {
    return $("show-spots").checked;
  }

  #sayArmSpread() {
    const slider = $("arm-spread");
    slider.nextElementSibling.textContent = `${slider.value}°`;
    slider.setAttribute("aria-valuetext", `${slider.value} degrees`);
  }

  // The next method.
  next() {
    if ($("motion-method").hidden) return;
    const inputs = all("#motion-method input");
    const at = inputs.findIndex(({ checked }) => checked);
    this.onMethod(Number(inputs[(at + 1) % inputs.length].value));
  }

  // motion: as MotionPlayer has it, with {own, method, inPlace, armSpread}, or null; clip: the one that plays.
  show(motion, clip) {
    $("methods").hidden = !motion;
    if (!motion) return;
    $("motion-method").hidden = motion.own; // its file's own frames are as they are
    $("in-place-choice").hidden = motion.own;
    $("in-place").checked = motion.inPlace;
    $("arm-spread-choice").hidden = motion.own;
    $("arm-spread").value = String(motion.armSpread);
    this.#sayArmSpread();
    for (const input of all("#motion-method input")) input.checked = Number(input.value) === motion.method;
    const { notes } = motion.files[motion.clips[clip].file];
    $("motion-report").textContent = [clipText(motion.clips[clip]), ...notes].filter(Boolean).map(sentenceOf).join(" ");
  }
}
