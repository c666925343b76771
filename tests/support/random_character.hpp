// SPDX-License-Identifier: MIT
// Random characters for properties of readers and writers: any polygons, any tree of joints, any weights, from one
// seed.
#ifndef SINEW_TESTS_RANDOM_CHARACTER_HPP
#define SINEW_TESTS_RANDOM_CHARACTER_HPP

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "sinew_formats/character.hpp"

struct RandomCharacter {
  explicit RandomCharacter(uint64_t seed) : random(seed) {}

  uint32_t below(uint32_t limit) { return static_cast<uint32_t>(random() % limit); }
  float real(float scale) { return (static_cast<float>(random() >> 40) / 8388608.0f - 1.0f) * scale; }

  sinew::Character make() {
    sinew::Character c;
    c.name = "random";
    const uint32_t vertex_count = 3 + below(60), joint_count = 1 + below(12);
    const float scale = std::pow(10.0f, real(3));
    for (uint32_t v = 0; v < vertex_count; ++v) c.vertices.push_back({real(scale), real(scale), real(scale)});
    const bool uvs = below(2) != 0, normals = below(2) != 0, materials = below(2) != 0, groups = below(2) != 0;
    if (materials) c.material_names = {"skin", "cloth two"};
    if (groups) c.group_names = {"a", "b c", "d"};
    std::vector<uint32_t> order(vertex_count);
    for (uint32_t v = 0; v < vertex_count; ++v) order[v] = v;
    // Materials and groups in the order of first use, as every reader numbers them.
    int material = -1, group = -1;
    for (uint32_t f = 0, count = 1 + below(80); f < count; ++f) {
      std::shuffle(order.begin(), order.end(), random);
      const uint32_t corners = 3 + below(std::min(vertex_count - 2, 5u));
      for (uint32_t k = 0; k < corners; ++k) {
        c.face_vertices.push_back(order[k]);
        if (uvs) c.corner_uvs.push_back({real(2), real(2)});
        if (normals) c.corner_normals.push_back({real(1), real(1), 0.5f});
      }
      c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
      if (materials && below(3) == 0) material = f < 3 ? 0 : material == 0 && c.face_materials.size() > 2 ? 1 : 0;
      if (groups && below(3) == 0) group = std::min(group + 1, 2);
      if (materials) c.face_materials.push_back(material = std::max(material, 0));
      if (groups) c.face_groups.push_back(group = std::max(group, 0));
    }
    if (materials)
      c.material_names.resize(static_cast<size_t>(*std::max_element(c.face_materials.begin(), c.face_materials.end())) +
                              1);
    if (groups)
      c.group_names.resize(static_cast<size_t>(*std::max_element(c.face_groups.begin(), c.face_groups.end())) + 1);

    // A joint's parent has a smaller number in a shuffled order, so that parents may come later in the list.
    std::vector<uint32_t> new_index(joint_count);
    for (uint32_t j = 0; j < joint_count; ++j) new_index[j] = j;
    std::shuffle(new_index.begin(), new_index.end(), random);
    c.joints.resize(joint_count);
    for (uint32_t j = 0; j < joint_count; ++j) {
      sinew::Joint& joint = c.joints[new_index[j]];
      joint.name = "j" + std::to_string(new_index[j]);
      joint.position = {real(scale), real(scale), real(scale)};
      joint.parent = j == 0 || below(10) == 0 ? -1 : static_cast<int>(new_index[below(j)]);
    }
    c.influences.resize(vertex_count);
    for (auto& row : c.influences) {
      if (below(20) == 0) continue;
      std::shuffle(new_index.begin(), new_index.end(), random);
      float total = 0;
      for (uint32_t k = 0, count = 1 + below(std::min(joint_count, 9u)); k < count; ++k) {
        row.push_back({new_index[k], 0.001f + std::fabs(real(1))});
        total += row.back().weight;
      }
      for (sinew::Influence& influence : row) influence.weight /= total;
    }
    return c;
  }

  std::mt19937_64 random;
};

#endif
