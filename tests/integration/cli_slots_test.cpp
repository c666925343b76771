// SPDX-License-Identifier: MIT
// The published method from the command line: a few steps of training, a skeleton, figures, and what is refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

class CliSlots : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    fs::create_directories(in("set"));
    for (const char* name : {"biped__robot", "quadruped__tailed"})
      for (const char* end : {".obj", ".rig.txt"}) fs::copy(kData + "/" + name + end, in("set"));
    put(in("slots.json"),
        R"({"architecture": "slots", "width": 8, "variants": 1, "synthetic": 0, "batch": 4, "steps": 60,
            "validate_every": 30, "average_decay": 0.9})");
  }
  std::string train(const std::string& more) {
    return "train set --task rig --config slots.json --threads 1 -o slots.ckpt " + more;
  }
};

TEST_F(CliSlots, TrainsRigsAndIsMeasured) {
  const std::string said = good(train("--release alone.ckpt")).out;
  EXPECT_NE(said.find("next: sinew-lab quantize slots.ckpt"), std::string::npos) << said;
  const std::string layers = good("quantize alone.ckpt --calibrate set -o slots.sinew").out;
  EXPECT_NE(layers.find("beside the float network joints move by"), std::string::npos) << layers;
  EXPECT_LT(fs::file_size(in("alone.ckpt")) * 3, fs::file_size(in("slots.ckpt")));
  const std::string log = slurp(in("slots.ckpt.csv"));
  EXPECT_EQ(log.rfind("step,seconds,total,joints,connections,distance,presence,", 0), 0u) << log;

  fs::copy(in("set/biped__robot.obj"), in("figure.obj"));
  const auto told = nlohmann::json::parse(
      good("rig figure.obj --method slots --model slots.sinew --no-bind -o figure.rig.txt --json").out);
  ASSERT_GE(told["joints"].size(), 3u);
  EXPECT_EQ(told["joints"][0]["parent"], "");
  EXPECT_EQ(told["symmetric"], false);
  Character skeleton;
  read_skeleton(in("figure.rig.txt"), false, &skeleton);
  EXPECT_EQ(skeleton.joints.size(), told["joints"].size());

  // Display, edits and the bind are those of any skeleton.
  const std::string root = told["joints"][0]["name"];
  good("rig figure.obj --method slots --model slots.sinew --class biped --move " + root +
       "=0.25,0.5,0 -o figure.glb --png figure.png");
  EXPECT_GT(fs::file_size(in("figure.png")), 1000u);
  const Character bound = read_gltf(in("figure.glb"));
  expect_bound(bound, 4);
  EXPECT_FLOAT_EQ(bound.joints[0].position.x, 0.25f);

  const std::string table = good("eval rig set --method slots --model slots.sinew").out;
  EXPECT_NE(table.find("| mean of families | 2 |"), std::string::npos) << table;
  good("rig set --method slots --model slots.sinew -o predicted --format rig.txt --no-bind");
  EXPECT_EQ(good("eval rig set --predictions predicted").out, table);
  EXPECT_NE(good("eval rig set --method votes").out, table);
}

TEST_F(CliSlots, AnotherConfigurationIsRefusedAndLeavesTheRunAlone) {
  good(train("--quiet"));
  const std::string whole = slurp(in("slots.ckpt.csv"));
  const Checkpoint first = read_checkpoint(in("slots.ckpt"));
  put(in("other.json"), R"({"architecture": "slots", "width": 8, "balance": 0.5})");
  EXPECT_NE(bad(1, "train set --task rig --config other.json -o slots.ckpt --resume").error.find("configuration"),
            std::string::npos);
  put(in("votes.json"), R"({"variants": 0, "synthetic": 0, "steps": 1})");
  EXPECT_NE(bad(1, "train set --task rig --config votes.json -o v.ckpt --init slots.ckpt").error.find("slots"),
            std::string::npos);
  const Checkpoint after = read_checkpoint(in("slots.ckpt"));
  EXPECT_EQ(after.network.parameters[0].weights, first.network.parameters[0].weights)
      << "what was refused left it alone";
  EXPECT_EQ(slurp(in("slots.ckpt.csv")), whole);
}

