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
  // Half a forearm, or a bone that shares its turn, is no hand.
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

bool pin_plain_names(const Hierarchy& target, const Hierarchy& source, const int32_t* sources, Pins* pins) {
  if (!goes_upright(target) || !goes_upright(source)) return false;  // four legs have names of their own
  int32_t pairs[2 * (sizeof kLimbs / sizeof kLimbs[0]) + 1][2], count = 0, wrong = 0;
  const auto look_for = [&](Part part, int8_t side) {
    const int32_t a = only_joint(target, part, side), b = only_joint(source, part, side);
    if (a < 0 || b < 0 || pins->source_of[a] != Pins::kFree || pins->target_of[b] != Pins::kFree) return;
    wrong += sources[a] == b ? 0 : 1;
    pairs[count][0] = a;
    pairs[count++][1] = b;
  };
  for (const Part part : kLimbs) {
    look_for(part, 1);
    look_for(part, -1);
  }
  look_for(Part::kHead, 0);
  if (count < kFewestPairs || wrong == 0) return false;
  for (int32_t k = 0; k < count; ++k) {
    pins->source_of[pairs[k][0]] = pairs[k][1];
    pins->target_of[pairs[k][1]] = pairs[k][0];
  }
  pins->any = true;
  return true;
}

}  // namespace sinew::mapping
