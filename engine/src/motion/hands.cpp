// SPDX-License-Identifier: MIT
// Hands and forearms against the body: a hand near a place of the source's surface goes to the same place of the target's,
// and what would be deeper inside of it than the source's is comes out.
#include "motion/contacts.hpp"

namespace sinew {
namespace {

// Shares of the height: nearer than the first a hand touches, farther than the second it does not.
constexpr double kTouch = 0.03, kFar = 0.12;
constexpr double kSpread = 0.02;  // of the weights of near triangles
constexpr uint32_t kRounds = 3;
constexpr uint32_t kFeetEnd = 250, kSourceEnd = 400, kWhole = 1000;  // permille

// About exp(-x^2 / 2): a power of a fraction needs no libm.
double bell(double x) {
  const double d = 1 + x * x * (1.0 / 16);
  const double d2 = d * d, d4 = d2 * d2;
  return 1 / (d4 * d4);
}

double squared(Vec3d v) { return dot(v, v); }

// The smallest box along the axes around the vertices of an arm, grown by `reach`.
struct ReachBox {
  Vec3d low = {0, 0, 0}, high = {0, 0, 0};
  bool any = false;

  void add(Vec3d p) {
    if (!any) low = high = p;
    any = true;
    low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
    high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
  }
  bool holds(Vec3d p, double reach) const {
    return any && p.x >= low.x - reach && p.y >= low.y - reach && p.z >= low.z - reach && p.x <= high.x + reach &&
           p.y <= high.y + reach && p.z <= high.z + reach;
  }
};

class Hands {
 public:
  explicit Hands(ContactScene* scene) : s_(*scene), plan_(*scene->plan), body_(*scene->body) {
    for (uint32_t l = 0; l < s_.limbs.count && arm_count_ < kMostArms; ++l) {
      if (!s_.limbs.limbs[l].leg) arms_[arm_count_++] = l;
    }
    uint32_t count = 0;
    for (uint32_t a = 0; a < arm_count_; ++a) {
      begin_[a] = count;
      for (uint32_t v = 0; v < body_.vertex_count; ++v) {
        if (s_.limb_of[v] == arms_[a] && s_.parts[v] == BodyPart::kHand) s_.arm_vertices[count++] = v;
      }
      hand_end_[a] = count;
      for (uint32_t v = 0; v < body_.vertex_count; ++v) {
        if (s_.limb_of[v] == arms_[a] && s_.parts[v] == BodyPart::kForearm) s_.arm_vertices[count++] = v;
      }
      end_[a] = count;
    }
  }

  sinew_status run() {
    const Progress& progress = s_.in->progress;
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      (void)s_.load_source(f, true);
      s_.source.find_triangles(body_.triangles, body_.triangle_count);
      for (uint32_t a = 0; a < arm_count_; ++a) look_at_source(a, &contact(f, a));
      if (!progress.report(kFeetEnd + static_cast<uint32_t>(uint64_t{f} * (kSourceEnd - kFeetEnd) / s_.in->frames)))
        return SINEW_ERROR_CANCELLED;
    }
    for (uint32_t round = 0; round < kRounds; ++round) {
      touch();
      push_out();
      for (uint32_t f = 0; f < s_.in->frames; ++f) {
        s_.load(f);
        for (uint32_t a = 0; a < arm_count_; ++a) {
          const Limb& limb = s_.limbs.limbs[arms_[a]];
          const Vec3d move = s_.moves[index(f, a)] + s_.moves[index(f, kMostArms + a)];
          if (squared(move) > 0) move_limb(limb, plan_.target_places[limb.last] + move, &plan_);
        }
        s_.store(f);
      }
      if (!progress.report(kSourceEnd + (round + 1) * (kWhole - kSourceEnd) / kRounds)) return SINEW_ERROR_CANCELLED;
    }
    return SINEW_OK;
  }

 private:
  static size_t index(uint32_t frame, uint32_t slot) { return size_t{frame} * kMostLimbs + slot; }
  HandContact& contact(uint32_t frame, uint32_t arm) { return s_.hands[size_t{frame} * kMostArms + arm]; }
  bool is_arm_vertex(uint32_t v) const { return s_.limb_of[v] < kMostLimbs && !s_.limbs.limbs[s_.limb_of[v]].leg; }

