// SPDX-License-Identifier: MIT
// Every function with structs that grow, called by a program compiled with the first release's header, and by one compiled with a header of the
// future: what its structs hold beyond this library's decides.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "bundled_model.hpp"
#include "first_release.h"
#include "sinew/motion_clips.h"
#include "sinew/published.h"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

// Members never move, and nothing is put between them.
#define SINEW_KEEPS(type, member) \
  static_assert(offsetof(type, member) == offsetof(type##_0_1, member), #member " stands elsewhere")
SINEW_KEEPS(sinew_bind_options, struct_size);
SINEW_KEEPS(sinew_bind_options, method);
SINEW_KEEPS(sinew_bind_options, influence_count);
SINEW_KEEPS(sinew_bind_options, weight_format);
SINEW_KEEPS(sinew_bind_options, candidate_count);
SINEW_KEEPS(sinew_bind_options, grid_size);
SINEW_KEEPS(sinew_bind_options, surface_vertices);
SINEW_KEEPS(sinew_bind_options, symmetric);
SINEW_KEEPS(sinew_bind_options, rigid_parts);
SINEW_KEEPS(sinew_bind_options, softness_percent);
SINEW_KEEPS(sinew_bind_options, weights_in_place);
SINEW_KEEPS(sinew_bind_options, kernel);
SINEW_KEEPS(sinew_bind_options, thread_count);
SINEW_KEEPS(sinew_bind_options, reserved);
SINEW_KEEPS(sinew_bind_options, locked);
SINEW_KEEPS(sinew_bind_options, hints);
SINEW_KEEPS(sinew_bind_options, parallel_for);
SINEW_KEEPS(sinew_bind_options, parallel_user);
SINEW_KEEPS(sinew_bind_options, progress);
SINEW_KEEPS(sinew_bind_options, progress_user);
SINEW_KEEPS(sinew_bind_outputs, struct_size);
SINEW_KEEPS(sinew_bind_outputs, symmetric_vertices);
SINEW_KEEPS(sinew_bind_outputs, joint_indices);
SINEW_KEEPS(sinew_bind_outputs, weights);
SINEW_KEEPS(sinew_bind_outputs, confidence);
SINEW_KEEPS(sinew_bind_outputs, used_bytes);
SINEW_KEEPS(sinew_rig_options, struct_size);
SINEW_KEEPS(sinew_rig_options, up);
SINEW_KEEPS(sinew_rig_options, mirror);
SINEW_KEEPS(sinew_rig_options, spine_count);
SINEW_KEEPS(sinew_rig_options, without);
SINEW_KEEPS(sinew_rig_options, reserved);
SINEW_KEEPS(sinew_rig_options, weights_in_place);
SINEW_KEEPS(sinew_rig_options, kernel);
SINEW_KEEPS(sinew_rig_options, progress);
SINEW_KEEPS(sinew_rig_options, progress_user);
SINEW_KEEPS(sinew_rig_outputs, struct_size);
SINEW_KEEPS(sinew_rig_outputs, joint_count);
SINEW_KEEPS(sinew_rig_outputs, positions);
SINEW_KEEPS(sinew_rig_outputs, parents);
SINEW_KEEPS(sinew_rig_outputs, flags);
SINEW_KEEPS(sinew_rig_outputs, joint_classes);
SINEW_KEEPS(sinew_rig_outputs, partners);
SINEW_KEEPS(sinew_rig_outputs, confidence);
SINEW_KEEPS(sinew_rig_outputs, parent_confidence);
SINEW_KEEPS(sinew_rig_outputs, names);
SINEW_KEEPS(sinew_rig_outputs, mirrored);
SINEW_KEEPS(sinew_rig_outputs, facing);
SINEW_KEEPS(sinew_rig_outputs, plane);
SINEW_KEEPS(sinew_rig_outputs, spread);
SINEW_KEEPS(sinew_rig_outputs, used_bytes);
SINEW_KEEPS(sinew_deform_options, struct_size);
SINEW_KEEPS(sinew_deform_options, method);
SINEW_KEEPS(sinew_deform_options, cell_count);
SINEW_KEEPS(sinew_deform_options, round_count);
SINEW_KEEPS(sinew_deform_options, softness);
SINEW_KEEPS(sinew_deform_options, without);
SINEW_KEEPS(sinew_deform_options, thread_count);
SINEW_KEEPS(sinew_deform_options, body_contact);
SINEW_KEEPS(sinew_deform_outputs, struct_size);
SINEW_KEEPS(sinew_deform_outputs, corrected);
SINEW_KEEPS(sinew_deform_outputs, positions);
SINEW_KEEPS(sinew_deform_outputs, active_tetrahedra);
SINEW_KEEPS(sinew_deform_outputs, inverted_tetrahedra);
SINEW_KEEPS(sinew_retarget_options, struct_size);
SINEW_KEEPS(sinew_retarget_options, method);
SINEW_KEEPS(sinew_retarget_options, in_place);
SINEW_KEEPS(sinew_retarget_options, scale);
SINEW_KEEPS(sinew_contact_options, struct_size);
SINEW_KEEPS(sinew_contact_options, fps);
SINEW_KEEPS(sinew_contact_options, progress);
SINEW_KEEPS(sinew_contact_options, progress_user);
SINEW_KEEPS(sinew_reference_options, struct_size);
SINEW_KEEPS(sinew_reference_options, area_power);
SINEW_KEEPS(sinew_reference_options, own_limb);
SINEW_KEEPS(sinew_reference_options, legs);
SINEW_KEEPS(sinew_reference_options, falloff);
SINEW_KEEPS(sinew_reference_options, least_cosine);
SINEW_KEEPS(sinew_reference_options, progress);
SINEW_KEEPS(sinew_reference_options, progress_user);
SINEW_KEEPS(sinew_skeleton, struct_size);
SINEW_KEEPS(sinew_skeleton, joint_count);
SINEW_KEEPS(sinew_skeleton, positions);
SINEW_KEEPS(sinew_skeleton, parents);
SINEW_KEEPS(sinew_skeleton, flags);
SINEW_KEEPS(sinew_skeleton, ends);
SINEW_KEEPS(sinew_skeleton, names);
SINEW_KEEPS(sinew_skeleton, rotations);
SINEW_KEEPS(sinew_skeleton, up);
SINEW_KEEPS(sinew_skeleton, reserved);
SINEW_KEEPS(sinew_map_options, struct_size);
SINEW_KEEPS(sinew_map_options, method);
SINEW_KEEPS(sinew_map_options, pin_count);
SINEW_KEEPS(sinew_map_options, reserved);
SINEW_KEEPS(sinew_map_options, pins);
SINEW_KEEPS(sinew_map_outputs, struct_size);
SINEW_KEEPS(sinew_map_outputs, method);
SINEW_KEEPS(sinew_map_outputs, sources);
SINEW_KEEPS(sinew_map_outputs, confidence);
SINEW_KEEPS(sinew_map_outputs, reasons);
SINEW_KEEPS(sinew_map_outputs, mapped);
SINEW_KEEPS(sinew_map_outputs, certainty);
SINEW_KEEPS(sinew_map_outputs, used_bytes);
SINEW_KEEPS(sinew_transfer_options, struct_size);
SINEW_KEEPS(sinew_transfer_options, method);
SINEW_KEEPS(sinew_transfer_options, influence_count);
SINEW_KEEPS(sinew_transfer_options, weight_format);
SINEW_KEEPS(sinew_transfer_options, garment);
SINEW_KEEPS(sinew_transfer_options, as_drawn);
SINEW_KEEPS(sinew_transfer_options, weights_in_place);
SINEW_KEEPS(sinew_transfer_options, kernel);
SINEW_KEEPS(sinew_transfer_options, thread_count);
SINEW_KEEPS(sinew_transfer_options, pair_count);
SINEW_KEEPS(sinew_transfer_options, locked);
SINEW_KEEPS(sinew_transfer_options, pairs);
SINEW_KEEPS(sinew_transfer_options, parallel_for);
SINEW_KEEPS(sinew_transfer_options, parallel_user);
SINEW_KEEPS(sinew_transfer_options, progress);
SINEW_KEEPS(sinew_transfer_options, progress_user);
SINEW_KEEPS(sinew_transfer_outputs, struct_size);
SINEW_KEEPS(sinew_transfer_outputs, part_capacity);
SINEW_KEEPS(sinew_transfer_outputs, joint_indices);
SINEW_KEEPS(sinew_transfer_outputs, weights);
SINEW_KEEPS(sinew_transfer_outputs, confidence);
SINEW_KEEPS(sinew_transfer_outputs, parts);
SINEW_KEEPS(sinew_transfer_outputs, vertex_parts);
SINEW_KEEPS(sinew_transfer_outputs, part_count);
SINEW_KEEPS(sinew_transfer_outputs, bound_by);
SINEW_KEEPS(sinew_transfer_outputs, carried_q16);
SINEW_KEEPS(sinew_transfer_outputs, style_q16);
SINEW_KEEPS(sinew_transfer_outputs, mismatch_q16);
SINEW_KEEPS(sinew_transfer_outputs, reference_count);
SINEW_KEEPS(sinew_transfer_outputs, used_bytes);
SINEW_KEEPS(sinew_simplify_options, struct_size);
SINEW_KEEPS(sinew_simplify_options, level);
SINEW_KEEPS(sinew_simplify_options, joint_count);

namespace {

// A caller's struct with memory behind it that the library must leave alone.
template <class Struct>
struct Guarded {
  Struct known;
  uint8_t behind[256];

  explicit Guarded(const Struct& s) : known(s) { std::memset(behind, 0x5A, sizeof behind); }
  void expect_untouched() const {
    for (const uint8_t byte : behind) ASSERT_EQ(byte, 0x5A) << "a member that this program lacks was written";
  }
};

// A header of the future: a member more.
template <class Struct>
struct Future {
  Struct known;
  const void* more;
};

// Calls run(size) with sizes of a struct that no header has: every one is refused.
template <class Run>
void expect_sizes_refused(size_t first_size, Run run) {
  for (const uint32_t size : {0u, static_cast<uint32_t>(first_size) - 1, 4097u})
    EXPECT_EQ(run(size), SINEW_ERROR_ARGUMENT) << size;
}

// A bar of four rings with two bones, and what every call binds into.
class GrowingStructs : public ::testing::Test {
 protected:
  GrowingStructs() {
    for (int ring = 0; ring < 4; ++ring) {
      for (const auto& c : {std::array<float, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        positions.insert(positions.end(), {c[0], static_cast<float>(ring), c[1]});
    }
    for (uint32_t a = 0; a < 12; ++a) {
      const uint32_t b = a % 4 == 3 ? a - 3 : a + 1;
      corners.insert(corners.end(), {a, a + 4, b + 4, a, b + 4, b});
    }
  }

  // The size query and the bind with a caller's structs of any version; the first status that is not SINEW_OK.
  template <class Options, class Outputs>
  sinew_status bind(const Options& options, Outputs* outputs) {
    const float joint_positions[] = {0.5f, 0.1f, 0.5f, 0.5f, 2, 0.5f};
    const int32_t parents[] = {-1, 0};
    const sinew_mesh mesh = {positions.data(), kVertices, nullptr, corners.data(), kTriangles, 3 * kTriangles};
    sinew_skeleton skeleton = sinew_test::skeleton_of(joint_positions, parents, 2);
    const auto* const o = reinterpret_cast<const sinew_bind_options*>(&options);
    size_t bytes = 0;
    const sinew_status sized = sinew_bind_workspace_size(nullptr, mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                                         skeleton.joint_count, o, &bytes);
    sinew::Workspace workspace(sized == SINEW_OK ? bytes : size_t{1} << 20);
    const sinew_status bound = sinew_bind(nullptr, &mesh, &skeleton, o, workspace.data(), workspace.size(),
                                          reinterpret_cast<sinew_bind_outputs*>(outputs));
    // A fault of the options is seen by both, one of the outputs by the bind alone.
    if (sized != SINEW_OK) {
      EXPECT_EQ(bound, sized);
    }
    return bound;
  }

  // Everything set that a heat bind takes, so that a member that stands elsewhere is seen.
  template <class Options>
  static Options filled(uint32_t size) {
    Options options = {};
    options.struct_size = size;
    options.method = SINEW_METHOD_HEAT;
    options.influence_count = kInfluences;
    options.weight_format = SINEW_WEIGHT_UNORM16;
    options.symmetric = 1;
    options.kernel = SINEW_KERNEL_REF;
    options.thread_count = 3;
    options.progress = [](void* calls, uint32_t) { return ++*static_cast<int*>(calls), 0; };
    return options;
  }
  template <class Outputs>
  Outputs outputs_of(uint32_t size) {
    Outputs outputs = {};
    outputs.struct_size = size;
    outputs.joint_indices = joints.data();
    outputs.weights = weights.data();
    outputs.confidence = confidence.data();
    return outputs;
  }

  // What this header's own call gives, which it leaves in joints, weights and confidence.
  sinew_bind_outputs expect() {
    sinew_bind_options options = filled<sinew_bind_options>(sizeof(sinew_bind_options));
    options.progress_user = &calls;
    sinew_bind_outputs outputs = outputs_of<sinew_bind_outputs>(sizeof(sinew_bind_outputs));
    EXPECT_EQ(bind(options, &outputs), SINEW_OK);
    EXPECT_GT(calls, 0);
    EXPECT_EQ(outputs.symmetric_vertices, kVertices);
    return outputs;
  }

  static constexpr uint32_t kVertices = 16, kTriangles = 24, kInfluences = 2;
  std::vector<float> positions;
  std::vector<uint32_t> corners;
  std::vector<uint16_t> joints = std::vector<uint16_t>(kVertices * kInfluences), weights = joints;
  std::vector<uint8_t> confidence = std::vector<uint8_t>(kVertices);
  int calls = 0;
};

TEST_F(GrowingStructs, AProgramOfTheFirstReleaseBindsAsEver) {
  const sinew_bind_outputs expected = expect();
  const std::vector<uint16_t> expected_joints = joints, expected_weights = weights;
  const std::vector<uint8_t> expected_confidence = confidence;
  const int expected_calls = std::exchange(calls, 0);
  joints.assign(joints.size(), 0);
  weights.assign(weights.size(), 0);
  confidence.assign(confidence.size(), 0);

  sinew_bind_options_0_1 options = filled<sinew_bind_options_0_1>(sizeof(sinew_bind_options_0_1));
  options.progress_user = &calls;
  Guarded memory(outputs_of<sinew_bind_outputs_0_1>(sizeof(sinew_bind_outputs_0_1)));
  ASSERT_EQ(bind(options, &memory.known), SINEW_OK);
  EXPECT_EQ(joints, expected_joints);
  EXPECT_EQ(weights, expected_weights);
  EXPECT_EQ(confidence, expected_confidence);
  EXPECT_EQ(calls, expected_calls);
  EXPECT_EQ(memory.known.struct_size, sizeof(sinew_bind_outputs_0_1));
  EXPECT_EQ(memory.known.symmetric_vertices, expected.symmetric_vertices);
  EXPECT_EQ(memory.known.used_bytes, expected.used_bytes);
  memory.expect_untouched();
}

TEST_F(GrowingStructs, AProgramOfTheFutureBindsAsLongAsItWantsNothingNew) {
  const sinew_bind_outputs expected = expect();
  const std::vector<uint16_t> expected_weights = weights;
  weights.assign(weights.size(), 0);
  Future<sinew_bind_options> options = {filled<sinew_bind_options>(sizeof(Future<sinew_bind_options>)), nullptr};
  options.known.progress_user = &calls;
  Future<sinew_bind_outputs> outputs = {outputs_of<sinew_bind_outputs>(sizeof(Future<sinew_bind_outputs>)), nullptr};
  ASSERT_EQ(bind(options, &outputs), SINEW_OK);
  EXPECT_EQ(weights, expected_weights);
  EXPECT_EQ(outputs.known.struct_size, sizeof(Future<sinew_bind_outputs>));
  EXPECT_EQ(outputs.known.used_bytes, expected.used_bytes);
  EXPECT_EQ(outputs.more, nullptr);

  const std::vector<uint16_t> zero(weights.size(), 0);
  weights = zero;
  outputs = {outputs_of<sinew_bind_outputs>(sizeof(Future<sinew_bind_outputs>)), nullptr};
  options.more = "something";
  EXPECT_EQ(bind(options, &outputs), SINEW_ERROR_VERSION);
  options.more = nullptr;
  outputs.more = &calls;
  EXPECT_EQ(bind(options, &outputs), SINEW_ERROR_VERSION);
  EXPECT_EQ(weights, zero) << "outputs were written";
  EXPECT_EQ(outputs.known.used_bytes, 0u);
}

TEST_F(GrowingStructs, ASizeThatWasNeverSetIsRefused) {
  const sinew_bind_options options = filled<sinew_bind_options>(sizeof(sinew_bind_options));
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_bind_options_0_1)} - 1, 4097u}) {
    sinew_bind_outputs outputs = outputs_of<sinew_bind_outputs>(sizeof(sinew_bind_outputs));
    EXPECT_EQ(bind(filled<sinew_bind_options>(size), &outputs), SINEW_ERROR_ARGUMENT) << size;
  }
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_bind_outputs_0_1)} - 1, 4097u}) {
    sinew_bind_outputs outputs = outputs_of<sinew_bind_outputs>(size);
    EXPECT_EQ(bind(options, &outputs), SINEW_ERROR_ARGUMENT) << size;
  }
}

