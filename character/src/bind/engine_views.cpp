// SPDX-License-Identifier: MIT
// The arrays of a Character in the engine's order, and its refusals as errors with the character's name.
#include "sinew_character/bind/engine_views.hpp"

#include <string>

#include "sinew_formats/error.hpp"

namespace sinew {

EngineViews::EngineViews(const Character& character, const std::vector<uint8_t>& joint_flags, Axis up_axis)
    : flags(joint_flags) {
  skeleton.up = engine_up(up_axis);
  positions.reserve(character.vertices.size() * 3);
  for (const Vec3& p : character.vertices) positions.insert(positions.end(), {p.x, p.y, p.z});
  for (const Joint& joint : character.joints) {
    joint_positions.insert(joint_positions.end(), {joint.position.x, joint.position.y, joint.position.z});
    parents.push_back(joint.parent);
  }
  mesh.positions = positions.data();
  mesh.vertex_count = static_cast<uint32_t>(character.vertices.size());
  mesh.face_offsets = character.face_offsets.data();
  mesh.face_vertices = character.face_vertices.data();
  mesh.face_count = static_cast<uint32_t>(character.face_count());
  mesh.corner_count = static_cast<uint32_t>(character.face_vertices.size());
  skeleton.positions = joint_positions.data();
  skeleton.parents = parents.data();
  skeleton.flags = flags.empty() ? nullptr : flags.data();
  skeleton.joint_count = static_cast<uint32_t>(character.joints.size());
}

SkeletonView::SkeletonView(const std::vector<Joint>& joints) {
  for (const Joint& joint : joints) {
    positions.insert(positions.end(), {joint.position.x, joint.position.y, joint.position.z});
    parents.push_back(joint.parent);
    names.push_back(joint.name.c_str());
  }
  skeleton = SINEW_INIT(sinew_skeleton);
  skeleton.positions = positions.data();
  skeleton.parents = parents.data();
  skeleton.joint_count = static_cast<uint32_t>(joints.size());
  skeleton.names = names.data();
}

void check_bindable(const Character& character) {
  if (character.vertices.empty()) throw Error(character.name + ": the mesh has no vertices");
  if (character.joints.empty()) {
    throw Error(character.name + ": no skeleton; give one with --skeleton or use a file that has a skin");
  }
  if (character.joints.size() > SINEW_MAX_JOINTS) {
    throw Error(character.name + ": " + std::to_string(character.joints.size()) + " joints, at most " +
                std::to_string(SINEW_MAX_JOINTS) + " are supported");
  }
  if (character.vertices.size() > SINEW_MAX_VERTICES) {
    throw Error(character.name + ": " + std::to_string(character.vertices.size()) + " vertices, at most " +
                std::to_string(SINEW_MAX_VERTICES) + " are supported");
  }
}

void throw_status(const Character& character, sinew_status status) {
  if (status != SINEW_OK) throw Error(character.name + ": " + sinew_status_text(status));
}

}  // namespace sinew
