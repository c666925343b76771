// SPDX-License-Identifier: MIT
// A bound strip of quads for tests of what two meshes share.
#ifndef SINEW_TESTS_SUPPORT_STRIP_OF_QUADS_HPP
#define SINEW_TESTS_SUPPORT_STRIP_OF_QUADS_HPP

#include "sinew_formats/character.hpp"

namespace sinew {

// A strip of quads along y with `extra` triangles behind it, `shift` vertices that no face names before it.
inline Character strip(size_t quads, size_t extra, size_t shift, float width) {
  Character c;
  c.name = "strip";
  c.joints = {{"a", {0, 0, 0}, -1}};
  c.vertices.resize(shift);
  for (size_t i = 0; i <= quads; ++i) {
    c.vertices.push_back({0, static_cast<float>(i), 0});
    c.vertices.push_back({width, static_cast<float>(i), 0});
  }
  const auto face = [&](std::initializer_list<size_t> corners) {
    for (const size_t v : corners) c.face_vertices.push_back(static_cast<uint32_t>(v + shift));
    c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
  };
  for (size_t i = 0; i < quads; ++i) face({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  for (size_t i = 0; i < extra; ++i) face({0, 2 * i + 2, 1});
  c.influences.assign(c.vertices.size(), {{0, 1.0f}});
  return c;
}

}  // namespace sinew
#endif
