// SPDX-License-Identifier: MIT
// Names of joints against a table of words; the first line that fits says the class.
#include "sinew_character/joint_class_of.hpp"

#include <algorithm>
#include <array>

namespace sinew {
namespace {

// What a line of the table says: a class, or one of these.
enum Verdict : int {
  kDetail = -1,
  kFrontLeg = -2,  // clavicle or upper arm
  kHindLeg = -3,   // hip or thigh
  kLeg = -4,       // thigh or calf
};

struct Line {
  std::string_view words;  // between blanks; ^word: the name begins so, word$: it ends so, word!x: not before x
  int verdict;
};

// Order matters: a finger of the hand is a detail before it is a hand, a forearm is one before it is an arm.
constexpr std::array<Line, 26> kTable = {{
    {"finger thumb index middle!hand ring pinky metacarpal ^palmp$ ^palmi$ ^palmr$ ^palmt$", kDetail},
    {"levator oris tongue special temporalis oculi risorius orbicularis ^eye$ ^eyes$ eyebrow jaw mouth ^face$ vent",
     kDetail},
    {"breast twist", kDetail},
    {"ponytail hair", kClassHair},
    {"^ear$", kClassEar},
    {"wing flipper fin$", kClassWing},
    {"tail!or", kClassTail},
    {"head", kClassHead},
    {"neck", kClassNeck},
    {"forearm lowerarm lowarm frontlowerleg frontlowleg", kClassForearm},
    {"frontshoulder clavicle", kClassClavicle},
    {"upperarm ^arm$ frontupperleg frontupleg", kClassUpperArm},
    {"hand palm wrist fist weapon frontfoot ^ff$", kClassHand},
    {"backshoulder hipjoint", kClassHip},
    {"upperleg upleg thigh", kClassThigh},
    {"lowerleg lowleg calf midleg shin", kClassCalf},
    {"frontleg", kFrontLeg},
    {"backleg", kHindLeg},
    {"toe ball", kClassToe},
    {"foot ^ffb$ ankle", kClassFoot},
    {"^leg$", kLeg},
    {"^shoulders$", kClassSpine},
    {"shoulder", kClassClavicle},
    {"pelvis ^hip$ ^hips$ ^root$ ^body$ ^master$ ^all$", kClassPelvis},
    {"spine abdomen torso chest back waist main", kClassSpine},
    {"", kClassOther},
}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_gap(char c) { return c == '.' || c == '_' || c == '-'; }
bool is_side(char c) { return c == 'L' || c == 'R' || c == 'l' || c == 'r'; }

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (is_upper(c)) c = static_cast<char>(c - 'A' + 'a');
  return out;
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

bool fits(std::string_view name, std::string_view word) {
  const bool begins = word.front() == '^', ends = word.back() == '$';
  if (begins) word.remove_prefix(1);
  if (ends) word.remove_suffix(1);
  const size_t mark = word.find('!');
  const std::string_view not_before = mark == std::string_view::npos ? "" : word.substr(mark + 1);
  word = word.substr(0, mark);
  if (begins && ends) return name == word;
  if (ends) return name.ends_with(word);
  for (size_t at = name.find(word); at != std::string_view::npos; at = name.find(word, at + 1))
    if (not_before.empty() || !name.substr(at + word.size()).starts_with(not_before)) return true;
  return false;
}

bool fits_any(std::string_view name, std::string_view words) {
  if (words.empty()) return true;
  while (!words.empty()) {
    const size_t end = std::min(words.find(' '), words.size());
    if (fits(name, words.substr(0, end))) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

struct PlainName {
  std::string text;
  bool sided = false;
};

// LeftArm, LThumb, LHipJoint, l-arm.
std::string_view without_side_before(std::string_view name, bool* sided) {
  size_t length = 0;
  for (const std::string_view side : {"Left", "Right"})
    if (name.starts_with(side) && name.size() > side.size() && is_upper(name[side.size()])) length = side.size();
  if (length == 0 && !name.empty() && (name[0] == 'L' || name[0] == 'R') &&
      (name.substr(1).starts_with("HipJoint") || name.substr(1).starts_with("Thumb")))
    length = 1;
  if (length == 0 && name.size() > 1 && (name[0] == 'l' || name[0] == 'r') && name[1] == '-') length = 2;
  *sided = *sided || length > 0;
  return name.substr(length);
}

// arm.L, arm_r.001, leg.L.end: a letter alone between a gap and a gap or the end.
std::string without_side_behind(std::string_view name, bool* sided) {
  std::string out;
  for (size_t i = 0; i < name.size(); ++i) {
    const bool letter_alone =
        i + 1 < name.size() && is_side(name[i + 1]) && (i + 2 == name.size() || is_gap(name[i + 2]));
    if (!is_gap(name[i]) || !letter_alone) {
      out += name[i];
      continue;
    }
    *sided = true;
    if (i + 2 < name.size()) out += name[i + 2];
    i += 2;
  }
  return out;
}

PlainName plain(std::string name) {
  constexpr std::string_view kMixamo = "mixamorig:";
  for (size_t at = name.find(kMixamo); at != std::string::npos; at = name.find(kMixamo, at))
    name.erase(at, kMixamo.size());
  PlainName out;
  for (const char c : lower_case(without_side_behind(without_side_before(name, &out.sided), &out.sided)))
    if (!is_digit(c) && !is_gap(c) && c != ':') out.text += c;
  return out;
}

// Details that only the whole name tells, most of them MakeHuman's: bones that halve a limb, its joints beside the pelvis.
bool is_detail_by_whole_name(std::string_view name) {
  for (const std::string_view half :
       {"upperleg02", "lowerleg02", "upperarm02", "lowerarm02", "shoulder01.", "pelvis.", "lhipjoint", "rhipjoint"})
    if (name.starts_with(half)) return true;
  return name.size() >= 6 && name.starts_with("toe") && is_digit(name[3]) && name[4] == '-' && is_digit(name[5]);
}

}  // namespace

std::optional<JointClass> joint_class_of(const std::string& name, const std::vector<std::string_view>& below) {
  if (is_detail_by_whole_name(lower_case(name))) return std::nullopt;
  PlainName plain_name = plain(name);
  std::string& text = plain_name.text;
  for (const std::string_view ending : {"end", "leaf"}) {
    if (!text.ends_with(ending)) continue;
    text.resize(text.size() - ending.size());
    break;
  }
  const auto upper_leg_follows = [&] {
    return std::any_of(below.begin(), below.end(),
                       [](std::string_view one) { return contains(lower_case(one), "upleg"); });
  };
  if (plain_name.sided && text == "hip") return upper_leg_follows() ? kClassHip : kClassThigh;  // not the pelvis
  const auto line =
      std::find_if(kTable.begin(), kTable.end(), [&](const Line& each) { return fits_any(text, each.words); });
  switch (line->verdict) {
    case kDetail:
      return std::nullopt;
    case kFrontLeg:
      return upper_leg_follows() ? kClassClavicle : kClassUpperArm;
    case kHindLeg:
      return upper_leg_follows() ? kClassHip : kClassThigh;
    case kLeg:
      return plain_name.sided && !below.empty() ? kClassCalf : kClassThigh;
    default:
      return static_cast<JointClass>(line->verdict);
  }
}

std::string plain_joint_name(const std::string& name) { return plain(name).text; }

bool names_bone_end(std::string name) {
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.pop_back();
  const std::string ending = lower_case(name.substr(name.size() - std::min<size_t>(name.size(), 4)));
  return ending == "_end" || ending == "_tip";
}

const char* joint_class_text(uint32_t joint_class) {
  constexpr std::array<const char*, kEndClasses> kNames = {
      "pelvis", "spine", "neck", "head", "clavicle", "upperarm", "forearm", "hand",  "hip", "thigh",
      "calf",   "foot",  "toe",  "tail", "wing",     "ear",      "hair",    "other", "tip"};
  return joint_class < kEndClasses ? kNames[joint_class] : "?";
}

}  // namespace sinew
