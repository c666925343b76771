// SPDX-License-Identifier: MIT
// Where bones point, and the axes that follow from it.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "predict/turn.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

std::optional<AxesPart> part_of(uint8_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_PELVIS:
    case SINEW_CLASS_SPINE:
    case SINEW_CLASS_NECK:
    case SINEW_CLASS_HEAD:
      return AxesPart::kTrunk;
    case SINEW_CLASS_CLAVICLE:
      return AxesPart::kClavicle;
    case SINEW_CLASS_UPPER_ARM:
      return AxesPart::kUpperArm;
    case SINEW_CLASS_FOREARM:
      return AxesPart::kForearm;
    case SINEW_CLASS_HAND:
      return AxesPart::kHand;
    case SINEW_CLASS_THUMB:
      return AxesPart::kThumb;
    case SINEW_CLASS_INDEX:
    case SINEW_CLASS_MIDDLE:
    case SINEW_CLASS_RING:
    case SINEW_CLASS_PINKY:
      return AxesPart::kFinger;
    case SINEW_CLASS_THIGH:
      return AxesPart::kThigh;
    case SINEW_CLASS_CALF:
      return AxesPart::kCalf;
    case SINEW_CLASS_FOOT:
      return AxesPart::kFoot;
    case SINEW_CLASS_TOE:
      return AxesPart::kToe;
    default:
      return std::nullopt;
  }
}

// Classes that may follow a bone of a class, besides its own.
std::vector<uint8_t> next_classes(uint8_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_PELVIS:
      return {SINEW_CLASS_SPINE};
    case SINEW_CLASS_SPINE:
      return {SINEW_CLASS_NECK, SINEW_CLASS_HEAD};
    case SINEW_CLASS_NECK:
      return {SINEW_CLASS_HEAD};
    case SINEW_CLASS_CLAVICLE:
      return {SINEW_CLASS_UPPER_ARM};
    case SINEW_CLASS_UPPER_ARM:
      return {SINEW_CLASS_FOREARM};
    case SINEW_CLASS_FOREARM:
      return {SINEW_CLASS_HAND};
    case SINEW_CLASS_HAND:
      return {SINEW_CLASS_MIDDLE};
    case SINEW_CLASS_HIP:
      return {SINEW_CLASS_THIGH};
    case SINEW_CLASS_THIGH:
      return {SINEW_CLASS_CALF};
    case SINEW_CLASS_CALF:
      return {SINEW_CLASS_FOOT};
    case SINEW_CLASS_FOOT:
      return {SINEW_CLASS_TOE};
    default:
      return {};
  }
}

Point3 direction_of_letter(char letter, int side) {
  switch (letter) {
    case 'L':
      return {1, 0, 0};
    case 'R':
      return {-1, 0, 0};
    case 'U':
      return {0, 1, 0};
    case 'D':
      return {0, -1, 0};
    case 'B':
      return {0, 0, -1};
    case 'O':
      return {side < 0 ? -1.0 : 1.0, 0, 0};
    default:
      return {0, 0, 1};
  }
}

Rotation of_letters(const char* letters) {
  Rotation r{};
  for (size_t c = 0; c < 3; ++c) {
    const Point3 axis = direction_of_letter(letters[c], 0);
    for (size_t row = 0; row < 3; ++row) r[3 * row + c] = axis[row];
  }
  return r;
}

// The shortest rotation; 180 degrees is about the front, for a bone along the front about the upright axis.
Rotation turn_between(const Point3& from, const Point3& to) {
  const Point3 across = cross(from, to);
  const double sine = length(across), cosine = dot(from, to);
  if (sine < 1e-6)
    return cosine > 0
               ? kNoRotation
               : axis_rotation(std::abs(from[2]) < 0.9 ? Point3{0, 0, 1} : Point3{0, 1, 0}, 3.14159265358979323846);
  return axis_rotation((1 / sine) * across, std::atan2(sine, cosine));
}

class Bones {
 public:
  Bones(const std::vector<Joint>& joints, const JointVerdicts& verdicts)
      : joints_(joints), verdicts_(verdicts), children_(JointTree(joints).children) {
    Vec3 low = joints.empty() ? Vec3{} : joints[0].position, high = low;
    for (const Joint& joint : joints) {
      low = {std::min(low.x, joint.position.x), std::min(low.y, joint.position.y), std::min(low.z, joint.position.z)};
      high = {std::max(high.x, joint.position.x), std::max(high.y, joint.position.y),
              std::max(high.z, joint.position.z)};
    }
    least_ = 1e-5 * length(point(high) - point(low));
  }

