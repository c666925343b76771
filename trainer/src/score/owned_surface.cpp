// SPDX-License-Identifier: MIT
// What a user sees of a predicted skeleton: which part of the surface moves with which bone.
#include <algorithm>
#include <cmath>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/vertex_areas.hpp"
#include "sinew_trainer/rig_score.hpp"

namespace sinew {
namespace {

constexpr double kMiddle = 0.01;  // of the longest side

// The joint of most weight where `to` says whom each joint's weight is for; -1 without any.
template <class To>
int strongest(const std::vector<Influence>& influences, size_t joints, std::vector<double>* sums, To&& to) {
  if (influences.empty()) return -1;
  sums->assign(joints, 0.0);
  for (const Influence& influence : influences) (*sums)[to(influence.joint)] += influence.weight;
  return static_cast<int>(std::max_element(sums->begin(), sums->end()) - sums->begin());
}

}  // namespace

double owned_surface(const BoundSkeleton& bound, const Character& character, const TargetSkeleton& reference) {
  const double limit = kMiddle * box_of(character.vertices).longest_side();
  const auto side = [&](double across) {
    return std::fabs(across - bound.plane) < limit ? 0 : across < bound.plane ? -1 : 1;
  };
  const std::vector<double> area = vertex_areas(character);
  std::vector<double> sums;
  double all = 0, right = 0;
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    const int theirs = strongest(character.influences[v], reference.joints.size(), &sums,
                                 [&](uint32_t joint) { return reference.owners[joint]; });
    if (theirs < 0) continue;
    all += area[v];
    const int ours = strongest(bound.influences[v], bound.joints.size(), &sums, [](uint32_t joint) { return joint; });
    if (ours < 0) continue;
    const TargetJoint& a = reference.joints[static_cast<size_t>(theirs)];
    const Joint& b = bound.joints[static_cast<size_t>(ours)];
    const double across = bound.axis == 0 ? b.position.x : b.position.z;
    if (a.joint_class == bound.classes[static_cast<size_t>(ours)] &&
        side(a.position[static_cast<size_t>(bound.axis)]) == side(across)) {
      right += area[v];
    }
  }
  return all > 0 ? right / all : 0;
}

}  // namespace sinew
