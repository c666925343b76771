// SPDX-License-Identifier: MIT
// Rotations of joints from keypoints alone: from bones and hinges.
#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/keypoint_layouts.hpp"
#include "motion/person.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/keypoints_stream.hpp"
#include "sinew_formats/median.hpp"

namespace sinew {
namespace {

constexpr double kStraight = 0.1, kBent = 0.35;  // sines of a limb's bend: below the first its plane says nothing
constexpr double kHipsStill = 1e-3;              // of the body's size: hips that never leave the origin

// A hinge's limb: its middle joint points to `bend` at rest.
struct HingeOf {
  const char *upper, *lower, *end;
  Point3 bend;
};
constexpr HingeOf kHinges[] = {{"UpperLeg", "LowerLeg", "Foot", {0, 0, 1}},
                               {"UpperArm", "LowerArm", "Hand", {0, 0, -1}}};
// Parts whose rotation follows from two directions: the one from `from` to `to`, exactly, and the one from the joint to `along`.
struct SidedPart {
  const char *joint, *to, *along;
  const char* from = nullptr;  // null: the other side of `to`
};
constexpr SidedPart kSided[] = {{"hips", "leftUpperLeg", "spine"},          {"hips", "leftUpperLeg", "upperChest"},
                                {"upperChest", "leftUpperArm", "neck"},     {"upperChest", "leftUpperArm", "spine"},
                                {"upperChest", "leftUpperArm", "head"},     {"head", "leftEar_end", "nose_end"},
                                {"head", "headTop_end", "nose_end", "head"}};

}  // namespace

// A person's joints that were learned from frames, and frames of it.
class KeypointsSolver {
 public:
  explicit KeypointsSolver(const KeypointsLayout& layout) : columns_(layout) {
    motion_.joints = person_joints(columns_.names);
  }

  // Up, sides, floor and lengths of `rows`, which are the motion's clip from then on.
  void learn(const std::vector<std::vector<Point3>>& rows) {
    for (const std::vector<Point3>& row : rows) keypoints_.push_back(columns_.joints_of(row));
    stand_up();
    fit_lengths();
    fit_sides();
    Clip clip;
    for (const std::vector<Point3>& frame : keypoints_) clip.frames.push_back(frame_of(frame));
    motion_.clips.push_back(std::move(clip));
    keypoints_.clear();
  }

  // One that may not have been among them.
  MotionFrame frame(const std::vector<Point3>& row) const {
    std::vector<Point3> at = columns_.joints_of(row);
    for (Point3& point : at) point = rotate(turn_, point);
    if (mirrored_) mirror(&at);
    if (relative_) lower(&at);
    return frame_of(at);
  }

  Motion& motion() { return motion_; }

 private:
  int index(const std::string& name) const { return joint_named(motion_.joints, name); }
  static Point3 between(const std::vector<Point3>& at, int from, int to) {
    return at[static_cast<size_t>(to)] - at[static_cast<size_t>(from)];
  }

  static void mirror(std::vector<Point3>* at) {
    for (Point3& point : *at) point[2] = -point[2];
  }
  // The lowest joint on the floor.
  static void lower(std::vector<Point3>* at) {
    double low = (*at)[0][1];
    for (const Point3& point : *at) low = std::min(low, point[1]);
    for (Point3& point : *at) point[1] -= low;
  }

  // The mean direction from one joint to another.
  Point3 mean_of(const std::string& from, const std::string& to) const {
    const int a = index(from), b = index(to);
    Point3 sum{};
    if (a >= 0 && b >= 0)
      for (const std::vector<Point3>& frame : keypoints_) sum = sum + unit(between(frame, a, b));
    return sum;
  }

  void stand_up() {
    const Point3 up =
        mean_of("leftFoot", "leftUpperLeg") + mean_of("rightFoot", "rightUpperLeg") + mean_of("hips", "head");
    turn_ = turn_to_y_up(up);
    if (axis_name(up) != "y")
      motion_.notes.push_back("the body is upright along " + axis_name(up) +
                              ", so that axis was taken as up; correct it with --from-up");
    for (std::vector<Point3>& frame : keypoints_)
      for (Point3& point : frame) point = rotate(turn_, point);
    // Toes and noses point to where left, seen with up, has its front.
    double front = 0;
    for (const std::vector<Point3>& frame : keypoints_)
      for (const auto& [from, to] :
           {std::pair("leftFoot", "leftToes"), std::pair("rightFoot", "rightToes"), std::pair("head", "nose_end")}) {
        const int a = index(from), b = index(to), left = index("leftUpperLeg"), right = index("rightUpperLeg");
        if (a >= 0 && b >= 0)
          front += dot(unit(between(frame, a, b)), cross(unit(between(frame, right, left)), {0, 1, 0}));
      }
    mirrored_ = front < 0;
    if (mirrored_) {
      motion_.notes.emplace_back("left and right are exchanged (a left-handed world), so the motion was mirrored");
      for (std::vector<Point3>& frame : keypoints_) mirror(&frame);
    }
    put_on_floor();
  }

