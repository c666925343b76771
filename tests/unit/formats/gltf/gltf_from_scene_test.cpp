// SPDX-License-Identifier: MIT
// FBX, COLLADA and others in: mesh, joints, weights, units and axes; broken files and builds without Assimp.
#include "gltf/gltf_from_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <sstream>
#ifdef __linux__
#include <unistd.h>
#endif

#include "expect_error.hpp"
#include "glb_round.hpp"
#include "gltf/scene_process.hpp"
#include "scene_files.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "with_asan.hpp"

// Assimp 5.2.5 forgets parts of its own tree of an FBX: no leak of ours.
#ifdef SINEW_WITH_ASAN
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }
#endif

namespace sinew {
namespace {

#ifdef SINEW_HAS_ASSIMP

const std::string kPng = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(17, '\0') + "\2 picture";

// 1 wide and 4 high, upright, with the weights of the file.
void expect_strip(const Character& c) {
  ASSERT_EQ(c.joints.size(), 3u);
  EXPECT_EQ(c.joints[0].name, "hip");
  EXPECT_EQ(c.joints[0].parent, -1);
  EXPECT_EQ(c.joints[1].name, "knee");
  EXPECT_EQ(c.joints[1].parent, 0);
  EXPECT_EQ(c.joints[2].name, "tip");
  EXPECT_EQ(c.joints[2].parent, 1);
  EXPECT_NEAR(c.joints[1].position.y, 2, 1e-5);
  EXPECT_NEAR(c.joints[2].position.y, 4, 1e-5);
  EXPECT_NEAR(c.joints[2].position.z, 0, 1e-5);
  ASSERT_GE(c.vertices.size(), 10u);
  for (size_t v = 0, found = 0; v < c.vertices.size(); ++v) {
    const float y = c.vertices[v].y;
    const bool of_strip = c.influences[v].size() == 2 || std::abs(y - std::round(y)) < 1e-5f;
    if (!of_strip || found++ >= 10) continue;
    EXPECT_NEAR(c.vertices[v].z, 0, 1e-5);
    EXPECT_NEAR(row(c, v)[1], y / 4, 2e-5) << v;
    EXPECT_NEAR(row(c, v)[0], 1 - y / 4, 2e-5) << v;
  }
}

TEST(GltfFromScene, Fbx) {
  const TempFolder folder;
  const Character c = read_mesh(folder.write("strip.fbx", strip_fbx()));
  expect_strip(c);
  EXPECT_EQ(c.vertices.size(), 13u);
  EXPECT_EQ(c.face_count(), 9u);
  EXPECT_EQ(row(c, 12), (std::map<uint32_t, float>{{1, 1.0f}}));  // the lamp hangs on the knee
  const Character again = reread(written(c));
  expect_strip(again);
  const nlohmann::json out = json_of_glb(written(c));
  const nlohmann::json& body = out["meshes"][0];
  EXPECT_EQ(body["name"], "body");
  const nlohmann::json& red = out["materials"][body["primitives"][0]["material"].get<size_t>()];
  EXPECT_EQ(red["name"], "red");
  EXPECT_EQ(red["pbrMetallicRoughness"]["baseColorFactor"], nlohmann::json({1, 0, 0, 1}));
}

// Assimp says bones by their names alone; editors let a mesh be called as a bone is.
TEST(GltfFromScene, AMeshMayBeCalledAsAJoint) {
  const TempFolder folder;
  const auto renamed = [](std::string text, const std::string& what, const std::string& with) {
    const size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), with);
  };
  for (const char* joint : {"hip", "knee"}) {
    const std::string fbx = renamed(strip_fbx(), "Model::body", std::string("Model::") + joint);
    expect_strip(read_mesh(folder.write("strip.fbx", fbx)));
    const std::string dae = renamed(strip_dae(), "name=\"body\"", std::string("name=\"") + joint + "\"");
    expect_strip(read_character(folder.write("strip.dae", dae)));
  }
}

TEST(GltfFromScene, Collada) {
  const TempFolder folder;
  const std::string path = folder.write("strip.dae", strip_dae());
  Character c = read_character(path);
  expect_strip(c);
  EXPECT_EQ(c.vertices.size(), 10u);
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes[0].find("skin.png"), std::string::npos) << c.notes[0];
  folder.write("skin.png", kPng);
  c = read_character(path);
  EXPECT_TRUE(c.notes.empty());
  const std::string glb = written(c);
  EXPECT_EQ(json_of_glb(glb)["images"].size(), 1u);
  EXPECT_NE(glb.find(kPng), std::string::npos);
  EXPECT_EQ(list_characters(folder.path()), std::vector<std::string>{path});
}

