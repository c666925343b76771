// SPDX-License-Identifier: MIT
// Compares joint names with their parents, their sides and their positions on a body.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "check/findings.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

enum class Limb : uint8_t { kNone, kTrunk, kHead, kArm, kLeg };

// How far out on its limb a class is.
struct LimbRank {
  Limb limb = Limb::kNone;
  int rank = 0;
};

LimbRank limb_rank(uint8_t one) {
  switch (one) {
    case SINEW_CLASS_PELVIS:
      return {Limb::kTrunk, 0};
    case SINEW_CLASS_SPINE:
      return {Limb::kTrunk, 1};
    case SINEW_CLASS_NECK:
      return {Limb::kHead, 0};
    case SINEW_CLASS_HEAD:
      return {Limb::kHead, 1};
    case SINEW_CLASS_CLAVICLE:
      return {Limb::kArm, 0};
    case SINEW_CLASS_UPPER_ARM:
      return {Limb::kArm, 1};
    case SINEW_CLASS_FOREARM:
      return {Limb::kArm, 2};
    case SINEW_CLASS_HAND:
      return {Limb::kArm, 3};
    case SINEW_CLASS_HIP:
      return {Limb::kLeg, 0};
    case SINEW_CLASS_THIGH:
      return {Limb::kLeg, 1};
    case SINEW_CLASS_CALF:
      return {Limb::kLeg, 2};
    case SINEW_CLASS_FOOT:
      return {Limb::kLeg, 3};
    case SINEW_CLASS_TOE:
      return {Limb::kLeg, 4};
    default:
      return {};
  }
}

// The nearest joint above that is one of a limb, -1 = none.
int classed_above(const RigFacts& facts, size_t joint) {
  for (int up = facts.character.joints[joint].parent; up >= 0;
       up = facts.character.joints[static_cast<size_t>(up)].parent)
    if (limb_rank(facts.verdicts.classes[static_cast<size_t>(up)]).limb != Limb::kNone &&
        facts.verdicts.roles[static_cast<size_t>(up)] == SINEW_ROLE_DEFORMS)
      return up;
  return -1;
}

void order(const RigFacts& facts, Findings* findings) {
  for (size_t j = 0; j < facts.character.joints.size(); ++j) {
    if (facts.verdicts.roles[j] != SINEW_ROLE_DEFORMS || !facts.bound || facts.weight[j] <= 0) continue;
    const LimbRank own = limb_rank(facts.verdicts.classes[j]);
    const int above = classed_above(facts, j);
    if (own.limb == Limb::kNone || own.limb == Limb::kTrunk || facts.verdicts.classes[j] == SINEW_CLASS_TOE ||
        above < 0 || facts.weight[static_cast<size_t>(above)] <= 0)
      continue;
    if (!facts.is_single(j) || !facts.is_single(static_cast<size_t>(above))) continue;
    const LimbRank up = limb_rank(facts.verdicts.classes[static_cast<size_t>(above)]);
    const int side = facts.verdicts.sides[j], their_side = facts.verdicts.sides[static_cast<size_t>(above)];
    // A foreleg is a child of a shoulder. The end of a chain may be named after the whole chain: IKBackLeg under
    // BackLowerLeg.
    if (own.limb == Limb::kLeg && facts.verdicts.classes[static_cast<size_t>(above)] == SINEW_CLASS_CLAVICLE) continue;
    std::string why;
    if (own.limb == up.limb && own.rank < up.rank && !facts.tree.children[j].empty())
      why = "unlike its children";
    else if (own.limb != up.limb && (up.limb == Limb::kArm || up.limb == Limb::kLeg) && own.limb != Limb::kNone)
      why = "which is another limb";
    else if (own.limb == up.limb && side != 0 && their_side != 0 && side != their_side)
      why = "which is on the other side";
    // A joint in the middle is not a limb, so it cannot be a wrong parent: a robot's base, the one shoulder of a
    // horse.
    if (why.empty() || (their_side == 0 && up.limb != Limb::kHead)) continue;
    RigFinding finding;
    finding.joint = static_cast<int>(j);
    finding.other = above;
    finding.value = own.limb == up.limb && (side == their_side || side == 0 || their_side == 0) ? 1 : kOtherLimb;
    finding.what = findings->quoted(finding.joint) + ", a " + joint_class_text(facts.verdicts.classes[j]) +
                   " by its name, is a child of " + findings->quoted(above) + ", " + why;
    findings->add("name-order", std::move(finding));
  }
}

