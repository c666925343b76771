// SPDX-License-Identifier: MIT
// Names of joints, cut into words at case changes, digits and punctuation, and looked up in a table of conventions.
#include "mapping/names.hpp"

#include <string.h>

namespace sinew::mapping {
namespace {

struct Phrase {
  char text[20];
  Word word;
};

// Mixamo, Unreal, Rigify, MakeHuman, CMU, Poser, VRM, Biped; words in lower case with a space between them.
constexpr Phrase kPhrases[] = {
    {"hips", Word::kHips},
    {"hip", Word::kHips},
    {"pelvis", Word::kHips},
    {"root", Word::kHips},
    {"cog", Word::kHips},
    {"bip pelvis", Word::kHips},
    {"spine", Word::kSpine},
    {"abdomen", Word::kSpine},
    {"torso", Word::kSpine},
    {"chest", Word::kSpine},
    {"waist", Word::kSpine},
    {"upper chest", Word::kSpine},
    {"lower back", Word::kSpine},
    {"stomach", Word::kSpine},
    {"back", Word::kSpine},
    {"neck", Word::kNeck},
    {"head", Word::kHead},
    {"jaw", Word::kJaw},
    {"chin", Word::kJaw},
    {"mouth", Word::kJaw},
    {"mandible", Word::kJaw},
    {"eye", Word::kEye},
    {"ear", Word::kEar},
    {"tail", Word::kTail},
    {"wing", Word::kWing},
    {"breast", Word::kBreast},
    {"hair", Word::kHair},
    {"ponytail", Word::kHair},
    {"shoulder", Word::kShoulder},
    {"clavicle", Word::kShoulder},
    {"collar", Word::kShoulder},
    {"scapula", Word::kShoulder},
    {"arm", Word::kUpperArm},
    {"upper arm", Word::kUpperArm},
    {"upperarm", Word::kUpperArm},
    {"shldr", Word::kUpperArm},
    {"uparm", Word::kUpperArm},
    {"humerus", Word::kUpperArm},
    {"fore arm", Word::kLowerArm},
    {"forearm", Word::kLowerArm},
    {"lower arm", Word::kLowerArm},
    {"lowerarm", Word::kLowerArm},
    {"low arm", Word::kLowerArm},
    {"elbow", Word::kLowerArm},
    {"hand", Word::kHand},
    {"wrist", Word::kHand},
    {"palm", Word::kHand},
    {"fist", Word::kHand},
    {"up leg", Word::kUpLeg},
    {"upleg", Word::kUpLeg},
    {"upper leg", Word::kUpLeg},
    {"upperleg", Word::kUpLeg},
    {"thigh", Word::kUpLeg},
    {"femur", Word::kUpLeg},
    {"leg", Word::kLowLeg},
    {"lower leg", Word::kLowLeg},
    {"lowerleg", Word::kLowLeg},
    {"low leg", Word::kLowLeg},
    {"calf", Word::kLowLeg},
    {"shin", Word::kLowLeg},
    {"knee", Word::kLowLeg},
    {"down leg", Word::kLowLeg},
    {"foot", Word::kFoot},
    {"ankle", Word::kFoot},
    {"feet", Word::kFoot},
    {"toe", Word::kToe},
    {"toe base", Word::kToe},
    {"ball", Word::kToe},
    {"toes", Word::kToe},
    {"toebase", Word::kToe},
    {"hip joint", Word::kHipJoint},
    {"buttock", Word::kHipJoint},
    {"thumb", Word::kThumb},
    {"hand thumb", Word::kThumb},
    {"index", Word::kIndex},
    {"hand index", Word::kIndex},
    {"finger index", Word::kIndex},
    {"index finger", Word::kIndex},
    {"middle", Word::kMiddle},
    {"hand middle", Word::kMiddle},
    {"mid", Word::kMiddle},
    {"middle finger", Word::kMiddle},
    {"ring", Word::kRing},
    {"hand ring", Word::kRing},
    {"ring finger", Word::kRing},
    {"pinky", Word::kPinky},
    {"hand pinky", Word::kPinky},
    {"little", Word::kPinky},
    {"pinky finger", Word::kPinky},
    {"finger pinky", Word::kPinky},
    {"metacarpal", Word::kMeta},
    {"palm meta", Word::kMeta},
    {"fingers", Word::kFingers},
    {"finger base", Word::kFingers},
    {"hand finger", Word::kFingers},
    {"front leg", Word::kForeLeg},
    {"front up leg", Word::kForeLeg},
    {"front upper leg", Word::kForeLeg},
    {"front low leg", Word::kForeLeg},
    {"front lower leg", Word::kForeLeg},
    {"front foot", Word::kForeLeg},
    {"front shoulder", Word::kForeLeg},
    {"back leg", Word::kHindLeg},
    {"back up leg", Word::kHindLeg},
    {"back upper leg", Word::kHindLeg},
    {"back low leg", Word::kHindLeg},
    {"back lower leg", Word::kHindLeg},
    {"back foot", Word::kHindLeg},
    {"hind leg", Word::kHindLeg},
    {"rear leg", Word::kHindLeg},
};

constexpr char kNoise[][10] = {"mixamorig", "bip", "def", "j", "bone", "jnt", "sk", "rig", "c", "m"};
constexpr char kEnds[][6] = {"end", "tip", "leaf", "nub", "site"};
// Words that a side may stand before without a gap: lhand, rfoot.
constexpr char kAfterSide[][10] = {"hand", "arm", "foot", "leg", "fingers", "thumb", "forearm", "shoulder"};

constexpr int kMostBytes = 128;

struct Text {
  const char* at;
  int length;

