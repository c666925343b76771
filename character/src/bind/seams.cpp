// SPDX-License-Identifier: MIT
// Edges between parts that are apart, gathered to lines; lines that are no seams go.
#include "sinew_character/bind/seams.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "bind/seam_steps.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

// Chosen on train families, see trainer/configs/RESULTS.md.
constexpr double kBand = 0.06;     // of the size, to both sides of where weights cross: homes are decided anew
constexpr double kReach = 0.1;     // the same: rows are cleaned
constexpr double kValley = -0.05;  // mean bend across a line above which it is no valley

class SeamFinder {
 public:
  SeamFinder(const Character& character, const WeightRows& rows)
      : rows_(rows), surface_(character), paths_(character.joints, surface_.size) {}

  Seams run() {
    homes_.assign(rows_.size(), kNoHome);
    for (uint32_t v = 0; v < rows_.size(); ++v)
      if (surface_.welded[v] == v) homes_[v] = home_joint(rows_[v]);
    find_crossing();
    if (crossing_.size() < kFewestEdges) return {};
    find_seam_homes(surface_, paths_, rows_, near_crossing(kBand), &homes_);
    find_crossing();
    keep_seams();
    if (found_.seams.empty()) return {};
    found_.homes.assign(rows_.size(), kNoHome);
    for (const uint32_t v : near_crossing(kReach)) found_.homes[v] = homes_[v];
    for (uint32_t v = 0; v < rows_.size(); ++v) found_.homes[v] = found_.homes[surface_.welded[v]];
    return std::move(found_);
  }

 private:
  void find_crossing() {
    crossing_.clear();
    for (uint32_t e = 0; e < surface_.edges.size(); ++e) {
      const SurfaceEdge& edge = surface_.edges[e];
      const uint32_t a = homes_[edge.from], b = homes_[edge.to];
      if (a == b || a == kNoHome || b == kNoHome) continue;
      if (paths_.are_apart(paths_.nearest(a, surface_.positions[edge.from]),
                           paths_.nearest(b, surface_.positions[edge.to])))
        crossing_.push_back(e);
    }
  }

  // Welded vertices at most that far from an end of an edge that crosses, ascending.
  std::vector<uint32_t> near_crossing(double share) const {
    std::vector<uint32_t> ends, near;
    for (const uint32_t e : crossing_) {
      ends.push_back(surface_.edges[e].from);
      ends.push_back(surface_.edges[e].to);
    }
    const std::vector<double> distances = surface_.distances(ends, share * surface_.size);
    for (uint32_t v = 0; v < distances.size(); ++v)
      if (distances[v] <= share * surface_.size && homes_[v] != kNoHome) near.push_back(v);
    return near;
  }

  // [edges] 1: crosses.
  std::vector<char> which_cross() const {
    std::vector<char> crosses(surface_.edges.size(), 0);
    for (const uint32_t e : crossing_) crosses[e] = 1;
    return crosses;
  }

  // Groups of crossing edges whose ends are the same or neighbors.
  std::vector<std::vector<uint32_t>> lines() const {
    std::vector<std::vector<uint32_t>> lines;
    std::vector<char> crosses = which_cross();
    const auto take = [&](uint32_t v, std::vector<uint32_t>* line) {
      for (uint32_t k = surface_.offsets[v]; k < surface_.offsets[v + 1]; ++k) {
        const uint32_t e = surface_.around[k];
        if (crosses[e] == 0) continue;
        crosses[e] = 0;
        line->push_back(e);
      }
    };
    for (const uint32_t first : crossing_) {
      if (crosses[first] == 0) continue;
      crosses[first] = 0;
      std::vector<uint32_t> line = {first};
      for (size_t i = 0; i < line.size(); ++i)
        for (const uint32_t v : {surface_.edges[line[i]].from, surface_.edges[line[i]].to})
          for (uint32_t k = surface_.offsets[v]; k < surface_.offsets[v + 1]; ++k)
            take(surface_.other_end(surface_.around[k], v), &line);
      lines.push_back(std::move(line));
    }
    return lines;
  }

  // [V] the piece of the surface without crossing edges that a vertex belongs to.
  std::vector<uint32_t> pieces() const {
    const std::vector<char> crosses = which_cross();
    std::vector<uint32_t> pieces(homes_.size(), kNoHome);
    for (uint32_t first = 0; first < pieces.size(); ++first) {
      if (pieces[first] != kNoHome) continue;
      pieces[first] = first;
      std::vector<uint32_t> open = {first};
      while (!open.empty()) {
        const uint32_t v = open.back();
        open.pop_back();
        for (uint32_t k = surface_.offsets[v]; k < surface_.offsets[v + 1]; ++k) {
          const uint32_t other = surface_.other_end(surface_.around[k], v);
          if (crosses[surface_.around[k]] != 0 || pieces[other] != kNoHome) continue;
          pieces[other] = first;
          open.push_back(other);
        }
      }
    }
    return pieces;
  }

