// SPDX-License-Identifier: MIT
// Matches branches of paired limbs: fingers by their order from the thumb, their joints by the distance from the
// wrist.
#include "core/eigenpairs.hpp"
#include "mapping/matcher.hpp"

namespace sinew::mapping {
namespace {

constexpr double kFingerAlone = 0.9;
constexpr int32_t kFingerJoints = 3;

// The direction in which points spread most: the eigenvector of their covariance.
Point main_axis(const Point* points, int32_t count) {
  Point mean;
  for (int32_t k = 0; k < count; ++k) mean = mean + points[k];
  mean = (1.0 / count) * mean;
  double m[9] = {}, v[9];
  for (int32_t k = 0; k < count; ++k) {
    const Point d = points[k] - mean;
    const double c[3] = {d.x, d.y, d.z};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m[3 * i + j] += c[i] * c[j];
    }
  }
  find_eigenpairs(3, m, v);
  const int best = m[0] >= m[4] && m[0] >= m[8] ? 0 : m[4] >= m[8] ? 1 : 2;
  return {v[best], v[3 + best], v[6 + best]};
}

// Index of finger k of n, the thumb aside: with two of them one is at either end, three lack the last but one.
double finger_position(int32_t k, int32_t n) {
  if (n == 1) return 0;
  if (n == 3) return k == 0 ? 0 : k == 1 ? 0.4 : 0.9;
  return static_cast<double>(k) / (n - 1);
}

Part finger_word(const Anatomy& rig, int32_t finger) {
  const Limb& limb = rig.limb(finger);
  for (int32_t k = 0; k < limb.joint_count; ++k) {
    const Part w = rig.rig->part(rig.limbs.joint(limb, k));
    if (is_finger(w)) return w;
  }
  return Part::kNone;
}

// Branches of a limb. Where two fingers share a bone of the palm, as ring and little finger of some captures do, it
// is they that count. Returns how many there are.
int32_t gather_fingers(const Anatomy& rig, const Limb& limb, int32_t* list) {
  int32_t count = 0;
  rig.limbs.each_sub(limb, [&](int32_t t) {
    const Limb& palm = rig.limb(t);
    int32_t fingers[kMostFingers], shared = 0;
    rig.limbs.each_end_sub(palm, [&](int32_t u) {
      if (rig.limb(u).joint_count >= kFingerJoints && shared < kMostFingers) fingers[shared++] = u;
    });
    if (palm.joint_count > 1 || shared < 2) fingers[0] = t, shared = 1;
    for (int32_t k = 0; k < shared && count < kMostFingers; ++k) list[count++] = fingers[k];
  });
  return count;
}

}  // namespace

// Takes the twist joints out of two limbs' lists, and puts those side by side that lie on bones which represent each other.
void Matcher::match_twists(const Limb& a, const Limb& b, int32_t* fa, int32_t* na, int32_t* fb, int32_t* nb) {
  int32_t ta[kMostFingers], tb[kMostFingers];
  const auto part = [](const Anatomy& rig, const Limb& limb, int32_t* fingers, int32_t* count, int32_t* twists) {
    int32_t kept = 0, out = 0;
    for (int32_t k = 0; k < *count; ++k)
      (rig.limbs.is_twist(limb, fingers[k]) ? twists[out++] : fingers[kept++]) = fingers[k];
    *count = kept;
    return out;
  };
  const int32_t ca = part(*a_, a, fa, na, ta), cb = part(*b_, b, fb, nb, tb);
  for (int32_t i = 0; i < ca; ++i) {
    for (int32_t j = 0; j < cb; ++j) {
      if (tb[j] < 0 || sources_[a_->limb(ta[i]).attach] != b_->limb(tb[j]).attach) continue;
      match_finger(ta[i], tb[j], a, b);
      tb[j] = -1;
      break;
    }
  }
}

