// SPDX-License-Identifier: MIT
// Every kind of damage that a person of ours can have is found by a rule that tells it.
#include "sinew_trainer/rig_damage.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sinew_character/check/check.hpp"
#include "small_biped.hpp"

namespace sinew {
namespace {

const Character& biped() {
  static const Character kBiped = sinew_test::small_biped(40);
  return kBiped;
}

class RigDamage : public testing::TestWithParam<size_t> {};

TEST_P(RigDamage, IsFound) {
  const DamageKind& kind = damage_kinds()[GetParam()];
  const std::optional<DamagedRig> whole = undamaged(biped(), needs_of(kind));
  ASSERT_TRUE(whole);
  const std::optional<DamagedRig> broken = damaged(*whole, kind, 5);
  if (!broken) GTEST_SKIP() << "a biped of ours has no place for it";
  const auto check = [](const DamagedRig& rig) {
    return check_rig(rig.character, rig.motion ? &*rig.motion : nullptr);
  };
  const RigCheck before = check(*whole), now = check(*broken);
  const CheckChange change = check_change(before, whole->character.joints, now, broken->character.joints);
  const bool told = std::any_of(change.added.begin(), change.added.end(), [&](size_t i) {
    return std::any_of(kind.rules.begin(), kind.rules.end(),
                       [&](const char* rule) { return std::string(rule) == now.findings[i].rule->name; });
  });
  EXPECT_TRUE(told) << kind.what << "; " << checked_line(now);
}

INSTANTIATE_TEST_SUITE_P(Kinds, RigDamage, testing::Range<size_t>(0, damage_kinds().size()),
                         [](const testing::TestParamInfo<size_t>& at) {
                           std::string name = damage_kinds()[at.param].name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace sinew
