// SPDX-License-Identifier: MIT
// A clip's name means that of the body it is for.
#include "sinew_character/motion/motion_file.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

MapRig sample(const std::string& name) {
  return map_rig_of(read_character(SINEW_SOURCE_DIR "/samples/data/" + name + ".obj"));
}

TEST(MotionFile, AWalkIsThatOfTheCharactersLimbs) {
  EXPECT_EQ(read_motion_for({"builtin:walk"}, sample("biped__robot")).motion.joints[0].name, "mixamorig:Hips");
  EXPECT_EQ(read_motion_for({"builtin:walk"}, sample("quadruped__tailed")).motion.joints[0].name, "Hips");
  EXPECT_EQ(read_motion_for({"builtin:idle"}, sample("quadruped__tailed")).motion.clips.size(), 1u);
  EXPECT_EQ(read_motion_for({"builtin:person/walk"}, sample("quadruped__tailed")).motion.joints[0].name,
            "mixamorig:Hips")
      << "as it was asked for";
  EXPECT_ERROR(read_motion_for({"builtin:fly"}, sample("biped__robot")), "builtin:fly", "bird: flap");
  EXPECT_ERROR(read_motion_for({"builtin:wave", 0, "", "eve"}, sample("biped__robot")), "found 'eve'");
  EXPECT_ERROR(read_motion_for({"walk.doc"}, sample("biped__robot")), "walk.doc", "expected a motion");
}

}  // namespace
}  // namespace sinew
