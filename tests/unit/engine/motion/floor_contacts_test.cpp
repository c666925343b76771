// SPDX-License-Identifier: MIT
// The whole body on the floor: crawl, plank, push-up, kneel and sit of one body on bodies of other proportions.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "motion/contacts.hpp"
#include "motion_clip.hpp"

namespace {

using namespace sinew_test;

constexpr double kPi = 3.14159265358979;

struct Proportions {
  double arms = 1, trunk = 1, thighs = 1, calves = 1, size = 1;
};

// body() with longer or shorter bones; feet stay where they are.
MotionScene built(const Proportions& p) {
  MotionScene scene = body(10);
  for (const uint32_t j : {uint32_t{kLeftHand}, uint32_t{kRightHand}, uint32_t{kLeftFinger}})
    scene.positions[3 * j + 2] += 0.03f;  // to which side elbows bend
  const MotionScene rest = scene;
  const auto factor = [&](uint32_t j) {
    if (j == kSpine || j == kNeck || j == kHead) return p.trunk;
    if (j == kLeftForearm || j == kLeftHand || j == kRightForearm || j == kRightHand) return p.arms;
    if (j == kLeftCalf || j == kRightCalf) return p.thighs;
    return j == kLeftFoot || j == kRightFoot ? p.calves : 1.0;
  };
  for (uint32_t j = 1; j < scene.count(); ++j) {
    const uint32_t above = static_cast<uint32_t>(rest.parents[j]);
    const Vec3d at = scene.at(above) + factor(j) * (rest.at(j) - rest.at(above));
    for (int i = 0; i < 3; ++i) scene.positions[3 * j + i] = static_cast<float>(i == 0 ? at.x : i == 1 ? at.y : at.z);
  }
  const double sink = scene.at(kLeftFoot).y - rest.at(kLeftFoot).y;
  for (uint32_t j = 0; j < scene.count(); ++j) scene.positions[3 * j + 1] = static_cast<float>(scene.at(j).y - sink);
  for (float& x : scene.positions) x = static_cast<float>(p.size * x);
  return scene;
}

// Directions of bones in the world, by angles: 0 down, a quarter turn to the front, half a turn up.
struct Directions {
  double trunk = 2, thighs[2] = {0, 0}, calves[2] = {0, 0}, arms[2] = {0, 0}, forearms[2] = {0, 0}, feet = 0;
};
constexpr double kQuarter = kPi / 2;

Vec3d direction(double angle) { return {0, -std::cos(angle), std::sin(angle)}; }

Pose posed(const MotionScene& scene, const Directions& d, Vec3d shift) {
  std::vector<Quat> world(scene.count(), sinew::kNoRotation);
  const Quat trunk = sinew::shortest_arc({0, 1, 0}, direction(d.trunk));
  for (uint32_t j : {kPelvis, kSpine, kNeck, kHead}) world[j] = trunk;
  for (int side = 0; side < 2; ++side) {
    const uint32_t arm = side == 0 ? kLeftUpperArm : kRightUpperArm, leg = side == 0 ? kLeftThigh : kRightThigh;
    const auto turn = [&](uint32_t j, double angle) {
      return sinew::shortest_arc(scene.at(j + 1) - scene.at(j), direction(angle));
    };
    world[arm] = turn(arm, d.arms[side]);
    world[arm + 1] = turn(arm + 1, d.forearms[side]);
    world[arm + 2] = sinew::shortest_arc(side == 0 ? scene.at(kLeftFinger) - scene.at(kLeftHand) : Vec3d{-1, 0, 0},
                                         {0, 0, 1});  // flat, fingers to the front
    world[leg] = turn(leg, d.thighs[side]);
    world[leg + 1] = turn(leg + 1, d.calves[side]);
    world[leg + 2] = sinew::shortest_arc({0, -1, 0}, direction(d.feet));
  }
  world[kLeftFinger] = world[kLeftHand];
  Pose pose = rest_pose(scene);
  for (uint32_t j = 0; j < scene.count(); ++j) {
    const int32_t p = scene.parents[j];
    if (p < 0)
      pose.set(j, world[j], scene.at(j) + shift);
    else
      pose.set(j, conjugate(world[static_cast<size_t>(p)]) * world[j], vec(&pose.translations[3 * j]));
  }
  return pose;
}

// Lowest vertex of the boxes around joints, over the floor of the body at rest; all joints: `joint` -1.
double lowest(const MotionScene& scene, const BoxBody& boxes, const Placed& pose, int joint) {
  double rest = 1e9, low = 1e9;
  for (size_t v = 0; v < boxes.joints.size(); ++v) {
    const Vec3d p = vec(&boxes.positions[3 * v]);
    rest = std::min(rest, p.y);
    const size_t j = boxes.joints[v];
    if (joint >= 0 && j != static_cast<size_t>(joint)) continue;
    low = std::min(low, (pose.places[j] + rotate(pose.rotations[j], p - scene.at(j))).y);
  }
  return low - rest;
}

using Motion = std::function<Directions(double)>;

// The steepness of the trunk at which hands are as low as the knees, or as the feet.
void fit_trunk(const MotionScene& scene, const BoxBody& boxes, uint32_t with, Directions* d) {
  double low = 0.3, high = kPi - 0.2;
  for (int i = 0; i < 20; ++i) {
    d->trunk = 0.5 * (low + high);
    const Placed pose = placed(scene, posed(scene, *d, {0, 0, 0}));
    const double hands = std::min(lowest(scene, boxes, pose, kLeftHand), lowest(scene, boxes, pose, kRightHand));
    (hands > lowest(scene, boxes, pose, static_cast<int>(with)) ? high : low) = d->trunk;
  }
}

struct Figures {
  double off = 0, below = 0;  // shares of the height
  int contacts = 0;
};

// Plays a motion, and looks where hands, knees and pelvis of the source touch its floor.
Figures play(const Motion& motion, const Proportions& p, bool with_source, int stands_with, double along) {
  const MotionScene source = built({}), target = built(p);
  const BoxBody a(source, 0.1), b(target, 0.1 * p.size, p.size);
  PlayedClip clip(source, target);
  std::vector<Placed> poses;
  for (int f = 0; f < 30; ++f) {
    Directions d = motion(f / 15.0);
    if (stands_with >= 0) fit_trunk(source, a, static_cast<uint32_t>(stands_with), &d);
    Pose pose = posed(source, d, {0, 0, 2 * along * f});
    const double low = lowest(source, a, placed(source, pose), -1);
    pose = posed(source, d, {0, -low, 2 * along * f});
    poses.push_back(placed(source, pose));
    clip.add(pose);
  }
  EXPECT_EQ(clip.contacts(with_source ? &a : nullptr, b), SINEW_OK);
  Figures out;
  const double height = 1.58 * p.size;
  for (uint32_t f = 0; f < clip.frames; ++f) {
    const Placed now = clip.frame(f);
    out.below = std::max(out.below, -lowest(target, b, now, -1) / height);
    for (const uint32_t j : {kLeftHand, kRightHand, kLeftCalf, kRightCalf, kLeftForearm, kRightForearm, kLeftThigh,
                             kRightThigh, kLeftFoot, kRightFoot}) {
      if (lowest(source, a, poses[f], static_cast<int>(j)) > 0.004) continue;
      ++out.contacts;
      double low = lowest(target, b, now, static_cast<int>(j));
      if (j == kLeftHand) low = std::min(low, lowest(target, b, now, kLeftFinger));
      const double off = std::abs(low) / height;
      out.off = std::max(out.off, off);
    }
  }
  return out;
}

const std::vector<Proportions>& builds() {
  static const std::vector<Proportions> all = {{0.85, 1, 1, 1, 1},      {1.15, 1, 1, 1, 1},     {1, 1.15, 1, 1, 0.7},
                                               {1, 0.85, 1, 1, 1.4},    {1, 1, 1.15, 0.9, 1},   {1, 1, 0.88, 1.12, 1},
                                               {0.9, 1.1, 0.9, 1, 0.5}, {1.1, 0.9, 1.1, 1.1, 1}};
  return all;
}

Directions crawling(double t) {
  Directions d;
  const double s = 0.25 * std::sin(2 * kPi * t);
  d.thighs[0] = s;
  d.thighs[1] = -s;
  d.calves[0] = d.calves[1] = -kQuarter + 0.03;
  d.arms[0] = d.forearms[0] = -s;
  d.arms[1] = d.forearms[1] = s;
  d.feet = -kQuarter;
  return d;
}

Directions planking(double t) {
  Directions d;
  d.thighs[0] = d.thighs[1] = d.calves[0] = d.calves[1] = -1.2 - 0.02 * std::sin(kPi * t);
  d.feet = -0.4;
  return d;
}
Directions pushing(double t) {
  Directions d = planking(0);
  const double bend = 0.5 * (1 - std::cos(kPi * t));
  d.arms[0] = d.arms[1] = -bend;
  d.forearms[0] = d.forearms[1] = 0.6 * bend;
  return d;
}
Directions kneeling(double t) {
  Directions d;
  d.trunk = kPi - 0.1 * std::sin(kPi * t);
  d.calves[0] = d.calves[1] = -kQuarter + 0.03;
  d.feet = -kQuarter;
  return d;
}
Directions sitting(double t) {
  Directions d;
  d.trunk = kPi - 0.05 * std::sin(kPi * t);
  d.thighs[0] = d.thighs[1] = d.calves[0] = d.calves[1] = kQuarter;
  d.arms[0] = d.arms[1] = d.forearms[0] = d.forearms[1] = 1.2;
  return d;
}

void expect_on_floor(const Motion& motion, int stands_with, double along, int contacts) {
  for (const Proportions& p : builds()) {
    for (const bool with_source : {true, false}) {
      const Figures found = play(motion, p, with_source, stands_with, along);
      const auto what = ::testing::Message() << "arms " << p.arms << " trunk " << p.trunk << " thighs " << p.thighs
                                             << " size " << p.size << (with_source ? "" : ", no body");
      EXPECT_GE(found.contacts, contacts) << what;
      EXPECT_LT(found.off, 0.01) << what;
      EXPECT_LT(found.below, 0.005) << what;
    }
  }
}

TEST(FloorContacts, HandsAndKneesCrawl) { expect_on_floor(crawling, kLeftCalf, 0.01, 60); }
TEST(FloorContacts, HandsCarryAPlank) { expect_on_floor(planking, kLeftFoot, 0, 90); }
TEST(FloorContacts, HandsStayDownInAPushUp) { expect_on_floor(pushing, kLeftFoot, 0, 90); }
TEST(FloorContacts, KneesKneel) { expect_on_floor(kneeling, -1, 0, 60); }
TEST(FloorContacts, TheSeatSits) { expect_on_floor(sitting, -1, 0, 60); }

// A hand that stays where it is in the source does so in the target, although its shoulders go elsewhere.
TEST(FloorContacts, HandsOnTheFloorDoNotSlide) {
  const MotionScene source = built({}), target = built({1.15, 0.9, 1, 1, 1});
  const BoxBody a(source, 0.1), b(target, 0.1);
  PlayedClip clip(source, target);
  Directions d = planking(0);
  fit_trunk(source, a, kLeftFoot, &d);
  const Pose first = posed(source, d, {0, 0, 0});
  const double low = lowest(source, a, placed(source, first), -1);
  for (int f = 0; f < 20; ++f) {  // hips to and fro, hands and feet where they are
    const double swing = 0.03 * std::sin(0.4 * f);
    Directions moved = d;
    for (int side = 0; side < 2; ++side) {
      moved.arms[side] = moved.forearms[side] = -swing / 0.55;
      moved.thighs[side] = moved.calves[side] = d.thighs[side] - swing / 0.8 * std::cos(d.thighs[side]);
    }
    clip.add(posed(source, moved, {0, -low, swing}));
  }
  const auto slide = [&] {
    double most = 0;
    for (uint32_t f = 1; f < clip.frames; ++f)
      most = std::max(most, distance(clip.frame(f).places[kRightHand], clip.frame(f - 1).places[kRightHand]));
    return most;
  };
  EXPECT_GT(slide(), 0.001) << "copied";
  ASSERT_EQ(clip.contacts(&a, b), SINEW_OK);
  EXPECT_LT(slide(), 0.0005);
}

// A foot on every step, and the body over the lower one.
TEST(FloorContacts, FeetStandOnAnUnevenFloor) {
  const MotionScene scene = built({}), target = built({1, 1, 1.05, 1, 1});
  const BoxBody boxes(scene, 0.1), own(target, 0.1);
  const float steps[] = {0.2f, 0.3f, 0.2f, 0.3f};  // from right to left
  sinew_floor floor = {steps, 2, 2, {-0.1f, -1}, 0.2f, 0};
  sinew::ContactSettings settings;
  settings.floor = &floor;
  PlayedClip clip(scene, target);
  for (int f = 0; f < 5; ++f) clip.add(rest_pose(scene));
  const double hips = clip.frame(2).places[kPelvis].y;
  ASSERT_EQ(clip.contacts(&boxes, own, settings), SINEW_OK);
  const Placed stands = clip.frame(2);
  EXPECT_NEAR(stands.places[kLeftFoot].y, 0.1 + 0.3, 5e-3) << "where the floor is highest below it";
  EXPECT_NEAR(stands.places[kRightFoot].y, 0.1 + 0.22, 5e-3);
  EXPECT_NEAR(stands.places[kPelvis].y, hips + 0.2, 1e-6);

  const auto refused = [&](sinew_floor wrong) {
    settings.floor = &wrong;
    return clip.contacts(&boxes, own, settings);
  };
  const std::vector<float> before = clip.rotations;
  EXPECT_EQ(refused({nullptr, 2, 2, {0, 0}, 1, 0}), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused({steps, 0, 2, {0, 0}, 1, 0}), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused({steps, 2, 2, {0, 0}, 0, 0}), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused({steps, 2, SINEW_MAX_FLOOR_SIDE + 1, {0, 0}, 1, 0}), SINEW_ERROR_COUNT);
  const float hole[] = {0, 0, std::numeric_limits<float>::quiet_NaN(), 0};
  EXPECT_EQ(refused({hole, 2, 2, {0, 0}, 1, 0}), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(clip.rotations, before);
}

}  // namespace
