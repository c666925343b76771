// SPDX-License-Identifier: MIT
// A file as the source of a map is what animate plays from it: the same stance, ends and joints, hence the same map.
#include "sinew_character/motion/map_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "expect_error.hpp"
#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "temp_folder.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

const std::string kData = SINEW_SOURCE_DIR "/samples/data/";

std::function<bool()> go_on(size_t) {
  return [] { return true; };
}

// As the command and the C API do it.
AnimatedCharacter animated(const std::string& target, const std::string& path) {
  AnimatedCharacter out = animated_character(read_character(target), target);
  const MotionFile file = read_motion_for({path}, map_rig_of(out.character));
  AnimateOptions options;
  options.character = target;
  options.force = true;
  add_motion(options, {path, "", &file.motion, [&] { return file.whole ? body_of_motion(path) : std::nullopt; }}, go_on,
             &out);
  return out;
}

// A robot that walks, with its mesh, in a file.
std::string walking_robot(const TempFolder& folder) {
  const std::string bvh = folder.path() + "/walk.bvh", path = folder.path() + "/robot.glb";
  const Motion walk = walking_person(20);
  write_bvh(bvh, walk, walk.clips[0]);
  const AnimatedCharacter robot = animated(kData + "biped__robot.obj", bvh);
  GlbOptions options;
  options.motion = &robot.motion;
  write_gltf_morphs(path, robot.character, options, {});
  return path;
}

TEST(MapSource, TheMapIsThatOfAnimate) {
  const TempFolder folder;
  const std::string axes = folder.path() + "/axes.bvh";
  const Motion walk = with_random_axes(walking_person());
  write_bvh(axes, walk, walk.clips[0]);
  for (const std::string& path : {walking_robot(folder), axes, std::string("builtin:walk")}) {
    for (const char* name : {"biped__robed.obj", "quadruped__tailed.obj"}) {
      const std::string target = kData + name;
      const MapRig to = map_rig_of(read_character(target)), from = read_map_source({path}, to);
      MapSkeletonOptions options;
      options.target_up = options.source_up = std::nullopt;
      const MappedSkeleton map = map_skeleton(to, from, options);
      const std::vector<int> sources(map.sources.begin(), map.sources.end());
      EXPECT_EQ(sources, animated(target, path).map.sources) << path << " on " << name;
    }
  }
}

TEST(MapSource, LeavesWithoutWeightAreEndsInAMotionToo) {
  const TempFolder folder;
  const std::string path = walking_robot(folder);
  const MapRig skeleton = map_rig_of(read_gltf(path)), source = read_map_source({path}, {});
  ASSERT_GE(source.ends.size(), skeleton.ends.size());
  EXPECT_TRUE(std::equal(skeleton.ends.begin(), skeleton.ends.end(), source.ends.begin()));
  EXPECT_EQ(source.surfaces.shares.size(), source.joints.size());
  EXPECT_NE(std::count(source.animated.begin(), source.animated.end(), 1), 0);
}

// Bones along x under a root that stays where the stage begins, names plain: every joint moves as the one of its name.
TEST(MapSource, PlainNamesFindTheirPartsUnderAFarRoot) {
  const Motion walk = walking_person();
  const Motion written = with_far_root(with_bones_in_one_line(walk), {0.1, 0.3, -4.5});
  const MapSource source = map_source_of(written, nullptr, {}, {});
  ASSERT_TRUE(source.standing);
  const MapRig target = map_rig_of(walk);
  const MotionMap map = map_motion(target, source.rig, {}, "");
  EXPECT_EQ(map.cover.warnings, std::vector<std::string>{});
  for (size_t j = 0; j < target.joints.size(); ++j) {
    if (target.ends[j] != 0) continue;
    const std::string& name = target.joints[j].name;
    ASSERT_GE(map.sources[j], 0) << name;
    EXPECT_EQ(source.rig.joints[static_cast<size_t>(map.sources[j])].name, name);
  }
}

TEST(MapSource, AMotionMadeOnTheTargetKeepsItsRestPose) {
  const Motion walk = with_random_axes(walking_person());
  EXPECT_TRUE(map_source_of(walk, nullptr, {}, {}).standing);
  EXPECT_FALSE(map_source_of(walk, nullptr, rest_joints(walk), {}).standing);
}

TEST(MapSource, ALayoutIsForPlacesAlone) {
  const TempFolder folder;
  const std::string path = folder.path() + "/walk.bvh";
  const Motion walk = walking_person(5);
  write_bvh(path, walk, walk.clips[0]);
  for (const std::string& file : {path, std::string("builtin:walk"), std::string("template:mixamo")}) {
    EXPECT_ERROR((void)read_map_source({file, "smpl24"}, {}), file, "leave it out");
  }
  EXPECT_ERROR((void)read_motion(path, 0, "smpl24"), "walk.bvh", "leave it out");
  EXPECT_ERROR((void)read_map_source({path, "", "eve"}, {}), "walk.bvh", "'eve'");
}

}  // namespace
}  // namespace sinew
