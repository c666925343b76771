// SPDX-License-Identifier: MIT
// Springs as the engine's, with a joint more for every chain's end, frame by frame.
#include "sinew_character/springs/play_springs.hpp"

#include <algorithm>
#include <cmath>

#include "sinew/sinew.hpp"
#include "sinew_formats/error.hpp"

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

class SpringPlayer {
 public:
  SpringPlayer(const Springs& springs, const Motion& motion) : motion_(motion), joints_(rest_joints(motion)) {
    if (springs.chains.empty()) throw Error(motion.name + ": has no chains that swing");
    read(springs);
    sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
    skeleton.positions = positions_.data();
    skeleton.parents = parents_.data();
    skeleton.joint_count = static_cast<uint32_t>(parents_.size());
    sinew_spring_set set = SINEW_INIT(sinew_spring_set);
    set.joint_count = static_cast<uint32_t>(heads_.size());
    set.chain_count = static_cast<uint32_t>(chains_.size());
    set.collider_count = static_cast<uint32_t>(colliders_.size());
    set.chain_collider_count = static_cast<uint32_t>(chain_colliders_.size());
    set.joints = heads_.data();
    set.chains = chains_.data();
    set.colliders = colliders_.data();
    set.chain_colliders = chain_colliders_.data();
    set.hinges = hinges_.data();
    check(springs_.make(skeleton, set));
    rotations_.assign(4 * parents_.size(), 0);
    translations_.assign(3 * parents_.size(), 0);
  }

