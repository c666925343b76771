// SPDX-License-Identifier: MIT
// Nearest middles of triangles, by the tree.
#include "motion/arm_search.hpp"

namespace sinew::motion {
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
  order_.allocate(arena, triangles);
  vertices_ = arena.alloc<uint32_t>(vertices);
  near_ = arena.alloc<uint32_t>(vertices);
  hints_ = arena.alloc<uint32_t>(vertices / kGroup + kMostArms);
  const ArenaScope scope(arena);
  masks_ = arena.alloc<uint8_t>(triangles);
  (void)scratch_.allocate(arena, triangles > vertices ? triangles : vertices);
}

void ArmSearch::open(const ClipScene& scene, uint32_t most) {
  scene_ = &scene;
  for (uint32_t l = 0; l < scene.limbs.count && count_ < kMostArms; ++l) {
    if (!scene.limbs.limbs[l].leg) limbs_[count_++] = l;
  }
  const sinew_motion_body& body = *scene.body;
  uint32_t listed = 0;
  const auto list = [&](uint32_t arm, BodyPart part) {
    for (uint32_t v = 0; v < body.vertex_count; ++v) {
      if (scene.limb_of[v] == limbs_[arm] && scene.parts[v] == part) vertices_[listed++] = v;
    }
    return listed;
  };
  for (uint32_t a = 0; a < count_; ++a) {
    begin_[a] = listed;
    hand_end_[a] = list(a, BodyPart::kHand);
    end_[a] = list(a, BodyPart::kForearm);
    deepest_[a] = 0;
    nearest_[a] = begin_[a];
    const auto position = [&](uint32_t i) { return scene.target.rest(vertices_[begin_[a] + i]); };
    const uint32_t hand = hand_end_[a] - begin_[a];
    sort_by_position(end_[a] - begin_[a], scratch_, position, [&](uint32_t i) { return i < hand ? 0u : 1u; });
    for (uint32_t i = begin_[a]; i < end_[a]; ++i) near_[i] = begin_[a] + scratch_.order[i - begin_[a]];
    if (end_[a] - begin_[a] > most) thin_out(a, most);
  }
  for (uint32_t g = 0; g < body.vertex_count / kGroup + kMostArms; ++g) hints_[g] = 0;
  for (uint32_t t = 0; t < body.triangle_count; ++t) {
    masks_[t] = mask_of(t);
    any_body_ = any_body_ || masks_[t] == 0;
  }
  order_.sort(scene.target, masks_, scratch_);
}

// vertices_ become those along near_, which then has them in their order.
void ArmSearch::thin_out(uint32_t arm, uint32_t most) {
  const uint32_t begin = begin_[arm], step = (end_[arm] - begin + most - 1) / most;
  const uint32_t hand = hand_end_[arm] - begin;
  uint32_t kept = 0, kept_of_hand = 0;
  for (uint32_t k = 0; k < end_[arm] - begin; k += step) {
    scratch_.other_order[kept++] = vertices_[near_[begin + k]];
    if (k < hand) kept_of_hand = kept;
  }
  for (uint32_t k = 0; k < kept; ++k) {
    vertices_[begin + k] = scratch_.other_order[k];
    near_[begin + k] = begin + k;
  }
  hand_end_[arm] = begin + kept_of_hand;
  end_[arm] = begin + kept;
}

uint8_t ArmSearch::mask_of(uint32_t triangle) const {
  uint8_t mask = 0;
  for (int c = 0; c < 3; ++c) {
    const uint32_t limb = scene_->limb_of[corners(triangle)[c]];
    if (limb >= kMostLimbs || scene_->limbs.limbs[limb].leg) continue;
    uint32_t arm = 0;
    while (arm < count_ && limbs_[arm] != limb) ++arm;
    mask = static_cast<uint8_t>(mask | 1u << (arm < count_ ? arm : kMostArms));
  }
  return mask;
}

// A triangle whose middle is nearer to p than `found`; the first of equals.
void ArmSearch::look_nearer(const TriangleTree& tree, uint8_t without, Vec3d p, Nearest* found) {
  tree.walk(p, without, &found->square,
            [&](uint32_t leaf, const double(&squares)[kTreeFan]) { take_nearer(tree, leaf, squares, found); });
}

bool ArmSearch::is_any_within(const TriangleTree& tree, uint8_t without, Vec3d p, double reach) {
  const double square = reach * reach * kRounding;
  double bound = square;
  tree.walk(p, without, &bound, [&](uint32_t, const double(&squares)[kTreeFan]) {
    for (uint32_t i = 0; i < kTreeFan; ++i) {
      if (squares[i] <= square) bound = -1;
    }
  });
  return bound < 0;
}

double ArmSearch::distance(const TriangleTree& tree, uint32_t arm, uint32_t vertex) const {
  const double reach = kFar * tree.posed().height;
  Nearest found;
  found.square = reach * reach;
  look_nearer(tree, bit_of(arm), tree.posed().vertices[vertex], &found);
  return root(found.square);
}