// As of Second Life: nodes stand as the default avatar does, inverse bind matrices as the mesh was bound, and a bind shape matrix scales it.
TEST(GltfFromScene, ColladaNodesNeedNotBeTheBindPose) {
  const TempFolder folder;
  std::string text = strip_dae();
  const auto replace = [&](const std::string& what, const std::string& with) {
    const size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), with);
  };
  replace("sid=\"knee\" type=\"JOINT\"><matrix>1 0 0 0 0 1 0 0 0 0 1 200",
          "sid=\"knee\" type=\"JOINT\"><matrix>1 0 0 30 0 0 -1 0 0 1 0 120");
  replace("<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0", "<bind_shape_matrix>2 0 0 0 0 2 0 0 0 0 2 0");
  std::string halves;
  std::istringstream words(text.substr(text.find("count=\"30\">") + 11));
  for (int k = 0; k < 30; ++k) {
    double value = 0;
    words >> value;
    halves += std::to_string(0.5 * value) + " ";
  }
  const size_t begin = text.find("count=\"30\">") + 11;
  text.replace(begin, text.find('<', begin) - begin, halves);
  const Character c = read_character(folder.write("avatar.dae", text));
  expect_strip(c);
}

// All upright and with the weights that stand in them, whatever their axes.
TEST(GltfFromScene, OtherFormatsWithSkins) {
  const TempFolder folder;
  folder.write("strip.skeleton.xml", strip_skeleton_xml());
  const std::map<std::string, std::string> files = {{"strip.x", strip_x()},
                                                    {"strip.md5mesh", strip_md5mesh()},
                                                    {"strip.smd", strip_smd()},
                                                    {"strip.mesh.xml", strip_mesh_xml()},
                                                    {"strip.b3d", strip_b3d()}};
  for (const auto& [name, text] : files) {
    SCOPED_TRACE(name);
    const Character c = read_character(folder.write(name, text));
    EXPECT_EQ(c.name, "strip");
    EXPECT_EQ(c.vertices.size(), 10u);
    EXPECT_EQ(c.face_count(), 8u);
    expect_strip(c);
    expect_strip(reread(written(c)));
  }
  EXPECT_EQ(list_characters(folder.path()).size(), files.size());
}

TEST(GltfFromScene, MilkShapeHasOneJointAVertex) {
  const TempFolder folder;
  const Character c = read_character(folder.write("strip.ms3d", strip_ms3d()));
  ASSERT_EQ(c.joints.size(), 3u);
  EXPECT_NEAR(c.joints[2].position.y, 4, 1e-5);
  ASSERT_EQ(c.vertices.size(), 10u);
  for (size_t v = 0; v < 10; ++v)
    EXPECT_EQ(row(c, v), (std::map<uint32_t, float>{{c.vertices[v].y > 2.5f ? 1u : 0u, 1.0f}})) << v;
}

// A skeleton without a mesh, two clips, Z up: the tip goes where the file says, in meters and Y up.
TEST(GltfFromScene, MotionsOfCollada) {
  const TempFolder folder;
  const Motion motion = read_motion(folder.write("moves.dae", moving_dae()), 10);
  ASSERT_EQ(motion.clips.size(), 2u);
  EXPECT_EQ(motion.clips[0].name, "bend_bend");  // Assimp puts the first one's name before all
  EXPECT_EQ(motion.clips[1].name, "bend_rise");
  EXPECT_EQ(find_clip(motion, "moves.dae", "1").frames.size(), 21u);
  ASSERT_EQ(motion.joints.size(), 3u);
  EXPECT_EQ(motion.joints[2].name, "tip");
  EXPECT_EQ(motion.joints[2].parent, 1);
  ASSERT_EQ(motion.clips[0].frames.size(), 11u);
  ASSERT_EQ(motion.clips[1].frames.size(), 21u);
  const auto expect_tip = [&](const MotionFrame& frame, Point3 wanted) {
    const Point3 tip = world_pose(motion, frame).positions[2];
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(tip[i], wanted[i], 1e-5) << i;
  };
  expect_tip(motion.clips[0].frames.front(), {0, 4, 0});
  expect_tip(motion.clips[0].frames.back(), {0, 2, 2});  // -y of the file is front
  expect_tip(motion.clips[1].frames[10], {0, 4.5, 0});
  expect_tip(motion.clips[1].frames.back(), {0, 5, 0});
}