  // Keypoints that are relative to the hips say nothing of how high these are: the lowest joint is on the floor.
  void put_on_floor() {
    const size_t hips = static_cast<size_t>(index("hips"));
    double size = 0, moved = 0;
    for (const std::vector<Point3>& frame : keypoints_) {
      for (const Point3& point : frame) size = std::max(size, length(point - frame[hips]));
      moved = std::max(moved, length(frame[hips] - keypoints_[0][hips]));
    }
    relative_ = keypoints_.size() >= 2 && !(moved > kHipsStill * size);
    if (!relative_) return;
    motion_.notes.emplace_back(
        "the hips never move, so keypoints were taken as relative to them, with the lowest joint of each frame on the "
        "floor");
    for (std::vector<Point3>& frame : keypoints_) lower(&frame);
  }

  // Offsets keep their direction and get the length that the bone mostly has.
  void fit_lengths() {
    for (size_t j = 0; j < motion_.joints.size(); ++j) {
      MotionJoint& joint = motion_.joints[j];
      if (joint.parent < 0) continue;
      std::vector<double> lengths;
      for (const std::vector<Point3>& frame : keypoints_)
        lengths.push_back(length(between(frame, joint.parent, static_cast<int>(j))));
      joint.offset = median(&lengths) * unit(joint.offset);
    }
    take_rest();
  }

  // A child of a part that is oriented by its sides has its mean position in that part's axes.
  void fit_sides() {
    std::vector<Point3> offsets(motion_.joints.size());
    for (const std::vector<Point3>& frame : keypoints_) {
      const std::vector<Quaternion> world = rotations_of(frame);
      for (size_t j = 0; j < offsets.size(); ++j) {
        const int parent = motion_.joints[j].parent;
        if (parent >= 0)
          offsets[j] = offsets[j] + rotate(conjugate(world[static_cast<size_t>(parent)]),
                                           between(frame, parent, static_cast<int>(j)));
      }
    }
    for (size_t j = 0; j < offsets.size(); ++j) {
      const int parent = motion_.joints[j].parent;
      if (parent >= 0 && sided_part(static_cast<size_t>(parent)) != nullptr)
        motion_.joints[j].offset = (1 / static_cast<double>(keypoints_.size())) * offsets[j];
    }
    take_rest();
  }

  // Keypoints at rest, the lowest on the floor.
  void take_rest() {
    MotionJoint& hips = motion_.joints[static_cast<size_t>(index("hips"))];
    hips.offset = {};
    hips.offset[1] = -lowest_at_rest(motion_);
    rest_.clear();
    for (const Joint& joint : rest_joints(motion_)) rest_.push_back(point(joint.position));
  }

  // The pair of sides that rotates a joint, if the layout has them; or null.
  const SidedPart* sided_part(size_t j) const {
    for (const SidedPart& part : kSided)
      if (motion_.joints[j].name == part.joint && index(part.to) >= 0 && index(part.along) >= 0) return &part;
    return nullptr;
  }

  std::vector<Quaternion> rotations_of(const std::vector<Point3>& at) const {
    std::vector<Quaternion> world;
    for (size_t j = 0; j < motion_.joints.size(); ++j) {  // layouts list parents first
      const int parent = motion_.joints[j].parent;
      const Quaternion above = parent < 0 ? kNoRotation4 : world[static_cast<size_t>(parent)];
      world.push_back(motion_.joints[j].end ? above : rotation_at(j, above, at));
    }
    return world;
  }

  MotionFrame frame_of(const std::vector<Point3>& at) const {
    const std::vector<Quaternion> world = rotations_of(at);
    MotionFrame frame;
    for (size_t j = 0; j < world.size(); ++j) {
      const MotionJoint& joint = motion_.joints[j];
      const Quaternion above = joint.parent < 0 ? kNoRotation4 : world[static_cast<size_t>(joint.parent)];
      frame.rotations.push_back(normalized(multiply(conjugate(above), world[j])));
      frame.translations.push_back(joint.parent < 0 ? at[j] : joint.offset);
    }
    return frame;
  }

