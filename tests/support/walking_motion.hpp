// SPDX-License-Identifier: MIT
// A person who walks, made in code, and the same motion as other programs would have written it.
#ifndef SINEW_TESTS_SUPPORT_WALKING_MOTION_HPP
#define SINEW_TESTS_SUPPORT_WALKING_MOTION_HPP

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "random.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// Y up, facing +z, left at +x, arms to the sides. The root stands at the origin at rest.
inline Motion walking_person(size_t frames = 60) {
  Motion motion;
  motion.name = "walk";
  const auto add = [&](const char* name, int parent, Point3 offset) {
    motion.joints.push_back({name, parent, offset});
    return static_cast<int>(motion.joints.size()) - 1;
  };
  const int hips = add("Hips", -1, {0, 0, 0});
  const int spine = add("Spine", hips, {0, 0.12, -0.01}), chest = add("Chest", spine, {0, 0.2, 0});
  const int neck = add("Neck", chest, {0, 0.22, 0}), head = add("Head", neck, {0, 0.1, 0.02});
  motion.joints[static_cast<size_t>(add("Head_end", head, {0, 0.18, 0}))].end = true;
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "Left" : "Right";
    const int shoulder = add((name + "Shoulder").c_str(), chest, {side * 0.05, 0.17, 0});
    const int arm = add((name + "Arm").c_str(), shoulder, {side * 0.13, 0, 0});
    const int fore = add((name + "ForeArm").c_str(), arm, {side * 0.28, 0, 0});
    const int hand = add((name + "Hand").c_str(), fore, {side * 0.25, 0, 0});
    motion.joints[static_cast<size_t>(add((name + "Hand_end").c_str(), hand, {side * 0.15, 0, 0}))].end = true;
    const int thigh = add((name + "UpLeg").c_str(), hips, {side * 0.09, -0.05, 0});
    const int shin = add((name + "Leg").c_str(), thigh, {side * 0.01, -0.42, 0});
    const int foot = add((name + "Foot").c_str(), shin, {0, -0.42, -0.01});
    const int toe = add((name + "ToeBase").c_str(), foot, {0, -0.07, 0.13});
    motion.joints[static_cast<size_t>(add((name + "ToeBase_end").c_str(), toe, {0, -0.01, 0.06}))].end = true;
  }
  Clip clip = {"walk", 1.0 / 30, {}};
  for (size_t f = 0; f < frames; ++f) {
    MotionFrame frame;
    const double phase = 0.21 * static_cast<double>(f);
    for (const MotionJoint& joint : motion.joints) {
      frame.translations.push_back(joint.offset);
      Quaternion turn = kNoRotation4;
      const bool left = joint.name.rfind("Left", 0) == 0;
      const double swing = std::sin(phase) * (left ? 1 : -1);
      const std::string part = joint.name.substr(left ? 4 : joint.name.rfind("Right", 0) == 0 ? 5 : 0);
      if (part == "Hips") turn = axis_rotation(1, 0.05 * std::sin(phase));
      if (part == "Spine") turn = axis_rotation(0, 0.03);
      if (part == "UpLeg") turn = axis_rotation(0, -0.45 * swing);
      if (part == "Leg") turn = axis_rotation(0, 0.25 - 0.25 * std::cos(phase + (left ? 0 : 3.14)));
      if (part == "Arm") turn = multiply(axis_rotation(0, 0.3 * swing), axis_rotation(2, left ? -1.3 : 1.3));
      if (part == "ForeArm") turn = axis_rotation(1, left ? -0.35 : 0.35);
      frame.rotations.push_back(turn);
    }
    frame.translations[0] = {0, 0.95 + 0.01 * std::cos(2 * phase), 0.03 * static_cast<double>(f)};
    clip.frames.push_back(std::move(frame));
  }
  motion.clips.push_back(std::move(clip));
  return motion;
}

// Another rest pose for the same motion: joint j is turned by `turn_of(j)` at rest.
inline Motion with_axes(const Motion& motion, const std::function<Quaternion(size_t)>& turn_of) {
  Motion out = motion;
  std::vector<Quaternion> turns;
  for (size_t j = 0; j < motion.joints.size(); ++j) turns.push_back(turn_of(j));
  const auto above = [&](size_t j) {
    const int parent = motion.joints[j].parent;
    return parent < 0 ? kNoRotation4 : turns[static_cast<size_t>(parent)];
  };
  for (size_t j = 0; j < motion.joints.size(); ++j) {
    out.joints[j].offset = rotate(above(j), motion.joints[j].offset);
    for (Clip& clip : out.clips)
      for (MotionFrame& frame : clip.frames) {
        frame.rotations[j] = normalized(multiply(above(j), multiply(frame.rotations[j], conjugate(turns[j]))));
        frame.translations[j] = rotate(above(j), frame.translations[j]);
      }
  }
  return out;
}
inline Motion with_random_axes(const Motion& motion, uint32_t seed = 1) {
  test::Random random(seed);
  return with_axes(motion, [&](size_t) {
    const auto part = [&] { return 2 * random.uniform() - 1; };
    return normalized({part(), part(), part(), part()});
  });
}
// All bones along x at rest, as programs write them whose joints have their bones there.
inline Motion with_bones_in_one_line(const Motion& motion) {
  std::vector<Quaternion> turns(motion.joints.size(), kNoRotation4);
  for (size_t j = motion.joints.size(); j-- > 1;)  // the first child decides
    turns[static_cast<size_t>(motion.joints[j].parent)] = rotation_between(motion.joints[j].offset, {1, 0, 0});
  return with_axes(motion, [&](size_t j) { return turns[j]; });
}
// Under a root that stays at the origin, the body far from it.
inline Motion with_far_root(const Motion& motion, const Point3& away) {
  Motion out = motion;
  for (MotionJoint& joint : out.joints) ++joint.parent;
  out.joints.insert(out.joints.begin(), {"joint_Root", -1, {0, 0, 0}});
  out.joints[1].offset = away;
  for (Clip& clip : out.clips)
    for (MotionFrame& frame : clip.frames) {
      frame.translations[0] = frame.translations[0] + away;
      frame.rotations.insert(frame.rotations.begin(), kNoRotation4);
      frame.translations.insert(frame.translations.begin(), Point3{});
    }
  return out;
}
// At rest as in frame `f`.
inline Motion with_rest_of_frame(const Motion& motion, size_t f) {
  const WorldPose pose = world_pose(motion, motion.clips[0].frames[f]);
  return with_axes(motion, [&](size_t j) { return pose.rotations[j]; });
}
// The same in a world that is turned so; the rest pose turns along.
inline Motion turned_world(const Motion& motion, const Quaternion& turn) {
  Motion out = motion;
  for (MotionJoint& joint : out.joints) joint.offset = rotate(turn, joint.offset);
  for (Clip& clip : out.clips)
    for (MotionFrame& frame : clip.frames) {
      for (Quaternion& q : frame.rotations) q = multiply(turn, multiply(q, conjugate(turn)));
      for (Point3& p : frame.translations) p = rotate(turn, p);
    }
  return out;
}
inline Motion numbered(Motion motion) {
  for (size_t j = 0; j < motion.joints.size(); ++j) motion.joints[j].name = "joint_" + std::to_string(j);
  return motion;
}

}  // namespace sinew
#endif
