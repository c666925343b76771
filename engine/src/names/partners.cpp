// SPDX-License-Identifier: MIT
// Partners by names, images by positions.
#include "names/partners.hpp"

#include "core/sort.hpp"

namespace sinew::names {
namespace {

constexpr float kTolerance = 0.005f;  // of the longest side

float at(const NamedJoints& s, int32_t j, uint32_t axis) { return s.positions[3 * j + static_cast<int32_t>(axis)]; }

double square_distance(const NamedJoints& s, int32_t j, const float* point) {
  double sum = 0;
  for (uint32_t axis = 0; axis < 3; ++axis) {
    const double d = static_cast<double>(at(s, j, axis)) - static_cast<double>(point[axis]);
    sum += d * d;
  }
  return sum;
}

float longest_side(const NamedJoints& s) {
  float longest = 0;
  for (uint32_t axis = 0; axis < 3; ++axis) {
    float low = at(s, 0, axis), high = low;
    for (int32_t j = 1; j < s.n; ++j) {
      low = at(s, j, axis) < low ? at(s, j, axis) : low;
      high = at(s, j, axis) > high ? at(s, j, axis) : high;
    }
    longest = high - low > longest ? high - low : longest;
  }
  return longest;
}

void find_images(const NamedJoints& s, const int32_t* partners, double tolerance, float plane, Mirror* mirror) {
  int32_t* const images = mirror->images;
  for (int32_t j = 0; j < s.n; ++j) {
    images[j] = -1;
    float image[3] = {at(s, j, 0), at(s, j, 1), at(s, j, 2)};
    const double off = static_cast<double>(image[mirror->axis]) - static_cast<double>(plane);
    image[mirror->axis] = 2 * plane - image[mirror->axis];
    if (partners[j] >= 0) {
      if (square_distance(s, partners[j], image) <= tolerance * tolerance) images[j] = partners[j];
    } else if ((off < 0 ? -off : off) <= tolerance / 2) {
      images[j] = j;
    } else {
      double least = tolerance * tolerance;
      for (int32_t k = 0; k < s.n; ++k) {
        if (k == j || partners[k] >= 0) continue;
        const double gap = square_distance(s, k, image);
        if (gap > least) continue;
        least = gap;
        images[j] = k;
      }
    }
  }
  // Both must agree: one after the other, in the order of joints.
  mirror->exact = true;
  for (int32_t j = 0; j < s.n; ++j) {
    if (images[j] < 0 || images[images[j]] != j) images[j] = -1;
    if (images[j] < 0) mirror->exact = false;
  }
  for (int32_t j = 0; j < s.n && mirror->exact; ++j) {
    const int32_t p = s.parents[j];
    mirror->exact = (p < 0 ? -1 : images[p]) == s.parents[images[j]];
  }
}

}  // namespace

void find_partners(const NamedJoints& joints, int32_t* partners) {
  for (int32_t j = 0; j < joints.n; ++j) {
    partners[j] = -1;
    const JointName& own = joints.names[j];
    for (int32_t k = 0; k < joints.n && own.side != 0; ++k) {
      const JointName& other = joints.names[k];
      if (other.side != -own.side || other.other_side_key != own.other_side_key) continue;
      partners[j] = k;
      break;
    }
  }
}

float mirror_plane(const NamedJoints& joints, const int32_t* partners, uint32_t axis, float* scratch) {
  size_t count = 0;
  double sum = 0;
  for (int32_t j = 0; j < joints.n; ++j) {
    const float own = at(joints, j, axis);
    sum += static_cast<double>(own);
    if (partners[j] >= 0 && joints.names[j].side > 0)
      scratch[count++] = own + (at(joints, partners[j], axis) - own) / 2;
  }
  if (count == 0) return static_cast<float>(sum / joints.n);
  sort_ascending(scratch, count);
  return scratch[count / 2];
}

void find_mirror(const NamedJoints& joints, const int32_t* partners, const float* planes, int32_t* scratch,
                 Mirror* best) {
  const double tolerance = static_cast<double>(kTolerance * longest_side(joints));
  int64_t most = -1;
  constexpr uint32_t kAxes[3] = {0, 2, 1};
  for (const uint32_t axis : kAxes) {
    Mirror mirror;
    mirror.images = scratch;
    mirror.axis = axis;
    find_images(joints, partners, tolerance, planes[axis], &mirror);
    int64_t found = mirror.exact ? 1 : 0;
    for (int32_t j = 0; j < joints.n; ++j) found += scratch[j] < 0 ? 0 : partners[j] >= 0 ? 4 : 2;
    if (found <= most) continue;
    most = found;
    best->exact = mirror.exact;
    best->axis = axis;
    for (int32_t j = 0; j < joints.n; ++j) best->images[j] = scratch[j];
  }
}

}  // namespace sinew::names
