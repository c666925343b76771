// SPDX-License-Identifier: MIT
// sinew bake: corrective morph targets for programs that know linear skinning alone.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_character/jobs/bake_job.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct BakeCommandSettings {
  std::string character, output, animation;
  DeformSettings deform{"volume", 0, 0};
  size_t poses = 1500, shapes = 8;
  uint64_t seed = 1;
  double limit = 60, error = 0.2;
  bool animated = false, json = false;
};

void tell(const BakeCommandSettings& s, const BakedCharacter& baked) {
  const Morphs& morphs = baked.morphs;
  size_t moved = 0;
  for (const MorphShape& shape : morphs.shapes) moved += shape.vertices.size();
  if (s.json) {
    const auto error = [](const BakeError& e) { return Json{{"linear", e.linear}, {"baked", e.baked}}; };
    Json json = {{"sinew_bake", 1},
                 {"character", s.character},
                 {"output", s.output},
                 {"bends", morphs.drivers.size()},
                 {"shapes", morphs.shapes.size()},
                 {"moved_vertices", moved},
                 {"animations", morphs.clips.size()},
                 {"poses", baked.learnt_poses},
                 {"held_out_poses", baked.held_out_poses},
                 {"error", error(baked.learned)}};
    if (baked.held_out_poses > 0) json["held_out_error"] = error(baked.held_out);
    std::printf("%s\n", json_line(json).c_str());
    return;
  }
  std::printf("%s: %zu shapes for %zu bends from %zu poses\n", printable(s.character).c_str(), morphs.shapes.size(),
              morphs.drivers.size(), baked.learnt_poses);
  const auto say = [](const char* which, size_t count, const BakeError& e) {
    std::printf("  %s (%zu poses): %.3f %% of the size off the corrected pose, %.3f %% with linear skinning alone\n",
                which, count, 100 * e.baked, 100 * e.linear);
  };
  say("learned", baked.learnt_poses, baked.learned);
  if (baked.held_out_poses > 0) say("held out", baked.held_out_poses, baked.held_out);
  if (!morphs.clips.empty()) std::printf("  %zu animations play the shapes\n", morphs.clips.size());
  std::printf("wrote %s\n", printable(s.output).c_str());
}

void run_bake(const BakeCommandSettings& s) {
  check_output(s.output, kWritesWhole);
  const sinew_deform_options deform = deform_options(s.deform).value();  // --deform takes corrections alone
  const std::atomic<bool>& stop = stop_on_signals();
  const Character character = read_character(s.character);
  OwnMotion own;
  if (character.gltf != nullptr) own = read_own_motion(s.character);
  BakeJobOptions job;
  job.character = s.character;
  job.deform = deform;
  job.poses = s.poses;
  job.shapes = s.shapes;
  job.seed = s.seed;
  job.limit = s.limit;
  job.error = s.error / 100;
  if (s.animated) job.animation = s.animation;
  const BakedCharacter baked = bake_character(character, own, job, [&stop](size_t steps) {
    auto progress = std::make_shared<Progress>(steps, "poses");
    return [progress, &stop] {
      progress->step();
      return !stop;
    };
  });
  if (stop) throw Error(s.output + ": cannot write, the job was interrupted");
  GlbOptions options;
  options.keep_skin = true;
  write_gltf_morphs(s.output, character, options, baked.morphs);
  tell(s, baked);
}

}  // namespace

void add_bake(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("bake", "Bake corrected bends into morph targets, for programs without sinew");
  auto s = std::make_shared<BakeCommandSettings>();
  sub->add_option("character", s->character, "Skinned file, or NAME.obj with NAME.rig.txt. " + mesh_files())
      ->required()
      ->type_name("CHARACTER");
  shared_option(sub, "-o,--output", s->output,
                "The character with its shapes, their drivers, and their weights in its animations: " +
                    extensions_text(kWritesWhole))
      ->required();
  sub->add_option("--poses", s->poses, "Number of training poses: random ones, or frames of --animation")
      ->check(CLI::Range(1u, 10000u))
      ->type_name("N")
      ->capture_default_str();
  shared_option(sub, "--limit", s->limit)->check(CLI::Range(1.0, 180.0))->capture_default_str();
  shared_option(sub, "--seed", s->seed)->capture_default_str();
  auto* animation = shared_option(sub, "--animation", s->animation, "The training poses come from it");
  shared_option(sub, "--shapes", s->shapes, "Per bend")->check(CLI::Range(1u, 64u))->capture_default_str();
  sub->add_option(
         "--error", s->error,
         "Threshold for leaving out shapes and displacements: root mean square over the poses, in percent of the size")
      ->check(CLI::Range(0.0, 10.0))
      ->type_name("PERCENT")
      ->capture_default_str();
  add_deform_options(sub, {"volume", "xpbd", "delta-mush"}, "Of the poses that shapes are fitted to. ", &s->deform);
  sub->get_option("--deform")->default_str("volume");
  shared_flag(sub, "--json", s->json);
  add_solver_options(sub, &s->deform);
  add_drawn_correction(sub, &s->deform);
  sub->footer(
      "Examples:\n  sinew bake hero.glb -o hero.baked.glb\n"
      "  sinew bake walking.glb --animation walk --shapes 4 -o walking.baked.glb");
  sub->callback([s, animation] {
    s->animated = animation->count() > 0;
    run_bake(*s);
  });
}

}  // namespace sinew::cli