void Matcher::match_all_fingers() {
  for (int32_t k = 0; k < finger_pairs_; ++k) {  // the count grows in the loop
    const Limb &a = a_->limb(fingers_[k].a), &b = b_->limb(fingers_[k].b);
    int32_t fa[kMostFingers], fb[kMostFingers];
    int32_t na = gather_fingers(*a_, a, fa), nb = gather_fingers(*b_, b, fb);
    match_twists(a, b, fa, &na, fb, &nb);
    if (na >= 2 && nb >= 2) {
      match_hand(a, b, fa, na, fb, nb);
      continue;
    }
    assignment_.rows = na;
    assignment_.columns = nb;
    for (int32_t i = 0; i < na; ++i) {
      for (int32_t j = 0; j < nb; ++j) assignment_.at(i, j) = limb_cost(fa[i], fb[j]);
    }
    assignment_.solve(kFingerAlone);
    for (int32_t i = 0; i < na; ++i) {
      if (assignment_.match[i] >= 0) match_finger(fa[i], fb[assignment_.match[i]], a, b);
    }
  }
}

// Fingers without the thumb, from its side on. Returns how many there are.
int32_t Matcher::sort_fingers(const Anatomy& rig, const Limb& limb, int32_t* fingers, int32_t count,
                              int32_t thumb) const {
  (void)limb;
  int32_t n = 0;
  for (int32_t k = 0; k < count; ++k) {
    if (fingers[k] != thumb) fingers[n++] = fingers[k];
  }
  if (n <= 1) return n;
  Point points[kMostFingers], mean;
  for (int32_t k = 0; k < n; ++k) {
    const Limb& f = rig.limb(fingers[k]);
    points[k] = 0.5 * (rig.limbs.point(f, f.joint_count > 1 ? 1 : 0) + rig.limbs.point(f, 0));
    mean = mean + points[k];
  }
  mean = (1.0 / n) * mean;
  Point axis = main_axis(points, n);
  const Limb& t = rig.limb(thumb);
  if (dot(rig.at(rig.limbs.last_joint(t)) - mean, axis) > 0) axis = -axis;
  double position[kMostFingers];
  for (int32_t k = 0; k < n; ++k) {  // stable
    const double own = dot(points[k] - mean, axis);
    const int32_t finger = fingers[k];
    int32_t at = k;
    for (; at > 0 && position[at - 1] > own; --at) {
      position[at] = position[at - 1];
      fingers[at] = fingers[at - 1];
    }
    position[at] = own;
    fingers[at] = finger;
  }
  return n;
}

void Matcher::match_hand(const Limb& a, const Limb& b, const int32_t* fa, int32_t na, const int32_t* fb, int32_t nb) {
  int32_t ra[kMostFingers], rb[kMostFingers];
  int32_t ca = 0, cb = 0;
  int32_t thumb_a = a_->thumb(a, fa, na), thumb_b = b_->thumb(b, fb, nb);
  if (names_) {
    constexpr int kWords = static_cast<int>(names::kLastFinger) - static_cast<int>(names::kFirstFinger) + 1;
    const auto by_word = [](const Anatomy& rig, const int32_t* list, int32_t n, int32_t* of) {
      for (int w = 0; w < kWords; ++w) of[w] = -1;
      for (int32_t k = 0; k < n; ++k) {
        const Part w = finger_word(rig, list[k]);
        if (w != Part::kNone) of[static_cast<int>(w) - static_cast<int>(names::kFirstFinger)] = list[k];
      }
    };
    int32_t of_a[kWords], of_b[kWords];
    by_word(*a_, fa, na, of_a);
    by_word(*b_, fb, nb, of_b);
    bool common = false;
    for (int w = 0; w < kWords; ++w) {
      if (of_a[w] < 0 || of_b[w] < 0) continue;
      common = true;
      match_finger(of_a[w], of_b[w], a, b);
    }
    if (common) {  // the rest in their order
      if (of_a[0] >= 0) thumb_a = of_a[0];
      if (of_b[0] >= 0) thumb_b = of_b[0];
      const auto rest = [&](const Anatomy& rig, const int32_t* list, int32_t n, const int32_t* own,
                            const int32_t* other, int32_t thumb, int32_t* out) {
        int32_t count = 0;
        for (int32_t k = 0; k < n; ++k) {
          const int w = static_cast<int>(finger_word(rig, list[k])) - static_cast<int>(names::kFirstFinger);
          const bool done = w >= 0 && w < kWords && own[w] == list[k] && other[w] >= 0;
          if (!done && w != 0) out[count++] = list[k];
        }
        return sort_fingers(rig, a, out, count, thumb);
      };
      ca = rest(*a_, fa, na, of_a, of_b, thumb_a, ra);
      cb = rest(*b_, fb, nb, of_b, of_a, thumb_b, rb);
      for (int32_t k = 0; k < ca && k < cb; ++k) match_finger(ra[k], rb[k], a, b);
      return;
    }
  }
  match_finger(thumb_a, thumb_b, a, b);
  for (int32_t k = 0; k < na; ++k) ra[k] = fa[k];
  for (int32_t k = 0; k < nb; ++k) rb[k] = fb[k];
  ca = sort_fingers(*a_, a, ra, na, thumb_a);
  cb = sort_fingers(*b_, b, rb, nb, thumb_b);
  (void)aligner_.run(ca, cb, 3.0,
                     [&](int32_t i, int32_t j) { return absolute(finger_position(i, ca) - finger_position(j, cb)); });
  // match_finger() aligns joints with the same table: keep the fingers' own.
  int32_t match[kMostFingers];
  for (int32_t i = 0; i < ca; ++i) match[i] = aligner_.match[i];
  for (int32_t i = 0; i < ca; ++i) {
    if (match[i] >= 0) match_finger(ra[i], rb[match[i]], a, b);
  }
}

