// SPDX-License-Identifier: MIT
// A copy of every bone beside it, or another odd hierarchy, hides a body from anatomy whose joints are all called by their names.
#include "mapping/matcher.hpp"

namespace sinew::mapping {
namespace {

constexpr Part kLimbs[] = {Part::kUpperArm, Part::kLowerArm, Part::kHand, Part::kUpLeg, Part::kLowLeg, Part::kFoot};
constexpr double kUpright = 0.8;     // cosine
constexpr int32_t kFewestPairs = 6;  // pairs of names

// The one joint that is called that and nothing else, or the first of a chain of them; -1 = none or several.
int32_t only_joint(const Hierarchy& rig, Part part, int8_t side) {
  int32_t found = -1;
  for (int32_t k = 0; k < rig.n; ++k) {
    const int32_t i = rig.order[k];
    const JointName& name = rig.names[i];
    if (rig.end[i] != 0 || !name.exact || name.plain != part || name.side != side) continue;
    if (found >= 0 && !rig.holds(found, i)) return -1;
    if (found < 0) found = i;
  }
  return found;
}

// Whether the head is over where legs begin, seen from the feet; false where one of them is not called by its name.
bool goes_upright(const Hierarchy& rig) {
  const auto middle = [&](Part part, Point* sum) {
    const int32_t left = only_joint(rig, part, 1), right = only_joint(rig, part, -1);
    if (left < 0 || right < 0) return false;
    *sum = 0.5 * (rig.at[left] + rig.at[right]);
    return true;
  };
  Point hips, feet;
  const int32_t head = only_joint(rig, Part::kHead, 0);
  if (head < 0 || !middle(Part::kUpLeg, &hips) || !middle(Part::kFoot, &feet)) return false;
  const Point trunk = rig.at[head] - hips, legs = hips - feet;
  const double along = dot(trunk, legs);
  return along > 0 && along * along > kUpright * kUpright * dot(trunk, trunk) * dot(legs, legs);
}

// Parts of a body that move alike.
enum class Region : uint8_t { kNone, kTrunk, kHead, kFace, kLimb, kDigit, kTail, kHair, kBreast, kProp };

// Words that some rigs use for others are none: a face for a head, a shoulder without a side for a chest, the middle of a leg.
Region region_of(const JointName& name) {
  switch (name.plain) {
    case Part::kHips:
    case Part::kSpine:
      return Region::kTrunk;
    case Part::kNeck:
    case Part::kHead:
      return Region::kHead;
    case Part::kEye:
    case Part::kJaw:
      return Region::kFace;
    case Part::kHair:
    case Part::kEar:
      return Region::kHair;
    case Part::kTail:
      return Region::kTail;
    case Part::kBreast:
      return Region::kBreast;
    case Part::kProp:
      return Region::kProp;
    case Part::kNone:
    case Part::kFace:
    case Part::kMiddle:
    case Part::kMeta:
      return Region::kNone;
    default:
      return name.side == 0 ? Region::kNone : is_finger(name.plain) ? Region::kDigit : Region::kLimb;
  }
}

}  // namespace

bool contradict(const JointName& a, const JointName& b) {
  // Half a forearm, or a bone that shares its rotation, is no hand.
  const auto twist_for_end = [](const JointName& twist, const JointName& end) {
    return twist.has(names::kTwist | names::kHalf) && (end.plain == Part::kHand || end.plain == Part::kFoot);
  };
  if (twist_for_end(a, b) || twist_for_end(b, a)) return true;
  const Region x = region_of(a), y = region_of(b);
  if (x == Region::kNone || y == Region::kNone) return false;
  if (x == y) return x == Region::kFace && a.plain != b.plain;
  const auto are = [&](Region one, Region other) { return (x == one && y == other) || (x == other && y == one); };
  if (are(Region::kLimb, Region::kDigit)) {  // a hand and its fingers, a foot and its toes, a leg's last bones
    const Part limb = x == Region::kLimb ? a.plain : b.plain;
    return limb == Part::kShoulder || limb == Part::kUpperArm || limb == Part::kLowerArm || limb == Part::kUpLeg;
  }
  return !are(Region::kTrunk, Region::kTail) && !are(Region::kTrunk, Region::kHead);
}

namespace {

bool is_leg_part(Part part) {
  return part == Part::kUpLeg || part == Part::kLowLeg || part == Part::kLeg || part == Part::kFoot ||
         part == Part::kToe || part == Part::kForeLeg || part == Part::kHindLeg;
}

// Joints that are to belong together and are free to.
struct NamedPairs {
  const int32_t* sources;
  Pins* pins;
  int32_t joints[32][2] = {}, count = 0, wrong = 0;

