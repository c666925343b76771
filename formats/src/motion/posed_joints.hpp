// SPDX-License-Identifier: MIT
// Joints given by their positions and rotations in the world, frame by frame.
#ifndef SINEW_FORMATS_MOTION_POSED_JOINTS_HPP
#define SINEW_FORMATS_MOTION_POSED_JOINTS_HPP

#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// [frames][joints], the same numbers of both.
struct PosedJoints {
  std::vector<std::vector<Point3>> positions;
  std::vector<std::vector<Quaternion>> rotations;  // against a rest pose whose axes are the world's
};

// One clip. A joint's parent carries it: seen from the parent's axes it never moves, which also gives the offset at rest. Names are those of the
// named skeleton with as many joints whose parents carry them; for others, parents are guessed, with a note, and
// names are joint_0 and so on. Throws Error, which begins with `file`, where a joint is carried by none that comes
// before it.
//   joints  at least one frame and one joint
Motion motion_of_posed_joints(const std::string& file, const PosedJoints& joints);

}  // namespace sinew
#endif
