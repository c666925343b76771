// SPDX-License-Identifier: MIT
// What joints are called: against what they hang on, against their sides, and against where a body has such joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "check/findings.hpp"

namespace sinew {
namespace {

// A person of joints with a small face around each, all of which follows it; feet and toes point to +z.
Character named_person() {
  Character c;
  c.name = "person";
  c.joints = {{"Hips", {0, 1, 0}, -1},
              {"Spine", {0, 1.2f, 0}, 0},
              {"Spine1", {0, 1.4f, 0}, 1},
              {"Neck", {0, 1.5f, 0}, 2},
              {"Head", {0, 1.6f, 0}, 3}};
  for (const float x : {1.0f, -1.0f}) {
    const std::string side = x > 0 ? "Left" : "Right";
    const auto add = [&](const char* name, Vec3 at, int parent) {
      c.joints.push_back({side + name, {x * at.x, at.y, at.z}, parent});
      return static_cast<int>(c.joints.size()) - 1;
    };
    const int shoulder = add("Shoulder", {0.06f, 1.42f, 0}, 2);
    const int arm = add("Arm", {0.2f, 1.42f, 0}, shoulder);
    (void)add("Hand", {0.7f, 1.42f, 0}, add("ForeArm", {0.45f, 1.42f, 0}, arm));
    const int foot = add("Foot", {0.1f, 0.1f, 0}, add("Leg", {0.1f, 0.5f, 0}, add("UpLeg", {0.1f, 0.95f, 0}, 0)));
    (void)add("ToeBase", {0.1f, 0.02f, 0.12f}, foot);
  }
  for (uint32_t j = 0; j < c.joints.size(); ++j) {
    const Vec3 p = c.joints[j].position;
    for (const Vec3& corner :
         {Vec3{p.x - 0.03f, p.y, p.z + 0.02f}, {p.x + 0.03f, p.y, p.z + 0.02f}, {p.x, p.y - 0.03f, p.z + 0.05f}}) {
      c.face_vertices.push_back(static_cast<uint32_t>(c.vertices.size()));
      c.vertices.push_back(corner);
      c.influences.push_back({{j, 1.0f}});
    }
    c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
  }
  return c;
}

int number_of(const Character& c, const std::string& name) {
  for (size_t j = 0; j < c.joints.size(); ++j)
    if (c.joints[j].name == name) return static_cast<int>(j);
  ADD_FAILURE() << "no joint " << name;
  return 0;
}

// Exchanges the names of two joints.
void exchange_names(Character* c, const std::string& a, const std::string& b) {
  std::swap(c->joints[static_cast<size_t>(number_of(*c, a))].name,
            c->joints[static_cast<size_t>(number_of(*c, b))].name);
}

std::vector<RigFinding> name_findings(const Character& c, const std::string& rule = "") {
  const RigFacts facts(c);
  Findings findings(c, {});
  check_names(facts, &findings);
  std::vector<RigFinding> found;
  for (const RigFinding& f : findings.all())
    if (rule.empty() || rule == f.rule->name) found.push_back(f);
  return found;
}

TEST(CheckNames, OfASoundPersonAreNoFinding) {
  Character c = named_person();
  EXPECT_TRUE(name_findings(c).empty());
  c.vertices.clear();
  c.influences.clear();
  c.face_offsets = {0};
  c.face_vertices.clear();
  EXPECT_TRUE(name_findings(c).empty()) << "nor of its skeleton alone";
}

TEST(CheckNames, ALimbOutOfOrderIsFoundAtTheJointThatShouldCarry) {
  Character c = named_person();
  exchange_names(&c, "LeftArm", "LeftForeArm");  // the upper arm hangs on the forearm now
  const std::vector<RigFinding> found = name_findings(c, "name-order");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].joint, number_of(c, "LeftArm"));
  EXPECT_EQ(found[0].other, number_of(c, "LeftForeArm"));
  EXPECT_EQ(found[0].value, 1) << "within a limb";
  EXPECT_NE(found[0].what.find("'LeftArm'"), std::string::npos) << found[0].what;
  EXPECT_NE(found[0].what.find("'LeftForeArm'"), std::string::npos);
  EXPECT_EQ(found[0].what.find('\n'), std::string::npos);
}

