// SPDX-License-Identifier: MIT
// Where the source's feet, hands, knees and elbows stand still the target's do, and they are as high over the floor.
#include "motion/body_lift.hpp"
#include "motion/foot_search.hpp"
#include "motion/natural_range.hpp"

namespace sinew::motion {
namespace {

constexpr double kFloorReach = 0.1;   // share of the source's height up to which the floor is felt
constexpr double kFade = 0.6;         // of an offset, in a thirtieth of a second
constexpr double kBend = 0.2;         // share of the upper arm by which an elbow on no side is on its own
constexpr double kNatural = 0.02;     // and that counts as much as where it is
constexpr double kStraight = 0.9995;  // share of an arm's length that it reaches
constexpr uint32_t kRounds = 3;       // of the body's height and its knees and elbows

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

// A joint that is held where it stands: the ankle with its foot, the wrist with its hand, a knee or an elbow.
struct Held {
  uint32_t limb = 0;
  uint32_t joint = 0;  // that stays at one place
  uint32_t spot = 0;   // of the body, beside feet
  bool foot = false, middle = false;
};

class FloorContacts {
 public:
  explicit FloorContacts(ContactScene* scene) : s_(*scene), plan_(*scene->plan), search_(scene) {}

  void run() {
    s_.floor_spots.open(&s_, search_.source_floor());
    if (s_.floor_spots.any()) find_bends();
    BodyLift lift(&s_, search_);
    lift.follow_floor();
    for (uint32_t round = 0; round < kRounds && s_.floor_spots.any(); ++round) {
      lift.meet_floor();
      for (uint32_t l = 0; l < s_.limbs.count; ++l) hold({l, s_.limbs.limbs[l].middle, middle_spot(l), false, true});
    }
    for (uint32_t l = 0; l < s_.limbs.count; ++l) {
      const Limb& limb = s_.limbs.limbs[l];
      hold({l, limb.leg ? search_.sole_joint(limb) : limb.last, l, limb.leg, false});
      if (!limb.leg) hold({l, limb.last, l, false, false});  // a wrist at its limit has turned the hand
    }
  }

 private:
  static size_t index(uint32_t frame, uint32_t limb) { return size_t{frame} * kMostLimbs + limb; }
  double weight(uint32_t frame, uint32_t spot) const { return s_.floor_spots.at(frame, spot).weight; }

  // Of what an arm hangs on.
  Quat axes_of(const Limb& limb) const {
    const int32_t above = plan_.target.parents[limb.first];
    return above < 0 ? kNoRotation : plan_.target_rotations[above];
  }
  // To which side elbows are while hands are on the floor, on average, in those axes; of arms that are straight all the time as they
  // bend by nature.
  void find_bends() {
    Hinge hinges[kMostLimbs];
    find_hinges(s_, hinges);
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      bool loaded = false;
      for (uint32_t l = 0; l < s_.limbs.count; ++l) {
        const Limb& limb = s_.limbs.limbs[l];
        const double own = limb.leg ? 0 : weight(f, l);
        if (!(own > 0)) continue;
        if (!loaded) s_.load(f);
        loaded = true;
        const Vec3d first = plan_.target_positions[limb.first], way = plan_.target_positions[limb.middle] - first;
        const Vec3d along = unit(plan_.target_positions[limb.last] - first);
        const Vec3d natural = rotate(plan_.target_rotations[limb.first], hinges[l].side);
        const Vec3d side = way - dot(way, along) * along - (kNatural * length(way)) * natural;
        bends_[l] = bends_[l] + own * rotate(conjugate(axes_of(limb)), side);
      }
    }
    for (Vec3d& bend : bends_) bend = unit(bend);
  }

  void hold(const Held& held) {
    if (held.foot) {
      search_.find_standing(s_.limbs.limbs[held.limb], s_.stands);
    } else if (!find_standing(held)) {
      return;
    }
    lock(held);
    fade(held.limb);
    if (held.foot)
      reach_floor(s_.limbs.limbs[held.limb], held.limb);
    else
      for (uint32_t f = 0; f < s_.in->frames; ++f) s_.heights[f] = rise_of(held, f);
    add_heights(held.limb);
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      const Vec3d move = s_.moves[index(f, held.limb)];
      if (!(dot(move, move) > 0)) continue;
      s_.load(f);
      if (held.middle)
        aim(s_.limbs.limbs[held.limb], move);
      else
        reach(held, move, f);
      s_.store(f);
    }
  }

