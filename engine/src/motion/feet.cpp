// SPDX-License-Identifier: MIT
// Feet: where the source's stand still the target's do, and they are as high over the floor.
#include "motion/contacts.hpp"

namespace sinew {
namespace {

// Shares of the source's height: a foot stands below the one, and moves less than the other in a thirtieth of a second.
constexpr double kContactHeight = 0.02, kContactWay = 0.006;
constexpr double kFloorReach = 0.1;  // up to this height the floor is felt
constexpr double kFade = 0.6;        // of an offset, in a thirtieth of a second
constexpr double kFps = 30;

struct FootHeights {
  double source, target;  // of the lowest point over the floor
};

// kFade to the power of 30 / fps: whole powers and roots of it, which need no libm.
double fade_at(double fps) {
  double fade = kFade, rate = kFps;
  while (fps >= 2 * rate) {  // twice the frames, the root
    fade = fade * reciprocal_root(fade);
    rate *= 2;
  }
  while (2 * fps <= rate) {
    fade *= fade;
    rate /= 2;
  }
  return fade;
}

class Feet {
 public:
  explicit Feet(ContactScene* scene) : s_(*scene), plan_(*scene->plan) {
    target_floor_ = s_.target.lowest;
    // The source's floor is as far below a standing ankle as at rest.
    const double sole =
        s_.has_source ? plan_.source_floor - s_.source.lowest : (plan_.target_floor - target_floor_) / plan_.scale;
    source_floor_ = s_.in->ground - sole;
  }

  sinew_status hold(uint32_t number) {
    const Limb& limb = s_.limbs.limbs[number];
    find_standing(limb);
    lock(limb, number);
    fade(number);
    reach_floor(limb, number);
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      s_.load(f);
      const Vec3d move = s_.moves[index(f, number)];
      move_limb(limb, plan_.target_places[limb.last] + move, &plan_);
      s_.store(f);
    }
    return SINEW_OK;
  }

 private:
  static size_t index(uint32_t frame, uint32_t limb) { return size_t{frame} * kMostLimbs + limb; }
  uint32_t sole_joint(const Limb& limb) const { return limb.toe >= 0 ? static_cast<uint32_t>(limb.toe) : limb.last; }
  uint32_t source_of(uint32_t t) const { return static_cast<uint32_t>(plan_.map[t]); }
  double source_height(uint32_t t) const { return dot(plan_.up, plan_.source_places[source_of(t)]); }
  // As high as the joint is over a standing ankle's height.
  double lift(uint32_t t) const {
    const double rest = dot(plan_.up, rotate(plan_.turn, plan_.source.positions[source_of(t)]));
    return source_height(t) - (rest - plan_.source_floor + s_.in->ground);
  }

  void find_standing(const Limb& limb) {
    const uint32_t toe = sole_joint(limb);
    Vec3d before = {0, 0, 0};
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      (void)s_.load_source(f, false);
      const double a = lift(limb.last), b = lift(toe);
      const Vec3d place = plan_.source_places[source_of(toe)];
      const double way = f == 0 ? 0 : length(place - before) * (s_.in->fps / kFps);
      before = place;
      s_.stands[f] = (a < b ? a : b) < kContactHeight * s_.source_height && way < kContactWay * s_.source_height;
    }
  }

  // In a run of standing frames the toe stays at their mean.
  void lock(const Limb& limb, uint32_t number) {
    const uint32_t toe = sole_joint(limb), frames = s_.in->frames;
    for (uint32_t f = 0; f < frames; ++f) {
      s_.load(f);
      const Vec3d p = plan_.target_places[toe];
      s_.smooth[f] = p - dot(p, plan_.up) * plan_.up;
      s_.moves[index(f, number)] = {0, 0, 0};
    }
    for (uint32_t first = 0; first < frames;) {
      uint32_t end = first;
      Vec3d sum = {0, 0, 0};
      for (; end < frames && s_.stands[end] != 0; ++end) sum = sum + s_.smooth[end];
      if (end == first) {
        ++first;
        continue;
      }
      const Vec3d mean = (1.0 / (end - first)) * sum;
      for (; first < end; ++first) s_.moves[index(first, number)] = mean - s_.smooth[first];
    }
  }