  // Drops lines that are not seams: short ones, those over a bulge, and those without a connection behind them, where
  // a joint's parent is elsewhere than the part that it is fused with.
  void keep_seams() {
    const std::vector<uint32_t> piece = pieces();
    std::vector<uint32_t> kept;
    for (const std::vector<uint32_t>& line : lines()) {
      double turn = 0;
      size_t joined = 0;
      for (const uint32_t e : line) {
        turn += surface_.edges[e].turn;
        joined += piece[surface_.edges[e].from] == piece[surface_.edges[e].to] ? 1 : 0;
      }
      const double count = static_cast<double>(line.size());
      if (line.size() < kFewestEdges || turn > kValley * count || 2 * joined < line.size()) continue;
      kept.insert(kept.end(), line.begin(), line.end());
      found_.seams.push_back(describe(line));
    }
    crossing_ = std::move(kept);
    for (const uint32_t e : crossing_) found_.edges.push_back({surface_.edges[e].from, surface_.edges[e].to});
    std::stable_sort(found_.seams.begin(), found_.seams.end(),
                     [](const Seam& a, const Seam& b) { return a.length > b.length; });
  }

  // Edges cross a line about twice for each that lies along it, so that half the mean length of an edge is a step.
  Seam describe(const std::vector<uint32_t>& line) const {
    std::map<std::pair<uint32_t, uint32_t>, size_t> counts;
    Seam seam;
    Point3 sum = {};
    for (const uint32_t e : line) {
      const SurfaceEdge& edge = surface_.edges[e];
      const auto [low, high] = std::minmax(homes_[edge.from], homes_[edge.to]);
      ++counts[{low, high}];
      sum = sum + 0.5 * (surface_.positions[edge.from] + surface_.positions[edge.to]);
      seam.length += 0.5 * edge.length;
    }
    size_t most = 0;
    for (const auto& [joints, count] : counts) {
      if (count <= most) continue;
      most = count;
      seam.joints = {joints.first, joints.second};
    }
    const Point3 middle = (1 / static_cast<double>(line.size())) * sum;
    seam.position = {static_cast<float>(middle[0]), static_cast<float>(middle[1]), static_cast<float>(middle[2])};
    return seam;
  }

  const WeightRows& rows_;
  const SeamSurface surface_;
  const SkeletonPaths paths_;
  std::vector<uint32_t> homes_;     // [V] of welded vertices
  std::vector<uint32_t> crossing_;  // edges
  Seams found_;
};

// Whether so many edges of faces lie between parts that are apart that there may be a seam: most bodies have none, and welding
// large meshes takes longer than this look at them.
bool may_have_seams(const Character& character, const WeightRows& rows) {
  if (character.vertices.empty() || rows.size() != character.vertices.size()) return false;
  const SkeletonPaths paths(character.joints, static_cast<double>(box_of(character.vertices).longest_side()));
  std::vector<uint32_t> homes;
  for (const auto& row : rows) homes.push_back(home_joint(row));
  const auto bone_point = [&](uint32_t v) { return paths.nearest(homes[v], point(character.vertices[v])); };
  size_t count = 0;
  for (size_t f = 0; f < character.face_count() && count < kFewestEdges; ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t c = first; c < end; ++c) {
      const uint32_t a = character.face_vertices[c], b = character.face_vertices[c + 1 < end ? c + 1 : first];
      if (homes[a] == homes[b] || homes[a] == kNoHome || homes[b] == kNoHome) continue;
      count += paths.are_apart(bone_point(a), bone_point(b)) ? 1 : 0;
    }
  }
  return count >= kFewestEdges;
}

}  // namespace

Seams find_seams(const Character& character, const WeightRows& rows) {
  if (!may_have_seams(character, rows)) return {};
  return SeamFinder(character, rows).run();
}

std::string seams_text(const std::vector<Joint>& joints, const Seams& seams, size_t doubled) {
  std::string text;
  std::vector<std::string> pairs;
  for (const Seam& seam : seams.seams) {
    std::string pair = joints[seam.joints[0]].name + " and " + joints[seam.joints[1]].name;
    if (std::find(pairs.begin(), pairs.end(), pair) != pairs.end()) continue;
    text += (pairs.empty() ? "" : ", ") + pair;
    pairs.push_back(std::move(pair));
  }
  return "fused parts at " + text + "; no weight crosses there, " +
         (doubled > 0 ? "and the mesh was cut open: " + std::to_string(doubled) + " vertices were doubled"
                      : std::string("--cut opens the mesh there"));
}

size_t keep_apart(const Character& character, const Seams& seams, const std::vector<uint8_t>& keep, WeightRows* rows) {
  if (seams.seams.empty()) return 0;
  const SkeletonPaths paths(character.joints, static_cast<double>(box_of(character.vertices).longest_side()));
  size_t changed = 0;
  for (size_t v = 0; v < rows->size(); ++v) {
    if (seams.homes[v] == kNoHome || (!keep.empty() && keep[v] != 0) || (*rows)[v].empty()) continue;
    const Point3 position = point(character.vertices[v]);
    const BonePoint home = paths.nearest(seams.homes[v], position);
    std::vector<Influence> row;
    for (const Influence& one : (*rows)[v])
      if (!paths.are_apart(home, paths.nearest(one.joint, position))) row.push_back(one);
    if (row.size() == (*rows)[v].size()) continue;
    if (row.empty()) row = {{seams.homes[v], 1.0f}};
    (*rows)[v] = round_influences(row, static_cast<uint32_t>(row.size()));
    ++changed;
  }
  return changed;
}

}  // namespace sinew
