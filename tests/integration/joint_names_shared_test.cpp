// SPDX-License-Identifier: MIT
// Names of every joint of real characters, where this machine has them: what the one table says of them against the labels
// that people gave the joints, as a table in joint_names.tsv of the folder the test runs in.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "shared_data.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/io.hpp"

using namespace sinew;

namespace {

// The label's class without its side, number and remarks: l_foreleg2|l_hand is foreleg.
std::string label_class(const std::string& label) {
  std::string text = label.substr(0, label.find_first_of("|?"));
  if (text.size() > 2 && text[1] == '_') text.erase(0, 2);
  while (!text.empty() && text.back() >= '0' && text.back() <= '9') text.pop_back();
  return text;
}

// What a label's class may be called here; labels that are not in the list say nothing about classes.
const std::map<std::string, std::vector<std::string>> kClasses = {{"hips", {"pelvis", "spine"}},
                                                                  {"spine", {"spine", "pelvis"}},
                                                                  {"neck", {"neck", "spine"}},
                                                                  {"head", {"head"}},
                                                                  {"shoulder", {"clavicle"}},
                                                                  {"upperarm", {"upperarm"}},
                                                                  {"lowerarm", {"forearm"}},
                                                                  {"hand", {"hand"}},
                                                                  {"hipjoint", {"hip"}},
                                                                  {"upleg", {"thigh"}},
                                                                  {"lowleg", {"calf"}},
                                                                  {"foot", {"foot"}},
                                                                  {"toe", {"toe"}},
                                                                  {"tail", {"tail"}},
                                                                  {"wing", {"wing"}},
                                                                  {"ear", {"ear"}},
                                                                  {"thumb", {"thumb"}},
                                                                  {"index", {"index"}},
                                                                  {"middle", {"middle"}},
                                                                  {"ring", {"ring"}},
                                                                  {"pinky", {"pinky"}},
                                                                  {"eye", {"eye"}},
                                                                  {"jaw", {"jaw"}}};

TEST(SharedJointNames, AgreeWithLabels) {
  if (shared_folder().empty())
    GTEST_SKIP() << "NO SHARED DATA HERE: names of real joints were not read; set SINEW_SHARED_DIR";
  const std::filesystem::path shared = shared_folder();
  std::map<std::string, std::map<std::string, std::string>> labels;  // rig, joint -> label
  std::ifstream lines(shared / "eval" / "mapping" / "labels.tsv");
  std::string rig, joint, label;
  while (std::getline(lines, rig, '\t') && std::getline(lines, joint, '\t') && std::getline(lines, label))
    labels[rig][joint] = label;
  std::ofstream table("joint_names.tsv");
  table << "joint\tlabel\tclass\trole\tside\tnumber\n";
  size_t told = 0, right = 0, sided = 0, right_side = 0;
  for (const char* set : {"train", "val"}) {
    for (const std::string& path : list_characters((shared / "data" / "characters" / set).string())) {
      const Character c = read_character(path);
      const JointVerdicts verdicts = joint_verdicts(c.joints, follows_of(c));
      for (size_t j = 0; j < c.joints.size(); ++j) {
        const std::string& said = labels[c.name][c.joints[j].name];
        const char* const found = joint_class_text(verdicts.classes[j]);
        table << c.joints[j].name << '\t' << said << '\t' << found << '\t' << joint_role_text(verdicts.roles[j]) << '\t'
              << int{verdicts.sides[j]} << '\t' << verdicts.numbers[j] << '\n';
        const auto expected = kClasses.find(label_class(said));
        if (expected == kClasses.end() || verdicts.is_end(j)) continue;
        ++told;
        for (const std::string& one : expected->second) right += one == found ? 1 : 0;
        if (said[1] != '_') continue;
        ++sided;
        right_side += verdicts.sides[j] == (said[0] == 'l' ? 1 : -1) ? 1 : 0;
      }
    }
  }
  std::printf("%zu of %zu classes, %zu of %zu sides as labeled\n", right, told, right_side, sided);
  EXPECT_GE(told, 10000u);
  EXPECT_GE(static_cast<double>(right), 0.98 * static_cast<double>(told));
  EXPECT_GE(static_cast<double>(right_side), 0.99 * static_cast<double>(sided));
}

}  // namespace
