// SPDX-License-Identifier: MIT
// Which joints controls move, and to which side knees, elbows and fingers bend.
#include "sinew_character/profile/controls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

Character with_joints(std::vector<Joint> joints) {
  Character character;
  character.name = "one";
  character.joints = std::move(joints);
  return character;
}
Character of_template(const std::string& name) { return with_joints(skeleton_template(name)); }

const ControlLimb& limb_named(const ControlRig& rig, const std::string& name) {
  for (const ControlLimb& limb : rig.limbs)
    if (limb.name == name) return limb;
  throw std::runtime_error("no limb " + name);
}

TEST(Controls, OfAPersonAllThatMoves) {
  const Character person = of_template("mixamo");
  const ControlRig rig = find_controls(person);
  const auto name = [&](int j) { return j < 0 ? std::string() : person.joints[static_cast<size_t>(j)].name; };
  ASSERT_EQ(rig.limbs.size(), 4u);
  const ControlLimb& leg = limb_named(rig, "leg.left");
  EXPECT_EQ(name(leg.joints.front()), "mixamorig:LeftUpLeg");
  EXPECT_EQ(name(leg.middle), "mixamorig:LeftLeg");
  EXPECT_EQ(name(leg.joints.back()), "mixamorig:LeftFoot");
  EXPECT_EQ(name(leg.ball), "mixamorig:LeftToeBase");
  EXPECT_GT(dot(leg.pole, rig.front), 0.9) << "knees point to the front";
  const ControlLimb& arm = limb_named(rig, "arm.right");
  EXPECT_EQ(name(arm.joints.back()), "mixamorig:RightHand");
  EXPECT_LT(dot(arm.pole, rig.front), -0.9) << "elbows point back";
  EXPECT_EQ(name(rig.hips), "mixamorig:Hips");
  EXPECT_EQ(rig.spine.size(), 3u);
  EXPECT_EQ(name(rig.head), "mixamorig:Head");
  EXPECT_EQ(rig.fingers.size(), 10u);
  EXPECT_TRUE(rig.notes.empty());
  EXPECT_GT(rig.up[1], 0.99);
  EXPECT_GT(rig.front[2], 0.99);
}

// Arms of the template are held out, palms down: fingers go down when they curl, and to the body's middle never.
TEST(Controls, FingersCurlToThePalm) {
  const Character person = of_template("mixamo");
  for (const ControlFinger& finger : find_controls(person).fingers) {
    ASSERT_EQ(finger.joints.size(), 3u) << finger.name;
    EXPECT_EQ(person.joints[static_cast<size_t>(finger.hand)].name,
              finger.side > 0 ? "mixamorig:LeftHand" : "mixamorig:RightHand");
    const auto at = [&](size_t k) { return point(person.joints[static_cast<size_t>(finger.joints[k])].position); };
    const Point3 goes = cross(finger.axis, unit(at(2) - at(0)));
    EXPECT_NEAR(length(finger.axis), 1, 1e-9);
    EXPECT_LT(goes[1], finger.name.rfind("thumb", 0) == 0 ? 1 : -0.8) << finger.name;
  }
}

// Turned about and stood on its side: directions turn along, names and joints stay.
TEST(Controls, TurnWithTheBody) {
  const Character person = of_template("mixamo");
  Character turned = person;
  for (Joint& joint : turned.joints) joint.position = {joint.position.x, -joint.position.z, joint.position.y};  // z up
  const ControlRig a = find_controls(person), b = find_controls(turned);
  ASSERT_EQ(a.limbs.size(), b.limbs.size());
  EXPECT_NEAR(b.up[2], 1, 1e-9);
  for (size_t k = 0; k < a.limbs.size(); ++k) {
    EXPECT_EQ(a.limbs[k].joints, b.limbs[k].joints);
    EXPECT_NEAR(b.limbs[k].pole[1], -a.limbs[k].pole[2], 1e-6);
    EXPECT_NEAR(b.limbs[k].pole[2], a.limbs[k].pole[1], 1e-6);
  }
  for (size_t k = 0; k < a.fingers.size(); ++k) EXPECT_NEAR(b.fingers[k].axis[2], a.fingers[k].axis[1], 1e-6);
}

TEST(Controls, OfAnAnimalFourLegsOfASnakeNone) {
  const ControlRig horse = find_controls(of_template("quadruped"));
  EXPECT_EQ(horse.limbs.size(), 4u);
  for (const ControlLimb& limb : horse.limbs) EXPECT_NEAR(length(limb.pole), 1, 1e-9) << limb.name;
  std::vector<Joint> chain;
  for (int k = 0; k < 8; ++k) chain.push_back({"bone" + std::to_string(k), {0, 0, static_cast<float>(k)}, k - 1});
  const ControlRig snake = find_controls(with_joints(chain));
  EXPECT_TRUE(snake.limbs.empty());
  ASSERT_FALSE(snake.notes.empty());
  EXPECT_EQ(snake.notes[0], "no legs and no arms among the joints, so they get no IK");
  EXPECT_TRUE(find_controls(Character()).limbs.empty());
}

TEST(Controls, TheFileSaysItByNames) {
  Character person = of_template("mixamo");
  const auto json = nlohmann::json::parse(controls_text(person));
  EXPECT_EQ(json["sinew_controls"], 1);
  EXPECT_EQ(json["joints"].size(), person.joints.size());
  EXPECT_EQ(json["limbs"][0]["joints"][1], json["limbs"][0]["middle"]);
  EXPECT_EQ(json["limbs"].size(), 4u);
  EXPECT_EQ(controls_text(person).find(" -0.0,"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(controls_extras(controls_text(person)))["sinew_controls"], json);
  // As it is written: other names, all turned about y.
  const Rotation about = {-1, 0, 0, 0, 1, 0, 0, 0, -1};
  std::vector<Joint> named = person.joints;
  for (Joint& joint : named) joint.name = "a " + joint.name;
  const auto other = nlohmann::json::parse(controls_text(find_controls(person), "one", named, about));
  EXPECT_EQ(other["front"][2].get<double>(), -json["front"][2].get<double>());
  EXPECT_EQ(other["hips"], "a " + json["hips"].get<std::string>());
  person.joints[0].name = "\xff";  // no UTF-8
  EXPECT_NO_THROW(controls_text(person));
}

}  // namespace
}  // namespace sinew
