// SPDX-License-Identifier: MIT
// Corrected poses through the C API: the rest pose, rigid motions, volumes, contact, twists, refusals.
#include "sinew/deform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "posed_tube.hpp"
#include "sinew/published.h"

namespace {

using sinew_test::BentTube, sinew_test::Posed, sinew_test::farthest, sinew_test::pose, sinew_test::skinned,
    sinew_test::stretch;

constexpr uint32_t kMethods[] = {SINEW_DEFORM_VOLUME, SINEW_DEFORM_XPBD, SINEW_DEFORM_DELTA_MUSH};

sinew_deform_options options_of(uint32_t method) {
  sinew_deform_options options = SINEW_INIT(sinew_deform_options);
  options.method = method;
  return options;
}

TEST(Deform, TheRestPoseComesBackExactly) {
  BentTube tube(4);
  for (float& x : tube.positions) x = x * 1.37f + 5.1f;  // no round numbers
  for (float& x : tube.joint_positions) x = x * 1.37f + 5.1f;
  for (const uint32_t method : kMethods) {
    EXPECT_EQ(pose(tube, options_of(method), tube.turned({0, 0, 1}, 0)).positions, tube.positions) << method;
  }
}

TEST(Deform, ARigidMotionMovesTheWholeRigidly) {
  const BentTube tube(3);
  const std::array<double, 12> m = BentTube::rotation_about({1, 2, 3}, 130, 0.4);
  std::vector<float> palette, want;
  for (size_t j = 0; j < 3; ++j)
    for (size_t e = 0; e < 12; ++e) palette.push_back(static_cast<float>(m[e] + (e % 4 == 3 ? 100 : 0)));
  for (uint32_t v = 0; v < tube.vertex_count(); ++v)
    for (size_t r = 0; r < 3; ++r) {
      double sum = m[4 * r + 3] + 100;
      for (size_t k = 0; k < 3; ++k) sum += m[4 * r + k] * double{tube.positions[3 * v + k]};
      want.push_back(static_cast<float>(sum));
    }
  for (const uint32_t method : kMethods) {
    const Posed posed = pose(tube, options_of(method), palette);
    EXPECT_LT(farthest(posed.positions, want), 2e-5f) << method;
    EXPECT_EQ(posed.outputs.active_tetrahedra, 0u) << method;
    EXPECT_EQ(posed.outputs.corrected, 1u) << method;
  }
}

TEST(Deform, VolumeIsKeptInABend) {
  const BentTube tube(2, 0.5);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 90);
  const double rest = tube.volume(tube.positions);
  ASSERT_GT(rest, 0);
  const auto error = [&](const std::vector<float>& at) { return std::abs(tube.volume(at) / rest - 1); };
  const double linear = error(skinned(tube, palette, false));
  const Posed posed = pose(tube, options_of(SINEW_DEFORM_VOLUME), palette);
  EXPECT_GT(linear, 0.01);
  EXPECT_LT(error(posed.positions), 0.004);
  EXPECT_LT(error(posed.positions), 0.25 * linear);
  EXPECT_GT(posed.outputs.active_tetrahedra, 0u);
  EXPECT_EQ(posed.outputs.inverted_tetrahedra, 0u);
  // Far from the bend nothing moves but with its joint.
  const std::vector<float> rigid = skinned(tube, palette, true);
  for (uint32_t v = 0; v < 5 * BentTube::kAround; ++v)
    for (size_t a = 0; a < 3; ++a) EXPECT_EQ(posed.positions[3 * v + a], rigid[3 * v + a]);
}

// Momentum: ten rounds are as near to the end as many more would be without it.
TEST(Deform, FewRoundsKeepMostOfTheVolume) {
  const BentTube tube(2, 0.3);
  sinew_deform_options options = options_of(SINEW_DEFORM_VOLUME);
  options.without = SINEW_WITHOUT_CONTACTS;
  const double rest = tube.volume(tube.positions);
  const auto error = [&](uint32_t rounds) {
    options.round_count = rounds;
    return std::abs(tube.volume(pose(tube, options, tube.turned({0, 0, 1}, 150)).positions) / rest - 1);
  };
  const double first = error(1), ten = error(10), last = error(200);
  EXPECT_LT(ten - last, 0.15 * (first - last)) << first << ' ' << ten << ' ' << last;
}

