// SPDX-License-Identifier: MIT
// Counts and findings of one character: faces, edges, joints, weights.
#include "sinew_character/check/mesh_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "sinew_character/check/label_check.hpp"

namespace sinew {
namespace {

using Level = CheckFinding::Level;
using Edge = std::pair<uint32_t, uint32_t>;

constexpr double kWeightSumTolerance = 1e-3;
constexpr size_t kMostInfluences = 12;  // of the engine

// Collects the first few elements of a kind for the one line of its finding.
class Examples {
 public:
  void add(const std::string& element) {
    if (count_++ < 5) text_ += (text_.empty() ? "" : ", ") + element;
  }
  void add(size_t element) { add(std::to_string(element)); }
  size_t count() const { return count_; }
  // "3 isolated vertices: 1, 2, 3"
  void report(Level level, const char* code, const std::string& what, CheckReport* report) const {
    if (count_ == 0) return;
    report->findings.push_back(
        {level, code, count_, std::to_string(count_) + " " + what + ": " + text_ + (count_ > 5 ? ", ..." : "")});
  }

 private:
  size_t count_ = 0;
  std::string text_;
};

Edge edge_of(uint32_t a, uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

double twice_area(const Character& character, const std::vector<uint32_t>& corners) {
  double sum[3] = {};
  for (size_t c = 0; c < corners.size(); ++c) {
    const Vec3& a = character.vertices[corners[c]];
    const Vec3& b = character.vertices[corners[(c + 1) % corners.size()]];
    const Vec3& o = character.vertices[corners[0]];
    const double ax = static_cast<double>(a.x - o.x), ay = static_cast<double>(a.y - o.y),
                 az = static_cast<double>(a.z - o.z);
    const double bx = static_cast<double>(b.x - o.x), by = static_cast<double>(b.y - o.y),
                 bz = static_cast<double>(b.z - o.z);
    sum[0] += ay * bz - az * by;
    sum[1] += az * bx - ax * bz;
    sum[2] += ax * by - ay * bx;
  }
  return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

struct Bounds {
  double low[3] = {}, high[3] = {}, longest = 0;
};

Bounds bounds_of(const std::vector<Vec3>& vertices) {
  Bounds box;
  for (size_t v = 0; v < vertices.size(); ++v) {
    const double p[3] = {static_cast<double>(vertices[v].x), static_cast<double>(vertices[v].y),
                         static_cast<double>(vertices[v].z)};
    for (size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = v == 0 ? p[axis] : std::min(box.low[axis], p[axis]);
      box.high[axis] = v == 0 ? p[axis] : std::max(box.high[axis], p[axis]);
    }
  }
  for (size_t axis = 0; axis < 3; ++axis) box.longest = std::max(box.longest, box.high[axis] - box.low[axis]);
  return box;
}

// Faults of single faces.
struct FaceCheck {
  Examples broken, degenerate, duplicate;
  std::vector<std::vector<uint32_t>> sound;
  std::vector<char> used;  // [vertices] in a face

  FaceCheck(const Character& character, const Bounds& box) : used(character.vertices.size(), 0) {
    std::set<std::vector<uint32_t>> known;
    for (size_t f = 0; f < character.face_count(); ++f) {
      std::vector<uint32_t> corners(
          character.face_vertices.begin() + static_cast<std::ptrdiff_t>(character.face_offsets[f]),
          character.face_vertices.begin() + static_cast<std::ptrdiff_t>(character.face_offsets[f + 1]));
      if (std::any_of(corners.begin(), corners.end(), [&](uint32_t v) { return v >= used.size(); })) {
        broken.add(f);
        continue;
      }
      for (const uint32_t v : corners) used[v] = 1;
      std::vector<uint32_t> sorted = corners;
      std::sort(sorted.begin(), sorted.end());
      const bool repeats = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
      if (corners.size() < 3 || repeats || !(twice_area(character, corners) > 1e-12 * box.longest * box.longest)) {
        degenerate.add(f);
        if (corners.size() < 3 || repeats) continue;  // one without area still joins its neighbors
      }
      if (!known.insert(std::move(sorted)).second) {
        duplicate.add(f);
        continue;
      }
      sound.push_back(std::move(corners));
    }
  }
};

// Edges that faces share, and connected components.
struct EdgeCheck {
  Examples non_manifold, flipped;
  size_t boundary = 0;
  std::map<Edge, size_t> faces_at;

  EdgeCheck(const std::vector<std::vector<uint32_t>>& faces, size_t vertex_count) : set_of_(vertex_count) {
    std::map<Edge, int> balance;  // +1 and -1 for the two directions: 0 where two neighbors agree on the side
    std::iota(set_of_.begin(), set_of_.end(), 0u);
    for (const std::vector<uint32_t>& corners : faces)
      for (size_t c = 0; c < corners.size(); ++c) {
        const uint32_t a = corners[c], b = corners[(c + 1) % corners.size()];
        ++faces_at[edge_of(a, b)];
        balance[edge_of(a, b)] += a < b ? 1 : -1;
        set_of_[find(a)] = find(b);
      }
    for (const auto& [edge, count] : faces_at) {
      const std::string name = std::to_string(edge.first) + "-" + std::to_string(edge.second);
      if (count == 1) ++boundary;
      if (count > 2) non_manifold.add(name);
      if (count == 2 && balance[edge] != 0) flipped.add(name);
    }
  }
  uint32_t find(uint32_t v) {
    while (set_of_[v] != v) v = set_of_[v] = set_of_[set_of_[v]];
    return v;
  }

 private:
  std::vector<uint32_t> set_of_;
};

void check_mesh(const Character& character, const Bounds& box, const BoundaryLoops& loops, CheckReport* report) {
  const size_t vertex_count = character.vertices.size();
  Examples not_finite, isolated;
  for (size_t v = 0; v < vertex_count; ++v) {
    const Vec3& p = character.vertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) not_finite.add(v);
  }
  const FaceCheck faces(character, box);
  EdgeCheck edges(faces.sound, vertex_count);
  for (uint32_t v = 0; v < vertex_count; ++v) {
    if (faces.used[v] == 0)
      isolated.add(v);
    else if (edges.find(v) == v)
      ++report->parts;
  }

  report->boundary_edges += edges.boundary;
  report->non_manifold_edges = edges.non_manifold.count();
  report->degenerate_faces = faces.degenerate.count();
  report->duplicate_faces = faces.duplicate.count();
  report->isolated_vertices = isolated.count();
  not_finite.report(Level::kError, "not-finite", "vertices that are not finite", report);
  faces.broken.report(Level::kError, "bad-faces", "faces that name vertices that do not exist", report);
  if (character.face_count() == 0)
    report->findings.push_back(
        {Level::kError, "no-faces", 1, "the mesh has " + std::to_string(vertex_count) + " vertices and no faces"});
  edges.non_manifold.report(Level::kWarning, "non-manifold-edges", "edges with more than two faces", report);
  edges.flipped.report(Level::kWarning, "flipped-faces", "edges whose two faces have opposite orientation", report);
  faces.degenerate.report(Level::kWarning, "degenerate-faces", "faces without area or with a vertex twice", report);
  faces.duplicate.report(Level::kWarning, "duplicate-faces", "faces that repeat an earlier face", report);
  isolated.report(Level::kWarning, "isolated-vertices", "vertices in no face", report);
  if (report->parts > 1)
    report->findings.push_back({Level::kNote, "parts", report->parts, std::to_string(report->parts) + " parts"});
  if (report->boundary_edges != 0)
    report->findings.push_back(
        {Level::kNote, "boundary-edges", report->boundary_edges,
         std::to_string(report->boundary_edges) + " boundary edges" +
             (loops ? " in " + std::to_string(loops(faces.sound, edges.faces_at)) + " loops" : "")});
}

void check_skeleton(const Character& character, const Bounds& box, CheckReport* report) {
  const std::vector<Joint>& joints = character.joints;
  Examples outside, roots, bad_parents, cycles;
  std::vector<size_t> seen_from(joints.size(), SIZE_MAX);
  for (size_t j = 0; j < joints.size(); ++j) {
    const double p[3] = {static_cast<double>(joints[j].position.x), static_cast<double>(joints[j].position.y),
                         static_cast<double>(joints[j].position.z)};
    bool far = false;
    for (size_t axis = 0; axis < 3; ++axis)
      far = far || !(p[axis] >= box.low[axis] - 0.5 * box.longest && p[axis] <= box.high[axis] + 0.5 * box.longest);
    if (far) outside.add(joints[j].name);
    if (joints[j].parent < 0) roots.add(joints[j].name);
    if (joints[j].parent >= static_cast<int>(joints.size())) bad_parents.add(joints[j].name);
    for (size_t at = j; seen_from[at] == SIZE_MAX;) {
      seen_from[at] = j;
      const int parent = joints[at].parent;
      if (parent < 0 || parent >= static_cast<int>(joints.size())) break;
      at = static_cast<size_t>(parent);
      if (seen_from[at] == j) cycles.add(joints[at].name);  // walked over in this very round: once per cycle
    }
  }
  report->joints_outside = outside.count();
  report->roots = roots.count();
  report->hierarchy_cycles = cycles.count();
  if (joints.empty()) report->findings.push_back({Level::kError, "no-joints", 1, "the character has no joints"});
  bad_parents.report(Level::kError, "bad-parents", "joints with a parent that does not exist", report);
  cycles.report(Level::kError, "cycles", "cycles of joints, through", report);
  if (!joints.empty() && roots.count() == 0)
    report->findings.push_back({Level::kError, "no-root", 1, "every joint has a parent"});
  if (roots.count() > 1) roots.report(Level::kWarning, "several-roots", "joints without parent", report);
  outside.report(Level::kWarning, "joints-outside", "joints further from the mesh's box than half its longest side",
                 report);
}

void check_weights(const Character& character, CheckReport* report) {
  if (character.influences.empty()) {
    if (!character.joints.empty())
      report->findings.push_back({Level::kNote, "no-weights", 1, "the character has no weights"});
    return;
  }
  if (character.influences.size() != character.vertices.size()) {
    report->findings.push_back({Level::kError, "weight-rows", character.influences.size(),
                                std::to_string(character.influences.size()) + " rows of weights for " +
                                    std::to_string(character.vertices.size()) + " vertices"});
    return;
  }
  Examples unbound, bad_sums, bad_influences, many, idle;
  std::vector<uint32_t> without;
  std::vector<char> has_weight(character.joints.size(), 0);
  for (size_t v = 0; v < character.influences.size(); ++v) {
    double sum = 0;
    size_t count = 0;
    bool bad = false;
    for (const Influence& influence : character.influences[v]) {
      bad =
          bad || influence.joint >= character.joints.size() || !std::isfinite(influence.weight) || influence.weight < 0;
      if (bad || influence.weight == 0) continue;
      sum += static_cast<double>(influence.weight);
      ++count;
      has_weight[influence.joint] = 1;
    }
    report->max_influences = std::max(report->max_influences, count);
    if (bad) {
      bad_influences.add(v);
    } else if (count == 0) {
      unbound.add(v);
      without.push_back(static_cast<uint32_t>(v));
    } else if (std::fabs(sum - 1) > kWeightSumTolerance) {
      bad_sums.add(std::to_string(v) + " (" + std::to_string(sum) + ")");
    }
    if (count > kMostInfluences) many.add(v);
  }
  for (size_t j = 0; j < has_weight.size(); ++j)
    if (has_weight[j] == 0) idle.add(character.joints[j].name);
  report->unbound_vertices = unbound.count();
  report->bad_weight_sums = bad_sums.count();
  bad_influences.report(Level::kError, "bad-influences",
                        "vertices with a weight that is negative, not finite or of no joint", report);
  bad_sums.report(Level::kWarning, "weight-sum", "vertices whose weights do not sum to 1", report);
  unbound.report(Level::kWarning, "unbound-vertices", "vertices without weights", report);
  if (!without.empty()) report->findings.back().vertices = std::move(without);
  many.report(Level::kWarning, "many-influences", "vertices with more than 12 influences", report);
  idle.report(Level::kNote, "idle-joints", "joints without weight", report);
}

}  // namespace

CheckReport check_character(const Character& character, const BoundaryLoops& loops) {
  CheckReport report;
  report.vertices = character.vertices.size();
  report.faces = character.face_count();
  report.joints = character.joints.size();
  const Bounds box = bounds_of(character.vertices);
  check_mesh(character, box, loops, &report);
  check_skeleton(character, box, &report);
  check_weights(character, &report);
  for (LabelFinding& f : check_labels(character)) {
    report.findings.push_back(
        {Level::kWarning, f.code, std::max<size_t>(1, f.vertices.size()), std::move(f.text), std::move(f.vertices)});
  }
  std::stable_sort(report.findings.begin(), report.findings.end(),
                   [](const CheckFinding& a, const CheckFinding& b) { return a.level > b.level; });
  return report;
}

}  // namespace sinew