// The same for skeletons.

class GrowingRigStructs : public GrowingStructs {
 protected:
  // The size query and the call; the first status that is not SINEW_OK.
  template <class RigOptions, class Outputs>
  sinew_status rig(const RigOptions& options, Outputs* outputs) {
    static const sinew_test::BundledModel model(SINEW_SOURCE_DIR "/samples/data/sinew_rig.sinew", sinew_rig_model_open);
    EXPECT_TRUE(model.ok) << "samples/data/sinew_rig.sinew is missing or refused";
    const sinew_mesh mesh = {positions.data(), kVertices, nullptr, corners.data(), kTriangles, 3 * kTriangles};
    const auto* const o = reinterpret_cast<const sinew_rig_options*>(&options);
    size_t bytes = 0;
    const sinew_status sized =
        sinew_rig_workspace_size(&model.model, mesh.vertex_count, mesh.face_count, mesh.corner_count, o, &bytes);
    sinew::Workspace workspace(sized == SINEW_OK ? bytes : size_t{1} << 20);
    const sinew_status rigged = sinew_rig(&model.model, &mesh, o, workspace.data(), workspace.size(),
                                          reinterpret_cast<sinew_rig_outputs*>(outputs));
    if (sized != SINEW_OK) {
      EXPECT_EQ(rigged, sized);
    }
    return rigged;
  }