  // Where the bone of a joint points; nullopt where nothing tells.
  std::optional<Point3> direction(size_t j) const {
    const uint8_t own = verdicts_.classes[j];
    if (!verdicts_.is_end(j)) {
      if (const std::optional<Point3> along = to(next_of(j, own), j)) return along;
      if (own == SINEW_CLASS_HAND)
        if (const std::optional<Point3> amid = amid_fingers(j)) return amid;
      std::vector<size_t> ends;
      for (const size_t child : children_[j])
        if (verdicts_.is_end(child)) ends.push_back(child);
      if (ends.size() == 1)
        if (const std::optional<Point3> along = to(ends[0], j)) return along;
      if (own == SINEW_CLASS_HEAD || own == SINEW_CLASS_PELVIS) return std::nullopt;  // other children are not its bone
      if (children_[j].size() == 1)
        if (const std::optional<Point3> along = to(children_[j][0], j)) return along;
      if (own == SINEW_CLASS_FOOT || own == SINEW_CLASS_TOE) return std::nullopt;
    }
    const int parent = joints_[j].parent;
    return parent < 0 ? std::nullopt
                      : unit_of(point(joints_[j].position) - point(joints_[joint_index(parent)].position));
  }

 private:
  std::optional<Point3> unit_of(const Point3& p) const {
    const double size = length(p);
    return size > least_ ? std::optional<Point3>((1 / size) * p) : std::nullopt;
  }
  std::optional<Point3> to(size_t other, size_t j) const {
    return other == SIZE_MAX ? std::nullopt : unit_of(point(joints_[other].position) - point(joints_[j].position));
  }

  bool is_part(size_t j) const {
    const uint8_t role = verdicts_.roles[j];
    return role == SINEW_ROLE_DEFORMS || role == SINEW_ROLE_FINGER || role == SINEW_ROLE_FACE ||
           role == SINEW_ROLE_ROOT;
  }

  // The nearest joint below of the same class or one that follows it, with twists and helpers passed over. SIZE_MAX: none.
  size_t next_of(size_t j, uint8_t own) const {
    const std::vector<uint8_t> next = next_classes(own);
    std::vector<int> level = children_[j];
    while (!level.empty()) {
      std::vector<int> below;
      for (const bool same : {true, false})
        for (const size_t one : level) {
          const uint8_t other = verdicts_.classes[one];
          if (!is_part(one) || verdicts_.is_end(one)) continue;
          const bool wanted =
              same ? other == own && part_or_tail(own) : std::find(next.begin(), next.end(), other) != next.end();
          if (wanted && (verdicts_.sides[one] == verdicts_.sides[j] || verdicts_.sides[j] == 0)) return one;
        }
      for (const size_t one : level) below.insert(below.end(), children_[one].begin(), children_[one].end());
      level = std::move(below);
    }
    return SIZE_MAX;
  }

  static bool part_or_tail(uint8_t own) {
    return part_of(own).has_value() || own == SINEW_CLASS_TAIL || own == SINEW_CLASS_WING || own == SINEW_CLASS_EAR ||
           own == SINEW_CLASS_HAIR;
  }

  std::optional<Point3> amid_fingers(size_t hand) const {
    Point3 sum{};
    size_t count = 0;
    for (size_t j = 0; j < joints_.size(); ++j) {
      const uint8_t one = verdicts_.classes[j];
      if (one < SINEW_CLASS_INDEX || one > SINEW_CLASS_PINKY || verdicts_.is_end(j)) continue;
      int up = joints_[j].parent;  // the first of a finger, perhaps behind a bone of the palm
      while (up >= 0 && joint_index(up) != hand && verdicts_.classes[joint_index(up)] != one)
        up = joints_[joint_index(up)].parent;
      if (up < 0 || joint_index(up) != hand) continue;
      sum = sum + point(joints_[j].position);
      ++count;
    }
    return count == 0 ? std::nullopt
                      : unit_of((1.0 / static_cast<double>(count)) * sum - point(joints_[hand].position));
  }

  const std::vector<Joint>& joints_;
  const JointVerdicts& verdicts_;
  std::vector<std::vector<int>> children_;
  double least_ = 0;
};

}  // namespace

