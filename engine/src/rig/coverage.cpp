// SPDX-License-Identifier: MIT
// Distances from bones through the body; the farthest cells, followed back to the bone.
#include "rig/coverage.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

constexpr uint32_t kMostChains = 4;
constexpr uint32_t kMaxStarts = 4096;
constexpr uint32_t kMaxPath = 512;
constexpr uint32_t kReach = 22;                         // tenths of a bone's radius that it explains,
constexpr uint32_t kMargin = 3 * kDistanceUnits;        // and so much more
constexpr uint32_t kLeastLength = 12 * kDistanceUnits;  // of what stands out, beyond that
constexpr int64_t kSlender = 3;                         // times as long as deep
constexpr uint32_t kStep = 8 * kDistanceUnits;          // from joint to joint
constexpr int32_t kPlane = side_share(200);

class Coverage {
 public:
  Coverage(Interior* interior, uint8_t* owner, WayStart* starts, FoldedTree* tree)
      : interior_(*interior), grid_(interior->grid), owner_(owner), starts_(starts), tree_(*tree) {}

  // Cells that bones run through. A bone belongs to the joint where it begins.
  SINEW_RARE uint32_t mark_bones() {
    for (uint32_t j = 0; j < tree_.count; ++j) {
      const FoldedNode& node = tree_.nodes[j];
      if (node.parent >= 0) mark(static_cast<uint32_t>(node.parent), j, node.at);
      if (node.has_end) mark(j, j, node.end);
      if (node.parent < 0) mark(j, j, node.at);
    }
    for (uint32_t j = 0; j < tree_.count; ++j) {
      if (cells_[j] > 0) radius_[j] = radius_[j] * kDistanceUnits / (cells_[j] * kDepthUnits);
    }
    return count_;
  }

  // Whether a chain was added, or what stands out of a joint's bones dismissed.
  SINEW_RARE bool add_chain(uint64_t* dismissed) {
    uint32_t tip = kNoIndex;
    uint32_t most = 0;
    for (uint32_t c = 0; c < grid_.cell_count; ++c) {
      if (interior_.depth[c] == 0 || owner_[c] == kNoOwner || interior_.distance[c] == kNoDistance) continue;
      if ((*dismissed >> owner_[c] & 1) != 0) continue;
      const uint32_t explains = reach_of(owner_[c]);
      if (interior_.distance[c] < explains + kLeastLength) continue;
      if (interior_.distance[c] - explains <= most) continue;
      most = interior_.distance[c] - explains;
      tip = c;
    }
    if (tip == kNoIndex) return false;
    if (!follow(tip)) *dismissed |= uint64_t{1} << owner_[tip];
    return true;
  }

 private:
  SINEW_RARE void mark(uint32_t from, uint32_t owner, Vec3i to) {
    const bool both = tree_.beside(owner) || (tree_.mirrored && to.x > 0);
    const int8_t only = tree_.only(owner);
    if (only >= 0) mark_line(tree_.nodes[from].at, to, from);
    if (!both || only > 0) return;
    const Vec3i a = tree_.nodes[from].at;
    mark_line({-a.x, a.y, a.z}, {-to.x, to.y, to.z}, from);
  }
  SINEW_RARE void mark_line(Vec3i a, Vec3i b, uint32_t owner) {
    const int64_t steps = static_cast<int64_t>(length(b - a)) * 2 / grid_.cell_size + 1;
    for (int64_t i = 0; i <= steps; ++i) {
      const Vec3i way = b - a;
      const Vec3i at = a + round_div(Vec3l{way.x * i, way.y * i, way.z * i}, steps);
      const uint32_t c = interior_.solid_near(at);
      if (interior_.depth[c] == 0 || count_ == kMaxStarts) continue;
      if (count_ > 0 && starts_[count_ - 1].cell == c) continue;
      starts_[count_++] = {c, static_cast<uint8_t>(owner)};
      // In a hollow body the surface is as far as the wall.
      const int64_t off = static_cast<int64_t>(length(grid_.center(c) - at)) * kDepthUnits / grid_.cell_size;
      radius_[owner] += interior_.depth[c] + static_cast<uint32_t>(off < kDepthUnits ? 0 : off);
      ++cells_[owner];
    }
  }

  // Moves to the deepest position in the body at the same distance from the bones.
  uint32_t center_of(uint32_t cell) const {
    for (uint32_t i = 0; i < 16; ++i) {
      uint32_t best = cell;
      grid_.each_neighbor(cell, [&](uint32_t other) {
        const int32_t off = int32_t{interior_.distance[other]} - int32_t{interior_.distance[cell]};
        if (off < -4 || off > 4 || owner_[other] != owner_[cell]) return;
        if (interior_.depth[other] > interior_.depth[best]) best = other;
      });
      if (best == cell) break;
      cell = best;
    }
    return cell;
  }

  SINEW_RARE bool follow(uint32_t tip) {
    uint32_t path[kMaxPath], count = 0;
    const uint8_t owner = owner_[tip];
    const uint32_t surface = radius_[owner];
    int64_t depth = 0;
    for (uint32_t cell = tip; count < kMaxPath;) {
      path[count++] = cell;
      if (interior_.distance[cell] <= surface) break;
      uint32_t next = cell;
      grid_.each_neighbor(cell, [&](uint32_t other) {
        if (interior_.distance[other] < interior_.distance[next] && interior_.depth[other] != 0) next = other;
      });
      if (next == cell) return false;
      cell = next;
    }
    for (uint32_t i = 0; i < count; ++i) depth += interior_.depth[center_of(path[i])];
    const int64_t length_of = int64_t{interior_.distance[tip]} - interior_.distance[path[count - 1]];
    // fifths of a cell along, thirds across
    if (length_of * kDepthUnits * count < kSlender * depth * kDistanceUnits) return false;
    return place(path, count, owner, static_cast<uint32_t>(length_of));
  }

