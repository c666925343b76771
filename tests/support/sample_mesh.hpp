// SPDX-License-Identifier: MIT
// The mesh of a character of samples/data, as the engine takes it.
#ifndef SINEW_TESTS_SAMPLE_MESH_HPP
#define SINEW_TESTS_SAMPLE_MESH_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "mesh_scene.hpp"
#include "sinew_formats/io.hpp"

namespace sinew_test {

inline MeshScene from_file(const std::string& name) {
  const sinew::Character character = sinew::read_mesh(SINEW_SOURCE_DIR "/samples/data/" + name);
  MeshScene scene;
  for (const sinew::Vec3& v : character.vertices) scene.add_vertex(v.x, v.y, v.z);
  for (size_t f = 0; f < character.face_count(); ++f) {
    scene.add_face(std::vector<uint32_t>(character.face_vertices.begin() + character.face_offsets[f],
                                         character.face_vertices.begin() + character.face_offsets[f + 1]));
  }
  return scene;
}

}  // namespace sinew_test
#endif
