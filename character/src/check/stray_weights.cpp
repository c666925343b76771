// SPDX-License-Identifier: MIT
// Weight where it does not belong: what check_labels() suspects, vertices unlike all around them, islands of a joint's weight.
#include <algorithm>
#include <map>
#include <utility>

#include "check/findings.hpp"
#include "sinew_character/check/label_check.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// Least share of an island's weight that counts as a bone's; less is blur.
constexpr double kSupport = 0.05;
constexpr size_t kLeastRing = 3;

void labels(const RigFacts& facts, Findings* findings) {
  static const std::map<std::string, const char*> kRuleOf = {{"far-weight", "far-weight"},
                                                             {"island", "far-weight"},
                                                             {"odd-vertex", "speck"},
                                                             {"left-right", "left-right"},
                                                             {"idle-twin", "dead-joint"}};
  for (LabelFinding& label : check_labels(facts.character)) {
    const auto rule = kRuleOf.find(label.code);
    if (rule == kRuleOf.end()) continue;  // shared-position is about what a data set teaches
    RigFinding finding;
    finding.joint = static_cast<int>(label.joint);
    finding.other = static_cast<int>(label.better);
    finding.value = label.vertices.empty() ? 1 : static_cast<double>(label.vertices.size());
    finding.vertices = std::move(label.vertices);
    finding.what = std::move(label.text);
    findings->add(rule->second, std::move(finding));
  }
}

// Vertices that no neighbor is like, while their joint is not the nearest: noise, and strokes of a wrong brush.
void specks(const RigFacts& facts, Findings* findings) {
  constexpr double kUnlike = 0.8;    // L1 to the neighbor that is most alike
  constexpr double kClearly = 0.05;  // of the size: so much farther than a neighbor's joint
  RigFinding finding;
  const BoneDistance distance(facts.character);
  for (uint32_t v = 0; v < facts.rings.size(); ++v) {
    const std::vector<uint32_t>& ring = facts.rings[v];
    if (ring.size() < kLeastRing || facts.strongest[v] == kNoOne) continue;
    bool alone = true, nearest = true;
    for (size_t n = 0; n < ring.size() && alone; ++n)
      alone = facts.strongest[ring[n]] != kNoOne && facts.difference(v, ring[n]) > kUnlike;
    if (!alone) continue;
    const Vec3& p = facts.character.vertices[v];
    const double own = distance(p, facts.strongest[v]);
    for (const uint32_t n : ring) nearest = nearest && own <= distance(p, facts.strongest[n]) + kClearly;
    if (!nearest) finding.vertices.push_back(v);
  }
  finding.value = static_cast<double>(finding.vertices.size());
  finding.what = vertices_text(finding.vertices.size()) + " unlike all neighbors: " + first_of(finding.vertices);
  findings->add("speck", std::move(finding));
}

// Vertices of a joint that lie nearer to its twin's bones than to its own.
std::vector<uint32_t> nearer_to_twin(const RigFacts& facts, const BoneDistance& distance, size_t joint, size_t twin) {
  std::vector<uint32_t> out;
  for (const uint32_t v : facts.moves[joint]) {
    const Vec3& p = facts.character.vertices[v];
    if (distance(p, twin) < distance(p, joint)) out.push_back(v);
  }
  return out;
}

// Twins of which each moves what is the other's.
void exchanged(const RigFacts& facts, Findings* findings) {
  constexpr double kMost = 0.7;  // of the vertices of both
  const BoneDistance distance(facts.character);
  for (size_t j = 0; j < facts.moves.size(); ++j) {
    const int32_t partner = facts.verdicts.partners[j];
    if (partner <= static_cast<int32_t>(j) || !facts.is_body(j)) continue;
    const size_t twin = static_cast<size_t>(partner);
    if (facts.moves[j].size() < kLeastRing || facts.moves[twin].size() < kLeastRing) continue;
    RigFinding finding;
    finding.vertices = nearer_to_twin(facts, distance, j, twin);
    const std::vector<uint32_t> others = nearer_to_twin(facts, distance, twin, j);
    const auto most = [&](const std::vector<uint32_t>& some, size_t of) {
      return static_cast<double>(some.size()) > kMost * static_cast<double>(facts.moves[of].size());
    };
    if (!most(finding.vertices, j) || !most(others, twin)) continue;
    finding.vertices.insert(finding.vertices.end(), others.begin(), others.end());
    finding.joint = static_cast<int>(j);
    finding.other = partner;
    finding.value = static_cast<double>(finding.vertices.size());
    finding.what = findings->quoted(finding.joint) + " and " + findings->quoted(partner) + " have each other's weights";
    findings->add("left-right", std::move(finding));
  }
}

