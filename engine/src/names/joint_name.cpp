// SPDX-License-Identifier: MIT
// Reads one name: the longest rows of the table first, from its left; then the foremost part of those that were found.
#include "names/joint_name.hpp"

#include <string.h>

namespace sinew::names {
namespace {

constexpr int kMostJoined = 4;  // words that make one row

struct SideText {
  char text[6];
  bool left;
};
constexpr SideText kSideTexts[] = {{"left", true}, {"right", false}, {"l", true}, {"r", false}};

uint64_t add_text(uint64_t hash, const Text& text) {
  for (int i = 0; i < text.length; ++i) hash = (hash ^ static_cast<uint8_t>(text.at[i])) * 1099511628211u;
  return (hash ^ 0x20u) * 1099511628211u;
}

// The end of a name, except .001 and _021: a separator and at least two digits behind another number's digits or a
// word.
int32_t number_at_end(const char* name) {
  size_t end = static_cast<size_t>(length_without_id(name, length_of(name)));
  for (size_t digits = 0; digits < end; ++digits) {
    const char c = name[end - 1 - digits];
    if (is_digit(c)) continue;
    if (digits >= 2 && (c == '.' || c == '_')) end -= digits + 1;
    break;
  }
  size_t first = end;
  while (first > 0 && is_digit(name[first - 1]) && end - first < 4) --first;
  if (first == end) return -1;
  int32_t number = 0;
  for (size_t i = first; i < end; ++i) number = 10 * number + (name[i] - '0');
  return number;
}

class Reader {
 public:
  Reader(const char* name, int skipped) : tokens_(name), skipped_(skipped) {}

  JointName read(const char* name) {
    find_side();
    keys();
    if (name != nullptr) out_.own_number = number_at_end(name);
    if (skipped_ >= tokens_.count) skipped_ = 0;
    for (int i = skipped_; i < tokens_.count;) i += take(i);
    choose_part();
    out_.plain = plain_part();
    out_.root = out_.has(kRoot) && !beside_root_;
    return out_;
  }

 private:
  // left and right anywhere, else an l or r of its own, else one in front of a word that goes with it: lhand.
  void find_side() {
    const auto take_side = [&](int i, bool left, int length, bool behind) {
      side_at_ = length == tokens_.token[i].length ? i : -1;
      out_.side = left ? int8_t{1} : int8_t{-1};
      out_.side_begin = tokens_.begin[i];
      out_.side_end = tokens_.end[i];
      if (side_at_ >= 0) return;
      glued_at_ = i;
      Text& token = tokens_.token[i];
      if (behind) {
        out_.side_begin = static_cast<int16_t>(tokens_.end[i] - length);
      } else {
        out_.side_end = static_cast<int16_t>(tokens_.begin[i] + length);
        token.at += length;
      }
      token.length -= length;
    };
    // Whole words before letters, letters that stand alone before those that touch others: PalmR.L is left.
    for (int pass = 0; pass < 3; ++pass) {
      for (int i = 0; i < tokens_.count; ++i) {
        const Text& token = tokens_.token[i];
        if ((token.length > 1) != (pass == 0) || (pass == 1 && (touches(i) || touches(i + 1)))) continue;
        const Word* const word = find_word(token);
        if (word != nullptr && (word->flags & (kLeft | kRight)) != 0)
          return take_side(i, (word->flags & kLeft) != 0, token.length, false);
      }
    }
    for (int i = 0; i < tokens_.count; ++i) {
      const Text& token = tokens_.token[i];
      if (find_word(token) != nullptr) continue;
      for (const SideText& one : kSideTexts) {
        const int length = length_of(one.text);
        if (length >= token.length) continue;
        if (token.begins_with(one.text) && (length > 1 || i == 0) &&
            goes_with_sides({token.at + length, token.length - length}))
          return take_side(i, one.left, length, false);
        if (length > 1 && token.ends_with(one.text) && goes_with_sides({token.at, token.length - length}))
          return take_side(i, one.left, length, true);
      }
    }
  }

  // Nothing is between a word and the one before it.
  bool touches(int i) const { return i > 0 && i < tokens_.count && tokens_.begin[i] == tokens_.end[i - 1]; }

