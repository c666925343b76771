// SPDX-License-Identifier: MIT
// Feet: where the source's stand still the target's do, and they are as high over the floor.
#include "motion/contacts.hpp"
#include "motion/foot_search.hpp"

namespace sinew::motion {
namespace {

constexpr double kFloorReach = 0.1;  // share of the source's height up to which the floor is felt
constexpr double kFade = 0.6;        // of an offset, in a thirtieth of a second

// kFade to the power of 30 / fps: whole powers and roots of it, which need no libm.
double fade_at(double fps) {
  double fade = kFade, rate = kContactFps;
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
  explicit Feet(ContactScene* scene) : s_(*scene), plan_(*scene->plan), search_(scene) {}

  void hold(uint32_t number) {
    const Limb& limb = s_.limbs.limbs[number];
    search_.find_standing(limb, s_.stands);
    lock(limb, number);
    fade(number);
    reach_floor(limb, number);
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      const Vec3d move = s_.moves[index(f, number)];
      if (!(dot(move, move) > 0)) continue;
      s_.load(f);
      move_limb(limb, plan_.target_positions[limb.last] + move, plan_.target_positions[limb.middle], &plan_);
      s_.store(f);
    }
  }

 private:
  static size_t index(uint32_t frame, uint32_t limb) { return size_t{frame} * kMostLimbs + limb; }

  // In a run of standing frames the toe stays at their mean.
  void lock(const Limb& limb, uint32_t number) {
    const uint32_t toe = search_.sole_joint(limb), frames = s_.in->frames;
    for (uint32_t f = 0; f < frames; ++f) {
      s_.load(f);
      const Vec3d p = plan_.target_positions[toe];
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

  void reach_floor(const Limb& limb, uint32_t number) {
    const uint32_t frames = s_.in->frames;
    for (uint32_t f = 0; f < frames; ++f) {
      (void)s_.load_source(f, false);
      if (s_.has_source) s_.source.take_pose(plan_.source_rotations, plan_.source_positions);
      s_.load(f);
      s_.target.take_pose(plan_.target_rotations, plan_.target_positions);
      const FootHeights low = search_.lowest(limb, number);
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
  FootSearch search_;
};

}  // namespace

void hold_feet(ContactScene* scene) {
  Feet feet(scene);
  for (uint32_t l = 0; l < scene->limbs.count; ++l) {
    if (scene->limbs.limbs[l].leg) feet.hold(l);
  }
}

}  // namespace sinew::motion
