// SPDX-License-Identifier: MIT
// A file's mesh, skeleton and animations, checked; how far its weights are from what three methods would give.
#include <algorithm>
#include <cmath>

#include "sinew_character/bind/bind.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/check/check_output.hpp"
#include "sinew_character/check/label_check.hpp"
#include "sinew_character/jobs/character_file.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

// None is fine: the file itself was read before.
Motion motion_in(const std::string& path, const Character& character) {
  if (!has_use(path, kReadsMotion)) return motion_of(character.joints);
  try {
    return read_motion(path);
  } catch (const OutOfMemory&) {
    throw;
  } catch (const Error&) {
    return motion_of(character.joints);
  }
}

}  // namespace

CheckedFile check_file(const std::string& path, const CheckOptions& options) {
  CheckedFile out;
  out.file = path;
  out.character = open_character(path).character;
  if (out.character.joints.empty()) throw Error(path + ": no skeleton to check; make one with sinew rig");
  out.motion = motion_in(path, out.character);
  out.check = check_rig(out.character, &out.motion, options);
  return out;
}

void check_against(const std::string& path, const CheckOptions& options, CheckedFile* file) {
  CheckedFile older = check_file(path, options);
  file->before = std::move(older.check);
  file->joints_before = std::move(older.character.joints);
  file->change = check_change(*file->before, file->joints_before, file->check, file->character.joints);
}

// How far weights are from what three methods would give: the bundled model, the heat method and the nearest bone.

namespace {

using Rows = std::vector<std::vector<Influence>>;

// [J] joints that may get weight, by their names and positions, since the weights are what is scored.
std::vector<char> usable_joints(const Character& character) {
  std::vector<char> usable;
  for (const uint8_t flags : choose_joints(character, JointsFrom::kNames).flags)
    usable.push_back((flags & SINEW_JOINT_NEVER) == 0 ? 1 : 0);
  return usable;
}

Rows nearest_bones(const Character& character, const std::vector<char>& usable) {
  const BoneDistance distance(character);
  Rows rows;
  for (const Vec3& vertex : character.vertices) {
    size_t nearest = usable.size();
    double least = 0;
    for (size_t j = 0; j < usable.size(); ++j) {
      if (usable[j] == 0) continue;
      const double here = distance(vertex, j);
      if (nearest == usable.size() || here < least) nearest = j, least = here;
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
  const bool bound = std::any_of(character.influences.begin(), character.influences.end(), [](const auto& row) {
    return std::any_of(row.begin(), row.end(), [](const Influence& one) { return one.weight > 0; });
  });
  const std::vector<char> usable = usable_joints(character);
  if (!bound || std::count(usable.begin(), usable.end(), 1) == 0) return 0;
  const std::unique_ptr<LoadedModel> model = load_model("");
  BindOptions options;
  for (const char one : usable) options.joint_flags.push_back(one != 0 ? uint8_t{0} : uint8_t{SINEW_JOINT_NEVER});
  double sum = difference(character.influences, nearest_bones(character, usable), usable.size());
  for (const uint32_t method : {SINEW_METHOD_MODEL, SINEW_METHOD_HEAT}) {
    options.method = method;
    options.model = method == SINEW_METHOD_MODEL ? &model->model : nullptr;
    sum += difference(character.influences, bind(character, options).influences, usable.size());
  }
  return 100 * (1 - sum / 6);
}

}  // namespace sinew
