// SPDX-License-Identifier: MIT
// Joints and weights against their mirror images, where most of the body is its own.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check/findings.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/median.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr double kAlike = 0.005;            // of the size: most twins are images of each other
constexpr double kMirrorTolerance = 0.002;  // of the size: a vertex is another one's image
constexpr double kMirroredShare = 0.9;      // of the vertices, of a mesh that is its own mirror image
constexpr double kUnlike = 0.6;             // L1 of rows
constexpr size_t kLeastVertices = 6;

struct Twins {
  uint32_t axis = 0;
  float plane = 0;
  std::vector<int> of;  // [J] partner, itself on the plane, -1 = none
};

Twins twins_of(const RigFacts& facts) {
  Twins twins;
  twins.axis = facts.verdicts.mirror_axis;
  twins.plane = facts.verdicts.mirror_planes[twins.axis];
  for (size_t j = 0; j < facts.verdicts.partners.size(); ++j) {
    const int32_t partner = facts.verdicts.partners[j];
    const double off =
        std::abs(static_cast<double>(component(facts.character.joints[j].position, twins.axis) - twins.plane));
    const bool both = partner >= 0 && facts.verdicts.partners[static_cast<size_t>(partner)] == static_cast<int32_t>(j);
    twins.of.push_back(both ? partner : partner < 0 && off < kMirrorTolerance * facts.size ? static_cast<int>(j) : -1);
  }
  return twins;
}

double off_image(const RigFacts& facts, const Twins& twins, size_t joint) {
  const Vec3 image = mirrored(facts.character.joints[joint].position, twins.axis, twins.plane);
  return length(point(image) - point(facts.character.joints[static_cast<size_t>(twins.of[joint])].position)) /
         facts.size;
}

void joints(const RigFacts& facts, const Twins& twins, Findings* findings) {
  std::vector<double> all;
  for (size_t j = 0; j < twins.of.size(); ++j)
    if (twins.of[j] > static_cast<int>(j)) all.push_back(off_image(facts, twins, j));
  if (all.size() < 4 || median(&all) > kAlike) return;
  for (size_t j = 0; j < twins.of.size(); ++j) {
    if (twins.of[j] <= static_cast<int>(j) || facts.verdicts.roles[j] == SINEW_ROLE_CONTROL) continue;
    if (facts.bound && (facts.weight[j] <= 0 || facts.weight[static_cast<size_t>(twins.of[j])] <= 0)) continue;
    // The descendants of a displaced joint are displaced with it.
    const int parent = facts.character.joints[j].parent;
    if (parent >= 0 && twins.of[static_cast<size_t>(parent)] >= 0 &&
        off_image(facts, twins, static_cast<size_t>(parent)) > kAlike)
      continue;
    RigFinding finding;
    finding.joint = static_cast<int>(j);
    finding.other = twins.of[j];
    finding.value = off_image(facts, twins, j);
    finding.what = findings->quoted(finding.joint) + " and " + findings->quoted(finding.other) +
                   print(" are %.3f of the size from each other's mirror images; other twins match", finding.value);
    findings->add("unlike-joints", std::move(finding));
  }
}

// [V] the vertex at its mirror image, kNoOne where there is none.
std::vector<uint32_t> images_of(const RigFacts& facts, const Twins& twins) {
  const double cell = kMirrorTolerance * facts.size;
  const auto key = [&](const Vec3& p, int dx, int dy, int dz) {
    return std::array<int64_t, 3>{static_cast<int64_t>(std::floor(static_cast<double>(p.x) / cell)) + dx,
                                  static_cast<int64_t>(std::floor(static_cast<double>(p.y) / cell)) + dy,
                                  static_cast<int64_t>(std::floor(static_cast<double>(p.z) / cell)) + dz};
  };
  std::map<std::array<int64_t, 3>, std::vector<uint32_t>> grid;
  for (uint32_t v = 0; v < facts.first.size(); ++v)
    if (facts.first[v] == v) grid[key(facts.character.vertices[v], 0, 0, 0)].push_back(v);
  std::vector<uint32_t> images(facts.first.size(), kNoOne);
  for (uint32_t v = 0; v < facts.first.size(); ++v) {
    if (facts.first[v] != v) continue;
    const Vec3 image = mirrored(facts.character.vertices[v], twins.axis, twins.plane);
    double nearest = cell;
    for (int n = 0; n < 27; ++n) {
      const auto found = grid.find(key(image, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
      if (found == grid.end()) continue;
      for (const uint32_t other : found->second) {
        const double d = length(point(facts.character.vertices[other]) - point(image));
        if (d < nearest) nearest = d, images[v] = other;
      }
    }
  }
  return images;
}

double row_difference(const RigFacts& facts, const Twins& twins, uint32_t v, uint32_t image) {
  double apart = 0, covered = 0;
  for (const Influence& i : facts.character.influences[v]) {
    const int twin = twins.of[i.joint];
    const double own = facts.weight_of(v, i.joint),
                 theirs = twin < 0 ? 0 : facts.weight_of(image, static_cast<uint32_t>(twin));
    apart += std::abs(own - theirs);
    covered += theirs;
  }
  return apart + std::max(0.0, 1 - covered);
}

void rows(const RigFacts& facts, const Twins& twins, Findings* findings) {
  const std::vector<uint32_t> images = images_of(facts, twins);
  size_t all = 0, paired = 0;
  std::vector<double> differences;
  std::vector<std::vector<uint32_t>> unlike(facts.moves.size()), known(facts.moves.size());
  for (uint32_t v = 0; v < images.size(); ++v) {
    if (facts.first[v] != v) continue;
    ++all;
    if (images[v] == kNoOne || facts.strongest[v] == kNoOne || facts.strongest[images[v]] == kNoOne) continue;
    ++paired;
    if (images[v] == v || twins.of[facts.strongest[v]] < 0) continue;
    const double difference = row_difference(facts, twins, v, images[v]);
    differences.push_back(difference);
    known[facts.strongest[v]].push_back(v);
    if (difference > kUnlike) unlike[facts.strongest[v]].push_back(v);
  }
  if (differences.empty() || static_cast<double>(paired) < kMirroredShare * static_cast<double>(all) ||
      median(&differences) > 0.05)
    return;
  for (size_t j = 0; j < unlike.size(); ++j) {
    if (unlike[j].size() < kLeastVertices || !facts.is_limb(j)) continue;
    RigFinding finding;
    finding.joint = static_cast<int>(j);
    finding.other = twins.of[j];
    finding.value = static_cast<double>(unlike[j].size()) / static_cast<double>(known[j].size());
    finding.what = vertices_text(unlike[j].size()) + " of " + findings->quoted(finding.joint) +
                   " have other weights than their mirror images: " + first_of(unlike[j]);
    finding.vertices = std::move(unlike[j]);
    findings->add("unlike-weights", std::move(finding));
  }
}

}  // namespace

void check_symmetry(const RigFacts& facts, Findings* findings) {
  const Twins twins = twins_of(facts);
  joints(facts, twins, findings);
  if (facts.bound) rows(facts, twins, findings);
}

}  // namespace sinew
