// SPDX-License-Identifier: MIT
// The caller's rig, checked: children in rows, the order that keeps subtrees together, counts and reaches.
#include "mapping/hierarchy.hpp"

namespace sinew::mapping {
namespace {

constexpr int kMostFarBones = 64;   // that are considered
constexpr int32_t kApartShare = 8;  // at most one joint of so many is no part of the body

bool is_finite(double a) { return a - a == 0; }

struct Box {
  Point low = {1e300, 1e300, 1e300}, high = {-1e300, -1e300, -1e300};

  void add(const Point& p) {
    low = {lesser(low.x, p.x), lesser(low.y, p.y), lesser(low.z, p.z)};
    high = {greater(high.x, p.x), greater(high.y, p.y), greater(high.z, p.z)};
  }
  double diagonal() const { return distance(low, high); }
};

double gap(const Box& a, const Box& b) {
  const auto off = [](double low, double high, double other_low, double other_high) {
    return greater(0, greater(other_low - high, low - other_high));
  };
  return length(Point{off(a.low.x, a.high.x, b.low.x, b.high.x), off(a.low.y, a.high.y, b.low.y, b.high.y),
                      off(a.low.z, a.high.z, b.low.z, b.high.z)});
}

}  // namespace

bool Hierarchy::allocate(Arena& arena, uint32_t joints) {
  n = static_cast<int32_t>(joints);
  at = arena.alloc<Point>(joints);
  parent = arena.alloc<int32_t>(joints);
  kid_offsets = arena.alloc<int32_t>(size_t{joints} + 2);
  kids = arena.alloc<int32_t>(joints);
  order = arena.alloc<int32_t>(joints);
  position = arena.alloc<int32_t>(joints);
  depth = arena.alloc<int32_t>(joints);
  count = arena.alloc<int32_t>(joints);
  reach = arena.alloc<double>(joints);
  end = arena.alloc<uint8_t>(joints);
  apart = arena.alloc<uint8_t>(joints);
  names = arena.alloc<JointName>(joints);
  return arena.ok();
}

sinew_status Hierarchy::build(const sinew_skeleton& rig, bool with_names) {
  n = static_cast<int32_t>(rig.joint_count);
  has_names = with_names;
  has_ends = rig.ends != nullptr;  // or names tell of some, see below
  for (int32_t i = 0; i < n; ++i) {
    const float* const p = rig.positions + size_t{3} * static_cast<size_t>(i);
    at[i] = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    if (!is_finite(at[i].x) || !is_finite(at[i].y) || !is_finite(at[i].z)) return SINEW_ERROR_NOT_FINITE;
    parent[i] = rig.parents[i];
    if (parent[i] < -1 || parent[i] >= n) return SINEW_ERROR_INDEX;
  }
  sinew_status status = sort_joints();
  if (status == SINEW_OK && join_roots()) status = sort_joints();
  if (status != SINEW_OK) return status;
  find_body();
  for (int32_t i = 0; i < n; ++i) {
    const bool told = rig.ends != nullptr && rig.ends[i] != 0;
    end[i] = (told || is_beside_body(i)) && parent[i] >= 0 ? 1 : 0;
    names[i] = JointName();
    if (!with_names) continue;
    names[i] = names::read_joint_name(rig.names[i]);
    if (names[i].is_end_of_map() && kid_count(i) == 0) {
      end[i] = 1;
      has_ends = true;
    }
  }
  return SINEW_OK;
}

sinew_status Hierarchy::sort_joints() {
  for (int32_t i = 0; i <= n + 1; ++i) kid_offsets[i] = 0;
  for (int32_t i = 0; i < n; ++i) ++kid_offsets[(parent[i] >= 0 ? parent[i] : n) + 1];
  for (int32_t i = 0; i <= n; ++i) kid_offsets[i + 1] += kid_offsets[i];
  for (int32_t i = 0; i < n; ++i) position[i] = 0;  // how many children of a joint have their index
  int32_t roots = 0;
  for (int32_t i = 0; i < n; ++i) {
    const int32_t p = parent[i];
    kids[kid_offsets[p >= 0 ? p : n] + (p >= 0 ? position[p]++ : roots++)] = i;
  }
  // Down to the first child, else on to the next sibling of the joint or of one above it.
  int32_t placed = 0;
  for (int32_t r = 0; r < roots; ++r) {
    int32_t i = kids[kid_offsets[n] + r];
    depth[i] = 0;
    for (bool down = true; i >= 0;) {
      if (down) {
        position[i] = placed;
        order[placed++] = i;
        count[i] = 0;  // children that were visited, until the subtree is done
      }
      if (count[i] < kid_count(i)) {
        const int32_t next = kid(i, count[i]++);
        depth[next] = depth[i] + 1;
        i = next;
        down = true;
      } else {
        i = parent[i];
        down = false;
      }
    }
  }
  if (placed != n) return SINEW_ERROR_HIERARCHY;  // what no root reaches goes round in a circle
  for (int32_t i = 0; i < n; ++i) {
    count[i] = 1;
    reach[i] = 0;
  }
  for (int32_t k = n - 1; k >= 0; --k) {
    const int32_t i = order[k], p = parent[i];
    if (p < 0) continue;
    count[p] += count[i];
    reach[p] = greater(reach[p], reach[i] + bone(i, p));
  }
  return SINEW_OK;
}

bool Hierarchy::join_roots() {
  constexpr int32_t kFewest = 3;                               // joints of a limb
  constexpr double kLimb = 0.2, kTouches = 0.1, kSame = 0.01;  // of the body's box: a part's reach, a gap, one position
  int32_t body = first_root();
  for (int32_t k = kid_offsets[n]; k < kid_offsets[n + 1]; ++k) body = count[kids[k]] > count[body] ? kids[k] : body;
  Box box;
  for (int32_t k = position[body]; k < position[body] + count[body]; ++k) box.add(at[order[k]]);
  const double whole = box.diagonal();
  // The body's joint that is nearest to another one, the topmost of equals.
  const auto nearest = [&](int32_t joint) {
    int32_t best = body;
    for (int32_t k = position[body]; k < position[body] + count[body]; ++k)
      if (bone(order[k], joint) < bone(best, joint)) best = order[k];
    return best;
  };
  bool any = false;
  for (int32_t r = kid_offsets[n]; r < kid_offsets[n + 1]; ++r) {
    const int32_t root = kids[r];
    if (count[root] < kFewest || count[root] >= count[body]) continue;  // as large: another body
    const int32_t joint = nearest(root);
    if (bone(joint, root) > kTouches * whole) continue;
    double far = 0;
    int32_t same = 0;
    for (int32_t k = position[root]; k < position[root] + count[root]; ++k) {
      far = greater(far, bone(root, order[k]));
      same += bone(nearest(order[k]), order[k]) < kSame * whole ? 1 : 0;
    }
    if (far < kLimb * whole || 2 * same > count[root]) continue;
    parent[root] = joint;
    any = true;
  }
  return any;
}

void Hierarchy::find_body() {
  // Bounds of the joints whose positions in `order` are in [from, to), or of all others.
  const auto box_of = [&](bool inside, int32_t from, int32_t to) {
    Box box;
    for (int32_t k = 0; k < n; ++k)
      if ((from <= k && k < to) == inside) box.add(at[order[k]]);
    return box;
  };
  for (int32_t i = 0; i < n; ++i) apart[i] = 0;
  const double whole = box_of(true, 0, n).diagonal();
  int looked_at = 0;
  for (int32_t k = 0; k < n && looked_at < kMostFarBones; ++k) {
    const int32_t i = order[k], last = k + count[i];
    // A gap that is larger than one side and the bones across it is a third of the whole at least.
    if (count[i] == n || (parent[i] >= 0 && 3 * bone(i, parent[i]) < whole)) continue;
    ++looked_at;
    if (kApartShare * (n - count[i]) > n) continue;
    const Box inner = box_of(true, k, last);
    if (!(gap(inner, box_of(false, k, last)) > inner.diagonal())) continue;
    for (int32_t m = 0; m < n; ++m) apart[order[m]] = m < k || m >= last ? 1 : 0;
  }
  Box body;
  for (int32_t i = 0; i < n; ++i)
    if (apart[i] == 0) body.add(at[i]);
  size = body.diagonal();
  if (!(size > 0)) size = 1;
}

void Hierarchy::take_leaves_as_ends(bool yes) {
  for (int32_t i = 0; i < n && !has_ends; ++i)
    end[i] = ((yes && kid_count(i) == 0) || is_beside_body(i)) && parent[i] >= 0 ? 1 : 0;
}

}  // namespace sinew::mapping