TEST(CheckNames, AJointOnAnotherLimbIsWorse) {
  Character c = named_person();
  c.joints[static_cast<size_t>(number_of(c, "LeftUpLeg"))].parent = number_of(c, "LeftForeArm");
  const std::vector<RigFinding> found = name_findings(c, "name-order");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].joint, number_of(c, "LeftUpLeg"));
  EXPECT_EQ(found[0].other, number_of(c, "LeftForeArm"));
  EXPECT_EQ(found[0].value, kOtherLimb);
}

TEST(CheckNames, AJointOnTheOtherSidesLimbIsAsBad) {
  Character c = named_person();
  c.joints[static_cast<size_t>(number_of(c, "LeftHand"))].parent = number_of(c, "RightForeArm");
  const std::vector<RigFinding> found = name_findings(c, "name-order");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].joint, number_of(c, "LeftHand"));
  EXPECT_EQ(found[0].value, kOtherLimb);
  EXPECT_NE(found[0].what.find("other side"), std::string::npos) << found[0].what;
}

TEST(CheckNames, JointsWithoutWeightAreNotToldOfTheirOrder) {
  Character c = named_person();
  exchange_names(&c, "LeftArm", "LeftForeArm");
  const auto arm = static_cast<uint32_t>(number_of(c, "LeftArm"));
  for (auto& row : c.influences)
    if (row[0].joint == arm) row[0].joint = 0;
  EXPECT_TRUE(name_findings(c, "name-order").empty());
}

TEST(CheckNames, APairOnExchangedSidesIsFound) {
  Character c = named_person();
  exchange_names(&c, "LeftHand", "RightHand");
  const std::vector<RigFinding> found = name_findings(c, "sides");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].joint, number_of(c, "LeftHand"));
  EXPECT_EQ(found[0].other, number_of(c, "RightHand"));
  EXPECT_EQ(found[0].value, 1);
}

// Which side is left is said by most of the pairs, and by where toes point.
TEST(CheckNames, ALeftThatIsTheRightOfAllIsOneFinding) {
  Character c = named_person();
  for (Joint& joint : c.joints) joint.position.x = -joint.position.x;
  for (Vec3& p : c.vertices) p.x = -p.x;
  const std::vector<RigFinding> found = name_findings(c, "sides");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].joint, -1) << "of the whole character";
  EXPECT_EQ(found[0].value, 8) << "pairs";
  // Turned about, a mirror image faces -z with its left at +x; a body that is turned as a whole has nothing wrong.
  Character turned = named_person();
  for (Joint& joint : turned.joints) joint.position = {-joint.position.x, joint.position.y, -joint.position.z};
  for (Vec3& p : turned.vertices) p = {-p.x, p.y, -p.z};
  EXPECT_TRUE(name_findings(turned, "sides").empty());
}

TEST(CheckNames, ArmsThatAreCalledLegsAreWhereABodyHasOtherLimbs) {
  Character c = named_person();
  for (const std::string side : {"Left", "Right"}) {
    exchange_names(&c, side + "Arm", side + "UpLeg");
    exchange_names(&c, side + "ForeArm", side + "Leg");
    exchange_names(&c, side + "Hand", side + "Foot");
  }
  const std::vector<RigFinding> found = name_findings(c, "name-place");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].value, 0.5) << "a share";
  EXPECT_LE(found[0].value, 1);
  EXPECT_GE(found[0].joint, 0);
  EXPECT_EQ(found[0].what.find('\n'), std::string::npos);
}

TEST(CheckNames, NamesThatSayNothingAreNoFinding) {
  Character c = named_person();
  for (size_t j = 0; j < c.joints.size(); ++j) c.joints[j].name = "Bone." + std::to_string(j);
  EXPECT_TRUE(name_findings(c).empty());
}

}  // namespace
}  // namespace sinew
