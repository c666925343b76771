// SPDX-License-Identifier: MIT
// The sinew command on skeletons: targets of characters, and predictions against them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

class CliRig : public Cli {
 protected:
  // Two pairs, one of them a folder below.
  void make_set() {
    fs::create_directories(in("set/low"));
    for (const char* end : {".obj", ".rig.txt"}) {
      fs::copy(kData + "/snake__long" + end, in("set"));
      fs::copy(kData + "/biped__robed" + end, in("set/low"));
    }
  }
};

// What has z up keeps its numbers in an OBJ, and stands in every format that has y up, its motion too.
TEST_F(CliRig, WhatHasZUpStandsInFormatsWithYUp) {
  Character lying = read_mesh(kData + "/biped__robed.obj");
  const float height = box_of(lying.vertices).high.y - box_of(lying.vertices).low.y;
  for (Vec3& v : lying.vertices) v = {v.x, -v.z, v.y};
  lying.corner_normals.clear();
  write_obj(in("z.obj"), lying);
  const auto size = [&](const char* file) {
    const Box box = box_of(read_mesh(in(file)).vertices);
    return box.high.y - box.low.y;
  };
  for (const char* file : {"z.glb", "z.gltf", "z.fbx"}) {
    good(std::string("rig z.obj --up z -o ") + file);
    EXPECT_NEAR(size(file), height, 1e-3f * height) << file;
  }
  good("rig z.obj --up z --no-bind -o same.rig.txt");
  Character same;
  read_skeleton(in("same.rig.txt"), false, &same);
  EXPECT_GT(same.joints[0].position.z, 0.4f * height) << "hips, in the mesh's own axes";
  good("animate z.obj --up z --motion builtin:walk -o walk.glb");
  const Motion walk = read_motion(in("walk.glb"));
  const Character walking = read_character(in("walk.glb"));
  EXPECT_NEAR(size("walk.glb"), height, 1e-3f * height);
  double least = 1e9, most = -1e9;  // of the hips, over time
  for (const MotionFrame& frame : walk.clips[0].frames) {
    const std::vector<Affine> palette = motion_palette(walk, frame, walking.joints.size());
    size_t hips = 0;
    while (walking.joints[hips].name != "Hips") ++hips;
    const Vec3& p = walking.joints[hips].position;
    const double y = transform_point(palette[hips], double{p.x}, double{p.y}, double{p.z})[1];
    least = std::min(least, y);
    most = std::max(most, y);
  }
  EXPECT_GT(least, 0.4 * double{height} + double{box_of(walking.vertices).low.y});
  EXPECT_LT(most - least, 0.2 * double{height}) << "it walks along the floor";
}

// A box of six faces that hang together with nothing else.
void add_box(const Vec3& low, const Vec3& high, Character* mesh) {
  Box box;
  box.low = low;
  box.high = high;
  const uint32_t first = static_cast<uint32_t>(mesh->vertices.size());
  for (const Vec3& corner : box.corners()) mesh->vertices.push_back(corner);
  for (const auto& face : std::vector<std::array<uint32_t, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    for (const uint32_t corner : face) mesh->face_vertices.push_back(first + corner);
    mesh->face_offsets.push_back(static_cast<uint32_t>(mesh->face_vertices.size()));
  }
}

