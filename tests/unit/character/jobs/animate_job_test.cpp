// SPDX-License-Identifier: MIT
// What clips are called that come from a file.
#include "sinew_character/jobs/animate_job.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

sinew::Motion motion_with(const std::vector<std::string>& names) {
  sinew::Motion motion;
  for (const std::string& name : names) motion.clips.emplace_back().name = name;
  return motion;
}

std::vector<std::string> named(const std::vector<std::string>& names, bool always = false) {
  sinew::Motion motion = motion_with(names);
  sinew::name_clips("clips/walking.fbx", always, motion_with({"idle"}), &motion);
  std::vector<std::string> made;
  for (const sinew::Clip& clip : motion.clips) made.push_back(clip.name);
  return made;
}

using Names = std::vector<std::string>;

TEST(NameClips, NamesThatNobodyGaveAreTheFiles) {
  for (const char* const name : {"mixamo.com", "Armature|mixamo.com|Layer0", "Take 001", "Unreal Take", ""})
    EXPECT_EQ(named({name}), Names{"walking"}) << name;
  EXPECT_EQ(named({"Take 001", "jump"}), (Names{"Take 001", "jump"})) << "of several each keeps its own";
}

TEST(NameClips, NamesThatWereGivenStayUnlessTheyAreTaken) {
  EXPECT_EQ(named({"run"}), Names{"run"});
  EXPECT_EQ(named({"idle"}), Names{"walking"});
  EXPECT_EQ(named({"idle", "run"}), (Names{"walking.idle", "walking.run"}));
  EXPECT_EQ(named({"run"}, true), Names{"walking"});
}

}  // namespace
