// SPDX-License-Identifier: MIT
// A stance from a motion: of upright bodies their own frame where they stand most upright, limbs stretched along
// their bones, what is left by its mean rotation; of others their typical pose; then the clips against it.
#include "sinew_character/motion/stance.hpp"

#include <algorithm>

#include "motion/typical_pose.hpp"
#include "motion/upright_body.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr double kStanding = 0.1, kOnFloor = 0.2;  // shares of frames
constexpr double kMirrored =
    0.1;  // of their distance from the middle, how far mirror images of a pose that is one are off
constexpr size_t kFewestPairs = 4;  // of mirror images, that tell left and right apart
constexpr double kBendsAhead = 0.939692620785908, kBendsUp = 0.342020143325669;  // cosine and sine of 20 degrees
// Mean cosine between a foot's upright and the world's while it is low, the least of a foot that stands.
constexpr double kFlat = 0.6;
constexpr double kUpright = 0.7;  // cosine of the most that a standing trunk leans

struct WorldAxes {
  Point3 up, left, front;
};
WorldAxes axes_of(Axis up_axis) {
  const size_t up = axis_index(up_axis);
  WorldAxes axes = {};
  axes.up[up] = 1;
  axes.left[up == 0 ? 1 : 0] = 1;
  axes.front = cross(axes.left, axes.up);
  return axes;
}

std::vector<Point3> positions_of(const std::vector<Joint>& joints) {
  std::vector<Point3> positions;
  for (const Joint& joint : joints)
    positions.push_back({double{joint.position.x}, double{joint.position.y}, double{joint.position.z}});
  return positions;
}

// The clips against a rest pose whose joints are rotated so in the world.
Motion against(const Motion& motion, const std::vector<Quaternion>& turns) {
  Motion out = motion;
  const auto above = [&](size_t j) {
    const int parent = motion.joints[j].parent;
    return parent < 0 ? kNoRotation4 : turns[static_cast<size_t>(parent)];
  };
  for (size_t j = 0; j < out.joints.size(); ++j)
    out.joints[j].offset = out.joints[j].parent < 0 ? Point3{} : rotate(above(j), motion.joints[j].offset);
  for (Clip& clip : out.clips)
    for (MotionFrame& frame : clip.frames)
      for (size_t j = 0; j < out.joints.size(); ++j) {
        frame.rotations[j] = normalized(multiply(above(j), multiply(frame.rotations[j], conjugate(turns[j]))));
        frame.translations[j] = rotate(above(j), frame.translations[j]);
      }
  return out;
}

class StanceFinder {
 public:
  StanceFinder(const Motion& motion, MaybeAxis up)
      : motion_(motion),
        moving_(motion),
        up_(up),
        classes_(joint_verdicts(map_rig_of(motion).joints).classes),
        all_(moving_.best_frames(1, [](size_t) { return 0.0; })) {}

  // Finds the body from the frames, as the rest pose does not show it. Returns false if it is unknown or not upright.
  bool find_body() {
    const MapRig rig = map_rig_of(motion_);
    const std::optional<UprightBody> named = find_upright_body(rig.joints, limb_classes(rig, {}));
    if (named && named->sided) {
      body_ = *named;
      axes_ = axes_of(up_axis());
      return goes_upright();
    }
    const std::vector<std::pair<int, int>> pairs = moving_.mirror_pairs();
    const bool in_line = is_in_one_line(motion_.joints);
    if (pairs.size() < kFewestPairs || (!in_line && asymmetry(pairs, positions_of(rig.joints)) < kMirrored))
      return false;
    for (const Axis up : {Axis::kY, Axis::kZ, Axis::kX})
      if ((!up_ || *up_ == up) && find_seen_body(rig, pairs, up) && goes_upright()) return true;
    return false;
  }

  Motion run() {
    turns_.assign(motion_.joints.size(), kNoRotation4);
    turn_hips();
    for (const size_t j : moving_.order()) turn_joint(static_cast<int>(j));
    return against(motion_, turns_);
  }

