// SPDX-License-Identifier: MIT
// The order in which a rig is read; which joints are of a side, and the limbs that begin there.
#include "mapping/anatomy.hpp"

#include "mapping/assignment.hpp"

namespace sinew::mapping {
namespace {

constexpr double kPairCost = 0.45;  // limbs that are less alike are no pair

}  // namespace

bool Anatomy::allocate(Arena& arena, uint32_t joints) {
  (void)frame.allocate(arena, joints);
  (void)limbs.allocate(arena, joints);
  x = arena.alloc<double>(joints);
  height = arena.alloc<double>(joints);
  side = arena.alloc<int8_t>(joints);
  limb_head = arena.alloc<int32_t>(joints);
  limb_next = arena.alloc<int32_t>(kMostSideLimbs);
  legs = arena.alloc<LimbPair>(kMostSideLimbs);
  feet = arena.alloc<LimbPair>(kMostSideLimbs);
  spine = arena.alloc<int32_t>(size_t{joints} + 1);
  path_open = arena.alloc<int8_t>(joints);
  features = arena.alloc<LimbFeatures>(kMostLimbs);
  hashes = arena.alloc<uint32_t>(size_t{4} * names::kMostWords * joints);
  return arena.ok();
}

bool Anatomy::build(const Hierarchy& hierarchy, const Point* up, bool flip_it, Arena& arena) {
  rig = &hierarchy;
  if (!find_frame(hierarchy, up, arena, &frame)) return false;
  if (!arena.measuring()) {
    find_sides();
    begin_limbs();
  }
  if (!pair_limbs(arena)) return false;
  if (arena.measuring()) return true;
  find_legs();
  find_front(flip_it);
  find_body();
  find_features();
  return true;
}

void Anatomy::find_sides() {
  const Hierarchy& r = *rig;
  const double near = 0.02 * r.size;
  // Joints off the plane on either side of it, in a subtree. `path_open` and the scratch below are free until the torso.
  int32_t* const left = spine;
  bool mirrored = false;
  for (int32_t i = 0; i < r.n; ++i) {
    mirrored = mirrored || frame.mate[i] >= 0;
    x[i] = dot(r.at[i], frame.across) - frame.plane;
    height[i] = dot(r.at[i], frame.up);
  }
  const auto limit = [&](int32_t i) { return frame.mate[i] >= 0 ? near : 3 * near; };
  int32_t* const right = limb_head;
  for (int32_t i = 0; i < r.n; ++i) {
    left[i] = r.apart[i] == 0 && x[i] > limit(i) ? 1 : 0;
    right[i] = r.apart[i] == 0 && x[i] < -limit(i) ? 1 : 0;
  }
  for (int32_t k = r.n - 1; k >= 0; --k) {
    const int32_t i = r.order[k], p = r.parent[i];
    if (p < 0) continue;
    left[p] += left[i];
    right[p] += right[i];
  }
  const auto one_sided = [&](int32_t i) { return (left[i] > 0) != (right[i] > 0); };
  for (int32_t i = 0; i < r.n; ++i) {
    side[i] = 0;
    if (!mirrored || r.apart[i] != 0) continue;  // one chain, however it bends
    if (frame.posed) {
      side[i] = frame.side[i];
    } else if (absolute(x[i]) > limit(i)) {
      const int32_t less = left[i] < right[i] ? left[i] : right[i], more = left[i] + right[i] - less;
      if (!(less > 0 && 3 * less >= more)) side[i] = x[i] > 0 ? 1 : -1;
    } else if (one_sided(i) &&
               r.parent[i] >= 0) {  // a hip joint or clavicle on the plane, if its like is on the other side
      const int8_t own = left[i] > 0 ? 1 : -1;
      each_kid(r, r.parent[i], [&](int32_t k) {
        const int32_t a = r.count[k], b = r.count[i];
        if (k != i && one_sided(k) && (left[k] > 0 ? 1 : -1) == -own && 3 * (a < b ? a : b) >= (a < b ? b : a)) {
          side[i] = own;
        }
      });
    }
  }
  for (int32_t k = 0; k < r.n; ++k) {
    const int32_t i = r.order[k], p = r.parent[i];
    if (p >= 0 && side[p] != 0) side[i] = side[p];
  }
}

void Anatomy::begin_limbs() {
  const Hierarchy& r = *rig;
  limbs.count = limbs.joints_used = limbs.points_used = limbs.pair_count = 0;
  limbs.full = false;
  for (int32_t i = 0; i < r.n; ++i) limb_head[i] = -1;
  for (int32_t k = 0; k < r.n; ++k) {
    const int32_t i = r.order[k], p = r.parent[i];
    if (side[i] == 0 || r.end[i] != 0 || (p >= 0 && side[p] != 0)) continue;
    if (limbs.count == kMostSideLimbs) {
      limbs.full = true;
      break;
    }
    (void)limbs.begin(r, i, side[i], p);
  }
  side_limbs = limbs.count;
  for (int32_t b = side_limbs - 1; b >= 0; --b) {  // rows keep the limbs' order
    const int32_t a = limbs.at[b].attach;
    if (a < 0) continue;
    limb_next[b] = limb_head[a];
    limb_head[a] = b;
  }
  limbs.grow(r, side, 0);
}

bool Anatomy::pair_limbs(Arena& arena) {
  const ArenaScope scope(arena);
  const uint32_t most = rig->n < kMostSideLimbs ? static_cast<uint32_t>(rig->n) : kMostSideLimbs;
  Assignment both;
  (void)both.allocate(arena, most, most);
  int32_t* const left = arena.alloc<int32_t>(most);
  int32_t* const right = arena.alloc<int32_t>(most);
  if (!arena.ok() || arena.measuring()) return arena.ok();
  for (int32_t k = 0; k < side_limbs; ++k) {
    if (limb(k).side > 0) {
      left[both.rows++] = k;
    } else {
      right[both.columns++] = k;
    }
  }
  for (int32_t i = 0; i < both.rows; ++i) {
    for (int32_t j = 0; j < both.columns; ++j) {
      const Limb &a = limb(left[i]), &b = limb(right[j]);
      Point image = limbs.mean_point(a);
      image = image - (2 * (dot(image, frame.across) - frame.plane)) * frame.across;
      both.at(i, j) = distance(image, limbs.mean_point(b)) / rig->size +
                      0.3 * absolute(logarithm(static_cast<double>(a.tree) / b.tree)) +
                      (a.attach == b.attach ? 0 : 0.05);
      if (frame.posed && frame.mate[limbs.joint(a, 0)] == limbs.joint(b, 0)) both.at(i, j) = 0;
    }
  }
  both.solve(32);  // no limb stays alone by choice
  for (int32_t i = 0; i < both.rows; ++i) {
    const int32_t j = both.match[i];
    if (j < 0 || !(both.at(i, j) < kPairCost)) continue;
    const LimbPair pair = {left[i], right[j]};
    limbs.at[pair.a].mate = pair.b;
    limbs.at[pair.b].mate = pair.a;
    limbs.pairs[limbs.pair_count++] = pair;
  }
  return true;
}

}  // namespace sinew::mapping
