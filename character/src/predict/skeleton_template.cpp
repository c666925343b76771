// SPDX-License-Identifier: MIT
// Reads the bundled templates: a line "about TEXT", then NAME PARENT X Y Z for every joint, "-" for the root's parent. Only
// the left side is written down; the right side is its mirror image about x = 0.
#include "sinew_character/predict/skeleton_template.hpp"

#include <algorithm>
#include <locale>
#include <map>
#include <sstream>

#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr const char* kAbout = "about ";

std::vector<Joint> parse(const std::string& name, const std::string& text) {
  std::vector<Joint> joints;
  std::map<std::string, int> index = {{"-", -1}};
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const auto add = [&](const Joint& joint) {
    if (!index.emplace(joint.name, static_cast<int>(joints.size())).second)
      throw Error("template " + name + "occurs twice " + joint.name + " is there twice");
    joints.push_back(joint);
  };
  while (std::getline(lines, line)) {
    if (line.empty()) continue;
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    Joint joint;
    std::string parent;
    if (!(words >> joint.name >> parent >> joint.position.x >> joint.position.y >> joint.position.z) ||
        index.count(parent) == 0)
      throw Error("template " + name + ": cannot parse the line: " + line);
    joint.parent = index.at(parent);
    add(joint);
    const std::string other = other_side_name(joint.name);
    if (other == joint.name) continue;
    const std::string other_parent = other_side_name(parent);
    joint.name = other;
    joint.position.x = -joint.position.x;
    joint.parent = index.at(other_parent);
    add(joint);
  }
  return joints;
}

// A joint, then all below it: the left side, then the right one.
std::vector<Joint> in_branches(const std::vector<Joint>& joints) {
  std::vector<Joint> sorted;
  std::vector<int> index(joints.size(), -1), open;
  for (size_t j = joints.size(); j-- > 0;)
    if (joints[j].parent < 0) open.push_back(static_cast<int>(j));
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    Joint joint = joints[static_cast<size_t>(at)];
    index[static_cast<size_t>(at)] = static_cast<int>(sorted.size());
    if (joint.parent >= 0) joint.parent = index[static_cast<size_t>(joint.parent)];
    sorted.push_back(std::move(joint));
    for (size_t j = joints.size(); j-- > 0;)
      if (joints[j].parent == at) open.push_back(static_cast<int>(j));
  }
  return sorted;
}

}  // namespace

std::vector<TemplateInfo> skeleton_templates() {
  std::vector<TemplateInfo> templates;
  for (const TemplateText* one = template_texts(); one->name != nullptr; ++one) {
    const std::string text = one->text, first = text.substr(0, text.find('\n'));
    templates.push_back({one->name, first.rfind(kAbout, 0) == 0 ? first.substr(std::string(kAbout).size()) : ""});
  }
  return templates;
}

std::vector<Joint> skeleton_template(const std::string& name) {
  std::string known;
  for (const TemplateText* one = template_texts(); one->name != nullptr; ++one) {
    if (name == one->name) return in_branches(parse(name, one->text));
    known += (known.empty() ? "" : ", ") + std::string(one->name);
  }
  throw Error("unknown template " + name + "; expected one of " + known);
}

}  // namespace sinew