// A puppet cut from cardboard stands, whichever axis is up in its file, and has the joints of its outline.
TEST_F(CliRig, ASheetStands) {
  Character puppet;
  puppet.name = "puppet";
  add_box({-.2f, .4f, 0}, {.2f, 1, .02f}, &puppet);
  add_box({-.15f, 1, 0}, {.15f, 1.3f, .02f}, &puppet);
  for (const float side : {-1.0f, 1.0f}) {
    add_box({side * .3f - .1f, .8f, 0}, {side * .3f + .1f, .95f, .02f}, &puppet);
    add_box({side * .1f - .05f, 0, 0}, {side * .1f + .05f, .4f, .02f}, &puppet);
  }
  write_obj(in("puppet.obj"), puppet);
  for (Vec3& v : puppet.vertices) v = {v.x, -v.z, v.y};
  write_obj(in("lying.obj"), puppet);
  for (const auto& [file, up] : {std::pair("puppet", "y"), std::pair("lying", "z")}) {
    const auto made =
        nlohmann::json::parse(good(std::string("rig ") + file + ".obj --no-bind --json -o made.rig.txt").out);
    EXPECT_EQ(made["up"], up);
    EXPECT_EQ(made["front"][up == std::string("y") ? 2 : 1], up == std::string("y") ? 1 : -1);
    std::map<std::string, std::array<double, 3>> joints;
    for (const auto& joint : made["joints"]) joints[joint["name"]] = joint["position"];
    const size_t height = up == std::string("y") ? 1 : 2;
    for (const char* const wanted : {"Head", "LeftArm", "RightArm", "LeftUpLeg", "RightUpLeg"})
      ASSERT_EQ(joints.count(wanted), 1u) << wanted << " " << file;
    EXPECT_GT(joints["LeftArm"][0], joints["RightArm"][0]);
    EXPECT_GT(joints["Head"][height], joints["LeftUpLeg"][height]);
    for (const auto& [name, p] : joints)
      EXPECT_LT(std::abs(p[3 - height]), 0.03) << name << " lies in the sheet: " << file;
  }
}

TEST_F(CliRig, AVehicleHasJointsForItsWheels) {
  Character cart;
  cart.name = "cart";
  add_box({-.5f, .3f, -1}, {.5f, .8f, 1}, &cart);
  for (const float x : {-.6f, .6f}) {
    for (const float z : {-.7f, .7f}) {
      const auto first = static_cast<uint32_t>(cart.vertices.size());
      for (const float side : {-.08f, .08f})
        for (int i = 0; i < 12; ++i)
          cart.vertices.push_back({x + side, .3f + .3f * std::sin(.5236f * static_cast<float>(i)),
                                   z + .3f * std::cos(.5236f * static_cast<float>(i))});
      for (uint32_t i = 0; i < 12; ++i) {
        const uint32_t next = (i + 1) % 12;
        for (const uint32_t corner : {i, next, 12 + next, 12 + i}) cart.face_vertices.push_back(first + corner);
        cart.face_offsets.push_back(static_cast<uint32_t>(cart.face_vertices.size()));
      }
    }
  }
  write_obj(in("cart.obj"), cart);
  const Outcome told = good("rig cart.obj --class vehicle -o cart.glb");
  EXPECT_NE(told.out.find("a vehicle of 4 moving parts"), std::string::npos) << told.out;
  const Character made = read_character(in("cart.glb"));
  ASSERT_EQ(made.joints.size(), 5u);
  for (const auto& row : made.influences) EXPECT_EQ(row.size(), 1u) << "parts move as wholes";
  EXPECT_NE(bad(1, "rig cart.obj --class vehicle --method votes -o other.glb").error.find("leave out the method"),
            std::string::npos);
}

// A dog of boxes that only touch: votes know little of it.
TEST_F(CliRig, ABodyOfSolidPartsHasAJointForEachThatMoves) {
  Character dog;
  dog.name = "boxes";
  const auto add = [&](const Vec3& middle, const Vec3& half) {
    add_box({middle.x - half.x, middle.y - half.y, middle.z - half.z},
            {middle.x + half.x, middle.y + half.y, middle.z + half.z}, &dog);
  };
  add({0, 0.5f, 0}, {0.3f, 0.3f, 0.45f});
  for (const float x : {-0.24f, 0.24f})
    for (const float z : {-0.35f, 0.35f}) add({x, 0.1f, z}, {0.05f, 0.1f, 0.05f});
  add({0, 0.5f, 0.6f}, {0.1f, 0.1f, 0.15f});
  add({0, 0.55f, -0.6f}, {0.06f, 0.06f, 0.15f});
  write_obj(in("boxes.obj"), dog);
  const Outcome told = good("rig boxes.obj --up y --front +z -o boxes.glb");
  ASSERT_NE(told.out.find("taken as a body of solid parts, a guess: 7 joints"), std::string::npos) << told.out;
  const Character made = read_character(in("boxes.glb"));
  std::map<std::string, Vec3> at;
  for (const Joint& joint : made.joints) at[joint.name] = joint.position;
  for (const char* name : {"Hips", "Head", "Tail", "LeftArm", "RightArm", "LeftUpLeg", "RightUpLeg"})
    EXPECT_EQ(at.count(name), 1u) << name;
  EXPECT_NEAR(at["LeftArm"].x, 0.24f, 1e-3f);
  EXPECT_NEAR(at["LeftArm"].y, 0.2f, 1e-3f) << "where both boxes touch";
  EXPECT_NEAR(at["LeftArm"].z, 0.35f, 1e-3f);
  EXPECT_NEAR(at["Tail"].z, -0.45f, 1e-3f);
  for (size_t v = 0; v < made.vertices.size(); ++v) {
    ASSERT_EQ(made.influences[v].size(), 1u) << "solid";
    if (made.vertices[v].z > -0.46f) continue;
    EXPECT_EQ(made.joints[made.influences[v][0].joint].name, "Tail");
  }
}

