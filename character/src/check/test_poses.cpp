// SPDX-License-Identifier: MIT
// The table of test poses, and the axes that joints rotate about.
#include <array>
#include <cmath>

#include "check/rig_facts.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

struct Angle {
  double cosine, sine;
};
constexpr Angle k15 = {0.9659258262890683, 0.25881904510252074}, k30 = {0.8660254037844387, 0.5},
                k45 = {0.7071067811865476, 0.7071067811865476}, k60 = {0.5, 0.8660254037844387}, k90 = {0, 1};

enum class About { kHinge, kSwing, kOutward, kBone };

struct Turn {
  uint8_t joint_class;
  About about;
  Angle angle;
};
struct PoseRow {
  const char* name;
  std::vector<Turn> turns;
};

// Elbows, knees and the others go as far as they do in everyday motions; shoulders and hips less, since linear skinning holds no more.
const std::vector<PoseRow>& rows() {
  static const std::vector<PoseRow> kRows = {
      {"elbows and knees bent by 90 degrees",
       {{SINEW_CLASS_FOREARM, About::kHinge, k90}, {SINEW_CLASS_CALF, About::kHinge, k90}}},
      {"arms and legs swung forward by 60 degrees",
       {{SINEW_CLASS_UPPER_ARM, About::kSwing, k60}, {SINEW_CLASS_THIGH, About::kSwing, k60}}},
      {"arms and legs swung out by 45 degrees",
       {{SINEW_CLASS_UPPER_ARM, About::kOutward, k45}, {SINEW_CLASS_THIGH, About::kOutward, k45}}},
      {"hands and feet bent by 45 degrees, neck and head by 30",
       {{SINEW_CLASS_HAND, About::kSwing, k45},
        {SINEW_CLASS_FOOT, About::kSwing, k45},
        {SINEW_CLASS_NECK, About::kSwing, k15},
        {SINEW_CLASS_HEAD, About::kSwing, k15}}},
      {"wings bent by 45 degrees, tail and ears by 30",
       {{SINEW_CLASS_WING, About::kSwing, k45},
        {SINEW_CLASS_TAIL, About::kSwing, k30},
        {SINEW_CLASS_EAR, About::kSwing, k30}}},
      {"torso bent by 15 degrees per joint", {{SINEW_CLASS_SPINE, About::kSwing, k15}}},
      {"hands, neck and torso twisted",
       {{SINEW_CLASS_HAND, About::kBone, k60},
        {SINEW_CLASS_NECK, About::kBone, k30},
        {SINEW_CLASS_HEAD, About::kBone, k30},
        {SINEW_CLASS_SPINE, About::kBone, k15}}},
  };
  return kRows;
}

class Poser {
 public:
  explicit Poser(const RigFacts& facts) : facts_(facts) {
    side_ = {};
    side_[facts.verdicts.mirror_axis] = 1;
  }

  TestPose pose(const PoseRow& row) const {
    TestPose out;
    out.name = row.name;
    const size_t count = facts_.character.joints.size();
    std::vector<Affine> local(count, kIdentity);
    for (size_t j = 0; j < count; ++j) {
      for (const Turn& turn : row.turns) {
        if (facts_.verdicts.classes[j] != turn.joint_class || !turns(j)) continue;
        const Point3 axis = axis_of(j, turn.about);
        if (!(length(axis) > 0)) continue;
        const Point3 at = position(j);
        local[j] = rotation_about(rotation(axis, turn.angle), {at[0], at[1], at[2]});
        out.joints.push_back(j);
      }
    }
    out.palette.assign(count, kIdentity);
    for (const size_t j : facts_.tree.parents_first) {
      const int parent = facts_.character.joints[j].parent;
      out.palette[j] = parent < 0 ? local[j] : multiply(out.palette[static_cast<size_t>(parent)], local[j]);
    }
    return out;
  }

 private:
  Point3 position(size_t joint) const { return point(facts_.character.joints[joint].position); }

  // The first of its class on its limb, and of a torso or a tail every one; something below it moves the mesh.
  bool turns(size_t joint) const {
    const uint8_t own = facts_.verdicts.classes[joint];
    if (facts_.verdicts.roles[joint] != SINEW_ROLE_DEFORMS) return false;
    if (facts_.moves[joint].empty()) return false;
    if (own == SINEW_CLASS_SPINE || own == SINEW_CLASS_TAIL || own == SINEW_CLASS_NECK) return true;
    for (int up = facts_.character.joints[joint].parent; up >= 0;
         up = facts_.character.joints[static_cast<size_t>(up)].parent)
      if (facts_.verdicts.classes[static_cast<size_t>(up)] == own) return false;
    return true;
  }

  // Along the bone: to its children's middle, of a leaf on from its parent.
  Point3 bone(size_t joint) const {
    Point3 to = {};
    for (const uint32_t child : facts_.tree.children[joint]) to = to + (position(child) - position(joint));
    const int parent = facts_.character.joints[joint].parent;
    if (!(length(to) > 1e-6 * facts_.size) && parent >= 0) to = position(joint) - position(static_cast<size_t>(parent));
    return unit(to);
  }

  // Across the bone and as near to the side as that allows; along the longest other axis where the bone goes sideways.
  Point3 swing(const Point3& along) const {
    Point3 axis = across(side_, along);
    if (length(axis) < 0.5) axis = across(facts_.verdicts.mirror_axis == 1 ? Point3{1, 0, 0} : Point3{0, 1, 0}, along);
    return unit(axis);
  }

  Point3 axis_of(size_t joint, About about) const {
    const Point3 along = bone(joint);
    if (about == About::kBone) return along;
    const Point3 axis = swing(along);
    if (about == About::kSwing) return axis;
    if (about == About::kOutward) return unit(cross(along, axis));
    // As the limb is bent already; a straight one about the swing's axis.
    const int parent = facts_.character.joints[joint].parent;
    const Point3 above = parent < 0 ? Point3{} : unit(position(joint) - position(static_cast<size_t>(parent)));
    const Point3 hinge = cross(above, along);
    return length(hinge) > 0.1 ? unit(hinge) : axis;
  }

  // Rodrigues, as axis_rotation() with a tabled angle.
  static Rotation rotation(const Point3& n, const Angle& angle) {
    const double c = angle.cosine, s = angle.sine, t = 1 - c;
    return {c + t * n[0] * n[0],        t * n[0] * n[1] - s * n[2], t * n[0] * n[2] + s * n[1],
            t * n[0] * n[1] + s * n[2], c + t * n[1] * n[1],        t * n[1] * n[2] - s * n[0],
            t * n[0] * n[2] - s * n[1], t * n[1] * n[2] + s * n[0], c + t * n[2] * n[2]};
  }

  const RigFacts& facts_;
  Point3 side_;
};

}  // namespace

std::vector<TestPose> test_poses(const RigFacts& facts) {
  const Poser poser(facts);
  std::vector<TestPose> poses;
  for (const PoseRow& row : rows()) {
    TestPose pose = poser.pose(row);
    if (!pose.joints.empty()) poses.push_back(std::move(pose));
  }
  return poses;
}

}  // namespace sinew
