// SPDX-License-Identifier: MIT
// sinew animate --vat: files out, and wrong calls.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

class CliVat : public Cli {
 protected:
  nlohmann::json layout(const std::string& file) { return nlohmann::json::parse(slurp(in(file))); }
};

TEST_F(CliVat, ClipsBecomeTexturesAMeshAndALayout) {
  const auto json = nlohmann::json::parse(
      good("animate " + kRobed + " --motion builtin:walk --motion builtin:idle --in-place --vat crowd --json").out);
  EXPECT_FALSE(json.contains("output"));
  EXPECT_EQ(json["vat"]["layout"], "biped__robed.vat.json");
  const nlohmann::json made = layout("crowd/biped__robed.vat.json");
  for (const auto& [name, file] : made["textures"].items())
    EXPECT_TRUE(fs::exists(in("crowd/" + file.get<std::string>()))) << name;
  const Character mesh = read_gltf(in("crowd/" + made["mesh"].get<std::string>()));
  EXPECT_TRUE(mesh.joints.empty());
  EXPECT_EQ(mesh.face_count() > 0, true);
  ASSERT_EQ(made["clips"].size(), 2u);
  ASSERT_EQ(json["vat"]["clips"].size(), 2u);
  size_t frames = 0;
  for (size_t c = 0; c < 2; ++c) {
    const nlohmann::json& clip = json["vat"]["clips"][c];
    EXPECT_EQ(made["clips"][c]["first_frame"], frames);
    EXPECT_EQ(made["clips"][c]["loop"], true) << made["clips"][c]["name"];
    EXPECT_EQ(clip["frames"], json["clips"][c]["frames"]);
    frames += clip["frames"].get<size_t>();
    // Half a step of 16 bits along three axes.
    double diagonal = 0;
    for (size_t i = 0; i < 3; ++i)
      diagonal += std::pow(made["bounds"]["max"][i].get<double>() - made["bounds"]["min"][i].get<double>(), 2);
    EXPECT_LE(clip["error"]["frames"]["max"].get<double>(), std::sqrt(diagonal) / 65535 / 2 + 1e-6);
    EXPECT_GT(clip["error"]["between"]["max"].get<double>(), clip["error"]["frames"]["max"].get<double>());
  }
  EXPECT_EQ(files(), 1u);  // the folder alone
  const std::string said = good("animate " + kRobed + " --motion builtin:walk --in-place --vat crowd").out;
  for (const char* part :
       {"walk: ", " MB; at frames at most 0.0", "halfway between", "; loops", "wrote crowd/biped__robed.vat.json"})
    EXPECT_NE(said.find(part), std::string::npos) << part << " in:\n" << said;
}

TEST_F(CliVat, SpringsAndTheCharacterGoAlong) {
  const std::string words = "animate " + kRobed + " --motion builtin:run";
  good(words + " --vat stiff");
  good(words + " --springs --vat swinging -o swinging.glb");
  EXPECT_EQ(slurp(in("stiff/biped__robed.vat.glb")), slurp(in("swinging/biped__robed.vat.glb")));
  EXPECT_NE(slurp(in("stiff/biped__robed.vat.position_low.png")),
            slurp(in("swinging/biped__robed.vat.position_low.png")));
  EXPECT_TRUE(fs::exists(in("swinging.glb")));
  // A clip that leaves its spot is no loop, and that is told.
  EXPECT_EQ(layout("stiff/biped__robed.vat.json")["clips"][0]["loop"], false);
  EXPECT_NE(good(words + " --vat stiff").out.find("--in-place"), std::string::npos);
}

TEST_F(CliVat, APictureAndABareMeshHaveTexturesToo) {
  good("animate " + kData + "/drawing__child.png --vat drawing");
  const Character mesh = read_gltf(in("drawing/drawing__child.vat.glb"));
  EXPECT_FALSE(mesh.corner_uvs.empty());
  EXPECT_FALSE(mesh.material_names.empty());
}

TEST_F(CliVat, WrongCallsSayWhat) {
  const std::string walk = "animate " + kRobed + " --motion builtin:walk ";
  put(in("taken"), "");
  std::istringstream rig(slurp(kRobedRig));
  std::string without_weights;
  for (std::string line; std::getline(rig, line);)
    if (line.rfind("skin ", 0) != 0) without_weights += line + "\n";
  put(in("bare.rig.txt"), without_weights);
  put(in("bare.obj"), slurp(kRobed));
  for (const auto& [words, part] : std::vector<std::pair<std::string, std::string>>{
           {walk, "--output is required"},
           {"animate " + kRobed + " --vat crowd", "--motion is required"},
           {walk + "--vat taken", "taken: is a file, expected a folder"},
           {walk + "--vat /proc/crowd", "/proc/crowd: cannot create this folder"},
           {walk + "--vat crowd --for unreal", "--for and --controls"},
           {"animate bare.obj --motion builtin:walk --vat crowd", "no skin weights"},
           {"animate " + kData + "/drawing__child.png --vat crowd -o child.apng", "write a .glb"},
           {"animate " + kData + " --motion builtin:walk --vat crowd -o out", "--vat takes one character"}}) {
    const Outcome outcome = run(words);
    EXPECT_NE(outcome.status, 0) << words;
    EXPECT_NE(outcome.error.find(part), std::string::npos) << words << "\n" << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  }
  EXPECT_FALSE(fs::exists(in("crowd")));
}

}  // namespace
}  // namespace sinew