// A slab under the feet, many times as large as the body, and a wall behind it.
TEST_F(CliRig, GroundAndBackdropAreNoPartOfTheBody) {
  const Character body = read_mesh(kData + "/quadruped__tailed.obj");
  const Box box = box_of(body.vertices);
  const float size = box.high.y - box.low.y;
  const auto with_box = [&](const char* file, const Vec3& low, const Vec3& high) {
    Character whole = body;
    whole.corner_normals.clear();
    whole.corner_uvs.clear();
    add_box(low, high, &whole);
    whole.face_groups.clear();
    whole.face_materials.clear();
    whole.face_objects.clear();
    write_obj(in(file), whole);
  };
  with_box("slab.obj", {-9 * size, box.low.y - size, -9 * size}, {9 * size, box.low.y, 9 * size});
  with_box("wall.obj", {-9 * size, box.low.y, box.low.z - size}, {9 * size, 9 * size, box.low.z});
  for (const char* file : {"slab.obj", "wall.obj"}) {
    const Outcome told = good(std::string("rig ") + file + " -o rigged.glb");
    EXPECT_NE(told.out.find("taken as ground, a pedestal or a backdrop, a guess: 8 of"), std::string::npos) << told.out;
    const Character made = read_character(in("rigged.glb"));
    for (const Joint& joint : made.joints) {
      EXPECT_GT(joint.position.y, box.low.y - 0.1f * size) << file << ' ' << joint.name;
      EXPECT_LT(joint.position.y, box.high.y + 0.1f * size) << file << ' ' << joint.name;
    }
    for (size_t v = 0; v < made.vertices.size(); ++v) {
      if (std::abs(made.vertices[v].x) < 8 * size) continue;
      ASSERT_EQ(made.influences[v].size(), 1u) << file;
      EXPECT_LT(made.joints[made.influences[v][0].joint].parent, 0) << file;
    }
  }
}

TEST_F(CliRig, TargetsOfAFolderAreWhatEvalComparesWith) {
  make_set();
  const Outcome made = good("dataset target set -o targets");
  EXPECT_NE(made.out.find("snake__long.rig.txt: "), std::string::npos) << made.out;
  EXPECT_TRUE(fs::exists(in("targets/biped__robed.rig.txt"))) << "by the name that eval knows it by";
  Character target;
  read_skeleton(in("targets/snake__long.rig.txt"), false, &target);
  EXPECT_GT(target.joints.size(), 3u);
  EXPECT_EQ(slurp(in("targets/snake__long.rig.txt")).find("skin"), std::string::npos);
  EXPECT_NE(slurp(in("targets/snake__long.rig.txt")).find("_end"), std::string::npos);

  const Outcome table = good("eval rig set --predictions targets -o figures.json");
  EXPECT_NE(table.out.find("| mean of families | 2 | 0.00 | 0.00 | 0.00 | 100.00 | 100.00 | 100.00 | 100.00 |"),
            std::string::npos)
      << table.out;
  const auto figures = nlohmann::json::parse(slurp(in("figures.json")));
  EXPECT_LT(figures["characters_mean"]["J2J"], 1e-6);
  EXPECT_EQ(figures["families"]["snake"]["IoU"], 1);
  EXPECT_EQ(figures["failed"], nlohmann::json::array());
  EXPECT_EQ(nlohmann::json::parse(good("eval rig set --predictions targets --json").out), figures);
}