template <class Look>
void ArmSearch::look_at_areas(const TriangleTree& tree, Vec3d p, double square, Look look) const {
  tree.walk(p, kAllArms, &square, [&](uint32_t leaf, const double(&squares)[kTreeFan]) {
    for (uint32_t i = 0; i < kTreeFan; ++i) {
      const uint32_t slot = kTreeFan * leaf + i, t = tree.triangle(slot);
      if (!(squares[i] <= square) || (i > 0 && tree.triangle(slot - 1) == t))
        continue;  // a short leaf's last one again
      const uint32_t* const corner = corners(t);
      const Vec3d a = tree.posed().vertices[corner[0]];
      const Vec3d area = 0.5 * cross(tree.posed().vertices[corner[1]] - a, tree.posed().vertices[corner[2]] - a);
      look(tree.middle(slot), area, squares[i]);
    }
  });
}

bool ArmSearch::is_inside(const TriangleTree& tree, Vec3d p) const {
  constexpr double kHalfOfAll = 6.283185307179586;  // between inside and outside
  double angle = 0;
  look_at_areas(tree, p, 1e300, [&](Vec3d middle, Vec3d area, double square) {
    if (square > 0) angle += dot(area, middle - p) / (square * root(square));
  });
  return angle > kHalfOfAll;
}

ArmDepth ArmSearch::deepest_inside(TriangleTree* tree, uint32_t arm, Vec3d moved, double least) {
  constexpr double kNearSurface = 0.02;  // share of the height
  const ArmDepth most = deepest(tree, arm, moved, least);
  if (most.depth - least <= kNearSurface * tree->posed().height) return most;
  if (is_inside(*tree, tree->posed().vertices[most.vertex] + moved)) return most;
  ArmDepth none;
  none.depth = least;
  return none;
}

Vec3d ArmSearch::way_out(const TriangleTree& tree, Vec3d p, double reach) const {
  constexpr double kThirdOfDisc = 1.0471975511965976;  // the integral of the shares over a disc of radius 1
  const double square = reach * reach;
  Vec3d sum = {0, 0, 0};
  look_at_areas(tree, p, square, [&](Vec3d, Vec3d area, double own) {
    const double share = 1 - own / square;
    sum = sum + share * share * area;
  });
  return (1 / (kThirdOfDisc * square)) * sum;
}

Vec3d ArmSearch::middle_of_hand(const TriangleTree& tree, uint32_t arm) const {
  Vec3d sum = {0, 0, 0};
  const uint32_t count = hand_end_[arm] - begin_[arm];
  for (uint32_t i = begin_[arm]; i < hand_end_[arm]; ++i) sum = sum + tree.posed().vertices[vertices_[i]];
  return count > 0 ? (1.0 / count) * sum : sum;
}

HandReach ArmSearch::nearest(const TriangleTree& tree, uint32_t arm) {
  const PosedBody& posed = tree.posed();
  const double reach = kFar * posed.height;
  HandReach found;
  found.square = reach * reach;
  uint32_t best = UINT32_MAX;  // the first of equally near ones
  const auto look = [&](uint32_t i) {
    Nearest own;
    own.square = found.square;
    look_nearer(tree, bit_of(arm), posed.vertices[vertices_[i]], &own);
    if (!(own.square < found.square) && !(own.square == found.square && i < best && found.near)) return;
    if (own.triangle == UINT32_MAX) return;
    found = {true, vertices_[i], own.square};
    best = i;
  };
  if (begin_[arm] < hand_end_[arm]) look(nearest_[arm]);
  for (uint32_t first = begin_[arm]; first < hand_end_[arm]; first += kGroup) {
    const uint32_t end = first + kGroup < hand_end_[arm] ? first + kGroup : hand_end_[arm];
    const Ball ball = ball_around(first, end, [&](uint32_t k) { return posed.vertices[vertices_[near_[k]]]; });
    if (!is_any_within(tree, bit_of(arm), ball.middle, root(found.square) + ball.radius)) continue;
    for (uint32_t k = first; k < end; ++k) look(near_[k]);
  }
  if (found.near) nearest_[arm] = best;
  return found;
}

uint32_t ArmSearch::neighbors(const TriangleTree& tree, uint32_t arm, uint32_t vertex, uint32_t most,
                              uint32_t* triangles, double* squares) const {
  const PosedBody& posed = tree.posed();
  const double reach = kFar * posed.height;
  Box hand;
  for (uint32_t i = begin_[arm]; i < hand_end_[arm]; ++i) hand.add(posed.vertices[vertices_[i]]);
  uint32_t count = 0;
  double bound = 1e300;
  const auto take = [&](uint32_t slot, double own) {
    const uint32_t t = tree.triangle(slot);
    const auto before = [&](uint32_t at) { return own < squares[at] || (own == squares[at] && t < triangles[at]); };
    if ((count == most && !before(count - 1)) || !hand.holds(tree.middle(slot), reach)) return;
    uint32_t at = 0;
    while (at < count && !before(at)) ++at;
    if (at > 0 && triangles[at - 1] == t) return;  // a short leaf's last one again
    count = count < most ? count + 1 : count;
    for (uint32_t k = count - 1; k > at; --k) {
      squares[k] = squares[k - 1];
      triangles[k] = triangles[k - 1];
    }
    squares[at] = own;
    triangles[at] = t;
    if (count == most) bound = squares[count - 1];
  };
  tree.walk(posed.vertices[vertex], bit_of(arm), &bound, [&](uint32_t leaf, const double(&own)[kTreeFan]) {
    for (uint32_t i = 0; i < kTreeFan; ++i) {
      if (own[i] <= bound) take(kTreeFan * leaf + i, own[i]);
    }
  });
  return count;
}

}  // namespace sinew::motion
