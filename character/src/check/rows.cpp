// SPDX-License-Identifier: MIT
// Rows of weights by themselves, and of edges at one position.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check/findings.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

double signed_sum(const std::vector<Influence>& row) {
  double sum = 0;
  for (const Influence& i : row) sum += static_cast<double>(i.weight);
  return sum;
}

// Meshes without a skin that follow a joint or do not move are correct.
std::vector<uint8_t> props_of(const Character& c) {
  std::vector<uint8_t> props(c.vertices.size(), 0);
  if (c.vertex_meshes.size() != c.vertices.size()) return props;
  for (size_t v = 0; v < props.size(); ++v) {
    const CharacterMesh& mesh = c.meshes[c.vertex_meshes[v]];
    props[v] = !mesh.skinned ? 1 : 0;
  }
  return props;
}

void unweighted(const RigFacts& facts, Findings* findings) {
  const std::vector<uint8_t> props = props_of(facts.character);
  RigFinding finding;
  for (uint32_t v = 0; v < facts.strongest.size(); ++v)
    if (facts.strongest[v] == kNoOne && props[v] == 0) finding.vertices.push_back(v);
  finding.value = static_cast<double>(finding.vertices.size());
  finding.what = vertices_text(finding.vertices.size()) + " without weight: " + first_of(finding.vertices);
  findings->add("unweighted", std::move(finding));
}

void sums(const RigFacts& facts, Findings* findings) {
  RigFinding finding;
  double worst_sum = 1;
  const double bound = findings->bound("weight-sum");
  for (uint32_t v = 0; v < facts.strongest.size(); ++v) {
    if (facts.strongest[v] == kNoOne) continue;
    const double sum = signed_sum(facts.character.influences[v]), off = std::abs(sum - 1);
    if (off > bound) finding.vertices.push_back(v);
    if (off > finding.value) finding.value = off, worst_sum = sum;
  }
  finding.what = vertices_text(finding.vertices.size()) +
                 print(" with weights that do not sum to 1, off by up to %.3f: ", worst_sum) +
                 first_of(finding.vertices);
  findings->add("weight-sum", std::move(finding));
}

void long_rows(const RigFacts& facts, Findings* findings) {
  constexpr size_t kTaken = 4;  // JOINTS_0 of glTF: what every program takes
  RigFinding finding;
  size_t longest = 0;
  const double bound = findings->bound("influences");
  for (uint32_t v = 0; v < facts.strongest.size(); ++v) {
    std::vector<float> weights;
    for (const Influence& i : facts.character.influences[v])
      if (i.weight > 0) weights.push_back(i.weight);
    if (weights.size() <= kTaken) continue;
    std::sort(weights.begin(), weights.end(), std::greater<float>());
    double sum = 0, kept = 0;
    for (size_t i = 0; i < weights.size(); ++i) {
      sum += static_cast<double>(weights[i]);
      if (i < kTaken) kept += static_cast<double>(weights[i]);
    }
    const double cut = 1 - kept / sum;
    if (cut > bound) finding.vertices.push_back(v);
    finding.value = std::max(finding.value, cut);
    longest = std::max(longest, weights.size());
  }
  finding.what =
      vertices_text(finding.vertices.size()) +
      print(" with up to %zu joints; all but the four strongest weigh up to %.0f %%: ", longest, 100 * finding.value) +
      first_of(finding.vertices);
  findings->add("influences", std::move(finding));
}

// Edges that two faces have at the same positions but with vertices of their own: a seam of the mesh that poses may open.
void cracks(const RigFacts& facts, Findings* findings) {
  const Character& c = facts.character;
  std::vector<uint8_t> shared(c.vertices.size(),
                              0);  // a position of several vertices: without one, an edge has no other
  for (uint32_t v = 0; v < shared.size(); ++v)
    if (facts.first[v] != v) shared[facts.first[v]] = 1;
  std::map<std::array<uint32_t, 2>, std::vector<std::array<uint32_t, 2>>> edges;  // by first vertices
  for (size_t f = 0; f < c.face_count(); ++f) {
    const uint32_t begin = c.face_offsets[f], end = c.face_offsets[f + 1];
    for (uint32_t k = begin; k < end; ++k) {
      const uint32_t a = c.face_vertices[k], b = c.face_vertices[k + 1 < end ? k + 1 : begin];
      if (facts.first[a] == facts.first[b] || shared[facts.first[a]] + shared[facts.first[b]] == 0) continue;
      const bool turned = facts.first[a] > facts.first[b];
      auto& known = edges[{facts.first[turned ? b : a], facts.first[turned ? a : b]}];
      known.push_back({turned ? b : a, turned ? a : b});
    }
  }
  RigFinding finding;
  const double bound = findings->bound("crack");
  std::vector<uint8_t> marked(c.vertices.size(), 0);
  for (const auto& [positions, at] : edges) {
    if (at.size() != 2) continue;  // of more, layers lie on each other
    for (size_t end = 0; end < 2; ++end) {
      const uint32_t a = at[0][end], b = at[1][end];
      if (a == b || facts.strongest[a] == kNoOne || facts.strongest[b] == kNoOne) continue;
      const double apart = facts.difference(a, b);
      finding.value = std::max(finding.value, apart);
      if (!(apart > bound)) continue;
      marked[a] = marked[b] = 1;
    }
  }
  for (uint32_t v = 0; v < marked.size(); ++v)
    if (marked[v] != 0) finding.vertices.push_back(v);
  finding.what = vertices_text(finding.vertices.size()) +
                 " of edges at one position have different weights: " + first_of(finding.vertices);
  findings->add("crack", std::move(finding));
}

}  // namespace

void check_rows(const RigFacts& facts, Findings* findings) {
  unweighted(facts, findings);
  sums(facts, findings);
  long_rows(facts, findings);
  cracks(facts, findings);
}

}  // namespace sinew