TEST_F(CliRig, AMissingPredictionIsNamedAndTheOthersAreMeasured) {
  make_set();
  good("dataset target set/snake__long.rig.txt -o targets");
  const Outcome missing = bad(1, "eval rig set --predictions targets -o figures.json --jobs 1");
  EXPECT_NE(missing.error.find("1 of 2 characters failed; the first: biped__robed: targets/biped__robed.rig.txt"),
            std::string::npos)
      << missing.error;
  EXPECT_NE(missing.out.find("failed 1: biped__robed"), std::string::npos) << missing.out;
  EXPECT_NE(missing.out.find("| mean of characters | 1 |"), std::string::npos) << missing.out;
  EXPECT_EQ(nlohmann::json::parse(slurp(in("figures.json")))["failed"], nlohmann::json::array({"biped__robed"}));
  put(in("targets/biped__robed.rig.txt"), "joints a 0 0\n");
  EXPECT_NE(bad(1, "eval rig set --predictions targets").error.find("robed.rig.txt:1: expected"), std::string::npos);
}

// A mesh without joints comes out with joints, names and weights.
TEST_F(CliRig, ABareMeshGetsASkeletonAndWeights) {
  put(in("figure.obj"), slurp(kData + "/biped__robot.obj"));
  good("rig figure.obj -o figure.glb --png figure.png");
  EXPECT_GT(fs::file_size(in("figure.png")), 1000u);
  const Character bound = read_gltf(in("figure.glb"));
  EXPECT_GT(bound.joints.size(), 15u);
  size_t weighted = 0;
  for (const auto& row : bound.influences) weighted += row.empty() ? 0 : 1;
  EXPECT_EQ(weighted, bound.vertices.size());
  const auto told = nlohmann::json::parse(good("rig figure.obj --no-bind -o figure.rig.txt --json").out);
  EXPECT_EQ(told["joints"].size(), bound.joints.size());
  EXPECT_EQ(told["joints"][0]["parent"], "");
  good("bind figure.obj --skeleton figure.rig.txt -o again.glb");
  fs::create_directories(in("meshes/sub"));
  put(in("meshes/sub/a.obj"), slurp(kData + "/bird__winged.obj"));
  good("rig meshes -o out --format rig.txt --no-bind");
  EXPECT_TRUE(fs::exists(in("out/sub/a.rig.txt"))) << "the folders of the input";
  EXPECT_NE(bad(2, "rig meshes -o meshes/sub").error.find("lies inside meshes"), std::string::npos);
  fs::copy(in("meshes/sub/a.obj"), in("meshes/sub/a.gltf"));
  EXPECT_NE(bad(1, "rig meshes -o twice").error.find("would both become twice/sub/a.glb"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("twice"))) << "said before any is made";
  // The command's own figures, of the model and of what it wrote.
  make_set();
  const std::string table = good("eval rig set").out;
  good("rig set -o predicted --format rig.txt --no-bind");
  EXPECT_TRUE(fs::exists(in("predicted/low/biped__robed.rig.txt")));
  EXPECT_EQ(good("eval rig set --predictions predicted").out, table);

  bad(1, "rig missing.obj");
  bad(2, "rig figure.obj --mirror --no-mirror");
  bad(2, "rig figure.obj --spine 0");
  bad(1, "rig figure.obj --model " + kData + "/sinew_default.sinew");
  put(in("empty.obj"), "");
  bad(1, "rig empty.obj");
  put(in("nan.obj"), "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n");
  bad(1, "rig nan.obj");
  EXPECT_FALSE(fs::exists(in("nan.rigged.glb")));
}

