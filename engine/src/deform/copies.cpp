// SPDX-License-Identifier: MIT
// Patches of triangles in a cell, copies by weights, inner cells in layers, and the union of corners.
#include "deform/copies.hpp"

#include "core/triangle.hpp"
#include "core/union_find.hpp"
#include "core/vector_math.hpp"
#include "voxels/triangle_cells.hpp"

namespace sinew::deform {
namespace {

// Patches of one cell that are compared with each other. More are dust, and join the first that is like them.
constexpr uint32_t kComparedPatches = 64;
constexpr uint32_t kSameInside = 98302;  // rows of two inner cells: 1.5 of 2

int16_t to_q14(double x) {
  const double scaled = x * 16384 + 0.5;
  return static_cast<int16_t>(scaled < 0 ? 0 : scaled > 16384 ? 16384 : static_cast<int32_t>(scaled));
}

// State of a patch while its cell is processed.
struct Patch {
  WeightRow row;
  Vec3l point;   // sum over its triangles, grid units
  Vec3l normal;  // sum of cross products
  uint32_t triangles;
};

class CopyMaker {
 public:
  CopyMaker(const LatticeInput& input, const LatticeBounds& bounds, RowSum* sum, VoxelGrid* grid, Copies* copies)
      : input_(input), mesh_(*input.mesh), bounds_(bounds), sum_(*sum), grid_(*grid), copies_(*copies) {}

  sinew_status run(Arena& arena) {
    parents_ = arena.alloc<uint32_t>(bounds_.pairs);
    patches_ = arena.alloc<Patch>(bounds_.pairs);
    copy_of_ = arena.alloc<uint32_t>(bounds_.pairs);
    seen_cell_ = arena.alloc<uint32_t>(bounds_.vertices);
    seen_pair_ = arena.alloc<uint32_t>(bounds_.vertices);
    queue_ = arena.alloc<uint32_t>(bounds_.cells);
    if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
    if (arena.measuring()) return SINEW_OK;
    clear_cells(&grid_);
    sort_pairs();
    flood_outside(queue_, &grid_);
    const uint32_t inner = (static_cast<uint32_t>(grid_.size[0]) - 2) * (static_cast<uint32_t>(grid_.size[1]) - 2) *
                           (static_cast<uint32_t>(grid_.size[2]) - 2);
    spare_ = bounds_.copies - inner;
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) seen_cell_[v] = kNoIndex;
    for (uint32_t c = 0; c < grid_.cell_count; ++c) {
      copies_.first_of_cell[c] = 0;
      copies_.count_of_cell[c] = 0;
      if (grid_.states[c] == kCellSurface) split_cell(c);
    }
    copies_.surface_count = copies_.count;
    fill_inside();
    return SINEW_OK;
  }

 private:
  // CSR of the triangles of each cell, and the surface cells.
  void sort_pairs() {
    uint32_t* const offsets = copies_.pair_offsets;
    for (uint32_t c = 0; c <= grid_.cell_count; ++c) offsets[c] = 0;
    const auto each_triangle = [this](const auto& visit) {
      for (uint32_t t = 0; t < mesh_.triangle_count; ++t) {
        const uint32_t* const at = mesh_.triangles + 3 * static_cast<size_t>(t);
        const Vec3i corners[3] = {mesh_.positions[at[0]], mesh_.positions[at[1]], mesh_.positions[at[2]]};
        each_touched_cell(corners, grid_, [&](uint32_t cell) { visit(cell, t); });
      }
    };
    each_triangle([&](uint32_t cell, uint32_t) {
      ++offsets[cell];
      grid_.states[cell] = kCellSurface;
    });
    uint32_t total = 0;
    for (uint32_t c = 0; c <= grid_.cell_count; ++c) {
      const uint32_t count = offsets[c];
      offsets[c] = total;
      total += count;
    }
    each_triangle([&](uint32_t cell, uint32_t t) { copies_.pair_triangles[offsets[cell]++] = t; });
    for (uint32_t c = grid_.cell_count; c > 0; --c) offsets[c] = offsets[c - 1];
    offsets[0] = 0;
  }

  void add_vertex(uint32_t welded, int64_t factor) {
    const size_t at = static_cast<size_t>(input_.first_vertices[welded]) * bounds_.influences;
    for (uint32_t i = 0; i < bounds_.influences; ++i) sum_.add(input_.joints[at + i], factor * input_.weights[at + i]);
  }

