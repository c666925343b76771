// SPDX-License-Identifier: MIT
// Views of a Character for the engine, with the arrays that they point to.
#ifndef SINEW_CHARACTER_ENGINE_VIEWS_HPP
#define SINEW_CHARACTER_ENGINE_VIEWS_HPP

#include <cstdint>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Holds pointers into `character` and into itself: neither may move while the views are used.
struct EngineViews {
  EngineViews(const Character& character, const std::vector<uint8_t>& joint_flags, Axis up_axis = Axis::kY);
  EngineViews(const EngineViews&) = delete;
  EngineViews& operator=(const EngineViews&) = delete;

  std::vector<float> positions, joint_positions;
  std::vector<int32_t> parents;
  std::vector<uint8_t> flags;
  sinew_mesh mesh = {};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
};

// Joints as the engine's skeleton, with their names. Holds pointers into `joints` and into itself, as above.
struct SkeletonView {
  explicit SkeletonView(const std::vector<Joint>& joints);
  SkeletonView(const SkeletonView&) = delete;
  SkeletonView& operator=(const SkeletonView&) = delete;

  std::vector<float> positions;
  std::vector<int32_t> parents;
  std::vector<const char*> names;
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
};

// Converts 0 = Y, 1 = Z to the engine's sinew_up.
inline uint32_t engine_up(MaybeAxis up) {
  if (!up) return SINEW_UP_AUTO;
  return *up == Axis::kX ? SINEW_UP_X : *up == Axis::kY ? SINEW_UP_Y : SINEW_UP_Z;
}
// Throws Error if there is nothing to bind or a limit of the engine is exceeded.
void check_bindable(const Character& character);
// Throws Error with the character's name if the status is not SINEW_OK.
void throw_status(const Character& character, sinew_status status);

}  // namespace sinew
#endif
