// SPDX-License-Identifier: MIT
// The training loss: gradient against central differences, folding of end joints, values worked out by hand.
#include "run/loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "random_sample.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using testing::random_sample;

std::vector<double> random_logits(const Sample& sample, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, 2.0);
  std::vector<double> logits(sample.candidate.size());
  for (double& l : logits) l = normal(random);
  return logits;
}

TEST(WeightLoss, GradientOfEveryTermAgreesWithDifferences) {
  const LossWeights cases[] = {{1, 0, 0, 0}, {0, 1, 0, 0},    {0, 0, 1, 0},
                               {0, 0, 0, 1}, {0, 0, 0, 0, 1}, {0.5, 1, 2, 0.5, 3}};
  for (uint64_t seed : {1, 2, 3}) {
    const Sample sample = random_sample({.vertices = 30, .candidates = 5, .seed = seed});
    for (const LossWeights& weights : cases) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " kl " << weights.kl << " l1 " << weights.l1 << " regret "
                                        << weights.regret << " part " << weights.part << " deformation "
                                        << weights.deformation);
      std::vector<double> logits = random_logits(sample, seed), gradient;
      weight_loss(sample, weights, logits, &gradient);
      size_t moved = 0;
      for (size_t i = 0; i < logits.size(); ++i) {
        constexpr double kStep = 1e-6;
        const double kept = logits[i];
        logits[i] = kept + kStep;
        const double up = weight_loss<double>(sample, weights, logits, nullptr).total;
        logits[i] = kept - kStep;
        const double down = weight_loss<double>(sample, weights, logits, nullptr).total;
        logits[i] = kept;
        EXPECT_NEAR(gradient[i], (up - down) / (2 * kStep), 1e-7) << "slot " << i;
        moved += std::abs(gradient[i]) > 1e-9;
      }
      EXPECT_GT(moved, 5u);
    }
  }
}

Sample one_vertex() {
  Sample s;
  s.name = "one";
  s.vertices = 1;
  s.candidates = 3;
  s.part_count = 1;
  s.joints = 3;
  s.candidate = {0, 1, 2};
  s.part = {0};
  s.part_offsets = {0, 1};
  s.part_vertices = {0};
  s.fold = {0, 0, 2};  // joint 1 is the end marker of joint 0
  s.target = {1, 0, 0};
  s.heat = {0.25f, 0.5f, 0.25f};
  s.missing = {0};
  s.importance = {3};
  s.positions = {0.5f, 0.25f, 0};
  s.joint_positions = {0, 0, 0, 0.5f, 0.75f, 0, 0.25f, 0.25f, 0};
  s.parents = {-1, 0, 0};
  return s;
}

TEST(WeightLoss, WorkedExample) {
  // p = (0.25, 0.25, 0.5); joints 0 and 1 count as one: p = 0.5 against 1, heat 0.75 against 1.
  const std::vector<double> logits = {0, 0, std::log(2.0)};
  const LossTerms terms = weight_loss<double>(one_vertex(), {1, 1, 1, 1}, logits, nullptr);
  EXPECT_NEAR(terms.l1, 1.0, 1e-12);
  EXPECT_NEAR(terms.kl, std::log(2.0), 1e-12);
  EXPECT_NEAR(terms.regret, 1.0 - 0.5, 1e-12);
  EXPECT_NEAR(terms.part, 1.0, 1e-12);
  EXPECT_NEAR(terms.total, terms.l1 + terms.kl + terms.regret + terms.part, 1e-12);
}

