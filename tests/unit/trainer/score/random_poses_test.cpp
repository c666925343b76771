// SPDX-License-Identifier: MIT
// The yardstick's random poses are numpy's.
#include <gtest/gtest.h>

#include "expect_affine.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/evaluate.hpp"

namespace sinew {
namespace {

using sinew_test::expect_affine;

Character chain() {
  Character c;
  c.name = "chain";
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {1, 0, 0}, 0}, {"e", {2, 0, 0}, 1}};
  return c;
}

// Written down from weights_eval.py: joints a, b, e, \u00e9, Z, so that the order of names is neither the file's nor a
// locale's.
TEST(RandomPoses, EqualTheYardsticks) {
  Character c;
  c.joints = {{"a", {}, -1}, {"b", {}, 0}, {"e", {}, 1}, {"\xc3\xa9", {}, 1}, {"Z", {}, 0}};
  const std::vector<std::array<double, 3>> positions = {
      {0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0.25}};
  const auto poses = random_poses(c, "F__x", positions);
  ASSERT_EQ(poses.size(), 10u);
  expect_affine(poses[0][0], {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  expect_affine(poses[0][1], {0.947529860214994, 0.1518960775137625, -0.28127343571138597, 0.026235069892503016,
                              -0.13455461998394436, 0.9876640680031228, 0.08009209084859209, 0.06727730999197218,
                              0.2899693401756993, -0.038043007392369155, 0.9562795152812873, -0.14498467008784965});
  expect_affine(poses[9][3], {0.6717544807815103, 0.5795083153422097, -0.4614282501095891, -0.05477898205856308,
                              -0.624149007491144, 0.7782714665828123, 0.06878619593245466, 0.3480209372015584,
                              0.39897861345914665, 0.241792549000734, 0.8845068847951068, -0.06684054250932632});
  expect_affine(poses[4][4], {0.9996283554656916, 0.014387511020165786, 0.02315492335555934, -0.012982486348972727,
                              -0.014581522037861444, 0.9998597976820063, 0.008231901017194714, -0.001987874095301767,
                              -0.023033240415030194, -0.008566475701368585, 0.9996979970621336, 0.004358738585150901});
  expect_affine(random_poses(c, "F__x", positions, 1)[0][2],
                {0.998214903425049, 0.04857023444355167, 0.03475541549483682, -0.010529871999397627,
                 -0.044863835590020856, 0.9939288542285654, -0.10046227644266786, 0.07823775910445363,
                 -0.03942388662057425, 0.09872368033045524, 0.9943336422477812, 0.1445404474119843});
}

TEST(RandomPoses, DoNotDependOnTheOrderOfJoints) {
  const Character c = chain();
  Character turned = c;
  turned.joints = {{"e", {2, 0, 0}, 1}, {"b", {1, 0, 0}, 2}, {"a", {0, 0, 0}, -1}};
  const auto one = random_poses(c, "F__x", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  const auto other = random_poses(turned, "F__x", {{2, 0, 0}, {1, 0, 0}, {0, 0, 0}});
  for (size_t k = 0; k < one.size(); ++k)
    for (size_t j = 0; j < 3; ++j) expect_affine(one[k][j], other[k][2 - j]);
}

TEST(RandomPoses, RefuseACycleAndWrongCounts) {
  Character c = chain();
  EXPECT_THROW(random_poses(c, "x", {{0, 0, 0}}), Error);
  c.joints[0].parent = 2;
  EXPECT_THROW(random_poses(c, "x", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), Error);
}

}  // namespace
}  // namespace sinew
