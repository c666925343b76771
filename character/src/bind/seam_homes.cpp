// SPDX-License-Identifier: MIT
// Weights, the distance to each bone relative to its usual one, and creases, relaxed over the band. All constants:
// train families.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "bind/seam_steps.hpp"
#include "sinew_formats/median.hpp"

namespace sinew {
namespace {

constexpr double kFacing =
    0.7;                       // cosine above which a vertex looks away from its bone, and tells how thick the part is
constexpr size_t kSteps = 11;  // points along a bone with a radius each
constexpr double kWindow = 0.15;     // of a bone, to both sides of such a point
constexpr size_t kFewest = 8;        // vertices that a radius is the median of
constexpr double kThinnest = 0.003;  // radius, of the size
constexpr double kLeastRow = 0.02;   // weight that a joint has at least where it is a candidate
constexpr int kReaches = 3;          // edges over which joints become candidates
constexpr int kRounds = 20;
constexpr double kCrease = 0.06;  // of the size: a crease that sharp over this length lets a quarter through

using Scores = std::vector<std::pair<uint32_t, double>>;  // by joint

double* score_of(Scores* scores, uint32_t joint) {
  const auto found = std::lower_bound(scores->begin(), scores->end(), joint,
                                      [](const auto& one, uint32_t j) { return one.first < j; });
  return found != scores->end() && found->first == joint ? &found->second : nullptr;
}

// How thick a part is along its bones: the usual distance of its surface.
class Radii {
 public:
  Radii(const SeamSurface& surface, const SkeletonPaths& paths, const std::vector<uint32_t>& homes)
      : surface_(surface), paths_(paths), owned_(paths.joint_count()), known_(paths.joint_count()) {
    for (uint32_t v = 0; v < homes.size(); ++v)
      if (surface.welded[v] == v && homes[v] != kNoHome) owned_[homes[v]].push_back(v);
  }

  double at(const BonePoint& bone_point) {
    std::vector<std::array<double, kSteps>>& bones = known_[bone_point.joint];
    if (bones.empty()) measure(bone_point.joint);
    const size_t step = static_cast<size_t>(bone_point.along * (kSteps - 1) + 0.5);
    return std::max(bone_point.bone < bones.size() ? bones[bone_point.bone][step] : 0.0, kThinnest * surface_.size);
  }

 private:
  void measure(uint32_t joint) {
    std::vector<BonePoint> bone_points;
    for (const bool facing : {true, false}) {
      for (const uint32_t v : owned_[joint]) {
        const BonePoint bone_point = paths_.nearest(joint, surface_.positions[v]);
        const Point3 out = unit(surface_.positions[v] - bone_point.position);
        if (!facing || dot(out, surface_.normals[v]) > kFacing) bone_points.push_back(bone_point);
      }
      if (bone_points.size() >= kFewest) break;
      bone_points.clear();
    }
    uint32_t bones = 1;
    std::vector<double> all;
    for (const BonePoint& bone_point : bone_points) {
      bones = std::max(bones, bone_point.bone + 1);
      all.push_back(bone_point.distance);
    }
    const double usual = all.empty() ? 0 : median(&all);
    known_[joint].resize(bones);
    for (uint32_t b = 0; b < bones; ++b) {
      for (size_t s = 0; s < kSteps; ++s) {
        const double here = static_cast<double>(s) / (kSteps - 1);
        std::vector<double> near;
        for (const BonePoint& bone_point : bone_points)
          if (bone_point.bone == b && std::fabs(bone_point.along - here) <= kWindow)
            near.push_back(bone_point.distance);
        known_[joint][b][s] = near.size() >= kFewest ? median(&near) : usual;
      }
    }
  }

  const SeamSurface& surface_;
  const SkeletonPaths& paths_;
  std::vector<std::vector<uint32_t>> owned_;                    // [J] vertices
  std::vector<std::vector<std::array<double, kSteps>>> known_;  // [J][bones]
};

class HomeFinder {
 public:
  HomeFinder(const SeamSurface& surface, const SkeletonPaths& paths, const WeightRows& rows,
             const std::vector<uint32_t>& band, std::vector<uint32_t>* homes)
      : surface_(surface), paths_(paths), rows_(rows), band_(band), homes_(*homes), radii_(surface, paths, *homes) {
    in_band_.assign(surface.positions.size(), UINT32_MAX);
    for (uint32_t i = 0; i < band.size(); ++i) in_band_[band[i]] = i;
  }

