// SPDX-License-Identifier: MIT
// Finds the pairs of limbs that are legs, feet with other parents, and the joint that carries the legs.
#include "mapping/anatomy.hpp"

namespace sinew::mapping {

double Anatomy::low(const LimbPair& pair) const {
  double least = lesser(limbs.lowest(limb(pair.a), frame.up), limbs.lowest(limb(pair.b), frame.up));
  for (int s = 0; s < 2; ++s) {  // toes
    limbs.each_end_sub(limb(pair.of(s)),
                       [&](int32_t toe) { least = lesser(least, limbs.lowest(limb(toe), frame.up)); });
  }
  return least;
}

// As low(), where a last bone whose end is no joint goes on by half its length.
double Anatomy::low_end(const LimbPair& pair) const {
  double least = low(pair);
  for (int s = 0; s < 2; ++s) {
    const Limb& leg = limb(pair.of(s));
    if (leg.point_count < 2 || leg.point_count > leg.joint_count || leg.first_sub >= 0) continue;
    const double end = dot(limbs.last_point(leg), frame.up);
    const double bone = dot(limbs.point(leg, leg.point_count - 2), frame.up) - end;
    if (bone > 0) least = lesser(least, greater(ground, end - 0.5 * bone));
  }
  return least;
}

double Anatomy::drop(const LimbPair& pair) const {
  double top = dot(limbs.point(limb(pair.a), 0), frame.up);
  for (int s = 0; s < 2; ++s) {  // a spider's legs go up first
    const Limb& leg = limb(pair.of(s));
    for (int32_t k = 0; k < leg.point_count; ++k) top = greater(top, dot(limbs.point(leg, k), frame.up));
  }
  return top - low(pair);
}

double Anatomy::start_height(const LimbPair& pair) const {
  return 0.5 * dot(limbs.point(limb(pair.a), 0) + limbs.point(limb(pair.b), 0), frame.up);
}

int32_t Anatomy::common_attach(const LimbPair& pair) const {
  const int32_t a = limb(pair.a).attach, b = limb(pair.b).attach;
  const int32_t both = rig->common(a >= 0 ? a : rig->first_root(), b >= 0 ? b : rig->first_root());
  return both >= 0 ? both : rig->first_root();
}

void Anatomy::find_legs() {
  ground = height[rig->first_of_body()];
  double top = ground;
  for (int32_t i = 0; i < rig->n; ++i) {
    if (rig->apart[i] != 0) continue;
    ground = lesser(ground, height[i]);
    top = greater(top, height[i]);
  }
  tall = greater(top - ground, 1e-9);
  find_pairs_on_ground();
  if (leg_count > 1) {  // IK feet: short pairs that begin near the ground are no legs of their own
    const auto both = [&](const LimbPair& p) { return limb(p.a).length + limb(p.b).length; };
    double longest = 0;
    for (int32_t k = 0; k < leg_count; ++k) longest = greater(longest, both(legs[k]));
    int32_t kept = 0;
    for (int32_t k = 0; k < leg_count; ++k) {
      if (both(legs[k]) >= (start_height(legs[k]) < ground + 0.25 * tall ? 0.35 : 0.25) * longest) {
        legs[kept++] = legs[k];
      }
    }
    leg_count = kept;
    leave_out_arms();
  }
  join_feet();
  find_hip();
}

// Arms that hang down to the ground: they begin high above other legs, not before or behind them.
void Anatomy::leave_out_arms() {
  int32_t kept = 0;
  for (int32_t k = 0; k < leg_count; ++k) {
    bool hangs = false;
    for (int32_t m = 0; m < leg_count; ++m) {
      hangs = hangs || (start_height(legs[k]) > start_height(legs[m]) + 0.2 * tall &&
                        absolute(pair_ahead(legs[k]) - pair_ahead(legs[m])) < 0.15 * rig->size);
    }
    if (hangs) continue;
    const LimbPair leg = legs[k];
    legs[k] = legs[kept];
    legs[kept++] = leg;
  }
  leg_count = kept;
}

// Fills legs and feet.
void Anatomy::find_pairs_on_ground() {
  const double size = rig->size;
  const LimbPair* const pairs = limbs.pairs;
  leg_count = foot_count = 0;
  int32_t few = 0;
  for (int32_t k = 0; k < limbs.pair_count; ++k) {
    const LimbPair& p = pairs[k];
    const bool near_ground = low_end(p) < ground + greater(0.15 * tall, 0.05 * size);
    if (near_ground) feet[foot_count++] = p;
    if (near_ground && drop(p) > 0.12 * tall && drop(p) > 0.06 * size) legs[leg_count++] = p;
    few += limb(p.a).joint_count == 1 && limb(p.b).joint_count == 1 ? 1 : 0;
  }
  if (leg_count == 1 && tall <= 0.3 * size && drop(legs[0]) <= (limb(legs[0].a).joint_count <= 2 ? 0.2 : 0.1) * size)
    leg_count = 0;  // fins under a flat body
  if (leg_count == 0 && (tall > 0.3 * size || few >= 2)) find_short_legs();
}

// Whether all of several pairs that seem to be legs begin at one position along the body: belly fins.
bool Anatomy::are_fins() const {
  for (int32_t k = 1; k < leg_count; ++k) {
    if (absolute(pair_ahead(legs[k]) - pair_ahead(legs[0])) > 0.1 * rig->size) return false;
  }
  return true;
}

// Legs of one joint or two: the lowest pairs.
void Anatomy::find_short_legs() {
  const LimbPair* const pairs = limbs.pairs;
  const int32_t pair_count = limbs.pair_count;
  const auto short_leg = [&](const LimbPair& p) {
    const Limb& a = limb(p.a);
    return a.joint_count <= 2 && limb(p.b).joint_count <= 2 &&
           dot(limbs.point(a, 0) - limbs.last_point(a), frame.up) >= 0;
  };
  double least = 0;
  bool any = false;
  for (int32_t k = 0; k < pair_count; ++k) {
    if (!short_leg(pairs[k])) continue;
    least = any ? lesser(least, low(pairs[k])) : low(pairs[k]);
    any = true;
  }
  if (!any || !(least < ground + 0.5 * tall)) return;
  for (int32_t k = 0; k < pair_count; ++k) {
    if (short_leg(pairs[k]) && low(pairs[k]) < least + greater(0.12 * tall, 0.06 * rig->size)) {
      legs[leg_count++] = pairs[k];
    }
  }
  if (leg_count > 1 && are_fins()) leg_count = 0;
  if (leg_count != 1 || limb(legs[0].a).joint_count != 1) return;
  // Feet alone under the root: the legs above them.
  const Point& foot = limbs.point(limb(legs[0].a), 0);
  double nearest = 0;
  int32_t best = -1;
  for (int32_t k = 0; k < pair_count; ++k) {
    const Limb& q = limb(pairs[k].a);
    if (pairs[k].a == legs[0].a || q.joint_count < 2 ||
        !(dot(limbs.point(q, 0) - limbs.last_point(q), frame.up) > 0.2 * q.length)) {
      continue;
    }
    const double d = distance(limbs.last_point(q), foot);
    if (best < 0 || d < nearest) {
      nearest = d;
      best = k;
    }
  }
  if (best >= 0) legs[0] = pairs[best];
}

// The joint where the highest legs begin; without legs the first joint on the plane that branches.
void Anatomy::find_hip() {
  hip_pair = LimbPair();
  hip = -1;
  if (leg_count > 0) {
    int32_t best = 0;
    for (int32_t k = 1; k < leg_count; ++k) {
      if (rig->depth[common_attach(legs[k])] < rig->depth[common_attach(legs[best])]) best = k;
    }
    hip_pair = legs[best];
    hip = common_attach(hip_pair);
    climb_to_trunk();
    return;
  }
  for (int32_t k = 0; k < rig->n && hip < 0; ++k) {
    if (side[rig->order[k]] == 0 && rig->kid_count(rig->order[k]) >= 2) hip = rig->order[k];
  }
  for (int32_t k = 0; k < rig->n && hip < 0; ++k) {
    if (side[rig->order[k]] == 0) hip = rig->order[k];
  }
  if (hip < 0) hip = rig->first_root();
}

// A pelvis that carries the legs, perhaps a tail, and is a sibling of the spine: the hips are what carries both.
void Anatomy::climb_to_trunk() {
  const Hierarchy& r = *rig;
  const auto leads_on = [&](int32_t joint, int32_t but) {  // to a torso with limbs: how many joints these have
    int32_t joints = 0;
    each_kid(r, joint, [&](int32_t kid) {
      if (kid == but || side[kid] != 0 || r.end[kid] != 0) return;
      for (int32_t k = 0; k < limbs.pair_count; ++k) {
        const int32_t attach = limb(limbs.pairs[k].a).attach;
        if (attach >= 0 && (attach == kid || r.holds(kid, attach))) joints += limb(limbs.pairs[k].a).tree;
      }
    });
    return joints;
  };
  int32_t central = 0;
  each_kid(r, hip, [&](int32_t kid) { central += side[kid] == 0 && r.end[kid] == 0 ? 1 : 0; });
  const int32_t own = leads_on(hip, -1);
  if (own > 0) {  // to a tail with feathers, where a joint on the same spot leads to more
    const int32_t above = r.parent[hip];
    if (above >= 0 && side[above] == 0 && r.bone(above, hip) < 0.01 * r.size && leads_on(above, hip) > own) hip = above;
    return;
  }
  // With something in the plane of its own, which may be a tail, it yields only to a joint at the same position.
  const double near = central > 0 && !quad ? 0.05 * r.size : r.size;
  int32_t from = hip;
  for (int32_t up = r.parent[hip]; up >= 0 && side[up] == 0; up = r.parent[up]) {
    if (leads_on(up, from) > 0) {
      if (r.bone(up, hip) <= near) hip = up;
      return;
    }
    from = up;
  }
  if (central == 0) climb_to_chest();
}

// A rig that begins at the chest: only legs are children of the pelvis; arms and head are children of its parent.
void Anatomy::climb_to_chest() {
  const Hierarchy& r = *rig;
  int32_t from = hip;
  bool arms_passed = false;
  for (int32_t up = r.parent[hip]; up >= 0 && side[up] == 0; up = r.parent[up]) {
    bool neck = false;
    each_kid(r, up, [&](int32_t kid) { neck = neck || (kid != from && side[kid] == 0 && r.end[kid] == 0); });
    for (int32_t k = 0; k < limbs.pair_count; ++k) {
      arms_passed = arms_passed || (limb(limbs.pairs[k].a).attach == up && !is_leg(limbs.pairs[k].a));
    }
    if (neck && arms_passed && height[up] > ground + 0.2 * tall) {
      hip = up;
      return;
    }
    from = up;
  }
}

// Feet below an IK root continue a leg at its end.
void Anatomy::join_feet() {
  int32_t kept = 0;
  for (int32_t f = 0; f < foot_count; ++f) {
    const LimbPair foot = feet[f];
    int32_t best = -1;
    double nearest = 0;
    for (int32_t k = 0; k < leg_count && !is_leg(foot.a); ++k) {
      const LimbPair& leg = legs[k];
      const double gap = distance(limbs.last_point(limb(leg.a)), limbs.point(limb(foot.a), 0)) +
                         distance(limbs.last_point(limb(leg.b)), limbs.point(limb(foot.b), 0));
      if (limb(foot.a).attach == limbs.last_joint(limb(leg.a)) || !(gap < (leg_count != 1 ? 0.12 : 0.5) * rig->size)) {
        continue;
      }
      if (best < 0 || gap < nearest) {
        best = k;
        nearest = gap;
      }
    }
    if (best < 0) {
      feet[kept++] = foot;
      continue;
    }
    limbs.append(legs[best].a, foot.a);
    limbs.append(legs[best].b, foot.b);
    int32_t left = 0;
    for (int32_t k = 0; k < limbs.pair_count; ++k) {
      if (limbs.pairs[k].a != foot.a) limbs.pairs[left++] = limbs.pairs[k];
    }
    limbs.pair_count = left;
  }
  foot_count = kept;
}

}  // namespace sinew::mapping
