// SPDX-License-Identifier: MIT
// Hands and forearms against the body: a hand near a spot of the source's surface goes to the same spot of the target's,
// and what would be deeper inside of it than the source's is comes out. Without a source's body what is deeper than at rest, each arm
// along one direction that changes little over time: its side must not depend on single triangles.
#include "motion/contacts.hpp"

namespace sinew::motion {
namespace {

constexpr double kSpread = 0.02;  // of the weights of near triangles
constexpr uint32_t kHandRounds = 3, kRoundsWithoutBody = 8, kRoundsOfFrame = 2;
constexpr uint32_t kArmOfFrame = 192;  // vertices of hand and forearm that are tested in a single frame
constexpr double kBlur = 0.12;         // share of the height, of the body that an arm is to leave
constexpr uint32_t kWayPasses = 32;    // of smoothing directions over frames
// The share of pushes and their directions that remains after a thirtieth of a second if no body moves the source.
constexpr double kPushFade = 0.9, kWayFade = 0.8;
constexpr double kLeastMove = 1e-5;  // share of the height, below which nothing is left of a move
constexpr double kSteepest = 0.5;    // cosine between a direction and a surface that lies across it
constexpr double kElbow = 0.4;       // share of a forearm that moves little with its hand
constexpr double kNoHelp =
    0.8;  // share of its depth that is left after a round that did not help: elbows do not move with hands
constexpr uint32_t kSourceEnd = 400, kWhole = 1000;  // permille

// About exp(-x^2 / 2): a power of a fraction needs no libm.
double bell(double x) {
  const double d = 1 + x * x * (1.0 / 16);
  const double d2 = d * d, d4 = d2 * d2;
  return 1 / (d4 * d4);
}

class Hands {
 public:
  // With a memory the clip is the next frame alone, and nothing is smoothed.
  Hands(ContactScene* scene, HandMemory* memory)
      : s_(*scene), memory_(memory), plan_(*scene->plan), search_(scene->search) {
    ratio_ = s_.has_source && s_.source.height > 0 ? s_.target.height / s_.source.height : 1;
  }

  sinew_status run() {
    const Progress& progress = s_.in->progress;
    if (!s_.has_source) look_at_rest_pose();
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      if (s_.has_source) look_at_source(f);
      if (!progress.report(kFeetEnd + static_cast<uint32_t>(uint64_t{f} * (kSourceEnd - kFeetEnd) / s_.in->frames)))
        return SINEW_ERROR_CANCELLED;
    }
    const uint32_t rounds = s_.has_source ? kHandRounds : kRoundsWithoutBody;
    for (uint32_t round = 0; round < rounds; ++round) {
      touch();
      find_depths(round == 0);
      push_out(round == 0);
      bool any = false;
      for (uint32_t f = 0; f < s_.in->frames; ++f) any = move(f) || any;
      if (!progress.report(kSourceEnd + (round + 1) * (kWhole - kSourceEnd) / rounds)) return SINEW_ERROR_CANCELLED;
      if (!any) break;
    }
    return SINEW_OK;
  }

  void open() {
    if (s_.has_source) return;
    s_.search_target_at_rest();
    for (uint32_t a = 0; a < search_.count(); ++a)
      memory_->rest_depths[a] = search_.deepest(&s_.target_tree, a, {0, 0, 0}, 0).depth;
  }

  // Touch once: what a push out of the body takes from it is not given back, or arms would tremble between the two.
  void next() {
    if (s_.has_source) look_at_source(0);
    for (uint32_t a = 0; a < search_.count() && !s_.has_source; ++a) {
      contact(0, a) = HandContact();
      contact(0, a).depth = memory_->rest_depths[a];
    }
    s_.load(0);
    for (uint32_t a = 0; a < search_.count(); ++a) axes_[a] = axes_of(s_.limbs.limbs[search_.limb(a)], plan_);
    touch();
    const double fade = memory_->any ? fade_at(s_.in->fps, kFade) : 0;
    const double push_fade = s_.has_source ? fade : fade_at(s_.in->fps, kPushFade);
    memory_->any = true;
    for (uint32_t a = 0; a < search_.count(); ++a) {
      keep(a, fade, 1 - fade, &s_.moves[index(0, a)], &memory_->touches[a]);
      s_.moves[index(0, kMostArms + a)] = {0, 0, 0};
      keep(a, push_fade, 0, &s_.moves[index(0, kMostArms + a)], &memory_->pushes[a]);
    }
    for (uint32_t round = 0; round < kRoundsOfFrame; ++round) {
      find_depths(round == 0);
      push_out(round == 0);
      if (!move(0)) break;
      for (uint32_t a = 0; a < search_.count(); ++a) {
        Vec3d& push = s_.moves[index(0, kMostArms + a)];
        const Vec3d own = rotate(conjugate(axes_[a]), push);
        memory_->pushes[a] = round == 0 ? own : memory_->pushes[a] + own;
        push = s_.moves[index(0, a)] = {0, 0, 0};
      }
    }
  }