TEST(Deform, TheSidesOfAFoldStayApart) {
  const BentTube tube(2, 0.3);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 150);
  // The plane that halves the angle: what belongs to the first joint is on the side of its bone.
  const double half = (180 - 150) / 2 * 3.14159265358979 / 180;
  const double normal[2] = {-std::sin(half), -std::cos(half)};  // in x and y, towards the first bone
  const auto crossing = [&](const std::vector<float>& at) {
    double most = 0;
    for (uint32_t v = 0; v < tube.vertex_count(); ++v) {
      if (tube.weights[2 * v] < 65535) continue;
      const double side = tube.joints[2 * v] == 0 ? 1 : -1;
      const double rest = side * -double{tube.positions[3 * v]};  // before the joint is positive
      if (rest > 0.35 || rest <= 0) continue;
      const double now = side * (double{at[3 * v]} * normal[0] + double{at[3 * v + 1]} * normal[1]);
      most = std::max(most, -now);
    }
    return most;
  };
  sinew_deform_options options = options_of(SINEW_DEFORM_VOLUME);
  EXPECT_LT(crossing(pose(tube, options, palette).positions), 1e-4);
  options.without = SINEW_WITHOUT_CONTACTS;
  EXPECT_GT(crossing(pose(tube, options, palette).positions), 1e-2);
}

TEST(Deform, ATwistKeepsItsRadiusAndTheBoneTakesAPart) {
  const BentTube tube(3, 0.2);
  // The last joint alone.
  std::vector<float> palette = tube.turned({1, 0, 0}, 0), turned = tube.turned({1, 0, 0}, 175);
  std::copy_n(turned.begin() + 12, 12, palette.begin() + 24);
  const auto radius = [&](const std::vector<float>& at) {
    double least = 1;
    for (uint32_t v = 0; v + 2 < tube.vertex_count(); ++v) {
      least = std::min(least, std::hypot(double{at[3 * v + 1]}, double{at[3 * v + 2]}) / 0.2);
    }
    return least;
  };
  sinew_deform_options options = options_of(SINEW_DEFORM_VOLUME);
  const std::vector<float> spread = pose(tube, options, palette).positions;
  options.without = SINEW_WITHOUT_TWIST_SPREAD;
  const std::vector<float> kept = pose(tube, options, palette).positions;
  EXPECT_LT(radius(skinned(tube, palette, false)), 0.3);
  EXPECT_GT(radius(spread), 0.8);
  EXPECT_GT(radius(spread), radius(kept));
  // Half way along the bone of the second joint, which is at x = -1/3, nothing turns without the spread.
  uint32_t middle = 0;
  for (uint32_t v = 0; v < tube.vertex_count(); v += BentTube::kAround)
    if (std::abs(tube.positions[3 * v]) < std::abs(tube.positions[3 * middle])) middle = v;
  EXPECT_NEAR(kept[3 * middle + 1], tube.positions[3 * middle + 1], 4e-3);
  // With it, by a blend of no twist and the whole one, half of the 27 % that the bone's end has of it.
  const auto angle = [&](const std::vector<float>& at) {
    return std::atan2(double{at[3 * middle + 2]}, double{at[3 * middle + 1]}) * 180 / 3.14159265358979;
  };
  const double half = 175.0 / 2 * 3.14159265358979 / 180, share = 0.5 * 0.27;
  const double blend = 2 * std::atan2(share * std::sin(half), 1 - share + share * std::cos(half));
  EXPECT_NEAR(angle(spread) - angle(tube.positions), blend * 180 / 3.14159265358979, 0.2);
}

