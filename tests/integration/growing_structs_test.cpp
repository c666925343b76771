// SPDX-License-Identifier: MIT
// sinew_bind() and sinew_rig() called by a program compiled with the first release's header, and by one compiled with a header of the
// future: what its structs hold beyond this library's decides.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "bundled_model.hpp"
#include "first_release.h"
#include "sinew/sinew.hpp"

// Members never move, and nothing is put between them.
#define SINEW_KEEPS(type, member) \
  static_assert(offsetof(type, member) == offsetof(type##_0_1, member), #member " stands elsewhere")
SINEW_KEEPS(sinew_options, struct_size);
SINEW_KEEPS(sinew_options, method);
SINEW_KEEPS(sinew_options, influence_count);
SINEW_KEEPS(sinew_options, weight_format);
SINEW_KEEPS(sinew_options, up_axis);
SINEW_KEEPS(sinew_options, candidate_count);
SINEW_KEEPS(sinew_options, grid_size);
SINEW_KEEPS(sinew_options, surface_vertices);
SINEW_KEEPS(sinew_options, symmetric);
SINEW_KEEPS(sinew_options, rigid_parts);
SINEW_KEEPS(sinew_options, softness_percent);
SINEW_KEEPS(sinew_options, weights_in_place);
SINEW_KEEPS(sinew_options, kernel);
SINEW_KEEPS(sinew_options, thread_count);
SINEW_KEEPS(sinew_options, locked);
SINEW_KEEPS(sinew_options, hints);
SINEW_KEEPS(sinew_options, parallel_for);
SINEW_KEEPS(sinew_options, parallel_user);
SINEW_KEEPS(sinew_options, progress);
SINEW_KEEPS(sinew_options, progress_user);
SINEW_KEEPS(sinew_bind_outputs, struct_size);
SINEW_KEEPS(sinew_bind_outputs, symmetric_vertices);
SINEW_KEEPS(sinew_bind_outputs, joint_indices);
SINEW_KEEPS(sinew_bind_outputs, weights);
SINEW_KEEPS(sinew_bind_outputs, confidence);
SINEW_KEEPS(sinew_bind_outputs, used_bytes);
SINEW_KEEPS(sinew_rig_options, struct_size);
SINEW_KEEPS(sinew_rig_options, up_axis);
SINEW_KEEPS(sinew_rig_options, mirror);
SINEW_KEEPS(sinew_rig_options, spine_count);
SINEW_KEEPS(sinew_rig_options, no_toes);
SINEW_KEEPS(sinew_rig_options, no_ends);
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
SINEW_KEEPS(sinew_rig_outputs, quarter_turns);
SINEW_KEEPS(sinew_rig_outputs, plane);
SINEW_KEEPS(sinew_rig_outputs, spread);
SINEW_KEEPS(sinew_rig_outputs, used_bytes);
SINEW_KEEPS(sinew_deform_options, struct_size);
SINEW_KEEPS(sinew_deform_options, method);
SINEW_KEEPS(sinew_deform_options, cell_count);
SINEW_KEEPS(sinew_deform_options, round_count);
SINEW_KEEPS(sinew_deform_options, softness);
SINEW_KEEPS(sinew_deform_options, no_twist_spread);
SINEW_KEEPS(sinew_deform_options, no_contact);
SINEW_KEEPS(sinew_deform_options, no_smoothing);
SINEW_KEEPS(sinew_deform_outputs, struct_size);
SINEW_KEEPS(sinew_deform_outputs, corrected);
SINEW_KEEPS(sinew_deform_outputs, positions);
SINEW_KEEPS(sinew_deform_outputs, active_tetrahedra);
SINEW_KEEPS(sinew_deform_outputs, inverted_tetrahedra);

namespace {

// A header of the future: an input and an output more.
struct FutureOptions {
  sinew_options known;
  const void* wish;
};
struct FutureOutputs {
  sinew_bind_outputs known;
  void* more;
};

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
    const sinew_skeleton skeleton = {joint_positions, parents, nullptr, 2};
    const auto* const o = reinterpret_cast<const sinew_options*>(&options);
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
    sinew_options options = filled<sinew_options>(sizeof(sinew_options));
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

  sinew_options_0_1 options = filled<sinew_options_0_1>(sizeof(sinew_options_0_1));
  options.progress_user = &calls;
  struct {
    sinew_bind_outputs_0_1 outputs;
    uint8_t behind[256];
  } memory;
  std::memset(memory.behind, 0x5A, sizeof memory.behind);
  memory.outputs = outputs_of<sinew_bind_outputs_0_1>(sizeof(sinew_bind_outputs_0_1));
  ASSERT_EQ(bind(options, &memory.outputs), SINEW_OK);
  EXPECT_EQ(joints, expected_joints);
  EXPECT_EQ(weights, expected_weights);
  EXPECT_EQ(confidence, expected_confidence);
  EXPECT_EQ(calls, expected_calls);
  EXPECT_EQ(memory.outputs.struct_size, sizeof(sinew_bind_outputs_0_1));
  EXPECT_EQ(memory.outputs.symmetric_vertices, expected.symmetric_vertices);
  EXPECT_EQ(memory.outputs.used_bytes, expected.used_bytes);
  for (const uint8_t byte : memory.behind) ASSERT_EQ(byte, 0x5A) << "a member that this program lacks was written";
}

TEST_F(GrowingStructs, AProgramOfTheFutureBindsAsLongAsItWantsNothingNew) {
  const sinew_bind_outputs expected = expect();
  const std::vector<uint16_t> expected_weights = weights;
  weights.assign(weights.size(), 0);
  FutureOptions options = {filled<sinew_options>(sizeof(FutureOptions)), nullptr};
  options.known.progress_user = &calls;
  FutureOutputs outputs = {outputs_of<sinew_bind_outputs>(sizeof(FutureOutputs)), nullptr};
  ASSERT_EQ(bind(options, &outputs), SINEW_OK);
  EXPECT_EQ(weights, expected_weights);
  EXPECT_EQ(outputs.known.struct_size, sizeof(FutureOutputs));
  EXPECT_EQ(outputs.known.used_bytes, expected.used_bytes);
  EXPECT_EQ(outputs.more, nullptr);

  const std::vector<uint16_t> zero(weights.size(), 0);
  weights = zero;
  outputs = {outputs_of<sinew_bind_outputs>(sizeof(FutureOutputs)), nullptr};
  options.wish = "something";
  EXPECT_EQ(bind(options, &outputs), SINEW_ERROR_VERSION);
  options.wish = nullptr;
  outputs.more = &calls;
  EXPECT_EQ(bind(options, &outputs), SINEW_ERROR_VERSION);
  EXPECT_EQ(weights, zero) << "outputs were written";
  EXPECT_EQ(outputs.known.used_bytes, 0u);
}

TEST_F(GrowingStructs, ASizeThatWasNeverSetIsRefused) {
  const sinew_options options = filled<sinew_options>(sizeof(sinew_options));
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_options_0_1)} - 1, 4097u}) {
    sinew_bind_outputs outputs = outputs_of<sinew_bind_outputs>(sizeof(sinew_bind_outputs));
    EXPECT_EQ(bind(filled<sinew_options>(size), &outputs), SINEW_ERROR_ARGUMENT) << size;
  }
  for (const uint32_t size : {0u, uint32_t{sizeof(sinew_bind_outputs_0_1)} - 1, 4097u}) {
    sinew_bind_outputs outputs = outputs_of<sinew_bind_outputs>(size);
    EXPECT_EQ(bind(options, &outputs), SINEW_ERROR_ARGUMENT) << size;
  }
}

