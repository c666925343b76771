// SPDX-License-Identifier: MIT
// Two tables: standard names in Shift-JIS, and English words.
#include "motion/vmd_bones.hpp"

#include <algorithm>
#include <string_view>

#include "motion/person.hpp"
#include "sinew_formats/base/lower_case.hpp"

namespace sinew {
namespace {

constexpr const char *kIk = "\x82\x68\x82\x6a", *kLeft = "\x8d\xb6", *kRight = "\x89\x45";  // Shift-JIS

struct BoneName {
  const char *shift_jis, *name;
};
// The left side alone. To add a bone: its name here, and in person.cpp where it stands; an English one in kWords.
constexpr BoneName kBones[] = {
    {"\x91\x53\x82\xc4\x82\xcc\x90\x65", "root"},                    // 全ての親
    {"\x83\x5a\x83\x93\x83\x5e\x81\x5b", "center"},                  // センター
    {"\x83\x4f\x83\x8b\x81\x5b\x83\x75", "groove"},                  // グルーブ
    {"\x8d\x98", "waist"},                                           // 腰
    {"\x89\xba\x94\xbc\x90\x67", "hips"},                            // 下半身
    {"\x8f\xe3\x94\xbc\x90\x67", "spine"},                           // 上半身
    {"\x8f\xe3\x94\xbc\x90\x67\x32", "chest"},                       // 上半身2
    {"\x8f\xe3\x94\xbc\x90\x67\x82\x51", "chest"},                   // 上半身２
    {"\x8e\xf1", "neck"},                                            // 首
    {"\x93\xaa", "head"},                                            // 頭
    {"\x8d\xb6\x8c\xa8", "leftShoulder"},                            // 左肩
    {"\x8d\xb6\x98\x72", "leftUpperArm"},                            // 左腕
    {"\x8d\xb6\x82\xd0\x82\xb6", "leftLowerArm"},                    // 左ひじ
    {"\x8d\xb6\x8e\xe8\x8e\xf1", "leftHand"},                        // 左手首
    {"\x8d\xb6\x91\xab", "leftUpperLeg"},                            // 左足
    {"\x8d\xb6\x82\xd0\x82\xb4", "leftLowerLeg"},                    // 左ひざ
    {"\x8d\xb6\x91\xab\x8e\xf1", "leftFoot"},                        // 左足首
    {"\x8d\xb6\x82\xc2\x82\xdc\x90\xe6", "leftToes"},                // 左つま先
    {"\x8d\xb6\x91\xab\x82\x68\x82\x6a", "leftFootIk"},              // 左足ＩＫ
    {"\x8d\xb6\x91\xab\x49\x4b", "leftFootIk"},                      // 左足IK
    {"\x8d\xb6\x91\xab\x49\x4b\x90\x65", "leftFootIkParent"},        // 左足IK親
    {"\x8d\xb6\x90\x65\x8e\x77\x82\x4f", "leftThumbMetacarpal"},     // 左親指０
    {"\x8d\xb6\x90\x65\x8e\x77\x82\x50", "leftThumbProximal"},       // 左親指１
    {"\x8d\xb6\x90\x65\x8e\x77\x82\x51", "leftThumbDistal"},         // 左親指２
    {"\x8d\xb6\x90\x6c\x8e\x77\x82\x50", "leftIndexProximal"},       // 左人指１
    {"\x8d\xb6\x90\x6c\x8e\x77\x82\x51", "leftIndexIntermediate"},   // 左人指２
    {"\x8d\xb6\x90\x6c\x8e\x77\x82\x52", "leftIndexDistal"},         // 左人指３
    {"\x8d\xb6\x92\x86\x8e\x77\x82\x50", "leftMiddleProximal"},      // 左中指１
    {"\x8d\xb6\x92\x86\x8e\x77\x82\x51", "leftMiddleIntermediate"},  // 左中指２
    {"\x8d\xb6\x92\x86\x8e\x77\x82\x52", "leftMiddleDistal"},        // 左中指３
    {"\x8d\xb6\x96\xf2\x8e\x77\x82\x50", "leftRingProximal"},        // 左薬指１
    {"\x8d\xb6\x96\xf2\x8e\x77\x82\x51", "leftRingIntermediate"},    // 左薬指２
    {"\x8d\xb6\x96\xf2\x8e\x77\x82\x52", "leftRingDistal"},          // 左薬指３
    {"\x8d\xb6\x8f\xac\x8e\x77\x82\x50", "leftLittleProximal"},      // 左小指１
    {"\x8d\xb6\x8f\xac\x8e\x77\x82\x51", "leftLittleIntermediate"},  // 左小指２
    {"\x8d\xb6\x8f\xac\x8e\x77\x82\x52", "leftLittleDistal"},        // 左小指３
};

// English names without their side, brackets, blanks and marks, in lower case.
struct BoneWord {
  const char *word, *name;
};
constexpr BoneWord kWords[] = {
    {"root", "root"},
    {"mother", "root"},
    {"parent", "root"},
    {"allparent", "root"},
    {"allparents", "root"},
    {"center", "center"},
    {"centre", "center"},
    {"groove", "groove"},
    {"waist", "waist"},
    {"lowerbody", "hips"},
    {"lbody", "hips"},
    {"lbody1", "hips"},
    {"upperbody", "spine"},
    {"upperbody1", "spine"},
    {"ubody", "spine"},
    {"ubody1", "spine"},
    {"upperbody2", "chest"},
    {"upperbody3", "chest"},
    {"ubody2", "chest"},
    {"ubody3", "chest"},
    {"neck", "neck"},
    {"head", "head"},
    {"shoulder", "leftShoulder"},
    {"arm", "leftUpperArm"},
    {"arm1", "leftUpperArm"},
    {"upperarm", "leftUpperArm"},
    {"elbow", "leftLowerArm"},
    {"arm2", "leftLowerArm"},
    {"arm3", "leftLowerArm"},
    {"arm4", "leftLowerArm"},
    {"forearm", "leftLowerArm"},
    {"lowerarm", "leftLowerArm"},
    {"wrist", "leftHand"},
    {"hand", "leftHand"},
    {"leg", "leftUpperLeg"},
    {"leg1", "leftUpperLeg"},
    {"leg2", "leftUpperLeg"},
    {"leg3", "leftUpperLeg"},
    {"leg4", "leftUpperLeg"},
    {"upperleg", "leftUpperLeg"},
    {"thigh", "leftUpperLeg"},
    {"knee", "leftLowerLeg"},
    {"leg5", "leftLowerLeg"},
    {"lowerleg", "leftLowerLeg"},
    {"shin", "leftLowerLeg"},
    {"ankle", "leftFoot"},
    {"toe", "leftToes"},
    {"toes", "leftToes"},
    {"legik", "leftFootIk"},
    {"legikparent", "leftFootIkParent"},
};
struct FingerWord {
  const char *word, *finger;
};
constexpr FingerWord kFingers[] = {
    {"thumb", "Thumb"},   {"finger1", "Thumb"},  {"index", "Index"},  {"fore", "Index"},    {"finger2", "Index"},
    {"middle", "Middle"}, {"finger3", "Middle"}, {"ring", "Ring"},    {"third", "Ring"},    {"finger4", "Ring"},
    {"little", "Little"}, {"pinky", "Little"},   {"small", "Little"}, {"finger5", "Little"}};

struct EnglishName {
  std::string word;  // without its side
  char side = ' ';   // l, r
};

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "Arm1-L[Y]" is arm1 of the left, "Right arm" is arm of the right.
EnglishName english_name(const std::string& name) {
  EnglishName out;
  std::string text = lower_case(name.substr(0, name.find('[')));
  while (!text.empty() && !is_letter(text.back()) && !is_digit(text.back())) text.pop_back();
  const auto take = [&](std::string_view word, char side) {
    if (out.side != ' ' || text.size() <= word.size()) return;
    const size_t last = text.size() - word.size();
    const bool letter = word.size() == 1;  // stands apart, or behind a number
    if (text.compare(last, word.size(), word) == 0 && !(letter && is_letter(text[last - 1]))) {
      text.erase(last);
      out.side = side;
    } else if (text.compare(0, word.size(), word) == 0 && !(letter && (is_letter(text[1]) || is_digit(text[1])))) {
      text.erase(0, word.size());
      out.side = side;
    }
  };
  take("left", 'l');
  take("right", 'r');
  take("l", 'l');
  take("r", 'r');
  for (const char c : text)
    if (is_letter(c) || is_digit(c)) out.word += c;
  return out;
}

// "thumb0", "index2", "finger13".
std::string finger_of(const std::string& word) {
  for (const FingerWord& one : kFingers) {
    const std::string_view finger = one.word;
    const bool same = word.size() == finger.size() + 1 && word.compare(0, finger.size(), finger) == 0;
    if (!same || !is_digit(word.back())) continue;
    const bool thumb = std::string_view(one.finger) == "Thumb";
    const size_t number = static_cast<size_t>(word.back() - '0');
    const bool from_one = finger.substr(0, 6) == "finger" && thumb;  // three bones, the thumb's too
    const size_t bone = number + (thumb && !from_one ? 1 : 0);
    const char* const kBonesOfThumb[] = {"Metacarpal", "Proximal", "Distal"};
    const char* const kBonesOfFinger[] = {"Proximal", "Intermediate", "Distal"};
    if (bone < 1 || bone > 3) return "";
    return std::string("left") + one.finger + (thumb ? kBonesOfThumb : kBonesOfFinger)[bone - 1];
  }
  return "";
}

std::string joint_of_english(const std::string& name) {
  if (std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; })) return "";
  const EnglishName english = english_name(name);
  std::string joint = finger_of(english.word);
  for (const BoneWord& one : kWords)
    if (joint.empty() && english.word == one.word) joint = one.name;
  if ((joint.rfind("left", 0) == 0) != (english.side != ' ')) return "";
  return english.side == 'r' ? other_side_of_person(joint) : joint;
}

std::string joint_of_japanese(const std::string& name) {
  const bool right = name.rfind(kRight, 0) == 0;
  const std::string left = right ? kLeft + name.substr(2) : name;
  for (const BoneName& bone : kBones)
    if (left == bone.shift_jis) return right ? other_side_of_person(bone.name) : bone.name;
  return "";
}

}  // namespace

std::string joint_of_vmd_bone(const std::string& name) {
  const std::string joint = joint_of_japanese(name);
  return joint.empty() ? joint_of_english(name) : joint;
}

std::string part_of_vmd_bone(const std::string& name) { return joint_of_japanese(name).empty() ? name : ""; }

bool is_vmd_ik(const std::string& name) {
  return name.find(kIk) != std::string::npos || name.find("IK") != std::string::npos;
}

std::vector<std::string> vmd_joints() {
  std::vector<std::string> names;
  for (const BoneName& bone : kBones)
    if (std::find(names.begin(), names.end(), bone.name) == names.end()) names.emplace_back(bone.name);
  return names;
}

}  // namespace sinew
