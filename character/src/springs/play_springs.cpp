// SPDX-License-Identifier: MIT
// Clips get the rotations of a SpringPlayer; loops are played until they close.
#include "sinew_character/springs/play_springs.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_character/springs/spring_player.hpp"

namespace sinew {
namespace {

constexpr size_t kMostPasses = 8;
constexpr double kClosed = 0.05;     // degrees
constexpr double kSameAngle = 6;     // degrees that a joint's rotations of a loop's ends differ by at most
constexpr double kSamePlace = 0.01;  // of the skeleton's size, the same of translations
constexpr double kSettle = 1;        // seconds in the first pose before a clip that is no loop
constexpr double kDegrees = 57.29577951308232;

double angle_between(const Quaternion& a, const Quaternion& b) {
  return 2 * kDegrees * std::acos(std::min(1.0, std::abs(dot(a, b))));
}

class LoopPlayer {
 public:
  LoopPlayer(const Springs& springs, const Motion& motion) : joints_(rest_joints(motion)), springs_(springs, motion) {}

  SpringPlay play(Clip* clip) {
    SpringPlay out;
    out.joints = springs_.joints().size();
    if (clip->frames.empty()) return out;
    out.loops = is_loop(*clip);
    if (!out.loops) {
      for (double t = 0; t < kSettle; t += clip->frame_time) (void)frame(clip->frames[0], 0, clip->frame_time);
      run(0, 0, clip->frame_time, clip);
      return out;
    }
    // A loop's last frame is its first one again.
    for (size_t j = 0; j < joints_.size(); ++j)
      travel_.push_back(clip->frames.back().translations[j] - clip->frames[0].translations[j]);
    const Clip given = *clip;
    std::vector<Quaternion> before = frame(given.frames[0], 0, clip->frame_time);
    for (out.passes = 1;; ++out.passes) {
      *clip = given;
      run(1, static_cast<double>(out.passes - 1), clip->frame_time, clip);
      std::vector<Quaternion> after;
      for (const size_t j : springs_.joints()) after.push_back(clip->frames.back().rotations[j]);
      out.gap = 0;
      for (size_t i = 0; i < after.size(); ++i) out.gap = std::max(out.gap, angle_between(before[i], after[i]));
      before = after;
      if (out.gap <= kClosed || out.passes == kMostPasses) break;
    }
    for (size_t i = 0; i < before.size(); ++i) clip->frames[0].rotations[springs_.joints()[i]] = before[i];
    return out;
  }

 private:
  // The rotations of the chains' joints in the next frame, after so many rounds of a loop.
  std::vector<Quaternion> frame(MotionFrame pose, double rounds, double seconds) {
    for (size_t j = 0; j < travel_.size(); ++j) pose.translations[j] = pose.translations[j] + rounds * travel_[j];
    springs_.frame(seconds, &pose);
    std::vector<Quaternion> out;
    for (const size_t j : springs_.joints()) out.push_back(pose.rotations[j]);
    return out;
  }

  void run(size_t first, double rounds, double seconds, Clip* clip) {
    for (size_t f = first; f < clip->frames.size(); ++f) {
      const std::vector<Quaternion> turned = frame(clip->frames[f], rounds, seconds);
      for (size_t i = 0; i < turned.size(); ++i) clip->frames[f].rotations[springs_.joints()[i]] = turned[i];
    }
  }

  size_t root() const {
    return static_cast<size_t>(
        std::find_if(joints_.begin(), joints_.end(), [](const Joint& joint) { return joint.parent < 0; }) -
        joints_.begin());
  }

  // Equal poses at both ends; roots and their children, such as hips below a joint for the floor, may have moved on.
  bool is_loop(const Clip& clip) const {
    if (clip.frames.size() < 3) return false;
    const MotionFrame &a = clip.frames[0], &b = clip.frames.back();
    double size = 0;
    for (const Joint& joint : joints_)
      size = std::max(size, length(point(joint.position) - point(joints_[root()].position)));
    for (size_t j = 0; j < joints_.size(); ++j) {
      if (angle_between(a.rotations[j], b.rotations[j]) > kSameAngle) return false;
      const int parent = joints_[j].parent;
      if (parent >= 0 && joints_[static_cast<size_t>(parent)].parent >= 0 &&
          length(a.translations[j] - b.translations[j]) > kSamePlace * size)
        return false;
    }
    return true;
  }

  const std::vector<Joint> joints_;
  SpringPlayer springs_;
  std::vector<Point3> travel_;  // [J] of a loop: how far each round moves a joint on
};

}  // namespace

SpringPlay play_springs(const Springs& springs, const Motion& motion, Clip* clip) {
  return LoopPlayer(springs, motion).play(clip);
}

}  // namespace sinew
