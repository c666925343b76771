// SPDX-License-Identifier: MIT
// Characters to the engine's deformer and back.
#include "sinew_character/pose/deform.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/bind/seams.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/decimal.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

// Parts that have fused move apart: open where they meet. Vertices that this doubles come last. nullopt: there are none.
std::optional<Character> opened(const Character& character) {
  if (character.joints.empty()) return std::nullopt;
  const Seams seams = find_seams(character, character.influences);
  if (seams.seams.empty()) return std::nullopt;
  Character out = character;
  out.gltf.reset();  // poses do not need it
  cut_seams(seams, &out);
  return out;
}

}  // namespace

CharacterDeformer::CharacterDeformer(const Character& character, const sinew_deform_options& options)
    : name_(character.name) {
  SkinArrays arrays = skin_arrays(character);
  const std::optional<Character> open = opened(character);
  if (open) arrays = skin_arrays(*open);
  const EngineViews views(open ? *open : character, {});
  const sinew_skin skin = {arrays.joints.data(), arrays.weights.data(), arrays.influences, SINEW_WEIGHT_UNORM16};
  const sinew_status status = deformer_.create(views.mesh, views.skeleton, skin, options);
  if (status != SINEW_OK) throw Error(name_ + ": cannot deform: " + sinew_status_text(status));
  all_positions_.resize(arrays.positions.size());
  positions_.resize(3 * character.vertices.size());
}

const std::vector<float>& CharacterDeformer::pose(const std::vector<Affine>& palette) {
  if (palette.size() != deformer_.get().joint_count) {
    throw Error(name_ + ": a pose needs one matrix per joint, expected " + std::to_string(deformer_.get().joint_count) +
                ", found " + std::to_string(palette.size()));
  }
  matrices_.clear();
  for (const Affine& m : palette)
    for (const double x : m) matrices_.push_back(static_cast<float>(x));
  sinew_deform_outputs outputs = SINEW_INIT(sinew_deform_outputs);
  outputs.positions = all_positions_.data();
  const sinew_status status = deformer_.pose(matrices_.data(), &outputs);
  if (status == SINEW_ERROR_NOT_FINITE) throw Error(name_ + ": a matrix of the pose is not finite; correct the pose");
  if (status != SINEW_OK) throw Error(name_ + ": posing failed: " + sinew_status_text(status));
  corrected_ = outputs.corrected != 0;
  std::copy_n(all_positions_.begin(), positions_.size(), positions_.begin());
  return positions_;
}

Character CharacterDeformer::pose_character(const Character& character, const std::vector<Affine>& palette) {
  return posed_character(character, palette, pose(palette));
}

// Matrices of a pose as text: a line a joint.
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
