// SPDX-License-Identifier: MIT
// sinew animate and sinew pose --animation: motions onto characters, and what a user may get wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "gltf_validator.hpp"
#include "make_glb.hpp"
#include "nodding_motion.hpp"
#include "scene_files.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

class CliAnimate : public Cli {
 protected:
  // A clip for the robed biped's own joints in which one arm swings and the body rises; in x.bvh.
  Motion make_clip(const std::string& name, size_t frames = 10) {
    Character biped;
    read_skeleton(kData + "/biped__robed.rig.txt", false, &biped);
    Motion motion = motion_of(biped.joints);
    motion.name = "clip";
    Clip clip = {name, 0.05, {}};
    for (size_t f = 0; f < frames; ++f) {
      MotionFrame frame;
      for (const MotionJoint& joint : motion.joints) {
        frame.rotations.push_back(kNoRotation4);
        frame.translations.push_back(joint.offset);
      }
      const double angle = 0.1 * static_cast<double>(f);
      frame.rotations[arm_of(biped)] = {0, 0, std::sin(angle / 2), std::cos(angle / 2)};
      for (size_t j = 0; j < motion.joints.size(); ++j)
        if (motion.joints[j].parent < 0) frame.translations[j][2] += 0.02 * static_cast<double>(f);
      clip.frames.push_back(frame);
    }
    motion.clips.push_back(clip);
    write_bvh(in(name + ".bvh"), motion, motion.clips[0]);
    return motion;
  }
  // A leaf's parent: some joint of a limb.
  static size_t arm_of(const Character& character) { return static_cast<size_t>(character.joints.back().parent); }
};

TEST_F(CliAnimate, TheSameRigPlaysAsItWasRecorded) {
  const Motion clip = make_clip("swing");
  good("bind " + kData + "/biped__robed.obj --skeleton " + kData + "/biped__robed.rig.txt --joints all -o hero.glb");
  const Outcome told = good("animate hero.glb --motion swing.bvh -o moved.glb --sheet sheet.png");
  EXPECT_NE(told.out.find("swing.bvh, swing: 10 frames, 20 per second"), std::string::npos) << told.out;
  EXPECT_GT(fs::file_size(in("sheet.png")), 2000u);
  const Motion moved = read_gltf_motion(in("moved.glb"), 20);
  ASSERT_EQ(moved.clips.size(), 1u);
  EXPECT_EQ(moved.clips[0].name, "swing");
  ASSERT_EQ(moved.clips[0].frames.size(), 10u);
  for (size_t f = 0; f < 10; ++f) {
    const WorldPose a = world_pose(moved, moved.clips[0].frames[f]), b = world_pose(clip, clip.clips[0].frames[f]);
    for (size_t j = 0; j < clip.joints.size(); ++j)
      for (size_t i = 0; i < 3; ++i) ASSERT_NEAR(a.positions[j][i], b.positions[j][i], 5e-6) << f << " " << j;
  }
  // The file again as a motion, one clip chosen, in two formats.
  good("animate hero.glb --motion moved.glb#swing --motion swing.bvh -o both.gltf");
  EXPECT_EQ(read_gltf_motion(in("both.gltf")).clips.size(), 2u);
  good("animate hero.glb --motion moved.glb --fps 10 --start 0.1 --end 0.4 -o part.bvh");
  const Motion part = read_bvh(in("part.bvh"));
  ASSERT_EQ(part.clips[0].frames.size(), 4u);
  EXPECT_NEAR(part.clips[0].frame_time, 0.1, 1e-9);
  // Its own animation as a pose.
  good("pose moved.glb --animation swing --time 0.45 -o posed.obj");
  good("pose moved.glb --animation 0 -o first.png");
  const Character rest = read_gltf(in("hero.glb")), posed = read_obj(in("posed.obj"));
  double most = 0;
  for (size_t v = 0; v < rest.vertices.size(); ++v)
    most = std::max(most, static_cast<double>(std::abs(posed.vertices[v].z - rest.vertices[v].z)));
  EXPECT_GT(most, 0.17);
  const auto json =
      nlohmann::json::parse(good("animate hero.glb --motion swing.bvh --in-place -o still.glb --json").out);
  EXPECT_EQ(json["clips"][0]["frames"], 10);
  EXPECT_EQ(json["clips"][0]["map"], "anatomy and names");
  const Motion still = read_gltf_motion(in("still.glb"), 20);
  EXPECT_NEAR(world_pose(still, still.clips[0].frames[9]).positions[0][2],
              world_pose(still, still.clips[0].frames[0]).positions[0][2], 0.02);
  const std::vector<std::string> written = {in("moved.glb"), in("both.gltf"), in("still.glb")};
  SINEW_EXPECT_VALID_GLTF(written);
}

