// SPDX-License-Identifier: MIT
// A character and a motion that were written and came back: the same but for the order of joints and vertices.
#ifndef SINEW_TESTS_SUPPORT_SAME_CHARACTER_HPP
#define SINEW_TESTS_SUPPORT_SAME_CHARACTER_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

template <class Joints>
std::map<std::string, size_t> by_name(const Joints& joints) {
  std::map<std::string, size_t> numbers;
  for (size_t j = 0; j < joints.size(); ++j) numbers[joints[j].name] = j;
  return numbers;
}

// For vertices that are all at different positions.
inline std::vector<size_t> order_by_position(const Character& character) {
  std::vector<size_t> order(character.vertices.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto key = [&](size_t v) {
    const Vec3& p = character.vertices[v];
    return std::array<long, 3>{std::lround(1e4 * static_cast<double>(p.x)), std::lround(1e4 * static_cast<double>(p.y)),
                               std::lround(1e4 * static_cast<double>(p.z))};
  };
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return key(a) < key(b); });
  return order;
}

//   apart  of positions, at most
inline void expect_same_character(const Character& a, const Character& b, double apart) {
  ASSERT_EQ(a.joints.size(), b.joints.size());
  const std::map<std::string, size_t> other = by_name(b.joints);
  for (const Joint& joint : a.joints) {
    ASSERT_EQ(other.count(joint.name), 1u) << joint.name;
    const Joint& same = b.joints[other.at(joint.name)];
    EXPECT_LT(length(point(joint.position) - point(same.position)), apart) << joint.name;
    ASSERT_EQ(joint.parent < 0, same.parent < 0) << joint.name;
    if (joint.parent >= 0) {
      EXPECT_EQ(a.joints[static_cast<size_t>(joint.parent)].name, b.joints[static_cast<size_t>(same.parent)].name);
    }
  }
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  EXPECT_EQ(a.face_count(), b.face_count());
  const std::vector<size_t> first = order_by_position(a), second = order_by_position(b);
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_LT(length(point(a.vertices[first[i]]) - point(b.vertices[second[i]])), apart);
    std::map<std::string, float> weights;
    for (const Influence& one : a.influences[first[i]]) weights[a.joints[one.joint].name] += one.weight;
    for (const Influence& one : b.influences[second[i]]) weights[b.joints[one.joint].name] -= one.weight;
    for (const auto& [name, difference] : weights) EXPECT_NEAR(difference, 0, 1e-6) << name;
  }
}

// The first clips, which move something by 0.1 from where the joints of `rest` are.
//   apart, turned  of positions, and of 1 less the rotations' product, at most
inline void expect_same_clip(const Motion& a, const Motion& b, const Character& rest, double apart, double turned) {
  ASSERT_EQ(a.clips[0].frames.size(), b.clips[0].frames.size());
  const std::map<std::string, size_t> numbers = by_name(b.joints);
  double moved = 0;
  for (size_t f = 0; f < a.clips[0].frames.size(); ++f) {
    const WorldPose wanted = world_pose(a, a.clips[0].frames[f]), has = world_pose(b, b.clips[0].frames[f]);
    for (size_t j = 0; j < a.joints.size(); ++j) {
      const size_t k = numbers.at(a.joints[j].name);
      EXPECT_LT(length(wanted.positions[j] - has.positions[k]), apart) << a.joints[j].name << f;
      EXPECT_GT(std::abs(dot(wanted.rotations[j], has.rotations[k])), 1 - turned) << a.joints[j].name << f;
      moved = std::max(moved, length(wanted.positions[j] - point(rest.joints[j].position)));
    }
  }
  EXPECT_GT(moved, 0.1);
}

}  // namespace sinew
#endif
