// SPDX-License-Identifier: MIT
// Palettes of given poses, and posed characters; the skinning itself is the engine's.
#include "sinew_character/pose/pose.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "sinew/sinew.h"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

Point3 rest_position(const Joint& joint) {
  return {static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
          static_cast<double>(joint.position.z)};
}

// One row for the C API: the strongest `slots` influences as unorm16 with sum 65535. The rounding remainder (at most
// half a step per slot) goes to the largest, which holds at least 65535 / 12. A row without weight is left as it is.
void quantize_row(const std::vector<Influence>& row, size_t slots, uint16_t* joints, uint16_t* weights) {
  std::vector<Influence> kept;
  for (const Influence& influence : row)
    if (influence.weight > 0) kept.push_back(influence);
  std::stable_sort(kept.begin(), kept.end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  if (kept.size() > slots) kept.resize(slots);
  double sum = 0;
  for (const Influence& influence : kept) sum += static_cast<double>(influence.weight);
  if (kept.empty() || !std::isfinite(sum)) return;
  int remainder = 65535;
  for (size_t s = 0; s < kept.size(); ++s) {
    const double share = static_cast<double>(kept[s].weight) / sum;
    joints[s] = static_cast<uint16_t>(kept[s].joint);
    weights[s] = static_cast<uint16_t>(std::lround(share * 65535));
    remainder -= weights[s];
  }
  weights[0] = static_cast<uint16_t>(weights[0] + remainder);
}

}  // namespace

JointTree joint_tree(const Character& character) {
  const size_t joint_count = character.joints.size();
  for (const Joint& joint : character.joints)
    if (joint.parent >= static_cast<int>(joint_count))
      throw Error(character.name + ": joint '" + joint.name + "' names parent " + std::to_string(joint.parent) +
                  ", but there are " + std::to_string(joint_count) + " joints");
  JointTree tree(character.joints);
  const size_t left = joint_count - tree.parents_first.size();
  if (left != 0)
    throw Error(character.name + ": the joint parents form a cycle (" + std::to_string(left) +
                " descendants); give every joint a path to a root");
  return tree;
}

std::vector<JointRotation> rotate_joints(const Character& character, const std::function<double()>& degrees) {
  std::vector<JointRotation> rotations;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    if (character.joints[j].parent < 0) continue;
    JointRotation rotation;
    rotation.joint = j;
    rotation.x = degrees();
    rotation.y = degrees();
    rotation.z = degrees();
    rotations.push_back(rotation);
  }
  return rotations;
}

std::vector<Affine> pose_palette(const Character& character, const std::vector<JointRotation>& rotations) {
  const std::vector<size_t> order = joint_tree(character).parents_first;
  std::vector<Rotation> local(character.joints.size(), kNoRotation);
  for (const JointRotation& rotation : rotations) {
    if (rotation.joint >= character.joints.size()) {
      throw Error(character.name + ": a pose rotates joint " + std::to_string(rotation.joint) + ", but there are " +
                  std::to_string(character.joints.size()) + " joints");
    }
    const Rotation rx = axis_rotation({1, 0, 0}, rotation.x * kRadiansPerDegree);
    const Rotation ry = axis_rotation({0, 1, 0}, rotation.y * kRadiansPerDegree);
    const Rotation rz = axis_rotation({0, 0, 1}, rotation.z * kRadiansPerDegree);
    local[rotation.joint] = multiply(multiply(rz, multiply(ry, rx)), local[rotation.joint]);
  }
  std::vector<Affine> palette(character.joints.size());
  for (size_t j : order) {
    const Affine m = rotation_about(local[j], rest_position(character.joints[j]));
    const int parent = character.joints[j].parent;
    palette[j] = parent < 0 ? m : multiply(palette[static_cast<size_t>(parent)], m);
  }
  return palette;
}

