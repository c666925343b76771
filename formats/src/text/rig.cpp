// SPDX-License-Identifier: MIT
// rig.txt (formats/spec/rig.md): joints, hierarchy and skin weights as text, read with exact error lines and written.

#include <set>
#include <unordered_map>

#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "text/decimal.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

struct RigLine {
  size_t number = 0;
  std::vector<std::string> words;
};

struct RigLines {
  std::vector<RigLine> joints, skins, hiers;
  RigLine root;  // number 0 = none
};

// Sorts the lines by keyword and checks their number of words: what they name may come later in the file.
RigLines split_lines(const std::string& path, const std::string& text) {
  RigLines rig;
  TextLines lines(path, text);
  while (lines.next()) {
    const auto& words = lines.words();
    if (words.empty() || words[0][0] == '#') continue;
    RigLine line{lines.number(), {words.begin() + 1, words.end()}};
    const size_t count = line.words.size();
    if (words[0] == "joints") {
      if (count != 4) lines.fail("'joints NAME x y z'", lines.line());
      rig.joints.push_back(std::move(line));
    } else if (words[0] == "root") {
      if (count != 1) lines.fail("'root NAME'", lines.line());
      if (rig.root.number != 0)
        lines.fail("one root line (the first is line " + std::to_string(rig.root.number) + ")", lines.line());
      rig.root = std::move(line);
    } else if (words[0] == "hier") {
      if (count != 2) lines.fail("'hier PARENT CHILD'", lines.line());
      rig.hiers.push_back(std::move(line));
    } else if (words[0] == "skin") {
      if (count % 2 != 1) lines.fail("'skin VERTEX' and pairs of 'JOINT WEIGHT'", lines.line());
      rig.skins.push_back(std::move(line));
    } else {
      lines.fail("'joints', 'root', 'skin' or 'hier'", words[0]);
    }
  }
  if (rig.joints.empty())
    throw Error(path + ": expected a rig with joints ('joints NAME x y z'), found none in " +
                std::to_string(lines.number()) + " lines");
  return rig;
}

// Follows parents from every joint; each joint is walked over once.
void check_no_cycle(const std::string& path, const std::vector<Joint>& joints) {
  std::vector<size_t> seen_from(joints.size(), SIZE_MAX);
  for (size_t start = 0; start < joints.size(); ++start) {
    for (int j = static_cast<int>(start); j >= 0 && seen_from[static_cast<size_t>(j)] != start;) {
      if (seen_from[static_cast<size_t>(j)] != SIZE_MAX) break;  // reached from an earlier start: no cycle there
      seen_from[static_cast<size_t>(j)] = start;
      j = joints[static_cast<size_t>(j)].parent;
      if (j >= 0 && seen_from[static_cast<size_t>(j)] == start)
        throw Error(path + ": expected a tree of joints, found a cycle through " +
                    in_quotes(joints[static_cast<size_t>(j)].name) + " in the hier lines");
    }
  }
}

}  // namespace