 private:
  // Without names: what a typical pose looks like.
  bool find_seen_body(MapRig rig, const std::vector<std::pair<int, int>>& pairs, Axis up) {
    axes_ = axes_of(up);
    const std::vector<Point3> positions = moving_.posed(typical_pose(moving_, pairs, axes_.up));
    for (size_t j = 0; j < positions.size(); ++j)
      rig.joints[j].position = {static_cast<float>(positions[j][0]), static_cast<float>(positions[j][1]),
                                static_cast<float>(positions[j][2])};
    const std::optional<UprightBody> seen = find_upright_body(rig.joints, limb_classes(rig, up));
    if (!seen) return false;
    body_ = *seen;
    if (!body_.sided) find_sides();
    return true;
  }

  bool goes_upright() {
    find_standing_frames();
    double upright = 0;
    for (const size_t f : frames_) upright += dot(unit(moving_.position(f, body_.chest) - leg_roots(f)), axes_.up);
    return upright > kUpright * static_cast<double>(frames_.size());
  }

  const UprightLimb& leg(size_t k) const { return body_.legs[k]; }
  Quaternion& turn(int joint) { return turns_[static_cast<size_t>(joint)]; }
  Point3 leg_roots(size_t f) const {
    return 0.5 * (moving_.position(f, leg(0).upper) + moving_.position(f, leg(1).upper));
  }
  int top() const { return body_.head >= 0 ? body_.head : body_.chest; }

  // From feet to where legs begin in the mean, the nearest axis; a quadruped's head is farther ahead than above.
  Axis up_axis() const {
    if (up_) return *up_;
    Point3 sum{};
    for (size_t f = 0; f < moving_.frame_count(); ++f)
      for (const UprightLimb& limb : body_.legs)
        sum = sum + moving_.position(f, limb.upper) - moving_.position(f, limb.end);
    return sum[2] > std::max(sum[0], sum[1]) ? Axis::kZ : sum[0] > sum[1] ? Axis::kX : Axis::kY;
  }

  // Knees and toes lie ahead, elbows behind, and bodies go ahead.
  void find_sides() {
    double ahead = 0;
    for (size_t f = 0; f < moving_.frame_count(); ++f) {
      const Point3 trunk = moving_.position(f, top()) - leg_roots(f);
      const Point3 side = moving_.position(f, leg(0).upper) - moving_.position(f, leg(1).upper);
      const Point3 front = unit(cross(side, trunk));
      const auto bend = [&](const UprightLimb& limb) {
        const Point3 line = moving_.position(f, limb.end) - moving_.position(f, limb.upper);
        return dot(across(moving_.position(f, limb.middle) - moving_.position(f, limb.upper), unit(line)), front) /
               (length(line) + 1e-12);
      };
      for (const UprightLimb& limb : body_.legs) {
        ahead += bend(limb);
        if (limb.tip < 0) continue;
        const Point3 toes = moving_.position(f, limb.tip) - moving_.position(f, limb.end);
        ahead += 0.3 * dot(unit(toes), front);
      }
      for (const UprightLimb& limb : body_.arms)
        if (body_.has_arms) ahead -= 0.5 * bend(limb);
    }
    if (ahead < 0) std::swap(body_.legs[0], body_.legs[1]);
    double same = 0;
    for (size_t f = 0; f < moving_.frame_count() && body_.has_arms; ++f)
      same += dot(moving_.position(f, body_.arms[0].upper) - moving_.position(f, body_.arms[1].upper),
                  moving_.position(f, leg(0).upper) - moving_.position(f, leg(1).upper));
    if (same < 0) std::swap(body_.arms[0], body_.arms[1]);
  }

  // Legs stretched below the body, the head above it.
  void find_standing_frames() {
    frames_ = moving_.best_frames(kStanding, [&](size_t f) {
      double value = dot(unit(moving_.position(f, top()) - leg_roots(f)), axes_.up);
      for (const UprightLimb& limb : body_.legs) {
        const Point3 from = moving_.position(f, limb.upper), knee = moving_.position(f, limb.middle),
                     to = moving_.position(f, limb.end);
        value += dot(from - to, axes_.up) / (length(knee - from) + length(to - knee) + 1e-12);
      }
      return value;
    });
  }

  void turn_hips() {
    const Point3 side = moving_.mean_difference(frames_, body_.hips, leg(1).upper, leg(0).upper);
    const Point3 up = moving_.mean_direction(frames_, body_.hips, axes_.up);
    turn(body_.hips) = rotation_between(side, up, axes_.left, axes_.up);
  }

