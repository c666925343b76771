// SPDX-License-Identifier: MIT
// The job of `sinew bake` for one character: training poses, test poses, and shapes that are animated in the file's
// clips.
#ifndef SINEW_CHARACTER_BAKE_JOB_HPP
#define SINEW_CHARACTER_BAKE_JOB_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sinew_character/bake/bake.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct BakeJobOptions {
  std::string character;  // its file, for messages
  sinew_deform_options deform = SINEW_INIT(sinew_deform_options);
  size_t poses = 1500, shapes = 8;  // maximum number of shapes per bend, each in one or two directions
  uint64_t seed = 1;
  double limit = 60;                     // degrees
  double error = 2e-3;                   // BakeSettings::error
  std::optional<std::string> animation;  // train on this clip of `own`, by name or number; nullopt: random poses
};

struct BakedCharacter {
  Morphs morphs;  // with keys for the animations of `own`
  size_t learnt_poses = 0, held_out_poses = 0;
  BakeError learned, held_out;
};

//   own    the file's own animations, or none
//   steps  as StepsOf of animate_job.hpp
// Throws Error.
BakedCharacter bake_character(const Character& character, const OwnMotion& own, const BakeJobOptions& options,
                              const std::function<std::function<bool()>(size_t)>& steps);
// Computes the drivers' weights in the clips of a motion.
void play_in_animations(const OwnMotion& own, const Character& character, Morphs* morphs);

}  // namespace sinew
#endif
