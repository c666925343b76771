// SPDX-License-Identifier: MIT
// Joints in the air beside the mesh: poles and targets without telling names.
#include <algorithm>
#include <array>
#include <cmath>

#include "names/joint_name.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

constexpr float kFar = 0.06f;  // of the mesh's diagonal, to the nearest vertex

bool deforms(uint8_t role) { return role == SINEW_ROLE_DEFORMS || role > SINEW_ROLE_END; }

float square_to_mesh(const Character& character, const Vec3& p) {
  float nearest = INFINITY;
  for (const Vec3& q : character.vertices) {
    const float x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
    nearest = std::min(nearest, x * x + y * y + z * z);
  }
  return nearest;
}

float coordinate(const Vec3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

}  // namespace

int directions_with_mesh(const Character& character, const Vec3& p) {
  std::array<bool, 6> hit{};
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], last = character.face_offsets[f + 1];
    for (uint32_t c = first + 2; c < last; ++c) {
      const Vec3 &a = character.vertices[character.face_vertices[first]],
                 &b = character.vertices[character.face_vertices[c - 1]],
                 &d = character.vertices[character.face_vertices[c]];
      for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto side = [&](const Vec3& from, const Vec3& to) {
          return static_cast<double>(coordinate(to, u) - coordinate(from, u)) *
                     static_cast<double>(coordinate(p, v) - coordinate(from, v)) -
                 static_cast<double>(coordinate(to, v) - coordinate(from, v)) *
                     static_cast<double>(coordinate(p, u) - coordinate(from, u));
        };
        const double wa = side(b, d), wb = side(d, a), wd = side(a, b), sum = wa + wb + wd;
        const bool inside = (wa >= 0 && wb >= 0 && wd >= 0) || (wa <= 0 && wb <= 0 && wd <= 0);
        if (!inside || sum == 0) continue;
        const double at =
            (wa * static_cast<double>(coordinate(a, axis)) + wb * static_cast<double>(coordinate(b, axis)) +
             wd * static_cast<double>(coordinate(d, axis))) /
            sum;
        hit[static_cast<size_t>(axis * 2 + (at < static_cast<double>(coordinate(p, axis)) ? 0 : 1))] = true;
      }
    }
  }
  return static_cast<int>(std::count(hit.begin(), hit.end(), true));
}

void find_joints_beside_mesh(const Character& character, std::vector<uint8_t>* roles) {
  if (character.vertices.empty()) return;
  const float size = box_of(character.vertices).diagonal();
  const size_t count = character.joints.size();
  std::vector<char> beside(count, 0);
  for (size_t j = 0; j < count; ++j) {
    const Vec3& p = character.joints[j].position;
    const float nearest = square_to_mesh(character, p);
    beside[j] = nearest > kFar * kFar * size * size && directions_with_mesh(character, p) <= kMostHitsOutside ? 1 : 0;
  }
  // Parents may come later: a joint stays where any joint below it does.
  for (size_t j = 0; j < count; ++j) {
    if (beside[j] != 0 || (*roles)[j] == SINEW_ROLE_END) continue;
    size_t steps = 0;
    for (int up = character.joints[j].parent; up >= 0 && steps < count; ++steps) {
      beside[static_cast<size_t>(up)] = 0;
      up = character.joints[static_cast<size_t>(up)].parent;
    }
  }
  // A descendant of a limb is part of the limb, wherever it is: poles and targets are children of roots or controls,
  // or roots.
  for (size_t j = 0; j < count; ++j) {
    const int parent = character.joints[j].parent;
    if (parent >= 0 && deforms((*roles)[static_cast<size_t>(parent)]) && beside[static_cast<size_t>(parent)] == 0)
      beside[j] = 0;
  }
  const size_t found = static_cast<size_t>(std::count(beside.begin(), beside.end(), char{1}));
  if (found * 2 > count) return;  // the skeleton does not fit the mesh: another matter
  for (size_t j = 0; j < count; ++j)
    if (beside[j] != 0 && deforms((*roles)[j])) (*roles)[j] = SINEW_ROLE_CONTROL;
}

void find_tips_without_mesh(const Character& character, std::vector<uint8_t>* roles) {
  if (character.vertices.empty()) return;
  const float far = kFar * box_of(character.vertices).diagonal();
  std::vector<char> leaf(character.joints.size(), 1);
  for (const Joint& joint : character.joints)
    if (joint.parent >= 0) leaf[static_cast<size_t>(joint.parent)] = 0;
  for (size_t j = 0; j < leaf.size(); ++j) {
    const Joint& joint = character.joints[j];
    if (leaf[j] == 0 || joint.parent < 0 || !deforms((*roles)[j])) continue;
    if (!names::read_joint_name(joint.name.c_str()).has(names::kTip)) continue;
    if (square_to_mesh(character, joint.position) > far * far) (*roles)[j] = SINEW_ROLE_END;
  }
}

}  // namespace sinew
