// SPDX-License-Identifier: MIT
// sinew-lab dataset convert: a studio's folder of files of other programs becomes a training set.
#include "cli_fixture.hpp"
#include "scene_files.hpp"

namespace sinew {
namespace {

class CliConvert : public Cli {
 protected:
  // Folders as a studio has them.
  void SetUp() override {
    Cli::SetUp();
    fs::create_directories(folder_ / "studio" / "orcs" / "young");
    fs::create_directories(folder_ / "studio" / "elves");
    put(folder_ / "studio" / "orcs" / "strip.fbx", strip_fbx());
    put(folder_ / "studio" / "orcs" / "young" / "small.x", strip_x());
    put(folder_ / "studio" / "elves" / "tall.dae", strip_dae());
    put(folder_ / "studio" / "elves" / "thin.md5mesh", strip_md5mesh());
    put(folder_ / "studio" / "elves" / "strip.mesh.xml", strip_mesh_xml());
    put(folder_ / "studio" / "elves" / "strip.skeleton.xml", strip_skeleton_xml());
    put(folder_ / "studio" / "dwarf__low.smd", strip_smd());
    put(folder_ / "studio" / "elves" / "far.b3d", strip_b3d());
    put(folder_ / "studio" / "plain.ms3d", strip_ms3d());
  }
};

#ifdef SINEW_HAS_ASSIMP

TEST_F(CliConvert, AFolderOfOtherProgramsBecomesATrainingSet) {
  const Outcome told = good("dataset convert studio -o set");
  EXPECT_NE(told.out.find("set/orcs__strip.obj: "), std::string::npos) << told.out;
  for (const std::string name : {"orcs__strip", "orcs_young__small", "elves__tall", "elves__thin", "elves__strip",
                                 "elves__far", "dwarf__low", "plain"}) {
    ASSERT_TRUE(fs::exists(folder_ / "set" / (name + ".obj"))) << name;
    const Character c = read_character((folder_ / "set" / (name + ".obj")).string());
    ASSERT_EQ(c.joints.size(), 3u) << name;
    EXPECT_EQ(c.joints[1].name, "knee");
    EXPECT_NEAR(c.joints[2].position.y, 4, 1e-4) << name;
    EXPECT_GE(c.vertices.size(), 10u);
    expect_bound(c, 2);
  }
  // What the data set's other commands see.
  const std::string stats = good("dataset stats set --no-recall").out;
  for (const char* family : {"orcs", "elves", "dwarf"}) EXPECT_NE(stats.find(family), std::string::npos) << stats;
  good("dataset convert studio -o whole --format glb");
  EXPECT_EQ(read_character((folder_ / "whole" / "elves__thin.glb").string()).joints.size(), 3u);
}

TEST_F(CliConvert, WhatFailsIsOneLineAndTheOthersGoOn) {
  put(folder_ / "studio" / "elves" / "broken.x", "xof 0303txt 0032\nFrame {");
  put(folder_ / "studio" / "bare.glb", "rubbish");
  const Outcome outcome = run("dataset convert studio -o set");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("broken.x: expected DirectX, found"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("2 of 10 characters failed"), std::string::npos) << outcome.error;
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 3) << outcome.error;
  EXPECT_TRUE(fs::exists(folder_ / "set" / "elves__thin.rig.txt"));
}

TEST_F(CliConvert, BindReadsThemToo) {
  for (const std::string file :
       {"orcs/young/small.x", "elves/thin.md5mesh", "elves/strip.mesh.xml", "dwarf__low.smd"}) {
    good("bind studio/" + file + " --method heat -o bound.glb");
    expect_bound(read_character(in("bound.glb")), 4);
    EXPECT_NE(good("inspect studio/" + file).out.find("joints        3"), std::string::npos) << file;
  }
}

#endif

TEST_F(CliConvert, WrongCallsSayWhatIsWrong) {
  put(folder_ / "studio" / "orcs" / "strip.dae", strip_dae());
  EXPECT_NE(bad(1, "dataset convert studio -o set").error.find("would both become set/orcs__strip.obj"),
            std::string::npos);
  EXPECT_NE(bad(2, "dataset convert studio -o studio/set").error.find("lies inside studio"), std::string::npos);
  EXPECT_NE(bad(2, "dataset convert studio -o studio").error.find("lies inside studio"), std::string::npos);
  EXPECT_NE(bad(2, "dataset convert studio -o set --skeleton x.rig.txt").error.find("--skeleton"), std::string::npos);
  EXPECT_NE(bad(2, "dataset convert " + kSnake + " o.glb --format glb").error.find("--format"), std::string::npos);
  EXPECT_NE(bad(2, "dataset convert " + kSnake + " o.md5mesh").error.find("does not write it"), std::string::npos);
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace sinew
