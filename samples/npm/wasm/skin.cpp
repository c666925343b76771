// SPDX-License-Identifier: MIT
// Functions of the package's modules beside the engine's interface (sinew.h): joints chosen as the command chooses
// them, and a callback that tells JavaScript how far a call is. src/binder.js and engine.js write the engine's
// structs into memory; the layouts they go by are checked here.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_character/bind/bind_character.hpp"

#define SKIN_EXPORT(name) __attribute__((used, export_name(name)))

// Every member is 4 bytes long, in the order of LAYOUTS in src/layouts.js, except where it says otherwise.
static_assert(sizeof(void*) == 4 && sizeof(size_t) == 4);
static_assert(sizeof(sinew_mesh) == 4 * 6 && sizeof(sinew_skeleton) == 4 * 10 && sizeof(sinew_model) == 4 * 29);
static_assert(sizeof(sinew_question) == 32 + 8 * SINEW_MAX_ALTERNATIVES && sizeof(sinew_answer) == 12);
static_assert(offsetof(sinew_bind_options, locked) == 4 * 14 &&
              offsetof(sinew_bind_outputs, questions_written) == 4 * 9);
static_assert(offsetof(sinew_rig_options, progress) == 4 * 8 && offsetof(sinew_rig_outputs, used_bytes) == 4 * 14);
static_assert(sizeof(sinew_map_options) == 4 * 10 && sizeof(sinew_map_outputs) == 4 * 8);
static_assert(sizeof(sinew_retarget_options) == 6 * 4);
static_assert(sizeof(sinew_motion_body) == 4 * 8 && sizeof(sinew_motion_clip) == 4 * 6 &&
              sizeof(sinew_contact_options) == 4 * 5 && sizeof(sinew_floor) == 4 * 7 &&
              sizeof(sinew_retarget_stream_options) == 4 * 8);
static_assert(sizeof(sinew_skin) == 4 * 4 && sizeof(sinew_deform_options) == 4 * 14 &&
              sizeof(sinew_deformer) == 4 * 14 && sizeof(sinew_deform_outputs) == 4 * 5);
static_assert(sizeof(sinew_bound_character) == 4 * 7 && sizeof(sinew_transfer_part) == 4 * 8);
static_assert(offsetof(sinew_transfer_options, progress_user) == 4 * 15 &&
              offsetof(sinew_transfer_outputs, used_bytes) == 4 * 13);
static_assert(sizeof(sinew_simplify_options) == 4 * 5);

// JavaScript's; 1 cancels.
extern "C" __attribute__((import_module("sinew"), import_name("progress"))) int tell_progress(uint32_t permille);

namespace {

using namespace sinew;

int progress(void*, uint32_t permille) { return tell_progress(permille); }

std::vector<Joint> joints_of(const sinew_skeleton& skeleton, const char* names) {
  std::vector<Joint> joints(skeleton.joint_count);
  for (size_t j = 0; j < joints.size(); ++j) {
    const float* const at = skeleton.positions + 3 * j;
    joints[j].position = {at[0], at[1], at[2]};
    joints[j].parent = skeleton.parents[j];
    if (names == nullptr) continue;
    joints[j].name = names;
    names += joints[j].name.size() + 1;
  }
  return joints;
}

// Vertices at one position are one piece: a face of two corners joins each to the first, as the readers' welding
// would.
Character character_of(const sinew_mesh& mesh, const sinew_skeleton& skeleton, const char* names) {
  Character character;
  character.joints = joints_of(skeleton, names);
  character.vertices.resize(mesh.vertex_count);
  std::map<std::tuple<float, float, float>, uint32_t> first_at;
  for (uint32_t f = 0; f < mesh.face_count; ++f) {
    const uint32_t from = mesh.face_offsets != nullptr ? mesh.face_offsets[f] : 3 * f;
    const uint32_t to = mesh.face_offsets != nullptr ? mesh.face_offsets[f + 1] : 3 * f + 3;
    character.face_vertices.insert(character.face_vertices.end(), mesh.face_vertices + from, mesh.face_vertices + to);
    character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
  }
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const float* const at = mesh.positions + 3 * size_t{v};
    character.vertices[v] = {at[0], at[1], at[2]};
    const auto [place, is_new] = first_at.emplace(std::tuple(at[0], at[1], at[2]), v);
    if (is_new) continue;
    character.face_vertices.insert(character.face_vertices.end(), {place->second, v});
    character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
  }
  return character;
}

}  // namespace

extern "C" {

SKIN_EXPORT("skin_progress") sinew_progress skin_progress() { return progress; }

// Which joints may get weight, as `sinew bind` sees it in a file without weights: by names and positions.
//   names     joint_count strings, each with a 0 behind it; null = not known
//   skeleton  flags: what the user says, or null
//   flags     out [J] SINEW_JOINT_* for sinew_bind()
//   tips      out [J] 1: the joint gets weight and hands it to its parent, see skin_fold_tips()
SKIN_EXPORT("skin_choose_joints")
void skin_choose_joints(const sinew_mesh* mesh, const sinew_skeleton* skeleton, const char* names, uint8_t* flags,
                        uint8_t* tips) {
  const Character character = character_of(*mesh, *skeleton, names);
  std::vector<uint8_t> said;
  if (skeleton->flags != nullptr) said.assign(skeleton->flags, skeleton->flags + skeleton->joint_count);
  const JointChoice choice = choose_joints(character, JointsFrom::kNames, said);
  std::memcpy(flags, choice.flags.data(), choice.flags.size());
  std::memset(tips, 0, choice.flags.size());
  for (const size_t tip : choice.tips) tips[tip] = 1;
}

// Weights of tips to their parents, in place: joints and weights [V x influence_count], weights of sum 65535.
SKIN_EXPORT("skin_fold_tips")
void skin_fold_tips(const sinew_mesh* mesh, const sinew_skeleton* skeleton, const uint8_t* flags, const uint8_t* tips,
                    uint32_t influence_count, uint16_t* joints, uint16_t* weights) {
  const Character character = character_of(*mesh, *skeleton, nullptr);
  JointChoice choice;
  choice.flags.assign(flags, flags + skeleton->joint_count);
  for (uint32_t j = 0; j < skeleton->joint_count; ++j)
    if (tips[j] != 0) choice.tips.push_back(j);
  std::vector<std::vector<Influence>> rows(mesh->vertex_count);
  const size_t n = influence_count;
  for (size_t v = 0; v < rows.size(); ++v)
    for (size_t i = v * n; i < (v + 1) * n && weights[i] != 0; ++i)
      rows[v].push_back({joints[i], static_cast<float>(weights[i]) / 65535.0f});
  if (fold_tips(character, choice, {}, &rows) == 0) return;
  std::memset(joints, 0, rows.size() * n * sizeof *joints);
  std::memset(weights, 0, rows.size() * n * sizeof *weights);
  for (size_t v = 0; v < rows.size(); ++v)
    for (size_t i = 0; i < rows[v].size(); ++i) {
      joints[v * n + i] = static_cast<uint16_t>(rows[v][i].joint);
      weights[v * n + i] = static_cast<uint16_t>(std::lround(rows[v][i].weight * 65535.0f));
    }
}

}  // extern "C"
