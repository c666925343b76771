// SPDX-License-Identifier: MIT
// The first page: a character that gets bones and colors and walks, in a picture that needs neither three.js nor the engine. The page itself is fetched once that picture moves.
import { $, isStill } from "./elements.js";
import { MovingPicture } from "./moving_picture.js";
import { movingOf, samples } from "./samples.js";

const cycle = 15; // seconds
const share = (/** @type {number} */ from, /** @type {number} */ seconds, /** @type {number} */ now) => Math.min(1, Math.max(0, (now - from) / seconds));

// What the picture shows at a time of the cycle: bones grow, colors rise, it walks, and all of it goes again.
/** @param {number} now */
export function sceneAt(now) {
  const time = now % cycle, stays = 1 - share(cycle - 0.8, 0.8, time);
  return {
    grown: share(0.8, 1.8, time) * stays,
    swept: share(2.7, 1.4, time) * stays,
    moved: share(4.2, 0.5, time) * (1 - share(cycle - 1.3, 0.5, time)),
    bones: 1 - 0.7 * share(4, 0.6, time),
    seconds: Math.max(0, time - 4.2),
    turn: 0.25 * Math.sin((2 * Math.PI * time) / cycle),
  };
}

/** @param {HTMLCanvasElement} canvas @param {HTMLButtonElement} button pauses it */
async function play(canvas, button) {
  const picture = await MovingPicture.of(movingOf(samples[0]), canvas);
  let seconds = 0, last = 0, isPaused = isStill(), isRunning = false, frames = 0;
  const draw = () => picture.draw(isPaused && seconds === 0 ? { seconds: 0.25 * picture.seconds, bones: 0.3 } : sceneAt(seconds));
  const next = (/** @type {number} */ now) => {
    isRunning = document.body.classList.contains("start") && !isPaused;
    if (!isRunning) return;
    seconds += Math.min(0.1, (now - last) / 1e3);
    last = now;
    draw();
    if (++frames === 2) performance.mark("first picture that moves");
    requestAnimationFrame(next);
  };
  const go = () => {
    button.ariaPressed = String(isPaused);
    if (isRunning || isPaused) return draw();
    isRunning = true;
    last = performance.now();
    requestAnimationFrame(next);
  };
  button.hidden = false;
  button.onclick = () => ((isPaused = !isPaused), go());
  new ResizeObserver(() => document.body.classList.contains("start") && draw()).observe(canvas);
  new MutationObserver(go).observe(document.body, { attributeFilter: ["class"] });
  go();
  await new Promise((resolve) => setTimeout(resolve, 50)); // two frames
}

await play($("hero"), $("hero-pause")).catch(() => ($("hero").hidden = true)); // no WebGL 2, no network: the page says itself what it lacks
await import("./main.js");