// Joints of two fingers by their distance from the wrist, whatever their size.
void Matcher::match_finger(int32_t x, int32_t y, const Limb& a, const Limb& b) {
  const Limb &fx = a_->limb(x), &fy = b_->limb(y);
  const int32_t n = fx.joint_count, m = fy.joint_count;
  if (n == m) {
    for (int32_t i = 0; i < n; ++i) put(a_->limbs.joint(fx, i), b_->limbs.joint(fy, i), 0.1);
  } else {
    // In shares of the limb's length up to the hand, so that a finger whose last joints are missing stays short.
    const auto positions = [](const Anatomy& rig, const Limb& f, const Limb& hand, double* out) {
      const Point wrist = rig.wrist(hand);
      add_up_lengths(rig.limbs.points + f.first_point, f.joint_count, wrist, out);
      double whole = 0;
      for (int32_t k = 1; k < hand.joint_count; ++k)
        whole += distance(rig.limbs.point(hand, k - 1), rig.limbs.point(hand, k));
      return whole;
    };
    const double arm_a = positions(*a_, fx, a, ua_), arm_b = positions(*b_, fy, b, ub_);
    const bool known = arm_a > 1e-9 && arm_b > 1e-9;
    const double size_a = known ? root(arm_a * ua_[n - 1]) : ua_[n - 1],
                 size_b = known ? root(arm_b * ub_[m - 1]) : ub_[m - 1];
    for (int32_t k = 0; k < n; ++k) ua_[k] /= greater(size_a, 1e-9);
    for (int32_t k = 0; k < m; ++k) ub_[k] /= greater(size_b, 1e-9);
    const double whole = greater(greater(ua_[n - 1], ub_[m - 1]), 1e-9);
    for (int32_t k = 0; k < n; ++k) ua_[k] /= whole;
    for (int32_t k = 0; k < m; ++k) ub_[k] /= whole;
    constexpr double kScales[] = {0.6, 0.7, 0.8, 0.9, 1, 1.12, 1.25, 1.45, 1.7};
    double least = 0, best = 0;
    const auto cost = [&](double scale, int32_t i, int32_t j) {
      return absolute(ua_[i] * scale - ub_[j]) + joint_cost(a_->limbs.joint(fx, i), b_->limbs.joint(fy, j));
    };
    for (const double scale : kScales) {
      const double sum = aligner_.fill(n, m, 0.5, [&](int32_t i, int32_t j) { return cost(scale, i, j); }) +
                         0.3 * absolute(logarithm(scale));
      if (best > 0 && !(sum < least - 1e-9)) continue;
      least = sum;
      best = scale;
    }
    (void)aligner_.run(n, m, 0.5, [&](int32_t i, int32_t j) { return cost(best, i, j); });
    for (int32_t i = 0; i < n; ++i) {
      const int32_t j = aligner_.match[i];
      if (j >= 0) put(a_->limbs.joint(fx, i), b_->limbs.joint(fy, j), 0.1 + cost(best, i, j));
    }
  }
  if (fx.first_sub >= 0 && fy.first_sub >= 0 && finger_pairs_ < kMostLimbs) fingers_[finger_pairs_++] = {x, y};
}

}  // namespace sinew::mapping