// Assimp puts clips of one channel together and calls them combinedAnim_ and '0' + number, which is no text from the 80th on.
TEST(GltfFromScene, NamesThatAreNoTextAreReplaced) {
  const TempFolder folder;
  std::string text = moving_dae();
  const size_t begin = text.find("<animation id=\"bend\""), end = text.find("<animation id=\"rise\"");
  ASSERT_LT(begin, end);
  const std::string clip = text.substr(begin, end - begin);
  const size_t channel = clip.find("/>\n", clip.find("<channel")) + 3;
  std::string clips;
  for (int k = 0; k < 83; ++k) {
    std::string one = k < 81    ? clip
                      : k == 81 ? clip.substr(0, channel) + "</animation>\n"
                                : clip.substr(0, clip.find('\n') + 1) + clip.substr(channel);
    for (size_t at = one.find("bend"); at != std::string::npos; at = one.find("bend", at + 1))
      one.replace(at, 4, "b" + std::to_string(k));
    clips += one;
  }
  const Motion motion = read_motion(folder.write("moves.dae", text.replace(begin, end - begin, clips)), 10);
  for (const Clip& made : motion.clips)
    for (const char c : made.name) EXPECT_TRUE(c >= 32 && c < 127) << made.name;
}

// An element for every channel, as Blender writes them: one clip, and of two that move the same joint the longer one.
TEST(GltfFromScene, ColladaAnimationsWithoutNamesAreOneClip) {
  const TempFolder folder;
  std::string text = moving_dae();
  for (const char* name : {" name=\"bend\"", " name=\"rise\"", " id=\"bend\"", " id=\"rise\""}) {
    const size_t at = text.find(name);
    ASSERT_NE(at, std::string::npos);
    text.erase(at, std::string(name).size());
  }
  const Motion motion = read_motion(folder.write("moves.dae", text), 10);
  ASSERT_EQ(motion.clips.size(), 1u);
  EXPECT_EQ(motion.clips[0].name, "moves");
  const Point3 tip = world_pose(motion, motion.clips[0].frames[10]).positions[2];
  EXPECT_NEAR(tip[1], 2, 1e-5) << "bends as the first element says";
}

TEST(GltfFromScene, MotionsOfFbx) {
  const TempFolder folder;
  const std::string fbx = folder.file("moves.fbx");
  const std::string still = folder.write("strip.fbx", strip_fbx());
  EXPECT_ERROR(read_motion(still), "strip.fbx", "expected an animation, found none");
  folder.write("moves.fbx", moving_fbx());
  const Motion motion = read_motion(fbx, 10);
  ASSERT_EQ(motion.clips.size(), 1u);
  EXPECT_EQ(motion.clips[0].name, "Take 001");
  ASSERT_EQ(motion.joints.size(), 3u);
  const Point3 tip = world_pose(motion, motion.clips[0].frames.back()).positions[2];
  EXPECT_NEAR(tip[1], 2, 1e-4);
  EXPECT_NEAR(std::abs(tip[2]), 2, 1e-4);
  // A mesh that is read for something else keeps its animations.
  const Character c = read_mesh(fbx);
  EXPECT_EQ(json_of_glb(written(c))["animations"].size(), 1u);
}

TEST(GltfFromScene, AClipInWhichNothingMovesKeepsItsLength) {
  const TempFolder folder;
  std::string text = moving_fbx();
  const std::string turn = "a: 0,90\n";
  ASSERT_NE(text.find(turn), std::string::npos);
  const Motion motion =
      read_motion(folder.write("idle.fbx", text.replace(text.find(turn), turn.size(), "a: 0,0\n")), 10);
  EXPECT_EQ(motion.clips.at(0).frames.size(), 11u);
}

TEST(GltfFromScene, BrokenMotionsAreOneLine) {
  const TempFolder folder;
  EXPECT_ERROR(read_motion(folder.file("none.dae")), "none.dae", "no such file");
  EXPECT_ERROR(read_motion(folder.write("still.dae", strip_dae())), "still.dae", "expected an animation, found none");
  std::string wrong = moving_dae();
  wrong.replace(wrong.rfind("100 0 0 0 1"), 3, "nan");
  EXPECT_ERROR(read_motion(folder.write("nan.dae", wrong)), "nan.dae");
  for (const std::string& whole : {moving_fbx(), moving_dae()}) {
    const char* name = whole[0] == ';' ? "cut.fbx" : "cut.dae";
    // The rarer formats cost a process each, and a second where Assimp hangs.
    const size_t steps = has_extension(name, ".fbx") || has_extension(name, ".dae") ? 40 : 8;
    for (size_t length = 16; length < whole.size(); length += whole.size() / steps) {
      try {
        (void)read_motion(folder.write(name, whole.substr(0, length)));
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).rfind(folder.file(name), 0), 0u) << error.what();
      }
    }
  }
}