  static bool goes_with_sides(const Text& text) {
    const Word* const word = find_word(text);
    return word != nullptr && (word->flags & kAfterSide) != 0;
  }

  void keys() {
    uint64_t stem = 14695981039346656037u, whole = stem;
    for (int i = 0; i < tokens_.count; ++i) {
      Text text = tokens_.token[i];
      if (i == side_at_ || i == glued_at_) whole = (whole ^ 0xFFu) * 1099511628211u;
      if (i == side_at_) continue;
      if (!text.is_number()) {
        if (out_.words == 0) out_.first_word = hash_of(text);
        if (out_.words < UINT8_MAX) ++out_.words;
        stem = add_text(stem, text);
      }
      while (text.is_number() && text.length > 1 && text.at[0] == '0') {  // 01 is 1
        ++text.at;
        --text.length;
      }
      whole = add_text(whole, text);
      if (text.is_number()) {
        out_.number = 0;
        for (int k = 0; k < text.length && k < 6; ++k) out_.number = 10 * out_.number + (text.at[k] - '0');
      }
      const uint32_t hash = hash_of(text);
      bool known = false;
      for (uint8_t k = 0; k < out_.count; ++k) known = known || out_.hashes[k] == hash;
      if (known || out_.count >= kMostWords) continue;
      if (text.length > 2) out_.long_mask = static_cast<uint8_t>(out_.long_mask | (1u << out_.count));
      out_.hashes[out_.count++] = hash;
    }
    out_.stem = stem;
    out_.other_side_key = whole;
  }

  // Words that were read.
  int take(int i) {
    if (i == side_at_) {
      beside_root_ = true;
      return 1;
    }
    Text joined;
    char buffer[sizeof Word::text];
    const Word* found = nullptr;
    int taken = 1;
    for (int k = i; k < tokens_.count && k < i + kMostJoined && k != side_at_; ++k) {
      const Text& token = tokens_.token[k];
      if (joined.length + token.length >= static_cast<int>(sizeof buffer)) break;
      memcpy(buffer + joined.length, token.at, static_cast<size_t>(token.length));
      joined = {buffer, joined.length + token.length};
      const Word* const word = find_word(joined);
      if (word == nullptr) continue;
      found = word;
      taken = k + 1 - i;
    }
    if (found == nullptr) return take_unknown(i);
    note(*found, i, i + taken);
    if (found->part == Part::kFingers && i + taken < tokens_.count && tokens_.token[i + taken].is_number())
      out_.finger = static_cast<int8_t>(tokens_.token[i + taken].at[0] - '0');
    return taken;
  }

  int take_unknown(int i) {
    const Text& token = tokens_.token[i];
    if (token.is_number()) return 1;
    beside_root_ = true;
    if (token.length == 1) return 1;  // Spine_A
    const Word* found = nullptr;
    if (token.length > 3 && token.at[token.length - 1] == 's') found = find_word({token.at, token.length - 1});
    if (found == nullptr) {
      unknown_ = true;
      found = longest_inside(token);
    }
    if (found != nullptr) note(*found, i, i + 1);
    return 1;
  }

  // Words of five letters or more at the beginning of a longer word, of four or more at its end: no tail is in
  // tailor.
  static const Word* longest_inside(const Text& token) {
    constexpr int kShortest = 4, kShortestBefore = 5;
    int count = 0, longest = 0;
    const Word* const all = words(&count);
    const Word* found = nullptr;
    for (int i = 0; i < count; ++i) {
      const Word& word = all[i];
      const int length = length_of(word.text);
      const bool part = word.part != Part::kNone && (word.flags & (kWhole | kSlot)) == 0 &&
                        ((word.flags & kToeToo) == 0 || word.part == Part::kFingers);
      const bool behind = (part || (word.flags & kOnSuffix) != 0) && token.ends_with(word.text);
      if (length < kShortest || length <= longest ||
          !(behind || (part && length >= kShortestBefore && token.begins_with(word.text))))
        continue;
      longest = length;
      found = &word;
    }
    return found;
  }

