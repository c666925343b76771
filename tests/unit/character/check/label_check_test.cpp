// SPDX-License-Identifier: MIT
// Suspicious weights: sound characters have none, and every kind of mistake put into one is found where it was put.
#include "sinew_character/check/label_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sinew_data_sets/dataset.hpp"
#include "small_biped.hpp"

namespace sinew {
namespace {

using sinew_test::small_biped;

uint32_t joint_named(const Character& c, const std::string& name) {
  for (uint32_t j = 0; j < c.joints.size(); ++j)
    if (c.joints[j].name == name) return j;
  ADD_FAILURE() << "no joint " << name;
  return 0;
}

// Vertices whose strongest joint is `joint`.
std::vector<uint32_t> of(const Character& c, uint32_t joint) {
  std::vector<uint32_t> out;
  for (uint32_t v = 0; v < c.vertices.size(); ++v) {
    const auto& row = c.influences[v];
    const auto top = std::max_element(row.begin(), row.end(),
                                      [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
    if (top != row.end() && top->joint == joint) out.push_back(v);
  }
  return out;
}

std::vector<uint32_t> flagged(const std::vector<LabelFinding>& findings, const std::string& code) {
  std::vector<uint32_t> out;
  for (const LabelFinding& f : findings)
    if (f.code == code) out.insert(out.end(), f.vertices.begin(), f.vertices.end());
  std::sort(out.begin(), out.end());
  return out;
}

TEST(LabelCheck, SoundCharactersHaveNoFindings) {
  for (const BodyPlan plan :
       {BodyPlan::kBiped, BodyPlan::kQuadruped, BodyPlan::kBird, BodyPlan::kSnake, BodyPlan::kManyLegged}) {
    for (uint64_t seed = 1; seed <= 3; ++seed) {
      SynthesizeOptions options;
      options.plan = plan;
      options.seed = seed;
      options.resolution = 32;
      options.clothing = false;  // the hem of a cloak that hangs from the chest can lie at a tail
      for (const LabelFinding& f : check_labels(synthesize(options)))
        ADD_FAILURE() << body_plan_name(plan) << " " << seed << ": " << f.code << " " << f.text;
    }
  }
}

TEST(LabelCheck, FindsTwinsByNameAndByPlace) {
  Character c = small_biped();
  const uint32_t left = joint_named(c, "upper_arm.L"), right = joint_named(c, "upper_arm.R");
  std::vector<uint32_t> twins = mirror_twins(c);
  EXPECT_EQ(twins[left], right);
  EXPECT_EQ(twins[right], left);
  for (size_t j = 0; j < c.joints.size(); ++j) {
    EXPECT_EQ(twins[twins[j]], j);
    c.joints[j].name = "j" + std::to_string(j);
  }
  twins = mirror_twins(c);
  EXPECT_EQ(twins[left], right);
  EXPECT_EQ(twins[right], left);
}

TEST(LabelCheck, FindsALimbBoundToTheOtherSide) {
  Character c = small_biped();
  const uint32_t left = joint_named(c, "forearm.L"), right = joint_named(c, "forearm.R");
  const std::vector<uint32_t> some = of(c, right);
  ASSERT_GT(some.size(), 8u);
  for (size_t i = 0; i < 4; ++i) c.influences[some[i]] = {{left, 1.0f}};
  const std::vector<uint32_t> expected(some.begin(), some.begin() + 4);
  EXPECT_EQ(flagged(check_labels(c), "left-right"), expected);
}

TEST(LabelCheck, FindsAnIslandAndAFarWeight) {
  Character c = small_biped();
  const uint32_t head = joint_named(c, "head"), foot = joint_named(c, "foot.L");
  const std::vector<uint32_t> feet = of(c, foot);
  ASSERT_GT(feet.size(), 5u);
  for (const uint32_t v : feet) c.influences[v] = {{head, 1.0f}};
  const std::vector<LabelFinding> findings = check_labels(c);
  std::vector<uint32_t> found = flagged(findings, "island");
  const std::vector<uint32_t> far = flagged(findings, "far-weight");
  found.insert(found.end(), far.begin(), far.end());
  EXPECT_GT(found.size(), feet.size() * 8 / 10) << "of " << feet.size();
  for (const uint32_t v : found) EXPECT_TRUE(std::binary_search(feet.begin(), feet.end(), v)) << v;

  Character blurred = small_biped();
  const uint32_t v = of(blurred, foot)[2];
  blurred.influences[v] = {{foot, 0.7f}, {head, 0.3f}};
  EXPECT_EQ(flagged(check_labels(blurred), "far-weight"), std::vector<uint32_t>{v});
  blurred.influences[v] = {{foot, 0.95f}, {head, 0.05f}};
  EXPECT_TRUE(check_labels(blurred).empty()) << "a little blur is no label";
}

TEST(LabelCheck, FindsAVertexUnlikeAllItsNeighbors) {
  Character c = small_biped();
  // Near enough not to be "across the body": the next joint but one.
  const uint32_t hips = joint_named(c, "hips"), shin = joint_named(c, "shin.L");
  std::vector<uint32_t> rigid;
  for (const uint32_t v : of(c, shin))
    if (c.influences[v][0].weight > 0.999f) rigid.push_back(v);
  ASSERT_FALSE(rigid.empty());
  size_t found = 0;
  for (const uint32_t v : rigid) {
    Character changed = c;
    changed.influences[v] = {{hips, 1.0f}};
    for (const LabelFinding& f : check_labels(changed)) found += f.vertices == std::vector<uint32_t>{v} ? 1 : 0;
  }
  EXPECT_GT(found, rigid.size() / 2) << "of " << rigid.size();
}

TEST(LabelCheck, FindsAnIdleTwin) {
  Character c = small_biped();
  const uint32_t left = joint_named(c, "hand.L"), right = joint_named(c, "hand.R");
  const auto parent = static_cast<uint32_t>(c.joints[left].parent);
  for (auto& row : c.influences)
    for (Influence& i : row)
      if (i.joint == left) i.joint = parent;
  const std::vector<LabelFinding> findings = check_labels(c);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, "idle-twin");
  EXPECT_EQ(findings[0].joint, left);
  EXPECT_EQ(findings[0].better, right);
}

TEST(LabelCheck, BrokenCharactersHaveNoFindingsAndDoNoHarm) {
  EXPECT_TRUE(check_labels({}).empty());
  Character c = small_biped();
  c.influences[0] = {{999999, 1.0f}};
  EXPECT_TRUE(check_labels(c).empty());
  c = small_biped();
  c.joints[1].parent = 1;
  EXPECT_TRUE(check_labels(c).empty());
  c = small_biped();
  c.influences.resize(3);
  EXPECT_TRUE(check_labels(c).empty());
}

TEST(LabelCheck, FindingsAreWarningsOfTheCheckWithTheirVertices) {
  Character c = small_biped();
  const uint32_t left = joint_named(c, "forearm.L"), right = joint_named(c, "forearm.R");
  const uint32_t v = of(c, right)[0];
  c.influences[v] = {{left, 1.0f}};
  const CheckReport report = check_character(c);
  const auto found = std::find_if(report.findings.begin(), report.findings.end(),
                                  [](const CheckFinding& f) { return f.code == "left-right"; });
  ASSERT_NE(found, report.findings.end());
  EXPECT_EQ(found->level, CheckFinding::Level::kWarning);
  EXPECT_EQ(found->vertices, std::vector<uint32_t>{v});
}

TEST(LabelCheck, JointsThatNothingTellsApartAreFound) {
  Character c;  // three flat joints, one triangle each
  c.name = "boxes";
  c.joints = {{"root", {0, 0, 0}, -1}, {"a", {1, 0, 0}, 0}, {"b", {1, 0, 0}, 0}, {"c", {3, 0, 0}, 0}};
  for (uint32_t j = 1; j < 4; ++j) {
    const float x = static_cast<float>(j);
    for (const Vec3& p : {Vec3{x, 0, 0}, Vec3{x, 1, 0}, Vec3{x, 0, 1}}) {
      c.vertices.push_back(p);
      c.influences.push_back({{j, 1.0f}});
    }
  }
  c.face_offsets = {0, 3, 6, 9};
  c.face_vertices = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const auto shared = [](const Character& character) {
    std::vector<LabelFinding> out;
    for (const LabelFinding& f : check_labels(character))
      if (f.code == "shared-position") out.push_back(f);
    return out;
  };
  const std::vector<LabelFinding> findings = shared(c);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].text,
            "67 % of the vertices are bound to joints at the position of a sibling, such as 'a' and 'b': it is "
            "ambiguous which holds what");
  Character chain = c;
  chain.joints[2].parent = 1;
  EXPECT_TRUE(shared(chain).empty()) << "a parent and its child are told apart by the hierarchy";
  Character apart = c;
  apart.joints[2].position = {2, 0, 0};
  EXPECT_TRUE(shared(apart).empty());
  Character idle = c;
  for (size_t v = 3; v < 6; ++v) idle.influences[v] = {{3, 1.0f}};
  EXPECT_TRUE(shared(idle).empty()) << "a control bone at the place of another holds nothing";
}

}  // namespace
}  // namespace sinew
