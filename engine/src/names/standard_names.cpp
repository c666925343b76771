// SPDX-License-Identifier: MIT
// Patterns of names. To add a convention, write a row of kConventions, its enumerator in sinew/names.h, and a pattern for
// each class it knows. In a pattern
//   @   represents the side
//   #   for the index: nothing, 1, 2
//   $   for the index from 1
//   %   for the index from 01
//   &   for the index as .001 .002
//   |   divides names of the first, second ... joint; further ones have none
#include "names/standard_names.hpp"

#include <string.h>

#include "names/tokens.hpp"

namespace sinew::names {
namespace {

struct Convention {
  char text[10];
  char left[6], right[6];
};

// In the order of sinew_naming.
constexpr Convention kConventions[] = {{"sinew", "Left", "Right"}, {"mixamo", "Left", "Right"},
                                       {"vrm", "left", "right"},   {"unreal", "_l", "_r"},
                                       {"rigify", ".L", ".R"},     {"makehuman", ".L", ".R"}};
constexpr uint32_t kConventionCount = sizeof kConventions / sizeof *kConventions;

struct Row {
  uint8_t joint_class;
  const char* patterns[kConventionCount];  // null: it has none
};

// "LeftHip" would be taken for hips by programs that know names: sinew's is HipJoint.
constexpr Row kRows[] = {
    {SINEW_CLASS_PELVIS, {"@Hips#", "mixamorig:Hips", "hips", "pelvis", "DEF-spine", "root"}},
    {SINEW_CLASS_SPINE,
     {"@Spine#", "mixamorig:Spine#", "spine|chest|upperChest", "spine_%", "DEF-spine&",
      "spine05|spine04|spine03|spine02|spine01"}},
    {SINEW_CLASS_NECK,
     {"@Neck#", "mixamorig:Neck#", "neck", "neck_%", "DEF-spine.004|DEF-spine.005", "neck01|neck02|neck03"}},
    {SINEW_CLASS_HEAD, {"@Head#", "mixamorig:Head", "head", "head", "DEF-spine.006", "head"}},
    {SINEW_CLASS_CLAVICLE,
     {"@Shoulder#", "mixamorig:@Shoulder", "@Shoulder", "clavicle@", "DEF-shoulder@", "clavicle@"}},
    {SINEW_CLASS_UPPER_ARM, {"@Arm#", "mixamorig:@Arm", "@UpperArm", "upperarm@", "DEF-upper_arm@", "upperarm01@"}},
    {SINEW_CLASS_FOREARM, {"@ForeArm#", "mixamorig:@ForeArm", "@LowerArm", "lowerarm@", "DEF-forearm@", "lowerarm01@"}},
    {SINEW_CLASS_HAND, {"@Hand#", "mixamorig:@Hand", "@Hand", "hand@", "DEF-hand@", "wrist@"}},
    {SINEW_CLASS_HIP, {"@HipJoint#", nullptr, nullptr, nullptr, nullptr, nullptr}},
    {SINEW_CLASS_THIGH, {"@UpLeg#", "mixamorig:@UpLeg", "@UpperLeg", "thigh@", "DEF-thigh@", "upperleg01@"}},
    {SINEW_CLASS_CALF, {"@Leg#", "mixamorig:@Leg", "@LowerLeg", "calf@", "DEF-shin@", "lowerleg01@"}},
    {SINEW_CLASS_FOOT, {"@Foot#", "mixamorig:@Foot", "@Foot", "foot@", "DEF-foot@", "foot@"}},
    {SINEW_CLASS_TOE, {"@ToeBase#", "mixamorig:@ToeBase", "@Toes", "ball@", "DEF-toe@", nullptr}},
    {SINEW_CLASS_TAIL, {"@Tail#", nullptr, nullptr, nullptr, nullptr, nullptr}},
    {SINEW_CLASS_WING, {"@Wing#", nullptr, nullptr, nullptr, nullptr, nullptr}},
    {SINEW_CLASS_EAR, {"@Ear#", nullptr, nullptr, nullptr, nullptr, nullptr}},
    {SINEW_CLASS_HAIR, {"@Hair#", nullptr, nullptr, nullptr, nullptr, nullptr}},
    {SINEW_CLASS_OTHER, {"@Bone#", nullptr, nullptr, nullptr, nullptr, nullptr}},
    {SINEW_CLASS_THUMB,
     {"@HandThumb$", "mixamorig:@HandThumb$", "@ThumbMetacarpal|@ThumbProximal|@ThumbDistal", "thumb_%@",
      "DEF-thumb.%@", "finger1-$@"}},
    {SINEW_CLASS_INDEX,
     {"@HandIndex$", "mixamorig:@HandIndex$", "@IndexProximal|@IndexIntermediate|@IndexDistal", "index_%@",
      "DEF-f_index.%@", "finger2-$@"}},
    {SINEW_CLASS_MIDDLE,
     {"@HandMiddle$", "mixamorig:@HandMiddle$", "@MiddleProximal|@MiddleIntermediate|@MiddleDistal", "middle_%@",
      "DEF-f_middle.%@", "finger3-$@"}},
    {SINEW_CLASS_RING,
     {"@HandRing$", "mixamorig:@HandRing$", "@RingProximal|@RingIntermediate|@RingDistal", "ring_%@", "DEF-f_ring.%@",
      "finger4-$@"}},
    {SINEW_CLASS_PINKY,
     {"@HandPinky$", "mixamorig:@HandPinky$", "@LittleProximal|@LittleIntermediate|@LittleDistal", "pinky_%@",
      "DEF-f_pinky.%@", "finger5-$@"}},
    {SINEW_CLASS_EYE, {"@Eye", "mixamorig:@Eye", "@Eye", nullptr, nullptr, "eye@"}},
    {SINEW_CLASS_JAW, {"@Jaw", nullptr, "jaw", nullptr, nullptr, "jaw"}},
    {SINEW_CLASS_PROP, {"@HandProp", nullptr, nullptr, nullptr, nullptr, nullptr}},
};

// A name that grows up to its room.
class Writer {
 public:
  void add(char c) {
    if (length_ + 1 < SINEW_JOINT_NAME_BYTES)
      text_[length_++] = c;
    else
      full_ = true;
  }
  void add(const char* text) {
    while (*text != 0) add(*text++);
  }
  void add(uint32_t number, uint32_t least_digits) {
    char digits[10];
    uint32_t count = 0;
    for (; number > 0 || count < least_digits; number /= 10) digits[count++] = static_cast<char>('0' + number % 10);
    while (count > 0) add(digits[--count]);
  }
  bool copy_to(char* name) const {
    if (full_) return false;
    memcpy(name, text_, length_);
    name[length_] = 0;
    return true;
  }