  // Patches are triangles that share vertices.
  uint32_t find_patches(uint32_t cell, uint32_t begin, uint32_t end) {
    for (uint32_t p = begin; p < end; ++p) {
      parents_[p] = p;
      const uint32_t* const at = mesh_.triangles + 3 * static_cast<size_t>(copies_.pair_triangles[p]);
      for (int k = 0; k < 3; ++k) {
        if (seen_cell_[at[k]] == cell) {
          join_sets(parents_, p, seen_pair_[at[k]]);
        } else {
          seen_cell_[at[k]] = cell;
          seen_pair_[at[k]] = p;
        }
      }
    }
    // A patch's number, in pair_copies for now; its triangles are gone through in order.
    uint32_t count = 0;
    for (uint32_t p = begin; p < end; ++p) {
      const uint32_t root = find_root(parents_, p);
      copies_.pair_copies[p] = root == p ? count++ : copies_.pair_copies[root];
    }
    return count;
  }

  void measure_pair(uint32_t pair, Vec3i low, Vec3d center, Patch* patch) {
    const uint32_t* const at = mesh_.triangles + 3 * static_cast<size_t>(copies_.pair_triangles[pair]);
    const Vec3i corners[3] = {mesh_.positions[at[0]], mesh_.positions[at[1]], mesh_.positions[at[2]]};
    const Vec3d a = to_double(corners[0]), b = to_double(corners[1]), c = to_double(corners[2]);
    double shares[3];
    nearest_on_triangle(center, a, b, c, shares);
    const Vec3d p = shares[0] * a + shares[1] * b + shares[2] * c;
    PairPoint& point = copies_.pair_points[pair];
    const double cell = grid_.cell_size;
    point.position[0] = to_q14((p.x - low.x) / cell);
    point.position[1] = to_q14((p.y - low.y) / cell);
    point.position[2] = to_q14((p.z - low.z) / cell);
    for (int k = 0; k < 3; ++k) point.shares[k] = to_q14(shares[k]);
    const Vec3l normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    patch->normal = {patch->normal.x + normal.x, patch->normal.y + normal.y, patch->normal.z + normal.z};
    patch->point.x += static_cast<int64_t>(p.x);
    patch->point.y += static_cast<int64_t>(p.y);
    patch->point.z += static_cast<int64_t>(p.z);
    ++patch->triangles;
  }

  void split_cell(uint32_t cell) {
    const uint32_t begin = copies_.pair_offsets[cell], end = copies_.pair_offsets[cell + 1];
    const uint32_t count = find_patches(cell, begin, end);
    const Vec3i at = cell_coordinates(grid_, cell);
    const Vec3i low = {grid_.low.x + at.x * grid_.cell_size, grid_.low.y + at.y * grid_.cell_size,
                       grid_.low.z + at.z * grid_.cell_size};
    const double half = 0.5 * grid_.cell_size;
    const Vec3d center = {low.x + half, low.y + half, low.z + half};
    for (uint32_t i = 0; i < count; ++i) patches_[i] = {};
    for (uint32_t p = begin; p < end; ++p) measure_pair(p, low, center, patches_ + copies_.pair_copies[p]);
    if (count == 1) {  // most cells
      for (uint32_t p = begin; p < end; ++p) add_pair(p);
      patches_[0].row = sum_.take();
      add_copy(cell, patches_[0]);
      for (uint32_t p = begin; p < end; ++p) copies_.pair_copies[p] = copies_.count - 1;
      return;
    }
    for (uint32_t i = 0; i < count; ++i) {
      for (uint32_t p = begin; p < end; ++p) {
        if (copies_.pair_copies[p] == i) add_pair(p);
      }
      patches_[i].row = sum_.take();
    }
    group_patches(cell, begin, end, count);
  }

  void add_pair(uint32_t pair) {
    const uint32_t* const at = mesh_.triangles + 3 * static_cast<size_t>(copies_.pair_triangles[pair]);
    for (int k = 0; k < 3; ++k) add_vertex(at[k], copies_.pair_points[pair].shares[k]);
  }

