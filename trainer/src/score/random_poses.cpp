// SPDX-License-Identifier: MIT
// Random poses, draw by draw those of numpy.
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "score/numpy.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/evaluate.hpp"

namespace sinew {

std::vector<std::vector<Affine>> random_poses(const Character& character, const std::string& name,
                                              const std::vector<std::array<double, 3>>& positions, int poses) {
  constexpr double low_limit = 30, high_limit = 60;
  const size_t joint_count = character.joints.size();
  const size_t pose_count = poses > 0 ? static_cast<size_t>(poses) : 0;
  if (positions.size() != joint_count) {
    throw Error(name + ": random poses need one position per joint, expected " + std::to_string(joint_count) +
                ", found " + std::to_string(positions.size()));
  }
  const std::vector<size_t> order = joint_tree(character).parents_first;

  const auto* bytes = reinterpret_cast<const Bytef*>(name.data());
  NumpyRandom random(static_cast<uint64_t>(crc32(crc32(0, nullptr, 0), bytes, static_cast<uInt>(name.size()))));

  // The draws go joint by joint in the order of names, so that the order of joints in the file does not change the
  // poses. Bytes of UTF-8 sort like code points.
  std::vector<size_t> by_name(joint_count);
  for (size_t j = 0; j < joint_count; ++j) by_name[j] = j;
  std::stable_sort(by_name.begin(), by_name.end(),
                   [&](size_t a, size_t b) { return character.joints[a].name < character.joints[b].name; });
  std::vector<std::vector<Rotation>> turns(pose_count, std::vector<Rotation>(joint_count));
  std::vector<std::array<double, 3>> axes(pose_count);
  for (size_t j : by_name) {
    for (std::array<double, 3>& axis : axes) {
      for (double& x : axis) x = random.normal();
      const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
      for (double& x : axis) x /= length;
    }
    for (size_t k = 0; k < pose_count; ++k) {
      // np.linspace(30, 60, poses); a single pose takes the wide end.
      const double limit =
          k + 1 == pose_count
              ? high_limit
              : static_cast<double>(k) * ((high_limit - low_limit) / static_cast<double>(pose_count - 1)) + low_limit;
      const double angle = random.uniform(-1, 1) * (limit * (std::numbers::pi / 180));
      turns[k][j] = axis_rotation(axes[k], character.joints[j].parent < 0 ? 0 : angle);
    }
  }

  std::vector<std::vector<Affine>> result(pose_count, std::vector<Affine>(joint_count));
  for (size_t k = 0; k < pose_count; ++k) {
    for (size_t j : order) {
      const Affine local = rotation_about(turns[k][j], positions[j]);
      const int parent = character.joints[j].parent;
      result[k][j] = parent < 0 ? local : multiply(result[k][static_cast<size_t>(parent)], local);
    }
  }
  return result;
}

}  // namespace sinew
