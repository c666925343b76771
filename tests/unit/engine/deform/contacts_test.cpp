// SPDX-License-Identifier: MIT
// Contact between parts that are no neighbors: an arm that is pressed on a torso, both of them tubes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bent_tube.hpp"
#include "sinew/published.h"

namespace {

using sinew_test::BentTube;

constexpr double kTorso = 0.25, kArm = 0.12, kHeight = 0.6;  // radii, and how far the arm lies above the torso at rest
constexpr float kLength = 0.8f;  // of the arm, of the torso's: it ends before the torso does

// A torso of joints 0 and 1, and above it an arm of joints 2 and 3, which hangs on joint 0.
struct Body {
  BentTube tube = BentTube(2, 0.5, kTorso);
  uint32_t torso_vertices = tube.vertex_count();

  explicit Body(bool rigid_arm = false) {
    BentTube arm(2, 0.5, kArm);
    for (size_t i = 0; i < arm.positions.size(); i += 3) arm.positions[i] = kLength * (arm.positions[i] + 1) - 1;
    for (size_t i = 0; i < arm.joint_positions.size(); i += 3)
      arm.joint_positions[i] = kLength * (arm.joint_positions[i] + 1) - 1;
    for (size_t i = 0; i < arm.positions.size(); ++i)
      tube.positions.push_back(arm.positions[i] + (i % 3 == 1 ? static_cast<float>(kHeight) : 0));
    for (const uint32_t corner : arm.corners) tube.corners.push_back(corner + torso_vertices);
    for (size_t i = 0; i < arm.joints.size(); ++i) {
      tube.joints.push_back(static_cast<uint16_t>(rigid_arm ? 2 : arm.joints[i] + 2));
      tube.weights.push_back(rigid_arm ? (i % 2 == 0 ? 65535 : 0) : arm.weights[i]);
    }
    for (size_t i = 0; i < arm.joint_positions.size(); ++i)
      tube.joint_positions.push_back(arm.joint_positions[i] + (i % 3 == 1 ? static_cast<float>(kHeight) : 0));
    tube.parents.insert(tube.parents.end(), {0, 2});
  }

  // The whole arm turned down by so many degrees about its first joint.
  std::vector<float> palette(double degrees) const {
    const std::array<double, 12> turn = BentTube::rotation_about({0, 0, 1}, -degrees, -1);
    std::vector<float> out = tube.turned({0, 0, 1}, 0);
    out.resize(48);
    for (size_t j = 2; j < 4; ++j) {
      for (size_t e = 0; e < 12; ++e) out[12 * j + e] = static_cast<float>(turn[e]);
      // About a point that lies kHeight above the axis.
      for (size_t r = 0; r < 3; ++r)
        out[12 * j + 4 * r + 3] += static_cast<float>(kHeight * ((r == 1 ? 1 : 0) - turn[4 * r + 1]));
    }
    return out;
  }
};

struct Deformed {
  sinew::Deformer deformer;
  std::vector<float> at;

  Deformed(const Body& body, bool contact, uint32_t method = SINEW_DEFORM_VOLUME) {
    sinew_deform_options options = SINEW_INIT(sinew_deform_options);
    options.method = method;
    options.body_contact = contact ? 1 : 0;
    EXPECT_EQ(deformer.create(body.tube.mesh(), body.tube.skeleton(), body.tube.skin(), options), SINEW_OK);
  }
  const std::vector<float>& pose(const std::vector<float>& palette) {
    at.assign(size_t{3} * deformer.get().vertex_count, 0);
    sinew_deform_outputs outputs = SINEW_INIT(sinew_deform_outputs);
    outputs.positions = at.data();
    EXPECT_EQ(deformer.pose(palette.data(), &outputs), SINEW_OK);
    return at;
  }
};

// How deep the arm's lowest vertex lies under the torso's highest one near it.
double depth(const Body& body, const std::vector<float>& at) {
  double most = -1;
  for (uint32_t v = body.torso_vertices; v < body.tube.vertex_count(); ++v) {
    double top = -1;
    for (uint32_t u = 0; u < body.torso_vertices; ++u) {
      if (std::abs(at[3 * u] - at[3 * v]) < 0.05f && std::abs(at[3 * u + 2] - at[3 * v + 2]) < 0.05f)
        top = std::max(top, double{at[3 * u + 1]});
    }
    if (top > -1) most = std::max(most, top - double{at[3 * v + 1]});
  }
  return most;
}

TEST(Contacts, AnArmOnATorsoIsPressedFlatAndSoIsTheTorso) {
  const Body body;
  const std::vector<float> palette = body.palette(10);
  Deformed free(body, false), kept(body, true);
  const double before = depth(body, free.pose(palette)), after = depth(body, kept.pose(palette));
  EXPECT_GT(before, 0.04);
  EXPECT_LT(after, 0.25 * before);
  const auto moved = [&](uint32_t begin, uint32_t end) {
    float most = 0;
    for (size_t i = size_t{3} * begin; i < size_t{3} * end; ++i)
      most = std::max(most, std::abs(kept.at[i] - free.at[i]));
    return most;
  };
  EXPECT_GT(moved(0, body.torso_vertices), 0.01f);
  EXPECT_GT(moved(body.torso_vertices, body.tube.vertex_count()), 0.01f);
}

TEST(Contacts, ThePublishedCorrectionKeepsPartsApartAsWell) {
  const Body body;
  const std::vector<float> palette = body.palette(10);
  Deformed free(body, false, SINEW_DEFORM_XPBD), kept(body, true, SINEW_DEFORM_XPBD);
  const double before = depth(body, free.pose(palette));
  EXPECT_GT(before, 0.04);
  EXPECT_LT(depth(body, kept.pose(palette)), 0.25 * before);
}

TEST(Contacts, WhatTouchesNothingStaysAsItIs) {
  const Body body;
  Deformed free(body, false), kept(body, true);
  for (const double degrees : {0.0, 3.0, 5.0}) {
    const std::vector<float> palette = body.palette(degrees);
    EXPECT_EQ(free.pose(palette), kept.pose(palette)) << degrees;
  }
}

TEST(Contacts, APartOfOneJointKeepsItsShapeAndTheOtherGivesWay) {
  const Body body(true);
  const std::vector<float> palette = body.palette(10);
  Deformed free(body, false), kept(body, true);
  const double before = depth(body, free.pose(palette)), after = depth(body, kept.pose(palette));
  EXPECT_LT(after, 0.4 * before);
  for (size_t i = size_t{3} * body.torso_vertices; i < kept.at.size(); ++i) ASSERT_EQ(kept.at[i], free.at[i]);
}

// The arm sinks in by 0.07. What jumps is where the nearest surface changes around the arm's end.
TEST(Contacts, ATouchBeginsWithoutAJump) {
  const Body body;
  Deformed kept(body, true);
  std::vector<float> last;
  float most = 0;
  for (double degrees = 7; degrees < 10; degrees += 0.02) {
    const std::vector<float> now = kept.pose(body.palette(degrees));
    for (size_t i = 0; i < last.size(); ++i) most = std::max(most, std::abs(now[i] - last[i]));
    last = now;
  }
  EXPECT_LT(most, 0.01f);  // 0.5 % of the longest side
}

}  // namespace
