// SPDX-License-Identifier: MIT
// Chains are kept, dropped and changed by name.
#include "sinew_character/jobs/springs_job.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "hairy_person.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

using sinew_test::HairyPerson;

HairyPerson with_chains() {
  HairyPerson person;
  person.chain("HairA", static_cast<int>(person.index("Head")), {0.03, 1.75, -0.12}, {0, -0.08, -0.01}, 3);
  person.chain("HairB", static_cast<int>(person.index("Head")), {-0.03, 1.75, -0.12}, {0, -0.08, -0.01}, 3);
  person.chain("Tail", static_cast<int>(person.index("Hips")), {0, 1, -0.16}, {0, -0.06, -0.1}, 4);
  return person;
}

TEST(SpringsJob, NamesChooseChains) {
  const Character character = with_chains().character;
  EXPECT_EQ(springs_of({}, "hero", character).springs.chains.size(), 3u);
  SpringsOptions options;
  options.drop = {"Hair*"};
  options.keep = {"HairB1"};
  options.values = {"Tail1:drag=0.7", "Tail*:radius=0"};
  options.presets = {"Tail1=ear"};
  const SpringsFound found = springs_of(options, "hero", character);
  ASSERT_EQ(found.chains.size(), 3u);
  ASSERT_EQ(found.springs.chains.size(), 1u);  // what is dropped goes, whoever else wants it
  EXPECT_EQ(found.springs.chains[0].name, "Tail1");
  for (const SpringJoint& joint : found.springs.chains[0].joints) {
    EXPECT_EQ(joint.drag, 0.7);
    EXPECT_EQ(joint.hit_radius, 0);
    EXPECT_EQ(joint.limit, 40);
  }
}

TEST(SpringsJob, AFilesOwnSpringsCountMore) {
  const TempFolder folder;
  Character character = with_chains().character;
  for (uint32_t v = 0; v + 2 < character.vertices.size(); v += 3) {
    character.face_vertices.insert(character.face_vertices.end(), {v, v + 1, v + 2});
    character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
  }
  SpringsOptions options;
  options.drop = {"Hair*"};
  const SpringsFound first = springs_of(options, "hero", character);
  GlbOptions glb;
  glb.springs = &first.springs;
  write_glb(folder.file("hero.glb"), character, glb);
  const Character again = read_gltf(folder.file("hero.glb"));
  const SpringsFound own = springs_of({}, "hero", again);
  ASSERT_EQ(own.chains.size(), 3u);
  EXPECT_TRUE(own.chains[0].own);
  EXPECT_EQ(own.chains[0].kind, SpringKind::kTail);
  EXPECT_EQ(own.springs.chains.size(), 1u);
  EXPECT_EQ(own.springs.colliders.size(), first.springs.colliders.size());
  EXPECT_EQ(own.springs.chains[0].joints[0].stiffness, first.springs.chains[0].joints[0].stiffness);
  options = {};
  options.keep = {"HairA1"};
  EXPECT_EQ(springs_of(options, "hero", again).springs.chains.size(), 2u);
  options = {};
  options.replace = true;
  EXPECT_EQ(springs_of(options, "hero", again).springs.chains.size(), 3u);
}

TEST(SpringsJob, FactorsKeepHowNumbersFallAlongAChain) {
  const Character character = with_chains().character;
  SpringsOptions options;
  options.values = {"Tail1:stiffness=x0.5", "Tail1:drag=x1000"};
  const Springs given = springs_of({}, "hero", character).springs,
                changed = springs_of(options, "hero", character).springs;
  size_t tails = 0;
  for (size_t c = 0; c < given.chains.size(); ++c) {
    const bool is_tail = given.chains[c].name == "Tail1";
    tails += is_tail;
    for (size_t i = 0; i < given.chains[c].joints.size(); ++i) {
      const SpringJoint &before = given.chains[c].joints[i], &after = changed.chains[c].joints[i];
      EXPECT_DOUBLE_EQ(after.stiffness, is_tail ? before.stiffness / 2 : before.stiffness);
      if (is_tail && before.drag > 0) {
        EXPECT_EQ(after.drag, 1);  // no more than there is
      }
    }
  }
  EXPECT_EQ(tails, 1u);
}

TEST(SpringsJob, WrongNamesAndNumbersAreOneLine) {
  const Character character = with_chains().character;
  const auto with = [&](auto change) {
    SpringsOptions options;
    change(&options);
    (void)springs_of(options, "hero", character);
  };
  EXPECT_ERROR(with([](SpringsOptions* o) { o->drop = {"Nose"}; }), "hero", "HairA1", "Nose");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->presets = {"Tail1=wing"}; }), "CHAIN=KIND", "long-hair");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->presets = {"Tail1"}; }), "CHAIN=KIND");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->values = {"Tail1:mass=1"}; }), "CHAIN:FIELD=NUMBER", "stiffness");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->values = {"Tail1:drag=2"}; }), "0 to 1", "'2'");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->values = {"Tail1:radius=nan"}; }), "a number", "nan");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->values = {"Tail1:radius=-1"}; }), "a number", "-1");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->values = {"Tail1:drag=x-1"}; }), "after x", "x-1");
  EXPECT_ERROR(with([](SpringsOptions* o) { o->values = {"Tail1:drag=x"}; }), "after x", "'x'");
}

}  // namespace
}  // namespace sinew
