// SPDX-License-Identifier: MIT
// sinew_character_check(): what `sinew check` looks for.
#include "sinew_character/check/check.hpp"

#include <cmath>

#include "handle.hpp"
#include "sinew_character/check/check_output.hpp"

namespace sinew {
namespace {

CheckOptions options_from(const sinew_character_check_options& given) {
  CheckOptions options;
  check_without(given.without, SINEW_WITHOUT_POSES | SINEW_WITHOUT_CLIPS);
  options.poses = (given.without & SINEW_WITHOUT_POSES) == 0;
  need(given.bound_count == 0 || (given.bound_rules != nullptr && given.bounds != nullptr), "bound_rules, bounds");
  for (uint32_t b = 0; b < given.bound_count; ++b) {
    need(given.bound_rules[b] != nullptr, "bound_rules");
    if (std::isnan(given.bounds[b]))
      throw Failure(SINEW_ERROR_NOT_FINITE,
                    std::string("bounds: the value of ") + given.bound_rules[b] + " is not a number");
    options.bounds[given.bound_rules[b]] = given.bounds[b];
  }
  return options;
}

// The file's clips and the added ones; a motion of a skeleton that was changed since has none.
Motion motion_now(sinew_character* character) {
  const Motion own = character->drop_animations ? Motion() : own_motion(character);
  Motion motion = motion_of(character->character.joints);
  if (own.joints.size() >= motion.joints.size() && !own.clips.empty()) motion = own;
  // Clips that were added know the character's joints alone; others stay at rest in them.
  for (Clip clip : character->clips) {
    for (MotionFrame& frame : clip.frames)
      for (size_t j = frame.rotations.size(); j < motion.joints.size(); ++j) {
        frame.rotations.push_back(kNoRotation4);
        frame.translations.push_back(motion.joints[j].offset);
      }
    motion.clips.push_back(std::move(clip));
  }
  return motion;
}

sinew_character_finding view_of(const RigFinding& finding) {
  sinew_character_finding view;
  std::memset(&view, 0, sizeof view);
  view.rule = finding.rule->name;
  view.what = finding.what.c_str();
  view.cure = finding.rule->cure;
  view.pose = finding.pose.c_str();
  view.clip = finding.clip.c_str();
  view.seconds = finding.seconds;
  view.value = finding.value;
  view.bound = finding.bound;
  view.vertices = finding.vertices.empty() ? nullptr : finding.vertices.data();
  view.vertex_count = count32(finding.vertices.size());
  view.severity = static_cast<uint32_t>(finding.severity);
  view.joint = finding.joint;
  view.other = finding.other;
  view.mesh = finding.mesh;
  view.position[0] = finding.position.x;
  view.position[1] = finding.position.y;
  view.position[2] = finding.position.z;
  view.radius = static_cast<float>(finding.radius);
  return view;
}

std::string all_rules() {
  std::string names;
  for (const CheckRule& rule : check_rules()) names += (names.empty() ? "" : " ") + std::string(rule.name);
  return names;
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" {

sinew_status sinew_character_check(sinew_character* character, const sinew_character_check_options* given,
                                   sinew_character_check_result* result) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(result != nullptr, "result");
    check_result(result);
    const sinew_character_check_options options = options_of(given);
    std::optional<Motion> motion;
    if ((options.without & SINEW_WITHOUT_CLIPS) == 0) motion = motion_now(character);
    check_at_most("score", options.score, 1);
    std::optional<double> score;
    if (options.score != 0) score = weight_score(character->character);
    RigCheck check = check_rig(character->character, motion ? &*motion : nullptr, options_from(options));
    ResultViews& views = character->results;
    views = {};
    views.check = std::move(check);
    for (const RigFinding& finding : views.check.findings) views.findings.push_back(view_of(finding));
    views.text = checked_line(views.check);
    sinew_character_check_result filled = SINEW_INIT(sinew_character_check_result);
    filled.finding_count = count32(views.findings.size());
    filled.errors = count32(views.check.errors);
    filled.warnings = count32(views.check.warnings);
    filled.notes = count32(views.check.notes);
    filled.findings = views.findings.data();
    filled.line = views.text.c_str();
    filled.score = score ? *score : -1;
    give(filled, result);
  });
}

const char* sinew_character_check_rules(void) {
  static const std::string names = all_rules();
  return names.c_str();
}

}  // extern "C"