  // Triangles within reach of a box: those without a vertex of this arm, or of any arm. Returns how many were picked.
  uint32_t pick(const PosedBody& posed, const ReachBox& box, double reach, uint32_t arm, bool of_other_arms) {
    uint32_t count = 0;
    for (uint32_t t = 0; t < body_.triangle_count; ++t) {
      if (!box.holds(posed.middles[t], reach)) continue;
      const uint32_t* const corner = body_.triangles + size_t{3} * t;
      bool usable = true;
      for (int c = 0; c < 3; ++c)
        usable = usable && (of_other_arms ? s_.limb_of[corner[c]] != arms_[arm] : !is_arm_vertex(corner[c]));
      if (usable) s_.picked[count++] = t;
    }
    return count;
  }

  // How far p lies under the nearest picked triangle, and that triangle; 0 where none is near.
  double depth(const PosedBody& posed, uint32_t picked, Vec3d p, double limit, uint32_t* nearest) const {
    double least = limit * limit;
    uint32_t best = UINT32_MAX;
    for (uint32_t i = 0; i < picked; ++i) {
      const double own = squared(p - posed.middles[s_.picked[i]]);
      if (own < least) {
        least = own;
        best = s_.picked[i];
      }
    }
    if (best == UINT32_MAX) return 0;
    *nearest = best;
    return dot(posed.middles[best] - p, posed.normals[best]);
  }

  // A triangle's axes: first edge, across, normal.
  void axes(const PosedBody& posed, uint32_t triangle, Vec3d (&out)[3]) const {
    const uint32_t* const corner = body_.triangles + size_t{3} * triangle;
    out[0] = unit(posed.vertices[corner[1]] - posed.vertices[corner[0]]);
    out[2] = posed.normals[triangle];
    out[1] = cross(out[2], out[0]);
  }

  void look_at_source(uint32_t arm, HandContact* out) {
    const double height = s_.source.height, reach = kFar * height;
    ReachBox hand, all;
    for (uint32_t i = begin_[arm]; i < end_[arm]; ++i) {
      const Vec3d p = s_.source.vertices[s_.arm_vertices[i]];
      all.add(p);
      if (i < hand_end_[arm]) hand.add(p);
    }
    *out = HandContact();
    uint32_t picked = pick(s_.source, hand, reach, arm, true);
    double least = reach * reach;
    bool near = false;
    for (uint32_t h = begin_[arm]; h < hand_end_[arm]; ++h) {
      const uint32_t v = s_.arm_vertices[h];
      const Vec3d p = s_.source.vertices[v];
      for (uint32_t i = 0; i < picked; ++i) {
        const double own = squared(p - s_.source.middles[s_.picked[i]]);
        if (own >= least) continue;
        least = own;
        out->vertex = v;
        near = true;
      }
    }
    if (near) {
      const double share = (reach - root(least)) / ((kFar - kTouch) * height);
      const double t = share > 1 ? 1 : share;
      out->alpha = t * t * (3 - 2 * t);
      remember_place(picked, height, out);
    }
    picked = pick(s_.source, all, reach, arm, false);
    for (uint32_t i = begin_[arm]; i < end_[arm] && picked > 0; ++i) {
      uint32_t nearest = 0;
      const double own = depth(s_.source, picked, s_.source.vertices[s_.arm_vertices[i]], reach, &nearest);
      if (own > out->depth) out->depth = own;
    }
  }
  // The nearest triangles with the vertex's place in each one's axes.
  void remember_place(uint32_t picked, double height, HandContact* out) const {
    double distances[kNearTriangles];
    const Vec3d p = s_.source.vertices[out->vertex];
    for (uint32_t i = 0; i < picked; ++i) {
      const uint32_t t = s_.picked[i];
      const double own = squared(p - s_.source.middles[t]);
      if (out->count == kNearTriangles && own >= distances[kNearTriangles - 1]) continue;
      uint32_t at = out->count < kNearTriangles ? out->count++ : kNearTriangles - 1;
      for (; at > 0 && own < distances[at - 1]; --at) {
        distances[at] = distances[at - 1];
        out->triangles[at] = out->triangles[at - 1];
      }
      distances[at] = own;
      out->triangles[at] = t;
    }
    double sum = 0;
    for (uint32_t i = 0; i < out->count; ++i) {
      out->shares[i] = bell((root(distances[i]) - root(distances[0])) / (kSpread * height));
      sum += out->shares[i];
      Vec3d axis[3];
      axes(s_.source, out->triangles[i], axis);
      const Vec3d way = p - s_.source.middles[out->triangles[i]];
      out->offsets[i] = {dot(axis[0], way), dot(axis[1], way), dot(axis[2], way)};
    }
    for (uint32_t i = 0; i < out->count; ++i) out->shares[i] = out->shares[i] / sum;
  }

