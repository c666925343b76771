// SPDX-License-Identifier: MIT
// Weights of corrective shapes, and meshes under them.
#include "sinew_formats/morphs.hpp"

#include <algorithm>

#include "sinew_formats/base/affine.hpp"

namespace sinew {

Quaternion joint_rotation(const std::vector<Joint>& joints, const std::vector<Affine>& palette, size_t joint) {
  const Quaternion own = quaternion_of(rotation_part(palette.at(joint)));
  const int parent = joints.at(joint).parent;
  if (parent < 0) return own;
  return normalized(multiply(conjugate(quaternion_of(rotation_part(palette.at(static_cast<size_t>(parent))))), own));
}

std::vector<Quaternion> joint_rotations(const std::vector<Joint>& joints, const std::vector<Affine>& palette) {
  std::vector<Quaternion> rotations;
  for (size_t j = 0; j < joints.size(); ++j) rotations.push_back(joint_rotation(joints, palette, j));
  return rotations;
}

std::array<double, 9> term_values(const MorphTerm& term, const std::vector<Quaternion>& rotations) {
  std::array<double, 9> values{};
  if (term.joint == term.with) {
    values = rotation_of(rotations.at(term.joint));
    for (size_t i = 0; i < 9; i += 4) values[i] -= 1;
    return values;
  }
  const Quaternion &a = rotations.at(term.joint), &b = rotations.at(term.with);
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) values[3 * r + c] = (2 * a[3] * a[r]) * (2 * b[3] * b[c]);
  return values;
}

std::vector<double> driver_sums(const MorphDriver& driver, const std::vector<Quaternion>& rotations) {
  std::vector<double> sums(driver.sum_count(), 0.0);
  for (const MorphTerm& term : driver.terms) {
    const std::array<double, 9> values = term_values(term, rotations);
    for (size_t s = 0; s < sums.size(); ++s)
      for (size_t i = 0; i < 9; ++i) sums[s] += term.factors.at(s)[i] * values[i];
  }
  return sums;
}

std::vector<double> driver_weights(const MorphDriver& driver, const std::vector<Quaternion>& rotations) {
  const std::vector<double> sums = driver_sums(driver, rotations);
  std::vector<double> weights;
  for (const MorphWeight& one : driver.weights) weights.push_back(std::clamp(one.scale * sums.at(one.sum), 0.0, 1.0));
  return weights;
}

std::vector<float> shape_weights(const std::vector<Joint>& joints, const Morphs& morphs,
                                 const std::vector<Affine>& palette) {
  std::vector<float> weights(morphs.shapes.size(), 0.0f);
  if (morphs.drivers.empty()) return weights;
  const std::vector<Quaternion> rotations = joint_rotations(joints, palette);
  for (const MorphDriver& driver : morphs.drivers) {
    const std::vector<double> values = driver_weights(driver, rotations);
    for (size_t i = 0; i < values.size(); ++i) weights.at(driver.weights[i].shape) = static_cast<float>(values[i]);
  }
  return weights;
}

Affine blended_matrix(const std::vector<Influence>& row, const std::vector<Affine>& palette) {
  Affine sum{};
  double total = 0;
  for (const Influence& influence : row) {
    for (size_t i = 0; i < 12; ++i) sum[i] += static_cast<double>(influence.weight) * palette.at(influence.joint)[i];
    total += static_cast<double>(influence.weight);
  }
  if (!(total > 0)) return kIdentity;
  for (double& value : sum) value /= total;
  return sum;
}

std::vector<Vec3> morphed_pose(const Character& character, const Morphs& morphs, const std::vector<float>& weights,
                               const std::vector<Affine>& palette) {
  std::vector<Vec3> positions = character.vertices;
  for (size_t s = 0; s < morphs.shapes.size(); ++s) {
    if (weights.at(s) == 0) continue;
    const MorphShape& shape = morphs.shapes[s];
    for (size_t i = 0; i < shape.vertices.size(); ++i) {
      Vec3& position = positions.at(shape.vertices[i]);
      position.x += weights[s] * shape.moves[i].x;
      position.y += weights[s] * shape.moves[i].y;
      position.z += weights[s] * shape.moves[i].z;
    }
  }
  for (size_t v = 0; v < positions.size(); ++v) {
    const Vec3& p = positions[v];
    const std::array<double, 3> moved =
        transform_point(blended_matrix(character.influences.at(v), palette), static_cast<double>(p.x),
                        static_cast<double>(p.y), static_cast<double>(p.z));
    positions[v] = {static_cast<float>(moved[0]), static_cast<float>(moved[1]), static_cast<float>(moved[2])};
  }
  return positions;
}

}  // namespace sinew
