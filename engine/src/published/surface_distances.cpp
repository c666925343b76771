// SPDX-License-Identifier: MIT
// One factorisation a mesh, two solves for eight reference points, one pass for the diagonal.
#include "published/surface_distances.hpp"

#include <string.h>

#include "features/parts.hpp"

namespace sinew::transferring {
namespace {

constexpr uint32_t kBatch = SparseLdl::kBatch;
constexpr uint32_t kMostTies = 24;  // of a part
constexpr double kTieWeight = 1;    // L is in cotangents: a tie is about as stiff as an edge

// Twice what solve/factor.hpp reserves for a Laplacian, for ties.
size_t tied_entries(uint32_t vertices) {
  size_t levels = 0;
  for (uint32_t v = vertices; v > 1; v = (v + 1) / 2) ++levels;
  return (40 + levels * levels / 2) * vertices;
}

const TrianglePosition& position_of(const References& references, uint32_t i, bool on_source) {
  return on_source ? references.points[i].source : references.points[i].target;
}

}  // namespace

void SurfaceDistances::Ties::add(uint32_t a, uint32_t b) {
  const uint32_t ends[2] = {a, b};
  for (uint32_t k = 0; k < 2; ++k) {
    other[count] = ends[1 - k];
    next[count] = first[ends[k]];
    first[ends[k]] = count++;
  }
}

bool SurfaceDistances::allocate(Arena& arena, const Counts& counts) {
  const uint32_t vertices = counts.vertices;
  (void)plate_.allocate(arena, counts);
  (void)ordering_.allocate(arena, counts);
  ties_.next = arena.alloc<uint32_t>(size_t{2} * vertices);
  ties_.other = arena.alloc<uint32_t>(size_t{2} * vertices);
  ties_.first = arena.alloc<uint32_t>(vertices);
  (void)ldl_.allocate(arena, vertices, tied_entries(vertices));
  (void)ldl_.allocate_rates(arena, vertices);
  uint32_t** const arrays[] = {&position_, &order_, &host_, &host_distance_};
  for (uint32_t** array : arrays) *array = arena.alloc<uint32_t>(vertices);
  keys_ = arena.alloc<uint64_t>(vertices);
  x_ = arena.alloc<double>(size_t{kBatch} * vertices);
  diagonal_ = arena.alloc<double>(vertices);
  area_ = arena.alloc<double>(vertices);
  return arena.ok();
}

sinew_status SurfaceDistances::find(const Mesh& mesh, const References& references, bool on_source,
                                    const Counts& counts, Arena& arena, double* out) {
  const sinew_status status = find_hosts(mesh, counts, arena, host_, host_distance_);
  if (status != SINEW_OK || arena.measuring()) return status;
  plate_.fill(mesh);
  tie_parts(mesh);
  order_vertices(mesh);
  if (!factorise(mesh)) return SINEW_ERROR_COUNT;
  area_sum_ = 0;
  for (uint32_t k = 0; k < mesh.welded_count; ++k) {
    area_[k] = plate_.area[order_[k]];
    area_sum_ += area_[k];
  }
  for (uint32_t first = 0; first < references.count; first += kBatch)
    solve_columns(mesh, references, on_source, first, out);
  find_diagonal(mesh.welded_count);
  turn_to_distances(mesh, references, on_source, out);
  return SINEW_OK;
}

void SurfaceDistances::tie_parts(const Mesh& mesh) {
  ties_.count = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) ties_.first[v] = kNoVertex;
  for (uint32_t part = 1; part < mesh.part_count; ++part) {
    const uint32_t begin = mesh.part_offsets[part], size = mesh.part_sizes[part];
    for (uint32_t i = 0; i < size; ++i) {
      const uint32_t v = mesh.part_vertices[begin + i];
      keys_[i] = (static_cast<uint64_t>(host_distance_[v]) << 32) | v;
    }
    heap_sort(keys_, size, [](uint64_t a, uint64_t b) { return a < b; });
    uint32_t count = size / 4 > 3 ? size / 4 : size < 3 ? size : 3;
    if (count > kMostTies) count = kMostTies;
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t v = static_cast<uint32_t>(keys_[i]);
      ties_.add(v, host_[v]);
    }
  }
}

