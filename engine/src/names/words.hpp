// SPDX-License-Identifier: MIT
// The one table of words in joints' names: what part of a body a word names, which side, and what it says a joint is for.
#ifndef SINEW_NAMES_WORDS_HPP
#define SINEW_NAMES_WORDS_HPP

#include <stdint.h>

#include "names/tokens.hpp"

namespace sinew::names {

// Parts of bodies. Of several in one name the first of this list counts: a finger of the hand is a finger, a forearm no arm.
enum class Part : uint8_t {
  kThumb,
  kIndex,
  kMiddle,
  kRing,
  kPinky,
  kFingers,  // all of them, or one that a number tells
  kMeta,     // bones of the palm
  kFace,
  kEye,
  kJaw,
  kBreast,
  kHair,
  kEar,
  kWing,
  kTail,
  kHead,
  kNeck,
  kLowerArm,
  kUpperArm,
  kHand,
  kProp,
  kHipJoint,
  kUpLeg,
  kLowLeg,
  kToe,
  kFoot,
  kLeg,  // upper or lower: the hierarchy tells
  kShoulder,
  kHips,
  kSpine,
  kForeLeg,  // of animals, in NameWords::part alone
  kHindLeg,
  kNone
};
constexpr Part kFirstFinger = Part::kThumb, kLastFinger = Part::kFingers;
constexpr bool is_finger(Part part) { return part <= kLastFinger; }

// Other meanings of a word: bits of Word::flags.
enum WordFlag : uint32_t {
  kLeft = 1u << 0,
  kRight = 1u << 1,
  kUpper = 1u << 2,
  kLower = 1u << 3,
  kFront = 1u << 4,  // of an animal's legs
  kHind = 1u << 5,
  kEnd = 1u << 6,      // marks the end of a bone
  kNub = 1u << 7,      // the same where nothing is bound to it
  kTip = 1u << 8,      // the last real bone as often as an end: geometry or weights tell
  kControl = 1u << 9,  // of inverse kinematics and the like
  kSlot = 1u << 10,    // where weapons and hats are attached
  kRoot = 1u << 11,    // carries the whole rig, where nothing but fillers is beside it
  kFiller = 1u << 12,  // says nothing, in names of roots
  kNoise = 1u << 13,   // says nothing anywhere
  kFk = 1u << 14,
  kDef = 1u << 15,          // Rigify's prefix of joints that deform
  kRigify = 1u << 16,       // beside such joints a control
  kStart = 1u << 17,        // the other end of what has an end: two bones
  kAfterSide = 1u << 18,    // a side may stand before it without a gap: lhand, rfoot
  kOnSuffix = 1u << 19,     // counts at the end of a longer word: legcontrol
  kTwist = 1u << 20,        // half a limb, or a bone that shares its rotation
  kToeToo = 1u << 21,       // a finger's name that toes have as well
  kLeaf = 1u << 26,         // exporters' bone behind a bone: an end to maps, whose fingers count its joints
  kWhole = 1u << 22,        // names a part where it is the whole name
  kGeneric = 1u << 24,      // a whole limb: what else is named is the joint
  kSidedHelper = 1u << 23,  // with a side it is a hip joint that helps: pelvis.L, CMU's LHipJoint
  kHalf = 1u << 25,         // the second half of a limb, MakeHuman's by their numbers
};

struct Word {
  char text[14];
  Part part;
  uint32_t flags;
};

// The row of a word, or of several that follow one another: "upperarm" is also found as upper arm. Null where there is none.
const Word* find_word(const Text& text);
// Every row, for tests and tables.
const Word* words(int* count);

}  // namespace sinew::names
#endif