 private:
  // The move becomes what is kept of the one before and a share of its own, and is kept.
  void keep(uint32_t arm, double fade, double share, Vec3d* move, Vec3d* kept) const {
    *kept = fade * *kept + share * rotate(conjugate(axes_[arm]), *move);
    if (length(*kept) < kLeastMove * s_.target.height) *kept = {0, 0, 0};
    *move = rotate(axes_[arm], *kept);
  }
  static size_t index(uint32_t frame, uint32_t slot) { return size_t{frame} * kMostLimbs + slot; }
  HandContact& contact(uint32_t frame, uint32_t arm) { return s_.hands[size_t{frame} * kMostArms + arm]; }

  // Arms go where touch() and push_out() want them. False: they stay, and the frame is not written.
  bool move(uint32_t frame) {
    Vec3d moves[kMostArms];
    bool any = false;
    for (uint32_t a = 0; a < search_.count(); ++a) {
      moves[a] = s_.moves[index(frame, a)] + s_.moves[index(frame, kMostArms + a)];
      any = any || squared(moves[a]) > 0;
    }
    if (!any) return false;
    s_.load(frame);
    for (uint32_t a = 0; a < search_.count(); ++a) {
      const Limb& limb = s_.limbs.limbs[search_.limb(a)];
      if (!(squared(moves[a]) > 0)) continue;
      move_limb(limb, plan_.target_positions[limb.last] + moves[a], plan_.target_positions[limb.middle], &plan_);
      contact(frame, a).outside = false;
    }
    s_.store(frame);
    return true;
  }

  // A triangle's axes: first edge, across, normal; and its middle. Of the body in its pose, vertex by vertex.
  struct Frame {
    Vec3d axis[3], middle;
  };
  Frame frame_of(const PosedBody& posed, uint32_t triangle) const {
    const uint32_t* const corner = s_.body->triangles + size_t{3} * triangle;
    const Vec3d a = posed.skinned(corner[0]), b = posed.skinned(corner[1]), c = posed.skinned(corner[2]);
    Frame out;
    out.axis[0] = unit(b - a);
    out.axis[2] = unit(cross(b - a, c - a));
    out.axis[1] = cross(out.axis[2], out.axis[0]);
    out.middle = (1.0 / 3.0) * (a + b + c);
    return out;
  }

