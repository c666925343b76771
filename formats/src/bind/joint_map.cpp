// SPDX-License-Identifier: MIT
// Maps of joints, by equal names or from a text file.
#include "sinew_formats/joint_map.hpp"

#include <algorithm>
#include <map>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

// Both as the skeleton has it and as a text file writes it; the first joint of a name has it.
std::map<std::string, int32_t, std::less<>> numbers_of(const std::vector<Joint>& joints) {
  std::map<std::string, int32_t, std::less<>> numbers;
  for (size_t j = 0; j < joints.size(); ++j) numbers.emplace(joints[j].name, static_cast<int32_t>(j));
  const std::vector<std::string> written = names_without_blanks(joints);
  for (size_t j = 0; j < joints.size(); ++j) numbers.emplace(written[j], static_cast<int32_t>(j));
  return numbers;
}

}  // namespace

JointMapping map_joints_by_name(const std::vector<Joint>& source, const std::vector<Joint>& target) {
  const auto numbers = numbers_of(target);
  const std::vector<std::string> written = names_without_blanks(source);
  JointMapping mapping(source.size(), -1);
  for (size_t j = 0; j < source.size(); ++j) {
    auto found = numbers.find(source[j].name);
    if (found == numbers.end()) found = numbers.find(written[j]);
    if (found != numbers.end()) mapping[j] = found->second;
  }
  return mapping;
}

JointMapping read_joint_map(const std::string& path, const std::vector<Joint>& source,
                            const std::vector<Joint>& target) {
  const auto source_numbers = numbers_of(source), target_numbers = numbers_of(target);
  const std::string text = read_text_file(path);
  JointMapping mapping(source.size(), -1);
  TextLines lines(path, text);
  while (lines.next()) {
    const auto& words = lines.words();
    if (words.empty() || words[0][0] == '#') continue;
    if (words.size() != 2) lines.fail("TARGET_JOINT SOURCE_JOINT", lines.line());
    const auto to = target_numbers.find(words[0]);
    const auto from = source_numbers.find(words[1]);
    if (to == target_numbers.end()) lines.fail("a joint of the target's skeleton in front", words[0]);
    if (from == source_numbers.end()) lines.fail("a joint of the source's skeleton behind", words[1]);
    int32_t& own = mapping[static_cast<size_t>(from->second)];
    if (own >= 0 && own != to->second) lines.fail("each joint of the source once", words[1]);
    own = to->second;
  }
  if (mapped_count(mapping) == 0) throw Error(path + ": maps no joint; expected lines TARGET_JOINT SOURCE_JOINT");
  return mapping;
}

size_t mapped_count(const JointMapping& mapping) {
  return static_cast<size_t>(std::count_if(mapping.begin(), mapping.end(), [](int32_t to) { return to >= 0; }));
}

}  // namespace sinew
