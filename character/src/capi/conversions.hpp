// SPDX-License-Identifier: MIT
// Callers' structs as jobs take them, and results as callers see them: what several calls share.
#ifndef SINEW_CHARACTER_CAPI_CONVERSIONS_HPP
#define SINEW_CHARACTER_CAPI_CONVERSIONS_HPP

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "handle.hpp"
#include "sinew/character.h"
#include "sinew/skeleton.h"
#include "sinew_character/bind/seams.hpp"
#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/motion/map_source.hpp"
#include "sinew_character/motion/motion_file.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// nullopt for plain skinning. Throws Failure for settings that the method has no use for.
//   usual  method where none is given
inline std::optional<sinew_deform_options> corrections_of(const sinew_character_deformation* given,
                                                          uint32_t usual = SINEW_POSE_LINEAR) {
  const sinew_character_deformation options = options_of(given);
  const uint32_t method = options.method == SINEW_POSE_LINEAR ? usual : options.method;
  check_at_most("deform", method, SINEW_POSE_DELTA_MUSH);
  if (options.cells != 0 && (options.cells < 8 || options.cells > SINEW_MAX_DEFORM_CELLS))
    throw Failure(SINEW_ERROR_ARGUMENT, "cells: expected 8 to " + std::to_string(SINEW_MAX_DEFORM_CELLS));
  check_at_most("rounds", options.rounds, SINEW_MAX_DEFORM_ROUNDS);
  check_at_most("tet_weights", options.tet_weights, SINEW_TET_WEIGHTS_DISTANCE);
  check_without(options.without, SINEW_WITHOUT_SMOOTHING);
  constexpr double kThousandths = 1000;
  if (options.stiffness != 0 &&
      !(options.stiffness >= 1 / kThousandths && options.stiffness <= SINEW_MAX_DEFORM_ENERGY / kThousandths))
    throw Failure(SINEW_ERROR_ARGUMENT, "stiffness: expected 0.001 to 1000, or 0 for the default");
  check_at_most("deform_as_drawn", options.deform_as_drawn, 1);
  if (method != SINEW_POSE_XPBD &&
      (options.stiffness != 0 || options.tet_weights != 0 || options.without != 0 || options.deform_as_drawn != 0))
    throw Failure(SINEW_ERROR_ARGUMENT,
                  "stiffness, tet_weights, deform_as_drawn and SINEW_WITHOUT_SMOOTHING need SINEW_POSE_XPBD");
  if (options.body_contact != 0 && method != SINEW_POSE_VOLUME && method != SINEW_POSE_XPBD)
    throw Failure(SINEW_ERROR_ARGUMENT, "body_contact needs SINEW_POSE_VOLUME or SINEW_POSE_XPBD");
  if (method < SINEW_POSE_VOLUME) {
    if (options.cells != 0 || options.rounds != 0)
      throw Failure(SINEW_ERROR_ARGUMENT, "cells and rounds need a corrected pose, SINEW_POSE_VOLUME or above");
    return std::nullopt;
  }
  sinew_deform_options out = SINEW_INIT(sinew_deform_options);
  out.cell_count = options.cells;
  out.round_count = options.rounds;
  out.body_contact = options.body_contact != 0 ? 1 : 0;
  out.energy = static_cast<uint32_t>(std::lround(kThousandths * options.stiffness));
  out.tet_weights = options.tet_weights;
  out.without = options.without;
  out.as_drawn = options.deform_as_drawn;
  if (method == SINEW_POSE_XPBD) out.method = SINEW_DEFORM_XPBD;
  if (method == SINEW_POSE_DELTA_MUSH) out.method = SINEW_DEFORM_DELTA_MUSH;
  return out;
}

// Progress over steps; each step may end the work.
inline auto steps_of(ProgressOfCaller* progress) {
  return [progress](size_t total) {
    return [progress, total, done = size_t{0}]() mutable { return progress->step(++done, total); };
  };
}

inline std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }
inline std::string file_of(const sinew_character& character) {
  return character.path.empty() ? character.character.name : character.path;
}

// The motion of a handle, as sinew_character_animate() plays it and sinew_character_map() maps from it.
inline bool plays_its_file(const sinew_character& from) {
  return from.clips.empty() && !from.path.empty() && !from.drop_animations;
}

// The clips that were added to a character.
inline MotionFile added_motion(const sinew_character& from) {
  Motion added = motion_of(from.character.joints);
  added.name = from.character.name;
  added.clips = from.clips;
  return {std::move(added), true};
}

// The mesh that moves with it; null: none, or one of several people.
inline const Character* body_of(const sinew_character& from, const MotionFile& motion) {
  return from.character.vertices.empty() || !motion.whole ? nullptr : &from.character;
}

// Throws Failure, and Error for names.
std::vector<Joint> joints_of(const sinew_skeleton* given);

//   picture  out: what the character's picture became; unchanged where it is of none
RiggedCharacter rig_of(const sinew_character& from, const sinew_character_rig_options& options,
                       ProgressOfCaller* progress, std::shared_ptr<const PictureCharacter>* picture);

// Seams as the C API tells them.
inline std::vector<sinew_character_seam> seams_of(const Seams& seams) {
  std::vector<sinew_character_seam> views;
  for (const Seam& seam : seams.seams)
    views.push_back({{static_cast<uint32_t>(seam.joints[0]), static_cast<uint32_t>(seam.joints[1])},
                     {seam.position.x, seam.position.y, seam.position.z},
                     static_cast<float>(seam.length)});
  return views;
}

}  // namespace sinew
#endif
