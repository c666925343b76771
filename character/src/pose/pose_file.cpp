// SPDX-License-Identifier: MIT
// Matrices of a pose as text: a line a joint.
#include <unordered_map>

#include "sinew_character/pose/deform.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/decimal.hpp"
#include "text/text_lines.hpp"

namespace sinew {

std::vector<Affine> read_pose_matrices(const std::string& path, const Character& character) {
  const std::string text = read_text_file(path);
  if (text.find('\0') != std::string::npos)
    throw Error(path + ": expected lines 'pose NAME m00 m01 ... m23', found binary data (a zero byte)");
  std::unordered_map<std::string, size_t> index_of;
  for (size_t j = 0; j < character.joints.size(); ++j) index_of.emplace(character.joints[j].name, j);
  std::vector<Affine> palette(character.joints.size(), Affine{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  std::vector<size_t> line_of(character.joints.size(), 0);
  size_t found = 0;
  TextLines lines(path, text);
  while (lines.next()) {
    const auto& words = lines.words();
    if (words.empty() || words[0][0] == '#') continue;
    if (words[0] != "pose" || words.size() != 14)
      lines.fail("'pose NAME' and the 12 numbers of a 3x4 matrix", lines.line());
    const auto at = index_of.find(std::string(words[1]));
    if (at == index_of.end()) lines.fail("the name of a joint of " + character.name, words[1]);
    if (line_of[at->second] != 0)
      lines.fail("each joint once (the first is line " + std::to_string(line_of[at->second]) + ")", words[1]);
    line_of[at->second] = lines.number();
    for (size_t e = 0; e < 12; ++e) {
      const std::optional<float> value = decimal_to_float(words[e + 2]);
      if (!value) lines.fail("a finite number in the matrix of joint " + std::string(words[1]), words[e + 2]);
      palette[at->second][e] = static_cast<double>(*value);
    }
    ++found;
  }
  if (found == 0) throw Error(path + ": expected lines 'pose NAME m00 m01 ... m23', found none");
  return palette;
}

}  // namespace sinew