  void look_at_source(uint32_t frame) {
    s_.search_source(frame);
    const double height = s_.source.height;
    for (uint32_t a = 0; a < search_.count(); ++a) {
      HandContact& hand = contact(frame, a);
      hand = HandContact();
      const HandReach reach = search_.nearest(s_.source_tree, a);
      if (reach.near) {
        hand.vertex = reach.vertex;
        const double share = (kFar * height - root(reach.square)) / ((kFar - kTouch) * height);
        const double t = share > 1 ? 1 : share;
        hand.alpha = (t * t * (3 - 2 * t)) * (1 - s_.floor_patches.at(frame, search_.limb(a)).weight);
        remember_position(a, &hand);
      }
      hand.depth = search_.deepest(&s_.source_tree, a, {0, 0, 0}, 0).depth;
    }
  }
  // The contacts of the motion's body are unknown: an arm may be as deep as at rest, and has no contacts.
  void look_at_rest_pose() {
    s_.search_target_at_rest();
    for (uint32_t a = 0; a < search_.count(); ++a) {
      HandContact hand;
      hand.depth = search_.deepest(&s_.target_tree, a, {0, 0, 0}, 0).depth;
      for (uint32_t f = 0; f < s_.in->frames; ++f) contact(f, a) = hand;
    }
  }
  // The nearest triangles with the vertex's position in each one's axes.
  void remember_position(uint32_t arm, HandContact* out) const {
    double squares[kNearTriangles];
    const Vec3d p = s_.source.vertices[out->vertex];
    out->count = search_.neighbors(s_.source_tree, arm, out->vertex, kNearTriangles, out->triangles, squares);
    double sum = 0;
    for (uint32_t i = 0; i < out->count; ++i) {
      out->shares[i] = bell((root(squares[i]) - root(squares[0])) / (kSpread * s_.source.height));
      sum += out->shares[i];
      const Frame frame = frame_of(s_.source, out->triangles[i]);
      const Vec3d offset = p - frame.middle;
      out->offsets[i] = {dot(frame.axis[0], offset), dot(frame.axis[1], offset), dot(frame.axis[2], offset)};
    }
    for (uint32_t i = 0; i < out->count; ++i) out->shares[i] = out->shares[i] / sum;
  }

  // moves[arm]: from where the hand is to the same spot of the body.
  void touch() {
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      bool any = false;
      for (uint32_t a = 0; a < search_.count(); ++a) {
        s_.moves[index(f, a)] = {0, 0, 0};
        any = any || contact(f, a).alpha > 0;
      }
      if (!any) continue;
      s_.load(f);
      s_.target.take_pose(plan_.target_rotations, plan_.target_positions);
      for (uint32_t a = 0; a < search_.count(); ++a) {
        const HandContact& hand = contact(f, a);
        if (!(hand.alpha > 0)) continue;
        Vec3d wanted = {0, 0, 0};
        for (uint32_t i = 0; i < hand.count; ++i) {
          const Frame frame = frame_of(s_.target, hand.triangles[i]);
          const Vec3d o = ratio_ * hand.offsets[i];
          wanted = wanted +
                   hand.shares[i] * (frame.middle + o.x * frame.axis[0] + o.y * frame.axis[1] + o.z * frame.axis[2]);
        }
        s_.moves[index(f, a)] = hand.alpha * (wanted - s_.target.skinned(hand.vertex));
      }
    }
    for (uint32_t a = 0; a < search_.count(); ++a)
      smooth_over_time(s_.moves + a, s_.in->frames, kMostLimbs, 2, s_.smooth);
  }