TEST_F(CliAnimate, JointsStayWithinTheirLimits) {
  const Motion walk = walking_person(8);
  write_bvh(in("walk.bvh"), walk, walk.clips[0]);
  const std::string robot = "animate " + kData + "/biped__robot.obj --motion walk.bvh ";
  Character rig;
  read_skeleton(kData + "/biped__robot.rig.txt", false, &rig);
  good(robot + "-o free.glb");
  const Motion free = read_gltf_motion(in("free.glb"));
  size_t moving = 0;  // a joint that turns
  for (size_t j = 0; j < rig.joints.size(); ++j)
    if (free.clips[0].frames[3].rotations[j][3] < free.clips[0].frames[3].rotations[moving][3]) moving = j;
  put(in("stiff.limits"), "fixed " + rig.joints[moving].name + "\n");
  good(robot + "--limits stiff.limits -o stiff.glb");
  const Motion stiff = read_gltf_motion(in("stiff.glb"));
  for (const MotionFrame& frame : stiff.clips[0].frames) EXPECT_NEAR(std::abs(frame.rotations[moving][3]), 1, 1e-6);
  good(robot + "--limits human -o human.glb");
  put(in("wrong.limits"), "fixed nobody\n");
  EXPECT_NE(bad(1, robot + "--limits wrong.limits -o none.glb").error.find("wrong.limits:1: expected a joint of"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(in("none.glb")));
}

// The same walk with a rest pose that is none: joints in frames of their own, with and without names, a frame of the clip, facing elsewhere.
TEST_F(CliAnimate, AMotionPlaysTheSameHoweverItIsWritten) {
  const Motion walk = walking_person();
  const std::string robot = kData + "/biped__robot.obj";
  const auto play = [&](const Motion& motion, bool told) {
    write_bvh(in("walk.bvh"), motion, motion.clips[0]);
    const Outcome outcome = good("animate " + robot + " --motion walk.bvh -o moved.glb");
    EXPECT_EQ(outcome.out.find("its rest pose is not a standing pose") != std::string::npos, told) << outcome.out;
    const Motion moved = read_gltf_motion(in("moved.glb"), 30);
    std::vector<Point3> positions;
    for (const MotionFrame& frame : moved.clips.at(0).frames)
      for (const Point3& p : world_pose(moved, frame).positions) positions.push_back(p);
    return positions;
  };
  const std::vector<Point3> wanted = play(walk, false);
  const double height = 1.42;  // of the robot
  const auto expect = [&](const Motion& motion, bool told, double most) {
    const std::vector<Point3> found = play(motion, told);
    ASSERT_EQ(found.size(), wanted.size());
    double sum = 0;
    for (size_t i = 0; i < found.size(); ++i)
      sum += std::hypot(found[i][0] - wanted[i][0], found[i][1] - wanted[i][1], found[i][2] - wanted[i][2]);
    EXPECT_LT(sum / static_cast<double>(found.size()), most * height);
  };
  expect(numbered(walk), false, 0.005);
  expect(with_random_axes(walk), true, 0.04);
  expect(with_rest_of_frame(walk, 10), true, 0.04);
  expect(with_random_axes(numbered(walk)), true, 0.04);
  good("map " + robot + " --from walk.bvh -o map.txt");
  good("animate " + robot + " --motion walk.bvh --map map.txt -o again.glb");
}

TEST_F(CliAnimate, AMotionThatDoesNotFitIsRefusedUnlessForced) {
  const Motion walk = walking_person(8);
  write_bvh(in("walk.bvh"), walk, walk.clips[0]);
  const std::string animal = kData + "/quadruped__tailed.obj";
  const size_t before = files();
  const Outcome refused = bad(1, "animate " + animal + " --motion walk.bvh -o out.glb");
  EXPECT_NE(refused.error.find("does not fit"), std::string::npos) << refused.error;
  EXPECT_NE(refused.error.find("one is upright, the other is not"), std::string::npos) << refused.error;
  EXPECT_EQ(files(), before);
  good("animate " + animal + " --motion walk.bvh -o out.glb --force");
}

TEST_F(CliAnimate, AMapSaysWhichJointMovesAsWhich) {
  make_clip("swing");
  const std::string robot = kData + "/biped__robot.obj";
  Character target, source;
  read_skeleton(kData + "/biped__robot.rig.txt", false, &target);
  read_skeleton(kData + "/biped__robed.rig.txt", false, &source);
  const std::string a = target.joints[0].name, b = source.joints[0].name;
  put(in("map.txt"), "# by hand\n" + a + " " + b + "\n" + target.joints[1].name + " -\n");
  const Outcome told = good("animate " + robot + " --motion swing.bvh --map map.txt -o moved.glb");
  EXPECT_NE(told.out.find("1 of " + std::to_string(target.joints.size()) + " joints mapped by map.txt"),
            std::string::npos)
      << told.out;
  const auto expect = [&](const std::string& map, const char* wanted) {
    put(in("map.txt"), map);
    const size_t before = files();
    const Outcome refused = bad(1, "animate " + robot + " --motion swing.bvh --map map.txt -o new.glb");
    EXPECT_NE(refused.error.find(wanted), std::string::npos) << refused.error;
    EXPECT_EQ(files(), before);
  };
  expect(a + "\n", "map.txt:1: expected 'TARGET_JOINT SOURCE_JOINT'");
  expect("\nnobody " + b + "\n", "map.txt:2: expected a joint of ");
  expect(a + " nobody\n", "map.txt:1: expected a joint of swing.bvh (its first is ");
  expect(a + " " + b + "\n" + a + " -\n", "map.txt:2: expected each joint once (the first is line 1)");
  expect("", "no joint maps to one of swing.bvh");
}

// The same mesh on a broader rig: the motion has a body of the character's mesh, so contacts work with it.
TEST_F(CliAnimate, ContactsKnowABodyOfTheSameMesh) {
  make_clip("swing");
  Character hero = read_character(kData + "/biped__robed.obj"), broad = hero;
  for (Vec3& v : broad.vertices) v = {1.4f * v.x, v.y, 1.6f * v.z};
  for (Joint& j : broad.joints) j.position = {1.4f * j.position.x, j.position.y, 1.6f * j.position.z};
  write_gltf(in("hero.glb"), hero);
  write_gltf(in("broad.glb"), broad);
  good("animate hero.glb --motion swing.bvh --method copy -o moved.glb");
  const Outcome told = good("animate broad.glb --motion moved.glb --method contacts -o kept.glb");
  EXPECT_EQ(told.out.find("has no body"), std::string::npos) << told.out;
  EXPECT_EQ(read_gltf_motion(in("kept.glb"), 20).clips[0].frames.size(), 10u);
  // The published method takes the same two bodies, and none is no answer.
  good("animate broad.glb --motion moved.glb --method reference-points -o drawn.glb");
  good(
      "animate broad.glb --motion moved.glb --method reference-points --area-power 0 --falloff 0.05 --no-own-limb "
      "--legs "
      "-o all.glb");
  good("animate broad.glb --motion moved.glb --method copy -o copy.glb");
  EXPECT_NE(slurp(in("drawn.glb")), slurp(in("copy.glb")));
  EXPECT_NE(slurp(in("drawn.glb")), slurp(in("all.glb")));
  const Outcome bodiless = good("animate broad.glb --motion swing.bvh --method reference-points -o new.glb");
  EXPECT_NE(bodiless.out.find("swing.bvh: has no body, so its reference points are on capsules"), std::string::npos)
      << bodiless.out;
  const Outcome feet = good("animate broad.glb --motion swing.bvh --method contacts -o feet.glb");
  EXPECT_NE(feet.out.find("has no body with the character's mesh"), std::string::npos) << feet.out;
}

TEST_F(CliAnimate, AStreamDoesNotLookAhead) {
  // Ten frames, a line each, of the whole walk and of its beginning.
  constexpr size_t kLines = 10;
  const auto frames = [&](const std::string& options) {
    good("animate " + kData + "/biped__robed.obj --motion builtin:walk " + options + " -o walking.bvh");
    const std::string text = slurp(in("walking.bvh"));
    const size_t begin = text.find('\n', text.find("Frame Time")) + 1;
    size_t end = begin;
    for (size_t line = 0; line < kLines; ++line) end = text.find('\n', end) + 1;
    return text.substr(begin, end - begin);
  };
  const std::string whole = frames("--method stream");
  EXPECT_EQ(frames("--method stream --end 0.3"), whole);
  EXPECT_NE(frames("--method copy"), whole);
  EXPECT_NE(frames("--method contacts --end 0.3"), frames("--method contacts"));
}

// Feet that hold still on the floor go back under a body that stays: the same poses as those of a body that travels.
TEST_F(CliAnimate, InPlaceIsTheSameMotionWithoutItsTravel) {
  for (const std::string method : {"contacts", "stream", "copy"}) {
    const std::string words = "animate " + kData + "/biped__robed.obj --motion builtin:walk --method " + method;
    good(words + " -o travels.glb");
    good(words + " --in-place -o stays.glb");
    const Motion travels = read_gltf_motion(in("travels.glb")), stays = read_gltf_motion(in("stays.glb"));
    ASSERT_EQ(travels.clips[0].frames.size(), stays.clips[0].frames.size());
    double farthest = 0, path = 0, left = 0;
    for (size_t f = 0; f < travels.clips[0].frames.size(); ++f) {
      const MotionFrame &a = travels.clips[0].frames[f], &b = stays.clips[0].frames[f];
      for (size_t j = 0; j < travels.joints.size(); ++j) {
        for (size_t c = 0; c < 4; ++c) farthest = std::max(farthest, std::abs(a.rotations[j][c] - b.rotations[j][c]));
        if (travels.joints[j].parent >= 0) continue;
        path = std::max(path, length(a.translations[j] - travels.clips[0].frames[0].translations[j]));
        left = std::max(left, std::hypot(b.translations[j][0] - stays.joints[j].offset[0],
                                         b.translations[j][2] - stays.joints[j].offset[2]));
      }
    }
    EXPECT_GT(path, 0.3) << method;
    EXPECT_LT(left, 0.1 * path) << method;
    EXPECT_LT(farthest, 1e-3) << method;
  }
}

TEST_F(CliAnimate, ArmSpreadLiftsBothArms) {
  for (const std::string method : {"contacts", "stream", "copy", "reference-points"}) {
    const std::string words = "animate " + kData + "/biped__robed.obj --motion builtin:walk --method " + method;
    double widths[3] = {};
    const char* const spreads[] = {"", " --arm-spread 25", " --arm-spread -10"};
    for (int i = 0; i < 3; ++i) {
      good(words + spreads[i] + " -o walks.glb");
      const Motion walks = read_gltf_motion(in("walks.glb"));
      for (const MotionFrame& frame : walks.clips[0].frames) {
        const WorldPose pose = world_pose(walks, frame);
        Point3 elbows[2] = {};
        for (size_t j = 0; j < walks.joints.size(); ++j) {
          if (walks.joints[j].name == "forearm.L") elbows[0] = pose.positions[j];
          if (walks.joints[j].name == "forearm.R") elbows[1] = pose.positions[j];
        }
        widths[i] += length(elbows[0] - elbows[1]);
      }
    }
    EXPECT_GT(widths[1], 1.15 * widths[0]) << method;
    EXPECT_LT(widths[2], widths[0]) << method;
  }
  EXPECT_NE(good("animate " + kSnake + " --motion builtin:swim --force --arm-spread 20 -o swims.glb")
                .out.find("the arm spread has no effect"),
            std::string::npos);
  for (const std::string degrees : {"90.5", "-91", "wide"})
    EXPECT_NE(bad(2, "animate hero.glb --motion builtin:walk --arm-spread " + degrees + " -o moved.glb")
                  .error.find("--arm-spread"),
              std::string::npos)
        << degrees;
}

TEST_F(CliAnimate, AReportSaysWhatWasMendedLimbByLimb) {
  make_clip("swing");
  Character hero = read_character(kData + "/biped__robed.obj"), broad = hero;
  for (Vec3& v : broad.vertices) v = {1.4f * v.x, v.y, 1.6f * v.z};
  for (Joint& j : broad.joints) j.position = {1.4f * j.position.x, j.position.y, 1.6f * j.position.z};
  write_gltf(in("broad.glb"), broad);
  const Outcome told = good("animate broad.glb --motion swing.bvh -o kept.glb --measure");
  EXPECT_NE(told.out.find(": in the body in "), std::string::npos) << told.out;
  EXPECT_NE(told.out.find(": under the floor in "), std::string::npos) << told.out;
  const auto json =
      nlohmann::json::parse(good("animate broad.glb --motion swing.bvh -o kept.glb --measure --json").out);
  const auto& report = json["clips"][0]["report"];
  ASSERT_EQ(report.size(), 4u) << json;
  size_t legs = 0;
  for (const auto& limb : report) {
    legs += limb["limb"] == "leg" ? 1 : 0;
    EXPECT_TRUE(limb["joint"].is_string());
    EXPECT_LE(limb["after"]["error"].get<double>(), limb["before"]["error"].get<double>() + 1e-4) << limb;
    EXPECT_GE(limb["before"]["deep_frames"].get<int>(), limb["after"]["deep_frames"].get<int>()) << limb;
  }
  EXPECT_EQ(legs, 2u);
  // What is copied is the same before and after.
  const auto copied = nlohmann::json::parse(
      good("animate broad.glb --motion swing.bvh --method copy -o copy.glb --measure --json").out);
  for (const auto& limb : copied["clips"][0]["report"]) EXPECT_EQ(limb["before"], limb["after"]);
  EXPECT_FALSE(
      nlohmann::json::parse(good("animate broad.glb --motion swing.bvh -o kept.glb --json").out)["clips"][0].contains(
          "report"));
}

TEST_F(CliAnimate, ABareMeshGetsASkeletonFirst) {
  put(in("figure.obj"), slurp(kData + "/biped__robot.obj"));
  good("rig figure.obj -o figure.glb");
  const Character rigged = read_gltf(in("figure.glb"));
  Motion motion = motion_of(rigged.joints);
  Clip clip = {"nod", 0.1, {}};
  for (int f = 0; f < 3; ++f) {
    clip.frames.push_back({std::vector<Quaternion>(motion.joints.size(), kNoRotation4), {}});
    for (const MotionJoint& joint : motion.joints) clip.frames.back().translations.push_back(joint.offset);
    clip.frames.back().translations[0][1] += 0.1 * f;
  }
  write_bvh(in("nod.bvh"), motion, clip);
  const Outcome told = good("animate figure.obj --motion nod.bvh -o moved.glb");
  EXPECT_NE(told.out.find("rigged first, " + std::to_string(rigged.joints.size())), std::string::npos) << told.out;
  EXPECT_EQ(read_gltf_motion(in("moved.glb"), 10).clips[0].frames.size(), 3u);
  EXPECT_EQ(read_gltf(in("moved.glb")).joints.size(), rigged.joints.size());
}

TEST_F(CliAnimate, MotionsOfFbxAndColladaMove) {
  put(in("move.fbx"), moving_fbx());
  put(in("moves.dae"), moving_dae());  // no mesh, Z up, two clips
  put(in("map.txt"), "root hip\nspine_1 knee\n");
  const std::string snake = "animate " + kSnake + " --map map.txt --method copy";
  good(snake + " --motion moves.dae#bend_rise -o rise.glb");
  const Motion rise = read_gltf_motion(in("rise.glb"), 10);
  ASSERT_EQ(rise.clips.size(), 1u);
  EXPECT_EQ(rise.clips[0].name, "bend_rise");   // as Assimp has it
  EXPECT_EQ(rise.clips[0].frames.size(), 21u);  // 2 s, 10 a second
  good(snake + " --motion moves.dae -o both.glb");
  EXPECT_EQ(read_gltf_motion(in("both.glb"), 10).clips.size(), 2u);
  // Its own rig: every joint moves, whatever its positions would say.
  good("bind move.fbx -o strip.glb");
  const Outcome own = good("animate strip.glb --motion move.fbx --method copy -o moved.glb");
  EXPECT_NE(own.out.find("3 of 3 joints mapped"), std::string::npos) << own.out;
  EXPECT_GT(read_gltf_motion(in("moved.glb"), 10).clips.at(0).frames.size(), 5u);
}

TEST_F(CliAnimate, WhatIsWrongIsOneLineAndLeavesFilesAsTheyWere) {
  make_clip("swing");
  const std::string hero = kData + "/biped__robed.obj";
  put(in("out.glb"), "old");
  const auto expect = [&](int status, const std::string& arguments, const char* wanted) {
    const Outcome refused = bad(status, "animate " + arguments);
    EXPECT_NE(refused.error.find(wanted), std::string::npos) << refused.error;
    EXPECT_TRUE(slurp(in("out.glb")) == "old") << arguments;
  };
  expect(1, hero + " --motion none.bvh -o out.glb", "none.bvh: no such file");
  expect(2, hero + " --motion swing.bvh -o out.dae", "does not write it");
  expect(2, hero + " --motion swing.bvh -o out.glb --method magic", "magic");
  expect(2, hero + " --motion swing.bvh -o out.glb --area-power 4", "--area-power needs --method reference-points");
  expect(2, hero + " --motion swing.bvh -o out.glb --legs", "--legs needs --method reference-points");
  expect(2, hero + " --motion swing.bvh -o out.glb --method reference-points --area-power 5", "--area-power");
  expect(2, hero + " --motion swing.bvh -o out.glb --method reference-points --falloff -1", "--falloff");
  expect(2, hero + " --motion swing.bvh -o out.glb --start 2 --end 1", "--start 2 is after --end 1");
  expect(2, hero + " --motion swing.bvh -o out.glb --sheet sheet.gif", "sheet.gif");
  expect(2, hero + " -o out.glb", "--motion");
  expect(1, hero + " --motion swing.bvh#run -o out.glb", "expected one of its clips, 'swing', found 'run'");
  expect(1, hero + " --motion swing.bvh --start 5 -o out.glb", "has no frame between");
  expect(2, hero + " --motion swing.bvh --motion swing.bvh -o two.bvh", "a BVH holds one clip");
  expect(1, hero + " --motion " + kData + "/biped__robot.obj -o out.glb", "expected a motion");
  expect(1, hero + " --motion " + kCaped + " -o out.glb", "expected an animation, found none");
  put(in("broken.fbx"), "; FBX 7.4.0 project file\nObjects:  {\n");
  expect(1, hero + " --motion broken.fbx -o out.glb", "broken.fbx");
  put(in("broken.bvh"), "HIERARCHY\nROOT a\n{\n");
  expect(1, hero + " --motion broken.bvh -o out.glb", "truncated BVH");
  Outcome refused = bad(1, "pose " + kCaped + " --animation walk -o a.png");
  EXPECT_NE(refused.error.find("expected an animation, found none"), std::string::npos) << refused.error;
  refused = bad(1, "pose " + hero + " --animation walk -o a.png");
  EXPECT_NE(refused.error.find("has no animations"), std::string::npos) << refused.error;
  bad(2, "pose " + hero + " --animation walk --random 3 -o a.png");
}

TEST_F(CliAnimate, CorrectsEveryFrameWithMorphTargets) {
  const std::string robed = kData + "/biped__robed.obj";
  put(in("nod.bvh"), nodding_bvh());
  put(in("map.txt"), nodding_map(read_character(robed)));
  const std::string call = "animate " + robed + " --motion nod.bvh --map map.txt --method copy --deform volume";
  const auto json = nlohmann::json::parse(good(call + " --json --sheet sheet.png -o out.glb").out);
  EXPECT_GT(json["clips"][0]["shapes"], 0);
  EXPECT_LE(json["clips"][0]["shapes"], 16);
  EXPECT_LT(json["clips"][0]["error"]["baked"].get<double>(), 0.2 * json["clips"][0]["error"]["linear"].get<double>());
  good("animate " + robed + " --motion nod.bvh --map map.txt --method copy --sheet plain.png -o plain.glb");
  EXPECT_NE(slurp(in("sheet.png")), slurp(in("plain.png"))) << "drawn as it is corrected";
  const auto document = json_of_glb(slurp(in("out.glb")));
  size_t weights = 0;
  for (const auto& channel : document["animations"][0]["channels"]) weights += channel["target"]["path"] == "weights";
  EXPECT_GT(weights, 0u);
  EXPECT_FALSE(document["meshes"][0].at("extras").contains("sinew_correctives")) << "only this clip has them";
  bad(2, call + " -o out.bvh");
  bad(2, "animate " + robed + " --motion nod.bvh --cells 16 -o other.glb");
}

TEST_F(CliAnimate, ClipsAloneAreOfHumanoidBones) {
  good("animate " + kRobed + " --motion builtin:walk --fps 30 -o walk.vrma");
  const nlohmann::json document = json_of_glb(slurp(in("walk.vrma")));
  const nlohmann::json bones = document["extensions"]["VRMC_vrm_animation"]["humanoid"]["humanBones"];
  for (const char* bone : {"hips", "spine", "head", "leftUpperArm", "rightLowerLeg"})
    EXPECT_TRUE(bones.contains(bone)) << bone;
  for (const nlohmann::json& channel : document["animations"][0]["channels"])
    if (channel["target"]["path"] != "rotation") {
      EXPECT_EQ(channel["target"]["path"], "translation");
      EXPECT_EQ(channel["target"]["node"], bones["hips"]["node"]);
    }
  const Motion motion = read_motion(in("walk.vrma"), 30);
  ASSERT_EQ(motion.clips.size(), 1u);
  EXPECT_GT(motion.clips[0].frames.size(), 20u);
  // A T pose: arms along the floor.
  const std::vector<Joint> rest = rest_joints(motion);
  const auto at = [&](const char* name) {
    return std::find_if(rest.begin(), rest.end(), [&](const Joint& joint) { return joint.name == name; })->position;
  };
  EXPECT_NEAR(at("leftHand").y, at("leftUpperArm").y, 1e-3);
  EXPECT_GT(at("leftHand").x, at("leftUpperArm").x + 0.2f);
  // And played on the character again, it is the walk.
  good("animate " + kRobed + " --motion walk.vrma -o again.glb");
  EXPECT_NE(bad(1, "animate " + kData + "/snake__long.obj --motion builtin:swim --force -o swim.vrma")
                .error.find("leftUpperLeg"),
            std::string::npos);
}

}  // namespace
}  // namespace sinew
