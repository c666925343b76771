// SPDX-License-Identifier: MIT
// The kernel and memory options of a whole bind: the same bytes with all of them, workspaces that do not depend on the
// processor, clear refusals.
#include <gtest/gtest.h>

#include <new>
#include <vector>

#include "heat_scene.hpp"
#include "open_bundled_model.hpp"

namespace {

struct Bound {
  sinew_status status = SINEW_OK;
  size_t bytes = 0, used = 0;
  std::vector<uint16_t> joints, weights;
};

Bound bind_star(uint32_t kernel, uint32_t weights_in_place) {
  const sinew_test::HeatScene scene = sinew_test::star(11, 12, 3);
  sinew_options options = {};
  options.kernel = kernel;
  options.weights_in_place = weights_in_place;
  const sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  Bound bound;
  bound.status = sinew_bind_workspace_size(bundled_model(), mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                           skeleton.joint_count, &options, &bound.bytes);
  if (bound.status != SINEW_OK) return bound;
  void* block = ::operator new (bound.bytes, std::align_val_t{64});
  bound.joints.resize(size_t{mesh.vertex_count} * 4);
  bound.weights.resize(size_t{mesh.vertex_count} * 4);
  bound.status = sinew_bind(bundled_model(), &mesh, &skeleton, &options, block, bound.bytes, bound.joints.data(),
                            bound.weights.data(), &bound.used);
  ::operator delete (block, std::align_val_t{64});
  return bound;
}

TEST(KernelOption, EveryKernelGivesTheSameBytesInPlaceOrNot) {
  const Bound reference = bind_star(SINEW_KERNEL_REF, 0);
  ASSERT_EQ(reference.status, SINEW_OK);
  for (uint32_t kernel = 0; sinew_kernel_name(kernel) != nullptr; ++kernel) {
    if (sinew_kernel_select(kernel) == 0) {
      EXPECT_EQ(bind_star(kernel, 0).status, SINEW_ERROR_KERNEL);
      continue;
    }
    for (const uint32_t in_place : {0u, 1u}) {
      const Bound bound = bind_star(kernel, in_place);
      ASSERT_EQ(bound.status, SINEW_OK) << sinew_kernel_name(kernel);
      EXPECT_EQ(bound.joints, reference.joints) << sinew_kernel_name(kernel);
      EXPECT_EQ(bound.weights, reference.weights) << sinew_kernel_name(kernel);
      EXPECT_LE(bound.used, bound.bytes);
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

TEST(KernelOption, UnknownValuesAreRefused) {
  EXPECT_EQ(bind_star(99, 0).status, SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(bind_star(0, 2).status, SINEW_ERROR_ARGUMENT);
}

}  // namespace
