// SPDX-License-Identifier: MIT
// sinew map: maps as text and JSON, edited maps given back, pins, presets, and every wrong way to ask.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli_fixture.hpp"

namespace sinew {
namespace {

using Json = nlohmann::json;

const std::string kRobotRig = kData + "/biped__robot.rig.txt";

class CliMap : public Cli {
 protected:
  // A rig.txt of three joints.
  void make_chain(const std::string& file, const std::string& prefix) {
    std::string text;
    for (int i = 0; i < 3; ++i) text += "joints " + prefix + std::to_string(i) + " 0 " + std::to_string(i) + " 0\n";
    text += "root " + prefix + "0\n";
    for (int i = 1; i < 3; ++i)
      text += "hier " + prefix + std::to_string(i - 1) + " " + prefix + std::to_string(i) + "\n";
    put(in(file), text);
  }
  static size_t lines(const std::string& text) {
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(CliMap, ALineForEveryJointAndTheSameAsJson) {
  const Outcome text = good("map " + kRobedRig + " --from " + kRobotRig);
  const Json json = Json::parse(good("map " + kRobedRig + " --from " + kRobotRig + " --json").out);
  EXPECT_EQ(lines(text.out), json["joints"].size());
  EXPECT_NE(text.error.find("joints from"), std::string::npos) << "the summary goes beside the map";
  std::istringstream words(text.out);
  size_t mapped = 0;
  for (const Json& one : json["joints"]) {
    std::string target, source;
    words >> target >> source;
    EXPECT_EQ(target, one["target"]);
    if (source == "-") {
      EXPECT_TRUE(one["source"].is_null());
      EXPECT_FALSE(one["reason"].get<std::string>().empty());
    } else {
      ++mapped;
      EXPECT_EQ(source, one["source"]);
      EXPECT_GT(one["confidence"].get<double>(), 0);
    }
  }
  EXPECT_EQ(json["mapped"], mapped);
  EXPECT_GT(mapped, json["joints"].size() / 2);
  EXPECT_EQ(json["method"], "sinew");
}

TEST_F(CliMap, AnEditedMapIsKept) {
  const Outcome wrote = good("map " + kRobedRig + " --from " + kRobotRig + " -o a.map");
  EXPECT_NE(wrote.out.find("wrote a.map"), std::string::npos);
  const std::string before = slurp(in("a.map"));
  good("map " + kRobedRig + " --from " + kRobotRig + " --map a.map -o b.map");
  EXPECT_EQ(slurp(in("b.map")), before);
  // Another source for one joint, none for a second, a third is free.
  make_chain("t.rig.txt", "t");
  make_chain("s.rig.txt", "s");
  put(in("edited.map"), "# mine\nt1 s2  # the top\n");
  const std::string text = good("map t.rig.txt --from s.rig.txt --map edited.map").out;
  EXPECT_NE(text.find("t1 s2\n"), std::string::npos) << text;
  EXPECT_NE(text.find("t0 s0\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("t2 s2"), std::string::npos) << text;
  EXPECT_NE(good("map t.rig.txt --from s.rig.txt --map edited.map --set t1=s1").out.find("t1 s1\n"), std::string::npos);
  EXPECT_NE(good("map t.rig.txt --from s.rig.txt --set t1=-").out.find("t1 -\n"), std::string::npos);
  EXPECT_NE(good("map t.rig.txt --from s.rig.txt --set t1=- --json").out.find("as asked"), std::string::npos);
}

TEST_F(CliMap, FilesOfOtherKindsAndPresets) {
  EXPECT_GT(lines(good("map " + kCaped + " --from " + kRobedRig).out), 10u);
  EXPECT_NE(good("map " + kRobedRig + " --to mixamo").out.find("mixamorig:"), std::string::npos);
  EXPECT_EQ(good("map template:unreal --from template:unreal").out.find(" -\n"), std::string::npos);
  for (const char* method : {"auto", "sinew", "branches"})
    EXPECT_GT(lines(good("map " + kRobedRig + " --from " + kRobotRig + " --no-names --up auto --method " + method).out),
              10u);
  for (const char* option : {"--cost mean", "--cost sum", "--first both", "--first target", "--first source"})
    EXPECT_GT(lines(good("map " + kRobedRig + " --from " + kRobotRig + " --method branches " + option).out), 10u);
  EXPECT_NE(bad(2, "map " + kRobedRig + " --from " + kRobotRig + " --cost sum").error.find("--method branches"),
            std::string::npos);
  bad(2, "map " + kRobedRig + " --from " + kRobotRig + " --method branches --first none");
  put(in("ends.tsv"), "biped__robed\tno such\n");
  EXPECT_NE(bad(1, "map " + kRobedRig + " --from " + kRobotRig + " --ends ends.tsv")
                .error.find("ends.tsv:1: expected a joint"),
            std::string::npos);
  good("map " + kRobedRig + " --from " + kRobotRig + " -o out.json");
  EXPECT_TRUE(Json::parse(slurp(in("out.json"))).contains("certainty"));
}

TEST_F(CliMap, MotionsAreReadAsAnimateReadsThem) {
  const Json json = Json::parse(good("map " + kRobed + " --from builtin:walk --json").out);
  EXPECT_GE(json["cover"].get<double>(), 0.5);
  const Outcome misfit = good("map " + kRobed + " --from builtin:quadruped/walk");
  EXPECT_NE(misfit.error.find("sinew animate refuses it without --force"), std::string::npos) << misfit.error;
  EXPECT_NE(bad(1, "map " + kRobed + " --from builtin:walk --layout smpl24").error.find("leave it out"),
            std::string::npos);
  EXPECT_NE(bad(1, "animate " + kData + "/biped__robot.obj --motion builtin:walk --layout smpl24 -o a.glb")
                .error.find("leave it out"),
            std::string::npos);
  EXPECT_NE(bad(1, "map " + kRobed + " --from builtin:wave --actor eve").error.find("'eve'"), std::string::npos);
}

TEST_F(CliMap, WrongUsageIsOneLine) {
  make_chain("t.rig.txt", "t");
  make_chain("s.rig.txt", "s");
  const std::string pair = "map t.rig.txt --from s.rig.txt ";
  EXPECT_NE(bad(2, "map t.rig.txt").error.find("--from"), std::string::npos);
  EXPECT_NE(bad(2, pair + "--to vrm").error.find("--from"), std::string::npos);
  EXPECT_NE(bad(2, "map t.rig.txt --to nonsense").error.find("mixamo"), std::string::npos);
  EXPECT_NE(bad(2, pair + "--set t9=s1").error.find("expected a joint of t.rig.txt (its first is t0), found 't9'"),
            std::string::npos);
  EXPECT_NE(bad(2, pair + "--set t1=x").error.find("expected a joint of s.rig.txt"), std::string::npos);
  EXPECT_NE(bad(2, pair + "--set t1").error.find("TARGET_JOINT=SOURCE_JOINT"), std::string::npos);
  EXPECT_NE(bad(2, pair + "--set t1=s1 --set t1=s2").error.find("each joint once"), std::string::npos);
  EXPECT_NE(bad(2, pair + "-o map.png").error.find(".map"), std::string::npos);
  bad(2, pair + "--method nearest");
  EXPECT_NE(bad(1, "map missing.rig.txt --from s.rig.txt").error.find("missing.rig.txt"), std::string::npos);
  EXPECT_NE(bad(1, "map t.rig.txt --from s.bvh2").error.find("s.bvh2"), std::string::npos);
  put(in("bad.map"), "t0 s0\nt1\n");
  EXPECT_NE(bad(1, pair + "--map bad.map -o keep.map").error.find("bad.map:2: expected 'TARGET_JOINT SOURCE_JOINT'"),
            std::string::npos);
  put(in("bad.map"), "t0 s0\nt9 s1\n");
  EXPECT_NE(bad(1, pair + "--map bad.map").error.find("bad.map:2: expected a joint of t.rig.txt"), std::string::npos);
  put(in("bad.map"), "t0 s0\nt0 s1\n");
  EXPECT_NE(bad(1, pair + "--map bad.map").error.find("bad.map:2: expected each joint once (the first is line 1)"),
            std::string::npos);
  put(in("bad.map"), "t0 s0\nt1 s0\n");
  EXPECT_NE(bad(1, pair + "--map bad.map").error.find("bad.map:2: expected each joint once"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("keep.map")));
}

TEST_F(CliMap, AsDrawnIsTheSumOfCostsWithoutNames) {
  good("map " + kRobedRig + " --from " + kRobotRig + " --as-drawn -o drawn.txt");
  good("map " + kRobedRig + " --from " + kRobotRig + " --method branches --cost sum --no-names -o sum.txt");
  EXPECT_EQ(slurp(in("drawn.txt")), slurp(in("sum.txt")));
  bad(2, "map " + kRobedRig + " --from " + kRobotRig + " --as-drawn --method sinew -o drawn.txt");
}

TEST_F(CliMap, APictureOfBoth) {
  good("map " + kRobedRig + " --from " + kRobotRig + " --up z --png map.png -o map.txt");
  const std::string png = slurp(in("map.png"));
  ASSERT_GT(png.size(), 1000u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  make_chain("t.rig.txt", "t");
  good("map t.rig.txt --from t.rig.txt --png one.png");  // no width at all
  EXPECT_NE(bad(2, "map t.rig.txt --from t.rig.txt --png one.jpg").error.find(".png"), std::string::npos);
}

TEST_F(CliMap, LeavesWithoutWeightAreEnds) {
  make_chain("s.rig.txt", "s");
  put(in("t.rig.txt"), slurp(in("s.rig.txt")) + "skin 0 s0 1\nskin 1 s1 1\n");
  const Json json = Json::parse(good("map t.rig.txt --from s.rig.txt --no-names --json").out);
  EXPECT_EQ(json["joints"][2]["target"], "s2");
  const Json blind = Json::parse(good("map t.rig.txt --from s.rig.txt --no-names --ends none --json").out);
  EXPECT_NE(json["joints"][2]["confidence"], blind["joints"][2]["confidence"]);
}

}  // namespace
}  // namespace sinew