SkinArrays skin_arrays(const Character& character) {
  const size_t vertex_count = character.vertices.size(), joint_count = character.joints.size();
  if (character.influences.size() != vertex_count) {
    throw Error(character.name + ": posing needs weights for each of its " + std::to_string(vertex_count) +
                " vertices, found " + std::to_string(character.influences.size()) + " rows; bind it first");
  }
  size_t slots = 1;
  for (size_t v = 0; v < vertex_count; ++v) {
    for (const Influence& influence : character.influences[v]) {
      if (influence.joint >= joint_count) {
        throw Error(character.name + ": vertex " + std::to_string(v) + " is bound to joint " +
                    std::to_string(influence.joint) + ", but there are " + std::to_string(joint_count) + " joints");
      }
    }
    slots = std::max(slots, character.influences[v].size());
  }
  slots = std::min<size_t>(slots, SINEW_MAX_INFLUENCES);
  SkinArrays arrays;
  arrays.influences = static_cast<uint32_t>(slots);
  arrays.joints.resize(vertex_count * slots);
  arrays.weights.resize(vertex_count * slots);
  for (size_t v = 0; v < vertex_count; ++v)
    quantize_row(character.influences[v], slots, arrays.joints.data() + v * slots, arrays.weights.data() + v * slots);
  arrays.positions.reserve(3 * vertex_count);
  for (const Vec3& p : character.vertices) arrays.positions.insert(arrays.positions.end(), {p.x, p.y, p.z});
  return arrays;
}

std::vector<float> palette_array(const Character& character, const std::vector<Affine>& palette) {
  const size_t joint_count = character.joints.size();
  if (palette.size() != joint_count) {
    throw Error(character.name + ": a pose needs one matrix per joint, expected " + std::to_string(joint_count) +
                ", found " + std::to_string(palette.size()));
  }
  std::vector<float> matrices;
  matrices.reserve(12 * joint_count);
  for (const Affine& m : palette)
    for (double x : m) matrices.push_back(static_cast<float>(x));
  return matrices;
}

Character posed_character(const Character& character, const std::vector<Affine>& palette,
                          const std::vector<float>& positions) {
  Character posed = character;
  for (size_t v = 0; v < posed.vertices.size(); ++v)
    posed.vertices[v] = {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
  for (size_t j = 0; j < posed.joints.size(); ++j) {
    const auto [x, y, z] = rest_position(character.joints[j]);
    posed.joints[j].position = to_vec3(transform_point(palette[j], x, y, z));
  }
  // Both belong to the rest pose: normals would shade wrongly, and the glTF source holds the rest positions.
  posed.corner_normals.clear();
  posed.gltf.reset();
  return posed;
}

Character apply_pose(const Character& character, const std::vector<Affine>& palette, bool dual_quaternion) {
  SkinArrays arrays = skin_arrays(character);
  const std::vector<float> matrices = palette_array(character, palette);
  const uint32_t vertex_count = static_cast<uint32_t>(character.vertices.size());
  std::vector<uint8_t> bound(vertex_count, 1);
  for (size_t v = 0; v < vertex_count; ++v) {
    uint16_t& strongest = arrays.weights[v * arrays.influences];
    bound[v] = strongest != 0;
    if (strongest == 0) strongest = 65535;  // the API wants a full row; the vertex is put back below
  }
  std::vector<float> moved(arrays.positions.size());
  const sinew_skin skin = {arrays.joints.data(), arrays.weights.data(), arrays.influences, SINEW_WEIGHT_UNORM16};
  const auto pose_skin = dual_quaternion ? sinew_skin_dual_quaternion : sinew_skin_linear;
  const sinew_status status = pose_skin(arrays.positions.data(), vertex_count, &skin, matrices.data(),
                                        static_cast<uint32_t>(character.joints.size()), moved.data());
  if (status != SINEW_OK) throw Error(character.name + ": posing failed: " + sinew_status_text(status));
  for (size_t v = 0; v < vertex_count; ++v)
    if (!bound[v])
      std::copy_n(arrays.positions.begin() + static_cast<std::ptrdiff_t>(3 * v), 3,
                  moved.begin() + static_cast<std::ptrdiff_t>(3 * v));
  return posed_character(character, palette, moved);
}

}  // namespace sinew
