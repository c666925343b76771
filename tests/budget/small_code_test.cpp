// SPDX-License-Identifier: MIT
// The engine as microcontrollers get it (SINEW_SMALL_CODE, engine/src/core/build.hpp): what was left out is refused
// with the status that the header names, and threads and weights in place, which it does without, change nothing.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "../../samples/embedded/character_small.h"
#include "sinew/sinew.h"
#include "skeleton_of.hpp"

namespace {

struct Free {
  void operator()(uint8_t* p) const { ::operator delete (p, std::align_val_t{64}); }
};
using Block = std::unique_ptr<uint8_t[], Free>;
Block block_of(size_t bytes) { return Block(static_cast<uint8_t*>(::operator new (bytes, std::align_val_t{64}))); }

// A model file's bytes, aligned, and the model when it opens.
struct Model {
  explicit Model(const std::string& name) {
    std::ifstream file(SINEW_SOURCE_DIR "/samples/" + name, std::ios::binary);
    const std::vector<char> read{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    bytes = block_of(read.size());
    std::memcpy(bytes.get(), read.data(), read.size());
    status = sinew_model_open(bytes.get(), read.size(), &model);
  }
  Block bytes;
  sinew_model model = {};
  sinew_status status;
};

sinew_bind_options small_options() {
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.candidate_count = 2;
  options.grid_size = 16;
  return options;
}

struct Result {
  sinew_status asked = SINEW_OK, bound = SINEW_OK;
  size_t bytes = 0, used = 0;
  std::vector<uint16_t> joints, weights;
};

// Asks for the workspace and binds, in more than enough where the question was refused.
Result bind(const Model& model, const sinew_bind_options& options) {
  const sinew_mesh mesh = {kPositions, kVertices, nullptr, kCorners, kTriangles, 3 * kTriangles};
  sinew_skeleton skeleton = sinew_test::skeleton_of(kJointPositions, kJointParents, kJoints);
  Result result;
  result.joints.assign(size_t{kVertices} * 4, 0);
  result.weights.assign(size_t{kVertices} * 4, 0);
  result.asked =
      sinew_bind_workspace_size(&model.model, kVertices, kTriangles, 3 * kTriangles, kJoints, &options, &result.bytes);
  const size_t bytes = result.asked == SINEW_OK ? result.bytes : size_t{1} << 22;
  const Block block = block_of(bytes);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = result.joints.data();
  outputs.weights = result.weights.data();
  result.bound = sinew_bind(&model.model, &mesh, &skeleton, &options, block.get(), bytes, &outputs);
  result.used = outputs.used_bytes;
  return result;
}

TEST(SmallCode, RefusesWhatWasLeftOut) {
  const Model model("embedded/small.sinew");
  ASSERT_EQ(model.status, SINEW_OK);
  const std::vector<uint8_t> hints(kVertices, 1);
  std::vector<std::pair<const char*, sinew_bind_options>> refused;
  const auto add = [&](const char* name) -> sinew_bind_options& {
    refused.emplace_back(name, small_options());
    return refused.back().second;
  };
  add("hints").hints = hints.data();
  add("symmetric").symmetric = 1;
  add("rigid_parts always").rigid_parts = SINEW_RIGID_PARTS_ALWAYS;
  add("rigid_parts never").rigid_parts = SINEW_RIGID_PARTS_NEVER;
  add("surface_vertices").surface_vertices = 100;
  for (const auto& [name, options] : refused) {
    const Result result = bind(model, options);
    EXPECT_EQ(result.asked, SINEW_ERROR_NOT_BUILT) << name;
    EXPECT_EQ(result.bound, SINEW_ERROR_NOT_BUILT) << name;
    EXPECT_EQ(result.joints, std::vector<uint16_t>(result.joints.size(), 0)) << name << " was written";
  }
}

TEST(SmallCode, HasNoMotion) {
  size_t bytes = 7;
  EXPECT_EQ(sinew_retarget_create_workspace_size(1, 1, &bytes), SINEW_ERROR_NOT_BUILT);
  const float origin[3] = {0, 0, 0};
  const int32_t parent = -1, map = 0;
  sinew_skeleton rig = sinew_test::skeleton_of(origin, &parent, 1);
  const Block block = block_of(1 << 16);
  sinew_retarget* plan = nullptr;
  EXPECT_EQ(sinew_retarget_create(&rig, &rig, &map, nullptr, nullptr, block.get(), 1 << 16, &plan),
            SINEW_ERROR_NOT_BUILT);
  EXPECT_EQ(plan, nullptr);
}

TEST(SmallCode, RefusesModelsWithSpectralFeatures) {
  EXPECT_EQ(Model("data/sinew_classic.sinew").status, SINEW_ERROR_MODEL_VERSION);
  EXPECT_EQ(Model("data/sinew_default.sinew").status, SINEW_OK);
}

void never(void*, uint32_t, void (*)(void*, uint32_t), void*) { ADD_FAILURE() << "threads were asked for"; }

TEST(SmallCode, ThreadsAndThePlaceOfWeightsChangeNothing) {
  const Model model("embedded/small.sinew");
  const Result plain = bind(model, small_options());
  ASSERT_EQ(plain.asked, SINEW_OK);
  ASSERT_EQ(plain.bound, SINEW_OK);
  EXPECT_EQ(plain.used, plain.bytes);
  sinew_bind_options options = small_options();
  options.thread_count = 7;
  options.parallel_for = never;
  options.weights_in_place = 1;
  const Result other = bind(model, options);
  ASSERT_EQ(other.bound, SINEW_OK);
  EXPECT_EQ(other.joints, plain.joints);
  EXPECT_EQ(other.weights, plain.weights);
  EXPECT_EQ(other.bytes, plain.bytes);
  sinew_model packed = model.model;
  size_t packed_bytes = 1;
  ASSERT_EQ(sinew_model_pack_workspace_size(&packed, &packed_bytes), SINEW_OK);
  EXPECT_EQ(packed_bytes, size_t{0});
  EXPECT_EQ(sinew_model_pack(&packed, block_of(64).get(), 64), SINEW_OK);
  EXPECT_EQ(packed.packed, nullptr);
}

TEST(SmallCode, PosesAreNotCorrected) {
  const sinew_mesh mesh = {kPositions, kVertices, nullptr, kCorners, kTriangles, 3 * kTriangles};
  size_t bytes = 7;
  EXPECT_EQ(sinew_deform_create_workspace_size(&mesh, kJoints, 4, nullptr, &bytes), SINEW_ERROR_NOT_BUILT);
}

}  // namespace
