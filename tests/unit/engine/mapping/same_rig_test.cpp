// SPDX-License-Identifier: MIT
// A rig's own motion is known by names and hierarchy.
#include "mapping/same_rig.hpp"

#include <string>

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

}  // namespace
}  // namespace sinew::mapping