std::vector<Rotation> joint_axes(const std::vector<Joint>& joints, const AxesTable& table) {
  const JointVerdicts verdicts = joint_verdicts(joints);
  const Bones bones(joints, verdicts);
  Character skeleton;
  skeleton.joints = joints;
  std::vector<Rotation> axes(joints.size(), of_letters(table[0].left));
  std::vector<Point3> directions(joints.size(), {0, 1, 0});
  for (const size_t j : joint_tree(skeleton).parents_first) {
    const int parent = joints[j].parent;
    const uint8_t own = verdicts.classes[j];
    if (parent >= 0) axes[j] = axes[joint_index(parent)], directions[j] = directions[joint_index(parent)];
    if ((parent >= 0 && verdicts.is_end(j)) || own == SINEW_CLASS_EYE || own == SINEW_CLASS_JAW ||
        own == SINEW_CLASS_PROP)
      continue;
    if (verdicts.roles[j] == SINEW_ROLE_ROOT) {  // has no bone: it lies below a body, or within
      axes[j] = of_letters(table[0].left);
      directions[j] = {0, 1, 0};
      continue;
    }
    const std::optional<Point3> found = bones.direction(j);
    const std::optional<AxesPart> part = part_of(own);
    if (!part) {
      if (!found) continue;
      axes[j] = multiply(turn_between(directions[j], *found), axes[j]);
      directions[j] = *found;
      continue;
    }
    const PartAxes& of = table[static_cast<size_t>(*part)];
    const int side = verdicts.sides[j];
    const bool flat = of.bone[0] == 'f';
    const Point3 usual = direction_of_letter(of.bone[0], side);
    directions[j] = found.value_or(usual);
    Point3 wanted = directions[j];
    if (flat) {
      wanted[1] = 0;
      wanted = length(wanted) > 0.1 ? unit(wanted) : usual;
    }
    axes[j] = multiply(turn_between(usual, wanted), of_letters(side < 0 ? of.right : of.left));
  }
  return axes;
}

namespace {

Point3 along_axis(const Point3& p) {
  Point3 out{};
  size_t widest = 0;
  for (size_t a = 1; a < 3; ++a)
    if (std::abs(p[a]) > std::abs(p[widest])) widest = a;
  out[widest] = p[widest] < 0 ? -1 : 1;
  return out;
}

// From the mean of the second to the mean of the first; nullopt where one of the two is empty.
template <class First, class Second>
std::optional<Point3> between(const std::vector<Joint>& joints, const First& first, const Second& second) {
  Point3 sums[2] = {};
  double counts[2] = {};
  for (size_t j = 0; j < joints.size(); ++j)
    for (const size_t k : {size_t{0}, size_t{1}})
      if (k == 0 ? first(j) : second(j)) sums[k] = sums[k] + point(joints[j].position), ++counts[k];
  if (counts[0] == 0 || counts[1] == 0) return std::nullopt;
  return (1 / counts[0]) * sums[0] - (1 / counts[1]) * sums[1];
}

}  // namespace

Rotation body_axes(const std::vector<Joint>& joints) {
  if (joints.empty()) return kNoRotation;
  const JointVerdicts verdicts = joint_verdicts(joints);
  const auto is = [&](uint8_t one) { return [&verdicts, one](size_t j) { return verdicts.classes[j] == one; }; };
  std::optional<Point3> upright = between(joints, is(SINEW_CLASS_THIGH), is(SINEW_CLASS_FOOT));
  if (!upright) upright = between(joints, is(SINEW_CLASS_THIGH), is(SINEW_CLASS_CALF));
  const Point3 up = upright && length(*upright) > 0 ? along_axis(*upright) : Point3{0, 1, 0};
  std::optional<Point3> sides;
  for (const uint8_t one : {SINEW_CLASS_THIGH, SINEW_CLASS_UPPER_ARM, SINEW_CLASS_CLAVICLE, SINEW_CLASS_OTHER}) {
    const bool any = one == SINEW_CLASS_OTHER;
    const auto on = [&](int side) {
      return [&, side](size_t j) { return verdicts.sides[j] == side && (any || verdicts.classes[j] == one); };
    };
    if (!sides) sides = between(joints, on(1), on(-1));
  }
  Point3 left = sides ? *sides - dot(*sides, up) * up : Point3{};
  if (!(length(left) > 0)) return kNoRotation;
  left = along_axis(left);
  const Point3 front = cross(left, up);
  return {left[0], up[0], front[0], left[1], up[1], front[1], left[2], up[2], front[2]};
}

}  // namespace sinew
