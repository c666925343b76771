// SPDX-License-Identifier: MIT
// sinew/character.h through libsinew_character alone: for each job the same bytes as the command's with the same input and default
// options, from files and from memory; what a caller may get wrong.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "character_handle.hpp"
#include "cli_fixture.hpp"
#include "make_glb.hpp"
#include "sinew/character.h"
#include "skeleton_of.hpp"

namespace sinew {
namespace {

Handle open_memory(const std::vector<std::string>& paths) {
  const MemoryFiles files(paths);
  sinew_character* character = nullptr;
  EXPECT_EQ(sinew_character_open_files(files.data(), files.count(), &character), SINEW_OK)
      << sinew_character_error(nullptr);
  return Handle(character);
}

sinew_character_arrays view(sinew_character* character) {
  sinew_character_arrays arrays = SINEW_INIT(sinew_character_arrays);
  EXPECT_EQ(sinew_character_view(character, &arrays), SINEW_OK) << sinew_character_error(character);
  return arrays;
}

class CharacterC : public Cli {
 protected:
  void good_call(sinew_status status, const Handle& character) {
    ASSERT_EQ(status, SINEW_OK) << sinew_character_error(character.get());
  }
  void save(const Handle& character, const std::string& name) {
    good_call(sinew_character_save(character.get(), in(name).c_str()), character);
  }
  void expect_same(const std::string& ours, const std::string& commands) {
    const std::string a = slurp(in(ours)), b = slurp(in(commands));
    EXPECT_GT(a.size(), 0u);
    EXPECT_TRUE(a == b) << ours << " has " << a.size() << " bytes, " << commands << " " << b.size();
  }
  std::string written(const Handle& character, const std::string& name, size_t file = 0) {
    const sinew_file* files = nullptr;
    uint32_t count = 0;
    EXPECT_EQ(sinew_character_write(character.get(), name.c_str(), &files, &count), SINEW_OK)
        << sinew_character_error(character.get());
    EXPECT_LT(file, count);
    return file < count ? std::string(static_cast<const char*>(files[file].bytes), files[file].size_bytes) : "";
  }
  void bind(const Handle& character) { good_call(sinew_character_bind(character.get(), nullptr, nullptr), character); }
  // Ten frames in which joints swing, of the robed biped, as swing.bvh.
  void make_swing() {
    const Handle robed = open(kRobed);
    const sinew_character_arrays arrays = view(robed.get());
    const uint32_t joints = arrays.joint_count, frames = 10;
    std::vector<double> rotations, translations;
    for (uint32_t f = 0; f < frames; ++f) {
      for (uint32_t j = 0; j < joints; ++j) {
        const double angle = arrays.parents[j] < 0 ? 0 : 0.02 * f;
        rotations.insert(rotations.end(), {0, 0, std::sin(angle / 2), std::cos(angle / 2)});
        for (uint32_t i = 0; i < 3; ++i) {
          const int parent = arrays.parents[j];
          const float above = parent < 0 ? 0 : arrays.joint_positions[3 * parent + static_cast<int>(i)];
          const double moved = parent < 0 && i == 2 ? 0.02 * f : 0;
          translations.push_back(static_cast<double>(arrays.joint_positions[3 * j + i]) - static_cast<double>(above) +
                                 moved);
        }
      }
    }
    sinew_character_clip clip = SINEW_INIT(sinew_character_clip);
    clip.frame_count = frames;
    clip.joint_count = joints;
    clip.frame_time = 0.05;
    clip.name = "swing";
    clip.rotations = rotations.data();
    clip.translations = translations.data();
    good_call(sinew_character_add_clip(robed.get(), &clip), robed);
    save(robed, "swing.bvh");
  }
};

TEST_F(CharacterC, BindsAsTheCommand) {
  good("bind " + kSnake + " --skeleton " + kSnakeRig + " -o command.glb");
  const Handle snake = open(kSnake);
  sinew_character_bind_result result = SINEW_INIT(sinew_character_bind_result);
  good_call(sinew_character_bind(snake.get(), nullptr, &result), snake);
  save(snake, "ours.glb");
  expect_same("ours.glb", "command.glb");
  EXPECT_EQ(std::string(result.hash).size(), 16u);
  EXPECT_TRUE(written(snake, "ours.glb") == slurp(in("command.glb")));

  good("bind " + kCaped + " -o caped.glb");
  const Handle caped = open(kCaped);
  bind(caped);
  save(caped, "caped_ours.glb");
  expect_same("caped_ours.glb", "caped.glb");

  good("bind " + kCaped + " --method heat --influences 8 --symmetric --joints all --confidence -o heat.glb");
  const Handle heat = open(kCaped);
  sinew_character_bind_options options = SINEW_INIT(sinew_character_bind_options);
  options.method = SINEW_METHOD_HEAT;
  options.influence_count = 8;
  options.symmetric = 1;
  options.joints = SINEW_JOINTS_ALL;
  options.keep_confidence = 1;
  options.thread_count = 3;
  good_call(sinew_character_bind(heat.get(), &options, nullptr), heat);
  save(heat, "heat_ours.glb");
  expect_same("heat_ours.glb", "heat.glb");
}

TEST_F(CharacterC, FilesInMemoryGiveTheSame) {
  good("bind " + kSnake + " --skeleton " + kSnakeRig + " -o snake.glb");
  const Handle snake = open_memory({kSnake, kSnakeRig});
  bind(snake);
  EXPECT_TRUE(written(snake, "snake.glb") == slurp(in("snake.glb")));
  good("bind " + kCaped + " -o caped.gltf");
  const Handle caped = open_memory({kCaped});
  bind(caped);
  EXPECT_TRUE(written(caped, "caped.gltf") == slurp(in("caped.gltf")));
  EXPECT_TRUE(written(caped, "caped.gltf", 1) == slurp(in("caped.bin")));
  EXPECT_EQ(files(), 3u) << "a file in memory was written to the disk";
}

// A cube without a skin that hangs on a joint of another mesh's skin.
TEST_F(CharacterC, MeshesThatHangOnJointsStayThere) {
  GlbBuilder b;
  const std::vector<float> bar = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0};
  const std::vector<uint16_t> faces = {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4};
  const std::vector<uint8_t> joints = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  std::vector<float> weights;
  for (int v = 0; v < 6; ++v) weights.insert(weights.end(), {1, 0, 0, 0});
  const int skinned = b.add("meshes", {{"primitives",
                                        {{{"attributes",
                                           {{"POSITION", b.positions(bar)},
                                            {"JOINTS_0", b.accessor(joints, "VEC4")},
                                            {"WEIGHTS_0", b.accessor(weights, "VEC4")}}},
                                          {"indices", b.accessor(faces, "SCALAR")}}}}});
  const int badge = b.add("meshes", {{"primitives",
                                      {{{"attributes", {{"POSITION", b.positions({0, 0, 1, 1, 0, 1, 0, 1, 1})}}},
                                        {"indices", b.accessor(std::vector<uint16_t>{0, 1, 2}, "SCALAR")}}}}});
  const int hat = b.add("nodes", {{"name", "hat"}, {"mesh", badge}});
  const int head = b.add("nodes", {{"name", "Head"}, {"translation", {0, 1, 0}}, {"children", {hat}}});
  const int hips = b.root({{"name", "Hips"}, {"children", {head}}});
  const std::vector<float> inverse = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
  b.add("skins", {{"joints", {hips, head}}, {"inverseBindMatrices", b.accessor(inverse, "MAT4")}});
  b.root({{"name", "body"}, {"mesh", skinned}, {"skin", 0}});
  put(in("hat.glb"), b.glb());
  good("bind hat.glb -o command.glb");
  const Handle character = open(in("hat.glb"));
  const sinew_character_arrays arrays = view(character.get());
  ASSERT_EQ(arrays.mesh_count, 2u);
  EXPECT_EQ(arrays.mesh_skinned[0] + arrays.mesh_skinned[1], 1);
  const uint32_t plain = arrays.mesh_skinned[0] != 0 ? 1 : 0;
  ASSERT_GE(arrays.mesh_joints[plain], 0);
  EXPECT_STREQ(arrays.joint_names[arrays.mesh_joints[plain]], "Head");
  sinew_character_bind_result result = SINEW_INIT(sinew_character_bind_result);
  good_call(sinew_character_bind(character.get(), nullptr, &result), character);
  EXPECT_EQ(result.kept_meshes, 1u);
  save(character, "ours.glb");
  expect_same("ours.glb", "command.glb");
}

TEST_F(CharacterC, RigsAsTheCommand) {
  good("rig " + kRobed + " -o command.glb");
  const Handle robed = open(kRobed);
  sinew_character_rig_result result = SINEW_INIT(sinew_character_rig_result);
  good_call(sinew_character_rig(robed.get(), nullptr, &result), robed);
  EXPECT_EQ(result.joint_count, view(robed.get()).joint_count);
  save(robed, "ours.glb");
  expect_same("ours.glb", "command.glb");

  good("rig " + kCaped + " --detail full --no-toes --skeleton template:mixamo --influences 2 -o command.rig.txt");
  const Handle caped = open(kCaped);
  sinew_character_rig_options options = SINEW_INIT(sinew_character_rig_options);
  options.detail = SINEW_CHARACTER_DETAIL_FULL;
  options.without = SINEW_WITHOUT_TOES;
  options.skeleton = "template:mixamo";
  sinew_character_bind_options bind = SINEW_INIT(sinew_character_bind_options);
  bind.influence_count = 2;
  options.bind = &bind;
  good_call(sinew_character_rig(caped.get(), &options, nullptr), caped);
  save(caped, "ours.rig.txt");
  expect_same("ours.rig.txt", "command.rig.txt");

  good("rig " + kCaped + " --to-pose t -o posed.glb");
  options = SINEW_INIT(sinew_character_rig_options);
  bind = SINEW_INIT(sinew_character_bind_options);
  bind.to_pose = "t";
  options.bind = &bind;
  const Handle posed = open(kCaped);
  good_call(sinew_character_rig(posed.get(), &options, nullptr), posed);
  save(posed, "posed_ours.glb");
  expect_same("posed_ours.glb", "posed.glb");
  options.without = SINEW_WITHOUT_BIND;
  EXPECT_NE(sinew_character_rig(posed.get(), &options, nullptr), SINEW_OK);

  good("rig " + kRobed + " --method shape --no-bind --no-mirror -o shape.rig.txt");
  options = SINEW_INIT(sinew_character_rig_options);
  options.method = SINEW_CHARACTER_RIG_SHAPE;
  options.without = SINEW_WITHOUT_BIND;
  options.mirror = SINEW_MIRROR_NEVER;
  good_call(sinew_character_rig(robed.get(), &options, nullptr), robed);
  save(robed, "shape_ours.rig.txt");
  expect_same("shape_ours.rig.txt", "shape.rig.txt");
}

TEST_F(CharacterC, MapsAsTheCommand) {
  good("map " + kCaped + " --to mixamo -o command.map");
  const Handle caped = open(kCaped), robed = open(kRobed);
  sinew_character_map_result result = SINEW_INIT(sinew_character_map_result);
  sinew_motion_source source = SINEW_INIT(sinew_motion_source);
  source.file = "template:mixamo";
  sinew_character_map_options options = SINEW_INIT(sinew_character_map_options);
  options.source = &source;
  good_call(sinew_character_map(caped.get(), nullptr, &options, &result), caped);
  EXPECT_EQ(result.text, slurp(in("command.map")));
  good("map " + kCaped + " --from " + kRobed + " -o other.map");
  good_call(sinew_character_map(caped.get(), robed.get(), nullptr, &result), caped);
  EXPECT_EQ(result.text, slurp(in("other.map")));
  EXPECT_GT(result.mapped, 5u);
  EXPECT_EQ(sinew_character_map(caped.get(), nullptr, nullptr, &result), SINEW_ERROR_ARGUMENT);
}

TEST_F(CharacterC, AnimatesAsTheCommand) {
  make_swing();
  good("animate " + kRobed + " --motion swing.bvh -o command.glb");
  const Handle robed = open(kRobed), swing = open(in("swing.bvh"));
  uint32_t clips = 0;
  good_call(sinew_character_clip_count(swing.get(), &clips), swing);
  EXPECT_EQ(clips, 1u);
  sinew_character_animate_result result = SINEW_INIT(sinew_character_animate_result);
  good_call(sinew_character_animate(robed.get(), swing.get(), nullptr, &result), robed);
  EXPECT_EQ(result.clip_count, 1u);
  save(robed, "ours.glb");
  expect_same("ours.glb", "command.glb");
  sinew_character_clip clip = SINEW_INIT(sinew_character_clip);
  good_call(sinew_character_get_clip(robed.get(), result.first_clip, &clip), robed);
  EXPECT_EQ(clip.frame_count, 10u);
  EXPECT_STREQ(clip.name, "swing");

  // A bare mesh is rigged first; from memory.
  put(in("bare.obj"), slurp(kRobed));
  good(
      "animate bare.obj --motion swing.bvh --in-place --arm-spread 20 --deform volume --cells 16 --shapes 2 -o "
      "bare.glb");
  const Handle bare = open_memory({in("bare.obj")}), memory = open_memory({in("swing.bvh")});
  sinew_character_animate_options options = SINEW_INIT(sinew_character_animate_options);
  options.in_place = 1;
  options.arm_spread = 20;
  sinew_character_deformation deform = SINEW_INIT(sinew_character_deformation);
  deform.method = SINEW_POSE_VOLUME;
  deform.cells = 16;
  options.deform = &deform;
  options.shapes = 2;
  good_call(sinew_character_animate(bare.get(), memory.get(), &options, &result), bare);
  EXPECT_EQ(result.rigged, 1u);
  save(bare, "bare_ours.glb");
  expect_same("bare_ours.glb", "bare.glb");
}

TEST_F(CharacterC, TellsHowAMotionFits) {
  make_swing();
  const Handle robed = open(kRobed), swing = open(in("swing.bvh"));
  sinew_map_pin pin = {0, -1};
  sinew_character_animate_options options = SINEW_INIT(sinew_character_animate_options);
  options.report = options.force = options.pin_count = 1;
  options.pins = &pin;
  sinew_character_animate_result result = SINEW_INIT(sinew_character_animate_result);
  good_call(sinew_character_animate(robed.get(), swing.get(), &options, &result), robed);
  EXPECT_EQ(result.sources[0], -1);
  EXPECT_EQ(result.reasons[0], SINEW_MAP_PINNED);
  EXPECT_EQ(result.spot_count, 10 * result.limb_count);
  EXPECT_EQ(std::count(result.source_names, result.source_names + std::strlen(result.source_names), '\n') + 1,
            static_cast<std::ptrdiff_t>(result.source_count));
  pin.target = 9999;
  EXPECT_EQ(sinew_character_animate(robed.get(), swing.get(), &options, &result), SINEW_ERROR_RANGE);
  options.pin_count = 0;
  options.arm_spread = 91;
  EXPECT_EQ(sinew_character_animate(robed.get(), swing.get(), &options, &result), SINEW_ERROR_ARGUMENT);
}

TEST_F(CharacterC, AnimatesByAFileAndAPartOfIt) {
  make_swing();
  good("animate " + kRobed +
       " --motion swing.bvh --start 0.1 --end 0.3 --method reference-points --legs -o command.glb");
  const Handle robed = open(kRobed);
  const std::string file = in("swing.bvh");
  sinew_motion_source motion = SINEW_INIT(sinew_motion_source);
  motion.file = file.c_str();
  motion.from = 0.1;
  motion.to = 0.3;
  sinew_reference_options reference = SINEW_INIT(sinew_reference_options);
  reference.legs = 1;
  sinew_character_animate_options options = SINEW_INIT(sinew_character_animate_options);
  EXPECT_EQ(sinew_character_animate(robed.get(), nullptr, &options, nullptr), SINEW_ERROR_ARGUMENT);
  options.motion = &motion;
  options.method = SINEW_ANIMATE_REFERENCE_POINTS;
  options.reference = &reference;
  good_call(sinew_character_animate(robed.get(), nullptr, &options, nullptr), robed);
  save(robed, "ours.glb");
  expect_same("ours.glb", "command.glb");
}

TEST_F(CharacterC, EditsAsTheCommand) {
  good("rig " + kRobed + " --no-bind --rename Head=Skull --add Hat=Skull:0,2,0 --move Hat=0,2.5,0 --parent Hat=Neck" +
       " --remove LeftHand --at LeftHand=0.8,1.2,0 -o command.rig.txt");
  sinew_skeleton_edit edits[] = {{SINEW_EDIT_RENAME, 0, "Head", "Skull", {}, 0},
                                 {SINEW_EDIT_ADD, 0, "Hat", "Skull", {0, 2, 0}, 0},
                                 {SINEW_EDIT_MOVE, 0, "Hat", nullptr, {0, 2.5f, 0}, 0},
                                 {SINEW_EDIT_PARENT, 0, "Hat", "Neck", {}, 0},
                                 {SINEW_EDIT_REMOVE, 0, "LeftHand", nullptr, {}, 0},
                                 {SINEW_EDIT_AT, 0, "LeftHand", nullptr, {0.8f, 1.2f, 0}, 0}};
  const Handle robed = open(kRobed);
  sinew_character_rig_options options = SINEW_INIT(sinew_character_rig_options);
  options.without = SINEW_WITHOUT_BIND;
  options.edits = edits;
  options.edit_count = 6;
  good_call(sinew_character_rig(robed.get(), &options, nullptr), robed);
  save(robed, "ours.rig.txt");
  expect_same("ours.rig.txt", "command.rig.txt");
  edits[2].position[1] = NAN;
  EXPECT_EQ(sinew_character_rig(robed.get(), &options, nullptr), SINEW_ERROR_NOT_FINITE);
  edits[1].other = nullptr;
  EXPECT_EQ(sinew_character_rig(robed.get(), &options, nullptr), SINEW_ERROR_ARGUMENT);
}

TEST_F(CharacterC, PosesAsTheCommand) {
  const Handle caped = open(kCaped);
  const sinew_character_arrays arrays = view(caped.get());
  std::vector<double> angles(3 * size_t{arrays.joint_count}, 0);
  const uint32_t turned = arrays.joint_count / 2;
  angles[3 * turned + 2] = -40;
  angles[3 * turned] = 15;
  const std::string joint = std::string(" --joint '") + arrays.joint_names[turned] + "=15,0,-40' ";
  const std::pair<const char*, uint32_t> methods[] = {{"linear", SINEW_POSE_LINEAR},
                                                      {"dual-quaternion", SINEW_POSE_DUAL_QUATERNION},
                                                      {"volume", SINEW_POSE_VOLUME},
                                                      {"xpbd", SINEW_POSE_XPBD},
                                                      {"delta-mush", SINEW_POSE_DELTA_MUSH}};
  for (const auto& [name, method] : methods) {
    good("pose " + kCaped + joint + "--deform " + name + " -o command.obj");
    sinew_character_pose_options options = SINEW_INIT(sinew_character_pose_options);
    options.angles = angles.data();
    sinew_character_deformation deform = SINEW_INIT(sinew_character_deformation);
    deform.method = method;
    options.deform = &deform;
    sinew_character* posed = nullptr;
    good_call(sinew_character_pose(caped.get(), &options, &posed), caped);
    const Handle owner(posed);
    EXPECT_TRUE(written(owner, "ours.obj") == slurp(in("command.obj"))) << name;
  }
}

TEST_F(CharacterC, PublishedMethodsAsTheCommand) {
  const Handle robed = open(kRobed), caped = open(kCaped);
  good("rig " + kRobed + " --method slots --class biped --no-bind -o command.rig.txt");
  sinew_character_rig_options rig = SINEW_INIT(sinew_character_rig_options);
  rig.method = SINEW_CHARACTER_RIG_SLOTS;
  rig.category = SINEW_CATEGORY_BIPED;
  rig.without = SINEW_WITHOUT_BIND;
  good_call(sinew_character_rig(robed.get(), &rig, nullptr), robed);
  save(robed, "ours.rig.txt");
  expect_same("ours.rig.txt", "command.rig.txt");

  // A pair whose map is another one by each of these.
  const std::string spider = kData + "/many-legged__plated.obj", quadruped = kData + "/quadruped__tailed.obj";
  const Handle target = open(spider), source = open(quadruped);
  sinew_character_map_result mapped = SINEW_INIT(sinew_character_map_result);
  for (const auto& [words, first, cost] :
       {std::tuple("--first source --cost sum", SINEW_BRANCHES_SOURCE, SINEW_BRANCHES_SUM),
        std::tuple("--first target --cost mean", SINEW_BRANCHES_TARGET, SINEW_BRANCHES_MEAN)}) {
    good("map " + spider + " --from " + quadruped + " --no-names --method branches " + words + " -o command.map");
    sinew_character_map_options map = SINEW_INIT(sinew_character_map_options);
    map.method = SINEW_MAP_BRANCHES;
    map.without = SINEW_WITHOUT_NAMES;
    map.branches_first = static_cast<uint32_t>(first);
    map.branches_cost = static_cast<uint32_t>(cost);
    good_call(sinew_character_map(target.get(), source.get(), &map, &mapped), target);
    EXPECT_EQ(mapped.text, slurp(in("command.map"))) << words;
  }

  std::vector<double> angles(3 * size_t{view(caped.get()).joint_count}, 20);
  sinew_character_pose_options pose = SINEW_INIT(sinew_character_pose_options);
  pose.angles = angles.data();
  sinew_character_deformation deform = SINEW_INIT(sinew_character_deformation);
  deform.method = SINEW_POSE_XPBD;
  deform.cells = 16;
  deform.stiffness = 0.003;
  deform.tet_weights = SINEW_TET_WEIGHTS_DISTANCE;
  deform.without = SINEW_WITHOUT_SMOOTHING;
  pose.deform = &deform;
  std::string joints;
  for (uint32_t j = 0; j < view(caped.get()).joint_count; ++j)
    joints += std::string(" --joint '") + view(caped.get()).joint_names[j] + "=20,20,20'";
  good("pose " + kCaped + joints +
       " --deform xpbd --cells 16 --stiffness 0.003 --tet-weights distance --no-smoothing -o command.obj");
  sinew_character* posed = nullptr;
  good_call(sinew_character_pose(caped.get(), &pose, &posed), caped);
  const std::string ours = written(Handle(posed), "ours.obj");
  EXPECT_TRUE(ours == slurp(in("command.obj")));
  good("pose " + kCaped + joints + " --deform xpbd --cells 16 --as-drawn -o drawn.obj");
  deform.stiffness = 0;
  deform.tet_weights = 0;
  deform.without = 0;
  deform.deform_as_drawn = 1;
  good_call(sinew_character_pose(caped.get(), &pose, &posed), caped);
  EXPECT_TRUE(written(Handle(posed), "ours.obj") == slurp(in("drawn.obj")));
  EXPECT_NE(slurp(in("drawn.obj")), ours);
}

// What only one method takes is refused by the others, in place of being left out.
TEST_F(CharacterC, RefusesWhatAnotherMethodTakes) {
  const Handle caped = open(kCaped), source = open(kRobed);
  const auto refused = [&](sinew_status status, const std::string& beginning) {
    EXPECT_EQ(status, SINEW_ERROR_ARGUMENT);
    EXPECT_EQ(std::string(sinew_character_error(caped.get())).rfind(beginning, 0), 0u)
        << sinew_character_error(caped.get());
  };
  sinew_character_rig_options rig = SINEW_INIT(sinew_character_rig_options);
  rig.category = SINEW_CATEGORY_BIRD;
  rig.method = SINEW_CHARACTER_RIG_SHAPE;
  refused(sinew_character_rig(caped.get(), &rig, nullptr), "category: ");
  rig.method = SINEW_CHARACTER_RIG_SLOTS + 1;
  refused(sinew_character_rig(caped.get(), &rig, nullptr), "method: ");
  sinew_character_map_options map = SINEW_INIT(sinew_character_map_options);
  sinew_character_map_result mapped = SINEW_INIT(sinew_character_map_result);
  map.branches_cost = SINEW_BRANCHES_SUM;
  refused(sinew_character_map(caped.get(), source.get(), &map, &mapped), "branches_first and branches_cost need");
  map.method = SINEW_MAP_BRANCHES;
  map.branches_first = SINEW_BRANCHES_SOURCE + 1;
  refused(sinew_character_map(caped.get(), source.get(), &map, &mapped), "branches_first: ");
  std::vector<double> angles(3 * size_t{view(caped.get()).joint_count}, 0);
  sinew_character_pose_options pose = SINEW_INIT(sinew_character_pose_options);
  sinew_character* posed = nullptr;
  pose.angles = angles.data();
  sinew_character_deformation deform = SINEW_INIT(sinew_character_deformation);
  deform.method = SINEW_POSE_VOLUME;
  deform.stiffness = 0.2;
  pose.deform = &deform;
  refused(sinew_character_pose(caped.get(), &pose, &posed),
          "stiffness, tet_weights, deform_as_drawn and SINEW_WITHOUT_SMOOTHING need");
  deform.without = SINEW_WITHOUT_TOES;
  refused(sinew_character_pose(caped.get(), &pose, &posed), "without: ");
  deform = SINEW_INIT(sinew_character_deformation);
  deform.method = SINEW_POSE_XPBD;
  for (const double wrong : {1001.0, 0.0001, -1.0}) {
    deform.stiffness = wrong;
    refused(sinew_character_pose(caped.get(), &pose, &posed), "stiffness: ");
  }
}

TEST_F(CharacterC, TransfersAsTheCommand) {
  good("transfer " + kCaped + " " + kRobed + " -o command.glb");
  const Handle source = open(kCaped), target = open(kRobed);
  sinew_character_transfer_result result = SINEW_INIT(sinew_character_transfer_result);
  good_call(sinew_character_transfer(source.get(), target.get(), nullptr, &result), target);
  EXPECT_GT(result.part_count, 0u);
  save(target, "ours.glb");
  expect_same("ours.glb", "command.glb");
  // A target without a skeleton gets the source's.
  put(in("bare.obj"), slurp(kRobed));
  good("transfer " + kCaped + " bare.obj -o bare.glb");
  const Handle bare = open(in("bare.obj"));
  good_call(sinew_character_transfer(source.get(), bare.get(), nullptr, &result), bare);
  EXPECT_EQ(result.fitted, 1u);
  save(bare, "bare_ours.glb");
  expect_same("bare_ours.glb", "bare.glb");
}

TEST_F(CharacterC, SimplifiesAndBakesAsTheCommand) {
  good("simplify " + kCaped + " --level low -o command.glb");
  const Handle caped = open(kCaped);
  sinew_character_simplify_options options = SINEW_INIT(sinew_character_simplify_options);
  options.low = 1;
  std::vector<uint32_t> into(view(caped.get()).joint_count);
  good_call(sinew_character_simplify(caped.get(), &options, into.data()), caped);
  EXPECT_LT(view(caped.get()).joint_count, into.size());
  save(caped, "ours.glb");
  expect_same("ours.glb", "command.glb");

  good("bake " + kSnake + " --poses 40 --shapes 2 --cells 16 -o baked.glb");
  const Handle snake = open(kSnake);
  sinew_character_bake_options bake = SINEW_INIT(sinew_character_bake_options);
  bake.poses = 40;
  bake.shapes = 2;
  sinew_character_deformation deform = SINEW_INIT(sinew_character_deformation);
  deform.cells = 16;
  bake.deform = &deform;
  sinew_character_bake_result result = SINEW_INIT(sinew_character_bake_result);
  good_call(sinew_character_bake(snake.get(), &bake, &result), snake);
  EXPECT_LT(result.baked_error, result.linear_error);
  save(snake, "baked_ours.glb");
  expect_same("baked_ours.glb", "baked.glb");
}

TEST_F(CharacterC, FindsWhatSwingsAsTheCommand) {
  good("springs " + kRobed + " --value tail_1:drag=0.5 -o command.glb");
  good("animate " + kRobed + " --motion builtin:run --springs -o running.glb");
  const Handle robed = open(kRobed), other = open(kRobed);
  const char* const values[] = {"tail_1:drag=0.5"};
  sinew_character_springs_options options = SINEW_INIT(sinew_character_springs_options);
  options.values = values;
  options.value_count = 1;
  sinew_character_springs_result result = SINEW_INIT(sinew_character_springs_result);
  good_call(sinew_character_springs(robed.get(), &options, &result), robed);
  EXPECT_EQ(result.chain_count, 1u);
  EXPECT_EQ(result.joint_count, 3u);
  EXPECT_GT(result.collider_count, 3u);
  ASSERT_EQ(result.proposal_count, 1u);
  EXPECT_EQ(result.kept[0], 1);
  EXPECT_GT(result.certainties[0], 0.9f);
  EXPECT_STREQ(result.names, "tail_1");
  EXPECT_STREQ(result.kinds, "tail");
  save(robed, "ours.glb");
  expect_same("ours.glb", "command.glb");

  sinew_character_animate_options animate = SINEW_INIT(sinew_character_animate_options);
  sinew_motion_source run = SINEW_INIT(sinew_motion_source);
  run.file = "builtin:run";
  animate.motion = &run;
  animate.springs = 1;
  good_call(sinew_character_animate(other.get(), nullptr, &animate, nullptr), other);
  save(other, "running_ours.glb");
  expect_same("running_ours.glb", "running.glb");
  good("animate " + kRobed + " --motion builtin:run --springs -o running.vrma");
  save(other, "ours.vrma");
  expect_same("ours.vrma", "running.vrma");
  // With the springs that were found before; a name that no chain has changes nothing.
  good_call(sinew_character_animate(robed.get(), nullptr, &animate, nullptr), robed);
  const char* const nobody[] = {"nobody"};
  options.drop = nobody;
  options.drop_count = 1;
  EXPECT_EQ(sinew_character_springs(robed.get(), &options, &result), SINEW_ERROR_INPUT);
  EXPECT_NE(std::string(sinew_character_error(robed.get())).find("nobody"), std::string::npos);
}

// Rounds of a clip, frame by frame, come to what is baked into the clip as a loop.
TEST_F(CharacterC, SpringsOfFramesAreThoseOfClips) {
  const Handle still = open(kRobed), swung = open(kRobed);
  sinew_character_animate_options animate = SINEW_INIT(sinew_character_animate_options);
  sinew_motion_source run = SINEW_INIT(sinew_motion_source);
  run.file = "builtin:idle";
  animate.motion = &run;
  good_call(sinew_character_animate(still.get(), nullptr, &animate, nullptr), still);
  animate.springs = 1;
  good_call(sinew_character_animate(swung.get(), nullptr, &animate, nullptr), swung);
  sinew_character_clip clip = SINEW_INIT(sinew_character_clip), baked = SINEW_INIT(sinew_character_clip);
  good_call(sinew_character_get_clip(still.get(), 0, &clip), still);
  good_call(sinew_character_get_clip(swung.get(), 0, &baked), swung);
  const size_t joints = clip.joint_count, frames = clip.frame_count;
  ASSERT_EQ(baked.frame_count, frames);
  const auto play = [&](size_t rounds) {
    double farthest = 0, moved = 0;
    std::vector<float> rotations(4 * joints), translations(3 * joints), out(4 * joints);
    for (size_t f = 0; f + 1 < frames * rounds; ++f) {
      const size_t k = f < frames ? f : 1 + (f - 1) % (frames - 1);
      for (size_t i = 0; i < 4 * joints; ++i) rotations[i] = static_cast<float>(clip.rotations[4 * joints * k + i]);
      for (size_t i = 0; i < 3 * joints; ++i)
        translations[i] = static_cast<float>(clip.translations[3 * joints * k + i]);
      good_call(sinew_character_springs_frame(still.get(), f == 0 ? 0 : static_cast<float>(clip.frame_time),
                                              rotations.data(), translations.data(), out.data()),
                still);
      if (f < frames * (rounds - 1)) continue;
      for (size_t i = 0; i < 4 * joints; ++i) {
        farthest = std::max(farthest, std::abs(static_cast<double>(out[i]) - baked.rotations[4 * joints * k + i]));
        moved = std::max(moved, std::abs(static_cast<double>(out[i] - rotations[i])));
      }
    }
    EXPECT_GT(moved, 1e-3);
    return farthest;
  };
  EXPECT_LT(play(6), 2e-3);
  good_call(sinew_character_springs_restart(still.get()), still);
  EXPECT_LT(play(6), 2e-3);
  float pose[4] = {};
  EXPECT_EQ(sinew_character_springs_frame(still.get(), -1, pose, pose, pose), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_character_springs_frame(still.get(), 0, nullptr, pose, pose), SINEW_ERROR_ARGUMENT);
  const Handle caped = open(kCaped);
  sinew_character_springs_options make = SINEW_INIT(sinew_character_springs_options);
  make.make = 1;
  sinew_character_springs_result made = SINEW_INIT(sinew_character_springs_result);
  const uint32_t before = view(caped.get()).joint_count;
  good_call(sinew_character_springs(caped.get(), &make, &made), caped);
  EXPECT_EQ(view(caped.get()).joint_count, before + 3 * (12 + 4));  // lines of a skirt and of a cape
  save(caped, "made.glb");
  good("springs " + kCaped + " --make -o command_made.glb");
  expect_same("made.glb", "command_made.glb");
}

TEST_F(CharacterC, ArraysInAreArraysOut) {
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, joints[] = {0, 0, 0, 0, 1, 0};
  const uint32_t faces[] = {0, 1, 2, 1, 3, 2};
  const int32_t parents[] = {-1, 0};
  const char* names[] = {"Hips", "Head"};
  const sinew_mesh mesh = {positions, 4, nullptr, faces, 2, 6};
  sinew_skeleton skeleton = sinew_test::skeleton_of(joints, parents, 2);
  skeleton.names = names;
  sinew_character* made = nullptr;
  ASSERT_EQ(sinew_character_create(&mesh, &skeleton, &made), SINEW_OK) << sinew_character_error(nullptr);
  const Handle character(made);
  const uint32_t offsets[] = {0, 1, 2, 4, 5}, indices[] = {0, 0, 0, 1, 1};
  const float weights[] = {1, 1, 0.25f, 0.75f, 1};
  good_call(sinew_character_set_weights(made, offsets, indices, weights), character);
  const sinew_character_arrays arrays = view(made);
  EXPECT_EQ(arrays.vertex_count, 4u);
  EXPECT_EQ(std::memcmp(arrays.positions, positions, sizeof positions), 0);
  EXPECT_EQ(std::memcmp(arrays.face_vertices, faces, sizeof faces), 0);
  EXPECT_STREQ(arrays.joint_names[1], "Head");
  EXPECT_EQ(arrays.influence_count, 2u);
  EXPECT_EQ(arrays.joint_indices[2], 1u) << "rows fall";
  uint16_t rows[8], shares[8];
  good_call(sinew_character_skin(made, 2, rows, shares), character);
  EXPECT_EQ(shares[4] + shares[5], 65535);
  EXPECT_EQ(rows[4], 1);
  bind(character);
  const Handle again = [&] {
    const std::string bytes = written(character, "made.glb");
    const sinew_file file = {"made.glb", bytes.data(), bytes.size()};
    sinew_character* read = nullptr;
    EXPECT_EQ(sinew_character_open_files(&file, 1, &read), SINEW_OK) << sinew_character_error(nullptr);
    return Handle(read);
  }();
  EXPECT_EQ(view(again.get()).joint_count, 2u);
}

TEST_F(CharacterC, WhatIsWrongIsSaidInOneLineAndChangesNothing) {
  const auto refused = [&](sinew_status wanted, sinew_status status, const sinew_character* of, const char* word) {
    EXPECT_EQ(status, wanted) << sinew_character_error(of);
    const std::string line = sinew_character_error(of);
    EXPECT_NE(line.find(word), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  };
  sinew_character* none = nullptr;
  const auto open_refused = [&](const std::string& path, const char* word) {
    refused(SINEW_ERROR_INPUT, sinew_character_open(path.c_str(), &none), nullptr, word);
    EXPECT_EQ(none, nullptr);
  };
  put(in("empty.glb"), "");
  put(in("cut.gltf"), slurp(kCaped).substr(0, 1000));
  put(in("nan.obj"), "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  fs::create_directory(in("folder.glb"));
  open_refused(in("missing.glb"), "no such file");
  open_refused(in("empty.glb"), "empty");
  open_refused(in("cut.gltf"), "does not parse");
  open_refused(in("nan.obj"), "nan");
  open_refused(in("folder.glb"), "directory");
  open_refused(in("hero.xyz"), "expected a mesh (.obj, ");
  refused(SINEW_ERROR_ARGUMENT, sinew_character_open(nullptr, &none), nullptr, "path");
  refused(SINEW_ERROR_ARGUMENT, sinew_character_open("x.glb", nullptr), nullptr, "character");
  refused(SINEW_ERROR_ARGUMENT, sinew_character_bind(nullptr, nullptr, nullptr), nullptr, "null");
  const std::string document = R"({"asset":{"version":"2.0"},"buffers":[{"uri":"/etc/passwd","byteLength":1}]})";
  const sinew_file outside = {"a.gltf", document.data(), document.size()};
  refused(SINEW_ERROR_INPUT, sinew_character_open_files(&outside, 1, &none), nullptr, "a.gltf");

  const Handle snake = open(kSnake);
  const std::string before = written(snake, "snake.glb");
  refused(SINEW_ERROR_INPUT, sinew_character_save(snake.get(), in("none/x.glb").c_str()), snake.get(), "none");
  refused(SINEW_ERROR_INPUT, sinew_character_save(snake.get(), in("x.dae").c_str()), snake.get(), "cannot write");
  refused(SINEW_ERROR_INPUT, sinew_character_save(snake.get(), in("x.bvh").c_str()), snake.get(), "one clip");
  sinew_character_bind_options options = {};
  refused(SINEW_ERROR_ARGUMENT, sinew_character_bind(snake.get(), &options, nullptr), snake.get(), "struct_size");
  struct {
    sinew_character_bind_options known;
    uint64_t later;
  } newer = {SINEW_INIT(sinew_character_bind_options), 0};
  newer.known.struct_size = sizeof newer;
  good_call(sinew_character_bind(snake.get(), &newer.known, nullptr), snake);
  const std::string bound = written(snake, "snake.glb");
  newer.later = 1;
  refused(SINEW_ERROR_VERSION, sinew_character_bind(snake.get(), &newer.known, nullptr), snake.get(),
          "update the library");
  options = SINEW_INIT(sinew_character_bind_options);
  options.influence_count = 13;
  refused(SINEW_ERROR_ARGUMENT, sinew_character_bind(snake.get(), &options, nullptr), snake.get(), "influence_count");
  options = SINEW_INIT(sinew_character_bind_options);
  options.progress = [](void*, uint32_t) { return 1; };
  refused(SINEW_ERROR_CANCELLED, sinew_character_bind(snake.get(), &options, nullptr), snake.get(), "");
  sinew_character_models models = SINEW_INIT(sinew_character_models);
  models.bind = "nonsense";
  models.bind_size = 8;
  options = SINEW_INIT(sinew_character_bind_options);
  options.models = &models;
  refused(SINEW_ERROR_INPUT, sinew_character_bind(snake.get(), &options, nullptr), snake.get(), "the model");
  EXPECT_EQ(written(snake, "snake.glb"), bound) << "a call that failed changed the character";
  EXPECT_NE(before, "");
  const float positions[] = {0, 0, NAN};
  const sinew_mesh mesh = {positions, 1, nullptr, nullptr, 0, 0};
  refused(SINEW_ERROR_NOT_FINITE, sinew_character_create(&mesh, nullptr, &none), nullptr, "finite");
  EXPECT_EQ(none, nullptr);
}

TEST_F(CharacterC, ControlsAndTransformsAsTheCommand) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " --turn y --turn -x --height 2 --floor -o transformed.glb");
  const Handle robed = open(kRobed);
  sinew_character_transform_options transform = SINEW_INIT(sinew_character_transform_options);
  const char* turns[] = {"y", "-x"};
  transform.turns = turns;
  transform.turn_count = 2;
  transform.height = 2;
  transform.floor = 1;
  good_call(sinew_character_transform(robed.get(), &transform), robed);
  bind(robed);
  save(robed, "ours.glb");
  expect_same("ours.glb", "transformed.glb");
  turns[1] = "w";
  EXPECT_EQ(sinew_character_transform(robed.get(), &transform), SINEW_ERROR_INPUT);
  EXPECT_NE(std::string(sinew_character_error(robed.get())).find("expected x, y, z"), std::string::npos);
  save(robed, "after.glb");
  expect_same("after.glb", "transformed.glb");

  good("bind " + kRobed + " --skeleton " + kRobedRig +
       " --for mixamo --to-pose none -o command.glb --controls command.controls.json");
  const Handle again = open(kRobed);
  bind(again);
  sinew_character_profile_options profile = SINEW_INIT(sinew_character_profile_options);
  profile.profile = "mixamo";
  profile.controls = 1;
  good_call(sinew_character_set_profile(again.get(), &profile), again);
  const char* text = nullptr;
  good_call(sinew_character_controls(again.get(), &text), again);
  EXPECT_EQ(std::string(text), slurp(in("command.controls.json")));
  save(again, "controlled.glb");
  expect_same("controlled.glb", "command.glb");
  const float point[] = {0, 0, 0};
  const sinew_mesh mesh = {point, 1, nullptr, nullptr, 0, 0};
  sinew_character* none = nullptr;
  ASSERT_EQ(sinew_character_create(&mesh, nullptr, &none), SINEW_OK);
  const Handle alone(none);
  EXPECT_EQ(sinew_character_controls(alone.get(), &text), SINEW_ERROR_INPUT);
}

TEST_F(CharacterC, LevelsAndScoreAsTheCommand) {
  good("lod " + kCaped + " --levels 2 --fewer-joints -o far.glb");
  const Handle caped = open(kCaped);
  sinew_character_lod_options options = SINEW_INIT(sinew_character_lod_options);
  options.level_count = 2;
  options.fewer_joints = 1;
  sinew_character* levels[2] = {};
  sinew_character_lod_level figures[2] = {};
  good_call(sinew_character_lod(caped.get(), &options, levels, figures), caped);
  const Handle first(levels[0]), second(levels[1]);
  EXPECT_LT(figures[1].triangle_count, figures[0].triangle_count);
  EXPECT_GE(figures[0].posed_error, figures[0].rest_error);
  save(first, "first.glb");
  save(second, "second.glb");
  expect_same("first.glb", "far.lod1.glb");
  expect_same("second.glb", "far.lod2.glb");
  options.ratio = 1.5;
  sinew_character* untouched = nullptr;
  EXPECT_EQ(sinew_character_lod(caped.get(), &options, &untouched, nullptr), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(untouched, nullptr);

  const auto told = nlohmann::json::parse(good("check " + kCaped + " --no-poses --score --json").out);
  sinew_character_check_options check = SINEW_INIT(sinew_character_check_options);
  sinew_character_check_result result = SINEW_INIT(sinew_character_check_result);
  check.without = SINEW_WITHOUT_POSES;
  good_call(sinew_character_check(caped.get(), &check, &result), caped);
  EXPECT_EQ(result.score, -1);
  check.score = 1;
  good_call(sinew_character_check(caped.get(), &check, &result), caped);
  EXPECT_NEAR(result.score, told["score"].get<double>(), 0.051);
  EXPECT_GT(result.score, 10);
}

// A person in T pose, front +z: the joints of humanml3d22.
std::vector<float> t_pose() {
  return {0,    0.95f, 0, 0.1f,  0.9f, 0, -0.1f,  0.9f, 0, 0,      1.05f, 0, 0.1f, 0.5f,  0,    -0.1f, 0.5f,  0,
          0,    1.2f,  0, 0.1f,  0.1f, 0, -0.1f,  0.1f, 0, 0,      1.3f,  0, 0.1f, 0.02f, 0.1f, -0.1f, 0.02f, 0.1f,
          0,    1.5f,  0, 0.06f, 1.4f, 0, -0.06f, 1.4f, 0, 0,      1.6f,  0, 0.2f, 1.4f,  0,    -0.2f, 1.4f,  0,
          0.5f, 1.4f,  0, -0.5f, 1.4f, 0, 0.75f,  1.4f, 0, -0.75f, 1.4f,  0};
}

TEST_F(CharacterC, KeypointsAloneAreAMotionAndThenFramesOfAStream) {
  constexpr uint32_t kKeypoints = 22, kLeftHand = 20;
  std::vector<float> keypoints = t_pose(), up = keypoints;
  up[3 * 18] = up[3 * 20] = 0.2f;  // the left arm points up
  up[3 * 18 + 1] = 1.7f;
  up[3 * 20 + 1] = 1.95f;
  for (size_t x = 0; x < up.size(); x += 3)
    up[x] += 0.01f;  // hips that never move stand for keypoints relative to them
  keypoints.insert(keypoints.end(), up.begin(), up.end());
  sinew_character* opened = nullptr;
  ASSERT_EQ(sinew_character_open_keypoints("humanml3d22", keypoints.data(), kKeypoints, 2, &opened), SINEW_OK)
      << sinew_character_error(nullptr);
  const Handle person(opened);
  sinew_character_arrays arrays = SINEW_INIT(sinew_character_arrays);
  good_call(sinew_character_view(person.get(), &arrays), person);
  ASSERT_EQ(arrays.joint_count, kKeypoints);
  uint32_t clips = 0;
  good_call(sinew_character_clip_count(person.get(), &clips), person);
  EXPECT_EQ(clips, 1u);
  const Handle copy = [&] {
    sinew_character* made = nullptr;
    good_call(sinew_character_copy(person.get(), &made), person);
    return Handle(made);
  }();
  std::vector<float> rotations(4 * kKeypoints), translations(3 * kKeypoints);
  good_call(sinew_character_keypoints_frame(copy.get(), up.data(), kKeypoints, rotations.data(), translations.data()),
            copy);
  // Where they put the hand.
  const auto hand_height = [&] {
    float height = 0;
    std::vector<std::array<float, 4>> turns(kKeypoints);
    std::vector<std::array<float, 3>> at(kKeypoints);
    for (uint32_t j = 0; j < kKeypoints; ++j) {
      const int parent = arrays.parents[j];
      const float* q = &rotations[4 * j];
      const float* t = &translations[3 * j];
      if (parent < 0) {
        turns[j] = {q[0], q[1], q[2], q[3]};
        at[j] = {t[0], t[1], t[2]};
        continue;
      }
      const auto& a = turns[static_cast<size_t>(parent)];
      turns[j] = {
          a[3] * q[0] + a[0] * q[3] + a[1] * q[2] - a[2] * q[1], a[3] * q[1] - a[0] * q[2] + a[1] * q[3] + a[2] * q[0],
          a[3] * q[2] + a[0] * q[1] - a[1] * q[0] + a[2] * q[3], a[3] * q[3] - a[0] * q[0] - a[1] * q[1] - a[2] * q[2]};
      const std::array<float, 3> u = {a[1] * t[2] - a[2] * t[1] + a[3] * t[0], a[2] * t[0] - a[0] * t[2] + a[3] * t[1],
                                      a[0] * t[1] - a[1] * t[0] + a[3] * t[2]};
      at[j] = {t[0] + 2 * (a[1] * u[2] - a[2] * u[1]), t[1] + 2 * (a[2] * u[0] - a[0] * u[2]),
               t[2] + 2 * (a[0] * u[1] - a[1] * u[0])};
      for (size_t i = 0; i < 3; ++i) at[j][i] += at[static_cast<size_t>(parent)][i];
      if (std::string(arrays.joint_names[j]) == "leftHand") height = at[j][1];
    }
    return height;
  };
  EXPECT_NEAR(hand_height(), up[3 * kLeftHand + 1], 1e-4);
  // A clip of these frames plays as any other.
  const Handle robed = open(kRobed);
  good_call(sinew_character_animate(robed.get(), person.get(), nullptr, nullptr), robed);

  const std::vector<float> before = rotations;
  EXPECT_EQ(sinew_character_keypoints_frame(robed.get(), up.data(), kKeypoints, rotations.data(), translations.data()),
            SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_character_keypoints_frame(copy.get(), up.data(), 21, rotations.data(), translations.data()),
            SINEW_ERROR_INPUT);
  EXPECT_STREQ(sinew_character_error(copy.get()), "keypoints: expected 22 keypoints as humanml3d22 has, found 21");
  up[7] = std::nanf("");
  EXPECT_NE(sinew_character_keypoints_frame(copy.get(), up.data(), kKeypoints, rotations.data(), translations.data()),
            SINEW_OK);
  EXPECT_EQ(rotations, before);
  sinew_character* untouched = nullptr;
  EXPECT_EQ(sinew_character_open_keypoints("h36m", keypoints.data(), kKeypoints, 2, &untouched), SINEW_ERROR_INPUT);
  EXPECT_EQ(sinew_character_open_keypoints("humanml3d22", keypoints.data(), kKeypoints, 0, &untouched),
            SINEW_ERROR_INPUT);
  EXPECT_EQ(untouched, nullptr);
}

TEST_F(CharacterC, WritesForAProgramAsTheCommand) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " --for mixamo --to-pose none -o command.glb");
  const Handle robed = open(kRobed);
  bind(robed);
  sinew_character_profile_options options = SINEW_INIT(sinew_character_profile_options);
  options.profile = "mixamo";
  good_call(sinew_character_set_profile(robed.get(), &options), robed);
  good_call(sinew_character_save(robed.get(), in("ours.glb").c_str()), robed);
  expect_same("ours.glb", "command.glb");
  const auto refused = [&](const char* word) {
    EXPECT_EQ(sinew_character_set_profile(robed.get(), &options), SINEW_ERROR_INPUT);
    EXPECT_NE(std::string(sinew_character_error(robed.get())).find(word), std::string::npos);
  };
  options.profile = "vrm";
  const char* author = "Ann";
  options.authors = &author;
  options.author_count = 1;
  good_call(sinew_character_set_profile(robed.get(), &options), robed);
  EXPECT_NE(written(robed, "ours.vrm").find("VRMC_vrm"), std::string::npos);
  good_call(sinew_character_set_profile(robed.get(), nullptr), robed);
  EXPECT_EQ(written(robed, "plain.glb").find("mixamorig"), std::string::npos);
  options.profile = "softimage";
  refused("mixamo");
  EXPECT_NE(std::string(sinew_character_profiles()).find("mixamo unreal"), std::string::npos);
}

TEST_F(CharacterC, ExtensionsComeFromOneTable) {
  EXPECT_STREQ(sinew_character_extensions(SINEW_READ_MESH),
               ".obj .gltf .glb .vrm .fbx .dae .b3d .x .mesh.xml .mesh .md5mesh .ms3d .smd .iqm");
  EXPECT_STREQ(
      sinew_character_extensions(SINEW_READ_MOTION),
      ".gltf .glb .vrm .fbx .dae .b3d .x .mesh.xml .mesh .md5mesh .ms3d .smd .iqm .bvh .vrma .npz .npy .vmd .amc");
  EXPECT_STREQ(sinew_character_extensions(SINEW_WRITE_CHARACTER), ".obj .rig.txt .gltf .glb .vrm .fbx .usda .usdz");
  EXPECT_STREQ(sinew_character_extensions(SINEW_READ_MOTION | SINEW_WRITE_MOTION), ".gltf .glb .vrm .fbx .bvh .vrma");
  EXPECT_STREQ(sinew_character_extensions(1u << 20), "");
  EXPECT_NE(std::string(sinew_character_templates()).find("mixamo"), std::string::npos);
}

}  // namespace
}  // namespace sinew
