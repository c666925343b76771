// SPDX-License-Identifier: MIT
// What the fuzz targets of the engine share: the bundled models, bytes as a mesh and as a skeleton, and what goes wrong around a
// call.
#ifndef SINEW_TESTS_FUZZ_MESH_INPUT_HPP
#define SINEW_TESTS_FUZZ_MESH_INPUT_HPP

#include <algorithm>
#include <cmath>

#include "bundled_model.hpp"
#include "fuzz.hpp"
#include "skeleton_of.hpp"

namespace sinew::test {

inline const sinew_model* fuzzed_model() {
  static const sinew_test::BundledModel opened(SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew", sinew_model_open);
  demand(opened.ok, "samples/data/sinew_default.sinew is there and opens");
  return &opened.model;
}

// What joints and faces may be; bits of `shape`.
enum InputShape : uint8_t {
  kRawJoints = 1,   // any floats for joints, NaN too
  kAnyParents = 2,  // any numbers; else parents come first
  kRawFloats = 4,   // any floats for vertices
  kPolygons = 8,
  kBeyond = 16,  // corners may name a vertex that does not exist
  kAnyOffsets = 32
};

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

struct SkeletonInput {
  std::vector<float> joint_positions;
  std::vector<int32_t> parents;
  std::vector<uint8_t> flags;                            // few joints have any
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);  // views of the arrays, without flags

  void read_joints(Bytes& in, uint8_t shape, uint32_t joints) {
    for (uint32_t i = 0; i < 3 * joints; ++i) joint_positions.push_back(any_float(in, (shape & kRawJoints) != 0));
    for (uint32_t j = 0; j < joints; ++j) {
      parents.push_back((shape & kAnyParents) != 0 ? static_cast<int8_t>(in.u8())
                                                   : static_cast<int32_t>(in.below(j + 1)) - 1);
      flags.push_back(in.u8() % 16 == 0 ? in.u8() : uint8_t{0});
    }
    skeleton = sinew_test::skeleton_of(joint_positions.data(), parents.data(), joints);
  }
};

inline bool any_not_finite(const std::vector<float>& values) {
  return std::any_of(values.begin(), values.end(), [](float x) { return !std::isfinite(x); });
}

// What hinders a call: too few bytes, bytes that are not aligned, a callback that cancels. Bits 32, 64 and 128 of `extras`.
struct Hindrance {
  size_t short_by = 0, misaligned = 0;
  uint32_t cancel_at = 0, reports = 0;

  void read_hindrance(Bytes& in, uint8_t extras) {
    if ((extras & 32) != 0) short_by = 1 + in.u16();
    if ((extras & 64) != 0) misaligned = in.below(64);
    if ((extras & 128) != 0) cancel_at = 1 + in.below(32);
  }
  size_t given(size_t need) const { return short_by > need ? 0 : need - short_by; }
  // A progress callback; `user` is the Hindrance.
  static int report(void* user, uint32_t permille) {
    Hindrance& self = *static_cast<Hindrance*>(user);
    demand(permille <= 1000, "progress is 0 to 1000");
    return ++self.reports == self.cancel_at ? 1 : 0;
  }
  // Whether a refusal is one of those that a hindrance brings; there must be one then.
  bool explains(sinew_status status) const {
    if (status == SINEW_ERROR_WORKSPACE)
      demand(short_by != 0 || misaligned % 64 != 0, "the promised workspace is enough");
    if (status == SINEW_ERROR_CANCELLED)
      demand(cancel_at != 0 && reports == cancel_at, "cancelled only when the callback says so");
    return status == SINEW_ERROR_WORKSPACE || status == SINEW_ERROR_CANCELLED;
  }
};

}  // namespace sinew::test
#endif
