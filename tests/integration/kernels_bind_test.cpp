// SPDX-License-Identifier: MIT
// The kernel and memory options of a whole bind: the same bytes with all of them, workspaces that do not depend on the
// processor, clear refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <vector>

#include "heat_scene.hpp"
#include "open_bundled_model.hpp"
#include "sinew/sinew.hpp"

namespace {

struct Bound {
  sinew_status status = SINEW_OK;
  size_t bytes = 0, used = 0;
  std::vector<uint16_t> joints, weights;
};

Bound bind_star(uint32_t kernel, uint32_t weights_in_place, const sinew_model* model = bundled_model()) {
  const sinew_test::HeatScene scene = sinew_test::star(11, 12, 3);
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.kernel = kernel;
  options.weights_in_place = weights_in_place;
  const sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  Bound bound;
  bound.status = sinew_bind_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                           skeleton.joint_count, &options, &bound.bytes);
  if (bound.status != SINEW_OK) return bound;
  void* block = ::operator new (bound.bytes, std::align_val_t{64});
  bound.joints.resize(size_t{mesh.vertex_count} * 4);
  bound.weights.resize(size_t{mesh.vertex_count} * 4);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = bound.joints.data();
  outputs.weights = bound.weights.data();
  bound.status = sinew_bind(model, &mesh, &skeleton, &options, block, bound.bytes, &outputs);
  bound.used = outputs.used_bytes;
  ::operator delete (block, std::align_val_t{64});
  return bound;
}

size_t pack_size(const sinew_model* model) {
  size_t bytes = 0;
  EXPECT_EQ(sinew_model_pack_workspace_size(model, &bytes), SINEW_OK);
  return bytes;
}

// The bundled model with its weights packed once.
const sinew_model* packed_model() {
  static sinew::Workspace memory(pack_size(bundled_model()));
  static const sinew_model packed = [] {
    sinew_model model = *bundled_model();
    EXPECT_EQ(sinew_model_pack(&model, memory.data(), memory.size()), SINEW_OK);
    EXPECT_EQ(model.packed, memory.data());
    return model;
  }();
  return &packed;
}

TEST(KernelOption, EveryKernelGivesTheSameBytesInPlaceOrNot) {
  const Bound reference = bind_star(SINEW_KERNEL_REF, 0);
  ASSERT_EQ(reference.status, SINEW_OK);
  for (uint32_t kernel = 0; sinew_kernel_name(kernel) != nullptr; ++kernel) {
    if (sinew_kernel_select(kernel) == 0) {
      EXPECT_EQ(bind_star(kernel, 0).status, SINEW_ERROR_KERNEL);
      continue;
    }
    for (const sinew_model* const model : {bundled_model(), packed_model()}) {
      for (const uint32_t in_place : {0u, 1u}) {
        const Bound bound = bind_star(kernel, in_place, model);
        ASSERT_EQ(bound.status, SINEW_OK) << sinew_kernel_name(kernel);
        EXPECT_EQ(bound.joints, reference.joints) << sinew_kernel_name(kernel);
        EXPECT_EQ(bound.weights, reference.weights) << sinew_kernel_name(kernel);
        EXPECT_LE(bound.used, bound.bytes);
      }
    }
  }
}

TEST(KernelOption, WorkspaceDependsOnWhatIsAskedNotOnTheProcessor) {
  const size_t automatic = bind_star(SINEW_KERNEL_AUTO, 0).bytes, in_place = bind_star(SINEW_KERNEL_AUTO, 1).bytes;
  EXPECT_EQ(bind_star(SINEW_KERNEL_AVX2, 0).bytes, automatic);
  EXPECT_EQ(bind_star(SINEW_KERNEL_VNNI, 0).bytes, automatic);
  EXPECT_EQ(bind_star(SINEW_KERNEL_REF, 0).bytes, in_place);
  EXPECT_LE(in_place, automatic);
  EXPECT_LE(automatic - in_place, size_t{2} * 93808) << "about the size of the model";
}

// Of a character whose network is what needs most.
size_t bytes_of_many(const sinew_model* model) {
  size_t bytes = 0;
  EXPECT_EQ(sinew_bind_workspace_size(model, 10000, 20000, 60000, 60, nullptr, &bytes), SINEW_OK);
  return bytes;
}

TEST(KernelOption, APackedModelNeedsAsMuchLessAsReadingInPlace) {
  EXPECT_EQ(bytes_of_many(bundled_model()) - bytes_of_many(packed_model()), pack_size(bundled_model()));
  const Bound bound = bind_star(SINEW_KERNEL_AUTO, 0, packed_model());
  EXPECT_EQ(bound.used, bound.bytes);
  // What is asked for is what is written, and binds read it alone.
  const size_t bytes = pack_size(bundled_model());
  EXPECT_GT(bytes, size_t{2} * bundled_model()->parameter_count);
  EXPECT_LE(bytes, size_t{2} * 93808);
  sinew::Workspace memory(bytes + 64);
  uint8_t* const first = static_cast<uint8_t*>(memory.data());
  std::fill_n(first, bytes + 64, uint8_t{0xA5});
  sinew_model model = *bundled_model();
  ASSERT_EQ(sinew_model_pack(&model, first, bytes), SINEW_OK);
  EXPECT_TRUE(std::all_of(first + bytes, first + bytes + 64, [](uint8_t b) { return b == 0xA5; }));
  const std::vector<uint8_t> before(first, first + bytes);
  EXPECT_EQ(bind_star(SINEW_KERNEL_AUTO, 0, &model).weights, bound.weights);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), first));
}

TEST(KernelOption, PackingRefusesWhatDoesNotFit) {
  const size_t bytes = pack_size(bundled_model());
  sinew::Workspace memory(bytes + 64);
  sinew_model model = *bundled_model(), empty = {};
  EXPECT_EQ(sinew_model_pack(&model, memory.data(), bytes - 1), SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(sinew_model_pack(&model, static_cast<uint8_t*>(memory.data()) + 8, bytes), SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(sinew_model_pack(&model, nullptr, bytes), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_model_pack(nullptr, memory.data(), bytes), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_model_pack(&empty, memory.data(), bytes), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(model.packed, nullptr);
  size_t untouched = 7;
  EXPECT_EQ(sinew_model_pack_workspace_size(&empty, &untouched), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_model_pack_workspace_size(nullptr, &untouched), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_model_pack_workspace_size(&model, nullptr), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(untouched, size_t{7});
}

TEST(KernelOption, UnknownValuesAreRefused) {
  EXPECT_EQ(bind_star(99, 0).status, SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(bind_star(0, 2).status, SINEW_ERROR_ARGUMENT);
}

}  // namespace
