// SPDX-License-Identifier: MIT
// By toes, by names, and by what is bent at rest.
#include "motion/limb_bends.hpp"

#include <cmath>

#include "sinew_formats/base/point.hpp"

namespace sinew {

BodyFrame body_frame(const std::vector<Joint>& joints, const UprightBody& body, MaybeAxis up) {
  const auto at = [&](int j) { return point(joints[static_cast<size_t>(j)].position); };
  BodyFrame frame;
  const auto& legs = body.legs;
  const Point3 hips = 0.5 * (at(legs[0].upper) + at(legs[1].upper));
  const Point3 rise = hips - 0.5 * (at(legs[0].end) + at(legs[1].end));
  size_t axis = up ? axis_index(*up) : 3;
  for (size_t i = 0; i < 3 && !up; ++i)
    if (axis == 3 || std::abs(rise[i]) > std::abs(rise[axis])) axis = i;
  frame.up[axis] = rise[axis] < 0 && !up ? -1 : 1;
  Point3 toes{};
  for (const UprightLimb& leg : legs)
    if (leg.tip >= 0) toes = toes + across(at(leg.tip) - at(leg.end), frame.up);
  const Point3 side = across(at(legs[0].upper) - at(legs[1].upper), frame.up);
  const Point3 by_names = cross(side, frame.up);
  const bool toed = length(toes) > 0.1 * length(rise);
  if (body.sided && (!toed || dot(toes, by_names) > 0))
    frame.front = unit(by_names);
  else if (toed)
    frame.front = unit(across(toes, unit(side)));
  frame.left = length(frame.front) > 0 ? cross(frame.up, frame.front) : unit(side);
  frame.middle = hips;
  return frame;
}

std::optional<Point3> bend_side(const Point3& along, const Point3& own, const Point3& front, bool calf) {
  constexpr double kLeastBend = 0.0871557427476582;  // sine of 5 degrees, as sinew_retarget_keep_range() has it
  constexpr double kLeastFront = 0.3;                // of a unit vector: less of it lies across the bone
  const Point3 by_front = across(calf ? -1.0 * front : front, along), by_rest = across(own, along);
  if (length(by_rest) > kLeastBend && (length(by_front) < kLeastFront || dot(by_rest, by_front) > 0)) return by_rest;
  return length(by_front) < kLeastFront ? std::nullopt : std::optional<Point3>(by_front);
}

}  // namespace sinew
