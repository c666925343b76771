// SPDX-License-Identifier: MIT
// The loss of skeleton prediction: its gradient, and points that teach their class alone.
#include "run/rig_loss.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

RigSample two_points() {
  RigSample s;
  s.vertices = 2;
  s.medial = {0, 0, 0, 0.1f, 0.2f, 0.3f};
  s.start = {0.1f, 0, 0, 0.2f, 0.2f, 0.3f};
  s.end = {0.2f, 0.1f, 0, 0.3f, 0.1f, 0.3f};
  s.weight = {1, 0};
  s.class_weight = {1, 0.5f};
  s.start_class = {2, 0};
  s.end_class = {3, 0};
  return s;
}

std::vector<float> some_outputs() {
  Random random(5);
  std::vector<float> outputs(size_t{2} * kRigOutputs);
  for (float& o : outputs) o = static_cast<float>(random.uniform(-1, 1));
  for (const size_t row : {size_t{0}, size_t{kRigOutputs}}) {
    outputs[row + kRigStartSpread] = -2.3f;
    outputs[row + kRigEndSpread] = -3.1f;
  }
  return outputs;
}

TEST(RigLoss, GradientIsThatOfFiniteDifferences) {
  const RigSample s = two_points();
  std::vector<float> outputs = some_outputs(), gradient;
  (void)rig_loss(s, outputs, &gradient);
  for (size_t i = 0; i < outputs.size(); ++i) {
    const float kept = outputs[i], step = 1e-2f;
    outputs[i] = kept + step;
    const double more = rig_loss(s, outputs, nullptr).total;
    outputs[i] = kept - step;
    const double less = rig_loss(s, outputs, nullptr).total;
    outputs[i] = kept;
    EXPECT_NEAR((more - less) / (2 * static_cast<double>(step)), static_cast<double>(gradient[i]), 2e-3) << i;
  }
}

TEST(RigLoss, APointWithoutWeightTeachesItsClassAlone) {
  const RigSample s = two_points();
  std::vector<float> gradient;
  (void)rig_loss(s, some_outputs(), &gradient);
  const float* const row = gradient.data() + kRigOutputs;
  for (uint32_t c = 0; c < kRigStartClass; ++c) EXPECT_EQ(row[c], 0) << c;
  EXPECT_LT(row[kRigStartClass], 0) << "more of its class";
  EXPECT_LT(row[kRigEndClass], 0);
}

}  // namespace
}  // namespace sinew