  void turn_joint(int joint) {
    const int parent = moving_.parent(joint);
    if (joint == body_.hips) return;
    if (!is_below(joint, body_.hips)) {  // what carries the body, and what lies beside it
      const Quaternion mean = moving_.is_still(joint)
                                  ? moving_.rotation(0, joint)
                                  : multiply(turn(body_.hips), moving_.mean_rotation(frames_, body_.hips, joint));
      turn(joint) = mean;
      return;
    }
    // Arms and heads do what they like while legs stand: over the whole clip they are straighter.
    const std::vector<size_t>& frames = is_below(joint, body_.chest) ? all_ : frames_;
    turn(joint) = multiply(turn(parent), moving_.mean_rotation(frames, parent, joint));
    if (joint == body_.chest && body_.has_arms) {
      const Point3 side = moving_.mean_difference(frames_, joint, body_.arms[1].upper, body_.arms[0].upper);
      const int next = next_in_trunk(joint);
      if (next >= 0)
        turn(joint) = rotation_between(side, moving_.offset(next), axes_.left, axes_.up);
      else
        swing(joint, side, axes_.left);
    } else if (const int next = next_in_trunk(joint); next >= 0) {
      // A dancer or runner leans in many frames, but a standing pose does not lean below the chest.
      const Point3 bone = moving_.offset(next);
      const bool below_chest = is_below(body_.chest, joint);
      swing(joint, bone, below_chest ? axes_.up : across(rotate(turn(joint), bone), axes_.left));
    }
    for (size_t k = 0; k < 2; ++k) {
      const double sign = k == 0 ? 1 : -1;
      stretch(joint, leg(k), -1.0 * axes_.up);
      if (joint == leg(k).end) stand(joint, leg(k));
      if (!body_.has_arms) continue;
      stretch(joint, body_.arms[k], sign * axes_.left);
      roll_arm(joint, body_.arms[k], sign * axes_.left);
      if (joint != body_.arms[k].end && is_below(joint, body_.arms[k].end)) lay_finger(joint, sign * axes_.left);
    }
  }

  // At rest fingers lie along the arm, thumbs halfway to the front: what hands do in a motion, curled mostly, does not say it. A hand's own
  // mean says more than that it is straight.
  void lay_finger(int joint, const Point3& along) {
    for (size_t j = 0; j < motion_.joints.size(); ++j) {
      const int child = static_cast<int>(j);
      if (moving_.parent(child) != joint || !(length(moving_.offset(child)) > 0)) continue;
      const bool thumb = classes_[static_cast<size_t>(joint)] == SINEW_CLASS_THUMB;
      swing(joint, moving_.offset(child), thumb ? unit(along + axes_.front) : along);
      return;
    }
  }

  bool is_below(int joint, int above) const {
    while (joint >= 0 && joint != above) joint = moving_.parent(joint);
    return joint >= 0;
  }

  // The next joint from a torso's joint up to the head, at a different position.
  int next_in_trunk(int joint) const {
    int at = top();
    if (!is_below(at, joint) || at == joint) return -1;
    while (moving_.parent(at) != joint) at = moving_.parent(at);
    return length(moving_.offset(at)) > 0 ? at : -1;
  }

  // Turns a joint so that what lies along `own` in its axes lies along `wanted` in the world.
  void swing(int joint, const Point3& own, const Point3& wanted) {
    turn(joint) = multiply(rotation_between(rotate(turn(joint), own), wanted), turn(joint));
  }

  void stretch(int joint, const UprightLimb& limb, const Point3& along) {
    const auto bone = [&](int from, int to) {
      if (joint == from && to >= 0) swing(joint, moving_.mean_difference(frames_, joint, from, to), along);
    };
    bone(limb.upper, limb.middle);
    bone(limb.middle, limb.end);
  }