// A robot's upper and lower arm, which overlap at the elbow.
TEST(Deform, PartsOfOneJointKeepTheirShape) {
  BentTube tube(2, 0.3);
  const uint32_t upper = tube.vertex_count();
  const BentTube lower = tube;
  for (uint32_t v = 0; v < upper; ++v) {
    for (size_t a = 0; a < 3; ++a) tube.positions.push_back(lower.positions[3 * v + a] * (a == 0 ? 0.55f : 0.9f));
    tube.positions[3 * v] = 0.55f * tube.positions[3 * v] - 0.45f;
    tube.positions[3 * (upper + v)] += 0.45f;
    tube.joints.insert(tube.joints.end(), {1, 0});
    tube.weights.insert(tube.weights.end(), {65535, 0});
    tube.joints[2 * v] = tube.joints[2 * v + 1] = 0;
    tube.weights[2 * v] = 65535;
    tube.weights[2 * v + 1] = 0;
  }
  for (const uint32_t corner : lower.corners) tube.corners.push_back(corner + upper);
  for (const auto& axis : {std::array<double, 3>{0, 0, 1}, std::array<double, 3>{1, 0, 0}}) {
    const std::vector<float> palette = tube.turned(axis, 80);
    const std::vector<float> posed = pose(tube, options_of(SINEW_DEFORM_VOLUME), palette).positions;
    EXPECT_LT(farthest(posed, skinned(tube, palette, true)), 1e-6f);
  }
}

// As the end of a head or a toe.
TEST(Deform, AJointWithoutWeightMovesNothing) {
  BentTube tube(3, 0.2);
  for (size_t i = 0; i < tube.joints.size(); ++i) tube.joints[i] = std::min<uint16_t>(tube.joints[i], 1);
  std::vector<float> palette = tube.turned({0, 0, 1}, 40), still = palette, turned = tube.turned({1, 0, 0}, 120);
  std::copy_n(palette.begin() + 12, 12, still.begin() + 24);  // goes with its parent
  std::copy_n(turned.begin() + 24, 12, palette.begin() + 24);
  for (const uint32_t method : kMethods) {
    EXPECT_EQ(pose(tube, options_of(method), palette).positions, pose(tube, options_of(method), still).positions)
        << method;
  }
}

// Two neighbors of a chain turn by less than half a turn against each other, the first and the third by more.
TEST(Deform, BlendsOverMoreThanHalfATurnDoNotJump) {
  BentTube tube(3, 0.2);
  for (uint32_t v = 0; v < tube.vertex_count(); ++v) {  // some skin hangs on the first and the third
    if (tube.weights[2 * v] == 65535) continue;
    tube.joints[2 * v] = 0;
    tube.joints[2 * v + 1] = 2;
  }
  sinew::Deformer deformer;
  ASSERT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), {}), SINEW_OK);
  float most = 0;
  std::vector<float> last;
  for (int degrees = 80; degrees <= 140; ++degrees) {
    const std::vector<float> now = pose(&deformer, tube.turned({0, 0, 1}, degrees)).positions;
    if (!last.empty()) most = std::max(most, farthest(last, now));
    last = now;
  }
  EXPECT_LT(most, 0.15f);
}

TEST(Deform, TheOtherMethodsCalmHardWeights) {
  const BentTube tube(2, 0.02);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 60);
  const double linear = stretch(tube, skinned(tube, palette, false));
  sinew_deform_options options = options_of(SINEW_DEFORM_DELTA_MUSH);
  const std::vector<float> five = pose(tube, options, palette).positions;
  EXPECT_LT(stretch(tube, five), 0.8 * linear);
  options.round_count = 15;
  EXPECT_NE(pose(tube, options, palette).positions, five);
  options = options_of(SINEW_DEFORM_XPBD);
  options.without = SINEW_WITHOUT_SMOOTHING;
  const Posed published = pose(tube, options, palette);
  EXPECT_LT(stretch(tube, published.positions), 0.95 * linear);
  EXPECT_GT(published.outputs.active_tetrahedra, 0u);
  options.without = 0;
  EXPECT_NE(pose(tube, options, palette).positions, published.positions);
  // Far from the bend both end where the joint puts them.
  for (const std::vector<float>* at : {&five, &published.positions}) {
    for (size_t i = 0; i < 15 * BentTube::kAround; ++i) ASSERT_NEAR((*at)[i], tube.positions[i], 2e-6f) << i;
  }
}

