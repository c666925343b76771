// SPDX-License-Identifier: MIT
// Green's functions of the reference points on both meshes, the distances they make, and the nearest in those.
#include "transfer/biharmonic.hpp"

#include <string.h>

#include "core/eigenpairs.hpp"
#include "features/parts.hpp"
#include "solve/ordering.hpp"
#include "transfer/references.hpp"
#include "transfer/sparse_ldl.hpp"
#include "transfer/thin_plate.hpp"

namespace sinew {
namespace {

constexpr uint32_t kBatch = SparseLdl::kBatch;
constexpr uint32_t kMostTies = 24;  // edges that tie a part to larger ones
constexpr double kTieWeight = 1;
constexpr double kGround = 1e-9;        // of L's trace, spread over the areas: L alone is singular
constexpr double kNearDistance = 0.02;  // added to distances before they are inverted

uint32_t most_references(const TransferPlan& plan) {
  return plan.pair_count > kFoundReferences ? plan.pair_count : kFoundReferences;
}

// A tie between two parts, listed at both of its vertices.
struct Ties {
  uint32_t* next = nullptr;   // [2 x most] the next entry of the same vertex, or kNoVertex
  uint32_t* other = nullptr;  // [2 x most]
  uint32_t* first = nullptr;  // [U]
  uint32_t count = 0;

  bool allocate(Arena& arena, uint32_t vertices) {
    next = arena.alloc<uint32_t>(size_t{2} * vertices);
    other = arena.alloc<uint32_t>(size_t{2} * vertices);
    first = arena.alloc<uint32_t>(vertices);
    return arena.ok();
  }
  void add(uint32_t a, uint32_t b) {
    const uint32_t ends[2] = {a, b};
    for (uint32_t k = 0; k < 2; ++k) {
      other[count] = ends[1 - k];
      next[count] = first[ends[k]];
      first[ends[k]] = count++;
    }
  }
};

// The distances of one mesh's vertices to the reference points.
class Distances {
 public:
  bool allocate(Arena& arena, const Counts& counts, uint32_t references) {
    vertices_ = counts.vertices;
    size_t levels = 0;
    for (uint32_t v = counts.vertices; v > 1; v = (v + 1) / 2) ++levels;
    (void)plate_.allocate(arena, counts);
    (void)ordering_.allocate(arena, counts);
    (void)ties_.allocate(arena, counts.vertices);
    (void)ldl_.allocate(arena, counts.vertices, (40 + levels * levels / 2) * counts.vertices);
    position_ = arena.alloc<uint32_t>(counts.vertices);
    order_ = arena.alloc<uint32_t>(counts.vertices);
    host_ = arena.alloc<uint32_t>(counts.vertices);
    host_distance_ = arena.alloc<uint32_t>(counts.vertices);
    keys_ = arena.alloc<uint64_t>(counts.vertices);
    x_ = arena.alloc<double>(size_t{kBatch} * counts.vertices);
    own_ = arena.alloc<double>(counts.vertices);
    const size_t square = size_t{references} * references;
    matrix_ = arena.alloc<double>(square);
    vectors_ = arena.alloc<double>(square);
    return arena.ok();
  }

  //   places  reference i is places[i * stride].source or .target
  //   out     [U x references.count]
  sinew_status find(const Mesh& mesh, const References& references, bool on_source, const Counts& counts, Arena& arena,
                    double* out) {
    const sinew_status status = find_hosts(mesh, counts, arena, host_, host_distance_);
    if (status != SINEW_OK || arena.measuring()) return status;
    plate_.fill(mesh);
    tie_parts(mesh);
    order_vertices(mesh);
    if (!factorise(mesh)) return SINEW_ERROR_COUNT;
    const auto position = [&](uint32_t i) -> const TrianglePosition& {
      return on_source ? references.points[i].source : references.points[i].target;
    };
    for (uint32_t first = 0; first < references.count; first += kBatch)
      solve_columns(mesh, references.count, first, position, out);
    turn_to_distances(mesh, references.count, position, out);
    return SINEW_OK;
  }

