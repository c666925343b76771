// SPDX-License-Identifier: MIT
// A character's arrays, out and in.
#include <cmath>
#include <set>

#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/motion/map_skeleton.hpp"

namespace sinew {
namespace {

void fill_weights(const Character& character, CharacterViews* views) {
  views->influence_count = 0;
  views->row_offsets.clear();
  views->joint_indices.clear();
  views->weights.clear();
  if (character.influences.empty()) return;
  views->row_offsets.push_back(0);
  for (const auto& row : character.influences) {
    for (const Influence& influence : row) {
      views->joint_indices.push_back(influence.joint);
      views->weights.push_back(influence.weight);
    }
    views->row_offsets.push_back(count32(views->weights.size()));
    views->influence_count = std::max(views->influence_count, count32(row.size()));
  }
}

void fill_views(const Character& character, CharacterViews* views) {
  *views = {};
  for (const Vec3& p : character.vertices) views->positions.insert(views->positions.end(), {p.x, p.y, p.z});
  for (const Joint& joint : character.joints) {
    views->joint_names.push_back(joint.name.c_str());
    views->joint_positions.insert(views->joint_positions.end(), {joint.position.x, joint.position.y, joint.position.z});
    views->parents.push_back(joint.parent);
  }
  for (const CharacterMesh& mesh : character.meshes) {
    views->mesh_names.push_back(mesh.name.c_str());
    views->mesh_joints.push_back(mesh.carrier);
    views->mesh_skinned.push_back(mesh.skinned ? 1 : 0);
  }
  fill_weights(character, views);
}

template <class T>
const T* or_null(const std::vector<T>& array) {
  return array.empty() ? nullptr : array.data();
}

// Another skeleton: weights, and what belonged to the old one, go.
void replace_skeleton(std::vector<Joint> joints, sinew_character* character) {
  Character& mesh = character->character;
  mesh.joints = std::move(joints);
  mesh.influences.clear();
  mesh.confidence.clear();
  mesh.meshes.clear();
  mesh.vertex_meshes.clear();
  character->clips.clear();
  character->morphs = {};
  character->own_skeleton = false;
  changed(character);
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" {

sinew_status sinew_character_view(sinew_character* character, sinew_character_arrays* arrays) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(arrays != nullptr, "arrays");
    check_result(arrays);
    if (!character->viewed) fill_views(character->character, &character->views);
    character->viewed = true;
    const Character& from = character->character;
    const CharacterViews& views = character->views;
    sinew_character_arrays filled = SINEW_INIT(sinew_character_arrays);
    filled.vertex_count = count32(from.vertices.size());
    filled.face_count = count32(from.face_count());
    filled.corner_count = count32(from.face_vertices.size());
    filled.joint_count = count32(from.joints.size());
    filled.mesh_count = count32(from.meshes.size());
    filled.influence_count = views.influence_count;
    filled.name = from.name.c_str();
    filled.positions = views.positions.data();
    filled.face_offsets = from.face_offsets.data();
    filled.face_vertices = from.face_vertices.data();
    filled.joint_positions = views.joint_positions.data();
    filled.parents = views.parents.data();
    filled.joint_names = views.joint_names.data();
    filled.row_offsets = or_null(views.row_offsets);
    filled.joint_indices = views.joint_indices.data();
    filled.weights = views.weights.data();
    filled.confidence = or_null(from.confidence);
    filled.vertex_meshes = or_null(from.vertex_meshes);
    filled.mesh_names = views.mesh_names.data();
    filled.mesh_joints = views.mesh_joints.data();
    filled.mesh_skinned = views.mesh_skinned.data();
    give(filled, arrays);
  });
}

