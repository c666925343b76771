// SPDX-License-Identifier: MIT
// Figures of the report that are not the yardstick's: reliability, differences in 255ths, nearest bone, recall.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/confidence.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {
namespace {

TEST(Reliability, PlotShowsBinsWithData) {
  const Reliability r = reliability({{"a", {153, 153}, {1, 0}}, {"b", {230}, {1}}});
  const std::string plot = reliability_plot(r);
  size_t circles = 0;
  for (size_t at = plot.find("<circle"); at != std::string::npos; at = plot.find("<circle", at + 1)) ++circles;
  EXPECT_EQ(circles, 2u);
  EXPECT_EQ(reliability_plot(reliability({})).find("nan"), std::string::npos);
}

TEST(Reliability, TopWeightIsAShareOfItsRow) {
  EXPECT_EQ(top_weights({{{3, 0.6f}, {1, 0.2f}}, {}, {{0, 1.0f}}}), (std::vector<uint8_t>{191, 0, 255}));
}

TEST(WeightDifference, RoundsToAnExactSum) {
  const auto row = row_unorm8({{2, 1.0f / 3}, {5, 1.0f / 3}, {7, 1.0f / 3}});
  EXPECT_EQ(row, (std::map<uint32_t, int>{{2, 85}, {5, 85}, {7, 85}}));
  const auto uneven = row_unorm8({{1, 0.5f}, {2, 0.5f}});
  EXPECT_EQ(uneven.at(1) + uneven.at(2), 255);
  EXPECT_EQ(row_unorm8({{1, 1.0f}, {2, 1e-4f}}), (std::map<uint32_t, int>{{1, 255}})) << "nothing left of the second";
  EXPECT_TRUE(row_unorm8({}).empty());
}

TEST(WeightDifference, CountsStepsAndFlips) {
  const auto share = [](int part) { return static_cast<float>(part) / 255; };
  WeightDifference d;
  d.add({{{0, 1.0f}}, {{0, share(155)}, {1, share(100)}}, {{4, 1.0f}}},
        {{{0, 1.0f}}, {{0, share(154)}, {1, share(101)}}, {{4, share(100)}, {5, share(155)}}});
  EXPECT_EQ(d.vertices, 3u);
  EXPECT_EQ(d.flips, 1u);
  EXPECT_EQ(d.weights(), 5u);
  EXPECT_EQ(d.steps, (std::array<size_t, WeightDifference::kSteps>{1, 2, 0, 0, 0, 0, 0, 2}));
  EXPECT_NEAR(d.close_share(), 0.6, 1e-9);
  EXPECT_NEAR(d.flip_share(), 1.0 / 3, 1e-9);
  const size_t sizes[] = {4, 7, 8, 15, 16, 31, 32}, steps[] = {4, 4, 5, 5, 6, 6, 7};
  for (size_t i = 0; i < 7; ++i) {
    WeightDifference one;
    const int size = static_cast<int>(sizes[i]);
    one.add({{{0, share(200)}, {1, share(55)}}}, {{{0, share(200 - size)}, {1, share(55 + size)}}});
    EXPECT_EQ(one.steps[steps[i]], 2u) << size << " is " << WeightDifference::step_name(steps[i]);
  }
  EXPECT_EQ(WeightDifference{}.close_share(), 1.0);
  EXPECT_THROW(d.add({{}}, {}), Error);
}

Character two_bones() {
  Character c;
  c.name = "f__two";
  c.joints = {{"root", {0, 0, 0}, -1}, {"mid", {0, 1, 0}, 0}, {"end", {0, 2, 0}, 1}};
  c.vertices = {{1, 0.2f, 0}, {1, 0.9f, 0}, {1, 1.4f, 0}, {1, 2.5f, 0}, {0, 3, 1}};
  c.face_offsets = {0, 3, 6};
  c.face_vertices = {0, 1, 2, 2, 3, 4};
  c.influences = {{{0, 1}}, {{0, 1}}, {{1, 1}}, {{2, 1}}, {}};
  return c;
}

void expect_rigid(const std::vector<std::vector<Influence>>& rows, const std::vector<uint32_t>& expected) {
  ASSERT_EQ(rows.size(), expected.size());
  for (size_t v = 0; v < rows.size(); ++v) {
    ASSERT_EQ(rows[v].size(), 1u);
    EXPECT_EQ(rows[v][0].joint, expected[v]) << v;
    EXPECT_EQ(rows[v][0].weight, 1.0f);
  }
}

TEST(NearestBone, BindsRigidlyToTheSegmentThatIsNearestAndALeafsGoesOnAlongItsParents) {
  expect_rigid(nearest_bone(two_bones()), {0, 0, 1, 2, 2});
  EXPECT_THROW(nearest_bone({}), Error);
}

TEST(NearestBone, AStubIsHalfAsLongAsItsParentBoneAndAtMostATenthOfTheSkeleton) {
  // One vertex above the stub and beside a bone of another tree, one that the stub reaches.
  Character c;
  c.joints = {
      {"root", {0, 0, 0}, -1}, {"end", {0, 1, 0}, 0}, {"side", {0.45f, 1.5f, 0}, -1}, {"hand", {2, 1.5f, 0}, 2}};
  c.vertices = {{0, 1.5f, 0}, {0, 1.2f, 0}};
  expect_rigid(nearest_bone(c), {1, 1});  // longest side 2: the stub is 0.2 long
  c.joints[2].position.x = 0.25f;
  expect_rigid(nearest_bone(c), {2, 1});
  c.joints[0].position.y = 0.9f;  // a parent bone of 0.1 carries a stub of 0.05 only
  c.joints[2].position.x = 0.42f;
  expect_rigid(nearest_bone(c), {2, 1});
}

TEST(NearestBone, TheDeeperJointHasWhatIsNearestToWhereTwoBonesMeetInAnyOrderOfJoints) {
  Character c = two_bones();
  c.vertices = {{1, 1, 0}};
  expect_rigid(nearest_bone(c), {1});
  c.joints = {{"mid", {0, 1, 0}, 2}, {"end", {0, 2, 0}, 0}, {"root", {0, 0, 0}, -1}};
  expect_rigid(nearest_bone(c), {0});
}

TEST(NearestBone, BindsToNoJointThatDoesNotDeform) {
  const Character c = two_bones();
  expect_rigid(nearest_bone(c, {1, 0, 1}), {0, 0, 0, 2, 2});
  EXPECT_THROW(nearest_bone(c, {0, 0, 0}), Error);
  EXPECT_THROW(nearest_bone(c, {1}), Error);
}

TEST(Measure, TellsDistancesPerPose) {
  const Character c = two_bones();
  std::vector<double> poses;
  const Metrics m = measure(c, {{{0, 1}}, {{0, 1}}, {{0, 1}}, {{1, 1}}, {}}, "f__two", 6, nullptr, &poses);
  ASSERT_EQ(poses.size(), 6u);
  EXPECT_NEAR(std::accumulate(poses.begin(), poses.end(), 0.0) / 6, m.avg_dist, 1e-12);
  EXPECT_GT(m.avg_dist, 0);
}

TEST(BeatenBy, NamesTheCharactersWorstFirst) {
  const auto scored = [](double a, double b, double c) {
    std::vector<std::pair<std::string, Metrics>> rows(3);
    const double l1[] = {a, b, c};
    for (size_t i = 0; i < 3; ++i) {
      rows[i].first = std::string(1, static_cast<char>('a' + i));
      rows[i].second.l1 = l1[i];
    }
    return summarize(rows);
  };
  const auto list = beaten_by(scored(0.5, 0.3, 0.4), scored(0.4, 0.3, 0.1));
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].first, "c");
  EXPECT_NEAR(list[0].second, 0.3, 1e-12);
  EXPECT_EQ(list[1].first, "a");
}

TEST(CandidateRecall, IsWhatTheSampleDoesNotMiss) {
  SynthesizeOptions options;
  options.plan = BodyPlan::kQuadruped;
  options.seed = 5;
  options.resolution = 28;
  const Character c = synthesize(options);
  const std::vector<double> recall = candidate_recall(c, {1, 6, 16}, 64);
  ASSERT_EQ(recall.size(), 3u);
  EXPECT_LT(recall[0], recall[1]);
  EXPECT_LE(recall[1], recall[2]);
  EXPECT_LE(recall[2], 1 + 1e-9);
  const Sample sample = make_sample(c, 6, 64);
  double missing = 0, bound = 0;
  for (size_t u = 0; u < sample.vertices; ++u) {
    missing += static_cast<double>(sample.missing[u] * sample.importance[u]);
    bound += static_cast<double>(sample.importance[u]);
  }
  EXPECT_NEAR(recall[1], 1 - missing / bound, 1e-5);
  Character bare = c;
  bare.influences.assign(c.vertices.size(), {});
  EXPECT_THROW(candidate_recall(bare, {6}, 64), Error);
}

}  // namespace
}  // namespace sinew
