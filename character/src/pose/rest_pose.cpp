// SPDX-License-Identifier: MIT
// Directions of bones in the body's own axes, and the rotations that bring a skeleton's bones there.
#include "sinew_character/pose/rest_pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_source.hpp"
#include "predict/limbs.hpp"
#include "predict/turn.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kArmsOfA = 45 * kDegree;   // below the shoulders' line
constexpr double kMostLean = 10 * kDegree;  // of a torso that stays as it is
constexpr double kLean = 50 * kDegree;      // a torso that leans more is no biped's
constexpr double kFootAlong = 0.1;          // a foot's share along the floor below which it has no direction

std::optional<Point3> direction_of(const Point3& p) {
  const double size = length(p);
  return size > 1e-9 ? std::optional<Point3>((1 / size) * p) : std::nullopt;
}

// The shortest rotation of one unit vector onto another; a rotation by 180 degrees is about `axis`.
Rotation turn_between(const Point3& from, const Point3& to, const Point3& axis) {
  const Point3 across = cross(from, to);
  const double sine = length(across), cosine = dot(from, to);
  if (sine < 1e-9) return cosine > 0 ? kNoRotation : axis_rotation(axis, std::numbers::pi);
  return axis_rotation((1 / sine) * across, std::atan2(sine, cosine));
}

// A skeleton with its limbs and its own axes.
struct Body {
  const LabeledSkeleton& skeleton;
  Point3 up = {}, left = {}, front = {};
  Limbs limbs;

  Body(const LabeledSkeleton& s, Axis up_axis, const std::string& whose) : skeleton(s) {
    up[axis_index(up_axis)] = 1;
    const JointVerdicts verdicts = joint_verdicts(s.joints);
    // Where limbs begin, which a pose moves least; else all that has a side.
    std::optional<SideMeans> sides;
    for (const uint8_t one : {SINEW_CLASS_THIGH, SINEW_CLASS_UPPER_ARM})
      add(sides_of(verdicts, [&](size_t j) { return verdicts.classes[j] == one && is_first_of_class(verdicts, j); }),
          &sides);
    if (!sides) add(sides_of(verdicts, [](size_t) { return true; }), &sides);
    const std::optional<Point3> across =
        sides ? direction_of(sides->between - dot(sides->between, up) * up) : std::nullopt;
    if (!across)
      throw Error(whose +
                  ": its joints' names do not tell left from right, so its rest pose is unknown; expected names like "
                  "LeftArm and RightArm");
    left = *across;
    front = cross(left, up);
    middle_ = dot((1 / sides->count) * sides->middle, left);
    const uint32_t depth = 3 - axis_index(up_axis), widest = std::fabs(left[0]) >= std::fabs(left[depth]) ? 0 : depth;
    limbs = find_limbs(s, widest, 0);
  }

  Point3 joint(int j) const { return point(skeleton.joints[joint_index(j)].position); }
  // 1 left, -1 right, of arms and legs; 0 of others.
  int side_of(const Limb& limb) const {
    if (limb.kind != LimbKind::kArm && limb.kind != LimbKind::kLeg) return limb.side;
    double sum = 0;
    for (const int j : limb.joints) sum += dot(joint(j), left) - middle_;
    return sum > 0 ? 1 : -1;
  }
  std::optional<Point3> bone(const Limb& limb, size_t k) const {
    return k + 1 < limb.joints.size() ? direction_of(joint(limb.joints[k + 1]) - joint(limb.joints[k])) : std::nullopt;
  }
  uint8_t class_of(int j) const { return skeleton.classes[joint_index(j)]; }
  // A direction of another body's axes in these.
  Point3 from_axes_of(const Body& other, const Point3& p) const {
    return dot(p, other.left) * left + dot(p, other.up) * up + dot(p, other.front) * front;
  }

 private:
  // From the right to the left, and what lies between; sums of `count` pairs of means.
  struct SideMeans {
    Point3 between = {}, middle = {};
    double count = 1;
  };

