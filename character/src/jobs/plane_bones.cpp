// SPDX-License-Identifier: MIT
// One clip of a body in space becomes one in the picture's plane.
#include <algorithm>
#include <array>
#include <cmath>

#include "sinew/rig.h"
#include "sinew_character/jobs/plane_motion.hpp"

namespace sinew {
namespace {

constexpr double kPi = 3.14159265358979323846;
// The direction in the plane is meaningless for a bone that points to the viewer; from this share of its length on it
// counts in full.
constexpr double kTellingLength = 0.4;

using Direction = std::array<double, 2>;

double wrapped(double angle) { return angle - 2 * kPi * std::round(angle / (2 * kPi)); }

bool is_leg(uint8_t c) { return c >= SINEW_CLASS_HIP && c <= SINEW_CLASS_TOE; }
bool is_arm(uint8_t c) { return c >= SINEW_CLASS_CLAVICLE && c <= SINEW_CLASS_HAND; }

// The child that the joint points to: along the torso, else the one with the longest bone.
std::vector<int> main_children(const Motion& motion, const std::vector<uint8_t>& classes) {
  std::vector<int> out(motion.joints.size(), -1);
  std::vector<double> best(motion.joints.size(), 0);
  for (size_t j = 0; j < motion.joints.size(); ++j) {
    const int parent = motion.joints[j].parent;
    if (parent < 0) continue;
    const Point3& o = motion.joints[j].offset;
    const auto p = static_cast<size_t>(parent);
    const bool along = classes[j] == classes[p] || classes[j] == SINEW_CLASS_SPINE || classes[j] == SINEW_CLASS_NECK ||
                       classes[j] == SINEW_CLASS_HEAD;
    const double score = std::hypot(o[0], o[1]) * (along ? 100 : 1) + 1e-9;
    if (score > best[p]) best[p] = score, out[p] = static_cast<int>(j);
  }
  return out;
}

// Projection of a joint's bone: from the front (x, y), or from the side with the character's forward to the right (z,
// y).
Direction seen(const Point3& d, bool from_side) { return {from_side ? d[2] : d[0], d[1]}; }

Point3 between(const WorldPose& pose, size_t from, size_t to) {
  Point3 d;
  for (size_t k = 0; k < 3; ++k) d[k] = pose.positions[to][k] - pose.positions[from][k];
  return d;
}

class PlaneBones {
 public:
  PlaneBones(const Motion& body, const std::vector<uint8_t>& classes, PictureView view, const Motion& plane)
      : body_(body), plane_(plane), classes_(classes), view_(view), children_(main_children(body, classes)) {
    MotionFrame rest;
    for (const MotionJoint& joint : body.joints) {
      rest.rotations.push_back(kNoRotation4);
      rest.translations.push_back(joint.offset);
    }
    rest_ = world_pose(body, rest);
    rest_floor_ = lowest_foot(rest_);
    for (size_t j = 0; j < plane.joints.size(); ++j) order_.push_back(j);
    std::vector<int> depth(order_.size(), 0);
    for (size_t j = 0; j < order_.size(); ++j)
      for (int p = plane.joints[j].parent; p >= 0; p = plane.joints[static_cast<size_t>(p)].parent) ++depth[j];
    std::stable_sort(order_.begin(), order_.end(), [&](size_t a, size_t b) { return depth[a] < depth[b]; });
  }

  Clip run(const Clip& clip) {
    choose_sides(clip);
    std::vector<double> turns(body_.joints.size(), 0);  // in the plane, against rest
    Clip out = {clip.name, clip.frame_time, {}};
    for (const MotionFrame& frame : clip.frames) {
      const WorldPose pose = world_pose(body_, frame);
      for (const size_t j : order_) turn_joint(pose, j, &turns);
      out.frames.push_back(frame_of(pose, turns));
    }
    return out;
  }

 private:
  // From the front, arms and legs that swing forwards and back do so in the plane.
  void choose_sides(const Clip& clip) {
    from_side_.assign(body_.joints.size(), view_ != PictureView::kFront);
    if (view_ != PictureView::kFront) return;
    std::vector<std::array<double, 4>> sums(body_.joints.size(), std::array<double, 4>{});
    for (const MotionFrame& frame : clip.frames) {
      const WorldPose pose = world_pose(body_, frame);
      for (size_t j = 0; j < sums.size(); ++j) {
        if (children_[j] < 0) continue;
        const Point3 d = between(pose, j, static_cast<size_t>(children_[j]));
        const double l = std::max(1e-9, std::hypot(d[0], d[1], d[2]));
        sums[j][0] += d[0] / l, sums[j][1] += d[0] * d[0] / (l * l);
        sums[j][2] += d[2] / l, sums[j][3] += d[2] * d[2] / (l * l);
      }
    }
    const auto n = static_cast<double>(clip.frames.size());
    for (const size_t j : order_) {
      const int parent = body_.joints[j].parent;
      const bool leg = is_leg(classes_[j]), arm = is_arm(classes_[j]);
      if (parent >= 0 && (leg || arm) &&
          (leg ? is_leg(classes_[static_cast<size_t>(parent)]) : is_arm(classes_[static_cast<size_t>(parent)])) &&
          classes_[static_cast<size_t>(parent)] != SINEW_CLASS_CLAVICLE) {
        from_side_[j] = from_side_[static_cast<size_t>(parent)];  // a limb as a whole
        continue;
      }
      if ((!leg && !arm) || children_[j] < 0) continue;
      const auto varies = [&](size_t k) { return sums[j][k + 1] / n - sums[j][k] * sums[j][k] / (n * n); };
      const Point3 d = between(rest_, j, static_cast<size_t>(children_[j]));
      const bool tells = std::hypot(d[1], d[2]) > 0.6 * std::hypot(d[0], d[1], d[2]);
      from_side_[j] = tells && varies(2) > 2 * varies(0) && varies(2) > 0.005;
    }
  }

