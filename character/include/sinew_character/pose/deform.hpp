// SPDX-License-Identifier: MIT
// Corrected poses of a character by sinew/deform.h.
#ifndef SINEW_CHARACTER_DEFORM_HPP
#define SINEW_CHARACTER_DEFORM_HPP

#include <string>
#include <vector>

#include "sinew/sinew.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Poses one character any number of times. Corrections do not cross seams (find_seams() by the character's own
// weights). Weights are unorm16, the 12 strongest of a row; a vertex without weight does not move.
class CharacterDeformer {
 public:
  // Throws Error for missing weights, a joint that does not exist, or input that the engine rejects. `character` need
  // not outlive the object.
  CharacterDeformer(const Character& character, const sinew_deform_options& options);

  // Returns posed vertices [V x 3]. Throws Error unless there is one finite matrix per joint.
  const std::vector<float>& pose(const std::vector<Affine>& palette);
  // The same as a character, without corner normals and glTF source.
  Character pose_character(const Character& character, const std::vector<Affine>& palette);

  const sinew_deformer& deformer() const { return deformer_.get(); }
  size_t memory_bytes() const { return deformer_.memory_bytes(); }
  bool corrected() const { return corrected_; }  // of the last pose: see sinew_deform_outputs

 private:
  std::string name_;
  Deformer deformer_;
  std::vector<float> all_positions_, positions_, matrices_;  // all: with the vertices that cuts double
  bool corrected_ = true;
};

// Reads lines `pose NAME m00 m01 ... m23`: one 3x4 skinning matrix per joint (rest space to posed space, row by row).
// Joints without a line stay at rest; other lines are ignored when they are empty or begin with '#'. Throws Error
// with file and line for an unknown or repeated joint, or a line that is not one of these.
std::vector<Affine> read_pose_matrices(const std::string& path, const Character& character);

}  // namespace sinew
#endif
