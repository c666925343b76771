// SPDX-License-Identifier: MIT
// Which vertices a joint holds and how high a character is: chains and colliders are fitted to them.
#ifndef SINEW_SPRINGS_BODY_SKIN_HPP
#define SINEW_SPRINGS_BODY_SKIN_HPP

#include <algorithm>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/base/segment.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// [J] the vertices whose largest weight is the joint's.
inline std::vector<std::vector<uint32_t>> held_vertices(const Character& character) {
  std::vector<std::vector<uint32_t>> held(character.joints.size());
  for (size_t v = 0; v < character.influences.size(); ++v) {
    const Influence* most = nullptr;
    for (const Influence& one : character.influences[v])
      if (most == nullptr || one.weight > most->weight) most = &one;
    if (most != nullptr && most->weight > 0) held[most->joint].push_back(static_cast<uint32_t>(v));
  }
  return held;
}

// [J] the vertices of which a joint has at least half of the largest weight that it has anywhere: a joint may share all of its skin with the body.
inline std::vector<std::vector<uint32_t>> followers_of(const Character& character) {
  std::vector<float> largest(character.joints.size(), 0);
  for (const std::vector<Influence>& row : character.influences)
    for (const Influence& one : row) largest[one.joint] = std::max(largest[one.joint], one.weight);
  std::vector<std::vector<uint32_t>> followers(character.joints.size());
  for (size_t v = 0; v < character.influences.size(); ++v)
    for (const Influence& one : character.influences[v])
      if (one.weight > 0 && one.weight >= 0.5f * largest[one.joint])
        followers[one.joint].push_back(static_cast<uint32_t>(v));
  return followers;
}

// From the lowest to the highest vertex; of joints where there are none.
inline double height_of(const Character& character) {
  const auto up_of = [&](const Vec3& p) {
    return static_cast<double>(character.up == Axis::kZ ? p.z : character.up == Axis::kX ? p.x : p.y);
  };
  double low = 0, high = 0;
  bool first = true;
  const auto add = [&](const Vec3& p) {
    low = first ? up_of(p) : std::min(low, up_of(p));
    high = first ? up_of(p) : std::max(high, up_of(p));
    first = false;
  };
  for (const Vec3& p : character.vertices) add(p);
  if (first)
    for (const Joint& joint : character.joints) add(joint.position);
  return high - low;
}
inline Point3 up_of(const Character& character) {
  return character.up == Axis::kZ ? Point3{0, 0, 1} : character.up == Axis::kX ? Point3{1, 0, 0} : Point3{0, 1, 0};
}

}  // namespace sinew
#endif