// A joint that bends through half a turn, and contact that begins, come on step by step.
TEST(Deform, SweepsOfABendDoNotJump) {
  const BentTube tube(2, 0.3);
  for (const uint32_t without : {0u, uint32_t{SINEW_WITHOUT_CONTACTS}}) {
    sinew_deform_options options = options_of(SINEW_DEFORM_VOLUME);
    options.without = without;
    sinew::Deformer deformer;
    ASSERT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), options), SINEW_OK);
    float most = 0;
    std::vector<float> last;
    for (int degrees = without != 0 ? 150 : 0; degrees <= (without != 0 ? 210 : 110); ++degrees) {
      const std::vector<float> now = pose(&deformer, tube.turned({0, 0, 1}, degrees)).positions;
      if (!last.empty()) most = std::max(most, farthest(last, now));
      last = now;
    }
    EXPECT_LT(most, 0.06f) << without;
  }
}

// Turns that are swing and twist at once come to half a turn and pass it.
TEST(Deform, SweepsOfAMixedTurnDoNotJump) {
  const BentTube tube(2, 0.3);
  sinew::Deformer deformer;
  ASSERT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), {}), SINEW_OK);
  for (const std::array<double, 3>& axis : {std::array<double, 3>{1, 1, 0}, {1, -1, 1}, {0.5, 0, 1}}) {
    float most = 0;
    std::vector<float> last;
    for (int degrees = 100; degrees <= 260; degrees += 2) {
      const std::vector<float> now = pose(&deformer, tube.turned(axis, degrees)).positions;
      if (!last.empty()) most = std::max(most, farthest(last, now));
      last = now;
    }
    EXPECT_LT(most, 0.08f) << axis[0] << ' ' << axis[1] << ' ' << axis[2];
  }
}

TEST(Deform, APoseDependsOnItsMatricesAlone) {
  const BentTube tube(3);
  sinew::Deformer deformer;
  ASSERT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), {}), SINEW_OK);
  const std::vector<float> first = pose(&deformer, tube.turned({0, 1, 1}, 70)).positions;
  const std::vector<float> other = pose(&deformer, tube.turned({1, 0, 1}, -50)).positions;
  EXPECT_NE(first, other);
  EXPECT_EQ(pose(&deformer, tube.turned({0, 1, 1}, 70)).positions, first);
}

// Calls bodies backwards, as threads that overtake each other might, and counts its calls.
void backwards(void* calls, uint32_t count, void (*body)(void* body_data, uint32_t index), void* body_data) {
  ++*static_cast<int*>(calls);
  for (uint32_t i = count; i-- > 0;) body(body_data, i);
}

TEST(Deform, ThreadsDoNotChangeABit) {
  const BentTube tube(4, 0.3, 0.25);
  const std::vector<float> palette = tube.turned({1, 0, 1}, 75);
  for (const uint32_t without : {0u, uint32_t{SINEW_WITHOUT_CONTACTS}}) {
    sinew_deform_options options = options_of(SINEW_DEFORM_VOLUME);
    options.cell_count = 60;
    options.round_count = 6;
    options.without = without;
    const std::vector<float> one = pose(tube, options, palette).positions;
    for (const uint32_t threads : {1u, 2u, 7u, SINEW_MAX_THREADS}) {
      int calls = 0;
      options.thread_count = threads;
      options.parallel_for = backwards;
      options.parallel_user = &calls;
      EXPECT_EQ(pose(tube, options, palette).positions, one) << threads;
      if (threads > 1) {
        EXPECT_GT(calls, 50) << threads;  // skinning alone is three calls
      }
    }
  }
}

TEST(Deform, OneScaleOfAllMatricesScalesTheResult) {
  const BentTube tube(2);
  std::vector<float> palette = tube.turned({0, 0, 1}, 80);
  for (const uint32_t method : kMethods) {
    std::vector<float> want = pose(tube, options_of(method), palette).positions;
    for (float& x : want) x *= 3;
    std::vector<float> scaled = palette;
    for (float& x : scaled) x *= 3;
    const Posed posed = pose(tube, options_of(method), scaled);
    EXPECT_EQ(posed.outputs.corrected, 1u);
    EXPECT_LT(farthest(posed.positions, want), 1e-4f) << method;
  }
}

