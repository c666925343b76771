// SPDX-License-Identifier: MIT
// How heavy findings are, once all are there: what both sides of a body have alike is how it was built, and a few vertices that follow a joint
// close by are a slip that hardly shows. Both are notes. Chosen on families of train with `sinew-lab eval check`.
#include <algorithm>
#include <cstring>

#include "check/findings.hpp"
#include "sinew_character/check/label_check.hpp"

namespace sinew {
namespace {

constexpr double kClose = 0.3;  // of the size, from a joint's bones: weight for it does not reach across the body
constexpr size_t kFew = 4;      // vertices; in fine meshes
constexpr size_t kPair = 2;
constexpr double kFewShare = 0.005;  // of the vertices
constexpr double kBothAlike = 2;     // ratio of the values of both sides
constexpr double kRigid = 0.8;       // of the vertices follow one joint: a body of rigid parts, whose seams open
constexpr size_t kLeastPairs = 6;    // of joints called left and right: of machines with fewer, toes say little

bool is_one_of(const RigFinding& f, std::initializer_list<const char*> rules) {
  return std::any_of(rules.begin(), rules.end(),
                     [&](const char* rule) { return std::strcmp(f.rule->name, rule) == 0; });
}

class Weigher {
 public:
  explicit Weigher(const RigFacts& facts) : facts_(facts), distance_(facts.character) {
    size_t rigid = 0, all = 0;
    for (uint32_t v = 0; v < facts.strongest.size(); ++v) {
      if (facts.strongest[v] == kNoOne) continue;
      ++all;
      rigid += facts.weight_of(v, facts.strongest[v]) > 0.99 ? 1 : 0;
    }
    rigid_body_ = static_cast<double>(rigid) > kRigid * static_cast<double>(all);
  }

  bool is_light(const RigFinding& f, const std::vector<RigFinding>& all) const {
    if (is_one_of(f, {"speck"})) return is_few(f) && is_close(f);
    if (is_one_of(f, {"left-right"})) return f.vertices.size() <= kPair;
    if (is_one_of(f, {"far-weight"})) return is_close(f) && (is_few(f) || on_both_sides(f, all));
    if (is_one_of(f, {"leak"})) return f.vertices.size() <= kPair || is_next(f) || on_both_sides(f, all);
    if (is_one_of(f, {"joint-outside", "zero-length", "lost-volume"})) return on_both_sides(f, all);
    if (is_one_of(f, {"name-order"})) return f.value < kOtherLimb && on_both_sides(f, all);
    if (is_one_of(f, {"tear"})) return is_few(f) || (rigid_body_ && on_both_sides(f, all));
    if (is_one_of(f, {"flip"})) return is_few(f);
    if (is_one_of(f, {"crack"})) return f.vertices.size() <= 2 * kPair;  // one edge
    if (is_one_of(f, {"unlike-joints"})) return !facts_.is_limb(static_cast<size_t>(f.joint));
    if (is_one_of(f, {"unlike-weights"})) return f.value < 2 * f.bound;
    return is_one_of(f, {"sides"}) && f.joint < 0 && f.value < static_cast<double>(kLeastPairs);
  }

 private:
  bool is_few(const RigFinding& f) const {
    const double share = kFewShare * static_cast<double>(facts_.character.vertices.size());
    return f.vertices.size() <= kFew || static_cast<double>(f.vertices.size()) <= share;
  }

  // All of its vertices, to the joint that moves each most.
  bool is_close(const RigFinding& f) const {
    return std::all_of(f.vertices.begin(), f.vertices.end(), [&](uint32_t v) {
      return facts_.strongest[v] != kNoOne && distance_(facts_.character.vertices[v], facts_.strongest[v]) < kClose;
    });
  }

  // The weight is for a parent, a child, a grandparent or a grandchild of what moves the vertices most.
  bool is_next(const RigFinding& f) const {
    return std::all_of(f.vertices.begin(), f.vertices.end(), [&](uint32_t v) {
      return facts_.strongest[v] != kNoOne && (is_near_above(f.joint, static_cast<int>(facts_.strongest[v])) ||
                                               is_near_above(static_cast<int>(facts_.strongest[v]), f.joint));
    });
  }

  bool is_near_above(int above, int joint) const {
    for (int step = 0; step < 3 && joint >= 0; ++step) {
      if (joint == above) return true;
      joint = facts_.character.joints[static_cast<size_t>(joint)].parent;
    }
    return false;
  }

  // The other one of a pair, or another joint of its class on the other side; of the middle itself.
  bool are_twins(int a, int b) const {
    if (a < 0 || b < 0) return a == b;
    const size_t i = static_cast<size_t>(a), j = static_cast<size_t>(b);
    if (a == b || facts_.verdicts.partners[i] >= 0)
      return a == b ? facts_.verdicts.partners[i] < 0 : facts_.verdicts.partners[i] == b;
    return facts_.verdicts.sides[i] != 0 && facts_.verdicts.sides[i] == -facts_.verdicts.sides[j] &&
           facts_.verdicts.classes[i] == facts_.verdicts.classes[j];
  }

  bool on_both_sides(const RigFinding& f, const std::vector<RigFinding>& all) const {
    return std::any_of(all.begin(), all.end(), [&](const RigFinding& g) {
      return &f != &g && g.rule == f.rule && g.pose == f.pose && g.value <= kBothAlike * f.value &&
             f.value <= kBothAlike * g.value &&
             ((are_twins(f.joint, g.joint) && are_twins(f.other, g.other)) ||
              (are_twins(f.joint, g.other) && are_twins(f.other, g.joint)));
    });
  }

  const RigFacts& facts_;
  const BoneDistance distance_;
  bool rigid_body_ = false;
};

}  // namespace

void weigh_findings(const RigFacts& facts, Findings* findings) {
  const Weigher weigher(facts);
  std::vector<RigFinding>& all = findings->all();
  std::vector<uint8_t> light(all.size(), 0);
  for (size_t i = 0; i < all.size(); ++i) light[i] = weigher.is_light(all[i], all) ? 1 : 0;
  for (size_t i = 0; i < all.size(); ++i)
    if (light[i] != 0) all[i].severity = CheckSeverity::kNote;
}

}  // namespace sinew
