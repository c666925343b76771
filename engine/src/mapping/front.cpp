// SPDX-License-Identifier: MIT
// Finds the front: votes of feet, heads, tails, bent knees and elbows, thumbs and faces; names take precedence.
#include "mapping/anatomy.hpp"

namespace sinew::mapping {

void Anatomy::open_paths() {
  for (int32_t i = 0; i < rig->n; ++i) path_open[i] = 0;
  path_open[hip] = 1;
  for (int32_t k = rig->position[hip] + 1; k < rig->position[hip] + rig->count[hip]; ++k) {
    const int32_t i = rig->order[k];
    path_open[i] = path_open[rig->parent[i]] != 0 && side[i] == 0 && rig->end[i] == 0 ? 1 : 0;
  }
}

bool Anatomy::is_path_end(int32_t joint) const {
  if (path_open[joint] == 0 || joint == hip) return false;
  for (int32_t k = 0; k < rig->kid_count(joint); ++k) {
    if (path_open[rig->kid(joint, k)] != 0) return false;
  }
  return true;
}

bool Anatomy::leads_to_legs(int32_t leaf) const {
  if (hip_pair.a < 0) return false;
  const int32_t attach = limb(hip_pair.a).attach;
  while (rig->parent[leaf] != hip) leaf = rig->parent[leaf];
  return attach >= 0 && attach != hip && rig->holds(leaf, attach);
}

double Anatomy::path_length(int32_t leaf) const {
  double sum = 0;
  for (int32_t i = leaf; i != hip; i = rig->parent[i]) sum += rig->bone(i, rig->parent[i]);
  return sum;
}

double Anatomy::path_names(int32_t leaf) const {
  if (!rig->has_names || leg_count == 0) return 0;  // without legs the longest path counts, head or tail
  bool is_head = false, is_trunk = false, is_tail = false, is_face = false;
  for (int32_t i = leaf; i != hip; i = rig->parent[i]) {
    const Part w = rig->part(i);
    is_head = is_head || w == Part::kHead;
    is_trunk = is_trunk || w == Part::kNeck || w == Part::kSpine;
    is_tail = is_tail || w == Part::kTail;
    is_face = is_face || w == Part::kJaw || w == Part::kHair;
  }
  return 3.0 * is_head + 1.0 * is_trunk - 2.0 * is_tail - 1.5 * is_face;
}

double Anatomy::pair_ahead(const LimbPair& pair) const {
  return 0.5 * (ahead(limbs.point(limb(pair.a), 0)) + ahead(limbs.point(limb(pair.b), 0)));
}

bool Anatomy::is_inner(double ahead_of, double first, double last) const {
  const double rim = 0.15 * (last - first);
  return first + rim < ahead_of && ahead_of < last - rim;
}

void Anatomy::take_spine(int32_t leaf) {
  spine_count = 0;
  if (leaf < 0) return;
  spine_count = rig->depth[leaf] - rig->depth[hip];
  for (int32_t i = leaf, k = spine_count; k > 0; i = rig->parent[i]) spine[--k] = i;
}

// Gathers votes; each is tanh of a value, times a weight.
class FrontVotes {
 public:
  explicit FrontVotes(Anatomy& anatomy) : a_(anatomy), rig_(*anatomy.rig), size_(anatomy.rig->size) {}

  double sum() {
    measure_legs();
    choose_spine();
    if (a_.leg_count > 2) {  // an insect's feet and knees point everywhere
      if (a_.spine_count > 0) add(a_.ahead(a_.at(a_.spine[a_.spine_count - 1]) - a_.at(a_.hip)) / size_ / 0.05, 2);
      faces();
      return sum_;
    }
    if (a_.leg_count > 0) feet();
    if (a_.quad && a_.spine_count > 0) {
      animal();
    } else if (a_.leg_count > 0) {
      trunk_and_tail();
    }
    if (a_.leg_count == 0 && a_.spine_count > 0) {  // fish, snakes: the long path is the tail, if it is not called head
      const Point d = a_.at(a_.spine[a_.spine_count - 1]) - a_.at(a_.hip);
      const double weight = named_tail();
      if (absolute(a_.ahead(d)) > 0.6 * absolute(dot(d, a_.frame.up))) add(-a_.ahead(d) / size_ / 0.1, weight);
    }
    if (a_.leg_count == 0) fins();
    find_arm();
    bends();
    arms();
    faces();
    return sum_;
  }

 private:
  void add(double value, double weight) { sum_ += hyperbolic_tangent(value) * weight; }