 private:
  // Every part is tied to larger ones by the quarter of its vertices that is nearest to them, at most kMostTies.
  void tie_parts(const Mesh& mesh) {
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
  void order_vertices(const Mesh& mesh) {
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

  bool factorise(const Mesh& mesh) {
    double trace = 0, area = 0;
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      trace += plate_.whole[v];
      area += plate_.area[v];
      for (uint32_t e = ties_.first[v]; e != kNoVertex; e = ties_.next[e]) trace += kTieWeight;
    }
    const double ground = kGround * (trace > 0 ? trace : 1) / area;
    return ldl_.factorise(mesh.welded_count, [&](uint32_t k, const auto& visit) {
      const uint32_t v = order_[k];
      plate_.laplacian(v, [&](uint32_t w, double value) { visit(position_[w], value); });
      for (uint32_t e = ties_.first[v]; e != kNoVertex; e = ties_.next[e]) {
        visit(k, kTieWeight);
        visit(position_[ties_.other[e]], -kTieWeight);
      }
      visit(k, ground * plate_.area[v]);
    });
  }

  // Takes the mean by area off each column of x_, which is in the order of elimination.
  void centre(const Mesh& mesh) {
    double sums[kBatch] = {}, area = 0;
    for (uint32_t k = 0; k < mesh.welded_count; ++k) {
      const double own = plate_.area[order_[k]];
      area += own;
      for (uint32_t m = 0; m < kBatch; ++m) sums[m] += own * x_[size_t{kBatch} * k + m];
    }
    for (uint32_t k = 0; k < mesh.welded_count; ++k)
      for (uint32_t m = 0; m < kBatch; ++m) x_[size_t{kBatch} * k + m] -= sums[m] / area;
  }

  // Columns of the pseudo-inverse of L A^-1 L: two solves each.
  template <class PositionOf>
  void solve_columns(const Mesh& mesh, uint32_t count, uint32_t first, const PositionOf& position, double* out) {
    const uint32_t size = count - first < kBatch ? count - first : kBatch;
    double area = 0;
    for (uint32_t v = 0; v < mesh.welded_count; ++v) area += plate_.area[v];
    for (uint32_t k = 0; k < mesh.welded_count; ++k)
      for (uint32_t m = 0; m < kBatch; ++m) x_[size_t{kBatch} * k + m] = -plate_.area[order_[k]] / area;
    for (uint32_t m = 0; m < size; ++m) {
      const TrianglePosition& p = position(first + m);
      for (uint32_t c = 0; c < 3; ++c) x_[size_t{kBatch} * position_[p.corners[c]] + m] += p.shares[c];
    }
    ldl_.solve(x_);
    centre(mesh);
    for (uint32_t k = 0; k < mesh.welded_count; ++k)
      for (uint32_t m = 0; m < kBatch; ++m) x_[size_t{kBatch} * k + m] *= plate_.area[order_[k]];
    ldl_.solve(x_);
    centre(mesh);
    for (uint32_t k = 0; k < mesh.welded_count; ++k)
      for (uint32_t m = 0; m < size; ++m) out[size_t{count} * order_[k] + first + m] = x_[size_t{kBatch} * k + m];
  }

  // d(x, i)^2 = g(x, x) + g(i, i) - 2 g(x, i), the first by Nystroem's approximation; divided by the mean distance between
  // reference points.
  template <class PositionOf>
  void turn_to_distances(const Mesh& mesh, uint32_t n, const PositionOf& position, double* g) {
    const auto at = [&](const TrianglePosition& p, uint32_t column) {
      return p.shares[0] * g[size_t{n} * p.corners[0] + column] + p.shares[1] * g[size_t{n} * p.corners[1] + column] +
             p.shares[2] * g[size_t{n} * p.corners[2] + column];
    };
    double* const gyy = own_;  // the diagonal; n is at most SINEW_MAX_TRANSFER_PAIRS
    double diagonal[SINEW_MAX_TRANSFER_PAIRS];
    for (uint32_t i = 0; i < n; ++i)
      for (uint32_t j = 0; j < n; ++j) matrix_[i * n + j] = 0.5 * (at(position(i), j) + at(position(j), i));
    for (uint32_t i = 0; i < n; ++i) diagonal[i] = matrix_[i * n + i];
    find_eigenpairs(n, matrix_, vectors_);
    double largest = 0;
    for (uint32_t i = 0; i < n; ++i) largest = greater(largest, matrix_[i * n + i]);
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      const double* const row = g + size_t{n} * v;
      double sum = 0;
      for (uint32_t i = 0; i < n; ++i) {
        const double value = matrix_[i * n + i];
        if (!(value > 1e-9 * largest)) continue;
        double along = 0;
        for (uint32_t k = 0; k < n; ++k) along += row[k] * vectors_[k * n + i];
        sum += along * along / value;
      }
      gyy[v] = sum;
    }
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      double* const row = g + size_t{n} * v;
      for (uint32_t i = 0; i < n; ++i) row[i] = root(greater(gyy[v] + diagonal[i] - 2 * row[i], 0));
    }
    double mean = 0;
    for (uint32_t i = 0; i < n; ++i)
      for (uint32_t j = 0; j < n; ++j) mean += at(position(j), i);
    mean /= static_cast<double>(n) * n;
    const double scale = mean > 1e-150 ? 1 / mean : 0;
    for (size_t i = 0; i < size_t{n} * mesh.welded_count; ++i) g[i] *= scale;
  }

  uint32_t vertices_ = 0;
  ThinPlate plate_;
  Ordering ordering_;
  Ties ties_;
  SparseLdl ldl_;
  uint32_t *position_ = nullptr, *order_ = nullptr, *host_ = nullptr, *host_distance_ = nullptr;
  uint64_t* keys_ = nullptr;
  double *x_ = nullptr, *own_ = nullptr, *matrix_ = nullptr, *vectors_ = nullptr;
};

// What is compared in place of distances: near references decide. Squares sum to 1, so that this is Hellinger's distance.
void turn_to_nearness(double* row, uint32_t n) {
  double sum = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const double d = row[i] + kNearDistance;
    row[i] = 1 / (d * d);
    sum += row[i];
  }
  for (uint32_t i = 0; i < n; ++i) row[i] = root(row[i] / sum);
}

