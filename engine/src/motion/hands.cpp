// SPDX-License-Identifier: MIT
// Hands and forearms against the body: a hand near a place of the source's surface goes to the same place of the target's,
// and what would be deeper inside of it than the source's is comes out. Without a source's body what is deeper than at rest.
#include "motion/contacts.hpp"

namespace sinew::motion {
namespace {

constexpr double kSpread = 0.02;  // of the weights of near triangles
constexpr uint32_t kRounds = 3;
constexpr uint32_t kFeetEnd = 250, kSourceEnd = 400, kWhole = 1000;  // permille

// About exp(-x^2 / 2): a power of a fraction needs no libm.
double bell(double x) {
  const double d = 1 + x * x * (1.0 / 16);
  const double d2 = d * d, d4 = d2 * d2;
  return 1 / (d4 * d4);
}

class Hands {
 public:
  explicit Hands(ContactScene* scene) : s_(*scene), plan_(*scene->plan), search_(scene->search) {
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
    for (uint32_t round = 0; round < kRounds; ++round) {
      touch();
      push_out();
      bool any = false;
      for (uint32_t f = 0; f < s_.in->frames; ++f) any = move(f) || any;
      if (!progress.report(kSourceEnd + (round + 1) * (kWhole - kSourceEnd) / kRounds)) return SINEW_ERROR_CANCELLED;
      if (!any) break;
    }
    return SINEW_OK;
  }

 private:
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
  // Nobody knows what the motion's own body touched: an arm may be as deep as it is at rest, and touches nothing.
  void look_at_rest_pose() {
    s_.search_target_at_rest();
    for (uint32_t a = 0; a < search_.count(); ++a) {
      HandContact hand;
      hand.depth = search_.deepest(&s_.target_tree, a, {0, 0, 0}, 0).depth;
      for (uint32_t f = 0; f < s_.in->frames; ++f) contact(f, a) = hand;
    }
  }
  // The nearest triangles with the vertex's place in each one's axes.
  void remember_position(uint32_t arm, HandContact* out) const {
    double squares[kNearTriangles];
    const Vec3d p = s_.source.vertices[out->vertex];
    out->count = search_.neighbours(s_.source_tree, arm, out->vertex, kNearTriangles, out->triangles, squares);
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

  // moves[arm]: from where the hand is to the same place of the body.
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

  // moves[kMostArms + arm]: what brings the deepest point out of the body, beyond the depth that it may have.
  void push_out() {
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      bool posed = false;
      for (uint32_t a = 0; a < search_.count(); ++a) {
        HandContact& hand = contact(f, a);
        const Vec3d moved = s_.moves[index(f, a)];
        s_.moves[index(f, kMostArms + a)] = {0, 0, 0};
        hand.outside = hand.outside && !(squared(moved) > 0);
        if (hand.outside) continue;
        if (!posed) s_.search_target(f, true);
        posed = true;
        const double least = ratio_ * hand.depth;
        const ArmDepth most = search_.deepest(&s_.target_tree, a, moved, least);
        const double beyond = most.depth - least;
        if (beyond > 0) s_.moves[index(f, kMostArms + a)] = beyond * most.out;
        hand.outside = !(beyond > 0);
      }
    }
    for (uint32_t a = 0; a < search_.count(); ++a)
      smooth_over_time(s_.moves + kMostArms + a, s_.in->frames, kMostLimbs, 1, s_.smooth);
  }

  ContactScene& s_;
  sinew_retarget& plan_;
  ArmSearch& search_;
  double ratio_ = 1;  // lengths of the target's body per length of the source's
};

}  // namespace

sinew_status place_hands(ContactScene* scene) {
  scene->search.open(*scene);
  return Hands(scene).run();
}

}  // namespace sinew::motion