// Small parts first, so that few ties fill up what is eliminated late.
void SurfaceDistances::order_vertices(const Mesh& mesh) {
  uint32_t next = 0;
  for (uint32_t part = mesh.part_count; part-- > 0;) {
    ordering_.dissect(mesh, part);
    for (uint32_t i = 0; i < mesh.part_sizes[part]; ++i) {
      order_[next] = ordering_.order[i];
      position_[order_[next]] = next;
      ++next;
    }
  }
}

bool SurfaceDistances::factorise(const Mesh& mesh) {
  return ldl_.factorise(mesh.welded_count - 1, [&](uint32_t k, const auto& visit) {
    const uint32_t v = order_[k];
    plate_.laplacian(v, [&](uint32_t w, double value) { visit(position_[w], value); });
    for (uint32_t e = ties_.first[v]; e != kNoVertex; e = ties_.next[e]) {
      visit(k, kTieWeight);
      visit(position_[ties_.other[e]], -kTieWeight);
    }
  });
}

// Takes the mean by area off each column of x_, whose last row is that of the vertex that is held.
void SurfaceDistances::center(uint32_t count) {
  double sums[kBatch] = {};
  for (uint32_t k = 0; k < count; ++k)
    for (uint32_t m = 0; m < kBatch; ++m) sums[m] += area_[k] * x_[size_t{kBatch} * k + m];
  for (uint32_t k = 0; k < count; ++k)
    for (uint32_t m = 0; m < kBatch; ++m) x_[size_t{kBatch} * k + m] -= sums[m] / area_sum_;
}

// K is the inverse with a row and column of zeros for the vertex that is held. Without its means K's row at x has the square
// (K A K)(x, x) - (K a)(x)^2 / sum of a.
void SurfaceDistances::find_diagonal(uint32_t count) {
  const uint32_t held = count - 1;
  for (uint32_t k = 0; k < held; ++k)
    for (uint32_t m = 0; m < kBatch; ++m) x_[size_t{kBatch} * k + m] = m == 0 ? area_[k] : 0;
  ldl_.solve(x_);
  ldl_.square_diagonal(area_, diagonal_);
  for (uint32_t k = 0; k < held; ++k) {
    const double mean = x_[size_t{kBatch} * k];
    diagonal_[k] -= mean * mean / area_sum_;
  }
  diagonal_[held] = 0;
}

void SurfaceDistances::solve_columns(const Mesh& mesh, const References& references, bool on_source, uint32_t first,
                                     double* out) {
  const uint32_t size = references.count - first < kBatch ? references.count - first : kBatch;
  const uint32_t held = mesh.welded_count - 1;
  memset(x_, 0, size_t{kBatch} * mesh.welded_count * sizeof *x_);
  for (uint32_t m = 0; m < size; ++m) {
    const TrianglePosition& p = position_of(references, first + m, on_source);
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t k = position_[p.corners[c]];
      if (k != held) x_[size_t{kBatch} * k + m] += p.shares[c];
    }
  }
  ldl_.solve(x_);
  center(mesh.welded_count);
  for (uint32_t k = 0; k < held; ++k)
    for (uint32_t m = 0; m < kBatch; ++m) x_[size_t{kBatch} * k + m] *= area_[k];
  for (uint32_t m = 0; m < kBatch; ++m) x_[size_t{kBatch} * held + m] = 0;
  ldl_.solve(x_);
  for (uint32_t m = 0; m < size; ++m) {
    double* const column = out + size_t{first + m} * mesh.welded_count;
    for (uint32_t k = 0; k < mesh.welded_count; ++k) column[order_[k]] = x_[size_t{kBatch} * k + m];
  }
}

void SurfaceDistances::turn_to_distances(const Mesh& mesh, const References& references, bool on_source,
                                         double* g) const {
  const uint32_t n = references.count;
  double mean = 0;
  for (uint32_t i = 0; i < n; ++i) {
    double* const column = g + size_t{i} * mesh.welded_count;
    const double own = mean_at(position_of(references, i, on_source), column);
    for (uint32_t v = 0; v < mesh.welded_count; ++v)
      column[v] = root(greater(diagonal_[position_[v]] + own - 2 * column[v], 0));
    for (uint32_t j = 0; j < n; ++j) mean += mean_at(position_of(references, j, on_source), column);
  }
  mean /= static_cast<double>(n) * n;
  const double scale = mean > 1e-150 ? 1 / mean : 0;
  for (size_t i = 0; i < size_t{n} * mesh.welded_count; ++i) g[i] *= scale;
}

}  // namespace sinew::transferring