  void pose_target(uint32_t frame) {
    s_.load(frame);
    s_.target.pose(plan_.target_turns, plan_.target_places);
    s_.target.find_triangles(body_.triangles, body_.triangle_count);
  }

  // moves[arm]: from where the hand is to the same place of the body.
  void touch() {
    const double ratio = s_.target.height / s_.source.height;
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      bool any = false;
      for (uint32_t a = 0; a < arm_count_; ++a) {
        s_.moves[index(f, a)] = {0, 0, 0};
        any = any || contact(f, a).alpha > 0;
      }
      if (!any) continue;
      pose_target(f);
      for (uint32_t a = 0; a < arm_count_; ++a) {
        const HandContact& hand = contact(f, a);
        if (!(hand.alpha > 0)) continue;
        Vec3d wanted = {0, 0, 0};
        for (uint32_t i = 0; i < hand.count; ++i) {
          Vec3d axis[3];
          axes(s_.target, hand.triangles[i], axis);
          const Vec3d o = ratio * hand.offsets[i];
          wanted = wanted + hand.shares[i] *
                                (s_.target.middles[hand.triangles[i]] + o.x * axis[0] + o.y * axis[1] + o.z * axis[2]);
        }
        s_.moves[index(f, a)] = hand.alpha * (wanted - s_.target.vertices[hand.vertex]);
      }
    }
    for (uint32_t a = 0; a < arm_count_; ++a) smooth_over_time(s_.moves + a, s_.in->frames, kMostLimbs, 2, s_.smooth);
  }

  // moves[kMostArms + arm]: what brings the deepest point out of the body, beyond the source's own depth.
  void push_out() {
    const double ratio = s_.target.height / s_.source.height, reach = kFar * s_.target.height;
    for (uint32_t f = 0; f < s_.in->frames; ++f) {
      pose_target(f);
      for (uint32_t a = 0; a < arm_count_; ++a) {
        const Vec3d moved = s_.moves[index(f, a)];
        ReachBox box;
        for (uint32_t i = begin_[a]; i < end_[a]; ++i) box.add(s_.target.vertices[s_.arm_vertices[i]] + moved);
        const uint32_t picked = pick(s_.target, box, reach, a, false);
        double most = 0;
        Vec3d out = {0, 0, 0};
        for (uint32_t i = begin_[a]; i < end_[a] && picked > 0; ++i) {
          uint32_t nearest = 0;
          const double own = depth(s_.target, picked, s_.target.vertices[s_.arm_vertices[i]] + moved, reach, &nearest);
          const double beyond = own - ratio * contact(f, a).depth;
          if (own <= 0 || beyond <= most) continue;
          most = beyond;
          out = most * s_.target.normals[nearest];
        }
        s_.moves[index(f, kMostArms + a)] = out;
      }
    }
    for (uint32_t a = 0; a < arm_count_; ++a)
      smooth_over_time(s_.moves + kMostArms + a, s_.in->frames, kMostLimbs, 1, s_.smooth);
  }

  ContactScene& s_;
  sinew_retarget& plan_;
  const sinew_motion_body& body_;
  uint32_t arms_[kMostArms] = {};  // indices of limbs
  uint32_t arm_count_ = 0;
  // Of each arm in arm_vertices: those of the hand, then those of the forearm.
  uint32_t begin_[kMostArms] = {}, hand_end_[kMostArms] = {}, end_[kMostArms] = {};
};

}  // namespace

sinew_status place_hands(ContactScene* scene) { return Hands(scene).run(); }

}  // namespace sinew
