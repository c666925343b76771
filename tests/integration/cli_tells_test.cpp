// SPDX-License-Identifier: MIT
// What the sinew command tells beside its outputs: contents of files, what became of old weights, what to do next.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "glb_round.hpp"
#include "numpy_bytes.hpp"
#include "scene_files.hpp"
#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "vmd_bytes.hpp"

namespace sinew {
namespace {

using nlohmann::json;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class CliTells : public Cli {};

TEST_F(CliTells, WhatIsInAGltf) {
  GlbBuilder builder = two_joint_strip();
  json triangle = {{"attributes", {{"POSITION", builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}};
  const int sword = builder.add("meshes", {{"name", "sword"}, {"primitives", json::array({triangle})}});
  builder.document["nodes"][1]["children"] = {builder.add("nodes", {{"name", "hand"}, {"mesh", sword}})};
  builder.document["nodes"][1]["rotation"] = {0, 0, 0.6, 0.8};
  put(in("hero.glb"), builder.glb());
  const std::string text = good("inspect hero.glb").out;
  EXPECT_TRUE(has(text, "  strip  10 vertices, 1 primitive, skin skin_0\n")) << text;
  EXPECT_TRUE(has(text, "  sword  3 vertices, 1 primitive, no skin, attached to joint knee\n")) << text;
  EXPECT_TRUE(has(text, "rest pose is not the bind pose: 1 joints differ")) << text;
  const json told = json::parse(good("inspect hero.glb --json").out);
  EXPECT_EQ(told["kind"], "character");
  EXPECT_EQ(told["joints"][1]["name"], "knee");
  EXPECT_EQ(told["gltf"]["meshes"][1]["joint"], "knee");
  EXPECT_EQ(told["gltf"]["skins"][0]["rest_is_bind"], false);

  GlbBuilder bare;
  bare.root({{"name", "nothing"}});
  put(in("bare.glb"), bare.glb());
  EXPECT_TRUE(has(good("inspect bare.glb").out, "glTF without a mesh"));
  EXPECT_EQ(json::parse(good("inspect bare.glb --json").out)["gltf"]["nodes"], 1);
}

TEST_F(CliTells, WhatIsInAMotion) {
  const Motion walk = builtin_motions("builtin:walk").front();
  write_bvh(in("walk.bvh"), walk, walk.clips[0]);
  const std::string text = good("inspect walk.bvh").out;
  EXPECT_TRUE(has(text, "walk.bvh: motion\nclips         1\n  walk  " + std::to_string(walk.clips[0].frames.size()) +
                            " frames, 30 per second"))
      << text;
  EXPECT_TRUE(has(text, "\nup            y\nrest pose     stands, arms ")) << text;
  EXPECT_TRUE(has(text, "\njoints        ")) << text;
  const json bvh = json::parse(good("inspect walk.bvh --json").out);
  EXPECT_EQ(bvh["kind"], "motion");
  EXPECT_EQ(bvh["motion"]["up"], "y");
  EXPECT_EQ(bvh["motion"]["clips"][0]["frames"], walk.clips[0].frames.size());
  EXPECT_GE(bvh["joints"].size(), walk.joints.size());

  put(in("dance.vmd"), test::vmd_of({{"\x8d\xb6\x82\xd0\x82\xb4", 10}, {"\x83\x58\x83\x4a\x81\x5b\x83\x67", 0}}));
  const json vmd = json::parse(good("inspect dance.vmd --json").out);
  EXPECT_EQ(vmd["motion"]["notes"][0], "1 bones without a standard name were left out");
  EXPECT_EQ(vmd["motion"]["rest_pose"], "stands, arms lowered to the sides (A pose)");
  put(in("poses.npz"), test::zip_of({{"poses.npy", test::npy_of("(2, 72)", std::vector<float>(144))}}));
  EXPECT_TRUE(has(good("inspect poses.npz").out, "note          SMPL")) << "guesses are told";
#ifdef SINEW_HAS_ASSIMP
  put(in("moves.dae"), moving_dae());
  const json dae = json::parse(good("inspect moves.dae --json").out);
  EXPECT_EQ(dae["kind"], "motion");
  EXPECT_EQ(dae["motion"]["clips"].size(), 2u);
  EXPECT_TRUE(dae["motion"]["up"].is_null());
#endif
  put(in("cut.vmd"), "Vocaloid");
  EXPECT_TRUE(has(bad(1, "inspect cut.vmd").error, "cut.vmd: truncated VMD"));
}

TEST_F(CliTells, WhatIsInOtherFilesAsJson) {
  const json snake = json::parse(good("inspect " + kSnake + " --json").out);
  EXPECT_EQ(snake["vertices"], 850);
  EXPECT_EQ(snake["joints"].size(), 18u);
  EXPECT_EQ(json::parse(good("inspect " + kSnakeRig + " --json").out)["kind"], "character");
  if (fs::exists(kData + "/sinew_default.sinew")) {
    const json model = json::parse(good("inspect " + kData + "/sinew_default.sinew --json").out);
    EXPECT_EQ(model["kind"], "model");
    EXPECT_EQ(model["checksum"], json::parse(good("inspect bundled --json").out)["checksum"]);
  }
}

TEST_F(CliTells, BundledIsAModelEverywhere) {
  if (!fs::exists(kData + "/sinew_default.sinew")) GTEST_SKIP() << "this build has no bundled model";
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig;
  EXPECT_TRUE(has(good(pair + " --model bundled -o named.glb").out, "bound with bundled model"));
  good(pair + " -o unnamed.glb");
  EXPECT_TRUE(slurp(in("named.glb")) == slurp(in("unnamed.glb")));
  EXPECT_TRUE(has(good("eval " + kData + " --model bundled").out, "| bundled model | 7 |"));
}

TEST_F(CliTells, WhatBecameOfOldWeights) {
  // By heat: how far that is from the sample's own weights is for this test to find out in another way.
  const Outcome bound = good("bind " + kCaped + " --method heat -o new.glb --json --changes");
  const json replaced = json::parse(bound.out)["replaced"];
  const Character before = read_character(kCaped), after = read_character(in("new.glb"));
  double sum = 0;
  ASSERT_EQ(before.vertices.size(), 2355u);
  // The written file is welded by weights again; vertices are found by position.
  std::map<std::array<float, 3>, std::map<std::string, double>> weights;
  const auto key = [](const Vec3& p) { return std::array<float, 3>{p.x, p.y, p.z}; };
  for (size_t v = 0; v < after.vertices.size(); ++v)
    for (const Influence& i : after.influences[v])
      weights[key(after.vertices[v])][after.joints[i.joint].name] = static_cast<double>(i.weight);
  for (size_t v = 0; v < before.vertices.size(); ++v) {
    std::map<std::string, double> difference = weights.at(key(before.vertices[v]));
    for (const Influence& i : before.influences[v])
      difference[before.joints[i.joint].name] -= static_cast<double>(i.weight);
    for (const auto& [joint, value] : difference) sum += std::abs(value);
  }
  EXPECT_EQ(replaced["vertices"], 2355);
  EXPECT_NEAR(replaced["l1"].get<double>(), sum / 2355, 0.01);
  ASSERT_EQ(replaced["joints"].size(), 10u);
  EXPECT_GE(replaced["joints"][0]["l1"], replaced["joints"][1]["l1"]);

  const std::string plain = good("bind " + kCaped + " --method heat -o new.glb").out;
  EXPECT_TRUE(has(plain, "replaced the weights of 2,355 vertices (mean L1 difference 0.")) << plain;
  EXPECT_FALSE(has(plain, "  mean L1")) << plain;
  const std::string table = good("bind " + kCaped + " --method heat -o new.glb --changes").out;
  EXPECT_TRUE(has(table, "\n  joint")) << table;
  EXPECT_TRUE(has(table, "vertices  mean L1\n  " + replaced["joints"][0]["joint"].get<std::string>())) << table;

  // What hangs on a joint without a skin is not bound, so that nothing of it is replaced.
  put(in("lamp.glb"), with_parts().glb());
  EXPECT_TRUE(has(good("bind lamp.glb --method heat -o lit.glb").out, "replaced the weights of 10 vertices"));

  // A rig's weights are read for the comparison alone; locked vertices are not replaced.
  const std::string pair = "bind " + kSnake + " --skeleton " + kSnakeRig + " --method heat -o snake.glb";
  EXPECT_FALSE(has(good(pair).out, "replaced"));
  EXPECT_TRUE(has(good(pair + " --changes").out, "replaced the weights of 850 vertices"));
  put(in("lock.txt"), "0\n7\n");
  EXPECT_TRUE(has(good(pair + " --lock lock.txt").out, "replaced the weights of 848 vertices"));
  const std::string kept = good(pair + " --lock all").out;
  EXPECT_TRUE(has(kept, "kept all weights") && !has(kept, "bound with") && !has(kept, "replaced") &&
              !has(kept, "no weight"))
      << kept;
  put(in("bare.rig.txt"), "joints a 0 0 0\nroot a\n");
  EXPECT_TRUE(has(good("bind " + kSnake + " --skeleton bare.rig.txt --method heat -o bare.glb --changes").out,
                  "nothing to compare with: the file has no weights"));
}

TEST_F(CliTells, WhatToDoNext) {
  good("dataset synthesize --plan snake --count 2 --resolution 24 -o set");
  put(in("config.json"),
      R"({"steps": 2, "validate_every": 2, "variants": 0, "synthetic": 0, "field": {"width": 8, "rounds": 1}})");
  const std::string trained = good("train set --config config.json -o run.sinewckpt").out;
  EXPECT_TRUE(has(trained, "wrote run.sinewckpt: 2 steps")) << trained;
  EXPECT_TRUE(has(trained, "\nnext: sinew-lab quantize run.sinewckpt --calibrate set -o run.sinew\n")) << trained;
  const std::string made = good("quantize run.sinewckpt --calibrate set -o run.sinew").out;
  EXPECT_EQ(made.rfind("run.sinew: " + std::to_string(fs::file_size(in("run.sinew"))) + " bytes; ", 0), 0u) << made;
  EXPECT_TRUE(has(made, " of the vertices change their joint (at most ")) << made;
  EXPECT_TRUE(has(made, "\nnext: sinew-lab eval set --model run.sinew\n")) << made;
  EXPECT_EQ(good("quantize run.sinewckpt --calibrate set -o run.sinew --quiet").out, "");
}

}  // namespace
}  // namespace sinew
