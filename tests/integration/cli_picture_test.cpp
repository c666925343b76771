// SPDX-License-Identifier: MIT
// The sinew command on pictures: a character, its mask, motion in the picture's plane, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_character/picture/sprites.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

const std::string kChild = kData + "/drawing__child.png", kCat = kData + "/drawing__cat.png",
                  kSketch = kData + "/drawing__sketch.png";

class CliPicture : public Cli {};

TEST_F(CliPicture, ADrawingBecomesACharacterInItsOwnPlace) {
  const auto said =
      nlohmann::json::parse(good("rig " + kChild + " --units pixels --mask-out mask.png --json -o child.glb").out);
  EXPECT_EQ(said["picture"]["class"], "biped");
  EXPECT_EQ(said["picture"]["view"], "from the front");
  EXPECT_TRUE(fs::exists(in("mask.png")));
  const Character made = read_character(in("child.glb"));
  EXPECT_GT(made.vertices.size(), 500u);
  EXPECT_LT(made.vertices.size(), 4000u);
  EXPECT_EQ(made.influences.size(), made.vertices.size());
  bool head = false;
  for (const Joint& joint : made.joints) {
    EXPECT_LT(std::abs(joint.position.z), 5) << joint.name;
    EXPECT_GT(joint.position.x, 0) << joint.name;
    EXPECT_LT(joint.position.x, 360) << joint.name;
    if (joint.name == "Head") head = std::abs(joint.position.x - 180) < 12 && joint.position.y > 300;
  }
  EXPECT_TRUE(head);
  const std::string glb = slurp(in("child.glb"));
  EXPECT_NE(glb.find("KHR_materials_unlit"), std::string::npos);
  EXPECT_NE(glb.find(slurp(kChild)), std::string::npos) << "the picture is the texture, to the byte";
}

TEST_F(CliPicture, ClassesAndViewsAreTold) {
  const auto cat = nlohmann::json::parse(good("rig " + kCat + " --json -o cat.rig.txt").out);
  EXPECT_EQ(cat["picture"]["class"], "quadruped");
  EXPECT_EQ(cat["picture"]["view"], "facing right");
  const auto sketch = nlohmann::json::parse(good("rig " + kSketch + " --json -o sketch.rig.txt").out);
  EXPECT_EQ(sketch["picture"]["class"], "biped");
  const auto given = nlohmann::json::parse(good("rig " + kSketch + " --class fish --json -o fish.rig.txt").out);
  EXPECT_EQ(given["picture"]["class"], "fish");
}

// What a camera adds: light and shade on the body, a wall with a grain, out-of-focus blots on it, noise of the sensor.
TEST_F(CliPicture, PhotographsAreRead) {
  good("pose " + kData + "/biped__robed.obj --joint head=0,10,0 -o seen.png");
  Pixels photograph = read_picture(in("seen.png")).pixels;
  std::mt19937 random(7);
  for (uint32_t y = 0; y < photograph.height; ++y)
    for (uint32_t x = 0; x < photograph.width; ++x) {
      const float blots =
          6 * std::sin(0.013f * static_cast<float>(x) + 0.6f) * std::cos(0.017f * static_cast<float>(y));
      for (uint32_t c = 0; c < 3; ++c) {
        uint8_t& value = photograph.rgba[4 * (size_t{y} * photograph.width + x) + c];
        const float noise = static_cast<float>(random() % 1000) / 1000 + static_cast<float>(random() % 1000) / 1000 - 1;
        value = static_cast<uint8_t>(std::clamp(static_cast<float>(value) + blots + 5 * noise, 0.0f, 255.0f));
      }
    }
  const std::vector<uint8_t> bytes = encode_png(photograph);
  put(in("photograph.png"), std::string(bytes.begin(), bytes.end()));
  const auto said = nlohmann::json::parse(good("rig photograph.png --units pixels --json -o photograph.glb").out);
  EXPECT_EQ(said["picture"]["class"], "biped");
  good("rig seen.png --units pixels -o seen.glb");
  const Box noisy = box_of(read_character(in("photograph.glb")).vertices);
  const Box clean = box_of(read_character(in("seen.glb")).vertices);
  EXPECT_NEAR(noisy.high.x - noisy.low.x, clean.high.x - clean.low.x, 12) << "the figure without the wall";
  EXPECT_NEAR(noisy.high.y - noisy.low.y, clean.high.y - clean.low.y, 12);
}

// Outline, triangulation, regions, branches, motion: no model is asked for the skeleton, and names say nothing.
TEST_F(CliPicture, TheDrawnRouteIsOneCommand) {
  const Outcome told = good("animate " + kCat + " --as-drawn -o cat.glb");
  EXPECT_NE(told.out.find("joints mapped by branches"), std::string::npos) << told.out;
  const Character cat = read_character(in("cat.glb"));
  for (const Joint& joint : cat.joints) EXPECT_EQ(joint.name.find("Left"), std::string::npos) << joint.name;
  ASSERT_EQ(cat.joints.size(), read_motion(in("cat.glb")).joints.size());
  EXPECT_NE(bad(2, "animate " + kCaped + " --motion builtin:walk --as-drawn -o a.glb")
                .error.find("--as-drawn needs a picture"),
            std::string::npos);
}

