// SPDX-License-Identifier: MIT
// Binds a character with respect to its file: only deforming joints get weight, attached meshes stay attached, and
// the report lists what was left out. It is based on the plain bind in bind.hpp.
#ifndef SINEW_CHARACTER_BIND_CHARACTER_HPP
#define SINEW_CHARACTER_BIND_CHARACTER_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "sinew_character/bind/bind.hpp"
#include "sinew_character/bind/seams.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Source of the joints that may get weight.
enum class JointsFrom {
  kAuto,   // kOwn for a character with weights, else kNames
  kOwn,    // per mesh, joints that already have weight there
  kNames,  // joint_verdicts() and find_joints_beside_mesh()
  kAll     // all joints
};

struct LeftOutJoint {
  size_t joint = 0;
  std::string why;  // "control", "no weight in the file", ...
};

struct JointChoice {
  JointsFrom from = JointsFrom::kAll;  // never kAuto
  std::vector<uint8_t> flags;          // [J] SINEW_JOINT_*
  std::vector<LeftOutJoint> left_out;
  std::vector<size_t> tips;  // joints that get weight which then goes to their parents
  // kOwn: sets of joints with weight per mesh. Meshes with the same joints share a set.
  std::vector<std::vector<size_t>> sets;
  std::vector<size_t> set_of_mesh;  // [meshes, at least 1] index into sets, SIZE_MAX: any joint
};

struct CharacterBindOptions {
  BindOptions bind;         // joint_flags are ignored: the choice has them
  bool keep_tips = false;   // tips keep their weight
  bool bind_props = false;  // meshes without a skin are bound even if joints carry them or other meshes have skins
  bool keep_apart = true;   // no weight across seams
  std::vector<uint8_t> scenery = {};  // [V] or empty: 1: not a part of the body, follows the root
};

// Chooses the joints of a character that may get weight. The user's `joint_flags` ([J] SINEW_JOINT_* or empty) take
// precedence: if some deform, no others do; joints that never deform are always left out.
JointChoice choose_joints(const Character& character, JointsFrom from, const std::vector<uint8_t>& joint_flags = {});
// Applies the user's flags to an existing choice.
void apply_joint_flags(const std::vector<uint8_t>& joint_flags, JointChoice* choice);

// Restores joints that were left out or are tips but have vertices bound by the user, for example in hints. Joints
// excluded by the user stay out.
void restore_joints(const std::vector<size_t>& joints, const std::vector<uint8_t>& joint_flags, JointChoice* choice);

// Moves the weight of tips to their parents, except for tips that have most of the weight of a connected piece of the
// mesh.
//   kept  [meshes] of kept_meshes(): their rows are unchanged; or empty
//   rows  in/out [V]
// Returns the number of tips that lost their weight.
size_t fold_tips(const Character& character, const JointChoice& choice, const std::vector<bool>& kept,
                 std::vector<std::vector<Influence>>* rows);

// [meshes] 1: the mesh is kept unbound: it has no skin, and a joint carries it or other meshes have skins.
std::vector<bool> kept_meshes(const Character& character, bool bind_props);

struct CharacterBind {
  std::vector<std::vector<Influence>> influences;  // [V]; kept meshes follow their joint, or have no weights
  std::vector<uint8_t> confidence;                 // [V] 0..255, see sinew_bind_outputs
  std::vector<sinew_question> questions;           // by descending gain; with BindOptions::question_count
  std::vector<uint32_t> vertex_questions;          // [V] index of a question or SINEW_NO_QUESTION, with the same
  std::vector<uint32_t> vertex_parts;              // [V] connected pieces in any order, with the same
  size_t kept_meshes = 0, folded_tips = 0;
  Seams seams;                    // with CharacterBindOptions::keep_apart
  size_t separated_vertices = 0;  // rows that lost weight across them
  size_t doubled_vertices = 0;    // vertices doubled by a cut
  uint32_t symmetric_vertices = 0;
  size_t workspace_bytes = 0, used_bytes = 0;  // of its largest bind
  double seconds = 0;                          // in sinew_bind()
};

// Throws Error like bind(), and if there is no mesh to bind.
CharacterBind bind_character(const Character& character, const JointChoice& choice,
                             const CharacterBindOptions& options);

}  // namespace sinew
#endif