TEST(GltfFromScene, BrokenFilesAreOneLine) {
  const TempFolder folder;
  EXPECT_ERROR(read_mesh(folder.file("none.fbx")), "none.fbx", "no such file");
  EXPECT_ERROR(read_mesh(folder.write("a.fbx", "")), "a.fbx", "empty");
  EXPECT_ERROR(read_mesh(folder.write("a.fbx", "rubbish")), "a.fbx", "expected FBX", "open it in Blender", "glTF 2.0");
  EXPECT_ERROR(read_mesh(folder.write("a.dae", "<COLLADA>")), "a.dae", "expected COLLADA");
  EXPECT_ERROR(read_mesh(folder.write("a.smd", "rubbish")), "a.smd", "expected Valve SMD");
  EXPECT_ERROR(read_mesh(folder.write("a.mesh", "rubbish")), "a.mesh", "expected OGRE");
  const std::pair<const char*, std::string> files[] = {{"cut.fbx", strip_fbx()}, {"cut.dae", strip_dae()},
                                                       {"cut.x", strip_x()},     {"cut.md5mesh", strip_md5mesh()},
                                                       {"cut.smd", strip_smd()}, {"cut.mesh.xml", strip_mesh_xml()},
                                                       {"cut.b3d", strip_b3d()}, {"cut.ms3d", strip_ms3d()}};
  for (const auto& [name, whole] : files) {
    // The rarer formats cost a process each, and a second where Assimp hangs.
    const size_t steps = has_extension(name, ".fbx") || has_extension(name, ".dae") ? 40 : 8;
    for (size_t length = 16; length < whole.size(); length += whole.size() / steps) {
      try {
        (void)read_mesh(folder.write(name, whole.substr(0, length)));
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).rfind(folder.file(name), 0), 0u) << error.what();
      }
    }
  }
}

// Assimp's reader never ends in a list of numbers with a character that belongs to none.
TEST(GltfFromScene, AWrongByteInAListOfColladaIsOneLine) {
  const TempFolder folder;
  std::string wrong = strip_dae();
  const size_t list = wrong.find("<p>");
  ASSERT_NE(list, std::string::npos);
  wrong[wrong.find('1', list)] = 'l';
  const auto line =
      std::to_string(1 + std::count(wrong.begin(), wrong.begin() + static_cast<std::ptrdiff_t>(list), '\n'));
  EXPECT_ERROR(read_mesh(folder.write("wrong.dae", wrong)), "wrong.dae:" + line,
               "expected whole numbers in <p>, found 'l'");
  std::string remark = strip_dae();  // what is no list may say anything
  remark.insert(remark.find("<library_geometries"), "<!-- <p>l</p> --><extra><p>a text</p></extra>");
  expect_strip(read_character(folder.write("remark.dae", remark)));
}

#ifdef __linux__

TEST(SceneProcess, EndsWithinItsLimits) {
  const auto fails = [](const SceneLimits& limits, const std::function<SceneBytes()>& convert, const char* wanted) {
    EXPECT_ERROR(convert_in_child("a.fbx", "FBX", limits, convert), "a.fbx: expected FBX", wanted);
  };
  const size_t much = size_t{1} << 30;
  fails(
      {much, 1, 600},
      [] {
        const volatile bool on = true;
        while (on) continue;
        return SceneBytes{};
      },
      "does not finish reading, stopped after 1 s");
  fails(
      {much, 600, 1},
      [] {
        (void)pause();
        return SceneBytes{};
      },
      "does not finish reading, stopped");
  fails(
      {much, 600, 600},
      [] {
        std::abort();
        return SceneBytes{};
      },
      "crashes on");
}

#ifndef SINEW_WITH_ASAN  // which has its own idea of memory

TEST(SceneProcess, GetsNoMoreMemoryThanItMayHave) {
  const SceneLimits limits = {size_t{256} << 20, 600, 600};
  bool refused = false;
  const SceneBytes scene = convert_in_child("a.fbx", "FBX", limits, [&] {
    SceneBytes out;
    try {
      std::vector<std::vector<char>> all;
      for (;;) all.emplace_back(size_t{16} << 20, 'x');
    } catch (const std::bad_alloc&) {
      out.notes.push_back("refused");
    }
    return out;
  });
  for (const std::string& note : scene.notes) refused = refused || note == "refused";
  EXPECT_TRUE(refused);
}

#endif
#endif

#else

TEST(GltfFromScene, WithoutAssimpTheLineSaysWhatToInstall) {
  const TempFolder folder;
  EXPECT_ERROR(read_mesh(folder.write("a.fbx", strip_fbx())), "a.fbx", "libassimp-dev", ".glb");
}

#endif

}  // namespace
}  // namespace sinew