  template <class Wanted>
  std::optional<SideMeans> sides_of(const JointVerdicts& verdicts, const Wanted& wanted) const {
    Point3 sums[2] = {};
    double counts[2] = {};
    for (size_t j = 0; j < verdicts.sides.size(); ++j) {
      if (verdicts.sides[j] == 0 || !wanted(j)) continue;
      const size_t side = verdicts.sides[j] > 0 ? 0 : 1;
      sums[side] = sums[side] + point(skeleton.joints[j].position);
      ++counts[side];
    }
    if (counts[0] == 0 || counts[1] == 0) return std::nullopt;
    const Point3 a = (1 / counts[0]) * sums[0], b = (1 / counts[1]) * sums[1];
    return SideMeans{a - b, 0.5 * (a + b), 1};
  }
  bool is_first_of_class(const JointVerdicts& verdicts, size_t j) const {
    const int parent = skeleton.joints[j].parent;
    return parent < 0 || verdicts.classes[joint_index(parent)] != verdicts.classes[j];
  }
  static void add(const std::optional<SideMeans>& one, std::optional<SideMeans>* sum) {
    if (one && *sum)
      **sum = {(*sum)->between + one->between, (*sum)->middle + one->middle, (*sum)->count + 1};
    else if (one)
      *sum = one;
  }

  double middle_ = 0;  // along left
};

// Where a joint's bone shall point, world space; nullopt: it goes with its parent.
struct BoneGoal {
  std::optional<Point3> bone, wanted;
  bool is_foot = false;  // its slope stays
};
using BoneGoals = std::vector<BoneGoal>;  // [J]

void straighten(const Body& body, RestPose::Kind kind, BoneGoals* goals) {
  for (const Limb& limb : body.limbs.limbs) {
    if (limb.kind != LimbKind::kArm && limb.kind != LimbKind::kLeg) continue;
    const Point3 out = body.side_of(limb) * body.left;
    const double lower = kind == RestPose::Kind::kA ? kArmsOfA : 0;
    const Point3 arm = std::cos(lower) * out - std::sin(lower) * body.up;
    for (size_t k = 0; k < limb.joints.size(); ++k) {
      BoneGoal& goal = (*goals)[joint_index(limb.joints[k])];
      goal.bone = body.bone(limb, k);
      switch (body.class_of(limb.joints[k])) {
        case SINEW_CLASS_UPPER_ARM:
        case SINEW_CLASS_FOREARM:
        case SINEW_CLASS_HAND:
          goal.wanted = arm;
          break;
        case SINEW_CLASS_THIGH:
        case SINEW_CLASS_CALF:
          goal.wanted = -1 * body.up;
          break;
        case SINEW_CLASS_FOOT:
          goal.is_foot = true;
          break;
        default:
          break;
      }
    }
  }
}

// From the torso's first joint to its last one below the head; its first joint is `from`.
std::optional<Point3> trunk_line(const Body& body, int* from) {
  for (const Limb& limb : body.limbs.limbs) {
    if (limb.kind != LimbKind::kTrunk) continue;
    size_t last = 0;
    for (size_t k = 0; k < limb.joints.size(); ++k)
      if (body.class_of(limb.joints[k]) <= SINEW_CLASS_NECK && body.skeleton.ends[joint_index(limb.joints[k])] == 0)
        last = k;
    *from = limb.joints[0];
    return last == 0 ? std::nullopt : direction_of(body.joint(limb.joints[last]) - body.joint(limb.joints[0]));
  }
  return std::nullopt;
}

void put_upright(const Body& body, const RestPose& pose, BoneGoals* goals) {
  int from = 0;
  const std::optional<Point3> line = trunk_line(body, &from);
  if (!line) return;
  const double lean = std::acos(std::clamp(dot(*line, body.up), -1.0, 1.0));
  if (lean > kLean)
    throw Error("the pose " + pose.name +
                " needs an upright character, but this torso is not; give a file in the pose you want, or none to keep "
                "the pose");
  if (lean > kMostLean) (*goals)[joint_index(from)] = {line, body.up};
}

// Limbs of a kind and side, the front ones first.
std::vector<const Limb*> limbs_like(const Body& body, LimbKind kind, int side) {
  std::vector<const Limb*> found;
  for (const Limb& limb : body.limbs.limbs)
    if (limb.kind == kind && body.side_of(limb) == side) found.push_back(&limb);
  std::stable_sort(found.begin(), found.end(), [&](const Limb* a, const Limb* b) {
    return dot(body.joint(a->joints.front()), body.front) > dot(body.joint(b->joints.front()), body.front);
  });
  return found;
}

