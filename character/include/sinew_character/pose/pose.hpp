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

// Validates a hierarchy. Throws Error for a cycle and for a parent that does not exist.
JointTree joint_tree(const Character& character);

// One pose: joints rotate about their rest position by XYZ Euler angles in degrees (R = Rz Ry Rx); children follow.
struct JointRotation {
  size_t joint = 0;
  double x = 0, y = 0, z = 0;
};
// Rotates each joint with a parent by `degrees`, called for x, y and z; a rotated root would only rotate the whole
// character.
std::vector<JointRotation> rotate_joints(const Character& character, const std::function<double()>& degrees);
std::vector<Affine> pose_palette(const Character& character, const std::vector<JointRotation>& rotations);
// Skins a character by linear blending (or dual quaternions) in the engine: unorm16 weights, the 12 strongest of a
// row; vertices without weight do not move. Returns the character with moved vertices and joints, without corner
// normals and glTF source, which describe the rest pose. Throws Error for missing weights or a joint that does not
// exist.
Character apply_pose(const Character& character, const std::vector<Affine>& palette, bool dual_quaternion = false);

// Returns the 12 strongest influences of a row as unorm16 with sum 65535; a row without weight has sum 0.
struct SkinArrays {
  std::vector<float> positions;           // [V x 3]
  std::vector<uint16_t> joints, weights;  // [V x influences]
  uint32_t influences = 1;
};

// Throws Error for missing weights or a joint that does not exist.
SkinArrays skin_arrays(const Character& character);
// Returns [J x 12]. Throws Error unless there is one matrix per joint.
std::vector<float> palette_array(const Character& character, const std::vector<Affine>& palette);
// Returns the character with its vertices at `positions` [V x 3] and its joints moved by the palette, without corner
// normals and glTF source, which belong to the rest pose.
Character posed_character(const Character& character, const std::vector<Affine>& palette,
                          const std::vector<float>& positions);

}  // namespace sinew
#endif