// Pieces of the surface on which a joint has weight. A piece without a vertex that the joint moves most, on a part of the mesh that has
// such vertices elsewhere, is where a brush or a bind went through a gap.
class Islands {
 public:
  //   weights  of the joint, of vertices that are the first at their positions
  Islands(const RigFacts& facts, const BoneDistance& distance, uint32_t joint, std::map<uint32_t, double> weights)
      : facts_(facts), distance_(distance), joint_(joint), weights_(std::move(weights)) {}

  void find(Findings* findings) {
    std::vector<std::vector<uint32_t>> pieces;
    std::map<uint32_t, uint8_t> seen;
    std::map<uint32_t, bool> has_core;  // by part of the mesh
    std::vector<bool> core;
    for (const auto& [start, weight] : weights_) {
      if (!seen.emplace(start, 1).second) continue;
      std::vector<uint32_t> piece = {start};
      bool own = false;
      for (size_t k = 0; k < piece.size(); ++k) {
        own = own || facts_.strongest[piece[k]] == joint_;
        for (const uint32_t n : facts_.rings[piece[k]])
          if (weights_.count(n) != 0 && seen.emplace(n, 1).second) piece.push_back(n);
      }
      has_core[facts_.parts[start]] = has_core[facts_.parts[start]] || own;
      core.push_back(own);
      pieces.push_back(std::move(piece));
    }
    far_pieces(pieces, core, findings);
    RigFinding finding;
    for (size_t p = 0; p < pieces.size(); ++p) {
      if (core[p] || !has_core[facts_.parts[pieces[p][0]]]) continue;
      double most = 0;
      for (const uint32_t v : pieces[p]) most = std::max(most, weights_[v]);
      finding.value = std::max(finding.value, most);
      if (most > findings->bound("leak"))
        finding.vertices.insert(finding.vertices.end(), pieces[p].begin(), pieces[p].end());
    }
    finding.joint = static_cast<int>(joint_);
    finding.what = vertices_text(finding.vertices.size()) + print(" with up to %.2f weight for ", finding.value) +
                   findings->quoted(finding.joint) +
                   " are apart from everything else it moves: " + first_of(finding.vertices);
    findings->add("leak", std::move(finding));
  }

 private:
  // Pieces that the joint moves most and that lie far from its bones, while nearly all of what it moves lies near.
  void far_pieces(const std::vector<std::vector<uint32_t>>& pieces, const std::vector<bool>& core,
                  Findings* findings) const {
    constexpr double kFar = 0.12, kFarther = 2.5, kSmall = 0.2;  // of the size; than most of its vertices; of these
    std::vector<double> usual;
    for (const uint32_t v : facts_.moves[joint_]) usual.push_back(distance_(facts_.character.vertices[v], joint_));
    if (usual.size() < 8) return;
    std::sort(usual.begin(), usual.end());
    const double bound = std::max(kFar, kFarther * usual[usual.size() * 3 / 4]);
    RigFinding finding;
    for (size_t p = 0; p < pieces.size(); ++p) {
      if (!core[p]) continue;
      size_t own = 0;
      bool far = true;
      for (const uint32_t v : pieces[p]) {
        if (facts_.strongest[v] != joint_) continue;
        ++own;
        far = far && distance_(facts_.character.vertices[v], joint_) > bound;
      }
      if (!far || static_cast<double>(own) > kSmall * static_cast<double>(usual.size())) continue;
      finding.vertices.insert(finding.vertices.end(), pieces[p].begin(), pieces[p].end());
    }
    finding.joint = static_cast<int>(joint_);
    finding.value = static_cast<double>(finding.vertices.size());
    finding.what = vertices_text(finding.vertices.size()) + " bound to " + findings->quoted(finding.joint) +
                   " far from everything else it moves: " + first_of(finding.vertices);
    findings->add("far-weight", std::move(finding));
  }

  const RigFacts& facts_;
  const BoneDistance& distance_;
  uint32_t joint_;
  std::map<uint32_t, double> weights_;
};

}  // namespace

void check_stray_weights(const RigFacts& facts, Findings* findings) {
  labels(facts, findings);
  specks(facts, findings);
  exchanged(facts, findings);
  std::vector<std::map<uint32_t, double>> weights(facts.moves.size());
  for (uint32_t v = 0; v < facts.first.size(); ++v) {
    if (facts.first[v] != v) continue;
    for (const Influence& i : facts.character.influences[v])
      if (const double weight = facts.weight_of(v, i.joint); weight > kSupport) weights[i.joint][v] = weight;
  }
  const BoneDistance distance(facts.character);
  for (uint32_t j = 0; j < weights.size(); ++j)
    if (!weights[j].empty()) Islands(facts, distance, j, std::move(weights[j])).find(findings);
}

}  // namespace sinew