// The same for skeletons.
struct FutureRigOptions {
  sinew_rig_options known;
  const void* wish;
};
struct FutureRigOutputs {
  sinew_rig_outputs known;
  void* more;
};

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
    options.no_ends = 1;
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
  const std::vector<float> expected_places = std::exchange(places, std::vector<float>(places.size()));
  EXPECT_GT(std::exchange(calls, 0), 0);

  struct {
    sinew_rig_outputs_0_1 outputs;
    uint8_t behind[256];
  } memory;
  std::memset(memory.behind, 0x5A, sizeof memory.behind);
  memory.outputs = rig_outputs<sinew_rig_outputs_0_1>(sizeof(sinew_rig_outputs_0_1));
  ASSERT_EQ(rig(filled_rig<sinew_rig_options_0_1>(sizeof(sinew_rig_options_0_1)), &memory.outputs), SINEW_OK);
  EXPECT_EQ(places, expected_places);
  EXPECT_GT(calls, 0);
  EXPECT_EQ(memory.outputs.struct_size, sizeof(sinew_rig_outputs_0_1));
  EXPECT_EQ(memory.outputs.joint_count, expected.joint_count);
  EXPECT_EQ(memory.outputs.used_bytes, expected.used_bytes);
  for (const uint8_t byte : memory.behind) ASSERT_EQ(byte, 0x5A) << "a member that this program lacks was written";

  places.assign(places.size(), 0);
  FutureRigOptions options = {filled_rig<sinew_rig_options>(sizeof(FutureRigOptions)), nullptr};
  FutureRigOutputs outputs = {rig_outputs<sinew_rig_outputs>(sizeof(FutureRigOutputs)), nullptr};
  ASSERT_EQ(rig(options, &outputs), SINEW_OK);
  EXPECT_EQ(places, expected_places);
  EXPECT_EQ(outputs.known.struct_size, sizeof(FutureRigOutputs));
  EXPECT_EQ(outputs.known.joint_count, expected.joint_count);
  EXPECT_EQ(outputs.more, nullptr);
}

