// SPDX-License-Identifier: MIT
// sinew pose: rotates joints of a bound character and writes the deformed mesh or a picture of it.
#include "sinew_character/pose/pose.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/jobs/pose_job.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_character/pose/rest_pose.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct PoseCommandSettings {
  std::string character, output, matrices, up = "y", animation, to_pose;
  DeformSettings deform;
  std::vector<std::string> rotations;
  uint64_t seed = 0;
  double limit = 35, time = 0;
  bool random = false, animated = false;
};

// NAME=rx,ry,rz in degrees; the name may hold '=' itself, so the last one counts.
JointRotation parse_rotation(const std::string& text, const Character& character) {
  const size_t equals = text.rfind('=');
  JointRotation rotation;
  int used = 0;
  if (equals == std::string::npos ||
      std::sscanf(text.c_str() + equals + 1, "%lf,%lf,%lf%n", &rotation.x, &rotation.y, &rotation.z, &used) != 3 ||
      static_cast<size_t>(used) != text.size() - equals - 1 || !std::isfinite(rotation.x + rotation.y + rotation.z)) {
    throw UsageError("--joint " + text + ": expected NAME=rx,ry,rz in degrees");
  }
  const std::string name = text.substr(0, equals);
  for (; rotation.joint < character.joints.size(); ++rotation.joint) {
    if (character.joints[rotation.joint].name == name) return rotation;
  }
  throw Error("--joint " + text + ": the skeleton has no joint " + name);
}

std::vector<JointRotation> random_rotations(const Character& character, uint64_t seed, double limit) {
  uint64_t state = seed;
  const auto draw = [&state, limit] {  // splitmix64, so that a seed means the same pose everywhere
    uint64_t z = (state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return (static_cast<double>((z ^ (z >> 31)) >> 11) / 9007199254740992.0 * 2 - 1) * limit;
  };
  return rotate_joints(character, draw);
}

Character deformed(const PoseCommandSettings& s, const Character& character, const std::vector<Affine>& palette) {
  const std::optional<sinew_deform_options> options = deform_options(s.deform);
  PosedCharacter posed = pose_character(character, palette, options, s.deform.method == "dual-quaternion");
  if (!posed.corrected) {
    std::fprintf(stderr,
                 "warning: %s: skinning matrices with shear or unequal scales; the pose is linear skinning, without "
                 "volume correction. Use rotations with one scale\n",
                 character.name.c_str());
  }
  return std::move(posed.character);
}

// By joint rotations.
std::vector<Affine> turned_palette(const PoseCommandSettings& s, const Character& character, size_t* count) {
  std::vector<JointRotation> rotations;
  if (s.random) {
    rotations = random_rotations(character, s.seed, s.limit);
  } else {
    for (const std::string& text : s.rotations) rotations.push_back(parse_rotation(text, character));
  }
  *count = rotations.size();
  return pose_palette(character, rotations);
}

// A moment of one of the file's own animations.
std::vector<Affine> animated_palette(const PoseCommandSettings& s, const Character& character, std::string* what) {
  if (character.gltf == nullptr)
    throw Error(s.character + ": has no animations; expected one of " + extensions_text(kReadsWhole | kReadsMotion));
  return clip_palette(read_gltf_motion(s.character), s.character, s.animation, s.time, character.joints.size(), what);
}

// By what the command line says.
std::vector<Affine> chosen_palette(const PoseCommandSettings& s, const Character& character, std::string* what) {
  if (s.animated) return animated_palette(s, character, what);
  if (!s.matrices.empty()) {
    *what = "posed by " + file_name(s.matrices);
    return read_pose_matrices(s.matrices, character);
  }
  if (!s.to_pose.empty()) {
    *what = "in the rest pose " + s.to_pose;
    return rest_pose_palette(label_skeleton(character.joints), read_rest_pose(s.to_pose), axis_of(s.up));
  }
  size_t turned = 0;
  const std::vector<Affine> palette = turned_palette(s, character, &turned);
  *what = std::to_string(turned) + " joints rotated";
  return palette;
}

void run_pose(const PoseCommandSettings& s) {
  if (int{s.random} + int{!s.rotations.empty()} + int{s.animated} + int{!s.matrices.empty()} +
          int{!s.to_pose.empty()} !=
      1)
    throw UsageError(
        "give one of --random SEED, --animation NAME, --matrices FILE.pose, --to-pose POSE, and any number of --joint "
        "NAME=rx,ry,rz");
  (void)deform_options(s.deform);
  std::vector<std::string> outputs = extensions_of(kWritesMesh);
  outputs.emplace_back(".png");
  check_output(s.output, outputs);
  const Character character = read_character(s.character);
  if (character.joints.empty() || character.influences.empty()) {
    throw Error(s.character + ": has no skin weights; bind it first with sinew bind");
  }
  std::string what;
  const std::vector<Affine> palette = chosen_palette(s, character, &what);
  const Character posed = deformed(s, character, palette);
  if (has_extension(s.output, ".png")) {
    RenderOptions view;
    view.up = axis_of(s.up);
    write_file(s.output, encode_png(render(posed, weight_colors(posed), view)));
  } else {
    write_obj(s.output, posed);
  }
  std::printf("%s: %s, wrote %s\n", character.name.c_str(), printable(what).c_str(), s.output.c_str());
}

}  // namespace

void add_pose(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("pose", "Pose a bound character");
  auto s = std::make_shared<PoseCommandSettings>();
  sub->add_option("character", s->character, "Skinned file, or NAME.obj with NAME.rig.txt. " + mesh_files())
      ->required()
      ->type_name("CHARACTER");
  shared_option(sub, "-o,--output", s->output, extensions_text(kWritesMesh) + " or .png")->required();
  auto* seed = sub->add_option("--random", s->seed, "Rotate every joint but the roots at random")->type_name("SEED");
  shared_option(sub, "--limit", s->limit, "About each axis, for --random")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str()
      ->needs(seed);
  sub->add_option("--joint", s->rotations, "Rotate a joint about x, then y, then z, in degrees; repeatable")
      ->type_name("NAME=rx,ry,rz")
      ->allow_extra_args(false);
  auto* animation = shared_option(sub, "--animation", s->animation);
  sub->add_option("--time", s->time, "Time in the animation, in seconds")
      ->check(CLI::NonNegativeNumber)
      ->needs(animation)
      ->type_name("T");
  sub->add_option("--matrices", s->matrices,
                  "Pose by skinning matrices (rest to posed space), one line per joint. pose NAME m00 m01 ... m23")
      ->type_name("FILE.pose");
  shared_option(sub, "--to-pose", s->to_pose);
  add_deform_options(sub, {"linear", "dual-quaternion", "volume", "xpbd", "delta-mush"},
                     "linear and dual-quaternion: skinning alone; ", &s->deform);
  shared_option(sub, "--up", s->up, "In the picture, and of --to-pose")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
  add_solver_options(sub, &s->deform);
  add_drawn_correction(sub, &s->deform);
  sub->footer(
      "Examples:\n  sinew pose hero.glb --random 7 -o pose.png\n"
      "  sinew pose hero.obj --joint upper_arm.L=0,0,-60 --joint head=0,30,0 -o pose.obj\n"
      "  sinew pose hero.glb --animation walk --time 0.5 -o walk.png\n"
      "  sinew pose hero.glb --matrices frame12.pose --deform volume -o pose.obj");
  sub->callback([s, seed, animation] {
    s->random = seed->count() > 0;
    s->animated = animation->count() > 0;
    run_pose(*s);
  });
}

}  // namespace sinew::cli
