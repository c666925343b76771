// SPDX-License-Identifier: MIT
// Joints of two limbs side by side: arms and legs by the ends of their long bones, others by their length along the
// limb.
#include "mapping/matcher.hpp"

namespace sinew::mapping {
namespace {

constexpr double kBranch = 0.4;
constexpr int32_t kMostStarts = 4, kMostPoints = 64;  // points of a limb that may be landmarks

}  // namespace

//   t  out  [points + 2] along the limb: arms by their length, legs by how far they descend
void Matcher::find_landmarks(const Anatomy& rig, int32_t number, bool leg, double* t, Landmarks* found) const {
  const Limb& limb = rig.limb(number);
  const Point& up = rig.frame.up;
  const auto point = [&](int32_t k) -> const Point& { return rig.limbs.point(limb, k); };
  const int32_t joints = limb.joint_count, real = limb.point_count;
  const int32_t subs = rig.limbs.end_subs(limb);
  // Where fingers or toes branch off before the chain's end: a hand or foot.
  int32_t branch = -1;
  rig.limbs.each_sub(limb, [&](int32_t sub) {
    if (rig.limbs.is_twist(limb, sub)) return;
    for (int32_t k = 2; k + 1 < joints; ++k) {
      if (rig.limbs.joint(limb, k) == rig.limb(sub).attach && k > branch) branch = k;
    }
  });
  t[0] = 0;
  for (int32_t k = 1; k < real; ++k) {
    const double path = distance(point(k - 1), point(k));
    t[k] = t[k - 1] + (leg ? greater(dot(point(k - 1) - point(k), up), 0.02 * path) : path);
  }
  int32_t n = real;
  if (subs == 0 || real < 3) {  // the end of the last long bone may be no joint
    if (leg) {
      t[n] = greater(t[n - 1] + 1e-6, dot(point(0), up) - rig.ground);
    } else {
      t[n] = t[n - 1] + (real >= 2 ? t[n - 1] - t[n - 2] : 0.3 * rig.trunk);
    }
    ++n;
  }
  if (n < 3) {
    t[n] = t[n - 1] > 0 ? 2 * t[n - 1] : 1;
    ++n;
  }
  const double whole = real > 2 ? t[real - 1] : t[n - 1];
  const auto off = [&](int32_t k) { return absolute(dot(point(k), rig.frame.across) - rig.frame.plane); };
  const auto word = [&](int32_t k) { return k < joints ? rig.rig->part(rig.limbs.joint(limb, k)) : Part::kNone; };
  const int32_t most = n < kMostPoints ? n : kMostPoints;
  found->count = 0;
  for (int32_t a = 0; a < most - 2 && a < kMostStarts; ++a) {
    for (int32_t b = a + 1; b < most - 1; ++b) {
      for (int32_t c = b + 1; c < most; ++c) {
        const double u = t[b] - t[a], v = t[c] - t[b];
        if (u < 1e-9 || v < 1e-9) continue;
        double score = 1.5 * absolute(logarithm(u / v)) - 2.5 * lesser((u + v) / greater(whole, 1e-9), 1);
        if (c == joints - 1) score -= subs >= 2 || (real > joints && branch < 0) ? 0.4 : 0.1;
        if (c == branch) score -= kBranch;
        if (c >= real) {
          score += 0.5;
        } else if (c >= joints) {
          score += 0.3;
        }
        score += 0.25 * (c - a - 2);
        score += greater(0, (t[a] - t[0]) / greater(whole, 1e-9) - 0.3);
        // A clavicle leads outwards; what already begins out there is the upper arm.
        if (!leg && !rig.frame.posed && a > 0 && t[a] - t[0] > 0.06 * whole)
          score += 1.5 * greater(0, 0.5 - (off(a) - off(0)) / (t[a] - t[0]));
        // Among joints at one position the last begins the bone, the first ends it.
        if (a + 1 < b && t[a + 1] - t[a] < 0.06 * whole) score += 0.4;
        if (c - 1 > b && t[c] - t[c - 1] < 0.03 * whole) score += 0.4;
        if (leg && c < real && dot(point(c - 1) - point(c), up) < 0.6 * distance(point(c - 1), point(c))) score += 0.8;
        if (b < real && !rig.frame.posed) score += greater(0, 0.3 - off(a) / greater(off(b), 1e-9)) / 0.3;
        if (names_) {
          const auto one_of = [](Part w, Part x, Part y) { return w == x || w == y ? 1 : 0; };
          score -= 0.8 * (one_of(word(a), Part::kUpperArm, Part::kUpLeg) +
                          one_of(word(b), Part::kLowerArm, Part::kLowLeg) + one_of(word(c), Part::kHand, Part::kFoot));
          const auto second = [&](int32_t k) {
            return k < joints && rig.rig->names[rig.limbs.joint(limb, k)].number == 2;
          };
          score += 0.4 * (second(a) + second(b));
        }
        const Landmark one = {rounded(score), a, b, c};
        if (found->count == kMostLandmarks && !one.before(found->at[kMostLandmarks - 1])) continue;
        int at = found->count < kMostLandmarks ? found->count++ : kMostLandmarks - 1;
        for (; at > 0 && one.before(found->at[at - 1]); --at) found->at[at] = found->at[at - 1];
        found->at[at] = one;
      }
    }
  }
}

// Both sides are decided together: by the mean of their scores.
//   t      out  as of find_landmarks()
//   other  scratch of the same size
void Matcher::find_pair_landmarks(const Anatomy& rig, int32_t number, bool leg, double* t, double* other,
                                  Landmarks* found) const {
  find_landmarks(rig, number, leg, t, found);
  const int32_t mate = rig.limb(number).mate;
  if (mate < 0 || rig.limb(mate).joint_count != rig.limb(number).joint_count ||
      rig.limb(mate).point_count != rig.limb(number).point_count) {
    return;
  }
  Landmarks image;
  find_landmarks(rig, mate, leg, other, &image);
  for (int k = 0; k < found->count && image.count > 0; ++k) {
    Landmark& own = found->at[k];
    int64_t score = image.at[image.count - 1].score;  // at least as bad, where it is not among the best
    for (int m = 0; m < image.count; ++m) {
      const Landmark& its = image.at[m];
      if (its.a == own.a && its.b == own.b && its.c == own.c) score = its.score;
    }
    own.score = (own.score + score) / 2;
  }
}

// Position of every joint: below 1 before the first landmark, 1..2 and 2..3 on the two long bones, beyond 3 the rest.
void Matcher::long_bone_positions(const Anatomy& rig, const Limb& limb, const double* t, const Landmark& at,
                                  double* positions) {
  double path = 0, distance_a = 0, distance_c = 0;
  for (int32_t k = 0; k < limb.joint_count; ++k) {
    if (k > 0) path += distance(rig.limbs.point(limb, k - 1), rig.limbs.point(limb, k));
    if (k == at.a) distance_a = path;
    if (k == at.c) distance_c = path;
    if (k < at.a) {
      positions[k] = 0.3 + 0.6 * k / at.a;
    } else if (k <= at.b) {
      positions[k] = 1 + (t[k] - t[at.a]) / greater(t[at.b] - t[at.a], 1e-9);
    } else if (k <= at.c) {
      positions[k] = 2 + (t[k] - t[at.b]) / greater(t[at.c] - t[at.b], 1e-9);
    } else {
      // A joint on the same spot comes after the landmark.
      positions[k] = 3 + 0.02 * (k - at.c) + (path - distance_c) / greater(0.5 * (distance_c - distance_a), 1e-9);
    }
  }
}

void Matcher::match_limbs(int32_t la, int32_t lb, bool leg, bool arm, double cost) {
  const Limb &a = a_->limb(la), &b = b_->limb(lb);
  const int32_t n = a.joint_count, m = b.joint_count;
  const auto joint_a = [&](int32_t i) { return a_->limbs.joint(a, i); };
  const auto joint_b = [&](int32_t j) { return b_->limbs.joint(b, j); };
  limb_doubt_ = greater(0, cost);
  Landmarks ma, mb;
  if ((leg || arm) && !a_->quad && !b_->quad) {
    find_pair_landmarks(*a_, la, leg, ta_, ua_, &ma);
    find_pair_landmarks(*b_, lb, leg, tb_, ub_, &mb);
  }
  if (ma.count > 0 && mb.count > 0) {
    // Both at once: the same pattern of joints is preferred.
    int best_a = 0, best_b = 0;
    double least = 0;
    for (int p = 0; p < ma.count; ++p) {
      const Landmark& x = ma.at[p];
      for (int q = 0; q < mb.count; ++q) {
        const Landmark& y = mb.at[q];
        const auto apart = [](int32_t i, int32_t j) { return i < j ? j - i : i - j; };
        const double sum = 1e-9 * static_cast<double>(x.score) + 1e-9 * static_cast<double>(y.score) +
                           0.35 * apart(x.a, y.a) + 0.08 * apart(x.b - x.a, y.b - y.a) +
                           0.08 * apart(x.c - x.b, y.c - y.b) + ((x.c < n) != (y.c < m) ? 0.3 : 0);
        if (p + q > 0 && !(sum < least - 1e-12)) continue;
        least = sum;
        best_a = p;
        best_b = q;
      }
    }
    long_bone_positions(*a_, a, ta_, ma.at[best_a], ua_);
    long_bone_positions(*b_, b, tb_, mb.at[best_b], ub_);
    const auto own_cost = [&](int32_t i, int32_t j) {
      return absolute(ua_[i] - ub_[j]) + joint_cost(joint_a(i), joint_b(j));
    };
    (void)aligner_.run(n, m, 0.3, own_cost);
    for (int32_t i = 0; i < n; ++i) {
      const int32_t j = aligner_.match[i];
      if (j >= 0) put(joint_a(i), joint_b(j), own_cost(i, j));
    }
  } else {
    // A chain in the plane begins at its parent.
    const auto positions = [](const Anatomy& rig, const Limb& limb, double* out) {
      const Point* const points = rig.limbs.points + limb.first_point;
      add_up_lengths(points, limb.point_count, limb.attach >= 0 && limb.side == 0 ? rig.at(limb.attach) : points[0],
                     out);
      const double whole = out[limb.point_count - 1];
      for (int32_t k = 0; k < limb.point_count; ++k) out[k] /= whole > 0 ? whole : 1;
    };
    positions(*a_, a, ua_);
    positions(*b_, b, ub_);
    const auto own_cost = [&](int32_t i, int32_t j) {
      return 0.5 * absolute(ua_[i] - ub_[j]) +
             0.5 *
                 absolute(static_cast<double>(i) / (n > 1 ? n - 1 : 1) - static_cast<double>(j) / (m > 1 ? m - 1 : 1)) +
             joint_cost(joint_a(i), joint_b(j));
    };
    (void)aligner_.run(n, m, 3.0, own_cost);
    for (int32_t i = 0; i < n; ++i) {
      const int32_t j = aligner_.match[i];
      if (j >= 0) put(joint_a(i), joint_b(j), own_cost(i, j));
    }
  }
  if (a.first_sub >= 0 && b.first_sub >= 0 && finger_pairs_ < kMostLimbs) fingers_[finger_pairs_++] = {la, lb};
}

}  // namespace sinew::mapping
