// SPDX-License-Identifier: MIT
// Jobs of sinew/character.h for the open character, by the JavaScript of the npm package: what files hold, checks, motions, files that are saved.
// The worker fetches this after the first bind. The session's character is copied for each job; page-only calls of the module are web_NAME().
import { CharacterFile, CharacterModule } from "@sinew/skin/character";

/** @typedef {{ up: number, own: boolean, picture: boolean, method: number, pins: number[][][], inPlace?: boolean, armSpread?: number }} MotionWish */
/** @typedef {import("../../npm/src/jobs.js").AnimateResult} AnimateResult */
/** @typedef {{ at: number, character: CharacterFile }} Handle */
/** @typedef {import("./types.js").SpringWish} SpringWish */
/** @typedef {{ names: string[], wish: MotionWish, sources: Handle[], made: Map<number, any>, now: any }} Opened */

const copies = { shown: 0, written: 1, ofFile: 2 }; // CopyOf of handles.hpp
/** @type {import("../../npm/src/jobs.js").RetargetOptions["method"][]} */
const methods = ["contacts", "copy", "reference-points", "stream"];
/** @type {import("../../npm/src/jobs.js").RetargetOptions["targetUp"][]} */
const ups = ["y", "z", "auto"];

export class Handles {
  #module;
  #house;
  /** @type {Opened | null} */
  #open = null; // what the character plays
  /** @type {Handle | null} */
  #springs = null; // the character with what swings on it
  /** @type {Map<any, Handle[]>} */
  #swung = new Map(); // clips with these springs played into them, by what #open has made
  #dragged = false; // since the springs were found

  /** @param {any} module of emscripten */
  constructor(module) {
    this.#module = module;
    this.#house = new CharacterModule(module, () => Promise.reject(new Error("scenes are read as files")));
  }

