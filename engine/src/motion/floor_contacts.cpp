// SPDX-License-Identifier: MIT
// Where the source's feet, hands, knees and elbows stand still the target's do, and they are as high over the floor.
#include "motion/floor_contacts.hpp"

#include "motion/body_lift.hpp"

namespace sinew::motion {
namespace {

constexpr double kFloorReach = 0.1;    // share of the source's height up to which the floor is felt
constexpr double kLeastOffset = 1e-5;  // share of the target's height, below which nothing is left of one
constexpr double kBend = 0.2;          // share of the upper arm by which an elbow on no side is on its own
constexpr double kNatural = 0.02;      // and that counts as much as where it is
constexpr double kStretched = 0.9995;  // share of an arm's length that it reaches
constexpr double kMostOffset =
    0.1;  // of the target's height that a standing joint may be from where it was copied, frame by frame
constexpr double kBendFade = 0.95;    // of the elbows' sides, in a frame
constexpr uint32_t kFloorRounds = 3;  // of the body's height and its knees and elbows

}  // namespace

double fade_at(double fps, double share) {
  double rate = kContactFps;
  while (fps >= 2 * rate) {  // twice the frames, the root
    share = share * reciprocal_root(share);
    rate *= 2;
  }
  while (2 * fps <= rate) {
    share *= share;
    rate /= 2;
  }
  return share;
}

bool FloorScene::allocate_floor(Arena& arena, uint32_t target_joints, uint32_t vertices, uint32_t frames) {
  moves = arena.alloc<Vec3d>(size_t{frames} * kMostLimbs);
  smooth = arena.alloc<Vec3d>(frames);
  lifts = arena.alloc<Vec3d>(frames);
  standing = arena.alloc<uint8_t>(frames);
  heights = arena.alloc<double>(frames);
  return floor_patches.allocate(arena, target_joints, vertices, frames);
}

void smooth_over_time(Vec3d* values, uint32_t count, uint32_t stride, uint32_t passes, Vec3d* scratch) {
  for (uint32_t pass = 0; pass < passes; ++pass) {
    for (uint32_t i = 0; i < count; ++i) scratch[i] = values[size_t{stride} * i];
    for (uint32_t i = 1; i + 1 < count; ++i)
      values[size_t{stride} * i] = 0.25 * (scratch[i - 1] + 2.0 * scratch[i] + scratch[i + 1]);
  }
}

FloorContacts::FloorContacts(FloorScene* scene, FloorMemory* memory)
    : s_(*scene), memory_(memory), plan_(*scene->plan), search_(scene) {}

void FloorContacts::run() {
  s_.floor_patches.look(search_.source_floor());
  if (s_.floor_patches.any()) find_bends();
  BodyLift lift(&s_, search_);
  lift.follow_floor();
  for (uint32_t round = 0; round < kFloorRounds && s_.floor_patches.any(); ++round) {
    lift.meet_floor();
    for (uint32_t l = 0; l < s_.limbs.count; ++l)
      hold({l, s_.limbs.limbs[l].middle, middle_patch(l), false, true}, round > 0);
  }
  for (uint32_t l = 0; l < s_.limbs.count; ++l) {
    const Limb& limb = s_.limbs.limbs[l];
    hold({l, limb.leg ? search_.sole_joint(limb) : limb.last, l, limb.leg, false}, false);
    if (!limb.leg) hold({l, limb.last, l, false, false}, true);  // a wrist at its limit has rotated the hand
  }
  if (memory_ != nullptr) memory_->any = true;
}

// Mean side of the elbows while hands are on the floor, in the axes of the arms' parents; of arms that are straight
// all the time as they bend by nature.
void FloorContacts::find_bends() {
  Hinge found[kMostLimbs];
  if (memory_ == nullptr) find_hinges(s_, found);
  const Hinge* const hinges = memory_ == nullptr ? found : memory_->hinges;
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
      bends_[l] = bends_[l] + own * rotate(conjugate(axes_of(limb, plan_)), side);
    }
  }
  for (uint32_t l = 0; l < s_.limbs.count; ++l) {
    if (memory_ != nullptr) bends_[l] = memory_->bends[l] = bends_[l] + kBendFade * memory_->bends[l];
    bends_[l] = unit(bends_[l]);
  }
}