// The bone of `other` that joint k of `limb` is like: of its class, else at the same share of the chain.
size_t like_bone(const Body& body, const Limb& limb, size_t k, const Body& other_body, const Limb& other) {
  const uint8_t wanted = body.class_of(limb.joints[k]);
  size_t before = 0, seen = 0;
  for (size_t i = 0; i < k; ++i) before += body.class_of(limb.joints[i]) == wanted ? 1 : 0;
  for (size_t i = 0; i + 1 < other.joints.size(); ++i)
    if (other_body.class_of(other.joints[i]) == wanted && seen++ == before) return i;
  return std::min(k * other.joints.size() / limb.joints.size(), other.joints.size() - 2);
}

size_t stand_like(const Body& body, const Body& like, BoneGoals* goals) {
  size_t matched = 0;
  for (const Limb& limb : body.limbs.limbs) {
    const std::vector<const Limb*> mine = limbs_like(body, limb.kind, body.side_of(limb));
    const std::vector<const Limb*> others = limbs_like(like, limb.kind, body.side_of(limb));
    const size_t number = static_cast<size_t>(std::find(mine.begin(), mine.end(), &limb) - mine.begin());
    if (limb.kind == LimbKind::kOther || number >= others.size() || mine.size() != others.size()) continue;
    const Limb& other = *others[number];
    if (other.joints.size() < 2) continue;
    ++matched;
    for (size_t k = 0; k + 1 < limb.joints.size(); ++k) {
      const std::optional<Point3> wanted = like.bone(other, like_bone(body, limb, k, like, other));
      if (wanted) (*goals)[joint_index(limb.joints[k])] = {body.bone(limb, k), body.from_axes_of(like, *wanted)};
    }
  }
  return matched;
}

// A foot's bone as its parent left it, rotated about the upright axis to the front.
std::optional<Point3> foot_forward(const Body& body, const Point3& bone) {
  const double high = dot(bone, body.up), along = std::sqrt(std::max(0.0, 1 - high * high));
  if (along < kFootAlong) return std::nullopt;
  return along * body.front + high * body.up;
}

std::vector<Affine> follow(const Body& body, const BoneGoals& goals) {
  const std::vector<Joint>& joints = body.skeleton.joints;
  std::vector<Affine> palette(joints.size(), kIdentity);
  std::vector<Rotation> turns(joints.size(), kNoRotation);
  std::vector<uint8_t> done(joints.size(), 0);
  for (size_t left = joints.size(); left > 0;) {
    for (size_t j = 0; j < joints.size(); ++j) {
      const int parent = joints[j].parent;
      if (done[j] != 0 || (parent >= 0 && done[joint_index(parent)] == 0)) continue;
      done[j] = 1;
      --left;
      const Rotation before = parent < 0 ? kNoRotation : turns[joint_index(parent)];
      const BoneGoal& goal = goals[j];
      Rotation turn = kNoRotation;
      if (goal.bone) {
        const Point3 bone = turned(before, *goal.bone);
        const std::optional<Point3> wanted = goal.is_foot ? foot_forward(body, bone) : goal.wanted;
        if (wanted) turn = turn_between(bone, *wanted, goal.is_foot ? body.up : body.front);
      }
      turns[j] = multiply(turn, before);
      const Point3 rest = point(joints[j].position);
      const Point3 posed = parent < 0 ? rest : transform_point(palette[joint_index(parent)], rest[0], rest[1], rest[2]);
      const Point3 moved = posed - turned(turns[j], rest);
      const Rotation& r = turns[j];
      palette[j] = {r[0], r[1], r[2], moved[0], r[3], r[4], r[5], moved[1], r[6], r[7], r[8], moved[2]};
    }
  }
  return palette;
}

// The transform of a vertex [V]: its joints' rotations, blended, at the position of the deformation.
std::vector<Affine> vertex_matrices(const Character& rest, const std::vector<Affine>& palette, const Character& posed) {
  std::vector<Affine> matrices(rest.vertices.size(), kIdentity);
  for (size_t v = 0; v < matrices.size(); ++v) {
    double sum = 0;
    for (const Influence& one : rest.influences[v]) sum += static_cast<double>(one.weight);
    Affine& m = matrices[v];
    if (sum > 0) {
      m = {};
      for (const Influence& one : rest.influences[v])
        for (size_t k = 0; k < m.size(); ++k) m[k] += static_cast<double>(one.weight) / sum * palette[one.joint][k];
    }
    const Vec3 &from = rest.vertices[v], &to = posed.vertices[v];
    const Point3 blended =
        transform_point(m, static_cast<double>(from.x), static_cast<double>(from.y), static_cast<double>(from.z));
    m[3] += static_cast<double>(to.x) - blended[0];
    m[7] += static_cast<double>(to.y) - blended[1];
    m[11] += static_cast<double>(to.z) - blended[2];
  }
  return matrices;
}