  bool is(const char* word) const {
    for (int i = 0; i < length; ++i) {
      if (word[i] != at[i]) return false;  // a shorter word ends with 0, which is in no text
    }
    return word[length] == 0;
  }
  bool is_number() const { return at[0] >= '0' && at[0] <= '9'; }
};

template <size_t kCount, size_t kLength>
bool is_one_of(const Text& text, const char (&words)[kCount][kLength]) {
  for (const auto& word : words) {
    if (text.is(word)) return true;
  }
  return false;
}

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return is_upper(c) || is_lower(c); }

// Whether a word ends between s[i] and s[i + 1].
bool ends_word(const char* s, int i) {
  const char a = s[i], b = s[i + 1];
  return (is_lower(a) && is_upper(b)) || (is_upper(a) && is_upper(b) && is_lower(s[i + 2])) ||
         (is_letter(a) && is_digit(b)) || (is_digit(a) && is_letter(b));
}

uint32_t hash_of(const Text& text) {
  uint32_t hash = 2166136261u;  // FNV-1a
  for (int i = 0; i < text.length; ++i) hash = (hash ^ static_cast<uint8_t>(text.at[i])) * 16777619u;
  return hash;
}

}  // namespace

void NameWords::read(const char* name) {
  *this = NameWords();
  if (name == nullptr) return;
  // Behind the last colon or bar, at most kMostBytes of it.
  const char* start = name;
  int length = 0;
  for (const char* c = name; *c != 0; ++c) {
    ++length;
    if (*c != ':' && *c != '|') continue;
    start = c + 1;
    length = 0;
  }
  if (length > kMostBytes) {
    start += length - kMostBytes;
    length = kMostBytes;
  }
  char buffer[kMostBytes + 3];
  memcpy(buffer, start, static_cast<size_t>(length));
  memset(buffer + length, 0, 3);
  Text tokens[kMostBytes];
  int count_all = 0;
  for (int i = 0; i < length;) {
    if (!is_letter(buffer[i]) && !is_digit(buffer[i])) {
      ++i;
      continue;
    }
    int last = i;
    while (last + 1 < length && (is_letter(buffer[last + 1]) || is_digit(buffer[last + 1])) && !ends_word(buffer, last))
      ++last;
    tokens[count_all++] = {buffer + i, last + 1 - i};
    i = last + 1;
  }
  for (int i = 0; i < length; ++i) {
    if (is_upper(buffer[i])) buffer[i] = static_cast<char>(buffer[i] - 'A' + 'a');
  }
  int side_at = -1;
  for (int i = 0; i < count_all && side_at < 0; ++i) {
    const Text& t = tokens[i];
    if (t.is("l") || t.is("r") || t.is("left") || t.is("right")) side_at = i;
  }
  if (side_at >= 0) {
    cls.side = tokens[side_at].at[0] == 'l' ? 1 : -1;
  } else if (count_all > 0 && tokens[0].length > 3 && (tokens[0].at[0] == 'l' || tokens[0].at[0] == 'r') &&
             is_one_of({tokens[0].at + 1, tokens[0].length - 1}, kAfterSide)) {
    cls.side = tokens[0].at[0] == 'l' ? 1 : -1;
    ++tokens[0].at;
    --tokens[0].length;
  }
  char phrase[kMostBytes * 2];
  int phrase_length = 0;
  bool last_is_end = false;
  for (int i = 0; i < count_all; ++i) {
    if (i == side_at) continue;
    Text t = tokens[i];
    while (t.is_number() && t.length > 1 && t.at[0] == '0') {  // 01 is 1
      ++t.at;
      --t.length;
    }
    last_is_end = is_one_of(t, kEnds);
    const uint32_t hash = hash_of(t);
    bool known = false;
    for (uint8_t k = 0; k < count; ++k) known = known || hashes[k] == hash;
    if (!known && count < kMostWords) {
      if (t.length > 2) long_mask = static_cast<uint8_t>(long_mask | (1u << count));
      hashes[count++] = hash;
    }
    if (last_is_end || is_one_of(t, kNoise)) continue;
    if (t.is_number()) {
      cls.number = 0;
      for (int k = 0; k < t.length && k < 6; ++k) cls.number = 10 * cls.number + (t.at[k] - '0');
      continue;
    }
    if (phrase_length > 0) phrase[phrase_length++] = ' ';
    memcpy(phrase + phrase_length, t.at, static_cast<size_t>(t.length));
    phrase_length += t.length;
  }
  cls.end = last_is_end;
  const Text whole = {phrase, phrase_length};
  for (const Phrase& one : kPhrases) {
    if (phrase_length > 0 && whole.is(one.text)) cls.word = one.word;
  }
}

Word limb_word(Word word) {
  switch (word) {
    case Word::kShoulder:
    case Word::kUpperArm:
    case Word::kLowerArm:
    case Word::kHand:
    case Word::kForeLeg:
      return Word::kUpperArm;
    case Word::kHipJoint:
    case Word::kUpLeg:
    case Word::kLowLeg:
    case Word::kFoot:
    case Word::kToe:
    case Word::kHindLeg:
      return Word::kUpLeg;
    default:
      return word;
  }
}

double overlap(const uint32_t* a, int32_t a_count, const uint32_t* b, int32_t b_count) {
  if (a_count == 0 || b_count == 0) return 0;
  int32_t both = 0;
  for (int32_t i = 0; i < a_count; ++i) {
    for (int32_t j = 0; j < b_count; ++j) both += a[i] == b[j] ? 1 : 0;
  }
  return static_cast<double>(both) / (a_count + b_count - both);
}

}  // namespace sinew::mapping
