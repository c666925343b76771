// SPDX-License-Identifier: MIT
// What a joint's name says: side, class, number, end marker, and its words for comparison.
#ifndef SINEW_MAPPING_NAMES_HPP
#define SINEW_MAPPING_NAMES_HPP

#include <stdint.h>

namespace sinew::mapping {

// What joints are called in common conventions. Order has no meaning but for kFirstFinger .. kLastFinger.
enum class Word : uint8_t {
  kNone,
  kHips,
  kSpine,
  kNeck,
  kHead,
  kJaw,
  kEye,
  kEar,
  kTail,
  kWing,
  kBreast,
  kHair,
  kShoulder,
  kUpperArm,
  kLowerArm,
  kHand,
  kUpLeg,
  kLowLeg,
  kFoot,
  kToe,
  kHipJoint,
  kMeta,
  kForeLeg,
  kHindLeg,
  kThumb,
  kIndex,
  kMiddle,
  kRing,
  kPinky,
  kFingers,
  kCount
};
constexpr Word kFirstFinger = Word::kThumb, kLastFinger = Word::kFingers;
inline bool is_finger(Word w) { return w >= kFirstFinger && w <= kLastFinger; }

struct Class {
  Word word = Word::kNone;
  int8_t side = 0;     // 1 left, -1 right, 0 not said
  bool end = false;    // "end", "tip", "nub", ...
  int32_t number = 0;  // the last one in the name
};

constexpr int kMostWords = 6;

struct NameWords {
  Class cls;
  uint8_t count = 0;                 // words that are kept, each once
  uint8_t long_mask = 0;             // which of them have more than two letters
  uint32_t hashes[kMostWords] = {};  // of the words, without the side

  // From UTF-8 text; null says nothing. Only its last 128 bytes count.
  void read(const char* name);
};

// Words of one limb: arm for the joints of an arm or foreleg, leg for those of a leg, else the word itself.
Word limb_word(Word word);

// Words in both over words in either, 0 where one has none.
double overlap(const uint32_t* a, int32_t a_count, const uint32_t* b, int32_t b_count);

}  // namespace sinew::mapping
#endif