float lowest(const Character& character, Axis up_axis) {
  const auto height = [up_axis](const Vec3& p) { return up_axis == Axis::kY ? p.y : p.z; };
  float low = height(character.vertices.front());
  for (const Vec3& p : character.vertices) low = std::min(low, height(p));
  return low;
}

void turn_corner_normals(const Character& rest, const std::vector<Affine>& matrices, Character* posed) {
  posed->corner_normals = rest.corner_normals;
  for (size_t c = 0; c < posed->corner_normals.size(); ++c) {
    Vec3& normal = posed->corner_normals[c];
    const std::optional<Point3> moved =
        direction_of(transform_normal(matrices[rest.face_vertices[c]], static_cast<double>(normal.x),
                                      static_cast<double>(normal.y), static_cast<double>(normal.z)));
    if (moved)
      normal = {static_cast<float>((*moved)[0]), static_cast<float>((*moved)[1]), static_cast<float>((*moved)[2])};
  }
}

bool has_arms(const Body& body) {
  return std::any_of(body.skeleton.classes.begin(), body.skeleton.classes.end(),
                     [](uint8_t one) { return one == SINEW_CLASS_UPPER_ARM; });
}

}  // namespace

RestPose read_rest_pose(const std::string& text) {
  RestPose pose;
  pose.name = text;
  if (text == "t" || text == "a") {
    pose.kind = text == "t" ? RestPose::Kind::kT : RestPose::Kind::kA;
    return pose;
  }
  pose.kind = RestPose::Kind::kLike;
  pose.like = label_skeleton(read_own_skeleton(text));
  return pose;
}

std::vector<Affine> rest_pose_palette(const LabeledSkeleton& skeleton, const RestPose& pose, Axis up_axis) {
  const Body body(skeleton, up_axis, "the skeleton");
  BoneGoals goals(skeleton.joints.size());
  if (pose.kind == RestPose::Kind::kLike) {
    const Body like(pose.like, up_axis, pose.name);
    if (stand_like(body, like, &goals) == 0)
      throw Error(pose.name + ": none of its limbs matches this skeleton, so it gives no rest pose");
  } else {
    if (!has_arms(body))
      throw Error("the pose " + pose.name +
                  " needs a character with arms, but no joint names one; give a file in the pose you want, or none to "
                  "keep the pose");
    straighten(body, pose.kind, &goals);
    put_upright(body, pose, &goals);
  }
  return follow(body, goals);
}

Character in_rest_pose(const Character& character, const RestPose& pose, Axis up_axis) {
  if (character.vertices.empty()) throw Error(character.name + ": has no mesh to put into a pose");
  std::vector<Affine> palette;
  try {
    palette = rest_pose_palette(label_skeleton(character.joints), pose, up_axis);
  } catch (const Error& error) {
    if (!pose.preferred) throw Error(character.name + ": " + error.what());
    const std::string reason = error.what();
    Character unchanged = character;
    unchanged.notes.push_back("warning: the rest pose is unchanged: " + reason.substr(0, reason.find(';')));
    return unchanged;
  }
  CharacterDeformer deformer(character, SINEW_INIT(sinew_deform_options));
  Character posed = deformer.pose_character(character, palette);
  const float fall = lowest(character, up_axis) - lowest(posed, up_axis);
  const auto height = [up_axis](Vec3& p) -> float& { return up_axis == Axis::kY ? p.y : p.z; };
  for (Vec3& p : posed.vertices) height(p) += fall;
  for (Joint& joint : posed.joints) height(joint.position) += fall;
  const std::vector<Affine> matrices = vertex_matrices(character, palette, posed);
  turn_corner_normals(character, matrices, &posed);
  if (!character.gltf) return posed;
  const bool own = !character.gltf->joint_nodes.empty() && same_joints(character.joints, character.gltf->joints);
  posed.gltf = moved_document(character.name, *character.gltf, matrices, own);
  if (!own) return posed;
  for (Affine& m : palette) m[4 * axis_index(up_axis) + 3] += static_cast<double>(fall);
  posed.gltf = moved_joints(character.name, *posed.gltf, palette, posed.joints);
  return posed;
}

}  // namespace sinew
