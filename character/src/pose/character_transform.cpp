// SPDX-License-Identifier: MIT
// One transform for everything; quarters are exact.
#include "sinew_character/pose/character_transform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

Affine quarter(const std::string& turn) {
  const bool back = turn[0] == '-';
  const size_t axis = static_cast<size_t>(turn.back() - 'x'), from = (axis + 1) % 3, to = (axis + 2) % 3;
  Affine m{};
  m[4 * axis + axis] = 1;
  m[4 * to + from] = back ? -1 : 1;
  m[4 * from + to] = back ? 1 : -1;
  return m;
}

void move_point(const Affine& m, Vec3* p) {
  const auto moved =
      transform_point(m, static_cast<double>(p->x), static_cast<double>(p->y), static_cast<double>(p->z));
  *p = {static_cast<float>(moved[0]), static_cast<float>(moved[1]), static_cast<float>(moved[2])};
}

// Least and greatest of the vertices along a component, once they are transformed.
std::array<double, 2> reach(const Character& character, const Affine& m, Axis axis) {
  std::array<double, 2> reach = {INFINITY, -INFINITY};
  for (const Vec3& p : character.vertices) {
    const double x = transform_point(m, static_cast<double>(p.x), static_cast<double>(p.y),
                                     static_cast<double>(p.z))[axis_index(axis)];
    reach = {std::min(reach[0], x), std::max(reach[1], x)};
  }
  return reach;
}

void turn_normals(const Affine& m, Character* character) {
  for (Vec3& n : character->corner_normals) {
    const auto turned =
        transform_normal(m, static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z));
    const double length = std::hypot(turned[0], turned[1], turned[2]);
    if (!(length > 0)) continue;
    n = {static_cast<float>(turned[0] / length), static_cast<float>(turned[1] / length),
         static_cast<float>(turned[2] / length)};
  }
}

}  // namespace

bool is_identity(const CharacterTransform& transform) {
  return transform.turns.empty() && transform.height == 0 && !transform.floor;
}

void check_transform(const CharacterTransform& transform) {
  for (const std::string& turn : transform.turns) {
    const std::string axis = turn.substr(turn.rfind('-', 0) == 0 ? 1 : 0);
    if (axis != "x" && axis != "y" && axis != "z")
      throw Error("rotation " + in_quotes(turn) + ": expected x, y, z, -x, -y or -z");
  }
  if (!(transform.height >= 0) || std::isinf(transform.height))
    throw Error("height: expected meters above 0, as in 1.75");
}

Character transformed(Character character, const CharacterTransform& transform, Axis up_axis) {
  if (is_identity(transform)) return character;
  check_transform(transform);
  if (character.vertices.empty()) throw Error(character.name + ": has no mesh to rotate or scale");
  Affine m = kIdentity;
  for (const std::string& turn : transform.turns) m = multiply(quarter(turn), m);
  if (transform.height > 0) {
    const auto [low, high] = reach(character, m, up_axis);
    const double scale = transform.height / (high - low);
    if (!std::isfinite(scale))
      throw Error(character.name + ": is flat along " + (up_axis == Axis::kZ ? "z" : "y") +
                  ", so that height is 0; rotate it upright first");
    m = multiply({scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0}, m);
  }
  if (transform.floor) m[4 * axis_index(up_axis) + 3] -= reach(character, m, up_axis)[0];
  for (Vec3& p : character.vertices) move_point(m, &p);
  for (Joint& joint : character.joints) move_point(m, &joint.position);
  turn_normals(m, &character);
  if (character.gltf) {
    std::vector<Joint> own = character.gltf->joints;
    for (Joint& joint : own) move_point(m, &joint.position);
    character.gltf = transformed_document(character.name, *character.gltf, m, own);
  }
  return character;
}

}  // namespace sinew