  /** @param {(blocks: any, out: number) => number} call @returns {Handle} */
  #handle(call) {
    const house = this.#house;
    return house.withBlocks(null, (/** @type {any} */ blocks) => {
      const out = blocks.room(Uint32Array, 1);
      house.check(call(blocks, out), 0);
      const [at] = blocks.view(Uint32Array, out, 1);
      return { at, character: new CharacterFile(house, at) };
    });
  }
  /** @param {string} name of a file that the module has */
  #file = (name) => this.#handle((blocks, out) => this.#module._sinew_character_open(blocks.texts([name]).address, out));
  /** @param {number} what of `copies` */
  #copy = (what, moving = 0) => this.#handle((_, out) => this.#module._web_character(what, moving, out));
  // Clips that files get: not those of its own.
  get #moving() {
    return this.#open && !this.#open.wish.own ? this.#open.now.handle.at : 0;
  }

  /**
   * @template Result
   * @param {Handle} handle closed afterwards
   * @param {(character: CharacterFile, at: number) => Result} use
   */
  #with({ character, at }, use) {
    try {
      return use(character, at);
    } finally {
      character.close();
    }
  }

  // Throws for a file that is neither a mesh nor a motion.
  /** @param {string} name */
  contents(name) {
    const house = this.#house;
    return this.#with(this.#file(name), (_, at) =>
      house.withBlocks(null, (/** @type {any} */ blocks) => {
        const { face_count: faces, joint_count: joints } = house.arrays(at), count = blocks.room(Uint32Array, 1);
        house.check(this.#module._sinew_character_clip_count(at, count), at);
        return { mesh: faces > 0, joints, clips: blocks.view(Uint32Array, count, 1)[0] };
      }),
    );
  }

  check = () => this.#with(this.#copy(copies.shown, this.#moving), (character) => character.check());

  // What swings on the character that is shown: chains that are proposed, the file's own first.
  /** @param {SpringWish} wish */
  findSprings({ take, drop, values }) {
    const handle = this.#copy(copies.shown);
    try {
      const { names, kinds, kept, certainties, ownCount } = handle.character.springs({ take, drop, values });
      const kind = kinds.split("\n");
      this.#forgetSprings();
      this.#springs = handle;
      return { chains: Array.from(kept, (one, c) => ({ name: names.split("\n")[c], kind: kind[c], kept: one !== 0, certainty: certainties[c], own: c < ownCount })) };
    } catch (error) {
      handle.character.close();
      throw error;
    }
  }

  #forgetSprings() {
    this.#forgetSwung();
    this.#springs?.character.close();
    this.#springs = null;
    this.#dragged = false;
  }

  #forgetSwung() {
    for (const handles of this.#swung.values()) for (const handle of handles) handle?.character.close(); // those of clips that were not shown are missing
    this.#swung.clear();
  }

  // The handle of a clip with the springs played into it, made when it is first asked for.
  /** @param {number} clip */
  #swungClip(clip) {
    const { now } = /** @type {Opened} */ (this.#open), { at } = /** @type {Handle} */ (this.#springs);
    const swung = this.#swung.get(now) ?? [];
    this.#swung.set(now, swung);
    swung[clip] ??= this.#handle((_, out) => this.#module._web_swing(now.handle.at, at, clip, out));
    return swung[clip];
  }

  // The springs' handle, for a drag, and whether it is the first frame of one.
  /** @param {boolean} begins */
  dragging(begins) {
    if (!this.#springs) throw new Error("no springs were looked for");
    const first = begins || !this.#dragged;
    this.#dragged = true;
    return { at: this.#springs.at, begins: first };
  }

  // {bytes, notes, height}; notes: what writing it had to say; a VRM stands on the floor, height: how far above it the character stood. springs: what swings and is written with it, null for what its file has; bakes: the clips swing, too.
  /** @param {string} name @param {{ clips: boolean, springs: SpringWish | null, bakes: boolean, profile: string, author: string, title: string, licence: string }} wish */
  file(name, { clips, springs, bakes, profile, author, title, licence }) {
    return this.#with(this.#copy(copies.written, clips ? this.#moving : 0), (character, at) => {
      const height = profile === "vrm" ? this.#putOnFloor(at) : 0;
      if (springs) character.springs(springs);
      if (springs && bakes) this.#house.check(this.#module._web_swing_all(at), at);
      if (profile) character.setProfile({ profile, authors: author ? [author] : [], title, license: licence });
      const before = character.notes.length, bytes = character.save(name);
      return { height, bytes, notes: character.notes.slice(before) };
    });
  }

  // How high it stood above the floor, on which it stands then.
  /** @param {number} at a handle */
  #putOnFloor(at) {
    const house = this.#house;
    return house.withBlocks(null, (/** @type {any} */ blocks) => {
      const out = blocks.room(Float64Array, 1);
      house.check(this.#module._web_put_on_floor(at, out), at);
      return blocks.view(Float64Array, out, 1)[0];
    });
  }

  /** @param {string} name */
  rigText = (name) => this.#with(this.#copy(copies.ofFile), (character) => character.save(name));

  // Every clip of the files, one file after another, for the character; what was open stays when that fails.
  /** @param {string[]} names or builtin:NAME @param {MotionWish} wish */
  openMotions(names, wish) {
    /** @type {Opened} */
    const opened = { names, wish, sources: [], made: new Map(), now: null };
    try {
      for (const name of names) opened.sources.push(this.#file(name));
      this.#make(opened, wish.method);
    } catch (error) {
      this.#close(opened);
      throw error;
    }
    this.closeMotions();
    this.#open = opened;
    const { clips, files } = opened.now;
    return { clips, files, joints: files[0].map.length };
  }

  // One clip for the character, for pictures of it: what is open stays. use: called with its handle, of which the module has frames.
  /**
   * @template Result
   * @param {string} name @param {MotionWish} wish @param {(at: number, seconds: number) => Result} use
   */
  preview(name, wish, use) {
    /** @type {Opened} */
    const opened = { names: [name], wish, sources: [this.#file(name)], made: new Map(), now: null };
    try {
      this.#make(opened, wish.method);
      const { handle, files: [{ notes }], clips: [{ seconds }] } = opened.now;
      return { notes, seconds, poses: use(handle.at, seconds) };
    } finally {
      this.#closeHandles(opened);
    }
  }

  // The same by another method, made when it is first asked for.
  /** @param {number} method */
  useMethod(method) {
    if (!this.#open) throw new Error("no motion is open");
    this.#make(this.#open, method);
    return { clips: this.#open.now.clips };
  }

  closeMotions() {
    if (this.#open) this.#close(this.#open);
    this.#open = null;
  }

  /** @param {Opened} opened */
  #close(opened) {
    this.#forgetSwung();
    this.#closeHandles(opened);
  }

  /** @param {Opened} opened */
  #closeHandles({ sources, made }) {
    for (const { character } of [...sources, ...[...made.values()].map(({ handle }) => handle)]) character.close();
  }

  /** @param {Opened} opened @param {number} method */
  #make(opened, method) {
    if (!opened.made.has(method)) opened.made.set(method, this.#made(opened, method));
    opened.now = opened.made.get(method);
  }

  /** @param {Opened} opened @param {number} method */
  #made({ names, wish, sources }, method) {
    const handle = this.#copy(copies.shown), { character } = handle;
    try {
      const results = sources.map(({ character: motion }, f) => {
        const before = character.notes.length;
        const pins = (wish.pins[f] ?? []).map(([target, source]) => ({ target, source }));
        const made = character.retarget(motion, { method: wish.picture && method === 0 ? "auto" : methods[method], targetUp: ups[wish.up], pins, inPlace: wish.inPlace ?? false, armSpread: wish.armSpread ?? 0, report: true, force: true });
        return { made, notes: character.notes.slice(before).filter((/** @type {string} */ note) => !note.startsWith("checked: ")) };
      });
      /** @type {any[]} */
      const rows = JSON.parse(this.#module.UTF8ToString(this.#module._web_clips(handle.at)));
      return { handle, files: results.map(({ made, notes }, f) => this.#fileOf(names[f], made, notes)), ...clipsOf(results.map(({ made }) => made), rows) };
    } catch (error) {
      character.close();
      throw error;
    }
  }

  /** @param {string} file @param {AnimateResult} made @param {string[]} notes */
  #fileOf(file, made, notes) {
    const why = (/** @type {number} */ reason) => this.#module.UTF8ToString(this.#module._web_map_reason(reason));
    return {
      file,
      mapped: made.mapped,
      how: made.mappedBy,
      sourceJoints: made.sourceNames.split("\n").map((name, j) => ({ name, end: made.sourceEnds[j] !== 0 })),
      map: Array.from(made.sources, (source, j) => ({ source, why: why(made.reasons[j]) })),
      notes: notes.map((note) => note.replace(`${file}: `, "")), // the page names the file itself
    };
  }

  // The handle whose clips play, the number of the one that does, and what limbs do in the frame that is nearest: [{joint, kind, place, error}], see
  // sinew_contact_spot.
  /** @param {number} clip @param {number} seconds @param {boolean} swings */
  playing(clip, seconds, swings) {
    const { handle = { at: 0 }, clips = [], spots = [] } = this.#open?.now ?? {};
    if (!(clip in clips)) return { at: 0, clip, spots: [] };
    const { frames, limbs, seconds: length } = clips[clip], { made, first } = spots[clip];
    const frame = length > 0 ? Math.max(0, Math.min(frames - 1, Math.round((seconds / length) * (frames - 1)))) : 0;
    /** @type {{ joint: number, kind: number, place: number[], error: number }[]} */
    const shown = limbs.flatMap((/** @type {{ joint: number }} */ { joint }, /** @type {number} */ l) => {
      const at = first + frame * limbs.length + l, kind = made.spotKinds[at] ?? 0; // a character without a body has none
      return kind === 0 ? [] : [{ joint, kind, place: [...made.spotPositions.subarray(3 * at, 3 * at + 3)], error: made.spotErrors[at] }];
    });
    return swings && this.#springs ? { at: this.#swungClip(clip).at, clip: 0, spots: shown } : { at: handle.at, clip, spots: shown };
  }
}

// rows: of all clips, as the module has them. spots: where those of each clip begin in its result.
/** @param {AnimateResult[]} results @param {any[]} rows */
function clipsOf(results, rows) {
  /** @type {any[]} */
  const clips = [], spots = [];
  for (const [file, made] of results.entries()) {
    let first = 0;
    for (let c = 0; c < made.clipCount; ++c) {
      const ofClip = (/** @type {any[]} */ list) => list.slice(c * made.limbCount, (c + 1) * made.limbCount);
      const after = ofClip(made.limbsAfter), row = rows[clips.length];
      spots.push({ made, first });
      clips.push({ ...row, file, limbs: ofClip(made.limbsBefore).map((before, l) => ({ joint: before.joint, leg: before.leg, before, after: after[l] })) });
      first += row.frames * made.limbCount;
    }
  }
  return { clips, spots };
}
