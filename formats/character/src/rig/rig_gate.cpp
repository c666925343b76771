// SPDX-License-Identifier: MIT
// Figures of a rigged mesh against bounds; the test poses.
#include "sinew_character/rig_gate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "sinew_character/pose.hpp"
#include "sinew_formats/box.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr uint32_t kTestPoses = 3;
constexpr double kTestDegrees = 30, kTornRatio = 4, kTornLength = 0.02;
constexpr float kWeakParent = 0.02f;

double length_between(const Vec3& a, const Vec3& b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y), static_cast<double>(a.z - b.z));
}

std::vector<JointRotation> test_pose(const Character& character, std::minstd_rand* draws) {
  const auto degrees = [draws] {
    constexpr double kRange = std::minstd_rand::max() - std::minstd_rand::min();
    return (static_cast<double>((*draws)()) / kRange * 2 - 1) * kTestDegrees;
  };
  return rotate_joints(character, degrees);
}

double torn_share(const Character& rest, const Character& posed, double side) {
  size_t edges = 0, torn = 0;
  for (size_t f = 0; f < rest.face_count(); ++f) {
    const uint32_t first = rest.face_offsets[f], last = rest.face_offsets[f + 1];
    for (uint32_t c = first; c < last; ++c) {
      const uint32_t a = rest.face_vertices[c], b = rest.face_vertices[c + 1 < last ? c + 1 : first];
      const double before = length_between(rest.vertices[a], rest.vertices[b]);
      const double after = length_between(posed.vertices[a], posed.vertices[b]);
      torn += after > kTornRatio * before && after - before > kTornLength * side ? 1 : 0;
      ++edges;
    }
  }
  return edges == 0 ? 0 : static_cast<double>(torn) / static_cast<double>(edges);
}

}  // namespace

double exploded_share(const Character& character) {
  if (character.influences.size() != character.vertices.size() || character.vertices.empty()) return 0;
  const double side = static_cast<double>(box_of(character.vertices).longest_side());
  std::minstd_rand draws(1);
  double worst = 0;
  for (uint32_t k = 0; k < kTestPoses; ++k) {
    const std::vector<Affine> palette = pose_palette(character, test_pose(character, &draws));
    worst = std::max(worst, torn_share(character, apply_pose(character, palette), side));
  }
  return worst;
}

double weak_parents(const PredictedSkeleton& skeleton) {
  size_t joints = 0, weak = 0;
  for (size_t j = 0; j < skeleton.joints.size(); ++j) {
    if (skeleton.ends[j] != 0 || skeleton.joints[j].parent < 0) continue;
    ++joints;
    weak += skeleton.parent_confidence[j] < kWeakParent ? 1 : 0;
  }
  return joints == 0 ? 0 : static_cast<double>(weak) / static_cast<double>(joints);
}

GateFigures gate_figures(const Character& character, const PredictedSkeleton& skeleton) {
  GateFigures figures;
  if (skeleton.usable) figures.usable = static_cast<double>(*skeleton.usable);
  if (skeleton.front_confidence > 0) figures.front = static_cast<double>(skeleton.front_confidence);
  figures.weak_parents = weak_parents(skeleton);
  size_t unweighted = 0;
  for (const auto& row : character.influences) unweighted += row.empty() ? 1 : 0;
  if (!character.influences.empty())
    figures.unweighted = static_cast<double>(unweighted) / static_cast<double>(character.influences.size());
  figures.exploded = exploded_share(character);
  return figures;
}

std::vector<std::string> gate_failures(const GateFigures& figures, bool bound) {
  std::vector<std::string> failures;
  const auto fail = [&](double value, double most, const char* what) {
    if (value > most) failures.push_back(print("%.2g %s, more than %.2g", value, what, most));
  };
  if (figures.usable < static_cast<double>(kDoubtfulUsable))
    failures.push_back(print("the skeleton can be used with a probability of %.2g, less than %.2g", figures.usable,
                             static_cast<double>(kDoubtfulUsable)));
  if (figures.front < static_cast<double>(kCoinToss))
    failures.push_back(print("left is left with a probability of %.2g, less than %.2g", figures.front,
                             static_cast<double>(kCoinToss)));
  fail(figures.weak_parents, kMostWeakParents, "of the joints are unsure of their parents");
  if (!bound) return failures;
  fail(figures.unweighted, kMostUnweighted, "of the vertices have no weight");
  fail(figures.exploded, kMostExploded, "of the edges tear in a test pose");
  return failures;
}

}  // namespace sinew
