// SPDX-License-Identifier: MIT
// A character that is placed, bound and saved with its controls, and what is wrong with another: files in OUT_FOLDER, the rest as one
// line of JSON.
//   delivery.mjs DATA_FOLDER OUT_FOLDER
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { load } from "@sinew/skin/character";

const [data, out] = process.argv.slice(2);
const house = await load();
const at = (name) => readFileSync(join(data, name));
const refused = (run) => {
  try {
    run();
    return "";
  } catch (error) {
    return `${error.name} ${error.status}: ${error.message}`;
  }
};

const hero = await house.open(at("biped__robed.obj"), "biped__robed.obj", { "biped__robed.rig.txt": at("biped__robed.rig.txt") });
hero.transform({ turns: ["y"], height: 2, floor: true });
hero.bind();
hero.setProfile({ controls: true });
const glb = hero.save("hero.glb");
writeFileSync(join(out, "hero.glb"), glb);
writeFileSync(join(out, "hero.controls.json"), hero.controls);
hero.setProfile({ profile: "mixamo" });
writeFileSync(join(out, "mixamo.glb"), hero.save("hero.glb"));
const errors = {
  turn: refused(() => hero.transform({ turns: ["up"] })),
  profile: refused(() => hero.setProfile({ profile: "none" })),
  rule: refused(() => hero.check({ bounds: { none: 1 } })),
  option: refused(() => hero.check({ count: 2 })),
};
hero.close();

const caped = await house.open(at("biped__caped.gltf"), "biped__caped.gltf");
const checked = caped.check({ score: true });
const strict = caped.check({ poses: false, bounds: { speck: -1, "far-weight": -1 } });
caped.close();
console.log(JSON.stringify({ checked, unscored: strict.score, strict: strict.findings.length, found: strict.findings.find(({ vertices }) => vertices.length > 0), errors }));