  void add(int32_t a, int32_t b) {
    if (a < 0 || b < 0 || pins->source_of[a] != Pins::kFree || pins->target_of[b] != Pins::kFree) return;
    wrong += sources[a] == b ? 0 : 1;
    joints[count][0] = a;
    joints[count++][1] = b;
  }
  // False where the map has them all.
  bool pin() {
    for (int32_t k = 0; k < count && wrong > 0; ++k) {
      pins->source_of[joints[k][0]] = joints[k][1];
      pins->target_of[joints[k][1]] = joints[k][0];
      pins->any = true;
    }
    return wrong > 0;
  }
};

// One side's joints by their names; -1 = none.
struct NamedArm {
  int32_t shoulder = -1, upper = -1, lower = -1, hand = -1;
};

// An arm of numbered joints bends at that nearest to its middle.
NamedArm named_arm(const Hierarchy& rig, int8_t side) {
  NamedArm arm;
  arm.shoulder = only_joint(rig, Part::kShoulder, side);
  arm.upper = only_joint(rig, Part::kUpperArm, side);
  arm.lower = only_joint(rig, Part::kLowerArm, side);
  arm.hand = only_joint(rig, Part::kHand, side);
  if (arm.upper < 0 || arm.hand < 0 || !rig.holds(arm.upper, arm.hand)) return NamedArm();
  if (arm.lower >= 0) return arm;
  double whole = 0, path = 0, least = 0;
  for (int32_t i = arm.hand; i != arm.upper; i = rig.parent[i]) whole += rig.bone(i, rig.parent[i]);
  for (int32_t i = arm.hand; rig.parent[i] != arm.upper; i = rig.parent[i]) {
    path += rig.bone(i, rig.parent[i]);
    const double off = absolute(path - 0.5 * whole);
    if (arm.lower >= 0 && off >= least) continue;
    arm.lower = rig.parent[i];
    least = off;
  }
  return arm;
}

// Returns whether a body has an arm and a head but no legs by names.
bool is_legless(const Hierarchy& rig) {
  for (int32_t i = 0; i < rig.n; ++i)
    if (is_leg_part(limb_part(rig.part(i))) || is_leg_part(rig.part(i))) return false;
  return only_joint(rig, Part::kHead, 0) >= 0 && (named_arm(rig, 1).hand >= 0 || named_arm(rig, -1).hand >= 0);
}

// Joints that are called spine, from the root on.
int32_t named_spine(const Hierarchy& rig, int32_t* spine, int32_t most) {
  int32_t count = 0;
  for (int32_t k = 0; k < rig.n && count < most; ++k) {
    const int32_t i = rig.order[k];
    if (rig.names[i].exact && rig.names[i].plain == Part::kSpine && rig.end[i] == 0) spine[count++] = i;
  }
  return count;
}

}  // namespace

bool is_leg_in_hand(const Hierarchy& target, const Hierarchy& source, const Pins& pins, const int32_t* sources,
                    int32_t joint) {
  const Part part = source.part(sources[joint]);
  if (!is_leg_part(part)) return false;
  for (int32_t at = target.parent[joint]; at >= 0; at = target.parent[at]) {
    if (!target.names[at].exact || target.part(at) != Part::kHand) continue;
    if (part != Part::kFoot && part != Part::kToe) return true;
    const int32_t own = pins.any && pins.source_of[at] >= 0 ? pins.source_of[at] : sources[at];
    if (own >= 0) return !source.holds(own, sources[joint]);
  }
  return false;
}

bool pin_legless_names(const Hierarchy& target, const Hierarchy& source, const int32_t* sources, Pins* pins) {
  if (!is_legless(target) && !is_legless(source)) return false;
  constexpr int32_t kMostSpines = 16;
  NamedPairs pairs = {sources, pins};
  for (int8_t side = -1; side <= 1; side = static_cast<int8_t>(side + 2)) {
    const NamedArm a = named_arm(target, side), b = named_arm(source, side);
    pairs.add(a.shoulder, b.shoulder);
    pairs.add(a.upper, b.upper);
    pairs.add(a.lower, b.lower);
    pairs.add(a.hand, b.hand);
  }
  pairs.add(only_joint(target, Part::kHead, 0), only_joint(source, Part::kHead, 0));
  pairs.add(only_joint(target, Part::kNeck, 0), only_joint(source, Part::kNeck, 0));
  int32_t a[kMostSpines], b[kMostSpines];
  const int32_t n = named_spine(target, a, kMostSpines), m = named_spine(source, b, kMostSpines);
  const int32_t both = n < m ? n : m;
  for (int32_t k = 0; k < both; ++k) pairs.add(a[k * n / both], b[k * m / both]);
  return pairs.pin();
}

bool pin_plain_names(const Hierarchy& target, const Hierarchy& source, const int32_t* sources, Pins* pins) {
  if (!goes_upright(target) || !goes_upright(source)) return false;  // four legs have names of their own
  NamedPairs pairs = {sources, pins};
  const auto look_for = [&](Part part, int8_t side) {
    pairs.add(only_joint(target, part, side), only_joint(source, part, side));
  };
  for (const Part part : kLimbs) {
    look_for(part, 1);
    look_for(part, -1);
  }
  look_for(Part::kHead, 0);
  return pairs.count >= kFewestPairs && pairs.pin();
}

}  // namespace sinew::mapping