TEST_F(GrowingRigStructs, WhatThisLibraryDoesNotKnowIsRefused) {
  FutureRigOptions options = {filled_rig<sinew_rig_options>(sizeof(FutureRigOptions)), "something"};
  FutureRigOutputs outputs = {rig_outputs<sinew_rig_outputs>(sizeof(FutureRigOutputs)), nullptr};
  EXPECT_EQ(rig(options, &outputs), SINEW_ERROR_VERSION);
  options.wish = nullptr;
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
struct FutureDeformOptions {
  sinew_deform_options known;
  uint32_t wish;
};
struct FutureDeformOutputs {
  sinew_deform_outputs known;
  void* more;
};

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
    const sinew_skeleton skeleton = {joint_positions, parents, nullptr, 2};
    const sinew_skin skin = {joints.data(), weights.data(), kInfluences};
    const float palette[24] = {1,    0,     0, 0,    0,    1,    0, 0,    0, 0, 1, 0,
                               0.6f, -0.8f, 0, 1.4f, 0.8f, 0.6f, 0, 0.2f, 0, 0, 1, 0};
    const auto* const o = reinterpret_cast<const sinew_deform_options*>(&options);
    size_t bytes = 0;
    const sinew_status sized = sinew_deform_memory_size(&mesh, 2, kInfluences, o, &bytes);
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
  const std::vector<float> expected_places = std::exchange(places, std::vector<float>(places.size()));
  struct {
    sinew_deform_outputs_0_1 outputs;
    uint8_t behind[256];
  } memory;
  std::memset(memory.behind, 0x5A, sizeof memory.behind);
  memory.outputs = deform_outputs<sinew_deform_outputs_0_1>(sizeof(sinew_deform_outputs_0_1));
  ASSERT_EQ(deform(filled_deform<sinew_deform_options_0_1>(sizeof(sinew_deform_options_0_1)), &memory.outputs),
            SINEW_OK);
  EXPECT_EQ(places, expected_places);
  EXPECT_EQ(memory.outputs.active_tetrahedra, expected.active_tetrahedra);
  for (const uint8_t byte : memory.behind) ASSERT_EQ(byte, 0x5A) << "a member that this program lacks was written";

  places.assign(places.size(), 0);
  FutureDeformOptions options = {filled_deform<sinew_deform_options>(sizeof(FutureDeformOptions)), 0};
  FutureDeformOutputs outputs = {deform_outputs<sinew_deform_outputs>(sizeof(FutureDeformOutputs)), nullptr};
  ASSERT_EQ(deform(options, &outputs), SINEW_OK);
  EXPECT_EQ(places, expected_places);
  places.assign(places.size(), 0);
  options.wish = 1;
  EXPECT_EQ(deform(options, &outputs), SINEW_ERROR_VERSION);
  options.wish = 0;
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

}  // namespace
