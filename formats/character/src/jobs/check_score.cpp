// SPDX-License-Identifier: MIT
// How far weights are from what three methods would give: the bundled model, the heat method and the nearest bone.
#include <algorithm>
#include <cmath>

#include "sinew_character/bind.hpp"
#include "sinew_character/bone_distance.hpp"
#include "sinew_character/check_output.hpp"
#include "sinew_character/models.hpp"

namespace sinew {
namespace {

using Rows = std::vector<std::vector<Influence>>;

// [J] joints with weight.
std::vector<char> used_joints(const Character& character) {
  std::vector<char> used(character.joints.size(), 0);
  for (const auto& row : character.influences)
    for (const Influence& one : row)
      if (one.weight > 0) used[one.joint] = 1;
  return used;
}

Rows nearest_bones(const Character& character, const std::vector<char>& used) {
  const BoneDistance distance(character);
  Rows rows;
  for (const Vec3& vertex : character.vertices) {
    size_t nearest = used.size();
    double least = 0;
    for (size_t j = 0; j < used.size(); ++j) {
      if (used[j] == 0) continue;
      const double here = distance(vertex, j);
      if (nearest == used.size() || here < least) nearest = j, least = here;
    }
    rows.push_back({{static_cast<uint32_t>(nearest), 1.0F}});
  }
  return rows;
}

// Mean over vertices with weight of the sum over joints of the differences, 0..2; rows brought to a sum of 1.
double difference(const Rows& a, const Rows& b, size_t joint_count) {
  std::vector<double> row(joint_count, 0);
  double sum = 0;
  size_t count = 0;
  for (size_t v = 0; v < a.size(); ++v) {
    double all = 0, apart = 0;
    for (const Influence& one : a[v]) all += static_cast<double>(one.weight);
    if (!(all > 0)) continue;
    for (const Influence& one : a[v]) row[one.joint] += static_cast<double>(one.weight) / all;
    for (const Influence& one : b[v]) row[one.joint] -= static_cast<double>(one.weight);
    for (const Rows* rows : {&a, &b})
      for (const Influence& one : (*rows)[v]) apart += std::abs(row[one.joint]), row[one.joint] = 0;
    sum += apart;
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

}  // namespace

double weight_score(const Character& character) {
  const std::vector<char> used = used_joints(character);
  if (character.vertices.empty() || std::count(used.begin(), used.end(), 1) == 0) return 0;
  const std::unique_ptr<LoadedModel> model = load_model("");
  BindOptions options;
  for (const char one : used) options.joint_flags.push_back(one != 0 ? uint8_t{0} : uint8_t{SINEW_JOINT_NEVER});
  double sum = difference(character.influences, nearest_bones(character, used), used.size());
  for (const uint32_t method : {SINEW_METHOD_MODEL, SINEW_METHOD_HEAT}) {
    options.method = method;
    options.model = method == SINEW_METHOD_MODEL ? &model->model : nullptr;
    sum += difference(character.influences, bind(character, options).influences, used.size());
  }
  return 100 * (1 - sum / 6);
}

}  // namespace sinew
