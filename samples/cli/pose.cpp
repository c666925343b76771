// SPDX-License-Identifier: MIT
// sinew pose: turns joints of a bound character and writes the deformed mesh or a picture of it.
#include "sinew_formats/pose.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "commands.hpp"
#include "sinew_datasets/image.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct Settings {
  std::string character, output, up = "y";
  std::vector<std::string> turns;
  uint64_t seed = 0;
  double limit = 35;
  bool random = false, dual_quaternion = false;
};

// NAME=rx,ry,rz in degrees; the name may hold '=' itself, so the last one counts.
JointTurn parse_turn(const std::string& text, const Character& character) {
  const size_t equals = text.rfind('=');
  JointTurn turn;
  int used = 0;
  if (equals == std::string::npos ||
      std::sscanf(text.c_str() + equals + 1, "%lf,%lf,%lf%n", &turn.x, &turn.y, &turn.z, &used) != 3 ||
      static_cast<size_t>(used) != text.size() - equals - 1 || !std::isfinite(turn.x + turn.y + turn.z)) {
    throw UsageError("--joint " + text + ": expected NAME=rx,ry,rz in degrees");
  }
  const std::string name = text.substr(0, equals);
  for (; turn.joint < character.joints.size(); ++turn.joint) {
    if (character.joints[turn.joint].name == name) return turn;
  }
  throw Error("--joint " + text + ": the skeleton has no joint " + name);
}

std::vector<JointTurn> random_turns(const Character& character, uint64_t seed, double limit) {
  std::vector<JointTurn> turns;
  uint64_t state = seed;
  const auto draw = [&state, limit] {  // splitmix64, so that a seed means the same pose everywhere
    uint64_t z = (state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return (static_cast<double>((z ^ (z >> 31)) >> 11) / 9007199254740992.0 * 2 - 1) * limit;
  };
  for (size_t j = 0; j < character.joints.size(); ++j) {
    if (character.joints[j].parent < 0) continue;  // a turned root only turns the whole character
    JointTurn turn;
    turn.joint = j;
    turn.x = draw();
    turn.y = draw();
    turn.z = draw();
    turns.push_back(turn);
  }
  return turns;
}

void run(const Settings& s) {
  if (s.random == !s.turns.empty()) throw UsageError("give either --random SEED or one --joint NAME=rx,ry,rz or more");
  check_output(s.output, {".obj", ".png"});
  const Character character = read_character(s.character);
  if (character.joints.empty() || character.influences.empty()) {
    throw Error(s.character + ": has no skin weights to pose; bind it first with sinew bind");
  }
  std::vector<JointTurn> turns;
  if (s.random) {
    turns = random_turns(character, s.seed, s.limit);
  } else {
    for (const std::string& text : s.turns) turns.push_back(parse_turn(text, character));
  }
  const Character posed = apply_pose(character, pose_palette(character, turns), s.dual_quaternion);
  if (has_extension(s.output, ".png")) {
    RenderOptions view;
    view.up_z = s.up == "z";
    write_file(s.output, encode_png(render(posed, weight_colours(posed), view)));
  } else {
    write_obj(s.output, posed);
  }
  std::printf("%s: %zu joints turned, wrote %s\n", character.name.c_str(), turns.size(), s.output.c_str());
}

}  // namespace

void add_pose(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("pose", "Pose a bound character");
  auto s = std::make_shared<Settings>();
  sub->add_option("character", s->character, "Skinned .glb, .gltf or .vrm, or NAME.obj with NAME.rig.txt beside it")
      ->required()
      ->type_name("CHARACTER");
  auto* seed = sub->add_option("--random", s->seed, "Turn every joint but the roots at random")->type_name("SEED");
  sub->add_option("--limit", s->limit, "Largest random angle about each axis, degrees")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str()
      ->needs(seed);
  sub->add_option("--joint", s->turns, "Turn one joint about x, then y, then z, in degrees; may be repeated")
      ->type_name("NAME=rx,ry,rz")
      ->allow_extra_args(false);
  sub->add_flag("--dual-quaternion", s->dual_quaternion, "Dual quaternion instead of linear blend skinning");
  sub->add_option("--up", s->up, "Axis that points up in the picture")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
  sub->add_option("-o,--output", s->output, "Output: .obj or .png")->required()->type_name("OUT");
  sub->footer(
      "Examples:\n  sinew pose hero.glb --random 7 -o pose.png\n"
      "  sinew pose hero.obj --joint upper_arm.L=0,0,-60 --joint head=0,30,0 -o pose.obj");
  sub->callback([s, seed] {
    s->random = seed->count() > 0;
    run(*s);
  });
}

}  // namespace sinew::cli