  // What is no foot stands where it is on the floor and slow. False: never in this clip.
  bool find_standing(const Held& held) {
    bool any = false;
    Vec3d before = {0, 0, 0};
    const uint32_t source = static_cast<uint32_t>(plan_.map[held.joint]);
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      (void)s_.load_source(f, false);
      const Vec3d position = plan_.source_positions[source];
      const double own = weight(f, held.spot);
      s_.stands[f] = own > 0.5 && (f == 0 || search_.is_slow(position - before));
      before = position;
      any = any || own > 0;
    }
    return any;
  }

  double rise_of(const Held& held, uint32_t frame) {
    const double own = weight(frame, held.spot);
    if (!(own > 0)) return 0;
    s_.load(frame);
    return own * s_.floor_spots.rise(frame, held.spot);
  }

  // The first bone towards the middle's goal; the second one keeps its direction.
  void aim(const Limb& limb, Vec3d move) {
    const Vec3d from = plan_.target_positions[limb.middle] - plan_.target_positions[limb.first];
    swing(limb.first, limb.middle, shortest_arc(from, from + move), &plan_);
  }
  // The end to its goal, by the second bone alone as far as the middle is on the floor.
  void reach(const Held& held, Vec3d move, uint32_t frame) {
    const Limb& limb = s_.limbs.limbs[held.limb];
    Vec3d goal = plan_.target_positions[limb.last] + move;
    const double middle = weight(frame, middle_spot(held.limb)), end = held.foot ? 0 : weight(frame, held.spot);
    if (middle > 0) {
      const Vec3d from = plan_.target_positions[limb.last] - plan_.target_positions[limb.middle];
      swing(limb.middle, limb.last, shortest_arc(from, from + middle * move), &plan_);
      const Vec3d now = plan_.target_positions[limb.last];
      goal = now + (1 - middle) * (goal - now);
    }
    Vec3d side = plan_.target_positions[limb.middle];
    // Straight arms bend as elbows do.
    if (end > 0) {
      const double upper = length(side - plan_.target_positions[limb.first]);
      goal = within_reach(limb, goal);
      side = side + (end * kBend * upper) * rotate(axes_of(limb), bends_[held.limb]);
    }
    move_limb(limb, goal, side, &plan_);
  }

  // As high as the goal, and as near to it as a straight limb comes.
  Vec3d within_reach(const Limb& limb, Vec3d goal) const {
    const Vec3d first = plan_.target_positions[limb.first], middle = plan_.target_positions[limb.middle];
    const double whole = kStraight * (length(middle - first) + length(plan_.target_positions[limb.last] - middle));
    const Vec3d rise = dot(goal - first, plan_.up) * plan_.up, level = goal - first - rise;
    const double square = whole * whole - dot(rise, rise);
    return dot(level, level) > square && square > 0 ? first + rise + root(square) * unit(level) : goal;
  }

  // In a run of standing frames the joint stays at their mean.
  void lock(const Held& held) {
    const uint32_t number = held.limb, frames = s_.in->frames;
    for (uint32_t f = 0; f < frames; ++f) {
      s_.load(f);
      const Vec3d p = plan_.target_positions[held.joint];
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
      // Below a knee on the floor an ankle may be lower than a standing one.
      const double source =
          !s_.has_source && low.source < 0 ? (1 - weight(f, middle_spot(number))) * low.source : low.source;
      s_.heights[f] = felt * (plan_.scale * source - low.target);
    }
  }

  void add_heights(uint32_t number) {
    const uint32_t frames = s_.in->frames;
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
  Vec3d bends_[kMostLimbs];  // see find_bends()
};

}  // namespace

void stand_on_floor(ContactScene* scene) { FloorContacts(scene).run(); }

}  // namespace sinew::motion
