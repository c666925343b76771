// SPDX-License-Identifier: MIT
// Meaning of one joint's name, by the table of words: part of a body, side, number, what it is for, and keys for
// comparison.
#ifndef SINEW_NAMES_JOINT_NAME_HPP
#define SINEW_NAMES_JOINT_NAME_HPP

#include <stddef.h>
#include <stdint.h>

#include "names/words.hpp"

namespace sinew::names {

constexpr int kMostWords = 6;

struct JointName {
  Part part = Part::kNone;
  // The part as maps want it: kNone where the name says more than a part, fore and hind legs as one each, a leg's
  // halves and hips only with a side.
  Part plain = Part::kNone;
  bool exact = false;                    // nothing else is in the name but sides, positions, numbers, ends and noise
  bool digit = false;                    // of a toe: one of several of a foot
  bool helper = false;                   // helps the joint above it: pelvis.L
  int8_t side = 0;                       // 1 left, -1 right, 0 unknown
  uint32_t flags = 0;                    // bits of WordFlag, of all words
  bool root = false;                     // words of roots and fillers alone
  int32_t number = 0;                    // the last one in the name
  int8_t finger = -1;                    // the digit behind the word finger: MakeHuman counts from 1, 3ds Max from 0
  int32_t own_number = -1;               // the one at its end but for what tools append (.001, _021), -1 without one
  int16_t side_begin = 0, side_end = 0;  // bytes of the name that say the side
  uint8_t words = 0;                     // of letters
  uint32_t first_word = 0;               // hash
  uint64_t stem = 0;                     // of its words without side and numbers, in order
  uint64_t other_side_key = 0;           // equal in names that differ in their side alone
  uint8_t count = 0;                     // words and numbers that are kept, each once
  uint8_t long_mask = 0;                 // which of them have more than two letters
  uint32_t hashes[kMostWords] = {};      // of them, without the side

  bool has(uint32_t bits) const { return (flags & bits) != 0; }
  bool is_end() const { return has(kEnd | kNub); }
  bool is_end_of_map() const { return has(kEnd | kNub | kLeaf); }
};

// The part of one limb: upper arm for the joints of an arm or foreleg, upper leg for those of a leg, else the part itself.
Part limb_part(Part part);

// From UTF-8; null says nothing. The first `skipped` words and numbers are left out of what it says, not of the keys.
JointName read_joint_name(const char* name, int skipped = 0);

// The name with its side exchanged, in the same writing, 0 behind it. False where it has no side or no room.
bool other_side_name(const char* name, char* other, size_t room);

// Words in both over words in either, 0 where one has none.
double overlap(const uint32_t* a, int32_t a_count, const uint32_t* b, int32_t b_count);

}  // namespace sinew::names
#endif
