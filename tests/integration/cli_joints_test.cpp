// SPDX-License-Identifier: MIT
// Which joints sinew bind gives weight to, what it leaves alone, and what it says of it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "glb_round.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

using nlohmann::json;

bool has_text(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class CliJoints : public Cli {
 protected:
  // The strip with a control between its joints, and a lamp without a skin on its knee.
  void SetUp() override {
    Cli::SetUp();
    GlbBuilder builder = two_joint_strip();
    const int control = builder.add("nodes", {{"name", "kneeIK"}, {"translation", {0, 1, 0}}});
    builder.document["nodes"][0]["children"].push_back(control);
    builder.document["skins"][0]["joints"].push_back(control);
    std::vector<float> binds(48, 0);
    for (size_t j = 0; j < 3; ++j)
      for (size_t i = 0; i < 4; ++i) binds[j * 16 + i * 5] = 1;
    binds[16 + 13] = -2;
    builder.document["skins"][0]["inverseBindMatrices"] = builder.accessor(binds, "MAT4");
    const json triangle = {{"attributes", {{"POSITION", builder.positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}};
    const int mesh = builder.add("meshes", {{"name", "lamp"}, {"primitives", json::array({triangle})}});
    builder.document["nodes"][1]["children"] = {
        builder.add("nodes", {{"name", "lamp"}, {"mesh", mesh}, {"translation", {0, 0.5, 0}}})};
    document_ = builder.document;
    put(in("hero.glb"), builder.glb());
  }
  double weight_of(const std::string& file, const std::string& joint) {
    const Character c = read_gltf(in(file));
    double sum = 0;
    for (size_t v = 0; v < c.vertices.size(); ++v)
      for (const Influence& i : c.influences[v])
        if (c.joints[i.joint].name == joint && c.meshes[c.vertex_meshes[v]].skinned)
          sum += static_cast<double>(i.weight);
    return sum;
  }
  json document_;
};

TEST_F(CliJoints, OwnJointsAndAttachedMeshesByDefault) {
  const std::string text = good("bind hero.glb -o out.glb --method heat").out;
  EXPECT_TRUE(
      has_text(text, "1 joints get no weight (no weight in the file: kneeIK); --joints all lets all have weight"))
      << text;
  EXPECT_TRUE(has_text(text, "1 attached meshes kept as they are; --bind-props binds them")) << text;
  EXPECT_EQ(weight_of("out.glb", "kneeIK"), 0);
  const std::string glb = slurp(in("out.glb"));
  const json out = json_of_glb(glb);
  EXPECT_EQ(out["nodes"][4], document_["nodes"][4]);  // the lamp, to the byte
  const json& attributes = out["meshes"][1]["primitives"][0]["attributes"];
  EXPECT_EQ(attributes.size(), 1u);
  EXPECT_EQ(values_of<float>(glb, out, attributes["POSITION"].get<int>(), 3),
            (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const json summary = json::parse(good("bind hero.glb -o out.glb --method heat --json").out);
  EXPECT_EQ(summary["left_out"][0]["joint"], "kneeIK");
  EXPECT_EQ(summary["left_out"][0]["why"], "no weight in the file");
}

TEST_F(CliJoints, NamesAllAndLists) {
  EXPECT_TRUE(has_text(good("bind hero.glb -o out.glb --method heat --joints names").out, "control: kneeIK"));
  EXPECT_EQ(weight_of("out.glb", "kneeIK"), 0);
  EXPECT_FALSE(has_text(good("bind hero.glb -o out.glb --method heat --joints all").out, "no weight"));
  EXPECT_GT(weight_of("out.glb", "kneeIK"), 0);
  put(in("list.txt"), "hip\nkneeIK\n");
  good("bind hero.glb -o out.glb --method heat --joints list.txt");
  EXPECT_GT(weight_of("out.glb", "kneeIK"), 0);
  EXPECT_EQ(weight_of("out.glb", "knee"), 0);
  bad(1, "bind hero.glb -o x.glb --joints nonsense");
  EXPECT_FALSE(fs::exists(in("x.glb")));
}

TEST_F(CliJoints, PropsAreBoundWhereAskedFor) {
  EXPECT_FALSE(has_text(good("bind hero.glb -o out.glb --method heat --bind-props").out, "attached"));
}

TEST_F(CliJoints, ASkeletonInOtherUnitsIsToldAndMended) {
  Character big = read_character(kSnake);
  big.influences.clear();
  for (Joint& joint : big.joints)
    joint.position = {100 * joint.position.x, 100 * joint.position.y, 100 * joint.position.z};
  write_rig(in("big.rig.txt"), big);
  const std::string warned = good("bind " + kSnake + " --skeleton big.rig.txt -o out.glb --method heat").out;
  EXPECT_TRUE(has_text(warned, "warning: the skeleton is 100 times as large as the mesh")) << warned;
  EXPECT_TRUE(has_text(warned, "correct it with --fit"));
  const std::string mended = good("bind " + kSnake + " --skeleton big.rig.txt -o out.glb --method heat --fit").out;
  EXPECT_TRUE(has_text(mended, "corrected by --fit")) << mended;
  EXPECT_FALSE(
      has_text(good("bind " + kSnake + " --skeleton " + kSnakeRig + " -o out.glb --method heat").out, "warning"));
}

TEST_F(CliJoints, AFlatListGetsAHierarchy) {
  std::string rig;
  for (const Joint& joint : read_character(kSnake).joints)
    rig += "joints " + joint.name + " " + std::to_string(joint.position.x) + " " + std::to_string(joint.position.y) +
           " " + std::to_string(joint.position.z) + "\n";
  put(in("flat.rig.txt"), rig + "root " + read_character(kSnake).joints.front().name + "\n");
  EXPECT_TRUE(has_text(good("bind " + kSnake + " --skeleton flat.rig.txt -o out.glb --method heat").out,
                       "17 joints had no parent and got the nearest one along the body"));
}

}  // namespace
}  // namespace sinew
