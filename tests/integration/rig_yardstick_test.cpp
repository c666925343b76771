// SPDX-License-Identifier: MIT
// Our figures of predicted skeletons against rig_eval.py on the same files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "shared_data.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/rig_score.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;

std::string python_with_scipy() {
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (std::system((std::string(python) + " -c 'import scipy' >/dev/null 2>&1").c_str()) == 0) return python;
  return "";
}

// The target with joints moved, and some left out.
std::vector<Joint> changed(const TargetSkeleton& target, std::mt19937* random) {
  std::vector<Joint> joints = target_joints(target), out;
  std::normal_distribution<float> normal(0, 0.015f * static_cast<float>(target.side));
  std::vector<int> moved_to;
  for (size_t j = 0; j < joints.size(); ++j) {
    const bool left_out = joints[j].parent >= 0 && (*random)() % 8 == 0;
    moved_to.push_back(left_out ? -1 : static_cast<int>(out.size()));
    if (left_out) continue;
    joints[j].position.x += normal(*random);
    joints[j].position.y += normal(*random);
    out.push_back(joints[j]);
  }
  for (Joint& joint : out) {
    while (joint.parent >= 0 && moved_to[static_cast<size_t>(joint.parent)] < 0)
      joint.parent = joints[static_cast<size_t>(joint.parent)].parent;
    if (joint.parent >= 0) joint.parent = moved_to[static_cast<size_t>(joint.parent)];
  }
  return out;
}

// Coordinates are floats here and doubles there.
void compare(const nlohmann::json& ours, const nlohmann::json& theirs, const std::string& where, double* largest) {
  for (const auto& [key, value] : theirs.items()) {
    ASSERT_TRUE(ours.contains(key)) << where << "/" << key;
    if (value.is_object()) {
      compare(ours[key], value, where + "/" + key, largest);
    } else {
      ASSERT_TRUE(ours[key].is_number()) << where << "/" << key;
      if (key == "class") {  // each side reads names by a table of its own
        EXPECT_NEAR(ours[key].get<double>(), value.get<double>(), 0.1) << where << "/" << key;
        continue;
      }
      EXPECT_NEAR(ours[key].get<double>(), value.get<double>(), 1e-6) << where << "/" << key;
      *largest = std::max(*largest, std::abs(ours[key].get<double>() - value.get<double>()));
    }
  }
}

TEST(RigYardstick, EveryFigureAgrees) {
  const fs::path shared = shared_folder();
  if (shared.empty())
    GTEST_SKIP() << "NOT CHECKED: there is no shared data; set SINEW_SHARED_DIR to compare with rig_eval.py";
  const fs::path script = shared / "eval" / "rig" / "rig_eval.py";
  if (!fs::exists(script)) GTEST_SKIP() << "NOT CHECKED: the shared data has no " << script;
  const std::string python = python_with_scipy();
  if (python.empty()) GTEST_SKIP() << "NOT CHECKED: no python3 with scipy to run rig_eval.py";

  const TempFolder work;
  const fs::path reference = shared / "data" / "characters" / "val";
  std::mt19937 random(1);
  std::vector<std::pair<std::string, RigScore>> rows;
  for (const std::string& path : list_characters(reference.string())) {
    const Character character = read_character(path);
    const TargetSkeleton target = target_skeleton(character);
    Character predicted;
    predicted.joints = changed(target, &random);
    const std::string file = work.file(character.name + ".rig.txt");
    write_rig(file, predicted);
    read_skeleton(file, false, &predicted);
    rows.emplace_back(character.name,
                      score_rig(scored_skeleton(predicted.joints, target.side), scored_skeleton(target)));
  }
  const std::string command = python + " '" + script.string() + "' '" + reference.string() + "' '" + work.path() +
                              "' --json '" + work.file("theirs.json") + "' >/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  const auto theirs = nlohmann::json::parse(std::ifstream(work.file("theirs.json")));
  const auto ours = nlohmann::json::parse(rig_scores_json(summarize(rows)));
  double largest = 0;
  for (const char* part : {"families", "characters_mean", "families_mean"})
    compare(ours[part], theirs[part], part, &largest);
  EXPECT_LT(theirs["characters_mean"]["IoU"], 0.99) << "the predictions are hardly changed";
  std::printf("largest difference of any figure: %.2g\n", largest);
}

}  // namespace
}  // namespace sinew
