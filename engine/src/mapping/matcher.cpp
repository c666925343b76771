// SPDX-License-Identifier: MIT
// Trunk against trunk, limbs against limbs; joints of what belongs together in their order.
#include "mapping/matcher.hpp"

namespace sinew::mapping {
namespace {

constexpr double kPairAlone = 0.9, kSingleAlone = 0.7, kOtherAlone = 0.8;  // leaving out costs this, each side
constexpr double kPointLimb = 0.3;
constexpr double kOtherSide = 2;      // a single limb on the other side
constexpr double kContradiction = 1;  // of two joints' names
constexpr double kPin = 40;           // more than anything else that is compared

}  // namespace

bool Matcher::allocate(Arena& arena, uint32_t target_joints, uint32_t source_joints) {
  const auto limbs = [](uint32_t joints) { return joints < kMostSideLimbs ? joints : uint32_t{kMostSideLimbs}; };
  (void)assignment_.allocate(arena, limbs(target_joints), limbs(source_joints));
  (void)aligner_.allocate(arena, target_joints, source_joints);
  rows_ = arena.alloc<int32_t>(kMostSideLimbs);
  columns_ = arena.alloc<int32_t>(kMostSideLimbs);
  ta_ = arena.alloc<double>(size_t{target_joints} + 4);
  tb_ = arena.alloc<double>(size_t{source_joints} + 4);
  ua_ = arena.alloc<double>(size_t{target_joints} + 4);
  ub_ = arena.alloc<double>(size_t{source_joints} + 4);
  fingers_ = arena.alloc<FingerPair>(kMostLimbs);
  used_ = arena.alloc<uint8_t>(source_joints);
  return arena.ok();
}

void Matcher::run(const Anatomy& target, const Anatomy& source, bool names, const Pins& pins, int32_t* sources,
                  double* costs) {
  a_ = &target;
  b_ = &source;
  names_ = names;
  pins_ = &pins;
  sources_ = sources;
  costs_ = costs;
  finger_pairs_ = 0;
  for (int32_t i = 0; i < target.rig->n; ++i) {
    sources[i] = -1;
    costs[i] = 0;
  }
  limb_doubt_ = 0;
  match_trunk();
  match_pairs();
  match_singles();
  match_others();
  match_all_fingers();
  match_ends();
}

void Matcher::put(int32_t i, int32_t j, double cost) {
  if (sources_[i] >= 0) return;
  sources_[i] = j;
  costs_[i] = limb_doubt_ + cost;
}

double Matcher::name_cost(int32_t i, int32_t j) const {
  if (!names_) return 0;
  const JointName &a = a_->rig->names[i], &b = b_->rig->names[j];
  double cost = 0;
  if (a.plain != Part::kNone && b.plain != Part::kNone) {
    const auto is_animal = [](Part w) { return w == Part::kForeLeg || w == Part::kHindLeg; };
    const Part limb = limb_part(a.plain);
    if (a.plain == b.plain) {
      cost -= 0.12;
    } else if (!((limb == Part::kUpperArm || limb == Part::kUpLeg) && limb == limb_part(b.plain) &&
                 (is_animal(a.plain) || is_animal(b.plain)))) {
      cost += contradict(a, b) ? kContradiction : 0.12;
    }
  }
  if (a.is_end_of_map() != b.is_end_of_map()) cost += 0.1;
  return cost - 0.06 * names::overlap(a.hashes, a.count, b.hashes, b.count);
}

double Matcher::pin_cost(int32_t i, int32_t j) const {
  if (!pins_->any) return 0;
  if (pins_->source_of[i] == j) return -kPin;
  return pins_->source_of[i] != Pins::kFree || pins_->target_of[j] != Pins::kFree ? kPin : 0;
}

// Pins between two limbs hold them together, pins to elsewhere keep them apart.
double Matcher::limb_pins(const Limb& a, const Limb& b) const {
  if (!pins_->any) return 0;
  double cost = 0;
  for (int32_t i = 0; i < a.joint_count; ++i) {
    const int32_t j = pins_->source_of[a_->limbs.joint(a, i)];
    if (j < 0) continue;
    bool inside = false;
    for (int32_t k = 0; k < b.joint_count; ++k) inside = inside || b_->limbs.joint(b, k) == j;
    cost += inside ? -kPin : kPin;
  }
  for (int32_t k = 0; k < b.joint_count; ++k) {
    const int32_t i = pins_->target_of[b_->limbs.joint(b, k)];
    if (i < 0) continue;
    bool inside = false;
    for (int32_t m = 0; m < a.joint_count; ++m) inside = inside || a_->limbs.joint(a, m) == i;
    if (!inside) cost += kPin;
  }
  return cost;
}

double Matcher::limb_cost(int32_t la, int32_t lb) const {
  const LimbFeatures &a = a_->features[la], &b = b_->features[lb];
  // The chest is the parent of the arms in both, wherever that joint is.
  const auto has_arm = [](const Anatomy& rig, const LimbFeatures& f) { return f.arm && rig.leg_count > 0; };
  const double farthest = has_arm(*a_, a) && has_arm(*b_, b) ? 0.15 : 1.5;
  // The tail of a fish begins wherever its root lies.
  const bool tails = a_->lying && b_->lying && a_->limb(la).side == 0 && b_->limb(lb).side == 0;
  const bool many_legs = a.rank >= 0 && b.rank >= 0;
  const double apart = many_legs ? 1.2 * absolute(a.rank - b.rank) : lesser(absolute(a.attach - b.attach), farthest);
  double cost = apart * (tails ? 0.3 : 1) + (a.grounded != b.grounded ? 1 : 0) +
                (tails ? 0 : 0.2) * absolute(a.log_tree - b.log_tree);
  if (!a.point && !b.point)  // a limb of one joint has no length and points nowhere
    cost += 0.4 * absolute(a.log_length - b.log_length) + 0.5 * (1 - dot(a.axis, b.axis));
  else
    cost += kPointLimb;
  if (tails && a.point != b.point) cost += 0.5;  // a fin
  if (many_legs) return cost + limb_pins(a_->limb(la), b_->limb(lb));
  if (a.hip != b.hip) cost += 0.8;
  if (a.hip && b.hip) cost -= 0.5;
  if (a.arm && b.arm) cost -= 0.4;
  if (names_) {
    const auto bits = [](uint64_t parts) {
      int32_t n = 0;
      for (; parts != 0; parts &= parts - 1) ++n;
      return n;
    };
    if (a.parts != 0 && b.parts != 0) {
      const int32_t x = bits(a.parts), y = bits(b.parts);
      cost += 0.8 - 1.6 * bits(a.parts & b.parts) / (x < y ? x : y);
    }
    cost -= 0.3 * names::overlap(a_->hashes + a.first_hash, a.hash_count, b_->hashes + b.first_hash, b.hash_count);
  }
  return cost + limb_pins(a_->limb(la), b_->limb(lb));
}

// Chains that mean the same: every joint of the shorter gets one of the longer.
void Matcher::match_in_order(const int32_t* a, int32_t n, const int32_t* b, int32_t m, int32_t base_a, int32_t base_b) {
  if (n <= 0 || m <= 0) return;
  const auto positions = [](const Anatomy& rig, const int32_t* joints, int32_t count, int32_t base, double* out) {
    double sum = 0;
    for (int32_t k = 0; k < count; ++k) {
      sum += rig.rig->bone(k > 0 ? joints[k - 1] : base, joints[k]);
      out[k] = sum;
    }
    for (int32_t k = 0; k < count; ++k) out[k] /= sum > 0 ? sum : 1;
  };
  positions(*a_, a, n, base_a, ua_);
  positions(*b_, b, m, base_b, ub_);
  const auto own_cost = [&](int32_t i, int32_t j) {
    const double x = n == 1 ? 0.5 : static_cast<double>(i) / (n - 1),
                 y = m == 1 ? 0.5 : static_cast<double>(j) / (m - 1);
    return 0.6 * absolute(x - y) + 0.4 * absolute(ua_[i] - ub_[j]) + joint_cost(a[i], b[j]);
  };
  (void)aligner_.run(n, m, 3.0, own_cost);
  for (int32_t i = 0; i < n; ++i) {
    if (aligner_.match[i] >= 0) put(a[i], b[aligner_.match[i]], own_cost(i, aligner_.match[i]));
  }
}

void Matcher::match_trunk() {
  const Anatomy &a = *a_, &b = *b_;
  put(a.hip, b.hip, 0);
  int32_t ha = a.head, hb = b.head;
  if (ha >= 0 && hb >= 0 && a.arms.a >= 0 && b.arms.a >= 0 && !a.quad && !b.quad) {
    // Without names the last joint may be the head's top: take what is alike in both.
    double least = 0;
    bool any = false;
    const int32_t heads_a[2] = {a.head, a.other_head}, heads_b[2] = {b.head, b.other_head};
    for (const int32_t p : heads_a) {
      for (const int32_t q : heads_b) {
        if (p < 0 || q < 0) continue;
        const double cost = 0.2 * (p != a.head) + 0.2 * (q != b.head) +
                            0.6 * absolute(logarithm(greater(a.head_ratio(p), 1e-3) / greater(b.head_ratio(q), 1e-3)));
        if (any && !(cost < least)) continue;
        any = true;
        least = cost;
        ha = p;
        hb = q;
      }
    }
  }
  const auto top_of = [](const Anatomy& rig) {
    int32_t top = rig.rig->parent[rig.hip];
    while (top >= 0 && rig.rig->parent[top] >= 0) top = rig.rig->parent[top];
    return top;
  };
  const int32_t ra = top_of(a), rb = top_of(b);
  if (ra >= 0 && rb >= 0 && a.rig->apart[ra] == b.rig->apart[rb]) put(ra, rb, 0.2);
  // Segments of the two spines between landmarks that both have.
  int32_t from_a = 0, from_b = 0;
  const auto base = [](const Anatomy& rig, int32_t from) { return from > 0 ? rig.spine[from - 1] : rig.hip; };
  const auto up_to = [&](int32_t to_a, int32_t to_b) {
    match_in_order(a.spine + from_a, to_a - from_a, b.spine + from_b, to_b - from_b, base(a, from_a), base(b, from_b));
    from_a = to_a;
    from_b = to_b;
  };
  if (a.chest >= 0 && b.chest >= 0) up_to(a.chest + 1, b.chest + 1);
  if (ha >= 0 && hb >= 0) {
    put(a.spine[ha], b.spine[hb], 0);
    up_to(ha, hb);
    ++from_a;
    ++from_b;
  }
  up_to(a.spine_count, b.spine_count);
}

void Matcher::match_pairs() {
  const Anatomy &a = *a_, &b = *b_;
  assignment_.rows = a.limbs.pair_count;
  assignment_.columns = b.limbs.pair_count;
  for (int32_t i = 0; i < assignment_.rows; ++i) {
    const LimbPair& p = a.limbs.pairs[i];
    for (int32_t j = 0; j < assignment_.columns; ++j) {
      const LimbPair& q = b.limbs.pairs[j];
      assignment_.at(i, j) = 0.5 * (limb_cost(p.a, q.a) + limb_cost(p.b, q.b));
    }
  }
  assignment_.solve(kPairAlone);
  for (int32_t i = 0; i < assignment_.rows; ++i) {
    const int32_t j = assignment_.match[i];
    if (j < 0) continue;
    const LimbPair &p = a.limbs.pairs[i], &q = b.limbs.pairs[j];
    match_limbs(p.a, q.a, a.hip_pair.a == p.a, a.arms.a == p.a, assignment_.at(i, j));
    match_limbs(p.b, q.b, a.hip_pair.b == p.b, a.arms.b == p.b, assignment_.at(i, j));
  }
}

void Matcher::match_singles() {
  const auto gather = [](const Anatomy& rig, int32_t* list) {
    int32_t n = 0;
    for (int32_t k = 0; k < rig.side_limbs; ++k) {
      if (rig.limb(k).mate < 0) list[n++] = k;
    }
    return n;
  };
  assignment_.rows = gather(*a_, rows_);
  assignment_.columns = gather(*b_, columns_);
  for (int32_t i = 0; i < assignment_.rows; ++i) {
    for (int32_t j = 0; j < assignment_.columns; ++j) {
      assignment_.at(i, j) =
          limb_cost(rows_[i], columns_[j]) + (a_->limb(rows_[i]).side != b_->limb(columns_[j]).side ? kOtherSide : 0);
    }
  }
  assignment_.solve(kSingleAlone);
  for (int32_t i = 0; i < assignment_.rows; ++i) {
    const int32_t j = assignment_.match[i];
    if (j >= 0) match_limbs(rows_[i], columns_[j], false, false, assignment_.at(i, j));
  }
}

void Matcher::match_others() {
  assignment_.rows = a_->others_count;
  assignment_.columns = b_->others_count;
  for (int32_t i = 0; i < assignment_.rows; ++i) {
    const int32_t la = a_->others_first + i;
    for (int32_t j = 0; j < assignment_.columns; ++j) {
      const int32_t lb = b_->others_first + j;
      assignment_.at(i, j) = limb_cost(la, lb) + (sources_[a_->limb(la).attach] == b_->limb(lb).attach ? 0 : 0.3);
    }
  }
  assignment_.solve(kOtherAlone);
  for (int32_t i = 0; i < assignment_.rows; ++i) {
    const int32_t j = assignment_.match[i];
    if (j >= 0) match_limbs(a_->others_first + i, b_->others_first + j, false, false, assignment_.at(i, j));
  }
}

// An end marker goes to the only free leaf below its parent's source.
void Matcher::match_ends() {
  const Hierarchy &a = *a_->rig, &b = *b_->rig;
  for (int32_t j = 0; j < b.n; ++j) used_[j] = 0;
  for (int32_t i = 0; i < a.n; ++i) {
    if (sources_[i] >= 0) used_[sources_[i]] = 1;
  }
  for (int32_t k = 0; k < a.n; ++k) {
    const int32_t i = a.order[k], p = a.parent[i];
    if (a.end[i] == 0 || sources_[i] >= 0 || p < 0 || sources_[p] < 0) continue;
    int32_t leaves = 0, leaf = -1;
    each_kid(b, sources_[p], [&](int32_t j) {
      if (used_[j] != 0 || b.kid_count(j) > 0) return;
      ++leaves;
      leaf = j;
    });
    if (leaves != 1) continue;
    limb_doubt_ = costs_[p];
    put(i, leaf, 0.1);
    used_[leaf] = 1;
  }
}

}  // namespace sinew::mapping
