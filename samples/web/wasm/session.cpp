// SPDX-License-Identifier: MIT
// One session a module, and what keeps its parts in step.
#include "session.hpp"

#include <cmath>
#include <cstring>
#include <utility>

#include "sinew_character/pose/rest_pose.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::web {

namespace {

void swap_stance(Session& s, Stance* other) {
  std::swap(s.character.vertices, other->vertices);
  std::swap(s.character.corner_normals, other->corner_normals);
  std::swap(s.character.joints, other->joints);
  std::swap(s.character.gltf, other->gltf);
  s.rest.clear();
  for (const Vec3& p : s.character.vertices) s.rest.insert(s.rest.end(), {p.x, p.y, p.z});
  s.skinning.forget();
  s.posed = s.rest;
  show(s);
}

Character in_pose(const Session& s, const Character& standing) {
  return in_rest_pose(standing, read_rest_pose(s.to_pose), s.up_axis);
}

}  // namespace

Session& session() {
  static Session only;
  return only;
}

void show(Session& s) {
  const size_t shown = s.surface.vertex_of.size();
  s.shown_positions.resize(shown * 3);
  for (size_t i = 0; i < shown; ++i)
    std::memcpy(&s.shown_positions[i * 3], &s.posed[size_t{s.surface.vertex_of[i]} * 3], 3 * sizeof(float));
  surface_normals(s.surface, s.posed, &s.shown_normals);
}

// The rows as skin() takes them: [V x slots], unused slots 0.
void fill_slots(Session& s) {
  s.skinning.forget();
  s.joints.assign(s.character.vertices.size() * s.slots, 0);
  s.weights.assign(s.joints.size(), 0);
  for (size_t v = 0; v < s.character.influences.size(); ++v) {
    const std::vector<Influence>& row = s.character.influences[v];
    for (size_t i = 0; i < row.size() && i < s.slots; ++i) {
      s.joints[v * s.slots + i] = static_cast<uint16_t>(row[i].joint);
      s.weights[v * s.slots + i] = static_cast<uint16_t>(std::lround(row[i].weight * 65535.0f));
    }
  }
}

// Shows rows instead of those that are shown, which become the argument.
void swap_rows(Session& s, Rows* rows) {
  std::swap(s.character.influences, rows->influences);
  std::swap(s.confidence, rows->confidence);
  fill_slots(s);
}

void end_preview(Session& s) {
  if (s.taken.influences.empty()) return;
  stand(s);
  swap_rows(s, &s.taken);
  s.taken = {};
  strike(s);
}

void stand(Session& s) {
  if (!s.standing) return;
  swap_stance(s, &*s.standing);
  s.standing.reset();
}

void strike(Session& s) {
  const std::shared_ptr<const PictureCharacter> picture = s.picture();
  const bool flat = picture != nullptr && picture->options.mesh.flat;
  if ((s.to_pose.empty() && !flat) || s.standing) return;
  Character posed = s.to_pose.empty() ? s.character : in_pose(s, s.character);
  if (flat) flatten(&posed);
  Stance stance = {std::move(posed.vertices), std::move(posed.corner_normals), std::move(posed.joints),
                   std::move(posed.gltf)};
  swap_stance(s, &stance);
  s.standing = std::move(stance);
}

Character written(const Session& s) {
  Character character = s.character;
  if (!s.standing || s.to_pose.empty() || s.seams.seams.empty()) return character;
  character.vertices = s.standing->vertices;
  character.corner_normals = s.standing->corner_normals;
  character.joints = s.standing->joints;
  character.gltf = s.standing->gltf;
  cut_seams(s.seams, &character);
  return in_pose(s, character);
}

void need_joints(const Session& s) {
  if (s.character.joints.empty()) throw Error(s.character.name + ": has no skeleton yet");
}

void need_weights(const Session& s) {
  if (s.weights.empty()) throw Error("no character is bound yet");
}

}  // namespace sinew::web
