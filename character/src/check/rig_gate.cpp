// SPDX-License-Identifier: MIT
// Figures of a rigged mesh against bounds; the test poses.
#include "sinew_character/check/rig_gate.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

#include "sinew_character/check/surface_faults.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr uint32_t kTestPoses = 3;
constexpr double kTestDegrees = 30;
constexpr float kWeakParent = 0.02f;

std::vector<JointRotation> test_pose(const Character& character, std::minstd_rand* draws) {
  const auto degrees = [draws] {
    constexpr double kRange = std::minstd_rand::max() - std::minstd_rand::min();
    return (static_cast<double>((*draws)()) / kRange * 2 - 1) * kTestDegrees;
  };
  return rotate_joints(character, degrees);
}

}  // namespace

double exploded_share(const Character& character) {
  if (character.influences.size() != character.vertices.size() || character.vertices.empty()) return 0;
  if (character.face_vertices.empty()) return 0;
  std::minstd_rand draws(1);
  double worst = 0;
  for (uint32_t k = 0; k < kTestPoses; ++k) {
    const std::vector<Affine> palette = pose_palette(character, test_pose(character, &draws));
    const size_t torn = torn_edges(character, apply_pose(character, palette)).size();
    worst = std::max(worst, static_cast<double>(torn) / static_cast<double>(character.face_vertices.size()));
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
    failures.push_back(print("the skeleton is usable with a probability of %.2g, less than %.2g", figures.usable,
                             static_cast<double>(kDoubtfulUsable)));
  if (figures.front < static_cast<double>(kCoinToss))
    failures.push_back(print("left and right are correct with a probability of %.2g, less than %.2g", figures.front,
                             static_cast<double>(kCoinToss)));
  fail(figures.weak_parents, kMostWeakParents, "of the joints have uncertain parents");
  if (!bound) return failures;
  fail(figures.unweighted, kMostUnweighted, "of the vertices have no weight");
  fail(figures.exploded, kMostExploded, "of the edges tear in a test pose");
  return failures;
}

}  // namespace sinew
