// SPDX-License-Identifier: MIT
// What a profile changes, and what it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "expect_error.hpp"
#include "gltf/gltf_source.hpp"
#include "make_glb.hpp"
#include "predict/turn.hpp"
#include "sinew_character/jobs/character_file.hpp"
#include "sinew_character/pose/rest_pose.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"
#include "walking_figure.hpp"

namespace sinew {
namespace {

ProfileOptions options_for(const std::string& profile) {
  ProfileOptions options;
  if (profile_named(profile).vrm != 0) options.authors = {"Ann"};
  return options;
}

std::string write(const std::string& profile, const std::string& path, const Character& character,
                  const Motion* motion = nullptr, bool keep_skin = false) {
  GlbOptions glb;
  glb.motion = motion;
  glb.keep_skin = keep_skin;
  std::string notes;
  for (const std::string& note : write_for_profile(profile_named(profile), options_for(profile), path, character, glb))
    notes += note + "\n";
  return notes;
}

// Skinned vertices of each frame of the file's own animation, by the file's own matrices. [frames][V]
std::vector<std::vector<Point3>> shown(const std::string& path) {
  const Character character = read_character(path);
  const Motion motion = read_gltf_motion(path, 30);
  std::vector<std::vector<Point3>> frames;
  for (const MotionFrame& frame : motion.clips.at(0).frames) {
    const std::vector<Affine> palette = motion_palette(motion, frame, character.joints.size());
    frames.emplace_back();
    for (size_t v = 0; v < character.vertices.size(); ++v) {
      const Point3 p = point(character.vertices[v]);
      Point3 sum{};
      for (const Influence& one : character.influences[v])
        sum = sum + static_cast<double>(one.weight) * transform_point(palette[one.joint], p[0], p[1], p[2]);
      frames.back().push_back(sum);
    }
  }
  return frames;
}

double largest_distance(const std::vector<std::vector<Point3>>& a, const std::vector<std::vector<Point3>>& b,
                        double side) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (size_t f = 0; f < std::min(a.size(), b.size()); ++f) {
    EXPECT_EQ(a[f].size(), b[f].size());
    for (size_t v = 0; v < std::min(a[f].size(), b[f].size()); ++v)
      largest = std::max(largest, length(Point3{side * a[f][v][0], a[f][v][1], side * a[f][v][2]} - b[f][v]));
  }
  return largest;
}

constexpr double kHeight = 1.71;

class EachProfile : public ::testing::TestWithParam<std::string> {
 protected:
  TempFolder folder_;
};

TEST_P(EachProfile, ShowsTheSamePictureInEveryFrame) {
  const Profile& profile = profile_named(GetParam());
  const double side = profile.faces_back ? -1 : 1;
  const Motion walk = walking_person(20);
  const std::string plain = folder_.file("plain.glb"), foreign = folder_.file("foreign.glb"),
                    once = folder_.file("once.glb"), twice = folder_.file("twice.glb");
  GlbOptions glb;
  glb.motion = &walk;
  write_character(plain, walking_figure(), glb);
  const std::vector<std::vector<Point3>> wanted = shown(plain);
  ASSERT_EQ(wanted.size(), 20u);
  EXPECT_GT(largest_distance({wanted[0]}, {wanted[7]}, 1), 0.1);  // it moves
  write(GetParam(), once, walking_figure(), &walk);
  EXPECT_LT(largest_distance(wanted, shown(once), side), 1e-4 * kHeight);
  // From a file with axes of its own and animations that lie in them.
  write("unreal", foreign, read_character(plain), nullptr, true);
  write(GetParam(), twice, read_character(foreign), nullptr, true);
  EXPECT_LT(largest_distance(wanted, shown(twice), side), 1e-4 * kHeight);
}

TEST_P(EachProfile, HasTheAxesThatItSays) {
  const Profile& profile = profile_named(GetParam());
  write(GetParam(), folder_.file("out.glb"), walking_figure());
  const Character character = read_character(folder_.file("out.glb"));
  const GltfSource& source = *character.gltf;
  std::vector<Rotation> wanted(character.joints.size(), kNoRotation);
  if (profile.axes != nullptr) wanted = joint_axes(character.joints, *profile.axes);
  for (size_t j = 0; j < character.joints.size(); ++j) {
    if (character.joints[j].name == profile.root) continue;
    const Rotation has = rotation_part(source.bind_pose.worlds[static_cast<size_t>(source.joint_nodes[j])]);
    for (size_t i = 0; i < 9; ++i) EXPECT_NEAR(has[i], wanted[j][i], 1e-5) << character.joints[j].name;
  }
  size_t roots = 0;
  for (const Joint& joint : character.joints) roots += joint.parent < 0 ? 1 : 0;
  EXPECT_EQ(roots, 1u);
  if (*profile.root != 0) {
    EXPECT_EQ(std::count_if(character.joints.begin(), character.joints.end(),
                            [&](const Joint& joint) { return joint.parent < 0 && joint.name == profile.root; }),
              1);
  }
}

std::vector<std::string> profile_list() {
  std::vector<std::string> names;
  for (const Profile& profile : profiles()) names.emplace_back(profile.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Profiles, EachProfile, ::testing::ValuesIn(profile_list()),
                         [](const auto& profile) { return profile.param; });

// Positions of joints by name, frame by frame, where the clip's rotation keys are copied onto the nodes of `onto` that have the same name; the
// positions are against the hips'.
std::vector<std::map<std::string, Point3>> by_name(const std::string& clip, const std::string& onto,
                                                   const std::string& hips) {
  const GltfSource from = *read_character(clip).gltf, to = *read_character(onto).gltf;
  const tinygltf::Animation& animation = from.model.animations.at(0);
  std::vector<std::map<std::string, Point3>> frames;
  for (size_t f = 0; f < 20; ++f) {
    std::map<std::string, std::vector<double>> keys;
    for (const tinygltf::Node& node : from.model.nodes) keys[node.name] = node.rotation;
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      if (channel.target_path != "rotation") continue;
      const std::vector<float> values =
          accessor_floats(clip, from.model, animation.samplers[static_cast<size_t>(channel.sampler)].output, 4);
      const size_t at =
          values.size() < size_t{4} * 20 ? 0 : 4 * f;  // a joint that stands still has its first and last key
      keys[from.model.nodes[static_cast<size_t>(channel.target_node)].name] = {
          static_cast<double>(values.at(at)), static_cast<double>(values.at(at + 1)),
          static_cast<double>(values.at(at + 2)), static_cast<double>(values.at(at + 3))};
    }
    tinygltf::Model posed = to.model;
    for (tinygltf::Node& node : posed.nodes)
      if (keys.count(node.name) != 0) node.rotation = keys[node.name];
    const GltfNodes nodes = gltf_nodes(onto, posed);
    frames.emplace_back();
    for (size_t n = 0; n < posed.nodes.size(); ++n) {
      const Affine& world = nodes.worlds[n];
      frames.back()[posed.nodes[n].name] = {world[3], world[7], world[11]};
    }
    const Point3 at_hips = frames.back().at(hips);
    for (auto& [name, position] : frames.back()) position = position - at_hips;
  }
  return frames;
}

class ReadyClips : public EachProfile {};

TEST_P(ReadyClips, LookAlikeByNameAlone) {
  const Motion walk = walking_person(20);
  const Character figure = walking_figure();
  const std::vector<std::string> names = profile_names(figure.joints, profile_named(GetParam()).names);
  const std::string original = folder_.file("original.glb"), other = folder_.file("other.glb"),
                    foreign = folder_.file("foreign.glb");
  write(GetParam(), original, figure, &walk);
  // The same body with another program's names and axes, and standing otherwise, which axes along bones make up for.
  Character standing = figure;
  if (profile_named(GetParam()).axes != nullptr) standing = in_rest_pose(figure, read_rest_pose("a"), Axis::kY);
  write(GetParam() == "unreal" ? "godot" : "unreal", foreign, standing);
  write(GetParam(), other, read_character(foreign), nullptr, true);
  const auto wanted = by_name(original, original, names[0]), copied = by_name(original, other, names[0]);
  double largest = 0, moved = 0;
  std::string worst;
  for (size_t f = 0; f < wanted.size(); ++f)
    for (const std::string& name : names) {
      if (name.find("_end") != std::string::npos) continue;
      ASSERT_EQ(copied[f].count(name), 1u) << name;
      const double apart = length(wanted[f].at(name) - copied[f].at(name));
      if (apart > largest) largest = apart, worst = name;
      moved = std::max(moved, length(wanted[f].at(name) - wanted[0].at(name)));
    }
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(largest, 0.01 * kHeight) << worst;
}
INSTANTIATE_TEST_SUITE_P(Profiles, ReadyClips, ::testing::Values("mixamo", "unreal", "vrm", "godot", "blender"),
                         [](const auto& profile) { return profile.param; });

TEST(WriteForProfile, KeepsTheStrongestInfluencesAndTheSkeletonWhereAsked) {
  TempFolder folder;
  Character figure = walking_figure();
  figure.influences[5] = {{0, 0.1f}, {1, 0.2f}, {2, 0.3f}, {3, 0.15f}, {4, 0.25f}};
  EXPECT_NE(write("mixamo", folder.file("four.glb"), figure).find("1 vertices had more than 4"), std::string::npos);
  for (const auto& row : read_character(folder.file("four.glb")).influences) EXPECT_LE(row.size(), 4u);
  EXPECT_EQ(write("unreal", folder.file("eight.glb"), figure).find("more than"), std::string::npos);
  ProfileOptions keep;
  keep.keep_axes = true;
  write_for_profile(profile_named("unreal"), keep, folder.file("kept.glb"), figure);
  const Character kept = read_character(folder.file("kept.glb"));
  ASSERT_EQ(kept.joints.size(), figure.joints.size());
  for (size_t j = 0; j < kept.joints.size(); ++j) EXPECT_EQ(kept.joints[j].name, figure.joints[j].name);
}

TEST(WriteForProfile, AVrmOfTheOlderVersionIsWhole) {
  TempFolder folder;
  ProfileOptions options = options_for("vrm0");
  options.license = "avatarPermission=everyone,licenseName=CC_BY";
  Character figure = walking_figure();
  write_for_profile(profile_named("vrm0"), options, folder.file("out.vrm"), figure);
  const nlohmann::json document = json_of_glb(folder.text_of("out.vrm"));
  const nlohmann::json& vrm = document["extensions"]["VRM"];
  EXPECT_EQ(vrm["meta"]["allowedUserName"], "Everyone");
  EXPECT_EQ(vrm["meta"]["licenseName"], "CC_BY");
  EXPECT_EQ(vrm["meta"]["violentUssageName"], "Disallow");
  std::map<std::string, int> bones;
  for (const auto& bone : vrm["humanoid"]["humanBones"]) bones[bone["bone"]] = bone["node"];
  EXPECT_EQ(document["nodes"][static_cast<size_t>(bones.at("leftUpperArm"))]["name"], "leftUpperArm");
  const Character read = read_character(folder.file("out.vrm"));
  for (size_t j = 0; j < read.joints.size(); ++j) {
    if (read.joints[j].name == "leftUpperArm") {
      EXPECT_LT(read.joints[j].position.x, -0.1f);  // it faces -z
    }
  }
  EXPECT_ERROR(write_for_profile(profile_named("vrm0"), options, folder.file("no.gltf"), figure), "no.gltf", ".vrm");
  figure.joints.erase(figure.joints.begin() + 3, figure.joints.end());
  figure.influences.assign(figure.vertices.size(), {{0, 1.0f}});
  EXPECT_ERROR(write_for_profile(profile_named("vrm0"), options, folder.file("no.vrm"), figure), "no.vrm", "head");
  EXPECT_ERROR(profile_named("softimage"), "mixamo");
  ProfileOptions older = options;
  EXPECT_ERROR(check_profile(profile_named("vrm"), older), "licenseName");
}

TEST(WriteForProfile, AVrmWithoutAnAuthorSaysSoAndOneOfTheOlderVersionKeepsItsOwn) {
  TempFolder folder;
  const auto authors = [&](const char* name) {
    return json_of_glb(folder.text_of(name))["extensions"]["VRMC_vrm"]["meta"]["authors"];
  };
  const std::vector<std::string> notes =
      write_for_profile(profile_named("vrm"), {}, folder.file("a.vrm"), walking_figure());
  EXPECT_EQ(authors("a.vrm"), nlohmann::json::array({"unknown"}));
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(notes.back().find("--author"), std::string::npos) << notes.back();
  write_for_profile(profile_named("vrm0"), options_for("vrm0"), folder.file("older.vrm"), walking_figure());
  write_for_profile(profile_named("vrm"), {}, folder.file("newer.vrm"), read_character(folder.file("older.vrm")));
  EXPECT_EQ(authors("newer.vrm"), nlohmann::json::array({"Ann"}));
  EXPECT_FALSE(json_of_glb(folder.text_of("newer.vrm"))["extensions"].contains("VRM"));
}

}  // namespace
}  // namespace sinew
