// SPDX-License-Identifier: MIT
// Grid, tetrahedra, weights of nodes, edges and the position of every vertex.
#include "deform/lattice.hpp"

#include "core/sort.hpp"
#include "core/triangle.hpp"
#include "core/vector_math.hpp"
#include "deform/copies.hpp"
#include "mesh/topology.hpp"
#include "voxels/triangle_cells.hpp"

namespace sinew::deform {
namespace {

// Triangles and cells that touch: more would need gigabytes.
constexpr uint64_t kMostPairs = 1u << 28;
// Rounds of means over what the surface says nothing of.
constexpr int kFillRounds = 4;

// Corners of a cell's five tetrahedra, by parity of its coordinates. The fifth is twice as large as the others. Volumes are
// positive.
constexpr uint8_t kFive[2][5][4] = {{{0, 1, 3, 5}, {0, 3, 2, 6}, {0, 5, 4, 6}, {3, 5, 6, 7}, {0, 3, 5, 6}},
                                    {{1, 0, 2, 4}, {1, 2, 3, 7}, {1, 4, 5, 7}, {2, 4, 6, 7}, {1, 2, 4, 7}}};
// The edges of these: the cell's twelve, and six diagonals of its sides, by the same parity.
constexpr uint8_t kTwelve[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                                    {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr uint8_t kSix[2][6][2] = {{{0, 3}, {0, 5}, {0, 6}, {3, 5}, {3, 6}, {5, 6}},
                                   {{1, 2}, {1, 4}, {1, 7}, {2, 4}, {2, 7}, {4, 7}}};
constexpr uint32_t kEdgesOfCell = 18;
const uint8_t (&edge_of_cell(uint32_t odd, uint32_t number))[2] {
  return number < 12 ? kTwelve[number] : kSix[odd][number - 12];
}

Vec3i corner_of(uint32_t q) {
  return {static_cast<int32_t>(q >> 2), static_cast<int32_t>(q >> 1 & 1), static_cast<int32_t>(q & 1)};
}
int32_t determinant(Vec3i a, Vec3i b, Vec3i c) { return static_cast<int32_t>(dot(cross(a, b), c)); }

// A tetrahedron of a cell with its corners in the order of positive volume.
void oriented(uint32_t odd, uint32_t number, uint32_t* corners) {
  for (int k = 0; k < 4; ++k) corners[k] = kFive[odd][number][k];
  const Vec3i a = corner_of(corners[0]);
  if (determinant(corner_of(corners[1]) - a, corner_of(corners[2]) - a, corner_of(corners[3]) - a) < 0) {
    const uint32_t last = corners[3];
    corners[3] = corners[2];
    corners[2] = last;
  }
}

class LatticeMaker {
 public:
  LatticeMaker(const LatticeInput& input, const LatticeBounds& bounds, const VoxelGrid& grid, Lattice* lattice)
      : input_(input), mesh_(*input.mesh), bounds_(bounds), grid_(grid), lattice_(*lattice) {}

  sinew_status run(Arena& arena) {
    grid_.states = arena.alloc<uint8_t>(bounds_.cells);
    if (!copies_.allocate(arena, bounds_) || !sum_.allocate(arena, bounds_.joints)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) sum_.clear(bounds_.joints);
    const sinew_status status = find_copies(input_, bounds_, &grid_, &sum_, arena, &copies_);
    if (status != SINEW_OK) return status;
    uint32_t* const offsets = arena.alloc<uint32_t>(static_cast<size_t>(bounds_.nodes) + 1);
    uint32_t* const members = arena.alloc<uint32_t>(static_cast<size_t>(bounds_.copies) * 36);
    uint8_t* const known = arena.alloc<uint8_t>(bounds_.nodes);
    uint8_t* const listed = arena.alloc<uint8_t>(static_cast<size_t>(bounds_.copies) * 36);
    uint32_t* const face_of = arena.alloc<uint32_t>(bounds_.vertices);
    if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
    if (arena.measuring()) return SINEW_OK;
    join_corners(grid_, bounds_.nodes, &copies_);
    make_tetrahedra();
    weigh_nodes(offsets, members, known);
    connect(offsets, members);
    cut_pieces();
    list_edges(offsets, members, listed);
    fill(offsets, members, known);
    embed(face_of);
    return SINEW_OK;
  }

 private:
  uint32_t parity(uint32_t cell) const {
    const Vec3i at = cell_coordinates(grid_, cell);
    return static_cast<uint32_t>(at.x + at.y + at.z) & 1u;
  }

  void make_tetrahedra() {
    lattice_.node_count = copies_.node_count;
    lattice_.tetrahedron_count = 5 * copies_.count;
    lattice_.split_cells = copies_.split_cells;
    uint32_t orders[2][5][4];
    for (uint32_t odd = 0; odd < 2; ++odd) {
      for (uint32_t t = 0; t < 5; ++t) oriented(odd, t, orders[odd][t]);
    }
    for (uint32_t c = 0; c < copies_.count; ++c) {
      const Vec3i at = cell_coordinates(grid_, copies_.cells[c]);
      const uint32_t* const nodes = copies_.corners + 8 * static_cast<size_t>(c);
      for (uint32_t q = 0; q < 8; ++q) {
        const Vec3i corner = at + corner_of(q);
        lattice_.nodes[nodes[q]] = {corner.x * kCellUnits, corner.y * kCellUnits, corner.z * kCellUnits};
      }
      const uint32_t odd = static_cast<uint32_t>(at.x + at.y + at.z) & 1u;
      for (uint32_t t = 0; t < 5; ++t) {
        for (uint32_t k = 0; k < 4; ++k) {
          lattice_.tetrahedra[(static_cast<size_t>(c) * 5 + t) * 4 + k] = nodes[orders[odd][t][k]];
        }
      }
    }
  }

  // A node's weights from the triangles of its copies, near ones more: squared trilinear shares.
  void weigh_nodes(uint32_t* offsets, uint32_t* members, uint8_t* known) {
    const uint32_t entries = 8 * copies_.surface_count;
    for (uint32_t n = 0; n <= lattice_.node_count; ++n) offsets[n] = 0;
    for (uint32_t i = 0; i < entries; ++i) ++offsets[copies_.corners[i]];
    sum_up(offsets, lattice_.node_count + 1);
    for (uint32_t i = entries; i-- > 0;) members[--offsets[copies_.corners[i]]] = i;
    for (uint32_t n = 0; n < lattice_.node_count; ++n) {
      for (uint32_t m = offsets[n]; m < offsets[n + 1]; ++m) {
        const uint32_t copy = members[m] / 8, cell = copies_.cells[copy];
        const Vec3i corner = corner_of(members[m] % 8);
        for (uint32_t p = copies_.pair_offsets[cell]; p < copies_.pair_offsets[cell + 1]; ++p) {
          if (copies_.pair_copies[p] == copy) add_pair(p, corner);
        }
      }
      lattice_.rows[n] = sum_.take();
      known[n] = lattice_.rows[n].empty() ? 0 : 1;
    }
  }
  void add_pair(uint32_t pair, Vec3i corner) {
    const PairPoint& point = copies_.pair_points[pair];
    const auto share = [](int32_t side, int32_t position) -> int64_t {
      return side != 0 ? position : (1 << 14) - position;
    };
    const int64_t trilinear = (share(corner.x, point.position[0]) * share(corner.y, point.position[1]) *
                               share(corner.z, point.position[2])) >>
                              29;
    const int64_t squared = (trilinear * trilinear) >> 10;  // Q16
    const uint32_t* const at = mesh_.triangles + 3 * static_cast<size_t>(copies_.pair_triangles[pair]);
    for (int k = 0; k < 3; ++k) {
      const int64_t factor = squared * point.shares[k];
      const size_t row = static_cast<size_t>(input_.first_vertices[at[k]]) * bounds_.influences;
      for (uint32_t i = 0; i < bounds_.influences; ++i) {
        sum_.add(input_.joints[row + i], (factor * input_.weights[row + i]) >> 8);
      }
    }
  }

  // Neighbors of every node, in both directions, ascending and unique.
  void connect(uint32_t* offsets, uint32_t* members) {
    const uint32_t count = lattice_.node_count;
    for (uint32_t n = 0; n <= count; ++n) offsets[n] = 0;
    const auto each = [this](const auto& visit) {
      for (uint32_t c = 0; c < copies_.count; ++c) {
        const uint32_t* const nodes = copies_.corners + 8 * static_cast<size_t>(c);
        for (uint32_t e = 0; e < kEdgesOfCell; ++e) {
          const uint8_t(&edge)[2] = edge_of_cell(parity(copies_.cells[c]), e);
          visit(nodes[edge[0]], nodes[edge[1]]);
          visit(nodes[edge[1]], nodes[edge[0]]);
        }
      }
    };
    each([offsets](uint32_t a, uint32_t) { ++offsets[a]; });
    sum_up(offsets, count + 1);
    each([offsets, members](uint32_t a, uint32_t b) { members[--offsets[a]] = b; });
    uint32_t kept = 0;
    for (uint32_t n = 0; n < count; ++n) {
      const uint32_t begin = offsets[n], end = offsets[n + 1];
      sort_ascending(members + begin, end - begin);
      offsets[n] = kept;
      uint32_t last = n;  // no node is its own neighbor
      for (uint32_t m = begin; m < end; ++m) {
        const uint32_t other = members[m];
        if (other == last) continue;
        last = other;
        members[kept++] = other;
      }
    }
    offsets[count] = kept;
  }

  // Cells of one parity on every axis have no corner in common. Copies of one cell may, and stay in one piece.
  void cut_pieces() {
    uint32_t taken = 0, pieces = 0;
    for (uint32_t color = 0; color < kColors; ++color) {
      lattice_.color_pieces[color] = pieces;
      uint32_t begin = taken, cell = 0;
      for (uint32_t c = 0; c < copies_.count; ++c) {
        const Vec3i at = cell_coordinates(grid_, copies_.cells[c]);
        if ((static_cast<uint32_t>(at.x & 1) | static_cast<uint32_t>(at.y & 1) << 1 |
             static_cast<uint32_t>(at.z & 1) << 2) != color) {
          continue;
        }
        if (taken - begin >= kPieceCopies && copies_.cells[c] != cell) {
          lattice_.piece_copies[pieces++] = begin;
          begin = taken;
        }
        cell = copies_.cells[c];
        lattice_.copy_order[taken++] = c;
      }
      if (taken > begin) lattice_.piece_copies[pieces++] = begin;
    }
    lattice_.color_pieces[kColors] = pieces;
    lattice_.piece_copies[pieces] = taken;
  }

  // Edges of one kind follow each other in a piece: they share few nodes, so that a processor need not wait for one to begin
  // the next. listed: of an entry of members.
  void list_edges(const uint32_t* offsets, const uint32_t* members, uint8_t* listed) {
    for (uint32_t m = 0; m < offsets[lattice_.node_count]; ++m) listed[m] = 0;
    lattice_.edge_count = 0;
    for (uint32_t piece = 0; piece < lattice_.piece_count(); ++piece) {
      lattice_.piece_edges[piece] = lattice_.edge_count;
      for (uint32_t e = 0; e < kEdgesOfCell; ++e) {
        for (uint32_t i = lattice_.piece_copies[piece]; i < lattice_.piece_copies[piece + 1]; ++i) {
          const uint32_t copy = lattice_.copy_order[i];
          const uint8_t(&ends)[2] = edge_of_cell(parity(copies_.cells[copy]), e);
          const uint32_t x = copies_.corners[8 * static_cast<size_t>(copy) + ends[0]],
                         y = copies_.corners[8 * static_cast<size_t>(copy) + ends[1]];
          const uint32_t a = x < y ? x : y, b = x < y ? y : x;
          uint32_t m = offsets[a];
          while (members[m] != b) ++m;  // there is one
          if (listed[m] != 0) continue;
          listed[m] = 1;
          lattice_.edges[lattice_.edge_count++] = {a, b};
        }
      }
    }
    lattice_.piece_edges[lattice_.piece_count()] = lattice_.edge_count;
  }

  // Nodes that no triangle is near: the mean of their neighbors, from the outside inwards, then smoothed.
  void fill(const uint32_t* offsets, const uint32_t* members, uint8_t* known) {
    const auto mean = [&](uint32_t n) {
      bool any = false;
      for (uint32_t m = offsets[n]; m < offsets[n + 1]; ++m) {
        if (known[members[m]] == 0) continue;
        sum_.add(lattice_.rows[members[m]], 1);
        any = true;
      }
      if (any) lattice_.rows[n] = sum_.take();
      return any;
    };
    const uint32_t count = lattice_.node_count;
    for (bool more = true; more;) {
      more = false;
      for (uint32_t n = 0; n < count; ++n) {
        if (known[n] == 0 && mean(n)) {
          known[n] = 2;
          more = true;
        }
      }
    }
    for (int round = 0; round < kFillRounds; ++round) {
      for (uint32_t i = 0; i < count; ++i) {
        const uint32_t n = round % 2 == 0 ? count - 1 - i : i;
        if (known[n] == 2) mean(n);
      }
    }
  }

  void embed(uint32_t* face_of) {
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) face_of[v] = mesh_.triangle_count;
    for (uint32_t i = 3 * mesh_.triangle_count; i-- > 0;) face_of[mesh_.triangles[i]] = i / 3;
    for (uint32_t v = 0; v < mesh_.welded_count; ++v) {
      Embedding& position = lattice_.vertices[v];
      position = {kNoTetrahedron, {0, 0, 0, 0}};
      if (face_of[v] == mesh_.triangle_count) continue;
      const uint32_t cell = grid_.cell_of(mesh_.positions[v]);
      for (uint32_t p = copies_.pair_offsets[cell]; p < copies_.pair_offsets[cell + 1]; ++p) {
        if (copies_.pair_triangles[p] == face_of[v])
          embed_in(copies_.pair_copies[p], cell, mesh_.positions[v], &position);
      }
    }
  }

  // In the tetrahedron whose smallest share is the largest. The vertex lies in its cell, so no share is below 0 there, but
  // for rounding.
  void embed_in(uint32_t copy, uint32_t cell, Vec3i position, Embedding* embedding) const {
    const Vec3i at = cell_coordinates(grid_, cell);
    const double size = grid_.cell_size;
    const Vec3d p = {(position.x - grid_.low.x - at.x * grid_.cell_size) / size,
                     (position.y - grid_.low.y - at.y * grid_.cell_size) / size,
                     (position.z - grid_.low.z - at.z * grid_.cell_size) / size};
    double best = -1e9;
    for (uint32_t t = 0; t < 5; ++t) {
      uint32_t corners[4];
      oriented(parity(cell), t, corners);
      const Vec3d a = to_double(corner_of(corners[0])), b = to_double(corner_of(corners[1])) - a,
                  c = to_double(corner_of(corners[2])) - a, d = to_double(corner_of(corners[3])) - a;
      const double volume = dot(b, cross(c, d));
      double shares[4];
      shares[1] = dot(p - a, cross(c, d)) / volume;
      shares[2] = dot(b, cross(p - a, d)) / volume;
      shares[3] = dot(b, cross(c, p - a)) / volume;
      shares[0] = 1 - shares[1] - shares[2] - shares[3];
      double least = shares[0];
      for (int k = 1; k < 4; ++k) least = shares[k] < least ? shares[k] : least;
      if (least <= best) continue;
      best = least;
      embedding->tetrahedron = 5 * copy + t;
      int32_t rest = 1 << kShareBits;
      uint32_t largest = 0;
      for (uint32_t k = 0; k < 4; ++k) {
        const double scaled = shares[k] * (1 << kShareBits) + 0.5;
        embedding->shares[k] = static_cast<int16_t>(scaled < 0 ? 0 : static_cast<int32_t>(scaled));
        rest -= embedding->shares[k];
        if (embedding->shares[k] > embedding->shares[largest]) largest = k;
      }
      embedding->shares[largest] = static_cast<int16_t>(embedding->shares[largest] + rest);
    }
  }

  const LatticeInput& input_;
  const Mesh& mesh_;
  const LatticeBounds& bounds_;
  VoxelGrid grid_;
  Lattice& lattice_;
  Copies copies_;
  RowSum sum_;
};

// Cells that the triangles of a face touch, all summed up: of its fan around the first corner, or around the last one, as a
// face is read that is rotated inwards, whichever is more.
uint64_t face_pairs(const sinew_mesh& mesh, const GridQuantizer& quantizer, const VoxelGrid& grid, uint32_t face) {
  const uint32_t first = mesh.face_offsets != nullptr ? mesh.face_offsets[face] : 3 * face;
  const uint32_t last = mesh.face_offsets != nullptr ? mesh.face_offsets[face + 1] : first + 3;
  const auto position = [&](uint32_t corner) {
    return quantize_point(quantizer, mesh.positions + 3 * static_cast<size_t>(mesh.face_vertices[corner]));
  };
  uint64_t most = 0;
  for (uint32_t pass = 0; pass < (last - first > 3 ? 2u : 1u); ++pass) {
    uint64_t pairs = 0;
    for (uint32_t c = first + 1; c + 1 < last; ++c) {
      const Vec3i corners[3] = {position(pass == 0 ? first : last - 1), position(pass == 0 ? c : c - 1),
                                position(pass == 0 ? c + 1 : c)};
      if (!has_area(corners, 0, 1, 2)) continue;
      each_touched_cell(corners, grid, [&](uint32_t) { ++pairs; });
    }
    most = pairs > most ? pairs : most;
  }
  return most;
}
}  // namespace

bool Lattice::allocate(Arena& arena, const LatticeBounds& bounds) {
  nodes = arena.alloc<Vec3i>(bounds.nodes);
  rows = arena.alloc<WeightRow>(bounds.nodes);
  tetrahedra = arena.alloc<uint32_t>(static_cast<size_t>(bounds.copies) * 20);
  const size_t pieces = bounds.copies / kPieceCopies + kColors + 1;
  copy_order = arena.alloc<uint32_t>(bounds.copies);
  piece_copies = arena.alloc<uint32_t>(pieces);
  piece_edges = arena.alloc<uint32_t>(pieces);
  edges = arena.alloc<LatticeEdge>(static_cast<size_t>(bounds.copies) * 18);
  vertices = arena.alloc<Embedding>(bounds.vertices);
  return arena.ok();
}

sinew_status find_lattice_bounds(const sinew_mesh& mesh, const GridQuantizer& quantizer, uint32_t cells_along,
                                 LatticeBounds* bounds, VoxelGrid* grid) {
  const sinew_status status = check_faces(mesh);
  if (status != SINEW_OK) return status;
  Vec3i low = quantize_point(quantizer, mesh.positions), high = low;
  for (uint32_t v = 1; v < mesh.vertex_count; ++v) {
    grow(quantize_point(quantizer, mesh.positions + 3 * static_cast<size_t>(v)), &low, &high);
  }
  const int32_t cell = (kSide + static_cast<int32_t>(cells_along) - 1) / static_cast<int32_t>(cells_along);
  grid->cell_size = cell;
  grid->low = {low.x - cell - cell * 31 / 100, low.y - cell - cell * 27 / 100, low.z - cell - cell * 37 / 100};
  grid->size[0] = (high.x - grid->low.x) / cell + 2;
  grid->size[1] = (high.y - grid->low.y) / cell + 2;
  grid->size[2] = (high.z - grid->low.z) / cell + 2;
  grid->cell_count = static_cast<uint32_t>(grid->size[0] * grid->size[1] * grid->size[2]);
  for (int axis = 0; axis < 3; ++axis) bounds->size[axis] = grid->size[axis];
  bounds->cells = grid->cell_count;
  bounds->vertices = mesh.vertex_count;
  uint64_t pairs = 0;
  for (uint32_t f = 0; f < mesh.face_count; ++f) pairs += face_pairs(mesh, quantizer, *grid, f);
  if (pairs > kMostPairs) return SINEW_ERROR_COUNT;
  bounds->pairs = static_cast<uint32_t>(pairs);
  const uint32_t x = static_cast<uint32_t>(grid->size[0]), y = static_cast<uint32_t>(grid->size[1]),
                 z = static_cast<uint32_t>(grid->size[2]);
  const uint32_t inner = (x - 2) * (y - 2) * (z - 2);
  bounds->copies = pairs == 0 ? 0 : inner + inner / 8 + (inner < 1024 ? inner : 1024);
  const uint32_t points = (x - 1) * (y - 1) * (z - 1);
  bounds->nodes = pairs == 0 ? 0 : points + points / 2 + 1024;
  return SINEW_OK;
}

sinew_status build_lattice(const LatticeInput& input, const LatticeBounds& bounds, const VoxelGrid& grid, Arena& arena,
                           Lattice* lattice) {
  const ArenaScope scope(arena);
  return LatticeMaker(input, bounds, grid, lattice).run(arena);
}

}  // namespace sinew::deform