  void note(const Word& word, int first, int behind) {
    out_.flags |= word.flags & ~uint32_t{kLeft | kRight};
    if ((word.flags & (kRoot | kFiller)) == 0) beside_root_ = true;
    if (word.part == Part::kNone || match_count_ == kMostMatches) return;
    matches_[match_count_++] = {&word, first, behind};
  }

  struct WordMatch {
    const Word* word = nullptr;
    int first = 0, behind = 0;  // tokens
  };

  static bool is_leg(Part part) { return part >= Part::kHipJoint && part <= Part::kShoulder; }
  static bool is_hips(Part part) { return part == Part::kHips; }

  bool is_limb(int but) const {
    for (int k = 0; k < match_count_; ++k) {
      const Part part = matches_[k].word->part;
      if (k != but && part >= Part::kLowerArm && part <= Part::kShoulder && (matches_[k].word->flags & kGeneric) == 0)
        return true;
    }
    return false;
  }

  bool any(bool (*wanted)(Part)) const {
    for (int k = 0; k < match_count_; ++k) {
      if (wanted(matches_[k].word->part)) return true;
    }
    return false;
  }

  void drop(int k) {
    for (--match_count_; k < match_count_; ++k) matches_[k] = matches_[k + 1];
  }

  void choose_part() {
    const bool leg = any(is_leg) || (out_.side != 0 && any(is_hips));
    for (int k = match_count_ - 1; k >= 0; --k) {
      const WordMatch& one = matches_[k];
      // The back leg is no spine.
      if (one.word->part == Part::kSpine && (one.word->flags & kHind) != 0 && leg) {
        drop(k);
        continue;
      }
      if ((one.word->flags & kHind) != 0 && one.word->part == Part::kSpine) out_.flags &= ~uint32_t{kHind};
      if (((one.word->flags & kWhole) != 0 && (unknown_ || match_count_ > 1)) ||
          ((one.word->flags & kGeneric) != 0 && is_limb(k))) {
        drop(k);
        continue;
      }
      // MiddleHand, ThighMid, EarRing; Footfinger and index_toe are toes.
      if ((one.word->flags & kToeToo) == 0) continue;
      bool other = false, hand = false;
      for (int i = 0; i < match_count_; ++i) {
        const Part part = matches_[i].word->part;
        if (i == k || (matches_[i].word->flags & kToeToo) != 0) continue;
        hand = hand || part == Part::kHand || is_finger(part) || part == Part::kMeta;
        other = true;
      }
      const bool before_hand = one.word->part == Part::kMiddle && k + 1 < match_count_ &&
                               matches_[k + 1].word->part == Part::kHand && matches_[k + 1].first == one.behind &&
                               match_count_ == 2;
      if (before_hand || (other && !hand)) drop(k);
    }
    if (any([](Part part) { return part == Part::kFoot || part == Part::kToe; })) out_.digit = out_.has(kToeToo);
    int distinct = 0;
    for (int k = 0; k < match_count_; ++k) {
      const Part part = matches_[k].word->part;
      if (part < out_.part) out_.part = part;
      if (part == Part::kToe) out_.digit = out_.digit || has_two_numbers(matches_[k].behind);
    }
    for (int k = 0; k < match_count_; ++k) {
      const Part part = matches_[k].word->part;
      const bool family = is_finger(out_.part) && (is_finger(part) || part == Part::kHand);
      const bool palm = out_.part == Part::kMeta && part == Part::kHand;
      distinct += part != out_.part && !family && !palm ? 1 : 0;
      out_.helper = out_.helper || ((matches_[k].word->flags & kSidedHelper) != 0 && out_.side != 0 &&
                                    (part == Part::kHips || out_.side_end - out_.side_begin == 1));
    }
    if (out_.helper && out_.part == Part::kHips) out_.part = Part::kHipJoint;
    // Bones of the palm, except the thumb's, which has no other bone there.
    if (is_finger(out_.part) && out_.part != Part::kThumb && any([](Part part) { return part == Part::kMeta; }))
      out_.part = Part::kMeta;
    out_.exact = out_.part != Part::kNone && distinct == 0 && !unknown_ && !out_.has(kTwist);
    if (out_.part == Part::kLeg && out_.has(kUpper)) out_.part = Part::kUpLeg;
    if (out_.part == Part::kLeg && out_.has(kLower)) out_.part = Part::kLowLeg;
    if (out_.part == Part::kUpperArm && out_.has(kLower) && !out_.has(kUpper)) out_.part = Part::kLowerArm;
  }

