// SPDX-License-Identifier: MIT
// Triangles in a box around an arm, then the nearest of them, by a grid.
#include "motion/arm_search.hpp"

namespace sinew {
namespace {

constexpr double kBetween =
    0.01;  // share of the height that is left for a surface between points that are seen as outside

}  // namespace

// The smallest box along the axes around points.
struct ArmSearch::Box {
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

void ArmSearch::allocate(Arena& arena, uint32_t vertices, uint32_t triangles) {
  picked_ = arena.alloc<uint32_t>(triangles);
  vertices_ = arena.alloc<uint32_t>(vertices);
  cells_ = arena.alloc<uint32_t>(kCells * kCells * kCells + 1);
  sorted_ = arena.alloc<uint32_t>(triangles);
  cell_of_ = arena.alloc<uint16_t>(triangles);
}

void ArmSearch::open(const ClipScene& scene) {
  scene_ = &scene;
  for (uint32_t l = 0; l < scene.limbs.count && count_ < kMostArms; ++l) {
    if (!scene.limbs.limbs[l].leg) limbs_[count_++] = l;
  }
  uint32_t listed = 0;
  for (uint32_t a = 0; a < count_; ++a) {
    begin_[a] = listed;
    for (uint32_t v = 0; v < scene.body->vertex_count; ++v) {
      if (scene.limb_of[v] == limbs_[a] && scene.parts[v] == BodyPart::kHand) vertices_[listed++] = v;
    }
    hand_end_[a] = listed;
    for (uint32_t v = 0; v < scene.body->vertex_count; ++v) {
      if (scene.limb_of[v] == limbs_[a] && scene.parts[v] == BodyPart::kForearm) vertices_[listed++] = v;
    }
    end_[a] = listed;
  }
}

bool ArmSearch::is_arm_vertex(uint32_t v) const {
  return scene_->limb_of[v] < kMostLimbs && !scene_->limbs.limbs[scene_->limb_of[v]].leg;
}

// Triangles within reach of a box: those without a vertex of this arm, or of any arm.
void ArmSearch::pick(const PosedBody& posed, const Box& box, double reach, uint32_t arm, bool of_other_arms) {
  const sinew_motion_body& body = *scene_->body;
  picked_count_ = 0;
  for (uint32_t t = 0; t < body.triangle_count; ++t) {
    if (!box.holds(posed.middles[t], reach)) continue;
    const uint32_t* const corner = corners(t);
    bool usable = true;
    for (int c = 0; c < 3; ++c)
      usable = usable && (of_other_arms ? scene_->limb_of[corner[c]] != limbs_[arm] : !is_arm_vertex(corner[c]));
    if (usable) picked_[picked_count_++] = t;
  }
}

uint32_t ArmSearch::cell_along(double from_low) const {
  const double at = from_low * per_length_;
  return at > 0 ? (at < kCells - 1 ? static_cast<uint32_t>(at) : kCells - 1) : 0;
}

void ArmSearch::sort_into_cells(const PosedBody& posed, const Box& box, double reach) {
  const Vec3d size = box.high - box.low;
  const double longest = (size.x > size.y ? size.x : size.y) > size.z ? (size.x > size.y ? size.x : size.y) : size.z;
  cell_ = (longest + 2 * reach) * (1.0 / kCells);
  per_length_ = cell_ > 0 ? 1 / cell_ : 0;
  low_ = box.low - Vec3d{reach, reach, reach};
  constexpr uint32_t kAll = kCells * kCells * kCells;
  for (uint32_t c = 0; c <= kAll; ++c) cells_[c] = 0;
  for (uint32_t k = 0; k < picked_count_; ++k) {
    const Vec3d at = posed.middles[picked_[k]] - low_;
    cell_of_[k] = static_cast<uint16_t>((cell_along(at.z) * kCells + cell_along(at.y)) * kCells + cell_along(at.x));
    ++cells_[cell_of_[k] + 1u];
  }
  for (uint32_t c = 0; c < kAll; ++c) cells_[c + 1] += cells_[c];
  for (uint32_t k = 0; k < picked_count_; ++k) sorted_[cells_[cell_of_[k]]++] = picked_[k];
  for (uint32_t c = kAll; c > 0; --c) cells_[c] = cells_[c - 1];
  cells_[0] = 0;
}

// A triangle whose middle is nearer to p than `found`; the first of equals. Cells in shells around p's: those outside of a shell
// are farther than as many cells.
void ArmSearch::look_nearer(const PosedBody& posed, Vec3d p, Nearest* found) const {
  const int32_t last = static_cast<int32_t>(kCells) - 1;
  const Vec3d at = p - low_;
  const int32_t x = static_cast<int32_t>(cell_along(at.x)), y = static_cast<int32_t>(cell_along(at.y)),
                z = static_cast<int32_t>(cell_along(at.z));
  const auto look = [&](int32_t i, int32_t j, int32_t k) {
    const uint32_t cell = static_cast<uint32_t>((k * (last + 1) + j) * (last + 1) + i);
    for (uint32_t n = cells_[cell]; n < cells_[cell + 1]; ++n) {
      const uint32_t t = sorted_[n];
      const double own = squared(p - posed.middles[t]);
      if (own < found->square || (own == found->square && t < found->triangle)) *found = {t, own};
    }
  };
  for (int32_t r = 0; r <= last; ++r) {
    const double nearest = (r - 1) * cell_;
    if (r > 1 && nearest * nearest > found->square) return;
    const int32_t k0 = z - r < 0 ? 0 : z - r, k1 = z + r > last ? last : z + r;
    const int32_t j0 = y - r < 0 ? 0 : y - r, j1 = y + r > last ? last : y + r;
    for (int32_t k = k0; k <= k1; ++k) {
      for (int32_t j = j0; j <= j1; ++j) {
        if (k == z - r || k == z + r || j == y - r || j == y + r) {
          for (int32_t i = x - r < 0 ? 0 : x - r; i <= (x + r > last ? last : x + r); ++i) look(i, j, k);
        } else {
          if (x - r >= 0) look(x - r, j, k);
          if (x + r <= last) look(x + r, j, k);
        }
      }
    }
  }
}

ArmDepth ArmSearch::deepest(const PosedBody& posed, uint32_t arm, Vec3d moved) {
  const double reach = kFar * posed.height;
  Box box;
  for (uint32_t i = begin_[arm]; i < end_[arm]; ++i) box.add(posed.vertices[vertices_[i]] + moved);
  pick(posed, box, reach, arm, false);
  ArmDepth most;
  if (picked_count_ == 0) return most;
  sort_into_cells(posed, box, reach);
  // Eight neighbours at a time: where their middle is so far outside that no surface lies between, none of them is under one.
  constexpr uint32_t kGroup = 8;
  for (uint32_t first = begin_[arm]; first < end_[arm]; first += kGroup) {
    const uint32_t end = first + kGroup < end_[arm] ? first + kGroup : end_[arm];
    Vec3d middle = {0, 0, 0};
    for (uint32_t i = first; i < end; ++i) middle = middle + posed.vertices[vertices_[i]];
    middle = (1.0 / (end - first)) * middle + moved;
    double radius = 0;
    for (uint32_t i = first; i < end; ++i) {
      const double own = squared(posed.vertices[vertices_[i]] + moved - middle);
      if (own > radius) radius = own;
    }
    radius = root(radius);
    Nearest near = {UINT32_MAX, (reach + radius) * (reach + radius)};
    look_nearer(posed, middle, &near);
    if (near.triangle == UINT32_MAX) continue;
    const uint32_t* const corner = corners(near.triangle);
    double size = 0;
    for (int c = 0; c < 3; ++c) {
      const double own = squared(posed.vertices[corner[c]] - posed.middles[near.triangle]);
      if (own > size) size = own;
    }
    const double margin = radius + 2 * root(size) + kBetween * posed.height;
    if (near.square > margin * margin && dot(posed.middles[near.triangle] - middle, posed.normal(corner)) <= 0)
      continue;
    for (uint32_t i = first; i < end; ++i) {
      const Vec3d p = posed.vertices[vertices_[i]] + moved;
      Nearest found = {UINT32_MAX, reach * reach};
      const double known = squared(p - posed.middles[near.triangle]);
      if (known < found.square) found = {near.triangle, known};
      if (found.square <= most.depth * most.depth) continue;  // no deeper than it is far
      look_nearer(posed, p, &found);
      if (found.triangle == UINT32_MAX) continue;
      const Vec3d normal = posed.normal(corners(found.triangle));
      const double own = dot(posed.middles[found.triangle] - p, normal);
      if (own > most.depth) most = {own, normal, vertices_[i]};
    }
  }
  return most;
}

double ArmSearch::distance(const PosedBody& posed, uint32_t arm, uint32_t vertex) {
  const double reach = kFar * posed.height;
  Box point;
  point.add(posed.vertices[vertex]);
  pick(posed, point, reach, arm, true);
  double least = reach * reach;
  for (uint32_t k = 0; k < picked_count_; ++k) {
    const double own = squared(posed.vertices[vertex] - posed.middles[picked_[k]]);
    if (own < least) least = own;
  }
  return root(least);
}

HandReach ArmSearch::nearest(const PosedBody& posed, uint32_t arm) {
  const double reach = kFar * posed.height;
  Box hand;
  for (uint32_t i = begin_[arm]; i < hand_end_[arm]; ++i) hand.add(posed.vertices[vertices_[i]]);
  pick(posed, hand, reach, arm, true);
  HandReach found;
  found.square = reach * reach;
  if (picked_count_ == 0) return found;
  sort_into_cells(posed, hand, reach);
  for (uint32_t i = begin_[arm]; i < hand_end_[arm]; ++i) {
    Nearest own = {UINT32_MAX, found.square};
    look_nearer(posed, posed.vertices[vertices_[i]], &own);
    if (own.square < found.square) found = {true, vertices_[i], own.triangle, own.square};
  }
  return found;
}

}  // namespace sinew