  void group_patches(uint32_t cell, uint32_t begin, uint32_t end, uint32_t count) {
    uint32_t* const groups = parents_;  // of patches, from here on
    for (uint32_t i = 0; i < count; ++i) {
      groups[i] = i;
      const uint32_t compared = i < kComparedPatches ? i : kComparedPatches;
      for (uint32_t k = 0; k < compared; ++k) {
        if (row_distance(patches_[i].row, patches_[k].row) < kSameRows) join_sets(groups, i, k);
      }
      if (i >= kComparedPatches) join_sets(groups, i, 0);
    }
    uint32_t kinds = 0;
    for (uint32_t i = 0; i < count; ++i) kinds += groups[i] == i ? 1u : 0u;
    if (kinds - 1 > spare_) {  // no room to tell them apart
      for (uint32_t i = 0; i < count; ++i) groups[i] = 0;
      kinds = 1;
    }
    spare_ -= kinds - 1;
    if (kinds > 1) ++copies_.split_cells;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t root = find_root(groups, i);
      if (root != i) continue;
      Patch whole = {};
      for (uint32_t k = i; k < count; ++k) {
        if (find_root(groups, k) != i) continue;
        const Patch& one = patches_[k];
        sum_.add(one.row, one.triangles);
        whole.point = {whole.point.x + one.point.x, whole.point.y + one.point.y, whole.point.z + one.point.z};
        whole.normal = {whole.normal.x + one.normal.x, whole.normal.y + one.normal.y, whole.normal.z + one.normal.z};
        whole.triangles += one.triangles;
        copy_of_[k] = copies_.count;
      }
      whole.row = sum_.take();
      add_copy(cell, whole);
    }
    for (uint32_t p = begin; p < end; ++p) copies_.pair_copies[p] = copy_of_[copies_.pair_copies[p]];
  }
  void add_copy(uint32_t cell, const Patch& patch) {
    const uint32_t i = copies_.count++;
    copies_.cells[i] = cell;
    copies_.rows[i] = patch.row;
    copies_.points[i] = patch.triangles == 0 ? Vec3i{0, 0, 0} : round_div(patch.point, patch.triangles);
    copies_.normals[i] = unit_vector(patch.normal, kNormalBits);
    if (copies_.count_of_cell[cell]++ == 0) copies_.first_of_cell[cell] = i;
  }

  // Cells inside of the body, from the surface inwards: the mean of what is around and faces them.
  void fill_inside() {
    uint32_t* const pending = queue_;
    uint32_t left = 0;
    for (uint32_t c = 0; c < grid_.cell_count; ++c) {
      if (grid_.states[c] == kCellInside) pending[left++] = c;
    }
    const int32_t steps[6] = {
        1, -1, grid_.size[0], -grid_.size[0], grid_.size[0] * grid_.size[1], -grid_.size[0] * grid_.size[1]};
    while (left > 0) {
      const uint32_t before = copies_.count;
      uint32_t kept = 0;
      for (uint32_t i = 0; i < left; ++i) {
        const uint32_t cell = pending[i];
        bool any = false;
        for (const int32_t step : steps) {
          const uint32_t other = static_cast<uint32_t>(static_cast<int32_t>(cell) + step);
          for (uint32_t k = 0; k < copies_.count_of_cell[other]; ++k) {
            const uint32_t copy = copies_.first_of_cell[other] + k;
            if (!faces_cell(grid_, copies_, copy, cell)) continue;
            sum_.add(copies_.rows[copy], 1);
            any = true;
          }
        }
        if (!any) {
          pending[kept++] = cell;
          continue;
        }
        copies_.cells[copies_.count] = cell;
        copies_.rows[copies_.count++] = sum_.take();
      }
      if (copies_.count == before) break;
      for (uint32_t i = before; i < copies_.count; ++i) {
        copies_.first_of_cell[copies_.cells[i]] = i;
        copies_.count_of_cell[copies_.cells[i]] = 1;
      }
      left = kept;
    }
  }

  const LatticeInput& input_;
  const Mesh& mesh_;
  const LatticeBounds& bounds_;
  RowSum& sum_;
  VoxelGrid& grid_;
  Copies& copies_;
  uint32_t *parents_ = nullptr, *copy_of_ = nullptr, *seen_cell_ = nullptr, *seen_pair_ = nullptr, *queue_ = nullptr;
  Patch* patches_ = nullptr;
  uint32_t spare_ = 0;

 public:
  // Whether a copy has that cell behind its surface, or has no front.
  static bool faces_cell(const VoxelGrid& grid, const Copies& copies, uint32_t copy, uint32_t cell) {
    if (copy >= copies.surface_count) return true;
    if (copies.count_of_cell[copies.cells[copy]] == 1) return true;
    return dot(copies.normals[copy], grid.center(cell) - copies.points[copy]) < 0;
  }
};

// Whether a triangle belongs to both copies: both lists are ascending.
bool share_triangle(const Copies& copies, uint32_t a, uint32_t b) {
  uint32_t i = copies.pair_offsets[copies.cells[a]], j = copies.pair_offsets[copies.cells[b]];
  const uint32_t i_end = copies.pair_offsets[copies.cells[a] + 1], j_end = copies.pair_offsets[copies.cells[b] + 1];
  while (i < i_end && j < j_end) {
    const uint32_t x = copies.pair_triangles[i], y = copies.pair_triangles[j];
    if (x == y && copies.pair_copies[i] == a && copies.pair_copies[j] == b) return true;
    i += x <= y ? 1u : 0u;
    j += y <= x ? 1u : 0u;
  }
  return false;
}