TEST(Deform, ScalesThatDifferAreSkinnedLinearly) {
  const BentTube tube(2);
  for (const float factor : {0.5f, -1.0f, 0.0f}) {
    std::vector<float> palette = tube.turned({0, 0, 1}, 40);
    for (size_t e = 12; e < 24; ++e) palette[e] *= factor;
    for (const uint32_t method : kMethods) {
      const Posed posed = pose(tube, options_of(method), palette);
      EXPECT_EQ(posed.outputs.corrected, 0u) << factor;
      EXPECT_LT(farthest(posed.positions, skinned(tube, palette, false)), 1e-5f) << factor;
    }
  }
}

TEST(Deform, OneColumnThatIsLongerIsSkinnedLinearly) {
  const BentTube tube(2);
  std::vector<float> palette = tube.turned({0, 0, 1}, 40);
  for (const size_t e : {12u, 16u, 20u}) palette[e] *= 1.1f;
  for (const uint32_t method : kMethods) {
    const Posed posed = pose(tube, options_of(method), palette);
    EXPECT_EQ(posed.outputs.corrected, 0u) << method;
    EXPECT_LT(farthest(posed.positions, skinned(tube, palette, false)), 1e-5f) << method;
  }
}

// Factors are powers of two, so that the grid rounds alike and the same cells are touched.
TEST(Deform, TheUnitOfLengthDoesNotMatter) {
  const BentTube tube(3, 0.3);
  const std::vector<float> palette = tube.turned({0, 1, 1}, 70);
  for (const uint32_t method : kMethods) {
    const std::vector<float> want = pose(tube, options_of(method), palette).positions;
    for (const float factor : {1.0f / 128, 128.0f}) {
      BentTube scaled = tube;
      for (float& x : scaled.positions) x *= factor;
      for (float& x : scaled.joint_positions) x *= factor;
      std::vector<float> matrices = palette;
      for (size_t e = 3; e < matrices.size(); e += 4) matrices[e] *= factor;
      std::vector<float> at = pose(scaled, options_of(method), matrices).positions;
      for (float& x : at) x /= factor;
      EXPECT_LT(farthest(at, want), 1e-6f) << method << ' ' << factor;
    }
  }
}

// Vertices of two tubes that nearly touch, but have different joints, are not in one tetrahedron.
TEST(Deform, PartsThatNearlyTouchStayApart) {
  BentTube tube(2, 0.3, 0.05);
  const uint32_t count = tube.vertex_count();
  const std::vector<uint32_t> corners = tube.corners;
  for (uint32_t v = 0; v < count; ++v) {
    const float p[3] = {tube.positions[3 * v], tube.positions[3 * v + 1] + 0.105f, tube.positions[3 * v + 2]};
    tube.positions.insert(tube.positions.end(), p, p + 3);
    tube.joints.insert(tube.joints.end(), {2, 0});
    tube.weights.insert(tube.weights.end(), {65535, 0});
  }
  for (const uint32_t c : corners) tube.corners.push_back(c + count);
  tube.joint_positions.insert(tube.joint_positions.end(), {-1, 0.105f, 0});
  tube.parents.push_back(0);
  sinew::Deformer deformer;
  ASSERT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), {}), SINEW_OK);
  EXPECT_GT(deformer.get().split_cell_count, 20u);
  // The first tube bends; the second, of the joint that stands still, must not move.
  std::vector<float> palette = tube.turned({0, 0, 1}, 0), bent = tube.turned({0, 0, 1}, -60);
  std::copy_n(bent.begin() + 12, 12, palette.begin() + 12);
  const std::vector<float> at = pose(&deformer, palette).positions;
  for (size_t i = 3 * count; i < at.size(); ++i) ASSERT_NEAR(at[i], tube.positions[i], 0.004f) << i;
}

