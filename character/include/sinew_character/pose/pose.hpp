// SPDX-License-Identifier: MIT
// Poses of a skeleton: palettes (pose times inverse bind) and skinned meshes.
#ifndef SINEW_CHARACTER_POSE_HPP
#define SINEW_CHARACTER_POSE_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Of a hierarchy that is one: throws Error for a cycle and for a parent that does not exist.
JointTree joint_tree(const Character& character);

// One pose: turn joints about their own rest position by XYZ Euler angles in degrees (R = Rz Ry Rx), children follow.
struct JointRotation {
  size_t joint = 0;
  double x = 0, y = 0, z = 0;
};
// Of every joint that has a parent, x, y and z in turn by `degrees`; a rotated root only rotates the whole character.
std::vector<JointRotation> rotate_joints(const Character& character, const std::function<double()>& degrees);
std::vector<Affine> pose_palette(const Character& character, const std::vector<JointRotation>& rotations);
// Skins with linear blend (or dual quaternions) through the engine's C API: weights as unorm16, the 12 strongest of a
// row, rows without weight stay where they are. Returns the character with moved vertices and joints; its corner
// normals and glTF source are dropped, since they describe the rest pose. Throws Error for missing weights or a joint
// that does not exist.
Character apply_pose(const Character& character, const std::vector<Affine>& palette, bool dual_quaternion = false);

// The 12 strongest influences of a row as unorm16 with sum 65535; a row without weight has sum 0.
struct SkinArrays {
  std::vector<float> positions;           // [V x 3]
  std::vector<uint16_t> joints, weights;  // [V x influences]
  uint32_t influences = 1;
};

// Throws Error for missing weights or a joint that does not exist.
SkinArrays skin_arrays(const Character& character);
// [J x 12]. Throws Error where there is not one matrix a joint.
std::vector<float> palette_array(const Character& character, const std::vector<Affine>& palette);
// The character with its vertices at `positions` [V x 3] and its joints moved by the palette; what belongs to the rest pose alone,
// corner normals and the glTF source, is dropped.
Character posed_character(const Character& character, const std::vector<Affine>& palette,
                          const std::vector<float>& positions);

}  // namespace sinew
#endif