bool hang_together(const VoxelGrid& grid, const Copies& copies, uint32_t a, uint32_t b, bool over_a_side) {
  const bool a_inner = a >= copies.surface_count, b_inner = b >= copies.surface_count;
  if (!a_inner && !b_inner && share_triangle(copies, a, b)) return true;
  if (!over_a_side) return false;
  const uint32_t distance = row_distance(copies.rows[a], copies.rows[b]);
  if (a_inner && b_inner) return distance < kSameInside;
  if (!a_inner && !b_inner) return distance < kSameRows;
  const uint32_t inner = a_inner ? a : b, outer = a_inner ? b : a;
  return CopyMaker::faces_cell(grid, copies, outer, copies.cells[inner]) || distance < kSameRows / 2;
}

void join_all(const VoxelGrid& grid, bool everything, Copies* copies) {
  uint32_t* const parents = copies->corners;
  for (uint32_t i = 0; i < 8 * copies->count; ++i) parents[i] = i;
  for (uint32_t a = 0; a < copies->count; ++a) {
    for (int32_t e = 14; e < 27; ++e) {  // the half of the neighbors that comes later
      const int32_t dx = e / 9 - 1, dy = e / 3 % 3 - 1, dz = e % 3 - 1;
      const uint32_t other =
          static_cast<uint32_t>(static_cast<int32_t>(copies->cells[a]) + (dz * grid.size[1] + dy) * grid.size[0] + dx);
      const bool side = (dx != 0) + (dy != 0) + (dz != 0) == 1;
      for (uint32_t k = 0; k < copies->count_of_cell[other]; ++k) {
        const uint32_t b = copies->first_of_cell[other] + k;
        if (!everything && !hang_together(grid, *copies, a, b, side)) continue;
        for (int32_t q = 0; q < 8; ++q) {
          const int32_t x = (q >> 2) - dx, y = (q >> 1 & 1) - dy, z = (q & 1) - dz;
          if (x < 0 || x > 1 || y < 0 || y > 1 || z < 0 || z > 1) continue;
          join_sets(parents, 8 * a + static_cast<uint32_t>(q), 8 * b + static_cast<uint32_t>(4 * x + 2 * y + z));
        }
      }
    }
  }
}

}  // namespace

bool Copies::allocate(Arena& arena, const LatticeBounds& bounds) {
  cells = arena.alloc<uint32_t>(bounds.copies);
  rows = arena.alloc<WeightRow>(bounds.copies);
  points = arena.alloc<Vec3i>(bounds.copies);
  normals = arena.alloc<Vec3i>(bounds.copies);
  first_of_cell = arena.alloc<uint32_t>(bounds.cells);
  count_of_cell = arena.alloc<uint32_t>(bounds.cells);
  pair_offsets = arena.alloc<uint32_t>(static_cast<size_t>(bounds.cells) + 1);
  pair_triangles = arena.alloc<uint32_t>(bounds.pairs);
  pair_copies = arena.alloc<uint32_t>(bounds.pairs);
  pair_points = arena.alloc<PairPoint>(bounds.pairs);
  corners = arena.alloc<uint32_t>(static_cast<size_t>(bounds.copies) * 8);
  return arena.ok();
}

Vec3i cell_coordinates(const VoxelGrid& grid, uint32_t cell) {
  const int32_t x = static_cast<int32_t>(cell) % grid.size[0], yz = static_cast<int32_t>(cell) / grid.size[0];
  return {x, yz % grid.size[1], yz / grid.size[1]};
}

sinew_status find_copies(const LatticeInput& input, const LatticeBounds& bounds, VoxelGrid* grid, RowSum* sum,
                         Arena& arena, Copies* copies) {
  const ArenaScope scope(arena);
  return CopyMaker(input, bounds, sum, grid, copies).run(arena);
}

void join_corners(const VoxelGrid& grid, uint32_t most_nodes, Copies* copies) {
  uint32_t* const corners = copies->corners;
  for (int pass = 0; pass < 2; ++pass) {
    join_all(grid, pass == 1, copies);
    uint32_t roots = 0;
    for (uint32_t i = 0; i < 8 * copies->count; ++i) roots += corners[i] == i ? 1u : 0u;
    if (roots <= most_nodes) break;  // always, once every corner of a position is one
  }
  // Roots come first of their set, so a root's number is known when its members ask.
  uint32_t count = 0;
  for (uint32_t i = 0; i < 8 * copies->count; ++i) corners[i] = find_root(corners, i);
  for (uint32_t i = 0; i < 8 * copies->count; ++i) corners[i] = corners[i] == i ? count++ : corners[corners[i]];
  copies->node_count = count;
}

}  // namespace sinew::deform
