// SPDX-License-Identifier: MIT
// The sinew command on folders: bind of every file, folders below folders, names that occur twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class CliFolders : public Cli {
 protected:
  // An OBJ pair, a glTF two folders below, a hidden copy that nobody asked for and a link that leads back up.
  void make_set() {
    fs::create_directories(in("set/low/deep"));
    fs::create_directories(in("set/.hidden"));
    for (const char* file : {"snake__long.obj", "snake__long.rig.txt"}) {
      fs::copy(kData + "/" + file, in("set"));
      fs::copy(kData + "/" + file, in("set/.hidden"));
    }
    fs::copy(kCaped, in("set/low/deep"));
    fs::create_directory_symlink("..", in("set/low/up"));
  }
};

TEST_F(CliFolders, BindGoesThroughAFolder) {
  make_set();
  const Outcome one = good("bind set -o one --method heat --jobs 1");
  ASSERT_EQ(lines_of(one.out).size(), 3u) << one.out;
  EXPECT_EQ(lines_of(one.out)[0].rfind("low/deep/biped__caped.gltf: 2355 vertices, ", 0), 0u) << one.out;
  EXPECT_EQ(lines_of(one.out)[1].rfind("snake__long.obj: 850 vertices, 17 of 18 joints, ", 0), 0u) << one.out;
  EXPECT_EQ(lines_of(one.out)[2].rfind("2 files: 2 bound, 0 failed, ", 0), 0u) << one.out;
  EXPECT_EQ(one.error, "") << "no progress where no terminal is";
  expect_bound(read_character(in("one/snake__long.glb")), 4);

  // The bytes of a bind of each, whatever the number of jobs.
  good("bind set -o three --method heat --jobs 3");
  good("bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat -o alone.glb");
  EXPECT_TRUE(slurp(in("one/snake__long.glb")) == slurp(in("alone.glb")));
  for (const char* file : {"snake__long.glb", "low/deep/biped__caped.glb"})
    EXPECT_TRUE(slurp(in("one/" + std::string(file))) == slurp(in("three/" + std::string(file))));

  good("bind set -o rigs --method heat --format rig.txt");
  EXPECT_TRUE(fs::exists(in("rigs/low/deep/biped__caped.rig.txt")));
  EXPECT_FALSE(fs::exists(in("rigs/.hidden")));
}