  // Legs that stand apart along the front axis: an animal on four or more.
  void measure_legs() {
    a_.quad = false;
    if (a_.leg_count == 0) return;
    double leg = 0;
    for (int32_t k = 0; k < a_.leg_count; ++k) {
      const double at = a_.pair_ahead(a_.legs[k]);
      first_leg_ = k == 0 ? at : lesser(first_leg_, at);
      last_leg_ = k == 0 ? at : greater(last_leg_, at);
      leg += a_.limb(a_.legs[k].a).length;
    }
    if (a_.leg_count >= 2) a_.quad = last_leg_ - first_leg_ > 0.35 * leg / a_.leg_count;
  }

  double path_weight(int32_t leaf) const {
    if (a_.leg_count == 0)
      return a_.path_length(leaf) / size_ + a_.path_names(leaf);  // a tail, and any child of the head
    double limbs = 0, top = a_.height[leaf];
    int32_t inner = 0;
    for (int32_t i = leaf; i != a_.hip; i = rig_.parent[i]) {
      for (int32_t b = a_.limb_head[i]; b >= 0; b = a_.limb_next[b])
        limbs += a_.limb(b).tree * (a_.limb(b).length / size_ + 0.02);
      top = greater(top, a_.height[i]);
      inner += a_.is_inner(a_.ahead(a_.at(i)), first_leg_, last_leg_) ? 1 : 0;
    }
    // Insects have an abdomen longer and higher than the head, which carries jaws and feelers.
    if (a_.leg_count > 2) return 20 * limbs + 0.3 * a_.path_length(leaf) / size_ + a_.path_names(leaf);
    double weight = limbs * 3 / greater(1, root(rig_.n)) + 0.3 * a_.path_length(leaf) / size_ +
                    0.6 * (top - a_.height[a_.hip]) / size_;
    if (a_.quad) {  // the spine runs from the hind legs to the fore legs, the tail does not
      weight += 0.5 * inner;
      if (!a_.is_inner(a_.ahead(a_.at(leaf)), first_leg_, last_leg_)) weight += 1;
      weight += 0.6 * (a_.height[leaf] - a_.height[a_.hip]) / size_;  // tails hang
    }
    return weight + a_.path_names(leaf);
  }

  template <class Body>
  void each_path(const Body& body) const {
    const int32_t from = rig_.position[a_.hip];
    for (int32_t k = from; k < from + rig_.count[a_.hip]; ++k) {
      if (a_.is_path_end(rig_.order[k])) body(rig_.order[k]);
    }
  }

  void choose_spine() {
    a_.open_paths();
    int32_t best = -1;
    each_path([&](int32_t leaf) {
      const double weight = path_weight(leaf) - (a_.leads_to_legs(leaf) ? 20 : 0);
      if (best >= 0 && !(weight > spine_weight_)) return;
      best = leaf;
      spine_weight_ = weight;
    });
    a_.take_spine(best);
  }

  // Bones near the ground point ahead.
  void feet() {
    for (int32_t k = 0; k < a_.foot_count; ++k) {
      for (int s = 0; s < 2; ++s) {
        const Limb& limb = a_.limb(a_.feet[k].of(s));
        const int32_t own = limb.point_count;
        int32_t first_sub = -1;
        a_.limbs.each_end_sub(limb, [&](int32_t t) { first_sub = first_sub < 0 ? t : first_sub; });
        const int32_t count = own + (first_sub >= 0 ? 1 : 0);
        const auto point = [&](int32_t i) {
          return i < own ? a_.limbs.point(limb, i) : a_.at(a_.limbs.last_joint(a_.limb(first_sub)));
        };
        const int32_t from = count - (a_.quad ? 1 : 3);
        for (int32_t i = from > 1 ? from : 1; i < count; ++i) {
          const Point bone = point(i) - point(i - 1);
          const double start = dot(point(i - 1), a_.frame.up), stop = dot(point(i), a_.frame.up);
          if (lesser(start, stop) < a_.ground + 0.08 * a_.tall &&
              start < a_.ground + (a_.quad ? 0.5 : 0.35) * a_.tall &&
              absolute(a_.ahead(bone)) > 0.5 * absolute(dot(bone, a_.frame.up))) {
            const double weight = a_.quad ? 0.6 : 1.2;
            add(a_.ahead(bone) / size_ / 0.04, a_.quad || start < a_.ground + 0.2 * a_.tall ? weight : 0.5 * weight);
          }
        }
      }
    }
  }