  template <class RigOptions>
  RigOptions filled_rig(uint32_t size) {
    RigOptions options = {};
    options.struct_size = size;
    options.mirror = SINEW_MIRROR_NEVER;
    options.spine_count = 2;
    options.without = SINEW_WITHOUT_ENDS;
    options.progress = [](void* count, uint32_t) { return ++*static_cast<int*>(count), 0; };
    options.progress_user = &calls;
    return options;
  }
  template <class Outputs>
  Outputs rig_outputs(uint32_t size) {
    Outputs outputs = {};
    outputs.struct_size = size;
    outputs.positions = places.data();
    outputs.parents = parents.data();
    outputs.names = names.data();
    return outputs;
  }

  std::vector<float> places = std::vector<float>(3 * SINEW_MAX_RIG_JOINTS);
  std::vector<int32_t> parents = std::vector<int32_t>(SINEW_MAX_RIG_JOINTS);
  std::array<char[SINEW_JOINT_NAME_BYTES], SINEW_MAX_RIG_JOINTS> names = {};
};

TEST_F(GrowingRigStructs, ProgramsOfTheFirstReleaseAndOfTheFutureRigAsEver) {
  sinew_rig_outputs expected = rig_outputs<sinew_rig_outputs>(sizeof(sinew_rig_outputs));
  ASSERT_EQ(rig(filled_rig<sinew_rig_options>(sizeof(sinew_rig_options)), &expected), SINEW_OK);
  const std::vector<float> expected_positions = std::exchange(places, std::vector<float>(places.size()));
  EXPECT_GT(std::exchange(calls, 0), 0);

  Guarded memory(rig_outputs<sinew_rig_outputs_0_1>(sizeof(sinew_rig_outputs_0_1)));
  ASSERT_EQ(rig(filled_rig<sinew_rig_options_0_1>(sizeof(sinew_rig_options_0_1)), &memory.known), SINEW_OK);
  EXPECT_EQ(places, expected_positions);
  EXPECT_GT(calls, 0);
  EXPECT_EQ(memory.known.struct_size, sizeof(sinew_rig_outputs_0_1));
  EXPECT_EQ(memory.known.joint_count, expected.joint_count);
  EXPECT_EQ(memory.known.used_bytes, expected.used_bytes);
  memory.expect_untouched();

  places.assign(places.size(), 0);
  Future<sinew_rig_options> options = {filled_rig<sinew_rig_options>(sizeof(Future<sinew_rig_options>)), nullptr};
  Future<sinew_rig_outputs> outputs = {rig_outputs<sinew_rig_outputs>(sizeof(Future<sinew_rig_outputs>)), nullptr};
  ASSERT_EQ(rig(options, &outputs), SINEW_OK);
  EXPECT_EQ(places, expected_positions);
  EXPECT_EQ(outputs.known.struct_size, sizeof(Future<sinew_rig_outputs>));
  EXPECT_EQ(outputs.known.joint_count, expected.joint_count);
  EXPECT_EQ(outputs.more, nullptr);
}