// Joints that names pair, left first, and how far they are apart.
struct Pair {
  size_t left = 0, right = 0;
  Point3 across = {};  // from the right one to the left one
};

std::vector<Pair> pairs_of(const RigFacts& facts) {
  std::vector<Pair> pairs;
  const auto& partners = facts.verdicts.partners;
  for (size_t j = 0; j < partners.size(); ++j) {
    if (facts.verdicts.sides[j] != 1 || partners[j] < 0 || facts.verdicts.roles[j] == SINEW_ROLE_CONTROL) continue;
    const size_t other = static_cast<size_t>(partners[j]);
    if (partners[other] != static_cast<int32_t>(j)) continue;
    pairs.push_back(
        {j, other, point(facts.character.joints[j].position) - point(facts.character.joints[other].position)});
  }
  return pairs;
}

// Where the toes point, level; none where feet do not agree or there are none.
Point3 toes_ahead(const RigFacts& facts, const Point3& up) {
  Point3 ahead = {};
  size_t feet = 0;
  for (size_t j = 0; j < facts.character.joints.size(); ++j) {
    if (facts.verdicts.classes[j] != SINEW_CLASS_FOOT || facts.moves[j].empty()) continue;
    bool above = false;
    for (int p = facts.character.joints[j].parent; p >= 0; p = facts.character.joints[static_cast<size_t>(p)].parent)
      above = above || facts.verdicts.classes[static_cast<size_t>(p)] == SINEW_CLASS_FOOT;
    if (above) continue;
    Point3 middle = {};
    for (const uint32_t v : facts.moves[j]) middle = middle + point(facts.character.vertices[v]);
    for (const uint32_t child : facts.tree.children[j])
      for (const uint32_t v : facts.moves[child]) middle = middle + point(facts.character.vertices[v]);
    size_t count = facts.moves[j].size();
    for (const uint32_t child : facts.tree.children[j]) count += facts.moves[child].size();
    const Point3 to =
        across((1.0 / static_cast<double>(count)) * middle - point(facts.character.joints[j].position), up);
    ahead = ahead + unit(to);
    ++feet;
  }
  if (feet < 2 || length(ahead) < 0.8 * static_cast<double>(feet)) return {};
  return unit(ahead);
}

// The axis that the body stands along: from feet to head.
Point3 upwards(const RigFacts& facts) {
  Point3 feet = {}, head = {};
  size_t foot_count = 0, head_count = 0;
  for (size_t j = 0; j < facts.character.joints.size(); ++j) {
    const Point3 at = point(facts.character.joints[j].position);
    if (facts.verdicts.classes[j] == SINEW_CLASS_FOOT) feet = feet + at, ++foot_count;
    if (facts.verdicts.classes[j] == SINEW_CLASS_HEAD || facts.verdicts.classes[j] == SINEW_CLASS_PELVIS)
      head = head + at, ++head_count;
  }
  if (foot_count == 0 || head_count == 0) return {0, 1, 0};
  const Point3 to = (1.0 / static_cast<double>(head_count)) * head - (1.0 / static_cast<double>(foot_count)) * feet;
  size_t axis = 0;
  for (size_t i = 1; i < 3; ++i)
    if (std::abs(to[i]) > std::abs(to[axis])) axis = i;
  Point3 up = {};
  up[axis] = to[axis] > 0 ? 1 : -1;
  // Animals are longer than they are high; their files say y.
  return axis == 1 || foot_count == 2 ? up : Point3{0, 1, 0};
}