  // The head's end of the spine, against the best path that ends on the other side of the legs; the root is behind.
  void animal() {
    const double middle = 0.5 * (first_leg_ + last_leg_);
    const int32_t end = sign(a_.ahead(a_.at(a_.spine[a_.spine_count - 1])) - middle);
    double other = 0;
    bool any = false;
    each_path([&](int32_t leaf) {
      if (sign(a_.ahead(a_.at(leaf)) - middle) != -end) return;
      const double weight = path_weight(leaf);
      other = any ? greater(other, weight) : weight;
      any = true;
    });
    const double sure = any ? hyperbolic_tangent((spine_weight_ - other) / 0.5) : 1;
    double top = a_.ahead(a_.at(a_.spine[a_.spine_count - 1]));
    if (a_.spine_count >= 3) top = 0.5 * (top + a_.ahead(a_.at(a_.spine[a_.spine_count - 2])));
    add((top - middle) / size_ / 0.05, 2 * sure);
    const double hips = a_.ahead(a_.at(a_.hip));
    if (absolute(hips - middle) > 0.12 * (last_leg_ - first_leg_)) add((middle - hips) / size_ / 0.05, 1);
  }

  void trunk_and_tail() {
    if (a_.spine_count == 0) return;
    const int32_t top = a_.spine[a_.spine_count - 1];
    const Point d = a_.at(top) - a_.at(a_.spine_count >= 3 ? a_.spine[0] : a_.hip);
    if (absolute(a_.ahead(d)) > 0.6 * absolute(dot(d, a_.frame.up))) add(a_.ahead(d) / size_ / 0.1, 1);
    each_path([&](int32_t leaf) {
      if (leaf == top || rig_.depth[leaf] - rig_.depth[a_.hip] < 2 || rig_.holds(a_.spine[0], leaf)) return;
      add(-a_.ahead(a_.at(leaf) - a_.at(a_.hip)) / size_ / 0.1, 1.5);
    });
  }

  // How much the spine is a tail.
  double named_tail() const {
    for (int32_t k = 0; k < a_.spine_count && rig_.has_names; ++k) {
      const Part w = rig_.part(a_.spine[k]);
      if (w == Part::kTail) return 3;
      if (w == Part::kHead) return -3;
    }
    return 0.8;
  }

  // Fins lie back.
  void fins() {
    for (int32_t k = 0; k < a_.limbs.pair_count; ++k) {
      for (int s = 0; s < 2; ++s) {
        const Limb& limb = a_.limb(a_.limbs.pairs[k].of(s));
        const Point direction = a_.limbs.last_point(limb) - a_.limbs.point(limb, 0);
        if (limb.point_count > 1 && limb.length > 0.05 * size_) add(-a_.ahead(direction) / size_ / 0.05, 0.5);
      }
    }
  }

  void find_arm() {
    double best = 0;
    for (int32_t k = 0; k < a_.limbs.pair_count; ++k) {
      const LimbPair& pair = a_.limbs.pairs[k];
      if (a_.is_leg(pair.a)) continue;
      const double own = a_.limb(pair.a).length + (a_.limb(pair.a).tree > 4 ? 0.3 * size_ : 0);
      if (arm_.a >= 0 && !(own > best)) continue;
      best = own;
      arm_ = pair;
    }
  }

  void bends() {
    for (int32_t k = 0; k < a_.limbs.pair_count; ++k) {
      for (int s = 0; s < 2; ++s) {
        const Limb& limb = a_.limb(a_.limbs.pairs[k].of(s));
        const int32_t most = limb.joint_count > 3 ? limb.joint_count : 3;
        const int32_t count = limb.point_count < most ? limb.point_count : most;
        if (count < 3 || !(limb.length > 0.15 * size_)) continue;
        const Point start = a_.limbs.point(limb, 0), chord = a_.limbs.point(limb, count - 1) - start;
        const double squared = dot(chord, chord);
        if (!(squared > 1e-12)) continue;
        double widest = -1, value = 0, least = 0, most_ahead = 0;
        for (int32_t i = 1; i + 1 < count; ++i) {
          const Point off = a_.limbs.point(limb, i) - start;
          const Point bend = off - (dot(off, chord) / squared) * chord;
          const double front = a_.ahead(bend);
          least = i == 1 ? front : lesser(least, front);
          most_ahead = i == 1 ? front : greater(most_ahead, front);
          if (!(dot(bend, bend) > widest)) continue;
          widest = dot(bend, bend);
          value = front / size_ / 0.02;
        }
        if (a_.is_leg(a_.limbs.pairs[k].a)) {  // a leg that bends to one side only
          if (!a_.quad && least * most_ahead > -1e-6 * size_ * size_) add(value, 0.4);
        } else if (a_.limbs.pairs[k].a == arm_.a && a_.leg_count > 0) {
          add(-value, 0.5);
        }
      }
    }
  }

