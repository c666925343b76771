// SPDX-License-Identifier: MIT
// Binds a character as its file means it: only joints that deform get weight, what is attached stays attached, and the
// report says what was left out. bind.hpp has the plain bind that this stands on.
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

// Where it is known from which joints may get weight.
enum class JointsFrom {
  kAuto,   // kOwn for a character that has weights, kNames for one that has none
  kOwn,    // mesh by mesh, those that have weight there already
  kNames,  // joint_verdicts() and find_joints_beside_mesh()
  kAll     // nowhere: all of them
};

struct LeftOutJoint {
  size_t joint = 0;
  std::string why;  // "control", "no weight in the file", ...
};

struct JointChoice {
  JointsFrom from = JointsFrom::kAll;  // never kAuto
  std::vector<uint8_t> flags;          // [J] SINEW_JOINT_*
  std::vector<LeftOutJoint> left_out;
  std::vector<size_t> tips;  // joints that get weight, and whose parents take it over
  // kOwn: which joints have weight where. Meshes with the same joints share a set.
  std::vector<std::vector<size_t>> sets;
  std::vector<size_t> set_of_mesh;  // [meshes, at least 1] index into sets, SIZE_MAX: any joint
};

struct CharacterBindOptions {
  BindOptions bind;         // without joint_flags: the choice has them
  bool keep_tips = false;   // tips keep the weight that they get
  bool bind_props = false;  // meshes without a skin are bound even if they hang on joints, or others have skins
  bool keep_apart = true;   // no weight across seams
  std::vector<uint8_t> scenery = {};  // [V] or empty: 1 for what is no part of the body and goes with the root
};

// Which joints of a character may get weight. What the user says, `joint_flags` [J] SINEW_JOINT_* or empty, has the last word:
// with joints that deform these and no others do, and joints that never do are left out beside the rest.
JointChoice choose_joints(const Character& character, JointsFrom from, const std::vector<uint8_t>& joint_flags = {});
// The user's word for a choice that is there already.
void apply_joint_flags(const std::vector<uint8_t>& joint_flags, JointChoice* choice);

// Restores joints that were left out or are tips, because the user binds vertices to them: in hints, say. Those that
// the user forbids stay out.
void restore_joints(const std::vector<size_t>& joints, const std::vector<uint8_t>& joint_flags, JointChoice* choice);

// Tips give what weight a bind gave them to their parents, but for those that most of a connected piece of the mesh belongs to.
//   kept  [meshes] of kept_meshes(): their rows stay as they are; or empty
//   rows  in/out [V]
// Returns how many tips gave theirs away.
size_t fold_tips(const Character& character, const JointChoice& choice, const std::vector<bool>& kept,
                 std::vector<std::vector<Influence>>* rows);

// Whether a mesh stays as it is: one without a skin that hangs on a joint, or whose neighbors have skins. [meshes]
std::vector<bool> kept_meshes(const Character& character, bool bind_props);

struct CharacterBind {
  std::vector<std::vector<Influence>> influences;  // [V]; kept meshes follow their joint, or have none
  std::vector<uint8_t> confidence;                 // [V] 0..255, see sinew_bind_outputs
  std::vector<sinew_question> questions;           // by falling gain; with BindOptions::question_count
  std::vector<uint32_t> vertex_questions;          // [V] index of a question or SINEW_NO_QUESTION, with the same
  std::vector<uint32_t> vertex_parts;              // [V] connected pieces, numbered in no certain order, with the same
  size_t kept_meshes = 0, folded_tips = 0;
  Seams seams;                    // with CharacterBindOptions::keep_apart
  size_t separated_vertices = 0;  // rows that lost weight across them
  size_t doubled_vertices = 0;    // where they were opened
  uint32_t symmetric_vertices = 0;
  size_t workspace_bytes = 0, used_bytes = 0;  // of the largest of its binds
  double seconds = 0;                          // in sinew_bind()
};

// Throws Error as bind() does, and when nothing is left to bind.
CharacterBind bind_character(const Character& character, const JointChoice& choice,
                             const CharacterBindOptions& options);

}  // namespace sinew
#endif
