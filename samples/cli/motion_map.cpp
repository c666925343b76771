// SPDX-License-Identifier: MIT
// Maps from files and by names; classes by names.
#include "motion_map.hpp"

#include <algorithm>
#include <map>

#include "sinew/sinew.h"
#include "sinew_datasets/label_skeleton.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// Names as map files have them: one word.
std::map<std::string, int> numbers_of(const std::vector<Joint>& joints) {
  std::map<std::string, int> numbers;
  for (size_t j = 0; j < joints.size(); ++j) {
    std::string word = joints[j].name;
    for (char& c : word)
      if (static_cast<unsigned char>(c) <= ' ') c = '_';
    numbers.emplace(joints[j].name, static_cast<int>(j));
    numbers.emplace(word, static_cast<int>(j));
  }
  return numbers;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  for (size_t at = 0; (at = line.find_first_not_of(" \t\r", at)) != std::string::npos;) {
    const size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::vector<int> read_map(const std::string& path, const std::vector<Joint>& target, const std::vector<Joint>& source,
                          const std::string& target_file, const std::string& source_file) {
  const std::map<std::string, int> targets = numbers_of(target), sources = numbers_of(source);
  std::vector<int> map(target.size(), -1);
  std::vector<size_t> said(target.size(), 0);
  const std::string text = read_text_file(path);
  size_t number = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::vector<std::string> words = words_of(text.substr(at, end - at));
    at = end + 1;
    ++number;
    if (words.empty() || words[0][0] == '#') continue;
    const std::string where = path + ":" + std::to_string(number) + ": expected ";
    if (words.size() != 2)
      throw Error(where + "'TARGET_JOINT SOURCE_JOINT', with - for no source, found " + std::to_string(words.size()) +
                  (words.size() == 1 ? " word" : " words"));
    const auto to = targets.find(words[0]), from = sources.find(words[1]);
    if (to == targets.end()) throw Error(where + "a joint of " + target_file + ", found " + words[0]);
    if (from == sources.end() && words[1] != "-")
      throw Error(where + "a joint of " + source_file + " or -, found " + words[1]);
    size_t& line = said[static_cast<size_t>(to->second)];
    if (line != 0)
      throw Error(where + "each joint of " + target_file + " once (the first is line " + std::to_string(line) +
                  "), found " + words[0]);
    line = number;
    if (from != sources.end()) map[static_cast<size_t>(to->second)] = from->second;
  }
  return map;
}

}  // namespace

JointMap map_joints(const std::vector<Joint>& target, const std::vector<Joint>& source, const std::string& target_file,
                    const std::string& source_file, const std::string& map_file) {
  JointMap map;
  if (!map_file.empty()) {
    map = {read_map(map_file, target, source, target_file, source_file), map_file};
  } else {
    map.how = "their names";
    const std::map<std::string, int> sources = numbers_of(source);
    for (const Joint& joint : target) {
      const auto found = sources.find(joint.name);
      map.sources.push_back(found == sources.end() ? -1 : found->second);
    }
  }
  if (std::all_of(map.sources.begin(), map.sources.end(), [](int s) { return s < 0; }))
    throw Error(target_file + ": no joint moves as one of " + source_file +
                (map_file.empty() ? ", the two name none alike; give --map FILE with lines TARGET_JOINT SOURCE_JOINT"
                                  : " by " + map_file));
  return map;
}

std::vector<uint8_t> motion_classes(const std::vector<Joint>& target, const std::vector<Joint>& source,
                                    const std::vector<int>& sources) {
  const LabelledSkeleton own = label_skeleton(target), from = label_skeleton(source);
  const auto known = [](const LabelledSkeleton& s, size_t j) {
    return s.ends[j] == 0 && s.classes[j] < SINEW_CLASS_OTHER;
  };
  std::vector<uint8_t> classes;
  for (size_t t = 0; t < target.size(); ++t) {
    const size_t s = sources[t] < 0 ? 0 : static_cast<size_t>(sources[t]);
    classes.push_back(known(own, t)                       ? own.classes[t]
                      : sources[t] >= 0 && known(from, s) ? from.classes[s]
                                                          : uint8_t{SINEW_CLASS_OTHER});
  }
  return classes;
}

}  // namespace sinew::cli