  // Arms reach forward, and so do thumbs.
  void arms() {
    if (arm_.a < 0 || a_.quad || a_.leg_count == 0) return;
    for (int s = 0; s < 2; ++s) {
      const Limb& limb = a_.limb(arm_.of(s));
      if (!(limb.length > 0.1 * size_)) continue;
      add(a_.ahead(a_.limbs.point(limb, limb.joint_count - 1) - a_.limbs.point(limb, 0)) / size_ / 0.1, 0.4);
      int32_t fingers[kMostFingers];
      int32_t count = 0;
      a_.limbs.each_end_sub(limb, [&](int32_t t) {
        if (count < kMostFingers) fingers[count++] = t;
      });
      if (count >= 3) {
        const int32_t thumb = a_.thumb(limb, fingers, count);
        Point others;
        for (int32_t k = 0; k < count; ++k) {
          if (fingers[k] != thumb) others = others + a_.limbs.point(a_.limb(fingers[k]), 0);
        }
        const Point tip = a_.at(a_.limbs.last_joint(a_.limb(thumb)));
        add(a_.ahead(tip - (1.0 / (count - 1)) * others) / size_ / 0.03, 0.6);
      } else if (count == 2) {
        const Limb &p = a_.limb(fingers[0]), &q = a_.limb(fingers[1]);
        const bool first = p.length < q.length || (p.length == q.length && a_.limbs.joint(p, 0) < a_.limbs.joint(q, 0));
        const Limb &thumb = first ? p : q, &other = first ? q : p;
        add(a_.ahead(a_.at(a_.limbs.last_joint(thumb)) - a_.limbs.point(other, 0)) / size_ / 0.03, 0.4);
      }
    }
  }

  // Small joints on the upper half of the spine, paired or in the plane, lie in front of it.
  void faces() {
    const bool tail = a_.leg_count == 0 && named_tail() > 0;  // the spine in hand leads away from the head
    for (int32_t k = a_.spine_count / 2; k < a_.spine_count && !tail; ++k) {
      for (int32_t b = a_.limb_head[a_.spine[k]]; b >= 0; b = a_.limb_next[b]) {
        const Limb& limb = a_.limb(b);
        if (!(limb.length < 0.1 * size_) || limb.mate < 0) continue;
        add(a_.ahead(a_.limbs.last_point(limb) - a_.at(a_.spine[k])) / size_ / 0.05, 0.3);
      }
    }
    for (int32_t k = tail ? a_.spine_count : a_.spine_count / 2; k <= a_.spine_count; ++k) {
      if (k == a_.spine_count && a_.leg_count > 0) break;
      const int32_t i = k < a_.spine_count ? a_.spine[k] : a_.hip;
      each_kid(rig_, i, [&](int32_t kid) {
        bool on_spine = false;
        for (int32_t s = 0; s < a_.spine_count; ++s) on_spine = on_spine || a_.spine[s] == kid;
        if (a_.side[kid] != 0 || on_spine || rig_.end[kid] != 0 ||
            !(rig_.reach[kid] + rig_.bone(kid, i) < 0.3 * size_)) {
          return;
        }
        const Point d = a_.at(kid) - a_.at(i);
        if (absolute(a_.ahead(d)) > absolute(dot(d, a_.frame.up))) add(a_.ahead(d) / size_ / 0.05, 0.4);
      });
    }
  }

  Anatomy& a_;
  const Hierarchy& rig_;
  const double size_;
  double sum_ = 0, first_leg_ = 0, last_leg_ = 0, spine_weight_ = 0;
  LimbPair arm_;
};

void Anatomy::find_front(bool flip_it) {
  const double sum = FrontVotes(*this).sum();
  sure = absolute(sum);
  bool reverse = sum < 0;
  if (rig->has_names) {
    double left = 0, right = 0;
    int32_t lefts = 0, rights = 0;
    for (int32_t i = 0; i < rig->n; ++i) {
      const int8_t said = rig->names[i].side;
      if (said == 0 || !(absolute(x[i]) > 0.02 * rig->size)) continue;
      (said > 0 ? left : right) += x[i];
      ++(said > 0 ? lefts : rights);
    }
    if (lefts > 0 && rights > 0 && absolute(left / lefts - right / rights) > 0.02 * rig->size) {
      reverse = left / lefts < right / rights;
      sure = 9;
    }
  }
  if (reverse != flip_it) flip();
}

void Anatomy::flip() {
  frame.across = -frame.across;
  frame.front = -frame.front;
  frame.plane = -frame.plane;
  for (int32_t i = 0; i < rig->n; ++i) {
    x[i] = -x[i];
    side[i] = static_cast<int8_t>(-side[i]);
  }
  for (int32_t k = 0; k < limbs.count; ++k) limbs.at[k].side = static_cast<int8_t>(-limbs.at[k].side);
  const auto swap = [](LimbPair* pair) { *pair = {pair->b, pair->a}; };
  for (int32_t k = 0; k < limbs.pair_count; ++k) swap(&limbs.pairs[k]);
  for (int32_t k = 0; k < leg_count; ++k) swap(&legs[k]);
  for (int32_t k = 0; k < foot_count; ++k) swap(&feet[k]);
  swap(&hip_pair);
}

}  // namespace sinew::mapping