TEST_F(GrowingRigStructs, WhatThisLibraryDoesNotKnowIsRefused) {
  Future<sinew_rig_options> options = {filled_rig<sinew_rig_options>(sizeof(Future<sinew_rig_options>)), "something"};
  Future<sinew_rig_outputs> outputs = {rig_outputs<sinew_rig_outputs>(sizeof(Future<sinew_rig_outputs>)), nullptr};
  EXPECT_EQ(rig(options, &outputs), SINEW_ERROR_VERSION);
  options.more = nullptr;
  outputs.more = &calls;
  EXPECT_EQ(rig(options, &outputs), SINEW_ERROR_VERSION);
  EXPECT_EQ(outputs.known.joint_count, 0u);
  EXPECT_EQ(places, std::vector<float>(places.size())) << "outputs were written";
}

TEST_F(GrowingRigStructs, ASizeThatWasNeverSetIsRefused) {
  const sinew_rig_options options = filled_rig<sinew_rig_options>(sizeof(sinew_rig_options));
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_rig_options_0_1)} - 1, 4097u}) {
    sinew_rig_outputs outputs = rig_outputs<sinew_rig_outputs>(sizeof(sinew_rig_outputs));
    EXPECT_EQ(rig(filled_rig<sinew_rig_options>(size), &outputs), SINEW_ERROR_ARGUMENT) << size;
  }
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_rig_outputs_0_1)} - 1, 4097u}) {
    sinew_rig_outputs outputs = rig_outputs<sinew_rig_outputs>(size);
    EXPECT_EQ(rig(options, &outputs), SINEW_ERROR_ARGUMENT) << size;
  }
}