void sides(const RigFacts& facts, Findings* findings) {
  const std::vector<Pair> pairs = pairs_of(facts);
  const uint32_t axis = facts.verdicts.mirror_axis;
  double left = 0, right = 0;
  for (const Pair& p : pairs) (p.across[axis] > 0 ? left : right) += std::abs(p.across[axis]);
  if (!(left + right > 0)) return;
  const double usual = left >= right ? 1 : -1;
  for (const Pair& p : pairs) {
    const double wrong = -usual * p.across[axis];
    if (!facts.is_limb(p.left) || wrong < 0.02 * facts.size || std::abs(p.across[axis]) < 0.7 * length(p.across))
      continue;
    RigFinding finding;
    finding.joint = static_cast<int>(p.left);
    finding.other = static_cast<int>(p.right);
    finding.value = 1;
    finding.what = findings->quoted(finding.joint) + " is on the side of the joints called right, and " +
                   findings->quoted(finding.other) + " is on the side of the left ones";
    findings->add("sides", std::move(finding));
  }
  const Point3 up = upwards(facts), ahead = facts.bound ? toes_ahead(facts, up) : Point3{};
  const double is_left = usual * cross(up, ahead)[axis];
  if (!(is_left < -0.8)) return;
  RigFinding finding;
  finding.value = static_cast<double>(pairs.size());
  finding.what = "all joints called left are on the character's right, judging by its toes";
  findings->add("sides", std::move(finding));
}

// A body without names laid over the joints, against what their names say.
void against_body(const RigFacts& facts, Findings* findings) {
  MapRig rig = map_rig_of(facts.character);
  MapSkeletonOptions options;
  options.names = false;
  double worst = -1, most = 0;
  bool person = false;  // an animal's forelegs are arms to one and legs to another
  std::array<int, 2> example = {-1, -1};
  std::string text;
  for (const char* const kind : {"mixamo", "quadruped"}) {
    MapRig body;
    body.name = kind;
    body.joints = skeleton_template(kind);
    const std::vector<uint8_t> classes = joint_verdicts(body.joints).classes;
    const MappedSkeleton map = map_skeleton(rig, body, options);
    size_t known = 0, other = 0;
    std::array<int, 2> first = {-1, -1};
    for (size_t j = 0; j < map.sources.size(); ++j) {
      if (map.sources[j] < 0 || !facts.is_single(j)) continue;
      const Limb said = limb_rank(facts.verdicts.classes[j]).limb,
                 found = limb_rank(classes[static_cast<size_t>(map.sources[j])]).limb;
      if (said == Limb::kNone || found == Limb::kNone) continue;
      ++known;
      if (said == found || said == Limb::kTrunk || found == Limb::kTrunk) continue;
      ++other;
      if (first[0] < 0) first = {static_cast<int>(j), map.sources[j]};
    }
    const double score = static_cast<double>(map.certainty) * static_cast<double>(known);
    if (known < 4 || score <= most) continue;
    most = score;
    person = std::string(kind) == "mixamo";
    worst = static_cast<double>(other) / static_cast<double>(known);
    example = first;
    if (first[0] >= 0) text = body.joints[static_cast<size_t>(first[1])].name;
  }
  if (worst < 0 || example[0] < 0 || !person) return;
  RigFinding finding;
  finding.joint = example[0];
  finding.value = worst;
  finding.what = print("%.0f %% of the limb joints are in other limbs than their names say: ", 100 * worst) +
                 findings->quoted(example[0]) + " is in " + text;
  findings->add("name-place", std::move(finding));
}

}  // namespace

void check_names(const RigFacts& facts, Findings* findings) {
  order(facts, findings);
  sides(facts, findings);
  bool named = false;
  for (size_t j = 0; j < facts.character.joints.size(); ++j)
    named =
        named || facts.verdicts.classes[j] == SINEW_CLASS_UPPER_ARM || facts.verdicts.classes[j] == SINEW_CLASS_THIGH;
  if (named) against_body(facts, findings);
}

}  // namespace sinew
