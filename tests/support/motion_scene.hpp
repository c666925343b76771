// SPDX-License-Identifier: MIT
// A body of seventeen joints for motion tests, with arms at any height, and poses of it.
#ifndef SINEW_TESTS_SUPPORT_MOTION_SCENE_HPP
#define SINEW_TESTS_SUPPORT_MOTION_SCENE_HPP

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "motion/quaternion.hpp"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace sinew_test {

using sinew::Vec3d;
using sinew::motion::Quat;

inline Vec3d vec(const float* p) { return {double{p[0]}, double{p[1]}, double{p[2]}}; }
inline Quat quat(const float* q) { return {double{q[0]}, double{q[1]}, double{q[2]}, double{q[3]}}; }
inline double distance(Vec3d a, Vec3d b) { return std::sqrt(sinew::dot(a - b, a - b)); }

struct MotionScene {
  std::vector<float> positions, rotations;  // rotations empty: the world's axes
  std::vector<int32_t> parents;
  std::vector<uint8_t> classes;

  uint32_t count() const { return static_cast<uint32_t>(parents.size()); }
  uint32_t up = SINEW_UP_AUTO;

  sinew_skeleton view() const {
    sinew_skeleton view = skeleton_of(positions.data(), parents.data(), count());
    if (!rotations.empty()) view.rotations = rotations.data();
    view.up = up;
    return view;
  }
  Vec3d at(size_t j) const { return vec(&positions[3 * j]); }
  Quat rest(size_t j) const {
    return rotations.empty() ? sinew::motion::kNoRotation : sinew::motion::normalized(quat(&rotations[4 * j]));
  }
  uint32_t add(Vec3d p, int32_t parent, uint8_t joint_class) {
    positions.insert(positions.end(), {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    parents.push_back(parent);
    classes.push_back(joint_class);
    return count() - 1;
  }
};

enum BodyJoint : uint32_t {
  kPelvis,
  kSpine,
  kNeck,
  kHead,
  kLeftUpperArm,
  kLeftForearm,
  kLeftHand,
  kRightUpperArm,
  kRightForearm,
  kRightHand,
  kLeftThigh,
  kLeftCalf,
  kLeftFoot,
  kRightThigh,
  kRightCalf,
  kRightFoot,
  kLeftFinger
};

// Feet at height 0.1, legs of 0.8, arms `degrees` below level; all of it times `size`.
inline MotionScene body(double degrees, double size = 1) {
  MotionScene scene;
  const double down = degrees * 3.14159265358979 / 180, c = std::cos(down), s = std::sin(down);
  const auto add = [&](double x, double y, double z, int32_t parent, uint8_t joint_class) {
    scene.add({size * x, size * y, size * z}, parent, joint_class);
  };
  add(0, 1, 0, -1, SINEW_CLASS_PELVIS);
  add(0, 1.2, 0, kPelvis, SINEW_CLASS_SPINE);
  add(0, 1.5, 0, kSpine, SINEW_CLASS_NECK);
  add(0, 1.6, 0, kNeck, SINEW_CLASS_HEAD);
  for (const double side : {1.0, -1.0}) {
    const int32_t first = static_cast<int32_t>(scene.count());
    add(side * 0.2, 1.45, 0, kSpine, SINEW_CLASS_UPPER_ARM);
    add(side * (0.2 + 0.3 * c), 1.45 - 0.3 * s, 0, first, SINEW_CLASS_FOREARM);
    add(side * (0.2 + 0.55 * c), 1.45 - 0.55 * s, 0.02, first + 1, SINEW_CLASS_HAND);
  }
  for (const double side : {1.0, -1.0}) {
    const int32_t first = static_cast<int32_t>(scene.count());
    add(side * 0.1, 0.9, 0, kPelvis, SINEW_CLASS_THIGH);
    add(side * 0.1, 0.5, 0.02, first, SINEW_CLASS_CALF);
    add(side * 0.1, 0.1, 0, first + 1, SINEW_CLASS_FOOT);
  }
  add(0.2 + 0.65 * c, 1.45 - 0.65 * s, 0.02, kLeftHand, SINEW_CLASS_INDEX);
  return scene;
}

struct Pose {
  std::vector<float> rotations, translations;

  explicit Pose(uint32_t joints) : rotations(4 * size_t{joints}, 77), translations(3 * size_t{joints}, 77) {}
  void set(size_t j, Quat q, Vec3d p) {
    const double r[4] = {q.x, q.y, q.z, q.w}, t[3] = {p.x, p.y, p.z};
    for (size_t i = 0; i < 4; ++i) rotations[4 * j + i] = static_cast<float>(r[i]);
    for (size_t i = 0; i < 3; ++i) translations[3 * j + i] = static_cast<float>(t[i]);
  }
};

// The rest pose as locals.
inline Pose rest_pose(const MotionScene& scene) {
  Pose pose(scene.count());
  for (uint32_t j = 0; j < scene.count(); ++j) {
    const int32_t parent = scene.parents[j];
    const size_t p = static_cast<size_t>(parent);
    if (parent < 0)
      pose.set(j, scene.rest(j), scene.at(j));
    else
      pose.set(j, conjugate(scene.rest(p)) * scene.rest(j),
               rotate(conjugate(scene.rest(p)), scene.at(j) - scene.at(p)));
  }
  return pose;
}

// Of body(): the left hand in front of the belly, as far as the upper arm points forward.
inline Pose reaching_pose(const MotionScene& scene, Vec3d upper_arm) {
  Pose pose = rest_pose(scene);
  const Quat upper = sinew::motion::shortest_arc(scene.at(kLeftForearm) - scene.at(kLeftUpperArm), upper_arm);
  const Quat lower =
      sinew::motion::shortest_arc(rotate(upper, scene.at(kLeftHand) - scene.at(kLeftForearm)), {-0.9, 0.05, 0.1});
  pose.set(kLeftUpperArm, upper, vec(&pose.translations[3 * kLeftUpperArm]));
  pose.set(kLeftForearm, conjugate(upper) * lower * upper, vec(&pose.translations[3 * kLeftForearm]));
  return pose;
}

// Every joint turned somehow by at most `most` radians about each axis, the root moved.
inline Pose random_pose(const MotionScene& scene, uint32_t seed, double most, Vec3d way = {0, 0, 0}) {
  std::mt19937 random(seed);
  const auto draw = [&] { return most * (static_cast<double>(random()) / 2147483648.0 - 1); };
  Pose pose = rest_pose(scene);
  for (uint32_t j = 0; j < scene.count(); ++j) {
    const Quat turn = sinew::motion::normalized({std::sin(draw() / 2), std::sin(draw() / 2), std::sin(draw() / 2), 1});
    const Vec3d position = vec(&pose.translations[3 * j]);
    pose.set(j, quat(&pose.rotations[4 * j]) * turn, scene.parents[j] < 0 ? position + way : position);
  }
  return pose;
}

// Joints in the world: parents come before children in these scenes.
struct WorldPose {
  std::vector<Quat> rotations;
  std::vector<Vec3d> positions;
};
inline WorldPose world_pose(const MotionScene& scene, const Pose& pose) {
  WorldPose out;
  for (uint32_t j = 0; j < scene.count(); ++j) {
    const Quat q = quat(&pose.rotations[4 * j]);
    const Vec3d p = vec(&pose.translations[3 * j]);
    const int32_t parent = scene.parents[j];
    if (parent < 0) {
      out.rotations.push_back(q);
      out.positions.push_back(p);
    } else {
      const size_t a = static_cast<size_t>(parent);
      out.rotations.push_back(out.rotations[a] * q);
      out.positions.push_back(out.positions[a] + rotate(out.rotations[a], p));
    }
  }
  return out;
}

inline std::vector<int32_t> one_to_one(uint32_t count) {
  std::vector<int32_t> map;
  for (uint32_t j = 0; j < count; ++j) map.push_back(static_cast<int32_t>(j));
  return map;
}

}  // namespace sinew_test
#endif