// The same for deformers.

class GrowingDeformStructs : public GrowingStructs {
 protected:
  GrowingDeformStructs() {
    for (uint32_t v = 0; v < kVertices; ++v) {
      joints[v * kInfluences] = positions[3 * v + 1] > 1.5f;
      weights[v * kInfluences] = 65535;
    }
  }
  // Makes a deformer and poses it; the first status that is not SINEW_OK.
  template <class DeformOptions, class Outputs>
  sinew_status deform(const DeformOptions& options, Outputs* outputs) {
    const float joint_positions[] = {0.5f, 0.1f, 0.5f, 0.5f, 1.5f, 0.5f};
    const int32_t parents[] = {-1, 0};
    const sinew_mesh mesh = {positions.data(), kVertices, nullptr, corners.data(), kTriangles, 3 * kTriangles};
    sinew_skeleton skeleton = sinew_test::skeleton_of(joint_positions, parents, 2);
    const sinew_skin skin = {joints.data(), weights.data(), kInfluences, SINEW_WEIGHT_UNORM16};
    const float palette[24] = {1,    0,     0, 0,    0,    1,    0, 0,    0, 0, 1, 0,
                               0.6f, -0.8f, 0, 1.4f, 0.8f, 0.6f, 0, 0.2f, 0, 0, 1, 0};
    const auto* const o = reinterpret_cast<const sinew_deform_options*>(&options);
    size_t bytes = 0;
    const sinew_status sized = sinew_deform_create_workspace_size(&mesh, 2, kInfluences, o, &bytes);
    sinew::Workspace memory(sized == SINEW_OK ? bytes : size_t{1} << 22);
    sinew_deformer made = {};
    const sinew_status status = sinew_deform_create(&mesh, &skeleton, &skin, o, memory.data(), memory.size(), &made);
    EXPECT_EQ(sized, status);
    if (status != SINEW_OK) return status;
    sinew::Workspace workspace(made.pose_bytes);
    return sinew_deform_pose(&made, palette, workspace.data(), workspace.size(),
                             reinterpret_cast<sinew_deform_outputs*>(outputs));
  }
  template <class DeformOptions>
  static DeformOptions filled_deform(uint32_t size) {
    DeformOptions options = {};
    options.struct_size = size;
    options.cell_count = 12;
    options.round_count = 3;
    return options;
  }
  template <class Outputs>
  Outputs deform_outputs(uint32_t size) {
    Outputs outputs = {};
    outputs.struct_size = size;
    outputs.positions = places.data();
    return outputs;
  }
  std::vector<float> places = std::vector<float>(3 * kVertices);
};

TEST_F(GrowingDeformStructs, ProgramsOfTheFirstReleaseAndOfTheFutureDeformAsEver) {
  auto expected = deform_outputs<sinew_deform_outputs>(sizeof(sinew_deform_outputs));
  ASSERT_EQ(deform(filled_deform<sinew_deform_options>(sizeof(sinew_deform_options)), &expected), SINEW_OK);
  EXPECT_GT(expected.active_tetrahedra, 0u);
  const std::vector<float> expected_positions = std::exchange(places, std::vector<float>(places.size()));
  Guarded memory(deform_outputs<sinew_deform_outputs_0_1>(sizeof(sinew_deform_outputs_0_1)));
  ASSERT_EQ(deform(filled_deform<sinew_deform_options_0_1>(sizeof(sinew_deform_options_0_1)), &memory.known), SINEW_OK);
  EXPECT_EQ(places, expected_positions);
  EXPECT_EQ(memory.known.active_tetrahedra, expected.active_tetrahedra);
  memory.expect_untouched();

  places.assign(places.size(), 0);
  Future<sinew_deform_options> options = {filled_deform<sinew_deform_options>(sizeof(Future<sinew_deform_options>)),
                                          nullptr};
  Future<sinew_deform_outputs> outputs = {deform_outputs<sinew_deform_outputs>(sizeof(Future<sinew_deform_outputs>)),
                                          nullptr};
  ASSERT_EQ(deform(options, &outputs), SINEW_OK);
  EXPECT_EQ(places, expected_positions);
  places.assign(places.size(), 0);
  options.more = "something";
  EXPECT_EQ(deform(options, &outputs), SINEW_ERROR_VERSION);
  options.more = nullptr;
  outputs.more = &calls;
  EXPECT_EQ(deform(options, &outputs), SINEW_ERROR_VERSION);
  EXPECT_EQ(places, std::vector<float>(places.size())) << "outputs were written";
}