sinew_status sinew_character_skin(const sinew_character* character, uint32_t influence_count, uint16_t* joint_indices,
                                  uint16_t* weights) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(joint_indices != nullptr && weights != nullptr, "joint_indices, weights");
    if (influence_count == 0 || influence_count > SINEW_MAX_INFLUENCES)
      throw Failure(SINEW_ERROR_ARGUMENT, "influence_count: expected 1 to " + std::to_string(SINEW_MAX_INFLUENCES) +
                                              ", found " + std::to_string(influence_count));
    const Character& from = character->character;
    if (from.influences.empty()) throw Error(from.name + ": has no weights; bind it first");
    std::fill_n(joint_indices, size_t{influence_count} * from.vertices.size(), uint16_t{0});
    std::fill_n(weights, size_t{influence_count} * from.vertices.size(), uint16_t{0});
    for (size_t v = 0; v < from.influences.size(); ++v) {
      size_t slot = v * influence_count;
      for (const Influence& influence : round_influences(from.influences[v], influence_count)) {
        joint_indices[slot] = static_cast<uint16_t>(influence.joint);
        weights[slot++] = static_cast<uint16_t>(std::lround(influence.weight * 65535.0f));
      }
    }
  });
}

sinew_status sinew_character_joint_classes(const sinew_character* character, uint8_t* classes) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(classes != nullptr, "classes");
    const std::vector<uint8_t> found = limb_classes(map_rig_of(character->character), Axis::kY);
    std::copy(found.begin(), found.end(), classes);
  });
}

const char* sinew_character_notes(sinew_character* character) {
  if (character == nullptr) return "";
  const sinew_status status = guarded(character, [&] {
    std::string text;
    for (const std::string& note : character->character.notes) text += (text.empty() ? "" : "\n") + note;
    character->notes = std::move(text);
  });
  return status == SINEW_OK ? character->notes.c_str() : "";
}

sinew_status sinew_character_set_skeleton(sinew_character* character, const sinew_skeleton* skeleton) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(skeleton != nullptr, "skeleton");
    replace_skeleton(joints_of(skeleton), character);
  });
}

sinew_status sinew_character_take_skeleton(sinew_character* character, const sinew_character* other,
                                           uint32_t with_weights) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(other != nullptr, "other");
    const Character& from = other->character;
    if (from.joints.empty()) throw Error(from.name + ": expected a skeleton, found a mesh without one");
    std::vector<std::vector<Influence>> rows;
    if (with_weights != 0) {
      if (from.influences.size() != character->character.vertices.size())
        throw Error(from.name + ": expected weights for " + std::to_string(character->character.vertices.size()) +
                    " vertices, found " + std::to_string(from.influences.size()));
      rows = from.influences;
    }
    std::vector<Joint> joints = from.joints;
    replace_skeleton(std::move(joints), character);
    character->character.influences = std::move(rows);
  });
}

sinew_status sinew_character_set_weights(sinew_character* character, const uint32_t* row_offsets,
                                         const uint32_t* joint_indices, const float* weights) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(row_offsets != nullptr, "row_offsets");
    const Character& mesh = character->character;
    const size_t count = mesh.vertices.size();
    std::vector<std::vector<Influence>> rows(count);
    if (row_offsets[0] != 0) throw Failure(SINEW_ERROR_INDEX, "row_offsets: expected 0 first");
    for (size_t v = 0; v < count; ++v) {
      if (row_offsets[v + 1] < row_offsets[v])
        throw Failure(SINEW_ERROR_INDEX, "row_offsets: they fall at vertex " + std::to_string(v));
      need(row_offsets[v + 1] == 0 || (joint_indices != nullptr && weights != nullptr), "joint_indices, weights");
      std::set<uint32_t> seen;
      for (uint32_t i = row_offsets[v]; i < row_offsets[v + 1]; ++i) {
        if (joint_indices[i] >= mesh.joints.size() || !seen.insert(joint_indices[i]).second)
          throw Failure(SINEW_ERROR_RANGE, "joint_indices: vertex " + std::to_string(v) + " names joint " +
                                               std::to_string(joint_indices[i]) +
                                               ", which does not exist or which it has already");
        if (!std::isfinite(weights[i]) || weights[i] < 0)
          throw Failure(SINEW_ERROR_RANGE, "weights: expected 0 or more at vertex " + std::to_string(v));
        if (weights[i] > 0) rows[v].push_back({joint_indices[i], weights[i]});
      }
      std::stable_sort(rows[v].begin(), rows[v].end(),
                       [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    }
    character->character.influences = std::move(rows);
    character->character.confidence.clear();
    changed(character);
  });
}

}  // extern "C"
