// SPDX-License-Identifier: MIT
// sinew lod: levels with fewer triangles, wrong calls.
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "cli_fixture.hpp"
#include "same_character.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

class CliLod : public Cli {};

TEST_F(CliLod, LevelsKeepWhatVerticesHave) {
  good("rig " + kRobed + " --skeleton template:mixamo -o whole.glb");
  good("animate whole.glb --motion builtin:walk -o walking.glb");
  std::istringstream lines(good("lod walking.glb --levels 3 --fewer-joints --json -o far.glb").out);
  const Character whole = read_gltf(in("walking.glb"));
  size_t before = whole.face_count();
  for (int level = 1; level <= 3; ++level) {
    std::string line;
    std::getline(lines, line);
    const auto told = nlohmann::json::parse(line);
    const Character less = read_gltf(in("far.lod" + std::to_string(level) + ".glb"));
    EXPECT_EQ(told["triangles"], less.face_count());
    EXPECT_LT(less.face_count(), before * 7 / 10);
    EXPECT_GT(less.face_count(), before / 4);
    before = less.face_count();
    EXPECT_LT(told["rest_error"].get<double>(), 0.05);
    EXPECT_GE(told["posed_error"].get<double>(), told["rest_error"].get<double>());
    // Vertices that are left are ones that were there, with their weights.
    std::set<std::array<float, 3>> positions;
    for (const Vec3& p : whole.vertices) positions.insert({p.x, p.y, p.z});
    for (const Vec3& p : less.vertices) EXPECT_EQ(positions.count({p.x, p.y, p.z}), 1u);
    for (const auto& row : less.influences) EXPECT_FALSE(row.empty());
    EXPECT_EQ(read_gltf_motion(in("far.lod" + std::to_string(level) + ".glb")).clips.size(), 1u);
    if (level == 1) {
      EXPECT_EQ(less.joints.size(), whole.joints.size());
    } else {
      EXPECT_LT(less.joints.size(), whole.joints.size() - (level == 2 ? 0 : 20));  // fingers go last
    }
  }
  put(in("bare.obj"), slurp(kData + "/biped__robot.obj"));
  EXPECT_NE(bad(1, "lod bare.obj -o none.glb").error.find("bound"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("none.lod1.glb")));
  bad(2, "lod walking.glb --levels 0");
  bad(2, "lod walking.glb -o x.rig.txt");
}

// One GLB whose mesh nodes name the other levels'; who does not know the extension sees the whole character.
TEST_F(CliLod, LevelsInOneFile) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o whole.glb");
  good("lod whole.glb --levels 2 -o far.glb");
  EXPECT_NE(good("lod whole.glb --levels 2 --one-file").out.find("wrote whole.lods.glb"), std::string::npos);
  expect_same_character(read_gltf(in("whole.glb")), read_gltf(in("whole.lods.glb")), 1e-6);
  const std::string bytes = slurp(in("whole.lods.glb"));
  uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, 4);
  const auto document = nlohmann::json::parse(bytes.substr(20, size));
  EXPECT_EQ(document["extensionsUsed"], nlohmann::json::array({"MSFT_lod"}));
  size_t nodes = 0;
  for (const auto& node : document["nodes"]) {
    if (!node.contains("extensions")) continue;
    ++nodes;
    EXPECT_EQ(node["extras"]["MSFT_screencoverage"], nlohmann::json::array({0.5, 0.25, 0.0}));
    const auto& ids = node["extensions"]["MSFT_lod"]["ids"];
    ASSERT_EQ(ids.size(), 2u);
    for (size_t k = 0; k < 2; ++k) {
      const auto& level = document["nodes"].at(ids[k].get<size_t>());
      EXPECT_EQ(level["skin"], node["skin"]);
      const auto& primitive = document["meshes"].at(level["mesh"].get<size_t>())["primitives"][0];
      EXPECT_EQ(document["accessors"].at(primitive["indices"].get<size_t>())["count"].get<size_t>(),
                3 * read_gltf(in("far.lod" + std::to_string(k + 1) + ".glb")).face_count());
      EXPECT_TRUE(primitive["attributes"].contains("WEIGHTS_0"));
    }
  }
  EXPECT_EQ(nodes, 1u);
  EXPECT_NE(bad(2, "lod whole.glb --one-file --fewer-joints").error.find("share a skeleton"), std::string::npos);
  EXPECT_NE(bad(2, "lod whole.glb --one-file -o x.fbx").error.find("writes a .glb"), std::string::npos);
}

}  // namespace
}  // namespace sinew