  // Excess depth of each arm, and in the first round the direction out of the body, longer for a larger depth.
  void find_depths(bool first_round) {
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      bool posed = false;
      for (uint32_t a = 0; a < search_.count(); ++a) {
        HandContact& hand = contact(f, a);
        Vec3d moved = s_.moves[index(f, a)];
        if (memory_ != nullptr) moved = moved + s_.moves[index(f, kMostArms + a)];
        const double before = hand.beyond;
        hand.beyond = 0;
        hand.outside = hand.outside && !(squared(moved) > 0);
        if (hand.outside) continue;
        if (!posed && memory_ == nullptr) s_.search_target(f, true);
        if (!posed && memory_ != nullptr) pose_frame(first_round);
        posed = true;
        const double least = ratio_ * hand.depth;
        const ArmDepth most = s_.has_source ? search_.deepest(&s_.target_tree, a, moved, least)
                                            : search_.deepest_inside(&s_.target_tree, a, moved, least);
        hand.beyond = most.depth - least;
        hand.normal = most.out;
        hand.outside = !(hand.beyond > 0);
        if (!s_.has_source && before > 0 && !first_round && hand.beyond > kNoHelp * before &&
            is_at_elbow(a, most.vertex)) {
          hand.outside = true;
          hand.beyond = 0;
        }
        if (first_round && !s_.has_source && !hand.outside) hand.way = (hand.beyond + length(moved)) * way_of_arm(a);
      }
    }
  }
  // search_target() for a single frame: only the tested vertices, and the body once, which does not move.
  void pose_frame(bool first_round) {
    s_.load(0);
    s_.target.take_pose(plan_.target_rotations, plan_.target_positions);
    for (uint32_t a = 0; a < search_.count(); ++a) search_.pose_arm(a, &s_.target);
    if (!first_round) return;
    for (uint32_t v = 0; v < s_.body->vertex_count; ++v) {
      const uint32_t limb = s_.limb_of[v];
      if (limb >= kMostLimbs || s_.limbs.limbs[limb].leg) s_.target.vertices[v] = s_.target.skinned(v);
    }
    search_.fill(s_.target, true, &s_.target_tree);
  }
  bool is_at_elbow(uint32_t arm, uint32_t vertex) const {
    const Limb& limb = s_.limbs.limbs[search_.limb(arm)];
    const Vec3d elbow = plan_.target_positions[limb.middle], bone = plan_.target_positions[limb.last] - elbow;
    return dot(s_.target.vertices[vertex] - elbow, bone) < kElbow * squared(bone);
  }
  // The common direction of wrist, hand and the middle of the forearm.
  Vec3d way_of_arm(uint32_t arm) const {
    const Limb& limb = s_.limbs.limbs[search_.limb(arm)];
    const Vec3d elbow = plan_.target_positions[limb.middle], wrist = plan_.target_positions[limb.last];
    const double reach = kBlur * s_.target.height;
    const auto way = [&](Vec3d p) { return search_.way_out(s_.target_tree, p, reach); };
    return way(0.5 * (elbow + wrist)) + way(wrist) + way(search_.middle_of_hand(s_.target_tree, arm));
  }

  // moves[kMostArms + arm]: what brings the deepest point out of the body, beyond the depth that it may have.
  void push_out(bool first_round) {
    for (uint32_t a = 0; a < search_.count(); ++a) {
      Vec3d* const moves = s_.moves + kMostArms + a;
      if (first_round && !s_.has_source) smooth_ways(a, moves);
      for (uint32_t f = 0; f < s_.in->frames; ++f) {
        const double floor = s_.has_source ? 0 : s_.floor_patches.at(f, search_.limb(a)).weight;
        const Vec3d kept = memory_ != nullptr ? moves[size_t{f} * kMostLimbs] : Vec3d{0, 0, 0};
        moves[size_t{f} * kMostLimbs] = (1 - floor) * (kept + move_out(contact(f, a)));
      }
      smooth_over_time(moves, s_.in->frames, kMostLimbs, 1, s_.smooth);
    }
  }
  void smooth_ways(uint32_t arm, Vec3d* scratch) {
    if (memory_ != nullptr) {
      Vec3d& way = memory_->ways[arm];
      way = fade_at(s_.in->fps, kWayFade) * way + rotate(conjugate(axes_[arm]), contact(0, arm).way);
      contact(0, arm).way = unit(rotate(axes_[arm], way));
      return;
    }
    for (uint32_t f = 0; f < s_.in->frames; ++f) scratch[size_t{f} * kMostLimbs] = contact(f, arm).way;
    smooth_over_time(scratch, s_.in->frames, kMostLimbs, kWayPasses, s_.smooth);
    for (uint32_t f = 0; f < s_.in->frames; ++f) contact(f, arm).way = unit(scratch[size_t{f} * kMostLimbs]);
  }
  Vec3d move_out(const HandContact& hand) const {
    if (!(hand.beyond > 0)) return {0, 0, 0};
    if (s_.has_source || !(squared(hand.way) > 0)) return hand.beyond * hand.normal;
    const double slope = dot(hand.way, hand.normal);
    return (hand.beyond / (slope > kSteepest ? slope : 1)) * hand.way;
  }

  ContactScene& s_;
  HandMemory* memory_;
  sinew_retarget& plan_;
  ArmSearch& search_;
  Quat axes_[kMostArms];  // of a frame alone, see axes_of()
  double ratio_ = 1;      // lengths of the target's body per length of the source's
};

}  // namespace

sinew_status place_hands(ContactScene* scene) {
  scene->search.open(*scene);
  return Hands(scene, nullptr).run();
}
void open_hands(ContactScene* scene, HandMemory* memory) {
  scene->search.open(*scene, kArmOfFrame);
  Hands(scene, memory).open();
}
void place_hands_next(ContactScene* scene, HandMemory* memory) { Hands(scene, memory).next(); }

}  // namespace sinew::motion