void read_rig(const std::string& path, bool with_skin, Character* character) {
  const std::vector<uint8_t> bytes = read_file(path);
  if (bytes.empty()) throw Error(path + ": expected a rig, found an empty file");
  const std::string text(bytes.begin(), bytes.end());
  if (text.find('\0') != std::string::npos)
    throw Error(path + ": expected a rig text file, found binary data (a zero byte)");
  const RigLines rig = split_lines(path, text);
  const auto fail = [&](const RigLine& line, const std::string& expected, const std::string& found) {
    throw Error(path + ":" + std::to_string(line.number) + ": expected " + expected + ", found " + in_quotes(found));
  };

  std::vector<Joint> joints;
  std::unordered_map<std::string, size_t> index_of;
  for (const RigLine& line : rig.joints) {
    Joint joint;
    joint.name = line.words[0];
    float* const xyz[3] = {&joint.position.x, &joint.position.y, &joint.position.z};
    for (size_t axis = 0; axis < 3; ++axis) {
      const std::optional<float> value = to_finite_float(line.words[axis + 1]);
      if (!value) fail(line, "a finite number as position of the joint", line.words[axis + 1]);
      *xyz[axis] = *value;
    }
    const auto [at, is_new] = index_of.emplace(joint.name, joints.size());
    if (!is_new)
      fail(line, "each joint once (the first is line " + std::to_string(rig.joints[at->second].number) + ")",
           joint.name);
    joints.push_back(std::move(joint));
  }
  const auto joint_at = [&](const RigLine& line, const std::string& name) {
    const auto at = index_of.find(name);
    if (at == index_of.end()) fail(line, "the name of a joint that has a 'joints' line", name);
    return at->second;
  };
  for (const RigLine& line : rig.hiers) {
    const size_t parent = joint_at(line, line.words[0]), child = joint_at(line, line.words[1]);
    if (joints[child].parent >= 0)
      fail(line,
           "one parent per joint (it has " + in_quotes(joints[static_cast<size_t>(joints[child].parent)].name) + ")",
           line.words[1]);
    joints[child].parent = static_cast<int>(parent);
  }
  check_no_cycle(path, joints);
  if (rig.root.number == 0) throw Error(path + ": expected a line 'root NAME', found none");
  const size_t root = joint_at(rig.root, rig.root.words[0]);
  if (joints[root].parent >= 0) fail(rig.root, "a joint without parent as root", rig.root.words[0]);

  std::vector<std::vector<Influence>> influences(with_skin && !rig.skins.empty() ? character->vertices.size() : 0);
  std::vector<size_t> skin_line(influences.size(), 0);
  std::set<size_t> joints_of_line;
  for (const RigLine& line : rig.skins) {
    const std::optional<int64_t> vertex = to_integer(line.words[0]);
    if (!vertex || *vertex < 0) fail(line, "a vertex number from 0", line.words[0]);
    const size_t v = static_cast<size_t>(*vertex);
    if (with_skin) {
      if (v >= influences.size())
        fail(line, "a vertex number below " + std::to_string(influences.size()) + " (the mesh's vertices)",
             line.words[0]);
      if (skin_line[v] != 0)
        fail(line, "one skin line per vertex (the first is line " + std::to_string(skin_line[v]) + ")", line.words[0]);
      skin_line[v] = line.number;
    }
    joints_of_line.clear();
    for (size_t i = 1; i + 1 < line.words.size(); i += 2) {
      const size_t joint = joint_at(line, line.words[i]);
      const std::optional<float> weight = to_finite_float(line.words[i + 1]);
      if (!weight || *weight < 0) fail(line, "a finite weight of 0 or more", line.words[i + 1]);
      if (!joints_of_line.insert(joint).second) fail(line, "each joint once per vertex", line.words[i]);
      if (with_skin && *weight > 0) influences[v].push_back({static_cast<uint32_t>(joint), *weight});
    }
  }
  character->joints = std::move(joints);
  character->influences = std::move(influences);
}

void write_rig(const std::string& path, const Character& character) {
  const std::vector<std::string> names = names_without_blanks(character.joints);
  std::string out;
  size_t root = names.size();
  for (size_t j = 0; j < names.size(); ++j) {
    const Joint& joint = character.joints[j];
    const Vec3& p = joint.position;
    out += "joints " + names[j] + " " + fixed_decimal(p.x, 8) + " " + fixed_decimal(p.y, 8) + " " +
           fixed_decimal(p.z, 8) + "\n";
    if (joint.parent >= static_cast<int>(names.size()))
      throw Error(path + ": cannot write, joint " + in_quotes(joint.name) + " has a parent that does not exist");
    if (joint.parent < 0 && root == names.size()) root = j;
  }
  if (root == names.size())
    throw Error(path + ": cannot write a rig " + (names.empty() ? "without joints" : "without a root joint"));
  out += "root " + names[root] + "\n";
  for (size_t v = 0; v < character.influences.size(); ++v) {
    std::string row;
    for (const Influence& influence : character.influences[v]) {
      if (influence.joint >= names.size())
        throw Error(path + ": cannot write, vertex " + std::to_string(v) + " names joint " +
                    std::to_string(influence.joint) + " of " + std::to_string(names.size()));
      const std::string weight = fixed_decimal(influence.weight, 6);
      if (weight != "0.000000") row += " " + names[influence.joint] + " " + weight;
    }
    if (!row.empty()) out += "skin " + std::to_string(v) + row + "\n";
  }
  for (size_t j = 0; j < names.size(); ++j)
    if (character.joints[j].parent >= 0)
      out += "hier " + names[static_cast<size_t>(character.joints[j].parent)] + " " + names[j] + "\n";
  write_text_file(path, out);
}

}  // namespace sinew
