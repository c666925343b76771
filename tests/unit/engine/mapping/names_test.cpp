// SPDX-License-Identifier: MIT
// Names of joints in the conventions of several programs.
#include "mapping/names.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sinew::mapping {
namespace {

NameWords read(const std::string& name) {
  NameWords words;
  words.read(name.c_str());
  return words;
}

struct Known {
  const char* name;
  Word word;
  int side;
  int number;
  bool end;
};

TEST(MappingNames, ConventionsAreRead) {
  const Known known[] = {
      {"mixamorig:LeftForeArm", Word::kLowerArm, 1, 0, false},
      {"upperarm_r", Word::kUpperArm, -1, 0, false},
      {"spine_03", Word::kSpine, 0, 3, false},
      {"Bip01 L Thigh", Word::kUpLeg, 1, 1, false},
      {"DEF-shin.R.001", Word::kLowLeg, -1, 1, false},
      {"HeadTop_End", Word::kNone, 0, 0, true},
      {"Head_end", Word::kHead, 0, 0, true},
      {"lhand", Word::kHand, 1, 0, false},
      {"RightHandIndex2", Word::kIndex, -1, 2, false},
      {"FrontLowerLeg.L", Word::kForeLeg, 1, 0, false},
      {"armature|Hips", Word::kHips, 0, 0, false},
      {"J7", Word::kNone, 0, 7, false},
      {"pCube1", Word::kNone, 0, 1, false},
      {"", Word::kNone, 0, 0, false},
  };
  for (const Known& one : known) {
    const Class got = read(one.name).cls;
    EXPECT_EQ(static_cast<int>(got.word), static_cast<int>(one.word)) << one.name;
    EXPECT_EQ(got.side, one.side) << one.name;
    EXPECT_EQ(got.number, one.number) << one.name;
    EXPECT_EQ(got.end, one.end) << one.name;
  }
}

TEST(MappingNames, NothingIsTooLongOrStrange) {
  EXPECT_EQ(read(std::string(5000, 'a')).cls.word, Word::kNone);
  std::string mixed;
  for (int i = 0; i < 500; ++i) mixed += i % 2 == 0 ? "a" : "1";
  EXPECT_LE(read(mixed).count, kMostWords);
  EXPECT_EQ(read(std::string(400, 'x') + ":Left" + "Hand").cls.word, Word::kHand);
  EXPECT_EQ(read("\xC3\xA4rm\xFF\x01").cls.side, 0);
  NameWords none;
  none.read(nullptr);
  EXPECT_EQ(none.count, 0);
  EXPECT_EQ(read("x9999999999").cls.number, 999999);
}

TEST(MappingNames, OverlapIsSharedOverAll) {
  const NameWords a = read("upper_arm_twist"), b = read("arm_twist_2");
  EXPECT_DOUBLE_EQ(overlap(a.hashes, a.count, b.hashes, b.count), 0.5);
  EXPECT_EQ(overlap(a.hashes, a.count, b.hashes, 0), 0);
}

}  // namespace
}  // namespace sinew::mapping