TEST_F(CliSlots, TrainingStopsWhenTheTotalNoLongerFalls) {
  put(in("slots.json"),
      R"({"architecture": "slots", "width": 8, "variants": 0, "synthetic": 0, "batch": 1, "steps": 400,
          "validate_every": 5, "learning_rate": 1e-12, "patience": 2})");
  const Outcome run = good(train("--val set"));
  EXPECT_NE(run.error.find("total has stopped falling (patience 2): stopped at step 15"), std::string::npos)
      << run.error;
  const std::string log = slurp(in("slots.ckpt.csv"));
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 4) << log;
  EXPECT_NE(good(train("--val set --resume")).error.find("has stopped falling"), std::string::npos);
  EXPECT_EQ(slurp(in("slots.ckpt.csv")), log);
}

TEST_F(CliSlots, TrainingStopsBelowAPresetTotal) {
  put(in("slots.json"),
      R"({"architecture": "slots", "width": 8, "variants": 0, "synthetic": 0, "batch": 1, "steps": 400,
          "validate_every": 5, "stop_below": 100})");
  const Outcome run = good(train("--val set"));
  EXPECT_NE(run.error.find("is below 100 (stop_below): stopped at step 5"), std::string::npos) << run.error;
  put(in("slots.json"), R"({"architecture": "slots", "stop_below": -1})");
  EXPECT_NE(bad(1, train("--val set")).error.find("stop_below: expected 0 (off) or more"), std::string::npos);
}

TEST_F(CliSlots, WrongUsage) {
  const std::string rig = "rig set/biped__robot.obj --method slots ";
  EXPECT_NE(bad(2, rig + "--model x.sinew --spine 3").error.find("--spine needs another method than"),
            std::string::npos);
  EXPECT_NE(bad(2, rig + "--model x.sinew --class crab").error.find("--class"), std::string::npos);
  EXPECT_NE(bad(2, "rig set/biped__robot.obj --method shape --class biped").error.find("--class steers"),
            std::string::npos);
  EXPECT_NE(bad(1, rig + "--model x.sinew").error.find("x.sinew"), std::string::npos);
  for (const char* other : {"sinew_default", "sinew_rig", "sinew_hands"})
    EXPECT_NE(bad(1, rig + "--model " + kData + "/" + other + ".sinew").error.find(other), std::string::npos);
  bad(2, "eval set --method slots");
  EXPECT_NE(bad(2, "eval rig set --method slots --predictions set").error.find("--predictions and --method"),
            std::string::npos);
  put(in("bad.json"), R"({"architecture": "slots", "balance": 2})");
  EXPECT_NE(bad(1, "train set --task rig --config bad.json -o b.ckpt").error.find("balance: expected 0 to 1"),
            std::string::npos);
  put(in("bad.json"), R"({"architecture": "slots", "losses": "mine"})");
  EXPECT_NE(bad(1, "train set --task rig --config bad.json -o b.ckpt").error.find("losses: expected"),
            std::string::npos);
  good(train("--quiet --steps 1"));
  EXPECT_NE(bad(1, rig + "--model slots.ckpt").error.find("slots.ckpt"), std::string::npos);
  EXPECT_NE(bad(2, train("--release slots.ckpt")).error.find("--release"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("set/biped__robot.rigged.glb")));
}

TEST_F(CliSlots, AMeshThatIsNoBodyIsTold) {
  const std::string warning = "warning: this mesh is unlike";
  put(in("point.obj"), "v 0 0 0\n");
  put(in("sheet.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put(in("cube.obj"),
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n");
  const auto told = [&](const std::string& mesh) {
    return good("rig " + mesh + " --method slots --no-bind -o out.rig.txt").out.find(warning) != std::string::npos;
  };
  for (const char* mesh : {"point.obj", "sheet.obj", "cube.obj"}) EXPECT_TRUE(told(mesh)) << mesh;
  for (const char* mesh : {"biped__robed", "biped__robot", "quadruped__tailed"})
    EXPECT_FALSE(told(kData + "/" + mesh + ".obj")) << mesh;
}

}  // namespace
}  // namespace sinew