TEST_F(GrowingDeformStructs, ASizeThatWasNeverSetIsRefused) {
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_deform_options_0_1)} - 1, 4097u}) {
    auto outputs = deform_outputs<sinew_deform_outputs>(sizeof(sinew_deform_outputs));
    EXPECT_EQ(deform(filled_deform<sinew_deform_options>(size), &outputs), SINEW_ERROR_ARGUMENT) << size;
  }
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_deform_outputs_0_1)} - 1, 4097u}) {
    auto outputs = deform_outputs<sinew_deform_outputs>(size);
    EXPECT_EQ(deform(filled_deform<sinew_deform_options>(sizeof(sinew_deform_options)), &outputs), SINEW_ERROR_ARGUMENT)
        << size;
  }
}

// The same for motion: plans, contacts, reference points.
class GrowingMotionStructs : public ::testing::Test {
 protected:
  // A joint with a box of two triangles, which moves for two frames.
  template <class RetargetOptions>
  sinew_status plan(const RetargetOptions& options) {
    const int32_t parent = -1, source = 0;
    sinew_skeleton from = sinew_test::skeleton_of(origin, &parent, 1);
    sinew_skeleton to = from;
    to.positions = aside;
    size_t bytes = 0;
    EXPECT_EQ(sinew_retarget_create_workspace_size(1, 1, &bytes), SINEW_OK);
    memory = sinew::Workspace(bytes);
    return sinew_retarget_create(&from, &to, &source, nullptr,
                                 reinterpret_cast<const sinew_retarget_options*>(&options), memory.data(),
                                 memory.size(), &made);
  }
  template <class Options>
  sinew_status clip(const Options& options, bool points) {
    const uint16_t joints[4] = {}, weights[4] = {65535, 65535, 65535, 65535};
    const float corners[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, larger[12] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 1};
    const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};
    const sinew_motion_body from = {corners, triangles, {joints, weights, 1, SINEW_WEIGHT_UNORM16}, 4, 2};
    const sinew_motion_body to = {larger, triangles, {joints, weights, 1, SINEW_WEIGHT_UNORM16}, 4, 2};
    float rotations[8] = {0, 0, 0, 1, 0, 0, 0, 1}, translations[6] = {}, out_rotations[8] = {0, 0, 0, 1, 0, 0, 0, 1},
          out_translations[6] = {};
    const sinew_motion_clip moved = {rotations, translations, out_rotations, out_translations, 2, 0};
    size_t bytes = 0;
    EXPECT_EQ(sinew_retarget_contacts_workspace_size(made, &to, 2, &bytes), SINEW_OK);
    size_t other = 0;
    EXPECT_EQ(sinew_retarget_reference_points_workspace_size(made, &to, &other), SINEW_OK);
    const sinew::Workspace block(bytes + other);
    if (points)
      return sinew_retarget_reference_points(made, &from, &to, &moved,
                                             reinterpret_cast<const sinew_reference_options*>(&options), block.data(),
                                             block.size());
    return sinew_retarget_contacts(made, &from, &to, &moved, reinterpret_cast<const sinew_contact_options*>(&options),
                                   block.data(), block.size());
  }
  // A struct of the first release, of the future, of the future with a wish, and of sizes that were never set.
  template <class Known, class First, class Call>
  void grows(const Call& call) {
    First first = {};
    first.struct_size = sizeof first;
    EXPECT_EQ(call(first), SINEW_OK);
    struct {
      Known known;
      uint64_t wish;
    } future = {};
    future.known.struct_size = sizeof future;
    EXPECT_EQ(call(future), SINEW_OK);
    future.wish = 1;
    EXPECT_EQ(call(future), SINEW_ERROR_VERSION);
    for (const uint32_t size : {0u, uint32_t{sizeof(First)} - 1, 4097u}) {
      first.struct_size = size;
      EXPECT_EQ(call(first), SINEW_ERROR_ARGUMENT) << size;
    }
  }
  const float origin[3] = {0, 0, 0}, aside[3] = {1, 0, 0};
  sinew::Workspace memory;
  sinew_retarget* made = nullptr;
};

TEST_F(GrowingMotionStructs, ProgramsOfTheFirstReleaseAndOfTheFutureRetargetAsEver) {
  grows<sinew_retarget_options, sinew_retarget_options_0_1>([&](const auto& options) { return plan(options); });
  ASSERT_EQ(plan(SINEW_INIT(sinew_retarget_options)), SINEW_OK);
  grows<sinew_contact_options, sinew_contact_options_0_1>([&](const auto& options) { return clip(options, false); });
  grows<sinew_reference_options, sinew_reference_options_0_1>([&](const auto& options) { return clip(options, true); });
}