  void turn_joint(const WorldPose& pose, size_t j, std::vector<double>* turns) const {
    const int parent = body_.joints[j].parent, child = children_[j];
    double& turn = (*turns)[j];
    const double inherited = parent >= 0 ? (*turns)[static_cast<size_t>(parent)] : 0;
    if (child < 0) {
      turn = inherited;
      return;
    }
    const Point3 d3 = between(pose, j, static_cast<size_t>(child)), r3 = between(rest_, j, static_cast<size_t>(child));
    const Direction d = seen(d3, from_side_[j]), r = seen(r3, from_side_[j]);
    const double length = std::hypot(r3[0], r3[1], r3[2]);
    if (length < 1e-9 || std::hypot(r[0], r[1]) < 0.3 * length) {
      turn = inherited;
      return;
    }
    double angle = wrapped(std::atan2(d[1], d[0]) - std::atan2(r[1], r[0]));
    if (view_ == PictureView::kFacesLeft) angle = -angle;
    const double tells = std::clamp(std::hypot(d[0], d[1]) / (kTellingLength * length), 0.0, 1.0);
    turn += wrapped(angle - turn) * tells * tells;
  }

  // The lowest y of legs' joints and ends; the lowest of all where there are none.
  double lowest_foot(const WorldPose& pose) const {
    double lowest = 1e30, lowest_leg = 1e30;
    for (size_t j = 0; j < pose.positions.size(); ++j) {
      lowest = std::min(lowest, pose.positions[j][1]);
      if (is_leg(classes_[j])) lowest_leg = std::min(lowest_leg, pose.positions[j][1]);
    }
    return lowest_leg < 1e29 ? lowest_leg : lowest;
  }

  MotionFrame frame_of(const WorldPose& pose, const std::vector<double>& turns) const {
    MotionFrame out;
    for (size_t j = 0; j < plane_.joints.size(); ++j) {
      const int parent = plane_.joints[j].parent;
      const double local = turns[j] - (parent >= 0 ? turns[static_cast<size_t>(parent)] : 0);
      out.rotations.push_back({0, 0, std::sin(0.5 * local), std::cos(0.5 * local)});
      out.translations.push_back(plane_.joints[j].offset);
      if (parent >= 0) continue;
      Point3 moved;
      for (size_t k = 0; k < 3; ++k) moved[k] = pose.positions[j][k] - rest_.positions[j][k];
      const Vec3 in_picture =
          to_picture(view_, {static_cast<float>(moved[0]), static_cast<float>(moved[1]), static_cast<float>(moved[2])});
      out.translations.back()[0] += static_cast<double>(in_picture.x);
      out.translations.back()[1] += moved[1];
    }
    bool stands = false;
    for (const uint8_t c : classes_) stands = stands || is_leg(c);
    if (!stands) return out;
    const WorldPose flat = world_pose(plane_, out);
    MotionFrame rest = out;
    for (size_t j = 0; j < rest.rotations.size(); ++j)
      rest.rotations[j] = kNoRotation4, rest.translations[j] = plane_.joints[j].offset;
    const double lift = lowest_foot(pose) - rest_floor_ + lowest_foot(world_pose(plane_, rest)) - lowest_foot(flat);
    for (size_t j = 0; j < plane_.joints.size(); ++j)
      if (plane_.joints[j].parent < 0) out.translations[j][1] += lift;
    return out;
  }

  const Motion &body_, &plane_;
  const std::vector<uint8_t>& classes_;
  PictureView view_;
  std::vector<int> children_;
  std::vector<size_t> order_;  // parents first
  std::vector<uint8_t> from_side_;
  WorldPose rest_;
  double rest_floor_ = 0;
};

}  // namespace

Clip clip_in_plane(const Motion& body, const Clip& clip, const std::vector<uint8_t>& classes, PictureView view,
                   const Motion& plane) {
  return PlaneBones(body, classes, view, plane).run(clip);
}

Clip clip_with_depth(const Motion& body, const Clip& clip, PictureView view, const Motion& plane) {
  const auto turned = [view](double x, double y, double z) {
    return to_picture(view, {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  };
  Clip out = clip;
  for (MotionFrame& frame : out.frames)
    for (size_t j = 0; j < plane.joints.size(); ++j) {
      Quaternion& q = frame.rotations[j];
      const Vec3 axis = turned(q[0], q[1], q[2]);
      q = {static_cast<double>(axis.x), static_cast<double>(axis.y), static_cast<double>(axis.z), q[3]};
      const Point3 &t = frame.translations[j], &rest = body.joints[j].offset;
      const Vec3 moved = turned(t[0] - rest[0], t[1] - rest[1], t[2] - rest[2]);
      frame.translations[j] = plane.joints[j].offset;
      if (plane.joints[j].parent >= 0) continue;
      frame.translations[j][0] += static_cast<double>(moved.x);
      frame.translations[j][1] += static_cast<double>(moved.y);
      frame.translations[j][2] += static_cast<double>(moved.z);
    }
  return out;
}

}  // namespace sinew
