// SPDX-License-Identifier: MIT
// A person of joints with rings of vertices around their bones, and what hangs on it.
#ifndef SINEW_TESTS_SUPPORT_HAIRY_PERSON_HPP
#define SINEW_TESTS_SUPPORT_HAIRY_PERSON_HPP

#include <cmath>
#include <string>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew_test {

using sinew::Point3;
using sinew::operator+;
using sinew::operator-;
using sinew::operator*;

struct HairyPerson {
  sinew::Character character;

  size_t add(const std::string& name, const Point3& at, int parent) {
    character.joints.push_back({name, sinew::to_vec3(at), parent});
    return character.joints.size() - 1;
  }
  size_t index(const std::string& name) const {
    size_t j = 0;
    while (character.joints[j].name != name) ++j;
    return j;
  }
  // Rings from a to b that follow one joint, with quads between them; open at both ends.
  void tube(size_t joint, const Point3& a, const Point3& b, double radius) { cone(joint, a, b, radius, radius); }
  void cone(size_t joint, const Point3& a, const Point3& b, double radius, double last_radius) {
    const Point3 along = sinew::unit(b - a),
                 side = sinew::unit(sinew::cross(along, std::abs(along[0]) < 0.9 ? Point3{1, 0, 0} : Point3{0, 1, 0}));
    const Point3 other = sinew::cross(along, side);
    const auto first = static_cast<uint32_t>(character.vertices.size());
    for (int ring = 0; ring <= 6; ++ring)
      for (int k = 0; k < 8; ++k) {
        const double angle = 0.785398 * k, r = radius + (ring / 6.0) * (last_radius - radius);
        const Point3 p = a + (ring / 6.0) * (b - a) + (r * std::cos(angle)) * side + (r * std::sin(angle)) * other;
        character.vertices.push_back(sinew::to_vec3(p));
        character.influences.push_back({{static_cast<uint32_t>(joint), 1.0f}});
      }
    for (uint32_t ring = 0; ring < 6; ++ring)
      for (uint32_t k = 0; k < 8; ++k)
        quad(first + 8 * ring + k, first + 8 * ring + (k + 1) % 8, first + 8 * (ring + 1) + (k + 1) % 8,
             first + 8 * (ring + 1) + k);
  }
  void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    character.face_vertices.insert(character.face_vertices.end(), {a, b, c, d});
    character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
  }
  // A joint with its skin up to where the next one is.
  size_t bone(const std::string& name, const Point3& at, int parent, const Point3& to, double radius) {
    const size_t joint = add(name, at, parent);
    tube(joint, at, to, radius);
    return joint;
  }
  // Joints NAME1, NAME2, ... from `at`, each `step` further, with skin around all.
  void chain(const std::string& name, int parent, Point3 at, const Point3& step, int count, double radius = 0.015) {
    for (int i = 1; i <= count; ++i) {
      parent = static_cast<int>(bone(name + std::to_string(i), at, parent, at + step, radius));
      at = at + step;
    }
  }

  HairyPerson() {
    character.name = "person";
    const int hips = static_cast<int>(bone("Hips", {0, 1, 0}, -1, {0, 1.15, 0}, 0.15));
    const int spine = static_cast<int>(bone("Spine", {0, 1.15, 0}, hips, {0, 1.3, 0}, 0.13));
    const int chest = static_cast<int>(bone("Spine1", {0, 1.3, 0}, spine, {0, 1.5, 0}, 0.14));
    const int neck = static_cast<int>(bone("Neck", {0, 1.5, 0}, chest, {0, 1.56, 0}, 0.05));
    (void)bone("Head", {0, 1.56, 0}, neck, {0, 1.8, 0}, 0.1);
    for (const double side : {1.0, -1.0}) {
      const std::string name = side > 0 ? "Left" : "Right";
      const int shoulder = static_cast<int>(add(name + "Shoulder", {0.05 * side, 1.45, 0}, chest));
      const int arm =
          static_cast<int>(bone(name + "Arm", {0.18 * side, 1.45, 0}, shoulder, {0.45 * side, 1.45, 0}, 0.045));
      const int fore =
          static_cast<int>(bone(name + "ForeArm", {0.45 * side, 1.45, 0}, arm, {0.7 * side, 1.45, 0}, 0.035));
      const int hand = static_cast<int>(bone(name + "Hand", {0.7 * side, 1.45, 0}, fore, {0.8 * side, 1.45, 0}, 0.03));
      chain(name + "HandIndex", hand, {0.8 * side, 1.45, 0}, {0.03 * side, 0, 0}, 3, 0.008);
      const int leg = static_cast<int>(bone(name + "UpLeg", {0.09 * side, 0.95, 0}, hips, {0.09 * side, 0.5, 0}, 0.07));
      const int shin = static_cast<int>(bone(name + "Leg", {0.09 * side, 0.5, 0}, leg, {0.09 * side, 0.1, 0}, 0.05));
      (void)bone(name + "Foot", {0.09 * side, 0.1, 0}, shin, {0.09 * side, 0, 0.15}, 0.04);
    }
  }
};

}  // namespace sinew_test
#endif