TEST(Deform, MeshesThatAreNoBodyArePosedToo) {
  BentTube tube(2);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 60);
  sinew::Deformer deformer;
  for (const uint32_t method : kMethods) {
    // One vertex without a face, all vertices at one position, a flat sheet, one triangle.
    const float point[3] = {0.5f, 0.2f, 0};
    sinew_mesh mesh = {point, 1, nullptr, nullptr, 0, 0};
    ASSERT_EQ(deformer.create(mesh, tube.skeleton(), tube.skin(), options_of(method)), SINEW_OK);
    EXPECT_EQ(deformer.get().tetrahedron_count, 0u);
    (void)pose(&deformer, palette);
    BentTube flat = tube;
    for (size_t i = 2; i < flat.positions.size(); i += 3) flat.positions[i] = 0;
    for (const float x : pose(flat, options_of(method), palette).positions) ASSERT_TRUE(std::isfinite(x));
    std::fill(flat.positions.begin(), flat.positions.end(), 0.25f);
    for (const float x : pose(flat, options_of(method), palette).positions) ASSERT_TRUE(std::isfinite(x));
    BentTube one = tube;
    one.corners.resize(3);
    for (const float x : pose(one, options_of(method), palette).positions) ASSERT_TRUE(std::isfinite(x));
  }
}

TEST(Deform, ExtremePosesStayFinite) {
  const BentTube tube(4);
  sinew::Deformer deformer;
  for (const uint32_t method : kMethods) {
    ASSERT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), options_of(method)), SINEW_OK);
    for (const double degrees : {170.0, 180.0, -179.9}) {
      for (const auto& axis : {std::array<double, 3>{1, 0, 0}, {0, 0, 1}, {1, 1, 1}}) {
        for (const float x : pose(&deformer, tube.turned(axis, degrees)).positions) {
          ASSERT_LT(std::abs(x), 10) << method << ' ' << degrees;
        }
      }
    }
    std::vector<float> far = tube.turned({0, 0, 1}, 30);
    far[15] = 1e12f;  // one joint is torn away
    for (const float x : pose(&deformer, far).positions) ASSERT_TRUE(std::isfinite(x));
  }
}

class DeformRefusals : public ::testing::Test {
 protected:
  DeformRefusals() : palette(tube.turned({0, 0, 1}, 45)), out(3 * tube.vertex_count(), 7) {}
  sinew_status create(const sinew_mesh& mesh, const sinew_skeleton& skeleton, const sinew_skin& skin,
                      const sinew_deform_options& options = SINEW_INIT(sinew_deform_options)) {
    return deformer.create(mesh, skeleton, skin, options);
  }
  BentTube tube;
  sinew::Deformer deformer;
  std::vector<float> palette, out;
};

TEST_F(DeformRefusals, MatricesThatAreNoNumbers) {
  ASSERT_EQ(create(tube.mesh(), tube.skeleton(), tube.skin()), SINEW_OK);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e20f}) {
    std::vector<float> broken = palette;
    broken[17] = bad;
    sinew_deform_outputs outputs = SINEW_INIT(sinew_deform_outputs);
    outputs.positions = out.data();
    EXPECT_EQ(deformer.pose(broken.data(), &outputs), SINEW_ERROR_NOT_FINITE);
    EXPECT_EQ(out, std::vector<float>(out.size(), 7));
    EXPECT_EQ(outputs.corrected, 0u);
  }
}

