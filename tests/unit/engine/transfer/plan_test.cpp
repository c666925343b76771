// SPDX-License-Identifier: MIT
// What is bound and matched by each method, and what a plan refuses.
#include "transfer/plan.hpp"

#include <gtest/gtest.h>

#include "sinew/published.h"
#include "transfer_scene.hpp"

namespace sinew::transferring {
namespace {

class Planned {
 public:
  Planned() {
    bound_ = {&mesh_, &skeleton_, rows_.joints.data(), rows_.weights.data(), 2, SINEW_WEIGHT_UNORM16, nullptr};
  }
  sinew_status make(const sinew_transfer_options* options) {
    plan = {};
    return plan_transfer(nullptr, {bound_, mesh_, skeleton_}, options, &plan);
  }
  sinew_status make(uint32_t method, uint32_t garment = 0) {
    sinew_transfer_options options = SINEW_INIT(sinew_transfer_options);
    options.method = method;
    options.garment = garment;
    return make(&options);
  }
  sinew_bound_character& bound() { return bound_; }
  TransferPlan plan;

 private:
  sinew_test::MeshScene scene_ = sinew_test::limb(6, 8, 2, 0.3);
  sinew_test::BoundRows rows_ = sinew_test::painted(scene_, 2);
  sinew_mesh mesh_ = scene_.mesh_view();
  sinew_skeleton skeleton_ = scene_.skeleton_view();
  sinew_bound_character bound_;
};

TEST(TransferPlan, WithoutOptionsEveryDefault) {
  Planned p;
  ASSERT_EQ(p.make(nullptr), SINEW_OK);
  EXPECT_EQ(p.plan.method, static_cast<uint32_t>(SINEW_TRANSFER_AUTO));
  EXPECT_EQ(p.plan.influence_count, 4u);
  EXPECT_FALSE(p.plan.with_model);
  EXPECT_EQ(p.plan.source.vertices, 48u);
}

TEST(TransferPlan, OnlyWhatAMethodNeedsIsDone) {
  Planned p;
  const struct {
    uint32_t method;
    bool binds, matches;
  } expected[] = {{SINEW_TRANSFER_AUTO, true, true},
                  {SINEW_TRANSFER_NEAREST, false, true},
                  {SINEW_TRANSFER_BIHARMONIC, false, false},
                  {SINEW_TRANSFER_REBIND, true, false}};
  for (const auto& one : expected) {
    ASSERT_EQ(p.make(one.method), SINEW_OK) << one.method;
    EXPECT_EQ(p.plan.binds(), one.binds) << one.method;
    EXPECT_EQ(p.plan.matches(), one.matches) << one.method;
  }
}

TEST(TransferPlan, AGarmentIsPlannedWithItsBody) {
  Planned p;
  ASSERT_EQ(p.make(SINEW_TRANSFER_AUTO, 1), SINEW_OK);
  EXPECT_EQ(p.plan.dressed.vertices, p.plan.source.vertices + p.plan.target.vertices);
  EXPECT_EQ(p.plan.dressed.corners, p.plan.source.corners + p.plan.target.corners);
  EXPECT_EQ(p.plan.target_binds[SINEW_METHOD_HEAT].counts.vertices, p.plan.dressed.vertices);
}

TEST(TransferPlan, RefusesWhatItCannotDo) {
  Planned p;
  EXPECT_EQ(p.make(SINEW_TRANSFER_BIHARMONIC, 1), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(p.make(SINEW_TRANSFER_REBIND + 1), SINEW_ERROR_ARGUMENT);
  p.bound().skin.influence_count = 0;
  EXPECT_EQ(p.make(nullptr), SINEW_ERROR_ARGUMENT);
  p.bound().skin.influence_count = SINEW_MAX_INFLUENCES + 1;
  EXPECT_EQ(p.make(nullptr), SINEW_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace sinew::transferring
