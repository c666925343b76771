// SPDX-License-Identifier: MIT
// Sides in names, and the plane that a skeleton is its own mirror image about.
#include "sinew_character/joint_mirror.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

namespace sinew {
namespace {

constexpr float kTolerance = 0.005f;  // of the longest side

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_letter(char c) { return is_lower(c) || is_upper(c); }

// Where a name says its side: [begin, begin + length) and what stands there on the other side.
struct SideWord {
  Side side = Side::kNone;
  size_t begin = 0, length = 0;
  std::string_view other;
};

SideWord side_word(const std::string& name) {
  struct Pair {
    std::string_view left, right;
  };
  constexpr std::array<Pair, 3> kWords = {{{"Left", "Right"}, {"left", "right"}, {"LEFT", "RIGHT"}}};
  for (const Pair& pair : kWords) {
    for (const bool left : {true, false}) {
      const std::string_view word = left ? pair.left : pair.right;
      const size_t at = name.find(word);
      if (at == std::string::npos) continue;
      // Not within a word: bright, cleft.
      if (is_lower(word[0]) && at > 0 && is_letter(name[at - 1])) continue;
      if (is_lower(word[1]) && at + word.size() < name.size() && is_lower(name[at + word.size()])) continue;
      return {left ? Side::kLeft : Side::kRight, at, word.size(), left ? pair.right : pair.left};
    }
  }
  constexpr std::array<Pair, 2> kLetters = {{{"L", "R"}, {"l", "r"}}};
  for (size_t i = 0; i < name.size(); ++i) {
    const bool free_before = i == 0 || !is_letter(name[i - 1]);
    const bool free_behind = i + 1 == name.size() || !is_letter(name[i + 1]);
    const bool word_follows = i == 0 && i + 2 < name.size() && is_upper(name[1]) && is_lower(name[2]);
    if (!free_before || (!free_behind && !word_follows)) continue;
    for (const Pair& pair : kLetters) {
      if (name[i] == pair.left[0]) return {Side::kLeft, i, 1, pair.right};
      if (name[i] == pair.right[0]) return {Side::kRight, i, 1, pair.left};
    }
  }
  return {};
}

float distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, std::hypot(a.y - b.y, a.z - b.z)); }

float longest_side(const std::vector<Joint>& joints) {
  float longest = 0;
  for (uint32_t axis = 0; axis < 3; ++axis) {
    float low = INFINITY, high = -INFINITY;
    for (const Joint& joint : joints) {
      low = std::min(low, component(joint.position, axis));
      high = std::max(high, component(joint.position, axis));
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

// [J] index of the joint named for the other side, -1 without one.
std::vector<int32_t> partners_by_name(const std::vector<Joint>& joints) {
  std::map<std::string, int32_t> by_name;
  for (size_t j = 0; j < joints.size(); ++j) by_name.emplace(joints[j].name, static_cast<int32_t>(j));
  std::vector<int32_t> partners(joints.size(), -1);
  for (size_t j = 0; j < joints.size(); ++j) {
    if (side_of_name(joints[j].name) == Side::kNone) continue;
    const auto found = by_name.find(other_side_name(joints[j].name));
    if (found != by_name.end()) partners[j] = found->second;
  }
  return partners;
}

float plane_of(const std::vector<Joint>& joints, const std::vector<int32_t>& named, uint32_t axis) {
  std::vector<float> middles;
  for (size_t j = 0; j < joints.size(); ++j)
    if (named[j] >= 0 && side_of_name(joints[j].name) == Side::kLeft)
      middles.push_back(
          component(joints[j].position, axis) +
          (component(joints[static_cast<size_t>(named[j])].position, axis) - component(joints[j].position, axis)) / 2);
  if (!middles.empty()) {
    std::nth_element(middles.begin(), middles.begin() + static_cast<ptrdiff_t>(middles.size() / 2), middles.end());
    return middles[middles.size() / 2];
  }
  double sum = 0;
  for (const Joint& joint : joints) sum += static_cast<double>(component(joint.position, axis));
  return static_cast<float>(sum / static_cast<double>(joints.size()));
}

JointMirror mirror_across(const std::vector<Joint>& joints, const std::vector<int32_t>& named, uint32_t axis,
                          float tolerance) {
  JointMirror mirror;
  mirror.axis = axis;
  mirror.plane = plane_of(joints, named, axis);
  std::vector<int32_t>& partners = mirror.partners;
  partners.assign(joints.size(), -1);
  for (size_t j = 0; j < joints.size(); ++j) {
    const Vec3 image = mirrored(joints[j].position, axis, mirror.plane);
    if (named[j] >= 0) {
      if (distance(joints[static_cast<size_t>(named[j])].position, image) <= tolerance) partners[j] = named[j];
      continue;
    }
    if (std::fabs(component(joints[j].position, axis) - mirror.plane) <= tolerance / 2) {
      partners[j] = static_cast<int32_t>(j);
      continue;
    }
    float least = tolerance;
    for (size_t k = 0; k < joints.size(); ++k) {
      const float gap = distance(joints[k].position, image);
      if (k == j || named[k] >= 0 || gap > least) continue;
      least = gap;
      partners[j] = static_cast<int32_t>(k);
    }
  }
  const auto partner_of = [&](int32_t j) { return j < 0 ? -1 : partners[static_cast<size_t>(j)]; };
  mirror.exact = true;
  for (size_t j = 0; j < joints.size(); ++j) {
    if (partner_of(partners[j]) != static_cast<int32_t>(j)) partners[j] = -1;
    if (partners[j] < 0) mirror.exact = false;
  }
  for (size_t j = 0; j < joints.size() && mirror.exact; ++j)
    mirror.exact = partner_of(joints[j].parent) == joints[static_cast<size_t>(partners[j])].parent;
  return mirror;
}

}  // namespace

float& component(Vec3* p, uint32_t axis) { return axis == 0 ? p->x : axis == 1 ? p->y : p->z; }
float component(const Vec3& p, uint32_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

Vec3 mirrored(const Vec3& p, uint32_t axis, float plane) {
  Vec3 image = p;
  component(&image, axis) = 2 * plane - component(p, axis);
  return image;
}

Side side_of_name(const std::string& name) { return side_word(name).side; }

std::string other_side_name(const std::string& name) {
  const SideWord word = side_word(name);
  std::string other = name;
  if (word.side != Side::kNone) other.replace(word.begin, word.length, word.other);
  return other;
}

float mirror_plane(const std::vector<Joint>& joints, uint32_t axis) {
  return joints.empty() ? 0 : plane_of(joints, partners_by_name(joints), axis);
}

JointMirror find_joint_mirror(const std::vector<Joint>& joints) {
  JointMirror best;
  best.partners.assign(joints.size(), -1);
  if (joints.empty()) return best;
  const std::vector<int32_t> named = partners_by_name(joints);
  const float tolerance = kTolerance * longest_side(joints);
  ptrdiff_t most = -1;
  for (const uint32_t axis : {0u, 2u, 1u}) {
    JointMirror mirror = mirror_across(joints, named, axis, tolerance);
    ptrdiff_t found = mirror.exact ? 1 : 0;
    for (size_t j = 0; j < joints.size(); ++j) found += mirror.partners[j] < 0 ? 0 : named[j] >= 0 ? 4 : 2;
    if (found <= most) continue;
    most = found;
    best = std::move(mirror);
  }
  return best;
}

}  // namespace sinew
