// SPDX-License-Identifier: MIT
// Crawl, plank, push-up, kneel and sit by code, and bodies of other proportions to play them on.
#ifndef SINEW_TESTS_SUPPORT_FLOOR_MOTIONS_HPP
#define SINEW_TESTS_SUPPORT_FLOOR_MOTIONS_HPP

#include <cmath>
#include <functional>

#include "motion_clip.hpp"

namespace sinew_test {

constexpr double kPi = 3.14159265358979;

struct Proportions {
  double arms = 1, trunk = 1, thighs = 1, calves = 1, size = 1;
};

// body() with longer or shorter bones; feet stay where they are.
inline MotionScene built(const Proportions& p) {
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

inline Vec3d direction(double angle) { return {0, -std::cos(angle), std::sin(angle)}; }

inline Pose posed(const MotionScene& scene, const Directions& d, Vec3d shift) {
  std::vector<Quat> world(scene.count(), sinew::motion::kNoRotation);
  const Quat trunk = sinew::motion::shortest_arc({0, 1, 0}, direction(d.trunk));
  for (uint32_t j : {kPelvis, kSpine, kNeck, kHead}) world[j] = trunk;
  for (int side = 0; side < 2; ++side) {
    const uint32_t arm = side == 0 ? kLeftUpperArm : kRightUpperArm, leg = side == 0 ? kLeftThigh : kRightThigh;
    const auto turn = [&](uint32_t j, double angle) {
      return sinew::motion::shortest_arc(scene.at(j + 1) - scene.at(j), direction(angle));
    };
    world[arm] = turn(arm, d.arms[side]);
    world[arm + 1] = turn(arm + 1, d.forearms[side]);
    world[arm + 2] =
        sinew::motion::shortest_arc(side == 0 ? scene.at(kLeftFinger) - scene.at(kLeftHand) : Vec3d{-1, 0, 0},
                                    {0, 0, 1});  // flat, fingers to the front
    world[leg] = turn(leg, d.thighs[side]);
    world[leg + 1] = turn(leg + 1, d.calves[side]);
    world[leg + 2] = sinew::motion::shortest_arc({0, -1, 0}, direction(d.feet));
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
inline double lowest(const MotionScene& scene, const BoxBody& boxes, const WorldPose& pose, int joint) {
  double rest = 1e9, low = 1e9;
  for (size_t v = 0; v < boxes.joints.size(); ++v) {
    const Vec3d p = vec(&boxes.positions[3 * v]);
    rest = std::min(rest, p.y);
    const size_t j = boxes.joints[v];
    if (joint >= 0 && j != static_cast<size_t>(joint)) continue;
    low = std::min(low, (pose.positions[j] + rotate(pose.rotations[j], p - scene.at(j))).y);
  }
  return low - rest;
}

using Motion = std::function<Directions(double)>;

// The steepness of the trunk at which hands are as low as the knees, or as the feet.
inline void fit_trunk(const MotionScene& scene, const BoxBody& boxes, uint32_t with, Directions* d) {
  double low = 0.3, high = kPi - 0.2;
  for (int i = 0; i < 20; ++i) {
    d->trunk = 0.5 * (low + high);
    const WorldPose pose = world_pose(scene, posed(scene, *d, {0, 0, 0}));
    const double hands = std::min(lowest(scene, boxes, pose, kLeftHand), lowest(scene, boxes, pose, kRightHand));
    (hands > lowest(scene, boxes, pose, static_cast<int>(with)) ? high : low) = d->trunk;
  }
}

inline const std::vector<Proportions>& builds() {
  static const std::vector<Proportions> all = {{0.85, 1, 1, 1, 1},      {1.15, 1, 1, 1, 1},     {1, 1.15, 1, 1, 0.7},
                                               {1, 0.85, 1, 1, 1.4},    {1, 1, 1.15, 0.9, 1},   {1, 1, 0.88, 1.12, 1},
                                               {0.9, 1.1, 0.9, 1, 0.5}, {1.1, 0.9, 1.1, 1.1, 1}};
  return all;
}

inline Directions crawling(double t) {
  Directions d;
  const double s = 0.25 * std::sin(2 * kPi * t);
  d.thighs[0] = s;
  d.thighs[1] = -s;
  d.calves[0] = d.calves[1] = -kQuarter - 0.02;
  d.arms[0] = d.forearms[0] = -s;
  d.arms[1] = d.forearms[1] = s;
  d.feet = -kQuarter;
  return d;
}

inline Directions planking(double t) {
  Directions d;
  d.thighs[0] = d.thighs[1] = d.calves[0] = d.calves[1] = -1.2 - 0.02 * std::sin(kPi * t);
  d.feet = -0.4;
  return d;
}
inline Directions pushing(double t) {
  Directions d = planking(0);
  const double bend = 0.5 * (1 - std::cos(kPi * t));
  d.arms[0] = d.arms[1] = -bend;
  d.forearms[0] = d.forearms[1] = 0.6 * bend;
  return d;
}
inline Directions kneeling(double t) {
  Directions d;
  d.trunk = kPi - 0.1 * std::sin(kPi * t);
  d.calves[0] = d.calves[1] = -kQuarter - 0.02;
  d.feet = -kQuarter;
  return d;
}
inline Directions sitting(double t) {
  Directions d;
  d.trunk = kPi - 0.05 * std::sin(kPi * t);
  d.thighs[0] = d.thighs[1] = d.calves[0] = d.calves[1] = kQuarter;
  d.arms[0] = d.arms[1] = d.forearms[0] = d.forearms[1] = 1.2;
  return d;
}

}  // namespace sinew_test
#endif