  SINEW_RARE bool place(const uint32_t* path, uint32_t count, uint8_t owner, uint32_t length_of) {
    const uint32_t steps = length_of / kStep < 2 ? 2 : length_of / kStep;
    if (tree_.count + steps > kMaxFoldedJoints) return false;
    Vec3i at[kMaxPath / 8];
    const uint32_t base = interior_.distance[path[count - 1]];
    uint32_t i = count;
    int64_t x = 0;
    for (uint32_t k = 0; k <= steps; ++k) {
      const uint32_t wanted = base + length_of * k / steps;
      while (i > 1 && interior_.distance[path[i - 1]] < wanted) --i;
      at[k] = grid_.center(k == steps ? path[0] : center_of(path[i - 1]));
      x += at[k].x;
    }
    const bool right = tree_.mirrored && x < 0;
    bool on_plane = tree_.mirrored;  // but where it leaves the body
    for (uint32_t k = 0; k <= steps; ++k) {
      if (right) at[k].x = -at[k].x;
      if (2 * k >= steps) on_plane = on_plane && at[k].x < kPlane && at[k].x > -kPlane;
    }
    while (on_plane && tree_.beside(owner)) owner = static_cast<uint8_t>(tree_.nodes[owner].parent);
    const bool beside = tree_.mirrored && !on_plane;
    const bool image = beside && stands_out(mirrored(path[0]), owner);
    for (uint32_t k = 0; k < steps; ++k) {
      FoldedNode node;
      node.at = at[k];
      if (on_plane) node.at.x = 0;
      if (beside && node.at.x < grid_.cell_size) node.at.x = grid_.cell_size;
      node.parent = static_cast<int16_t>(k == 0 ? owner : tree_.count - 1);
      node.only = beside && !image ? (right ? int8_t{-1} : int8_t{1}) : int8_t{0};
      node.joint_class = class_of(owner, at, steps, k, on_plane, image || !tree_.mirrored);
      node.parent_confidence = 32768 / 2;
      if (k + 1 == steps) {
        node.has_end = true;
        node.end = at[steps];
        if (on_plane) node.end.x = 0;
      }
      tree_.nodes[tree_.count++] = node;
    }
    return true;
  }
  uint32_t mirrored(uint32_t cell) const {
    Vec3i at = grid_.center(cell);
    at.x = -at.x;
    return grid_.cell_of(at);
  }
  // How far a joint's bones explain the body, fifths of a cell.
  uint32_t reach_of(uint8_t owner) const { return kReach * radius_[owner] / 10 + kMargin; }
  // Whether a cell or one beside it stands out as well.
  bool stands_out(uint32_t cell, uint8_t owner) const {
    bool found = false;
    const auto ask = [&](uint32_t c) {
      found = found || (interior_.depth[c] != 0 && owner_[c] == owner && interior_.distance[c] >= reach_of(owner));
    };
    ask(cell);
    grid_.each_neighbor(cell, ask);
    return found;
  }

  uint8_t class_of(uint8_t owner, const Vec3i* at, uint32_t steps, uint32_t k, bool on_plane, bool pair) const {
    const FoldedNode& above = tree_.nodes[owner];
    const Vec3i way = at[steps] - at[0];
    if (above.joint_class == kClassHead || above.joint_class == kClassNeck)
      return on_plane ? kClassOther : at[steps].y > at[0].y ? kClassEar : kClassHair;
    const bool trunk = above.joint_class == kClassPelvis || above.joint_class == kClassSpine;
    const bool leg = trunk && pair && way.y < 0;
    if (leg) return k == 0 ? kClassThigh : k + 1 == steps && steps > 2 ? kClassFoot : kClassCalf;
    const bool tail = trunk && !pair && way.z < 0;
    return tail || above.joint_class == kClassTail ? kClassTail : kClassOther;
  }

  Interior& interior_;
  const VoxelGrid& grid_;
  uint8_t* const owner_;
  WayStart* const starts_;
  FoldedTree& tree_;
  uint32_t count_ = 0;
  uint32_t radius_[kMaxFoldedJoints] = {};  // fifths of a cell
  uint32_t cells_[kMaxFoldedJoints] = {};
};

}  // namespace

SINEW_RARE bool cover_body(Arena& arena, Interior* interior, FoldedTree* tree) {
  const ArenaScope scope(arena);
  uint8_t* const owner = arena.alloc<uint8_t>(Interior::max_cells());
  WayStart* const starts = arena.alloc<WayStart>(kMaxStarts);
  if (!arena.ok()) return false;
  if (arena.measuring()) return divide_body(nullptr, 0, arena, interior, owner);
  uint64_t dismissed = 0;
  static_assert(kMaxFoldedJoints < 64, "a bit each");
  for (uint32_t tried = 0; tried < 2 * kMostChains; ++tried) {
    Coverage coverage(interior, owner, starts, tree);
    const uint32_t count = coverage.mark_bones();
    if (!divide_body(starts, count, arena, interior, owner)) return false;
    if (!coverage.add_chain(&dismissed)) break;
  }
  return true;
}

}  // namespace sinew::rigging
