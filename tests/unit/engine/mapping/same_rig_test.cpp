// SPDX-License-Identifier: MIT
// A rig's own motion is known by names and hierarchy, or by hierarchy and positions.
#include <string>

#include "mapping/hierarchy.hpp"
#include "small_rig.hpp"

namespace sinew::mapping {
namespace {

struct Named : SmallRig {
  std::vector<std::string> texts = {"hips", "chest", "head", "arm_l", "hand_l", "arm_r", "hand_r"};
  std::vector<const char*> names;

  sinew_skeleton named() {
    names.clear();
    for (const std::string& text : texts) names.push_back(text.c_str());
    sinew_skeleton view_of = view();
    view_of.names = names.data();
    return view_of;
  }
};

bool same(Named* target, Named* source, std::vector<int32_t>* sources) {
  EXPECT_EQ(target->build(), SINEW_OK);
  EXPECT_EQ(source->build(), SINEW_OK);
  sources->assign(target->parents.size(), -7);
  std::vector<int32_t> scratch(source->parents.size());
  return is_same_rig(target->named(), source->named(), target->rig, source->rig, sources->data(), scratch.data());
}

TEST(MapSameRig, InAnotherOrderAndAtOtherPlacesItIsTheSame) {
  Named target, source;
  source.texts = {"hips", "chest", "head", "arm_r", "hand_r", "arm_l", "hand_l"};
  for (float& x : source.positions) x = 10 * x + 3;
  std::vector<int32_t> sources;
  ASSERT_TRUE(same(&target, &source, &sources));
  EXPECT_EQ(sources, (std::vector<int32_t>{0, 1, 2, 5, 6, 3, 4}));
}

TEST(MapSameRig, AnotherHierarchyIsNot) {
  Named target, source;
  source.parents[5] = 0;  // an arm on the hips
  std::vector<int32_t> sources;
  EXPECT_FALSE(same(&target, &source, &sources));
}

TEST(MapSameRig, ALeafMayBeMissingAnInnerJointNot) {
  Named target, source;
  source.texts[6] = "glove_r";
  std::vector<int32_t> sources;
  ASSERT_TRUE(same(&target, &source, &sources));
  EXPECT_EQ(sources[6], -1);
  source.texts[6] = "hand_r";
  source.texts[5] = "wing_r";
  EXPECT_FALSE(same(&target, &source, &sources));
}

bool alike(Named* target, Named* source, bool names, std::vector<int32_t>* sources) {
  EXPECT_EQ(target->build(), SINEW_OK);
  EXPECT_EQ(source->build(), SINEW_OK);
  EXPECT_EQ(target->rig.build(names ? target->named() : target->view(), names), SINEW_OK);
  EXPECT_EQ(source->rig.build(names ? source->named() : source->view(), names), SINEW_OK);
  sources->assign(target->parents.size(), -7);
  std::vector<int32_t> scratch(source->parents.size());
  return is_same_shape(target->rig, source->rig, sources->data(), scratch.data());
}

// The right arm comes first in the source, which is twice as large and stands elsewhere.
TEST(MapSameShape, UnderOtherNamesItIsTheSame) {
  Named target, source;
  source.texts = {"a", "b", "c", "d", "e", "f", "g"};
  for (size_t k = 9; k < 15; ++k) std::swap(source.positions[k], source.positions[k + 6]);
  for (float& x : source.positions) x = 2 * x + 3;
  std::vector<int32_t> sources;
  for (const bool names : {false, true}) {
    ASSERT_TRUE(alike(&target, &source, names, &sources)) << names;
    EXPECT_EQ(sources, (std::vector<int32_t>{0, 1, 2, 5, 6, 3, 4})) << names;
  }
}

TEST(MapSameShape, OneThatLooksTheOtherWayOrHasOtherBonesIsNot) {
  std::vector<int32_t> sources;
  Named target, source;
  source.texts = {"hips", "chest", "head", "arm_r", "hand_r", "arm_l", "hand_l"};  // sides exchanged
  EXPECT_TRUE(alike(&target, &source, false, &sources));
  EXPECT_FALSE(alike(&target, &source, true, &sources));
  Named longer;
  longer.positions[12] += 2;  // a hand
  EXPECT_FALSE(alike(&target, &longer, false, &sources));
  Named other;
  other.parents[4] = 1;  // both hang on the chest
  EXPECT_FALSE(alike(&target, &other, false, &sources));
}

}  // namespace
}  // namespace sinew::mapping
