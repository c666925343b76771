// SPDX-License-Identifier: MIT
// Poses of a skeleton: palettes (pose times inverse bind) and skinned meshes.
#ifndef SINEW_FORMATS_POSE_HPP
#define SINEW_FORMATS_POSE_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

using Mat34 = std::array<double, 12>;  // row-major 3x4

// Random poses of the yardstick (numpy's default_rng seeded with crc32(name), axis normal, angle uniform, limit 30..60
// degrees): [poses][joints] skinning matrices; `positions` scaled as the caller wants. Same draws as weights_eval.py.
std::vector<std::vector<Mat34>> random_poses(const Character& character, const std::string& name,
                                             const std::vector<std::array<double, 3>>& positions, int poses = 10);
// One pose: turn joints about their own rest position by XYZ Euler angles in degrees (R = Rz Ry Rx), children follow.
struct JointTurn {
  size_t joint = 0;
  double x = 0, y = 0, z = 0;
};
std::vector<Mat34> pose_palette(const Character& character, const std::vector<JointTurn>& turns);
// Skins with linear blend (or dual quaternions) through the engine's C API: weights as unorm16, the 12 strongest of a
// row, rows without weight stay where they are. Returns the character with moved vertices and joints; its corner
// normals and glTF source are dropped, since they describe the rest pose. Throws Error for missing weights or a joint
// that does not exist.
Character apply_pose(const Character& character, const std::vector<Mat34>& palette, bool dual_quaternion = false);

}  // namespace sinew
#endif