  // Outside of the runs what was held fades, on both sides.
  void fade(uint32_t number) {
    const uint32_t frames = s_.in->frames;
    const double share = fade_at(s_.in->fps);
    const double least = 1e-5 * s_.target.height;
    Vec3d held = {0, 0, 0};
    for (uint32_t f = 0; f < frames; ++f) {
      held = s_.stands[f] != 0 ? s_.moves[index(f, number)] : length(held) > least ? share * held : Vec3d{0, 0, 0};
      s_.smooth[f] = s_.stands[f] != 0 ? Vec3d{0, 0, 0} : held;
    }
    held = {0, 0, 0};
    for (uint32_t f = frames; f-- > 0;) {
      held = s_.stands[f] != 0 ? s_.moves[index(f, number)] : length(held) > least ? share * held : Vec3d{0, 0, 0};
      if (s_.stands[f] == 0) s_.smooth[f] = s_.smooth[f] + held;
    }
    for (uint32_t f = 0; f < frames; ++f) {
      if (s_.stands[f] == 0) s_.moves[index(f, number)] = s_.smooth[f];
    }
  }

  // The lowest point of a foot: vertices of the body, or the joints as far as they are lifted.
  FootHeights lowest(const Limb& limb, uint32_t number) const {
    FootHeights low = {0, 0};
    bool any = false;
    for (uint32_t v = 0; v < s_.body->vertex_count; ++v) {
      if (s_.parts[v] != BodyPart::kFoot || s_.limb_of[v] != number) continue;
      const double own = dot(plan_.up, s_.target.vertices[v]) - target_floor_;
      const double from = s_.has_source ? dot(plan_.up, s_.source.vertices[v]) - source_floor_ : 0;
      if (!any || own < low.target) low.target = own;
      if (!any || from < low.source) low.source = from;
      any = true;
    }
    if (!s_.has_source) {
      const double a = lift(limb.last), b = lift(sole_joint(limb));
      low.source = a < b ? a : b;
    }
    if (!any) low.target = plan_.scale * low.source;  // a foot without a vertex: as it is
    return low;
  }

  void reach_floor(const Limb& limb, uint32_t number) {
    const uint32_t frames = s_.in->frames;
    for (uint32_t f = 0; f < frames; ++f) {
      (void)s_.load_source(f, true);
      s_.load(f);
      s_.target.pose(plan_.target_turns, plan_.target_places);
      const FootHeights low = lowest(limb, number);
      double felt = 1 - low.source / s_.source_height / kFloorReach;
      felt = s_.stands[f] != 0 || felt > 1 ? 1 : felt < 0 ? 0 : felt;
      s_.heights[f] = felt * (plan_.scale * low.source - low.target);
    }
    double before = frames > 0 ? s_.heights[0] : 0;
    for (uint32_t f = 0; f < frames; ++f) {
      const double own = s_.heights[f];
      const bool inside = f > 0 && f + 1 < frames;
      const double rise = inside ? 0.25 * (before + 2 * own + s_.heights[f + 1]) : own;
      before = own;
      s_.moves[index(f, number)] = s_.moves[index(f, number)] + rise * plan_.up;
    }
  }

  ContactScene& s_;
  sinew_retarget& plan_;
  double source_floor_ = 0, target_floor_ = 0;
};

}  // namespace

sinew_status hold_feet(ContactScene* scene) {
  Feet feet(scene);
  for (uint32_t l = 0; l < scene->limbs.count; ++l) {
    if (!scene->limbs.limbs[l].leg) continue;
    const sinew_status status = feet.hold(l);
    if (status != SINEW_OK) return status;
  }
  return SINEW_OK;
}

}  // namespace sinew