 private:
  char text_[SINEW_JOINT_NAME_BYTES];
  uint32_t length_ = 0;
  bool full_ = false;
};

}  // namespace

const char* naming_text(uint32_t naming) { return naming < kConventionCount ? kConventions[naming].text : nullptr; }

bool standard_name(uint32_t naming, uint32_t joint_class, int32_t side, uint32_t index,
                   char name[SINEW_JOINT_NAME_BYTES]) {
  const char* pattern = nullptr;
  for (const Row& row : kRows) {
    if (row.joint_class == joint_class) pattern = row.patterns[naming];
  }
  if (pattern == nullptr) return false;
  bool counts = false;
  for (const char* c = "#$%&"; *c != 0; ++c) counts = counts || find_letter(pattern, *c) != nullptr;
  const bool list = find_letter(pattern, '|') != nullptr;
  if (!list && !counts && index > 0) return false;
  if (naming != SINEW_NAMING_SINEW && side == 0 && find_letter(pattern, '@') != nullptr) return false;
  for (uint32_t skipped = 0; list && skipped < index; ++skipped) {
    pattern = find_letter(pattern, '|');
    if (pattern == nullptr) return false;
    ++pattern;
  }
  const Convention& convention = kConventions[naming];
  Writer out;
  for (const char* c = pattern; *c != 0 && *c != '|'; ++c) {
    if (*c == '@') {
      if (side != 0) out.add(side > 0 ? convention.left : convention.right);
    } else if (*c == '#') {
      out.add(index, 0);
    } else if (*c == '$') {
      out.add(index + 1, 1);
    } else if (*c == '%') {
      out.add(index + 1, 2);
    } else if (*c == '&') {
      out.add('.');
      out.add(index + 1, 3);
    } else {
      out.add(*c);
    }
  }
  return out.copy_to(name);
}

}  // namespace sinew::names