TEST_F(CliRig, WrongUsage) {
  make_set();
  EXPECT_NE(bad(2, "eval rig set --predictions set --model x.sinew").error.find("--predictions and --model"),
            std::string::npos);
  EXPECT_NE(bad(1, "eval rig set --predictions nowhere").error.find("nowhere: expected a folder"), std::string::npos);
  EXPECT_NE(bad(2, "eval rig set --predictions set --method heat").error.find("--method"), std::string::npos);
  EXPECT_NE(bad(2, "eval rig set --predictions set --known").error.find("--known"), std::string::npos);
  EXPECT_NE(bad(2, "dataset target set -o set").error.find("among the inputs"), std::string::npos);
  EXPECT_NE(bad(2, "dataset target set -o set/low").error.find("among the inputs"), std::string::npos);
  EXPECT_NE(bad(2, "dataset target set/snake__long.obj -o ./set/low/..").error.find("among the inputs"),
            std::string::npos);
  fs::copy(in("set/snake__long.obj"), in("snake__long.obj"));
  fs::copy(in("set/snake__long.rig.txt"), in("snake__long.rig.txt"));
  EXPECT_NE(bad(2, "dataset target snake__long.obj set -o out").error.find("would both become"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(CliRig, TrainingGoesOnFromTheReleasedModel) {
  fs::create_directories(in("set"));
  for (const char* name : {"/biped__robed", "/quadruped__tailed"})
    for (const char* end : {".obj", ".rig.txt"}) fs::copy(kData + name + end, in("set"));
  put(in("two.json"), R"({"steps": 2, "variants": 1, "synthetic": 0, "validate_every": 2, "learning_rate": 1e-5})");
  const std::string train = "train set --task rig --config two.json --quiet -o on.ckpt --init ";
  good(train + kData + "/sinew_rig.sinew");
  good("quantize on.ckpt --calibrate set --quiet -o on.sinew");
  const std::string table = good("eval rig set --checkpoint on.ckpt --model on.sinew").out;
  EXPECT_NE(table.find("float, on.ckpt: J2J "), std::string::npos) << table;
  EXPECT_NE(table.find("the same tree on 2 of 2 characters"), std::string::npos) << table;
  // What began with other weights is another skeleton.
  put(in("fresh.json"), R"({"steps": 1, "variants": 1, "synthetic": 0, "validate_every": 1})");
  good("train set --task rig --config fresh.json --quiet -o fresh.ckpt");
  EXPECT_NE(good("eval rig set --checkpoint fresh.ckpt --model on.sinew").out.find("the same tree on 0 of 2"),
            std::string::npos);

  fs::remove(in("on.ckpt"));
  EXPECT_NE(bad(1, train + kData + "/sinew_default.sinew").error.find("it has another task"), std::string::npos);
  EXPECT_NE(bad(1, "train set --task rig --config narrow.json --quiet -o on.ckpt --init " + kData + "/sinew_rig.sinew")
                .error.find("narrow.json"),
            std::string::npos);
  put(in("narrow.json"), R"({"steps": 2, "variants": 1, "synthetic": 0, "width": 32})");
  EXPECT_NE(bad(1, "train set --task rig --config narrow.json --quiet -o on.ckpt --init " + kData + "/sinew_rig.sinew")
                .error.find("cannot start from its weights: the configuration has other layers, or fewer channels"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(in("on.ckpt")));
  EXPECT_NE(bad(2, "eval rig set --checkpoint fresh.ckpt --method shape").error.find("--checkpoint"),
            std::string::npos);
}

TEST_F(CliRig, TargetGoesOnAfterAFailure) {
  make_set();
  put(in("set/broken.obj"), slurp(in("set/snake__long.obj")));
  put(in("set/broken.rig.txt"), "joints a 0 0 0\nroot a\n");
  const Outcome outcome = bad(1, "dataset target set -o targets");
  EXPECT_NE(outcome.error.find("1 of 3 characters failed; the first: "), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("no weights"), std::string::npos) << outcome.error;
  EXPECT_TRUE(fs::exists(in("targets/snake__long.rig.txt")));
  EXPECT_FALSE(fs::exists(in("targets/broken.rig.txt")));
}

// An OBJ does not say which axis is up: z is where the network is sure of it, and it hardly is of this creature.
TEST_F(CliRig, WhatHardlyTellsItsUpStandsOnItsFeet) {
  good("dataset synthesize --plan crawler --seed 9 --resolution 24 -o crawler.obj");
  const auto made = nlohmann::json::parse(good("rig crawler.obj --no-bind --json -o crawler.rig.txt").out);
  EXPECT_EQ(made["up"], "y") << made["up_certainty"];
}

}  // namespace
}  // namespace sinew
