// SPDX-License-Identifier: MIT
// The engine in a worker. A worker's script is two lines, so that every bundler finds it as it finds any other worker:
//   import { serve } from "@sinew/skin/worker";
//   serve();
// and the page has connect(new Worker(new URL("./skin-worker.js", import.meta.url), { type: "module" })). The same works
// with node's worker_threads.
import { ownPort } from "#host";
import { load } from "./index.js";
import { SinewError } from "./memory.js";

// Calls that may be sent, and those whose result stays in the worker and is known by a number.
const CALLS = ["bind", "rig", "map", "chooseJoints", "jointClasses", "pose", "transfer", "simplify"];
const MAKES = { openModel: ["free"], deformer: ["pose", "free"], retarget: ["clip", "free"] };
const KEPT = "sinewKept";

const buffersOf = (value) => {
  const found = new Set();
  const look = (one) => {
    if (ArrayBuffer.isView(one)) found.add(one.buffer);
    else if (Array.isArray(one)) one.forEach(look);
    else if (one && typeof one === "object") Object.values(one).forEach(look);
  };
  look(value);
  return [...found].filter((buffer) => buffer instanceof ArrayBuffer);
};

// Messages of browsers come wrapped, those of node do not.
const listen = (port, take) => {
  if (typeof port.on === "function") port.on("message", take);
  else port.addEventListener("message", (event) => take(event.data));
};

/** In a worker's script: answers the calls of connect(). */
export function serve() {
  let skin;
  let last = 0;
  const kept = new Map();
  // Arguments may name what was kept.
  const resolve = (value) => {
    if (value == null || typeof value !== "object" || ArrayBuffer.isView(value) || value instanceof ArrayBuffer) return value;
    if (Array.isArray(value)) return value.map(resolve);
    if (KEPT in value) return kept.get(value[KEPT]);
    return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, resolve(one)]));
  };
  /** @type {any} */
  const port = ownPort();
  if (!port) throw new Error("serve() belongs into a worker's script; call load() of @sinew/skin elsewhere");
  const take = async ({ id, call, on, args, wantsProgress }) => {
    try {
      const values = resolve(args);
      let result;
      if (call === "load") {
        skin = await load(values[0]);
        result = { version: skin.version, kernel: skin.kernel };
      } else if (on !== undefined) {
        result = kept.get(on)[call](...values);
        if (call === "free") kept.delete(on);
      } else if (CALLS.includes(call)) {
        const options = values.at(-1);
        if (wantsProgress) options.onProgress = (share) => void port.postMessage({ id, progress: share }); // node says true, which would stop the call
        result = skin[call](...values);
      } else {
        const made = skin[call](...values);
        kept.set(++last, made);
        const told = Object.entries(made).filter(([, value]) => typeof value !== "function");
        result = { [KEPT]: last, ...Object.fromEntries(told) };
      }
      port.postMessage({ id, result }, buffersOf(result));
    } catch (error) {
      port.postMessage({ id, error: { message: String(error?.message ?? error), status: error?.status ?? 0 } });
    }
  };
  listen(port, take);
}

/**
 * Starts the engine in a worker whose script calls serve().
 * @param {Worker} worker of a browser or of node's worker_threads
 * @param {object} options as load() has them
 * @returns {Promise<import("./worker.js").RemoteSkin>}
 */
export async function connect(worker, options = {}) {
  const waiting = new Map();
  let last = 0, closed = null;
  const fail = (message) => {
    closed = new SinewError(message);
    for (const { reject } of waiting.values()) reject(closed);
    waiting.clear();
  };
  listen(worker, ({ id, result, error, progress }) => {
    const call = waiting.get(id);
    if (!call) return;
    if (progress !== undefined) return void call.onProgress?.(progress);
    waiting.delete(id);
    if (error) call.reject(new SinewError(error.message, error.status));
    else call.resolve(result);
  });
  /** @param {any} event */
  const broken = (event) => fail(`the worker stopped: ${event.message ?? event}`);
  if ("on" in worker && typeof worker.on === "function") worker.on("error", broken);
  else worker.addEventListener("error", broken);

  const plain = (value) => {
    if (value == null || typeof value !== "object" || ArrayBuffer.isView(value) || value instanceof ArrayBuffer) return value;
    if (value instanceof WebAssembly.Module) return value;
    if (value instanceof URL) return value.href;
    if (Array.isArray(value)) return value.map(plain);
    if (value[KEPT] !== undefined) return { [KEPT]: value[KEPT] };
    return Object.fromEntries(Object.entries(value).filter(([, one]) => typeof one !== "function").map(([name, one]) => [name, plain(one)]));
  };
  const send = (call, args, on) =>
    new Promise((resolve, reject) => {
      if (closed) return reject(closed);
      const onProgress = args.at(-1)?.onProgress;
      const id = ++last;
      waiting.set(id, { resolve, reject, onProgress });
      try {
        worker.postMessage({ id, call, on, args: plain(args), wantsProgress: typeof onProgress === "function" });
      } catch (error) {
        waiting.delete(id);
        reject(error);
      }
    });
  const { model, ...rest } = options;
  const skin = { ...(await send("load", [rest])), model: null };
  for (const call of CALLS)
    skin[call] = (...args) => {
      if (call === "bind" || call === "transfer") args = withModel(args, call === "bind" ? 2 : 3, skin.model);
      return send(call, args);
    };
  for (const [make, methods] of Object.entries(MAKES))
    skin[make] = async (...args) => {
      const made = await send(make, args);
      for (const method of methods) made[method] = (...more) => send(method, more, made[KEPT]);
      return made;
    };
  skin.close = () => {
    fail("the worker was closed");
    return worker.terminate();
  };
  if (model != null) skin.model = await skin.openModel(model);
  return skin;
}

// The options of a call, which are its last argument, with the model that is open.
function withModel(args, at, model) {
  const all = args.slice(0, at);
  all[at] = { ...args[at] };
  if (model != null) all[at].model ??= model;
  return all;
}
