// SPDX-License-Identifier: MIT
// Scale, quaternions along the hierarchy, rigid groups and twists of a palette.
#include "deform/posed_joints.hpp"

namespace sinew::deform {
namespace {

constexpr double kLargest = 1e15;         // of an element of a matrix
constexpr double kScaleTolerance = 2e-3;  // of squared lengths, and of cosines between columns
constexpr double kSameScale = 1e-4;       // closer to 1 is 1: matrices of floats
// Joints that rotate by less than a thousandth of a radian against each other, or move by less than a thousandth of a cell, are
// one rigid piece.
constexpr double kSameRotation = 1 - 1.25e-7;
constexpr double kSameMove = 1e-3;
// Twists below some 3 degrees stay where they are; from there to 6 degrees the bone takes more and more.
constexpr double kLeastTwist = 0.026, kFullTwist = 0.052;  // sines of half angles
constexpr uint16_t kTold = 655;                            // weights of less than 1 % strain nothing
// Joints that swing by more than 148 degrees are overturned more and more, by 170 degrees wholly. Those that twist as well are from
// 110 degrees on, and wholly by 150. Cosines of half angles.
constexpr double kBeginSwung = 0.2756, kFullSwung = 0.0872, kBeginMixed = 0.5736, kFullMixed = 0.2588;
// A rotation whose swing is below 20 degrees is a twist, and one whose twist is below 20 a swing; from 50 degrees of
// the other on it is wholly mixed. Sines of half angles.
constexpr double kPure = 0.1736, kMixed = 0.4226;
constexpr double kMostTwistShare = 0.27;

Vec3d column(const double* m, int c) { return {m[c], m[4 + c], m[8 + c]}; }

bool is_number(float x) { return x >= -static_cast<float>(kLargest) && x <= static_cast<float>(kLargest); }

// Whether all matrices are rotations with one scale, which is divided out.
bool divide_scale(PosedJoints* posed) {
  const uint32_t count = posed->rest->joint_count;
  const Vec3d first = column(posed->joints[0].matrix, 0);
  const double square = dot(first, first);
  if (!(square > 1e-20)) return false;
  for (uint32_t j = 0; j < count; ++j) {
    const Vec3d x = column(posed->joints[j].matrix, 0), y = column(posed->joints[j].matrix, 1),
                z = column(posed->joints[j].matrix, 2);
    const double offs[6] = {dot(x, x) - square, dot(y, y) - square, dot(z, z) - square,
                            dot(x, y),          dot(y, z),          dot(z, x)};
    for (const double off : offs) {
      if (off > kScaleTolerance * square || off < -kScaleTolerance * square) return false;
    }
    if (dot(cross(x, y), z) < 0) return false;  // a mirror
  }
  posed->scale = root(square);
  if (posed->scale > 1 - kSameScale && posed->scale < 1 + kSameScale) posed->scale = 1;
  if (posed->scale == 1) return true;
  for (uint32_t j = 0; j < count; ++j) {
    for (double& element : posed->joints[j].matrix) element = element / posed->scale;
  }
  return true;
}

Vec3d image(const double* m, Vec3d p) {
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
          m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

// The group of a joint's parent, if the joint goes with it. A further root may go with the first one.
uint32_t find_group(const PosedJoints& posed, uint32_t j) {
  const RestJoint& joint = posed.rest->skeleton[j];
  if (j == posed.rest->first_joint) return j;
  const uint32_t group =
      posed.joints[joint.parent < 0 ? posed.rest->first_joint : static_cast<uint32_t>(joint.parent)].group;
  const PosedJoint &one = posed.joints[j], &other = posed.joints[group];
  if (dot(one.motion.real, other.motion.real) < kSameRotation) return j;
  const Vec3d apart = image(one.matrix, joint.position) - image(other.matrix, joint.position);
  return dot(apart, apart) > kSameMove * kSameMove * kCellUnits * kCellUnits * posed.rest->unit * posed.rest->unit
             ? j
             : group;
}

// How near to 180 degrees a joint is, where the quaternion that it has changes sides.
double find_overturn(const PosedJoints& posed, uint32_t j) {
  const RestJoint& joint = posed.rest->skeleton[j];
  if (joint.parent < 0) return 0;
  const Quaternion rotation = conjugate(posed.joints[joint.parent].motion.real) * posed.joints[j].motion.real;
  const double along = rotation.x * joint.to_parent.x + rotation.y * joint.to_parent.y + rotation.z * joint.to_parent.z;
  const double upright = rotation.w * rotation.w + along * along;  // squared cosine of half the swing
  const double swing = root(upright < 1 ? 1 - upright : 0);
  const double twist = upright > 1e-9 ? (along < 0 ? -along : along) * reciprocal_root(upright) : 0;
  const double mixed = ramp(twist, kPure, kMixed);
  return ramp(rotation.w, kBeginSwung + mixed * (kBeginMixed - kBeginSwung),
              kFullSwung + mixed * (kFullMixed - kFullSwung)) *
         ramp(swing, kPure, kMixed);
}

// The twist of a joint about the bone that leads to it, given to its parent's bone if that has no other child.
void find_twist(uint32_t j, PosedJoints* posed) {
  const RestJoint& joint = posed->rest->skeleton[j];
  if (joint.parent < 0 || joint.bound == 0) return;
  const RestJoint& above = posed->rest->skeleton[joint.parent];
  if (above.child_count != 1 || joint.parent_length < 1e-3 * posed->rest->size) return;
  PosedJoint& bone = posed->joints[joint.parent];
  const Quaternion rotation = conjugate(bone.motion.real) * posed->joints[j].motion.real;
  const Vec3d axis = -1.0 * joint.to_parent;
  const double along = rotation.x * axis.x + rotation.y * axis.y + rotation.z * axis.z;
  const double square = rotation.w * rotation.w + along * along;
  if (square < 1e-3) return;  // 180 degrees across: the twist is undefined
  const double inverse = reciprocal_root(square);
  double w = rotation.w * inverse, s = along * inverse;
  if (w < 0) {
    w = -w;
    s = -s;
  }
  const double sine = s < 0 ? -s : s;
  if (sine < kLeastTwist) return;
  if (sine < kFullTwist) {  // between nothing and all of it
    const double share = (sine - kLeastTwist) / (kFullTwist - kLeastTwist);
    s = s * share;
    w = root(1 - s * s);
  }
  const double kept = 1 - posed->joints[j].overturned;
  if (kept <= 0) return;
  if (kept < 1) {
    s = s * kept;
    w = root(1 - s * s);
  }
  const Quaternion twist = {w, s * axis.x, s * axis.y, s * axis.z};
  bone.twisted = bone.motion * motion(twist, above.position - rotate(twist, above.position));
  bone.twists = true;
}

}  // namespace

bool PosedJoints::allocate(Arena& arena, const DeformRest& of) {
  rest = &of;
  joints = arena.alloc<PosedJoint>(of.joint_count);
  return arena.ok();
}

sinew_status read_palette(const float* palette, PosedJoints* posed) {
  const DeformRest& rest = *posed->rest;
  for (size_t i = 0; i < static_cast<size_t>(rest.joint_count) * 12; ++i) {
    if (!is_number(palette[i])) return SINEW_ERROR_NOT_FINITE;
  }
  for (uint32_t j = 0; j < rest.joint_count; ++j) {
    for (uint32_t e = 0; e < 12; ++e) {
      posed->joints[j].matrix[e] = static_cast<double>(palette[static_cast<size_t>(j) * 12 + e]);
    }
    posed->joints[j].twists = false;
    posed->joints[j].group = j;
  }
  posed->overturned = false;
  posed->rigid = divide_scale(posed);
  if (!posed->rigid) return SINEW_OK;
  for (uint32_t j = rest.first_joint; j < rest.joint_count; j = rest.skeleton[j].next) {
    PosedJoint& joint = posed->joints[j];
    Quaternion rotation = rotation_quaternion(joint.matrix);
    const int32_t parent = rest.skeleton[j].parent;
    if (parent >= 0 && dot(rotation, posed->joints[parent].motion.real) < 0) rotation = -1.0 * rotation;
    joint.motion = motion(rotation, {joint.matrix[3], joint.matrix[7], joint.matrix[11]});
    joint.group = find_group(*posed, j);
    joint.overturned = find_overturn(*posed, j);
    posed->overturned = posed->overturned || joint.overturned > 0;
    if (rest.options.method == SINEW_DEFORM_VOLUME && (rest.options.without & SINEW_WITHOUT_TWIST_SPREAD) == 0)
      find_twist(j, posed);
  }
  return SINEW_OK;
}

bool bends(const PosedJoints& posed) {
  for (uint32_t j = 0; j < posed.rest->joint_count; ++j) {
    if (posed.joints[j].twists || posed.joints[j].group != posed.joints[posed.rest->first_joint].group) return true;
  }
  return false;
}

bool is_strained(const PosedJoints& posed, const WeightRow& row) {
  const uint32_t group = posed.joints[row.joints[0]].group;
  for (uint32_t s = 0; s < kNodeSlots && row.weights[s] > kTold; ++s) {
    const PosedJoint& joint = posed.joints[row.joints[s]];
    if (joint.group != group || joint.twists) return true;
  }
  return false;
}

double twist_share(const RestJoint& joint, Vec3d position) {
  // The bone leads to the only child.
  double share = dot(position - joint.position, joint.to_children) / joint.bone_length;
  share = share < 0 ? 0 : share > 1 ? 1 : share;
  return kMostTwistShare * share * share * (3 - 2 * share);
}

DualQuaternion blend_motions(const PosedJoints& posed, const uint16_t* joints, const uint16_t* weights, uint32_t n,
                             Vec3d position) {
  DualQuaternion sum = {{0, 0, 0, 0}, {0, 0, 0, 0}};
  uint32_t strongest = 0;
  for (uint32_t i = 0; i < n; ++i) {
    if (weights[i] == 0) continue;
    if (weights[i] > weights[strongest]) strongest = i;
    const PosedJoint& joint = posed.joints[joints[i]];
    if (!joint.twists) {
      add_scaled(&sum, weights[i], joint.motion);
      continue;
    }
    const double share = twist_share(posed.rest->skeleton[joints[i]], position);
    DualQuaternion own = {(1 - share) * joint.motion.real, (1 - share) * joint.motion.dual};
    add_scaled(&own, share, joint.twisted);
    add_scaled(&sum, weights[i] * reciprocal_root(dot(own.real, own.real)), own);
  }
  // Motions that cancel: the strongest alone.
  if (dot(sum.real, sum.real) < 65535.0) {
    return n == 0 || weights[strongest] == 0 ? DualQuaternion{{1, 0, 0, 0}, {0, 0, 0, 0}}
                                             : posed.joints[joints[strongest]].motion;
  }
  return sum;
}

double row_overturn(const PosedJoints& posed, const uint16_t* joints, const uint16_t* weights, uint32_t n) {
  if (!posed.overturned) return 0;
  const RestJoint* const skeleton = posed.rest->skeleton;
  double most = 0;
  for (uint32_t i = 1; i < n; ++i) {
    if (weights[i] <= kTold) continue;
    // From the first joint and this one up to their common ancestor.
    int32_t a = joints[0], b = joints[i];
    while (a != b && a >= 0 && b >= 0) {
      int32_t& below = skeleton[a].rank > skeleton[b].rank ? a : b;
      if (posed.joints[below].overturned > most) most = posed.joints[below].overturned;
      below = skeleton[below].parent;
    }
  }
  return most;
}

Vec3d blend_dual(const PosedJoints& posed, const uint16_t* joints, const uint16_t* weights, uint32_t n, Vec3d p) {
  const Vec3d dual = move(blend_motions(posed, joints, weights, n, p), p);
  const double most = row_overturn(posed, joints, weights, n);
  return most > 0 ? dual + most * (blend_linear(posed, joints, weights, n, p) - dual) : dual;
}

}  // namespace sinew::deform