TEST(WeightLoss, DeformationIsWhatTurningTheWronglyWeightedJointsMoves) {
  // p - t is -0.5 on joint 0 and 0.5 on joint 2: under the root they cancel, joint 2 is 0.25 away.
  const std::vector<double> logits = {0, 0, std::log(2.0)};
  EXPECT_NEAR(weight_loss<double>(one_vertex(), {0, 0, 0, 0, 1}, logits, nullptr).deformation, 0.5 * 0.25, 1e-6);
  Sample s = one_vertex();
  s.parents = {-1, 0, 1};  // turning joint 1, half a side away, moves joint 2's share as well
  s.fold = {0, 1, 2};
  s.target = {0.25f, 0.75f, 0};  // p - t: 0, -0.5, 0.5; below joint 1 they cancel
  EXPECT_NEAR(weight_loss<double>(s, {0, 0, 0, 0, 1}, logits, nullptr).deformation, 0.5 * 0.25, 1e-6);
  s.target = {0.75f, 0.25f, 0};  // -0.5, 0, 0.5
  EXPECT_NEAR(weight_loss<double>(s, {0, 0, 0, 0, 1}, logits, nullptr).deformation, 0.5 * std::hypot(0.25, 0.5), 1e-6);
}

TEST(WeightLoss, HeatOutsideTheCandidatesIsHeatsError) {
  Sample s = one_vertex();
  s.heat = {0.25f, 0.25f, 0};  // half of heat's weight lies elsewhere: L1 0.5 on the candidates and 0.5 outside
  const std::vector<double> logits = {0, 0, std::log(6.0)};  // p of joint 0: 0.25, so L1 is 1.5
  EXPECT_NEAR(weight_loss<double>(s, {0, 0, 1, 0}, logits, nullptr).regret, 0.5, 1e-12);
  s.missing = {0.5f};  // the reference lies elsewhere as well, perhaps at the same joint: heat is given the benefit
  s.target = {0.5f, 0, 0};
  EXPECT_NEAR(weight_loss<double>(s, {0, 0, 1, 0}, logits, nullptr).regret, 1.5, 1e-12);
}

TEST(WeightLoss, WeightOnAnEndJointIsWeightOnItsParent) {
  Sample s = one_vertex();
  const std::vector<double> on_parent = {30, 0, 0}, on_end = {0, 30, 0};
  EXPECT_NEAR(weight_loss<double>(s, {1, 1, 1, 1}, on_parent, nullptr).total, 0, 1e-9);
  EXPECT_NEAR(weight_loss<double>(s, {1, 1, 1, 1}, on_end, nullptr).total, 0, 1e-9);
  // The fold target is no candidate: its weight was put on the first end marker, and the second counts like it.
  s.joints = 4;
  s.fold = {0, 0, 2, 0};
  s.candidate = {1, 3, 2};
  EXPECT_NEAR(weight_loss<double>(s, {1, 1, 1, 1}, on_end, nullptr).total, 0, 1e-9);
  EXPECT_NEAR(sample_l1(s, {0.5f, 0.5f, 0}, 4), 0, 1e-6);
}

TEST(WeightLoss, FarLogitsStayFinite) {
  const Sample s = one_vertex();
  std::vector<float> gradient;
  const LossTerms terms = weight_loss<float>(s, {1, 1, 1, 1}, {-200.0f, -300.0f, 500.0f}, &gradient);
  EXPECT_NEAR(terms.kl, 700, 1);
  for (float g : gradient) EXPECT_TRUE(std::isfinite(g));
  EXPECT_LT(gradient[0], -0.9f) << "KL still has to pull the lost joint up";
}

TEST(SampleL1, KeepsTheLargestNormalizesAndCountsMissingWeight) {
  Sample s = one_vertex();
  s.fold = {0, 1, 2};
  s.target = {0.6f, 0.2f, 0};
  s.missing = {0.2f};
  // Two largest of (0.6, 0.3, 0.1) become (2/3, 1/3).
  EXPECT_NEAR(sample_l1(s, {0.6f, 0.3f, 0.1f}, 2), 2.0 / 3 - 0.6 + 1.0 / 3 - 0.2 + 0.2, 1e-6);
  s.importance = {0};
  EXPECT_THROW(sample_l1(s, {0.6f, 0.3f, 0.1f}, 2), Error);
}

}  // namespace
}  // namespace sinew
