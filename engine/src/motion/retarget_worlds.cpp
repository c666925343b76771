// SPDX-License-Identifier: MIT
// Up by the legs, front by mapped joints at rest, the rest by where legs begin.
#include "motion/retarget_plan.hpp"

namespace sinew::motion {
namespace {

class WorldFinder {
 public:
  WorldFinder(const RetargetOptions& options, sinew_retarget* plan)
      : options_(options), plan_(*plan), source_(plan->source), target_(plan->target) {}

  // Up to up, then the quarter rotate about it after which mapped joints lie nearest to their sources, as seen from their
  // middles, then the remaining rotation.
  void run() {
    plan_.up = up_of(options_.target_up, false);
    const Quat raise = shortest_arc(up_of(options_.source_up, true), plan_.up);
    Vec3d middle_s = {0, 0, 0}, middle_t = {0, 0, 0};
    double mapped = 0;
    for (uint32_t t = 0; t < target_.count; ++t) {
      if (!is_mapped(t)) continue;
      middle_s = middle_s + source_position(t);
      middle_t = middle_t + target_.positions[t];
      mapped += 1;
    }
    middle_s = (1 / mapped) * middle_s;
    middle_t = (1 / mapped) * middle_t;
    constexpr double kHalf = 0.70710678118654752440;  // sine and cosine of 45 degrees
    const double sines[4] = {0, kHalf, 1, -kHalf}, cosines[4] = {1, kHalf, 0, kHalf};
    double best = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Vec3d axis = sines[quarter] * plan_.up;
      const Quat rotation = Quat{axis.x, axis.y, axis.z, cosines[quarter]} * raise;
      double score = 0, size = 0;
      for (uint32_t t = 0; t < target_.count; ++t) {
        if (!is_mapped(t)) continue;
        const Vec3d s = rotate(rotation, source_position(t) - middle_s), own = target_.positions[t] - middle_t;
        score += dot(s, own);
        size += length(s) * length(own);
      }
      if (quarter > 0 && score <= best + 1e-9 * size) continue;
      best = score;
      plan_.rotation = rotation;
    }
    face_front();
  }

 private:
  bool is_mapped(uint32_t t) const { return plan_.map[t] >= 0; }
  Vec3d source_position(uint32_t t) const { return source_.positions[static_cast<uint32_t>(plan_.map[t])]; }

  Vec3d up_of(uint32_t wanted, bool of_source) const {
    if (wanted == SINEW_UP_X) return {1, 0, 0};
    if (wanted == SINEW_UP_Y) return {0, 1, 0};
    if (wanted == SINEW_UP_Z) return {0, 0, 1};
    Vec3d up = {0, 0, 0};
    for (uint32_t i = 0; plan_.has_legs && i < plan_.anchor_count; ++i) {
      const uint32_t top = plan_.anchors[i], end = plan_.floor_joints[i];
      up = up + (of_source ? unit(source_position(top) - source_position(end))
                           : unit(target_.positions[top] - target_.positions[end]));
    }
    // The nearest axis; Y of equals.
    const double x = up.x < 0 ? -up.x : up.x, y = up.y < 0 ? -up.y : up.y, z = up.z < 0 ? -up.z : up.z;
    if (x > y && x > z) return {up.x < 0 ? -1.0 : 1.0, 0, 0};
    if (z > y) return {0, 0, up.z < 0 ? -1.0 : 1.0};
    return {0, up.y < 0 ? -1.0 : 1.0, 0};
  }

  // Rotates about the up axis to align the starts of the legs with the target's, for a file at another heading than
  // multiples of 90 degrees. Legs start at mirrored positions in any pose; up to 3 degrees are measurement noise.
  void face_front() {
    constexpr double kStraight = 0.05;  // tangent below which it is no rotation
    if (!plan_.has_legs) return;
    Vec3d middle_s = {0, 0, 0}, middle_t = {0, 0, 0};
    const double share = 1.0 / plan_.anchor_count;
    for (uint32_t i = 0; i < plan_.anchor_count; ++i) {
      middle_s = middle_s + share * rotate(plan_.rotation, source_position(plan_.anchors[i]));
      middle_t = middle_t + share * target_.positions[plan_.anchors[i]];
    }
    double along = 0, across = 0;
    for (uint32_t i = 0; i < plan_.anchor_count; ++i) {
      const Vec3d from = rotate(plan_.rotation, source_position(plan_.anchors[i])) - middle_s;
      const Vec3d to = target_.positions[plan_.anchors[i]] - middle_t;
      along += dot(from, to) - dot(plan_.up, from) * dot(plan_.up, to);
      across += dot(plan_.up, cross(from, to));
    }
    const double off = across < 0 ? -across : across;
    if (off <= kStraight * along) return;
    const Vec3d side = plan_.up.x > 0.5 || plan_.up.x < -0.5 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    plan_.rotation = shortest_arc(side, along * side + across * cross(plan_.up, side)) * plan_.rotation;
  }

  const RetargetOptions& options_;
  sinew_retarget& plan_;
  const MotionRig& source_;
  const MotionRig& target_;
};

}  // namespace

void find_worlds(const RetargetOptions& options, sinew_retarget* plan) { WorldFinder(options, plan).run(); }

}  // namespace sinew::motion
