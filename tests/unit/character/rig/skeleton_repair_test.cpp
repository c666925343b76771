// SPDX-License-Identifier: MIT
// Flat joint lists get a hierarchy, and skeletons in other units or positions are noticed and brought back.
#include "sinew_character/rig/skeleton_repair.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew {
namespace {

std::vector<Joint> flat_body() {
  std::vector<Joint> joints;
  const auto add = [&](const char* name, float x, float y) { joints.push_back({name, {x, y, 0}, -1}); };
  add("arm1.L", 0.3f, 1.4f), add("arm2.L", 0.6f, 1.3f), add("hand.L", 0.9f, 1.2f);
  add("hips", 0, 1), add("spine", 0, 1.2f), add("head", 0, 1.7f);
  add("arm1.R", -0.3f, 1.4f), add("arm2.R", -0.6f, 1.3f), add("hand.R", -0.9f, 1.2f);
  add("leg1.L", 0.1f, 0.9f), add("leg2.L", 0.1f, 0.5f), add("foot.L", 0.1f, 0.1f);
  add("leg1.R", -0.1f, 0.9f), add("leg2.R", -0.1f, 0.5f), add("foot.R", -0.1f, 0.1f);
  return joints;
}

std::string parent_of(const std::vector<Joint>& joints, const std::string& name) {
  for (const Joint& joint : joints)
    if (joint.name == name) return joint.parent < 0 ? "" : joints[static_cast<size_t>(joint.parent)].name;
  return "?";
}

TEST(InferParents, AFlatListBecomesABody) {
  std::vector<Joint> joints = flat_body();
  EXPECT_EQ(infer_parents(&joints), 14u);
  const std::vector<std::pair<const char*, const char*>> wanted = {
      {"hips", ""},         {"spine", "hips"},    {"head", "spine"},    {"arm1.L", "spine"},  {"arm2.L", "arm1.L"},
      {"hand.L", "arm2.L"}, {"arm1.R", "spine"},  {"leg1.L", "hips"},   {"leg2.L", "leg1.L"}, {"foot.L", "leg2.L"},
      {"leg1.R", "hips"},   {"leg2.R", "leg1.R"}, {"foot.R", "leg2.R"}, {"hand.R", "arm2.R"}};
  for (const auto& [name, parent] : wanted) EXPECT_EQ(parent_of(joints, name), parent) << name;
}

TEST(InferParents, WhatHasAHierarchyStays) {
  std::vector<Joint> joints = flat_body();
  (void)infer_parents(&joints);
  EXPECT_EQ(infer_parents(&joints), 0u);
  std::vector<Joint> few = {{"a", {}, -1}, {"b", {}, -1}};
  EXPECT_EQ(infer_parents(&few), 0u);
}

TEST(InferParents, TipsStayWhereTheyHang) {
  std::vector<Joint> joints = flat_body();
  const size_t count = joints.size();
  for (size_t j = 0; j < count; ++j) {
    Joint tip = joints[j];
    tip.name += "_end";
    tip.parent = static_cast<int>(j);
    tip.position.z = 0.01f;
    joints.push_back(tip);
  }
  EXPECT_EQ(infer_parents(&joints), 14u);
  EXPECT_EQ(parent_of(joints, "arm2.L"), "arm1.L");
  EXPECT_EQ(parent_of(joints, "arm2.L_end"), "arm2.L");
}

Character body_with_mesh() {
  Character c;
  c.joints = flat_body();
  (void)infer_parents(&c.joints);
  for (const Joint& joint : c.joints)
    for (const float d : {-0.05f, 0.05f}) {
      c.vertices.push_back({joint.position.x + d, joint.position.y + 0.05f, joint.position.z + 2 * d});
      c.vertices.push_back({joint.position.x + d, joint.position.y - 0.05f, joint.position.z - 2 * d});
    }
  return c;
}

double worst_distance(const Character& c, const std::vector<Joint>& wanted) {
  double worst = 0;
  for (size_t j = 0; j < wanted.size(); ++j)
    worst = std::max(worst, static_cast<double>(std::hypot(c.joints[j].position.x - wanted[j].position.x,
                                                           c.joints[j].position.y - wanted[j].position.y,
                                                           c.joints[j].position.z - wanted[j].position.z)));
  return worst;
}

TEST(SkeletonFit, ASkeletonInItsMeshNeedsNone) { EXPECT_FALSE(find_skeleton_fit(body_with_mesh())); }

TEST(SkeletonFit, HundredfoldAndZUp) {
  for (const float scale : {1.0f, 100.0f, 0.01f, 1000.0f}) {
    for (const bool z_up : {false, true}) {
      if (scale == 1.0f && !z_up) continue;
      Character c = body_with_mesh();
      const std::vector<Joint> wanted = c.joints;
      for (Joint& joint : c.joints) {
        const Vec3 p = joint.position;
        joint.position =
            z_up ? Vec3{scale * p.x, -scale * p.z, scale * p.y} : Vec3{scale * p.x, scale * p.y, scale * p.z};
      }
      const std::optional<SkeletonFit> fit = find_skeleton_fit(c);
      ASSERT_TRUE(fit) << scale << z_up;
      apply_skeleton_fit(*fit, &c.joints);
      EXPECT_LT(worst_distance(c, wanted), 1e-4) << fit->what;
      EXPECT_EQ(fit->what.find("100 times as large") != std::string::npos, scale == 100.0f) << fit->what;
      EXPECT_EQ(fit->what.find("100 times smaller") != std::string::npos, scale == 0.01f) << fit->what;
      EXPECT_EQ(fit->what.find("Z up") != std::string::npos, z_up) << fit->what;
    }
  }
}

TEST(SkeletonFit, BesideTheMesh) {
  Character c = body_with_mesh();
  const std::vector<Joint> wanted = c.joints;
  for (Joint& joint : c.joints) joint.position.x += 5;
  const std::optional<SkeletonFit> fit = find_skeleton_fit(c);
  ASSERT_TRUE(fit);
  EXPECT_NE(fit->what.find("beside"), std::string::npos);
  apply_skeleton_fit(*fit, &c.joints);
  EXPECT_LT(worst_distance(c, wanted), 0.05);
}

}  // namespace
}  // namespace sinew
