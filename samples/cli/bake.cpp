// SPDX-License-Identifier: MIT
// sinew bake: corrective morph targets for programs that know linear skinning alone.
#include "sinew_character/bake.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "deform_options.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kHeldOut = 10;

struct Settings {
  std::string character, output, animation;
  DeformSettings deform{"volume", 0, 0};
  size_t poses = 1500, shapes = 8;
  uint64_t seed = 1;
  double limit = 60;
  bool animated = false, json = false;
};

// Poses to learn from, and others to be measured by.
struct Poses {
  std::vector<Palette> learnt, held_out;
};

Poses chosen_poses(const Settings& s, const Character& character, const Motion& motion) {
  Poses poses;
  if (!s.animated) {
    poses.learnt = random_palettes(character, s.poses, s.limit, s.seed);
    poses.held_out = random_palettes(character, kHeldOut, s.limit, s.seed + 1);
    return poses;
  }
  const Clip& clip = find_clip(motion, s.character, s.animation);
  const size_t frames = clip.frames.size();
  for (size_t f = 0; f < frames; ++f) {
    const Palette palette = motion_palette(motion, clip.frames[f], character.joints.size());
    // Ten frames at even distances, none of a clip too short to spare them.
    const bool spared = frames >= 3 * kHeldOut && (f * kHeldOut) / frames != ((f + 1) * kHeldOut) / frames;
    (spared ? poses.held_out : poses.learnt).push_back(palette);
  }
  if (poses.learnt.size() > s.poses) {  // evenly thinned
    std::vector<Palette> thinned;
    for (size_t p = 0; p < s.poses; ++p) thinned.push_back(poses.learnt[p * poses.learnt.size() / s.poses]);
    poses.learnt = std::move(thinned);
  }
  return poses;
}

// The drivers' weights in every animation of the file, so that any player shows the corrections.
void play_in_animations(const OwnMotion& own, const Character& character, Morphs* morphs) {
  for (size_t c = 0; c < own.keys.size(); ++c) {
    MorphClip keys = own.keys[c];
    for (const MotionFrame& frame : own.motion.clips[c].frames)
      keys.weights.push_back(
          shape_weights(character.joints, *morphs, motion_palette(own.motion, frame, character.joints.size())));
    morphs->clips.push_back(std::move(keys));
  }
}

void tell(const Settings& s, const Morphs& morphs, const Poses& poses, const BakeError& learnt,
          const BakeError& held_out) {
  size_t moved = 0;
  for (const MorphShape& shape : morphs.shapes) moved += shape.vertices.size();
  if (s.json) {
    const auto error = [](const BakeError& e) { return Json{{"linear", e.linear}, {"baked", e.baked}}; };
    Json json = {{"character", s.character},       {"output", s.output},
                 {"bends", morphs.drivers.size()}, {"shapes", morphs.shapes.size()},
                 {"moved_vertices", moved},        {"animations", morphs.clips.size()},
                 {"poses", poses.learnt.size()},   {"held_out_poses", poses.held_out.size()},
                 {"error", error(learnt)}};
    if (!poses.held_out.empty()) json["held_out_error"] = error(held_out);
    std::printf("%s\n", json_line(json).c_str());
    return;
  }
  std::printf("%s: %zu shapes for %zu bends from %zu poses\n", printable(s.character).c_str(), morphs.shapes.size(),
              morphs.drivers.size(), poses.learnt.size());
  const auto say = [](const char* which, size_t count, const BakeError& e) {
    std::printf("  %s (%zu poses): %.3f %% of the size from the corrected pose, linear skinning alone %.3f %%\n", which,
                count, 100 * e.baked, 100 * e.linear);
  };
  say("learnt", poses.learnt.size(), learnt);
  if (!poses.held_out.empty()) say("held out", poses.held_out.size(), held_out);
  if (!morphs.clips.empty()) std::printf("  %zu animations play the shapes\n", morphs.clips.size());
  std::printf("wrote %s\n", printable(s.output).c_str());
}

void run(const Settings& s) {
  check_output(s.output, {".glb", ".gltf", ".vrm"});
  const sinew_deform_options deform = deform_options(s.deform).value();  // --deform takes corrections alone
  const std::atomic<bool>& stop = stop_on_signals();
  const Character character = read_character(s.character);
  if (character.joints.empty() || character.influences.empty())
    throw Error(s.character + ": has no skin weights to bake; bind it first with sinew bind");
  OwnMotion own;
  if (character.gltf != nullptr) own = read_own_motion(s.character);
  if (s.animated && own.motion.clips.empty())
    throw Error(s.character + ": has no animation to learn from; leave --animation out, or see sinew animate");
  const Poses poses = chosen_poses(s, character, own.motion);
  BakeSettings settings;
  settings.deform = deform;
  settings.shapes_per_bend = s.shapes;
  Progress progress(2 * poses.learnt.size() + poses.held_out.size(), "poses");
  const BakeProgress step = [&] {
    progress.step();
    return !stop;
  };
  Morphs morphs = bake_bends(character, poses.learnt, settings, step);
  if (morphs.shapes.empty() && !stop) {
    throw Error(
        s.character +
        ": has nothing to bake: nothing bends in the poses, so linear skinning loses nothing; expected vertices "
        "or faces that follow two joints");
  }
  const BakeError learnt = bake_error(character, morphs, poses.learnt, deform, step);
  BakeError held_out;
  if (!poses.held_out.empty()) held_out = bake_error(character, morphs, poses.held_out, deform, step);
  if (!morphs.shapes.empty()) play_in_animations(own, character, &morphs);
  if (stop) throw Error(s.output + ": cannot write, the work was interrupted");
  GlbOptions options;
  options.keep_skin = true;
  write_gltf_morphs(s.output, character, options, morphs);
  tell(s, morphs, poses, learnt, held_out);
}

}  // namespace

void add_bake(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("bake", "Corrected bends as morph targets, for programs without sinew");
  auto s = std::make_shared<Settings>();
  sub->add_option("character", s->character, "Skinned file, or NAME.obj with NAME.rig.txt beside it. " + mesh_files())
      ->required()
      ->type_name("CHARACTER");
  shared_option(sub, "-o,--output", s->output,
                "The character with its shapes, what drives them, and their weights in its animations: .glb, .gltf or "
                ".vrm")
      ->required();
  sub->add_option("--poses", s->poses, "Poses to learn from: random ones, or frames of --animation")
      ->check(CLI::Range(1u, 10000u))
      ->type_name("N")
      ->capture_default_str();
  shared_option(sub, "--limit", s->limit)->check(CLI::Range(1.0, 180.0))->capture_default_str();
  shared_option(sub, "--seed", s->seed)->capture_default_str();
  auto* animation = shared_option(sub, "--animation", s->animation, "It is learnt from");
  shared_option(sub, "--shapes", s->shapes, "A bend")->check(CLI::Range(1u, 64u))->capture_default_str();
  add_deform_options(sub, {"volume", "xpbd", "delta-mush"}, "That is what the shapes learn. ", &s->deform);
  sub->get_option("--deform")->default_str("volume");
  shared_flag(sub, "--json", s->json);
  add_solver_options(sub, &s->deform);
  sub->footer(
      "Examples:\n  sinew bake hero.glb -o hero.baked.glb\n"
      "  sinew bake walking.glb --animation walk --shapes 4 -o walking.baked.glb");
  sub->callback([s, animation] {
    s->animated = animation->count() > 0;
    run(*s);
  });
}

}  // namespace sinew::cli