  Quaternion rotation_at(size_t j, const Quaternion& above, const std::vector<Point3>& at) const {
    const std::string& name = motion_.joints[j].name;
    if (const SidedPart* part = sided_part(j)) {
      const int from = index(part->from != nullptr ? part->from : other_side_of_person(part->to)), to = index(part->to);
      const int own = static_cast<int>(j), along = index(part->along);
      return rotation_between(between(rest_, from, to), between(rest_, own, along), between(at, from, to),
                              between(at, own, along));
    }
    const Quaternion straight = swung(j, above, at);
    for (const HingeOf& hinge : kHinges)
      for (const char* side : {"left", "right"}) {
        const std::string upper = side + std::string(hinge.upper), lower = side + std::string(hinge.lower);
        if (name != upper && name != lower) continue;
        const int a = index(upper), b = index(lower), c = index(side + std::string(hinge.end));
        const Point3 first = unit(between(at, a, b)), second = unit(between(at, b, c));
        const double bend = length(cross(first, second));
        const double sure = std::clamp((bend - kStraight) / (kBent - kStraight), 0.0, 1.0);
        if (!(sure > 0)) return straight;
        const Point3 out = across(between(at, a, b), unit(between(at, a, c)));
        const Point3 rest_bone = name == upper ? between(rest_, a, b) : between(rest_, b, c);
        const Quaternion hinged = rotation_between(rest_bone, cross(between(rest_, a, b), hinge.bend),
                                                   name == upper ? first : second, cross(first, out));
        return slerp(straight, hinged, sure * sure * (3 - 2 * sure));
      }
    return straight;
  }

  // Rotates with its parent, then by the shortest rotation to the direction of the bone to its child. A joint without
  // exactly one child follows its parent.
  Quaternion swung(size_t j, const Quaternion& above, const std::vector<Point3>& at) const {
    int child = -1;
    for (size_t c = 0; c < motion_.joints.size(); ++c) {
      if (motion_.joints[c].parent != static_cast<int>(j)) continue;
      if (child >= 0) return above;
      child = static_cast<int>(c);
    }
    if (child < 0) return above;
    const Point3 bone = rotate(above, motion_.joints[static_cast<size_t>(child)].offset);
    return normalized(multiply(rotation_between(bone, between(at, static_cast<int>(j), child)), above));
  }

  LayoutColumns columns_;
  Motion motion_;
  std::vector<std::vector<Point3>> keypoints_;  // [frames][J]
  std::vector<Point3> rest_;
  Quaternion turn_ = kNoRotation4;            // to y up
  bool mirrored_ = false, relative_ = false;  // to the hips
};

Motion motion_of_keypoints(const KeypointsLayout& layout, const std::vector<std::vector<Point3>>& keypoints) {
  KeypointsSolver solver(layout);
  solver.learn(keypoints);
  return std::move(solver.motion());
}

KeypointsStream::KeypointsStream(const std::string& layout, const std::vector<std::vector<Point3>>& first) {
  for (const KeypointsLayout& one : keypoint_layouts())
    if (layout == one.name) layout_ = &one;
  if (layout_ == nullptr)
    throw Error("keypoints: unknown layout '" + layout + "', expected one of " + motion_layouts());
  if (first.empty()) throw Error("keypoints: expected frames of a moving person, a second or two, found none");
  for (const std::vector<Point3>& row : first) check(row);
  solver_ = std::make_unique<KeypointsSolver>(*layout_);
  solver_->learn(first);
  Motion& person = solver_->motion();
  person.name = person.clips[0].name = layout_->name;
  person.clips[0].frame_time = 1 / layout_->fps;
}

KeypointsStream::KeypointsStream(KeypointsStream&&) noexcept = default;
KeypointsStream::~KeypointsStream() = default;

void KeypointsStream::check(const std::vector<Point3>& row) const {
  if (row.size() != layout_->count)
    throw Error("keypoints: expected " + std::to_string(layout_->count) + " keypoints as " + layout_->name +
                " has, found " + std::to_string(row.size()));
  for (size_t i = 0; i < row.size(); ++i)
    if (!std::isfinite(row[i][0] + row[i][1] + row[i][2]))
      throw Error("keypoints: number " + std::to_string(i) + " is not finite");
}

const Motion& KeypointsStream::person() const { return solver_->motion(); }

MotionFrame KeypointsStream::next(const std::vector<Point3>& row) const {
  check(row);
  return solver_->frame(row);
}

}  // namespace sinew