  SpringPlay play(Clip* clip) {
    SpringPlay out;
    out.joints = turning_.size();
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
      for (const size_t j : turning_) after.push_back(clip->frames.back().rotations[j]);
      out.gap = 0;
      for (size_t i = 0; i < after.size(); ++i) out.gap = std::max(out.gap, angle_between(before[i], after[i]));
      before = after;
      if (out.gap <= kClosed || out.passes == kMostPasses) break;
    }
    for (size_t i = 0; i < turning_.size(); ++i) clip->frames[0].rotations[turning_[i]] = before[i];
    return out;
  }

 private:
  void check(sinew_status status) const {
    if (status != SINEW_OK) throw Error(motion_.name + ": cannot play its springs: " + sinew_status_text(status));
  }

  void add_joint(const Point3& position, int parent) {
    for (const double x : position) positions_.push_back(static_cast<float>(x));
    parents_.push_back(parent);
  }
  static void copy(const Point3& from, float (&to)[3]) {
    for (size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(from[c]);
  }

  void read(const Springs& springs) {
    for (const Joint& joint : joints_) add_joint(point(joint.position), joint.parent);
    for (const SpringCollider& c : springs.colliders) {
      sinew_spring_collider made = {};
      made.joint = static_cast<uint32_t>(c.joint);
      made.shape = c.shape == ColliderShape::kSphere          ? SINEW_COLLIDER_SPHERE
                   : c.shape == ColliderShape::kCapsule       ? SINEW_COLLIDER_CAPSULE
                   : c.shape == ColliderShape::kInsideSphere  ? SINEW_COLLIDER_INSIDE_SPHERE
                   : c.shape == ColliderShape::kInsideCapsule ? SINEW_COLLIDER_INSIDE_CAPSULE
                                                              : SINEW_COLLIDER_PLANE;
      copy(c.offset, made.offset);
      copy(c.tail, made.tail);
      made.radius = static_cast<float>(c.radius);
      colliders_.push_back(made);
    }
    for (const SpringChain& chain : springs.chains) {
      sinew_spring_chain made = {static_cast<uint32_t>(heads_.size()), 0,
                                 static_cast<uint32_t>(chain_colliders_.size()), 0, chain.center};
      for (const SpringJoint& joint : chain.joints) add_head(joint);
      for (size_t i = 0; i < chain.turning_joints(); ++i) turning_.push_back(chain.joints[i].joint);
      if (chain.end) {
        const size_t last = chain.joints.back().joint;
        ends_.push_back(*chain.end);
        add_joint(point(joints_[last].position) + *chain.end, static_cast<int>(last));
        SpringJoint end;
        end.joint = parents_.size() - 1;
        add_head(end);
      }
      made.joint_count = static_cast<uint32_t>(heads_.size()) - made.first_joint;
      for (const size_t group : chain.groups)
        for (const size_t c : springs.groups[group].colliders) chain_colliders_.push_back(static_cast<uint32_t>(c));
      made.collider_count = static_cast<uint32_t>(chain_colliders_.size()) - made.first_collider;
      chains_.push_back(made);
    }
  }
  void add_head(const SpringJoint& joint) {
    sinew_spring_joint made = {};
    made.joint = static_cast<uint32_t>(joint.joint);
    made.hit_radius = static_cast<float>(joint.hit_radius);
    made.stiffness = static_cast<float>(joint.stiffness);
    made.gravity_power = static_cast<float>(joint.gravity_power);
    copy(joint.gravity, made.gravity);
    made.drag = static_cast<float>(joint.drag);
    made.limit = static_cast<float>(joint.limit);
    heads_.push_back(made);
    for (const double x : joint.hinge) hinges_.push_back(static_cast<float>(x));
  }

  // The rotations of the chains' joints in the next frame, after so many rounds of a loop.
  std::vector<Quaternion> frame(const MotionFrame& pose, double rounds, double seconds) {
    const size_t count = joints_.size();
    for (size_t j = 0; j < count; ++j) {
      for (size_t c = 0; c < 4; ++c) rotations_[4 * j + c] = static_cast<float>(pose.rotations[j][c]);
      const Point3 at = travel_.empty() ? pose.translations[j] : pose.translations[j] + rounds * travel_[j];
      for (size_t c = 0; c < 3; ++c) translations_[3 * j + c] = static_cast<float>(at[c]);
    }
    for (size_t e = 0; e < ends_.size(); ++e) {
      for (size_t c = 0; c < 4; ++c) rotations_[4 * (count + e) + c] = c == 3 ? 1.0f : 0.0f;
      for (size_t c = 0; c < 3; ++c) translations_[3 * (count + e) + c] = static_cast<float>(ends_[e][c]);
    }
    check(springs_.frame(static_cast<float>(seconds), rotations_.data(), translations_.data(), rotations_.data()));
    std::vector<Quaternion> out;
    for (const size_t j : turning_) {
      Quaternion q{};
      for (size_t c = 0; c < 4; ++c) q[c] = static_cast<double>(rotations_[4 * j + c]);
      out.push_back(normalised(q));
    }
    return out;
  }

  void run(size_t first, double rounds, double seconds, Clip* clip) {
    for (size_t f = first; f < clip->frames.size(); ++f) {
      const std::vector<Quaternion> turned = frame(clip->frames[f], rounds, seconds);
      for (size_t i = 0; i < turning_.size(); ++i) clip->frames[f].rotations[turning_[i]] = turned[i];
    }
  }

  size_t root() const {
    return static_cast<size_t>(
        std::find_if(joints_.begin(), joints_.end(), [](const Joint& joint) { return joint.parent < 0; }) -
        joints_.begin());
  }

  // Equal poses at both ends; roots, and what hangs on them, such as hips below a joint for the floor, may have moved on.
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

  const Motion& motion_;
  const std::vector<Joint> joints_;
  std::vector<float> positions_;
  std::vector<int32_t> parents_;
  std::vector<sinew_spring_joint> heads_;
  std::vector<float> hinges_;  // [heads x 3]
  std::vector<sinew_spring_chain> chains_;
  std::vector<sinew_spring_collider> colliders_;
  std::vector<uint32_t> chain_colliders_;
  std::vector<Point3> travel_;   // [J] of a loop: how far each round moves a joint on
  std::vector<size_t> turning_;  // joints that the clip gets rotations of
  std::vector<Point3> ends_;     // of chains, behind the motion's joints
  std::vector<float> rotations_, translations_;
  SpringSystem springs_;
};

}  // namespace

SpringPlay play_springs(const Springs& springs, const Motion& motion, Clip* clip) {
  return SpringPlayer(springs, motion).play(clip);
}

}  // namespace sinew
