// SPDX-License-Identifier: MIT
// Springs of a handle on the page: behind a clip, as files have it, and behind a character that the pointer drags.
#ifndef SINEW_WEB_SWINGING_HPP
#define SINEW_WEB_SWINGING_HPP

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "sinew/character.h"
#include "sinew_character/springs/spring_player.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::web {

// Plays the springs of a handle into its clips by play_springs(). Throws Error.
void swing(sinew_character* handle);
// A handle with a clip of `moving` alone, with the springs of `springs` played into it. Throws Error.
std::unique_ptr<sinew_character> swung(const sinew_character& moving, const sinew_character& springs, uint32_t clip);

// A pose that each joint's degrees about x, then y, then z make, [J x 3].
MotionFrame turned_frame(const std::vector<Joint>& rest, const float* degrees);

// How far the pointer has the whole character from where its pose has it.
struct Drag {
  Point3 move = {};
  double degrees = 0;  // about the axis that is up, around the first root
};

// Chains that follow a character while it is dragged, whether a clip plays or not.
class LiveSprings {
 public:
  // pose_at: of what plays; the chains begin as they are after a second of it, at `seconds`.
  LiveSprings(const Springs& springs, const std::vector<Joint>& rest, size_t up_axis,
              const std::function<MotionFrame(double seconds)>& pose_at, double seconds);

  // Pose times inverse bind of all joints, `passed` seconds after the frame before. Where the time of what plays goes back, as that of a loop does, the
  // chains do not feel it.
  std::vector<Affine> palette(MotionFrame pose, double seconds, double passed, const Drag& drag);

 private:
  Motion motion_;
  std::vector<size_t> roots_;
  size_t up_axis_;
  SpringPlayer springs_;
  double last_seconds_ = 0;
  Point3 last_root_ = {}, carried_ = {};  // how far loops have gone on
};

}  // namespace sinew::web
#endif