// No bone changes its length as it is seen, and none leaves the plane.
TEST_F(CliPicture, MotionStaysInThePlane) {
  const Outcome told = good("animate " + kChild + " --units pixels -o child.glb --sheet child.png");
  EXPECT_NE(told.out.find("builtin:person/wave"), std::string::npos) << told.out;
  const size_t checked = told.out.find("checked: ");
  EXPECT_NE(checked, std::string::npos) << told.out;
  EXPECT_EQ(told.out.find("checked: ", checked + 1), std::string::npos) << "once: " << told.out;
  EXPECT_TRUE(fs::exists(in("child.png")));
  const Motion motion = read_motion(in("child.glb"));
  ASSERT_EQ(motion.clips.size(), 1u);
  double most = 0, moved = 0;
  for (const MotionFrame& frame : motion.clips[0].frames) {
    const WorldPose pose = world_pose(motion, frame);
    for (size_t j = 0; j < motion.joints.size(); ++j) {
      if (motion.joints[j].parent < 0) continue;
      const Point3 &a = pose.positions[j], &b = pose.positions[static_cast<size_t>(motion.joints[j].parent)],
                   &rest = motion.joints[j].offset;
      const double before = std::hypot(rest[0], rest[1]);
      if (before > 1) most = std::max(most, std::abs(std::hypot(a[0] - b[0], a[1] - b[1]) / before - 1));
      moved = std::max(moved, std::hypot(a[0] - b[0] - rest[0], a[1] - b[1] - rest[1]));
    }
  }
  EXPECT_LT(most, 0.01);
  EXPECT_GT(moved, 20);
}

TEST_F(CliPicture, FramesForOtherPrograms) {
  good("animate " + kChild + " -o out.glb --sprites 4 --loop loop.png");
  const auto json = nlohmann::json::parse(slurp(in("out.sprites.json")));
  ASSERT_EQ(json["frames"].size(), 4u);
  EXPECT_EQ(json["meta"]["image"], "out.sprites.png");
  EXPECT_EQ(json["meta"]["frameTags"][0]["name"], "wave");
  const auto& last = json["frames"]["wave 3"]["frame"];
  EXPECT_EQ(last["y"].get<int>() + last["h"].get<int>(), json["meta"]["size"]["h"].get<int>());
  EXPECT_NE(slurp(in("loop.png")).find("acTL"), std::string::npos);
  EXPECT_NE(bad(2, "animate " + kCaped + " --motion builtin:walk -o a.glb --sprites 4")
                .error.find("--sprites is for pictures"),
            std::string::npos);
}

TEST_F(CliPicture, AnAnimatedPictureAlone) {
  good("animate " + kChild + " -o child.apng");
  EXPECT_NE(slurp(in("child.apng")).find("acTL"), std::string::npos);
  EXPECT_NE(bad(2, "animate " + kChild + " -o b.apng --for unreal").error.find("leave out --loop, --for and"),
            std::string::npos);
  EXPECT_NE(bad(2, "animate " + kCaped + " --motion builtin:walk -o b.apng").error.find("b.apng"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("b.apng")));
}

TEST_F(CliPicture, LinesInsideAreCutOnDemand) {
  const auto cut =
      nlohmann::json::parse(good("rig " + kCat + " --cut --no-bind --mask-out cut.png --json -o cut.glb").out);
  good("rig " + kCat + " --no-bind --mask-out whole.png -o whole.glb");
  EXPECT_NE(cut["notes"].dump().find("cut"), std::string::npos) << cut["notes"];
  EXPECT_NE(bad(2, "animate " + kCaped + " --motion builtin:walk --cut -o a.glb").error.find("--cut is for pictures"),
            std::string::npos);
}

TEST_F(CliPicture, AFolderOfPictures) {
  fs::create_directory(in("drawings"));
  put(in("drawings/child.png"), slurp(kChild));
  put(in("drawings/cat.png"), slurp(kCat));
  good("rig drawings -o rigged");
  EXPECT_TRUE(fs::exists(in("rigged/child.glb")));
  EXPECT_TRUE(fs::exists(in("rigged/cat.glb")));
  EXPECT_NE(bad(2, "rig drawings -o rigged --figure 1").error.find("--figure takes one picture"), std::string::npos);
  good("animate drawings --format apng -o moving");
  EXPECT_TRUE(fs::exists(in("moving/child.apng")));
  EXPECT_TRUE(fs::exists(in("moving/cat.apng")));
  put(in("drawings/empty.png"), "");
  const Outcome some = run("animate drawings -o moved");
  EXPECT_EQ(some.status, 1);
  EXPECT_NE(some.error.find("error: 1 of 3 characters failed"), std::string::npos) << some.error;
  EXPECT_TRUE(fs::exists(in("moved/cat.glb")));
  EXPECT_NE(bad(2, "animate drawings -o other --sheet a.png").error.find("--sheet takes one character"),
            std::string::npos);
}

TEST_F(CliPicture, WhatIsNoPictureOfACharacterIsALine) {
  put(in("empty.png"), "");
  EXPECT_NE(
      bad(1, "rig empty.png -o a.glb").error.find("empty.png: expected a PNG or JPEG picture, found an empty file"),
      std::string::npos);
  put(in("cut.png"), slurp(kChild).substr(0, 3000));
  EXPECT_NE(bad(1, "rig cut.png -o a.glb").error.find("cut.png: cannot read this PNG"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("a.glb")));
  EXPECT_NE(bad(1, "rig " + kChild + " --figure 2 -o a.glb").error.find("no figure 2, found 1"), std::string::npos);
  EXPECT_NE(bad(2, "rig " + kSnake + " --flat -o a.glb").error.find("--flat is for pictures"), std::string::npos);
  EXPECT_NE(bad(2, "animate " + kCaped + " -o a.glb").error.find("--motion is required"), std::string::npos);
}

}  // namespace
}  // namespace sinew