TEST_F(GrowingStructs, ProgramsOfTheFirstReleaseAndOfTheFutureMapAsEver) {
  const float places[] = {0, 1, 0, 0, 1.5f, 0, 0.3f, 1.5f, 0, -0.3f, 1.5f, 0};
  const int32_t parents[] = {-1, 0, 1, 1};
  const sinew_map_pin pin = {2, 3};
  std::vector<int32_t> sources(4);
  const auto map = [](const void* target, const void* source, const void* options, void* outputs) {
    size_t bytes = 0;
    EXPECT_EQ(sinew_map_workspace_size(4, 4, &bytes), SINEW_OK);
    sinew::Workspace workspace(bytes);
    return sinew_map(static_cast<const sinew_skeleton*>(target), static_cast<const sinew_skeleton*>(source),
                     static_cast<const sinew_map_options*>(options), workspace.data(), bytes,
                     static_cast<sinew_map_outputs*>(outputs));
  };
  const auto rig = [&](auto one, uint32_t size) {
    one.struct_size = size;
    one.joint_count = 4;
    one.positions = places;
    one.parents = parents;
    one.up = SINEW_UP_Y;
    return one;
  };
  const auto options = [&](auto one, uint32_t size) {
    one.struct_size = size;
    one.method = SINEW_MAP_SINEW;
    one.pin_count = 1;
    one.pins = &pin;
    return one;
  };
  const auto filled = [&](auto one, uint32_t size) {
    one.struct_size = size;
    one.sources = sources.data();
    return one;
  };
  const auto own_rig = rig(sinew_skeleton{}, sizeof(sinew_skeleton));
  const auto own_options = options(sinew_map_options{}, sizeof(sinew_map_options));
  auto own_outputs = filled(sinew_map_outputs{}, sizeof(sinew_map_outputs));
  ASSERT_EQ(map(&own_rig, &own_rig, &own_options, &own_outputs), SINEW_OK);
  EXPECT_EQ(sources[2], 3);
  const std::vector<int32_t> expected = std::exchange(sources, std::vector<int32_t>(4));

  const auto first_rig = rig(sinew_skeleton_0_1{}, sizeof(sinew_skeleton_0_1));
  const auto first_options = options(sinew_map_options_0_1{}, sizeof(sinew_map_options_0_1));
  Guarded memory(filled(sinew_map_outputs_0_1{}, sizeof(sinew_map_outputs_0_1)));
  ASSERT_EQ(map(&first_rig, &first_rig, &first_options, &memory.known), SINEW_OK);
  EXPECT_EQ(std::exchange(sources, std::vector<int32_t>(4)), expected);
  EXPECT_EQ(memory.known.mapped, own_outputs.mapped);
  EXPECT_EQ(memory.known.used_bytes, own_outputs.used_bytes);
  memory.expect_untouched();

  Future<sinew_skeleton> future_rig = {rig(sinew_skeleton{}, sizeof(Future<sinew_skeleton>)), nullptr};
  Future<sinew_map_options> future_options = {options(sinew_map_options{}, sizeof(Future<sinew_map_options>)), nullptr};
  Future<sinew_map_outputs> future = {filled(sinew_map_outputs{}, sizeof(Future<sinew_map_outputs>)), nullptr};
  ASSERT_EQ(map(&future_rig, &future_rig, &future_options, &future), SINEW_OK);
  EXPECT_EQ(std::exchange(sources, std::vector<int32_t>(4)), expected);
  for (const void** more : {&future_rig.more, &future_options.more, &future.more}) {
    *more = "something";
    EXPECT_EQ(map(&future_rig, &own_rig, &future_options, &future), SINEW_ERROR_VERSION);
    *more = nullptr;
  }
  EXPECT_EQ(sources, std::vector<int32_t>(4)) << "outputs were written";
  expect_sizes_refused(sizeof(sinew_skeleton_0_1), [&](uint32_t size) {
    const auto one = rig(sinew_skeleton{}, size);
    return map(&own_rig, &one, &own_options, &own_outputs);
  });
  expect_sizes_refused(sizeof(sinew_map_options_0_1), [&](uint32_t size) {
    const auto one = options(sinew_map_options{}, size);
    return map(&own_rig, &own_rig, &one, &own_outputs);
  });
  expect_sizes_refused(sizeof(sinew_map_outputs_0_1), [&](uint32_t size) {
    auto one = filled(sinew_map_outputs{}, size);
    return map(&own_rig, &own_rig, &own_options, &one);
  });
}

