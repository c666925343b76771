// SPDX-License-Identifier: MIT
// sinew lod: levels with fewer triangles, wrong calls.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "cli_fixture.hpp"
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
    std::set<std::array<float, 3>> places;
    for (const Vec3& p : whole.vertices) places.insert({p.x, p.y, p.z});
    for (const Vec3& p : less.vertices) EXPECT_EQ(places.count({p.x, p.y, p.z}), 1u);
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

}  // namespace
}  // namespace sinew