TEST_F(DeformRefusals, InputsThatBreakTheRules) {
  sinew_mesh mesh = tube.mesh();
  BentTube bad = tube;
  bad.joints[5] = 2;
  EXPECT_EQ(create(mesh, tube.skeleton(), bad.skin()), SINEW_ERROR_RANGE);
  bad = tube;
  bad.parents = {1, 0};
  EXPECT_EQ(create(mesh, bad.skeleton(), tube.skin()), SINEW_ERROR_HIERARCHY);
  bad.parents = {-1, 2};
  EXPECT_EQ(create(mesh, bad.skeleton(), tube.skin()), SINEW_ERROR_INDEX);
  bad = tube;
  bad.joint_positions[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(create(mesh, bad.skeleton(), tube.skin()), SINEW_ERROR_NOT_FINITE);
  bad = tube;
  bad.positions[8] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(create(bad.mesh(), tube.skeleton(), tube.skin()), SINEW_ERROR_NOT_FINITE);
  bad = tube;
  bad.corners[8] = tube.vertex_count();
  EXPECT_EQ(create(bad.mesh(), tube.skeleton(), tube.skin()), SINEW_ERROR_INDEX);
  mesh.vertex_count = 0;
  EXPECT_EQ(create(mesh, tube.skeleton(), tube.skin()), SINEW_ERROR_COUNT);
  sinew_skin none = tube.skin();
  none.influence_count = 0;
  EXPECT_EQ(create(tube.mesh(), tube.skeleton(), none), SINEW_ERROR_ARGUMENT);
}

TEST_F(DeformRefusals, OptionsOutOfRange) {
  const auto refused = [&](auto change) {
    sinew_deform_options options = SINEW_INIT(sinew_deform_options);
    change(options);
    return create(tube.mesh(), tube.skeleton(), tube.skin(), options);
  };
  EXPECT_EQ(refused([](auto& o) { o.method = 3; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.cell_count = 7; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.cell_count = SINEW_MAX_DEFORM_CELLS + 1; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.round_count = SINEW_MAX_DEFORM_ROUNDS + 1; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.softness = 65536; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.without = SINEW_WITHOUT_TOES; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.thread_count = SINEW_MAX_THREADS + 1; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.body_contact = 2; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused([](auto& o) { o.cell_count = 8; }), SINEW_OK);
  EXPECT_EQ(refused([](auto& o) { o.cell_count = SINEW_MAX_DEFORM_CELLS; }), SINEW_OK);
}

// The sizes are enough and not one step too large, and nothing is written behind them.
TEST_F(DeformRefusals, MemoryThatIsShort) {
  for (const uint32_t method : kMethods) {
    const sinew_deform_options options = options_of(method);
    const sinew_mesh mesh = tube.mesh();
    const sinew_skeleton skeleton = tube.skeleton();
    const sinew_skin skin = tube.skin();
    size_t bytes = 0;
    ASSERT_EQ(sinew_deform_create_workspace_size(&mesh, 2, 2, &options, &bytes), SINEW_OK);
    sinew::Workspace memory(bytes + 64);
    uint8_t* const base = static_cast<uint8_t*>(memory.data());
    std::fill_n(base + bytes, 64, uint8_t{0x5A});
    sinew_deformer made = {};
    EXPECT_EQ(sinew_deform_create(&mesh, &skeleton, &skin, &options, base, bytes - 64, &made), SINEW_ERROR_WORKSPACE);
    EXPECT_EQ(sinew_deform_create(&mesh, &skeleton, &skin, &options, base + 8, bytes, &made), SINEW_ERROR_WORKSPACE);
    EXPECT_EQ(made.memory, nullptr);
    ASSERT_EQ(sinew_deform_create(&mesh, &skeleton, &skin, &options, base, bytes, &made), SINEW_OK);
    EXPECT_EQ(std::count(base + bytes, base + bytes + 64, 0x5A), 64);
    sinew::Workspace workspace(made.pose_bytes + 64);
    uint8_t* const scratch = static_cast<uint8_t*>(workspace.data());
    std::fill_n(scratch + made.pose_bytes, 64, uint8_t{0x5A});
    sinew_deform_outputs outputs = SINEW_INIT(sinew_deform_outputs);
    outputs.positions = out.data();
    EXPECT_EQ(sinew_deform_pose(&made, palette.data(), scratch, made.pose_bytes - 64, &outputs), SINEW_ERROR_WORKSPACE);
    EXPECT_EQ(out[0], 7);
    ASSERT_EQ(sinew_deform_pose(&made, palette.data(), scratch, made.pose_bytes, &outputs), SINEW_OK);
    EXPECT_EQ(std::count(scratch + made.pose_bytes, scratch + made.pose_bytes + 64, 0x5A), 64);
    out.assign(out.size(), 7);
  }
}

}  // namespace