TEST_F(GrowingStructs, ProgramsOfTheFirstReleaseAndOfTheFutureTransferAsEver) {
  const float joint_positions[] = {0.5f, 0.1f, 0.5f, 0.5f, 2, 0.5f};
  const int32_t parents[] = {-1, 0}, map[] = {0, 1};
  const sinew_mesh mesh = {positions.data(), kVertices, nullptr, corners.data(), kTriangles, 3 * kTriangles};
  sinew_skeleton skeleton = sinew_test::skeleton_of(joint_positions, parents, 2);
  std::vector<uint16_t> source_joints(kVertices), source_weights(kVertices, 65535);
  for (uint32_t v = 0; v < kVertices; ++v) source_joints[v] = v >= kVertices / 2 ? 1 : 0;
  const sinew_bound_character source = {
      &mesh, &skeleton, {source_joints.data(), source_weights.data(), 1, SINEW_WEIGHT_UNORM16}, map};
  const auto transfer = [&](const void* given, void* outputs) {
    const auto* const o = static_cast<const sinew_transfer_options*>(given);
    size_t bytes = 0;
    const sinew_status sized = sinew_transfer_workspace_size(nullptr, &source, &mesh, &skeleton, o, &bytes);
    sinew::Workspace workspace(sized == SINEW_OK ? bytes : size_t{1} << 20);
    const sinew_status status = sinew_transfer(nullptr, &source, &mesh, &skeleton, o, workspace.data(),
                                               workspace.size(), static_cast<sinew_transfer_outputs*>(outputs));
    if (sized != SINEW_OK) {
      EXPECT_EQ(status, sized);
    }
    return status;
  };
  const auto options = [&](auto one, uint32_t size) {
    one.struct_size = size;
    one.method = SINEW_TRANSFER_NEAREST;
    one.influence_count = kInfluences;
    one.thread_count = 2;
    one.progress = [](void* count, uint32_t) { return ++*static_cast<int*>(count), 0; };
    one.progress_user = &calls;
    return one;
  };
  const auto filled = [&](auto one, uint32_t size) {
    one.struct_size = size;
    one.joint_indices = joints.data();
    one.weights = weights.data();
    one.confidence = confidence.data();
    return one;
  };
  const std::vector<uint16_t> zero(weights.size(), 0);
  const auto own_options = options(sinew_transfer_options{}, sizeof(sinew_transfer_options));
  auto own_outputs = filled(sinew_transfer_outputs{}, sizeof(sinew_transfer_outputs));
  weights = zero;
  ASSERT_EQ(transfer(&own_options, &own_outputs), SINEW_OK);
  EXPECT_GT(std::exchange(calls, 0), 0);
  const std::vector<uint16_t> expected = std::exchange(weights, zero);
  EXPECT_NE(expected, zero);

  const auto first_options = options(sinew_transfer_options_0_1{}, sizeof(sinew_transfer_options_0_1));
  Guarded memory(filled(sinew_transfer_outputs_0_1{}, sizeof(sinew_transfer_outputs_0_1)));
  ASSERT_EQ(transfer(&first_options, &memory.known), SINEW_OK);
  EXPECT_EQ(std::exchange(weights, zero), expected);
  EXPECT_EQ(memory.known.part_count, own_outputs.part_count);
  EXPECT_EQ(memory.known.used_bytes, own_outputs.used_bytes);
  memory.expect_untouched();

  Future<sinew_transfer_options> future_options = {
      options(sinew_transfer_options{}, sizeof(Future<sinew_transfer_options>)), nullptr};
  Future<sinew_transfer_outputs> future = {filled(sinew_transfer_outputs{}, sizeof(Future<sinew_transfer_outputs>)),
                                           nullptr};
  ASSERT_EQ(transfer(&future_options, &future), SINEW_OK);
  EXPECT_EQ(std::exchange(weights, zero), expected);
  for (const void** more : {&future_options.more, &future.more}) {
    *more = "something";
    EXPECT_EQ(transfer(&future_options, &future), SINEW_ERROR_VERSION);
    *more = nullptr;
  }
  EXPECT_EQ(weights, zero) << "outputs were written";
  expect_sizes_refused(sizeof(sinew_transfer_options_0_1), [&](uint32_t size) {
    const auto one = options(sinew_transfer_options{}, size);
    return transfer(&one, &own_outputs);
  });
  expect_sizes_refused(sizeof(sinew_transfer_outputs_0_1), [&](uint32_t size) {
    auto one = filled(sinew_transfer_outputs{}, size);
    return transfer(&own_options, &one);
  });
}

TEST_F(GrowingStructs, ProgramsOfTheFirstReleaseAndOfTheFutureSimplifyAsEver) {
  const float places[] = {0, 0, 0, 0, 1, 0, 0, 1.001f, 0, 0, 2, 0};
  const int32_t parents[] = {-1, 0, 1, 2};
  const auto simplify = [&](const void* options) {
    size_t bytes = 0;
    EXPECT_EQ(sinew_simplify_workspace_size(4, &bytes), SINEW_OK);
    sinew::Workspace workspace(bytes);
    uint32_t into[4] = {};
    sinew_skeleton skeleton = sinew_test::skeleton_of(places, parents, 4);
    const sinew_status status =
        sinew_simplify(&skeleton, nullptr, nullptr, static_cast<const sinew_simplify_options*>(options),
                       workspace.data(), bytes, into);
    if (status == SINEW_OK) {
      EXPECT_EQ(into[2], 1u);
      EXPECT_EQ(into[3], 3u);
    }
    return status;
  };
  const auto options = [](auto one, uint32_t size) {
    one.struct_size = size;
    one.joint_count = 3;
    return one;
  };
  const auto own = options(sinew_simplify_options{}, sizeof(sinew_simplify_options));
  const auto first = options(sinew_simplify_options_0_1{}, sizeof(sinew_simplify_options_0_1));
  Future<sinew_simplify_options> future = {options(sinew_simplify_options{}, sizeof(Future<sinew_simplify_options>)),
                                           nullptr};
  EXPECT_EQ(simplify(&own), SINEW_OK);
  EXPECT_EQ(simplify(&first), SINEW_OK);
  EXPECT_EQ(simplify(&future), SINEW_OK);
  future.more = "something";
  EXPECT_EQ(simplify(&future), SINEW_ERROR_VERSION);
  expect_sizes_refused(sizeof(sinew_simplify_options_0_1), [&](uint32_t size) {
    const auto one = options(sinew_simplify_options{}, size);
    return simplify(&one);
  });
}

}  // namespace