// `again`: a further round of the same frames.
void FloorContacts::hold(const HeldJoint& held, bool again) {
  if (!held.foot && !is_on_floor(held)) return;
  if (memory_ != nullptr) {
    if (!again) find_standing(held);
    lock_next(held, again);
  } else {
    find_standing(held);
    lock(held);
    fade(held.limb);
  }
  for (uint32_t f = 0; f < s_.in->frames; ++f)
    s_.moves[index(f, held.limb)] = s_.moves[index(f, held.limb)] + s_.lifts[f];
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

// In some frame, or between frames.
bool FloorContacts::is_on_floor(const HeldJoint& held) const {
  if (memory_ != nullptr && dot(anchor_of(held).offset, anchor_of(held).offset) > 0) return true;
  for (uint32_t f = 0; f < s_.in->frames; ++f) {
    if (weight(f, held.patch) > 0) return true;
  }
  return false;
}

// Low and slow.
void FloorContacts::find_standing(const HeldJoint& held) {
  const uint32_t source = static_cast<uint32_t>(plan_.map[held.joint]);
  bool first = memory_ == nullptr || !memory_->any;
  Vec3d before = memory_ == nullptr ? Vec3d{0, 0, 0} : anchor_of(held).source;
  for (uint32_t f = 0; f < s_.in->frames; ++f) {
    (void)s_.load_source(f, false);
    const Vec3d position = plan_.source_positions[source];
    const bool low = held.foot ? search_.is_low(s_.limbs.limbs[held.limb]) : weight(f, held.patch) > 0.5;
    s_.standing[f] = low && search_.is_slow(first ? Vec3d{0, 0, 0} : position - before);
    before = position;
    first = false;
  }
  if (memory_ != nullptr) anchor_of(held).source = before;
}

double FloorContacts::rise_of(const HeldJoint& held, uint32_t frame) {
  const double own = weight(frame, held.patch);
  if (!(own > 0)) return 0;
  s_.load(frame);
  return own * s_.floor_patches.rise(frame, held.patch);
}

// The first bone towards the middle's goal; the second one keeps its direction.
void FloorContacts::aim(const Limb& limb, Vec3d move) {
  const Vec3d from = plan_.target_positions[limb.middle] - plan_.target_positions[limb.first];
  swing(limb.first, limb.middle, shortest_arc(from, from + move), &plan_);
}
// The end to its goal, by the second bone alone as far as the middle is on the floor.
void FloorContacts::reach(const HeldJoint& held, Vec3d move, uint32_t frame) {
  const Limb& limb = s_.limbs.limbs[held.limb];
  Vec3d goal = plan_.target_positions[limb.last] + move;
  const double middle = weight(frame, middle_patch(held.limb)), end = held.foot ? 0 : weight(frame, held.patch);
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
    side = side + (end * kBend * upper) * rotate(axes_of(limb, plan_), bends_[held.limb]);
  }
  move_limb(limb, goal, side, &plan_);
}

// As high as the goal, and as near to it as a straight limb comes.
Vec3d FloorContacts::within_reach(const Limb& limb, Vec3d goal) const {
  const Vec3d first = plan_.target_positions[limb.first], middle = plan_.target_positions[limb.middle];
  const double whole = kStretched * (length(middle - first) + length(plan_.target_positions[limb.last] - middle));
  const Vec3d rise = dot(goal - first, plan_.up) * plan_.up, level = goal - first - rise;
  const double square = whole * whole - dot(rise, rise);
  return dot(level, level) > square && square > 0 ? first + rise + root(square) * unit(level) : goal;
}

// smooth: where the joint is over the floor; a hand on it where it was copied, whatever the torso did since, and
// lifts: the path back.
void FloorContacts::find_flat(const HeldJoint& held) {
  for (uint32_t f = 0; f < s_.in->frames; ++f) {
    s_.load(f);
    const Vec3d p = plan_.target_positions[held.joint];
    const Vec3d flat = p - dot(p, plan_.up) * plan_.up;
    const FloorPatch& patch = s_.floor_patches.at(f, held.patch);
    s_.lifts[f] = held.foot || held.middle ? Vec3d{0, 0, 0} : patch.weight * (patch.wrist - flat);
    s_.smooth[f] = flat + s_.lifts[f];
    s_.moves[index(f, held.limb)] = {0, 0, 0};
  }
}

