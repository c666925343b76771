// SPDX-License-Identifier: MIT
// Rotations as a twist about an axis, then a swing across it, held within sines of half angles.
#include "motion/motion_rig.hpp"
#include "motion/quaternion.hpp"
#include "motion/retarget.hpp"

namespace sinew::motion {
namespace {

constexpr double kHalfDegree = 0.00872664625997165;  // pi / 360

// sin(degrees / 2) of -180..180, by its series: the last term is below the last bit.
double half_sine(float degrees) {
  const double x = kHalfDegree * static_cast<double>(degrees), square = x * x;
  double term = x, sum = x;
  for (int k = 1; k < 13; ++k) {
    term = -term * square / static_cast<double>((2 * k) * (2 * k + 1));
    sum += term;
  }
  return clamped(sum, -1, 1);
}

struct Range {
  double least, most;  // sines of half angles
};

// A limit, checked and in sines.
struct Limit {
  uint32_t joint = 0;
  bool hinge = false;
  Quat zero = kNoRotation;
  Vec3d axis, side, third;
  Range twist = {-1, 1}, about_side = {-1, 1}, about_third = {-1, 1};
};

Vec3d vector_of(const float (&v)[3]) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

bool is_range(float least, float most) { return least >= -180 && most <= 180 && least <= most; }

sinew_status read_limit(const sinew_joint_limit& in, uint32_t joint_count, Limit* out) {
  for (const float x : in.zero)
    if (!is_finite(static_cast<double>(x))) return SINEW_ERROR_NOT_FINITE;
  for (int i = 0; i < 3; ++i) {
    const double all = static_cast<double>(in.axis[i]) + static_cast<double>(in.side[i]) +
                       static_cast<double>(in.least[i]) + static_cast<double>(in.most[i]);
    if (!is_finite(all)) return SINEW_ERROR_NOT_FINITE;
  }
  if (in.joint >= joint_count) return SINEW_ERROR_INDEX;
  if (in.kind != SINEW_LIMIT_HINGE && in.kind != SINEW_LIMIT_BALL) return SINEW_ERROR_ARGUMENT;
  out->joint = in.joint;
  out->hinge = in.kind == SINEW_LIMIT_HINGE;
  out->zero = normalized({static_cast<double>(in.zero[0]), static_cast<double>(in.zero[1]),
                          static_cast<double>(in.zero[2]), static_cast<double>(in.zero[3])});
  out->axis = unit(vector_of(in.axis));
  if (!is_range(in.least[0], in.most[0]) || dot(out->axis, out->axis) == 0) return SINEW_ERROR_ARGUMENT;
  out->twist = {half_sine(in.least[0]), half_sine(in.most[0])};
  if (out->hinge) return SINEW_OK;
  const Vec3d side = vector_of(in.side);
  out->side = unit(side - dot(side, out->axis) * out->axis);
  if (dot(out->side, out->side) == 0) return SINEW_ERROR_ARGUMENT;
  out->third = cross(out->axis, out->side);
  for (int i = 1; i < 3; ++i)
    if (!is_range(in.least[i], in.most[i]) || in.least[i] > 0 || in.most[i] < 0) return SINEW_ERROR_ARGUMENT;
  out->about_side = {half_sine(in.least[1]), half_sine(in.most[1])};
  out->about_third = {half_sine(in.least[2]), half_sine(in.most[2])};
  return SINEW_OK;
}

double half_cosine(double sine) { return root(1 - sine * sine); }

// The sine of half an angle of -180..180, taken to the nearer end of its range where it is out of it: round the circle, not along it.
double held(double sine, const Range& range) {
  if (sine >= range.least && sine <= range.most) return sine;
  const double cosine = half_cosine(sine);
  const double to_least = absolute(sine * range.least + cosine * half_cosine(range.least));
  const double to_most = absolute(sine * range.most + cosine * half_cosine(range.most));
  return to_most >= to_least ? range.most : range.least;
}

Quat about(Vec3d axis, double sine) { return {sine * axis.x, sine * axis.y, sine * axis.z, half_cosine(sine)}; }

// Within the quarter of an ellipse that the ends of both ranges span.
void hold_swing(const Limit& limit, double* a, double* b) {
  const double most_a = *a < 0 ? -limit.about_side.least : limit.about_side.most;
  const double most_b = *b < 0 ? -limit.about_third.least : limit.about_third.most;
  if (!(most_a > 0)) *a = 0;
  if (!(most_b > 0)) *b = 0;
  const double x = most_a > 0 ? *a / most_a : 0, y = most_b > 0 ? *b / most_b : 0, square = x * x + y * y;
  if (!(square > 1)) return;
  *a *= reciprocal_root(square);
  *b *= reciprocal_root(square);
}

// False: it is within the limit.
bool hold(const Limit& limit, Quat* rotation) {
  Quat d = conjugate(limit.zero) * *rotation;
  const Vec3d v = {d.x, d.y, d.z};
  const double along = dot(v, limit.axis);
  Quat twist = normalized({along * limit.axis.x, along * limit.axis.y, along * limit.axis.z, d.w});
  if (twist.w < 0) twist = {-twist.x, -twist.y, -twist.z, -twist.w};
  const double sine = dot(Vec3d{twist.x, twist.y, twist.z}, limit.axis), kept = held(sine, limit.twist);
  if (limit.hinge) {
    *rotation = limit.zero * about(limit.axis, kept);
    return true;
  }
  Quat swing = d * conjugate(twist);
  if (swing.w < 0) swing = {-swing.x, -swing.y, -swing.z, -swing.w};
  const Vec3d s = {swing.x, swing.y, swing.z};
  const double was_a = dot(s, limit.side), was_b = dot(s, limit.third);
  double a = was_a, b = was_b;
  hold_swing(limit, &a, &b);
  if (kept == sine && a == was_a && b == was_b) return false;
  const Vec3d across = a * limit.side + b * limit.third;
  const Quat new_swing = {across.x, across.y, across.z, root(1 - a * a - b * b)};
  *rotation = limit.zero * normalized(new_swing) * about(limit.axis, kept);
  return true;
}

}  // namespace

sinew_status keep_joint_limits(const sinew_joint_limit* limits, uint32_t limit_count, uint32_t joint_count,
                               uint32_t frame_count, float* rotations) {
  Limit limit;
  for (uint32_t i = 0; i < limit_count; ++i) {
    const sinew_status status = read_limit(limits[i], joint_count, &limit);
    if (status != SINEW_OK) return status;
  }
  for (size_t i = 0; i < size_t{4} * joint_count * frame_count; ++i)
    if (!is_finite(static_cast<double>(rotations[i]))) return SINEW_ERROR_NOT_FINITE;
  for (uint32_t i = 0; i < limit_count; ++i) {
    (void)read_limit(limits[i], joint_count, &limit);
    for (uint32_t f = 0; f < frame_count; ++f) {
      float* const at = rotations + 4 * (size_t{f} * joint_count + limit.joint);
      Quat q = normalized({static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]),
                           static_cast<double>(at[3])});
      if (!hold(limit, &q)) continue;
      at[0] = static_cast<float>(q.x);
      at[1] = static_cast<float>(q.y);
      at[2] = static_cast<float>(q.z);
      at[3] = static_cast<float>(q.w);
    }
  }
  return SINEW_OK;
}

}  // namespace sinew::motion
