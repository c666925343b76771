// SPDX-License-Identifier: MIT
// The walking person with a skin: a small tetrahedron around every joint, bound to it and to its parent.
#ifndef SINEW_TESTS_SUPPORT_WALKING_FIGURE_HPP
#define SINEW_TESTS_SUPPORT_WALKING_FIGURE_HPP

#include <array>

#include "sinew_formats/character.hpp"
#include "walking_motion.hpp"

namespace sinew {

inline Character skinned_figure(const std::vector<Joint>& joints) {
  Character character;
  character.name = "figure";
  character.joints = joints;
  for (uint32_t j = 0; j < joints.size(); ++j) {
    const Vec3 p = joints[j].position;
    const uint32_t first = static_cast<uint32_t>(character.vertices.size());
    for (const Vec3 d : {Vec3{0.02f, 0, 0}, Vec3{-0.02f, 0, 0.01f}, Vec3{0, 0.02f, 0}, Vec3{0, -0.02f, 0.02f}}) {
      character.vertices.push_back({p.x + d.x, p.y + d.y, p.z + d.z});
      character.influences.push_back({{j, 0.75f}});
      if (joints[j].parent >= 0)
        character.influences.back().push_back({static_cast<uint32_t>(joints[j].parent), 0.25f});
      else
        character.influences.back()[0].weight = 1;
    }
    constexpr std::array<std::array<uint32_t, 3>, 4> kFaces = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    for (const auto& face : kFaces) {
      for (const uint32_t corner : face) character.face_vertices.push_back(first + corner);
      character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
    }
  }
  return character;
}

// 1.71 high.
inline Character walking_figure() { return skinned_figure(rest_joints(walking_person(2))); }

}  // namespace sinew
#endif
