// SPDX-License-Identifier: MIT
// Feet by the positions of ankles and toes, and by the lowest vertices.
#include "motion/foot_search.hpp"

namespace sinew::motion {
namespace {

// Shares of the source's height: a foot stands below the one, and moves less than the other in a thirtieth of a second.
constexpr double kContactHeight = 0.02, kContactDistance = 0.006;

}  // namespace

FootSearch::FootSearch(ClipScene* scene) : s_(*scene) {
  // The source's floor is as far below a standing ankle as at rest.
  const sinew_retarget& plan = *s_.plan;
  const double sole =
      s_.has_source ? plan.source_floor - s_.source.lowest : (plan.target_floor - s_.target.lowest) / plan.scale;
  source_floor_ = s_.in->ground - sole;
}

// As high as the joint is over a standing ankle's height.
double FootSearch::lift(uint32_t t) const {
  const sinew_retarget& plan = *s_.plan;
  const double rest = dot(plan.up, rotate(plan.rotation, plan.source.positions[source_of(t)]));
  return dot(plan.up, plan.source_positions[source_of(t)]) - (rest - plan.source_floor + s_.in->ground);
}

void FootSearch::find_standing(const Limb& limb, uint8_t* standing) {
  const uint32_t toe = sole_joint(limb);
  Vec3d before = {0, 0, 0};
  for (uint32_t f = 0; f < s_.in->frames; ++f) {
    (void)s_.load_source(f, false);
    const Vec3d position = s_.plan->source_positions[source_of(toe)];
    const bool slow = is_slow(f == 0 ? Vec3d{0, 0, 0} : position - before);
    before = position;
    standing[f] = is_low(limb) && slow;
  }
}

bool FootSearch::is_low(const Limb& limb) const { return height(limb) < kContactHeight * s_.source_height; }

bool FootSearch::is_slow(Vec3d way) const {
  return length(way) * (s_.in->fps / kContactFps) < kContactDistance * s_.source_height;
}

FootHeights FootSearch::lowest(const Limb& limb, uint32_t number) const {
  const Vec3d up = s_.plan->up;
  FootHeights low;
  bool any = false;
  for (uint32_t v = 0; v < s_.body->vertex_count; ++v) {
    if (s_.parts[v] != BodyPart::kFoot || s_.limb_of[v] != number) continue;
    const double own = s_.over_floor(s_.target.skinned(v));
    const double from = s_.has_source ? dot(up, s_.source.skinned(v)) - source_floor_ : 0;
    if (!any || own < low.target) low.target = own;
    if (!any || from < low.source) low.source = from;
    any = true;
  }
  if (!s_.has_source) {
    const double a = lift(limb.last), b = lift(sole_joint(limb));
    low.source = a < b ? a : b;
  }
  if (!any) low.target = s_.plan->scale * low.source;  // a foot without a vertex: as it is
  return low;
}

}  // namespace sinew::motion