// The next frame alone: where it came to stand it stays, and what was held fades. A stand that the body leaves behind comes along.
void FloorContacts::lock_next(const HeldJoint& held, bool again) {
  FloorMemory::Anchor& anchor = anchor_of(held);
  find_flat(held);
  const Vec3d now = s_.smooth[0];
  Vec3d& move = s_.moves[index(0, held.limb)];
  if (again) {
    if (anchor.is_locked) move = anchor.position - now;
    return;
  }
  const bool stands = s_.standing[0] != 0;
  if (stands) {
    if (!anchor.is_locked) anchor.position = now + anchor.offset;
    const double most = kMostOffset * s_.target.height;
    anchor.offset = anchor.position - now;
    if (length(anchor.offset) > most) anchor.offset = most * unit(anchor.offset);
    anchor.position = now + anchor.offset;
  } else {
    anchor.offset = length(anchor.offset) > kLeastOffset * s_.target.height ? fade_at(s_.in->fps, kFade) * anchor.offset
                                                                            : Vec3d{0, 0, 0};
  }
  anchor.is_locked = stands;
  move = anchor.offset;
}

// In a run of standing frames the joint stays at their mean.
void FloorContacts::lock(const HeldJoint& held) {
  const uint32_t number = held.limb, frames = s_.in->frames;
  find_flat(held);
  for (uint32_t first = 0; first < frames;) {
    uint32_t end = first;
    Vec3d sum = {0, 0, 0};
    for (; end < frames && s_.standing[end] != 0; ++end) sum = sum + s_.smooth[end];
    if (end == first) {
      ++first;
      continue;
    }
    const Vec3d mean = (1.0 / (end - first)) * sum;
    for (; first < end; ++first) s_.moves[index(first, number)] = mean - s_.smooth[first];
  }
}

// Outside of the runs what was held fades, on both sides.
void FloorContacts::fade(uint32_t number) {
  const uint32_t frames = s_.in->frames;
  const double share = fade_at(s_.in->fps, kFade);
  const double least = kLeastOffset * s_.target.height;
  Vec3d held = {0, 0, 0};
  for (uint32_t f = 0; f < frames; ++f) {
    held = s_.standing[f] != 0 ? s_.moves[index(f, number)] : length(held) > least ? share * held : Vec3d{0, 0, 0};
    s_.smooth[f] = s_.standing[f] != 0 ? Vec3d{0, 0, 0} : held;
  }
  held = {0, 0, 0};
  for (uint32_t f = frames; f-- > 0;) {
    held = s_.standing[f] != 0 ? s_.moves[index(f, number)] : length(held) > least ? share * held : Vec3d{0, 0, 0};
    if (s_.standing[f] == 0) s_.smooth[f] = s_.smooth[f] + held;
  }
  for (uint32_t f = 0; f < frames; ++f) {
    if (s_.standing[f] == 0) s_.moves[index(f, number)] = s_.smooth[f];
  }
}

void FloorContacts::reach_floor(const Limb& limb, uint32_t number) {
  const uint32_t frames = s_.in->frames;
  for (uint32_t f = 0; f < frames; ++f) {
    (void)s_.load_source(f, false);
    if (s_.has_source) s_.source.take_pose(plan_.source_rotations, plan_.source_positions);
    s_.load(f);
    s_.target.take_pose(plan_.target_rotations, plan_.target_positions);
    const FootHeights low = search_.lowest(limb, number);
    double felt = 1 - low.source / s_.source_height / kFloorReach;
    felt = s_.standing[f] != 0 || felt > 1 ? 1 : felt < 0 ? 0 : felt;
    // Below a knee on the floor an ankle may be lower than a standing one.
    const double source =
        !s_.has_source && low.source < 0 ? (1 - weight(f, middle_patch(number))) * low.source : low.source;
    s_.heights[f] = felt * (plan_.scale * source - low.target);
  }
}

void FloorContacts::add_heights(uint32_t number) {
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

}  // namespace sinew::motion