  void run() {
    for (const uint32_t v : band_) start_.push_back(scores(v));
    std::vector<Scores> now = start_;
    for (int round = 0; round < kRounds; ++round) {
      std::vector<Scores> next = start_;
      for (size_t i = 0; i < band_.size(); ++i) relax(i, now, &next[i]);
      now = std::move(next);
    }
    for (size_t i = 0; i < band_.size(); ++i) {
      double most = 1e-12;
      for (const auto& [joint, score] : now[i]) {
        if (score <= most) continue;
        most = score;
        homes_[band_[i]] = joint;
      }
    }
  }

 private:
  // Joints that have weight at a vertex or a few edges on, each with nothing yet.
  Scores candidates(uint32_t vertex) const {
    std::vector<uint32_t> reached = {vertex};
    size_t ring = 0;
    for (int reach = 0; reach < kReaches; ++reach) {
      const size_t end = reached.size();
      for (; ring < end; ++ring)
        for (uint32_t i = surface_.offsets[reached[ring]]; i < surface_.offsets[reached[ring] + 1]; ++i) {
          const uint32_t other = surface_.other_end(surface_.around[i], reached[ring]);
          if (std::find(reached.begin(), reached.end(), other) == reached.end()) reached.push_back(other);
        }
    }
    std::map<uint32_t, double> found;
    for (const uint32_t v : reached)
      for (const Influence& one : rows_[v])
        if (static_cast<double>(one.weight) >= kLeastRow) found.emplace(one.joint, 0.0);
    return {found.begin(), found.end()};
  }

  Scores scores(uint32_t vertex) {
    Scores found = candidates(vertex);
    double sum = 0;
    for (auto& [joint, score] : found) {
      const BonePoint bone_point = paths_.nearest(joint, surface_.positions[vertex]);
      const double cosine = dot(unit(surface_.positions[vertex] - bone_point.position), surface_.normals[vertex]);
      const double far = std::max(bone_point.distance / radii_.at(bone_point) / (0.5 * (cosine + 1.001)), 1.0);
      double weight = kLeastRow;
      for (const Influence& one : rows_[vertex])
        if (one.joint == joint) weight += static_cast<double>(one.weight);
      score = weight / (far * far * far * far);
      sum += score;
    }
    for (auto& [joint, score] : found) score = sum > 0 ? score / sum : 0;
    return found;
  }

  // The start value of a vertex and those of its neighbors, weighted by how flat the path to them is.
  void relax(size_t i, const std::vector<Scores>& now, Scores* scores) const {
    double sum = 1;
    const uint32_t v = band_[i];
    for (uint32_t k = surface_.offsets[v]; k < surface_.offsets[v + 1]; ++k) {
      const SurfaceEdge& edge = surface_.edges[surface_.around[k]];
      const uint32_t other = surface_.other_end(surface_.around[k], v);
      const double valley = edge.length > 0 ? std::max(0.0, -edge.turn) * kCrease * surface_.size / edge.length : 0;
      const double share = 1 / ((1 + valley) * (1 + valley));
      sum += share;
      if (in_band_[other] == UINT32_MAX) {
        if (homes_[other] == kNoHome) continue;
        if (double* const score = score_of(scores, homes_[other])) *score += share;
        continue;
      }
      for (const auto& [joint, score] : now[in_band_[other]])
        if (double* const own = score_of(scores, joint)) *own += share * score;
    }
    for (auto& [joint, score] : *scores) score /= sum;
  }

  const SeamSurface& surface_;
  const SkeletonPaths& paths_;
  const WeightRows& rows_;
  const std::vector<uint32_t>& band_;
  std::vector<uint32_t>& homes_;
  Radii radii_;
  std::vector<uint32_t> in_band_;  // [V]
  std::vector<Scores> start_;      // [band]
};

}  // namespace

uint32_t home_joint(const std::vector<Influence>& row) {
  const auto most = std::max_element(row.begin(), row.end(),
                                     [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
  return most == row.end() || !(most->weight > 0) ? kNoHome : most->joint;
}

void find_seam_homes(const SeamSurface& surface, const SkeletonPaths& paths, const WeightRows& rows,
                     const std::vector<uint32_t>& band, std::vector<uint32_t>* homes) {
  HomeFinder(surface, paths, rows, band, homes).run();
}

}  // namespace sinew
