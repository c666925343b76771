// SPDX-License-Identifier: MIT
// Whether a skeleton lies in its mesh, and which change of units, axes and origin would bring it there.
#include <algorithm>
#include <cmath>

#include "sinew_character/rig/skeleton_repair.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr double kRoom = 0.1;        // of the mesh's diagonal: how far outside of its box joints may stand
constexpr double kMostInside = 0.6;  // a skeleton fits with this share of its joints inside
constexpr double kSmallest = 0.2;    // and with a box of at least this share of the mesh's diagonal

double diagonal(const Box& box) { return static_cast<double>(box.diagonal()); }

Vec3 moved(const SkeletonFit& fit, const Vec3& p) {
  const std::array<double, 3> scaled = {fit.scale * static_cast<double>(p.x), fit.scale * static_cast<double>(p.y),
                                        fit.scale * static_cast<double>(p.z)};
  const auto row = [&](size_t r) {
    return fit.rotation[r * 3] * scaled[0] + fit.rotation[r * 3 + 1] * scaled[1] + fit.rotation[r * 3 + 2] * scaled[2];
  };
  return {static_cast<float>(row(0) + static_cast<double>(fit.shift.x)),
          static_cast<float>(row(1) + static_cast<double>(fit.shift.y)),
          static_cast<float>(row(2) + static_cast<double>(fit.shift.z))};
}

// Share of the joints in the mesh's box with some room around it; 0 for a skeleton that is a speck in it.
double share_inside(const Box& mesh, const std::vector<Joint>& joints, const SkeletonFit& fit) {
  const float room = static_cast<float>(kRoom * diagonal(mesh));
  size_t inside = 0;
  std::vector<Vec3> points;
  for (const Joint& joint : joints) {
    const Vec3 p = moved(fit, joint.position);
    points.push_back(p);
    const auto within = [room](float value, float low, float high) {
      return value >= low - room && value <= high + room;
    };
    inside += within(p.x, mesh.low.x, mesh.high.x) && within(p.y, mesh.low.y, mesh.high.y) &&
                      within(p.z, mesh.low.z, mesh.high.z)
                  ? 1
                  : 0;
  }
  if (joints.size() > 2 && diagonal(box_of(points)) < kSmallest * diagonal(mesh)) return 0;
  return static_cast<double>(inside) / static_cast<double>(joints.size());
}

// Mean distance from the joints to the mesh's vertices: which of several fits is the closest.
double distance_to_mesh(const Character& character, const SkeletonFit& fit) {
  const size_t step = std::max<size_t>(1, character.vertices.size() / 2000);
  double sum = 0;
  for (const Joint& joint : character.joints) {
    const Vec3 p = moved(fit, joint.position);
    double nearest = 1e300;
    for (size_t v = 0; v < character.vertices.size(); v += step) {
      const Vec3& q = character.vertices[v];
      const double x = static_cast<double>(p.x - q.x), y = static_cast<double>(p.y - q.y),
                   z = static_cast<double>(p.z - q.z);
      nearest = std::min(nearest, x * x + y * y + z * z);
    }
    sum += std::sqrt(nearest);
  }
  return sum;
}

constexpr std::array<std::array<double, 9>, 5> kTurns = {{{1, 0, 0, 0, 1, 0, 0, 0, 1},
                                                          {1, 0, 0, 0, 0, 1, 0, -1, 0},     // Z up to Y up
                                                          {1, 0, 0, 0, 0, -1, 0, 1, 0},     // Y up to Z up
                                                          {0, 1, 0, -1, 0, 0, 0, 0, 1},     // X up to Y up
                                                          {-1, 0, 0, 0, 1, 0, 0, 0, -1}}};  // the back to the front
constexpr std::array<const char*, 5> kRotationTexts = {"", "has Z up, the mesh Y", "has Y up, the mesh Z",
                                                       "has X up, the mesh Y", "faces backwards"};
constexpr std::array<double, 7> kScales = {1, 0.01, 100, 0.001, 1000, 0.0254, 39.37007874};

std::string describe(const SkeletonFit& fit, size_t rotation, bool shifted) {
  std::string text;
  if (fit.scale < 0.999) text = print("is %.4g times as large as the mesh", 1 / fit.scale);
  if (fit.scale > 1.001) text = print("is %.4g times smaller than the mesh", fit.scale);
  if (rotation != 0) text += (text.empty() ? "" : " and ") + std::string(kRotationTexts[rotation]);
  if (shifted) text += (text.empty() ? "" : " and ") + std::string("lies beside it");
  return "the skeleton " + text;
}

}  // namespace

std::optional<SkeletonFit> find_skeleton_fit(const Character& character) {
  if (character.vertices.empty() || character.joints.empty()) return std::nullopt;
  const Box mesh = box_of(character.vertices);
  if (!(diagonal(mesh) > 0) || share_inside(mesh, character.joints, {}) >= kMostInside) return std::nullopt;

  std::optional<SkeletonFit> best;
  double best_distance = 0;
  const auto offer = [&](SkeletonFit fit, size_t rotation, bool shifted) {
    if (share_inside(mesh, character.joints, fit) < kMostInside + 0.2) return;
    const double distance = distance_to_mesh(character, fit);
    if (best && distance >= 0.8 * best_distance) return;
    fit.what = describe(fit, rotation, shifted);
    best_distance = distance;
    best = std::move(fit);
  };
  for (size_t rotation = 0; rotation < kTurns.size(); ++rotation)
    for (const double scale : kScales)
      if (rotation != 0 || scale != 1) offer({scale, kTurns[rotation], {}, {}}, rotation, false);
  if (best) return best;

  // None of the usual mistakes: as large as the mesh, and in its middle.
  std::vector<Vec3> points;
  for (const Joint& joint : character.joints) points.push_back(joint.position);
  const Box bones = box_of(points);
  if (!(diagonal(bones) > 0)) return std::nullopt;
  for (size_t rotation = 0; rotation < 3; ++rotation) {
    for (const bool same_size : {true, false}) {
      SkeletonFit fit{same_size ? 1 : 0.9 * diagonal(mesh) / diagonal(bones), kTurns[rotation], {}, {}};
      const Vec3 low = moved(fit, bones.low), high = moved(fit, bones.high);
      fit.shift = {(mesh.low.x + mesh.high.x - low.x - high.x) / 2, (mesh.low.y + mesh.high.y - low.y - high.y) / 2,
                   (mesh.low.z + mesh.high.z - low.z - high.z) / 2};
      offer(fit, rotation, true);
      if (best) return best;
    }
  }
  return best;
}

void apply_skeleton_fit(const SkeletonFit& fit, std::vector<Joint>* joints) {
  for (Joint& joint : *joints) joint.position = moved(fit, joint.position);
}

}  // namespace sinew