  // Elbows are hinges: stretched aside with the palm down, they would bend to the front and up:
  // by 30 degrees and more of CMU, by none of Mixamo (20 motions of eight makers). Upper arm and forearm both know how their elbow does.
  void roll_arm(int joint, const UprightLimb& arm, const Point3& along) {
    if (joint != arm.upper && joint != arm.middle) return;
    Point3 axis{};
    double bent = 0;
    for (const size_t f : all_) {
      const Point3 elbow = moving_.position(f, arm.middle);
      const Point3 bend =
          cross(unit(elbow - moving_.position(f, arm.upper)), unit(moving_.position(f, arm.end) - elbow));
      axis = axis + rotate(conjugate(moving_.rotation(f, joint)), bend);
      bent += length(bend);
    }
    constexpr double kLeastBend = 0.1, kOneWay = 0.7;  // mean sine; how far all bends are one
    if (bent < kLeastBend * static_cast<double>(all_.size()) || length(axis) < kOneWay * bent) return;
    const Point3 bone = joint == arm.upper ? moving_.mean_difference(all_, joint, arm.upper, arm.middle)
                                           : moving_.mean_difference(all_, joint, arm.middle, arm.end);
    const Point3 fore = kBendsAhead * axes_.front + kBendsUp * axes_.up;
    turn(joint) = rotation_between(bone, axis, along, cross(along, fore));
  }

  // Flat, as where it is lowest, and ahead.
  void stand(int foot, const UprightLimb& limb) {
    if (limb.tip < 0) return;
    const std::vector<size_t> low =
        moving_.best_frames(kOnFloor, [&](size_t f) { return -dot(moving_.position(f, foot), axes_.up); });
    const Point3 toes = moving_.mean_difference(low, foot, foot, limb.tip);
    const Point3 up = moving_.mean_direction(low, foot, axes_.up);
    double same = 0;
    for (const size_t f : low) same += dot(rotate(moving_.rotation(f, foot), up), axes_.up);
    if (same < kFlat * static_cast<double>(low.size()))  // on tiptoe, or upside down: only where toes are is known
      swing(foot, toes, axes_.front);
    else
      turn(foot) = rotation_between(up, toes, axes_.up, axes_.front);
  }

  const Motion& motion_;
  const MovingJoints moving_;
  const MaybeAxis up_;
  const std::vector<uint8_t> classes_;  // [J] sinew_joint_class by names
  UprightBody body_;
  WorldAxes axes_ = {};
  const std::vector<size_t> all_;
  std::vector<size_t> frames_;     // in which it stands
  std::vector<Quaternion> turns_;  // [J] from the old rest pose to the stance, in the world
};

// Left and right by names, else joints that lie as mirror images do.
MirrorPairs mirror_pairs_of(const MovingJoints& moving, const JointVerdicts& verdicts) {
  MirrorPairs pairs;
  for (const size_t j : moving.order())
    if (verdicts.sides[j] > 0 && verdicts.partners[j] >= 0)
      pairs.emplace_back(static_cast<int>(j), verdicts.partners[j]);
  return pairs.size() < kFewestPairs ? moving.mirror_pairs() : pairs;
}

// For quadrupeds and birds: their typical pose, if their rest pose is in one line or, by names of sides,
// no mirror image of itself.
std::optional<Motion> in_typical_pose(const Motion& motion, MaybeAxis up) {
  const MovingJoints moving(motion);
  const std::vector<Joint> rest = rest_joints(motion);
  const JointVerdicts verdicts = joint_verdicts(rest);
  const MirrorPairs pairs = mirror_pairs_of(moving, verdicts);
  if (pairs.size() < kFewestPairs) return std::nullopt;
  const bool named = verdicts.partners[static_cast<size_t>(pairs[0].first)] == pairs[0].second;
  if (!is_in_one_line(motion.joints) && !(named && asymmetry(pairs, positions_of(rest)) > kMirrored))
    return std::nullopt;
  return against(motion, typical_pose(moving, pairs, axes_of(up.value_or(Axis::kY)).up));
}

}  // namespace

std::optional<Motion> standing_motion(const Motion& motion, MaybeAxis up) {
  if (motion.rest_stands || motion.clips.empty() || motion.joints.empty()) return std::nullopt;
  const MapRig rig = map_rig_of(motion);
  const std::optional<UprightBody> body = find_upright_body(rig.joints, limb_classes(rig, {}));
  if (body && is_upright(*body, positions_of(rig.joints))) return std::nullopt;
  StanceFinder finder(motion, up);
  return finder.find_body() ? finder.run() : in_typical_pose(motion, up);
}

}  // namespace sinew