double squared_distance(const double* a, const double* b, uint32_t n, double limit) {
  constexpr uint32_t kRun = 8;
  double sum = 0;
  for (uint32_t i = 0; i < n && sum < limit;) {
    const uint32_t end = i + kRun < n ? i + kRun : n;
    for (; i < end; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return sum;
}

// The five of `source` that are most like `own`, and their shares.
void find_nearest(const double* source, const uint8_t* of_use, uint32_t count, const double* own, uint32_t n,
                  uint32_t* vertices, double* shares) {
  constexpr uint32_t kNearest = DistanceMatch::kNearest;
  double best[kNearest];
  uint32_t found = 0;
  for (uint32_t s = 0; s < count; ++s) {
    if (of_use[s] == 0) continue;
    const double limit = found < kNearest ? 1e300 : best[kNearest - 1];
    const double d = squared_distance(source + size_t{n} * s, own, n, limit);
    if (d >= limit) continue;
    uint32_t at = found < kNearest ? found++ : kNearest - 1;
    for (; at > 0 && best[at - 1] > d; --at) {
      best[at] = best[at - 1];
      vertices[at] = vertices[at - 1];
    }
    best[at] = d;
    vertices[at] = s;
  }
  double sum = 0;
  const double farthest = root(best[found - 1]);
  for (uint32_t i = 0; i < found; ++i) {
    shares[i] = 1 / (root(best[i]) + 0.05 * farthest + 1e-9);
    sum += shares[i];
  }
  for (uint32_t i = 0; i < kNearest; ++i) {
    if (i >= found) vertices[i] = vertices[0];
    shares[i] = i < found ? shares[i] / sum : 0;
  }
}

}  // namespace

void DistanceMatch::carry(const Rows& source_rows, uint32_t vertex, const Rows& out) const {
  out.clear(vertex);
  for (uint32_t k = 0; k < kNearest; ++k) {
    const uint32_t from = vertices[size_t{kNearest} * vertex + k];
    const double share = shares[size_t{kNearest} * vertex + k];
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      const uint16_t joint = source_rows.joints_of(from)[i];
      const uint32_t weight = static_cast<uint32_t>(share * source_rows.weights_of(from)[i] + 0.5);
      if (joint != kNoJoint && weight > 0) out.add(vertex, joint, weight);
    }
  }
  make_whole(out, vertex);
}

sinew_status match_by_distances(const TransferPlan& plan, const Pair& pair, const Rows& source_rows, Arena& arena,
                                DistanceMatch* match) {
  constexpr uint32_t kFewest = 4;
  const ArenaScope scope(arena);
  References references;
  const uint32_t most = most_references(plan);
  (void)references.allocate(arena, plan);
  uint8_t* const of_use = arena.alloc<uint8_t>(plan.source.vertices);
  double* const source = arena.alloc<double>(size_t{most} * plan.source.vertices);
  double* const target = arena.alloc<double>(size_t{most} * plan.target.vertices);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  sinew_status status = references.find(plan, pair, arena);
  if (status != SINEW_OK) return status;
  if (!arena.measuring() && references.count < kFewest) return SINEW_ERROR_RANGE;
  for (uint32_t side = 0; side < 2; ++side) {
    const ArenaScope one(arena);
    Distances distances;
    const Counts& counts = side == 0 ? plan.source : plan.target;
    if (!distances.allocate(arena, counts, most)) return SINEW_ERROR_WORKSPACE;
    status = distances.find(side == 0 ? pair.source : pair.target, references, side == 0, counts, arena,
                            side == 0 ? source : target);
    if (status != SINEW_OK) return status;
  }
  if (arena.measuring()) return SINEW_OK;
  const uint32_t n = references.count;
  match->reference_count = n;
  uint32_t useful = 0;
  for (uint32_t s = 0; s < pair.source.welded_count; ++s) {
    of_use[s] = 0;
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      const uint16_t joint = source_rows.joints_of(s)[i];
      if (joint != kNoJoint && source_rows.weights_of(s)[i] > 0 && pair.map.takes[joint] >= 0) of_use[s] = 1;
    }
    useful += of_use[s];
    if (!plan.as_drawn) turn_to_nearness(source + size_t{n} * s, n);
  }
  if (useful == 0) return SINEW_ERROR_RANGE;
  constexpr uint32_t kVertexPiece = 64;
  plan.target.threads.ranges(pair.target.welded_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) {
      double* const own = target + size_t{n} * v;
      if (!plan.as_drawn) turn_to_nearness(own, n);
      find_nearest(source, of_use, pair.source.welded_count, own, n,
                   match->vertices + size_t{DistanceMatch::kNearest} * v,
                   match->shares + size_t{DistanceMatch::kNearest} * v);
    }
  });
  return SINEW_OK;
}

}  // namespace sinew