TEST_F(CliFolders, BindGoesOnAfterAFailureAndShowsAll) {
  make_set();
  put(in("set/a_broken.obj"), "v 0 0 zero\n");
  put(in("set/low/mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome outcome = run("bind set -o out --method heat --jobs 2 --json --report page.html");
  EXPECT_EQ(outcome.status, 1);
  const std::vector<std::string> lines = lines_of(outcome.out), errors = lines_of(outcome.error);
  ASSERT_EQ(lines.size(), 4u) << outcome.out;
  std::vector<nlohmann::json> files;
  for (const std::string& line : lines) files.push_back(nlohmann::json::parse(line));
  EXPECT_EQ(files[0]["mesh"], "set/a_broken.obj");
  EXPECT_NE(files[0]["error"].get<std::string>().find("zero"), std::string::npos);
  EXPECT_EQ(files[1]["output"], "out/low/deep/biped__caped.glb");
  EXPECT_NE(files[2]["error"].get<std::string>().find("no skeleton"), std::string::npos);
  EXPECT_EQ(files[3]["vertices"], 850);
  ASSERT_EQ(errors.size(), 4u) << outcome.error;
  EXPECT_EQ(errors[0].rfind("sinew: error: set/a_broken.obj", 0), 0u) << outcome.error;
  EXPECT_EQ(errors[2].rfind("4 files: 2 bound, 2 failed, ", 0), 0u) << outcome.error;
  EXPECT_EQ(errors[3], "sinew: error: 2 of 4 files failed, see above");
  const std::string page = slurp(in("page.html"));
  EXPECT_NE(page.find("data:image/png"), std::string::npos);
  EXPECT_NE(page.find("low/deep/biped__caped.gltf"), std::string::npos);
  EXPECT_NE(page.find("found &#39;zero&#39;"), std::string::npos) << "failures are on the page";
  EXPECT_EQ(page.find("http"), std::string::npos) << "the page must need no network";
}

TEST_F(CliFolders, BindRefusesWhatWouldHarmOrMeansNothing) {
  make_set();
  for (const char* output : {"set", "set/low", "set/new", "-", "out.glb"})
    bad(2, std::string("bind set --method heat -o ") + output);
  bad(2, "bind set --method heat");
  for (const char* option : {"--png x.png", "--png-confidence x.png", "--hints x.rig.txt", "--lock x.txt"})
    bad(2, std::string("bind set -o out --method heat ") + option);
  for (const char* option : {"--jobs 2", "--report page.html", "--format glb"})
    bad(2, "bind " + kSnake + " --skeleton " + kSnakeRig + " -o out.glb " + option);
  bad(2, "bind set -o out --method heat --report page.txt");
  fs::create_directories(in("empty"));
  bad(1, "bind empty -o out --method heat");

  // Two files of one name: said before any is bound.
  fs::copy(kCaped, in("set/snake__long.gltf"));
  EXPECT_NE(bad(1, "bind set -o out --method heat").error.find("out/snake__long.glb"), std::string::npos);
  fs::remove(in("set/snake__long.gltf"));
  // An output that is a link to an input.
  good("dataset convert " + kSnake + " set/linked.glb");
  fs::create_directories(in("linked"));
  fs::create_symlink(in("set/linked.glb"), in("linked/linked.glb"));
  const std::string before = slurp(in("set/linked.glb"));
  bad(1, "bind set -o linked --method heat");
  EXPECT_TRUE(slurp(in("set/linked.glb")) == before);
  EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(CliFolders, DatasetCommandsLookBelow) {
  good("dataset synthesize --plan snake --count 2 --resolution 24 -o set/a");
  good("dataset synthesize --plan snake --count 1 --resolution 24 -o set/b");  // a second snake__0001
  const Outcome scores = good("eval set --method heat -o figures.json --save-predictions out");
  EXPECT_NE(scores.out.find("| heat | 3 |"), std::string::npos) << scores.out;
  for (const char* name : {"out/a/snake__0001.rig.txt", "out/b/snake__0001.rig.txt", "out/snake__0002.rig.txt"})
    EXPECT_TRUE(fs::exists(in(name))) << name;
  EXPECT_NE(good("eval set --method nearest --with heat=out").out.find("| heat | 3 |"), std::string::npos);
  EXPECT_NE(good("dataset stats set --no-recall --json").out.find("\"characters\": 3"), std::string::npos);
  EXPECT_EQ(lines_of(good("dataset check set").out)[0].rfind("set/a/snake__0001.obj", 0), 0u);
  good("dataset dedup set -o unique");
  EXPECT_TRUE(fs::exists(in("unique/a/snake__0001.obj")));
  EXPECT_FALSE(fs::exists(in("unique/b/snake__0001.obj"))) << "it is a copy";

  put(in("config.json"),
      R"({"steps": 2, "validate_every": 2, "variants": 0, "synthetic": 0, "field": {"width": 8, "rounds": 1}})");
  const Outcome train = good("train set --config config.json -o run.ckpt");
  EXPECT_NE(train.error.find("features: 3 of 3 samples"), std::string::npos) << train.error;
  fs::create_directories(in("set/c"));
  fs::copy(in("set/a/snake__0001.obj"), in("set/c"));
  put(in("set/c/snake__0001.rig.txt"), "joints a 0 0 0\nroot a\n");
  const Outcome bare = good("train set --config config.json -o run2.ckpt");
  EXPECT_NE(bare.error.find("left out: c/snake__0001: no vertex"), std::string::npos) << bare.error;
}

}  // namespace
}  // namespace sinew