  Part plain_part() const {
    // Which finger a number means the whole skeleton tells; controls stand beside what they are named after.
    if (!out_.exact || out_.has(kControl | kSlot) || (out_.part == Part::kFingers && out_.finger >= 0))
      return Part::kNone;
    const bool leg = is_leg(out_.part);
    if (leg && out_.has(kFront)) return Part::kForeLeg;
    if (leg && out_.has(kHind)) return Part::kHindLeg;
    if (out_.part == Part::kLeg) return Part::kLowLeg;
    if (out_.part == Part::kHips && out_.side != 0) return Part::kUpLeg;
    return out_.part;
  }

  // MakeHuman's toe2-1.
  bool has_two_numbers(int i) const {
    return i + 1 < tokens_.count && tokens_.token[i].is_number() && tokens_.token[i + 1].is_number() &&
           tokens_.token[i + 1].length == 1;
  }

  static constexpr int kMostMatches = 12;
  Tokens tokens_;
  int skipped_;
  JointName out_;
  int side_at_ = -1, glued_at_ = -1;
  bool unknown_ = false, beside_root_ = false;
  WordMatch matches_[kMostMatches];
  int match_count_ = 0;
};

}  // namespace

JointName read_joint_name(const char* name, int skipped) { return Reader(name, skipped).read(name); }

Part limb_part(Part part) {
  switch (part) {
    case Part::kShoulder:
    case Part::kUpperArm:
    case Part::kLowerArm:
    case Part::kHand:
    case Part::kForeLeg:
      return Part::kUpperArm;
    case Part::kHipJoint:
    case Part::kUpLeg:
    case Part::kLowLeg:
    case Part::kFoot:
    case Part::kToe:
    case Part::kHindLeg:
      return Part::kUpLeg;
    default:
      return part;
  }
}

bool other_side_name(const char* name, char* other, size_t room) {
  const JointName said = read_joint_name(name);
  if (said.side == 0 || said.side_begin >= said.side_end) return false;
  const size_t begin = static_cast<size_t>(said.side_begin), end = static_cast<size_t>(said.side_end);
  const size_t all = static_cast<size_t>(length_of(name)), length = end - begin;
  const char first = name[begin];
  const bool capital = first >= 'A' && first <= 'Z';
  const bool capitals = capital && length > 1 && name[begin + 1] >= 'A' && name[begin + 1] <= 'Z';
  const bool left = said.side < 0;
  const char* word = capitals  ? (left ? "LEFT" : "RIGHT")
                     : capital ? (left ? "Left" : "Right")
                               : (left ? "left" : "right");
  if (length == 1) word = capital ? (left ? "L" : "R") : (left ? "l" : "r");
  if (length == 3) {  // full-width
    const bool wide_capital = static_cast<uint8_t>(name[begin + 1]) == 0xBC;
    word = wide_capital ? (left ? "\xEF\xBC\xAC" : "\xEF\xBC\xB2") : (left ? "\xEF\xBD\x8C" : "\xEF\xBD\x92");
  }
  const size_t word_length = static_cast<size_t>(length_of(word));
  if (all - length + word_length + 1 > room) return false;
  memcpy(other, name, begin);
  memcpy(other + begin, word, word_length);
  memcpy(other + begin + word_length, name + end, all - end + 1);
  return true;
}

double overlap(const uint32_t* a, int32_t a_count, const uint32_t* b, int32_t b_count) {
  if (a_count == 0 || b_count == 0) return 0;
  int32_t both = 0;
  for (int32_t i = 0; i < a_count; ++i) {
    for (int32_t j = 0; j < b_count; ++j) both += a[i] == b[j] ? 1 : 0;
  }
  return static_cast<double>(both) / (a_count + b_count - both);
}

}  // namespace sinew::names
