// SPDX-License-Identifier: MIT
// What the fuzz targets of the engine share: the bundled models, and bytes as a mesh.
#ifndef SINEW_TESTS_FUZZ_MESH_INPUT_HPP
#define SINEW_TESTS_FUZZ_MESH_INPUT_HPP

#include "bundled_model.hpp"
#include "fuzz.hpp"

namespace sinew::test {

inline const sinew_model* fuzzed_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew", sinew_model_open);
  demand(opened.ok, "samples/data/sinew_default.sinew is there and opens");
  return &opened.model;
}

// What faces may be; bits of MeshInput's `shape`.
enum MeshShape : uint8_t { kRawFloats = 4, kPolygons = 8, kBeyond = 16, kAnyOffsets = 32 };

inline float any_float(Bytes& in, bool raw) {
  if (!raw) return static_cast<float>(static_cast<int16_t>(in.u16())) / 256.0f;
  const uint32_t bits = in.u32();
  float value;
  std::memcpy(&value, &bits, 4);
  return value;
}

struct MeshInput {
  std::vector<float> positions;
  std::vector<uint32_t> offsets, corners;
  sinew_mesh mesh = {};  // views of the arrays

  void read(Bytes& in, uint8_t shape, uint32_t vertices, uint32_t faces) {
    for (uint32_t i = 0; i < 3 * vertices; ++i) positions.push_back(any_float(in, (shape & kRawFloats) != 0));
    // Faces: triangles without offsets, polygons, or any offsets at all.
    offsets.push_back((shape & kAnyOffsets) != 0 ? in.u8() : 0);
    for (uint32_t f = 0; f < faces; ++f) {
      const uint32_t length = (shape & kPolygons) != 0 ? 2 + in.below(5) : 3;
      offsets.push_back((shape & kAnyOffsets) != 0 ? in.u32() % 200 : offsets.back() + length);
    }
    const uint32_t corner_count = (shape & kAnyOffsets) != 0 ? in.below(160) : offsets.back();
    const uint32_t beyond = (shape & kBeyond) != 0 ? 1 : 0;
    for (uint32_t c = 0; c < corner_count; ++c)
      corners.push_back(vertices + beyond > 0 ? in.below(vertices + beyond) : 0);
    mesh.positions = positions.data();
    mesh.vertex_count = vertices;
    mesh.face_offsets = (shape & (kPolygons | kAnyOffsets)) != 0 ? offsets.data() : nullptr;
    mesh.face_vertices = corners.data();
    mesh.face_count = faces;
    mesh.corner_count = corner_count;
  }
};

}  // namespace sinew::test
#endif
