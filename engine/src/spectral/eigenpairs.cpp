// SPDX-License-Identifier: MIT
// Block inverse iteration (Golub and Van Loan, section 8.2) on the fixed-point factor of the heat stage, with one
// Rayleigh-Ritz step at its end.
#include "spectral/eigenpairs.hpp"

#include <string.h>

namespace sinew {
namespace {

constexpr uint32_t kBatches = kSpectralModes / kBatch;
constexpr uint32_t kTile =
    16;  // rows of a Gram product that are gathered first, so that they stay in the nearest cache
// The factor is of L / 16 + M, so that M's multiple is 1: the shift is 4 / pi in the units of Eigenpairs.
constexpr int64_t kShift = 1335088;         // 4 / pi, Q20
constexpr int kRhsShift = kVectorBits + 4;  // right-hand sides are 1 / 16, so that a solution in Q24 is one in Q20
constexpr int64_t kSmallestRatio = static_cast<int64_t>(1) << (kProjectedBits - 10);  // eigenvalues above 1300
constexpr int32_t kRootLimit = 0x7FFFFFFF;

// 1/2 .. 1, from the index alone: no column of the start shall be symmetric by accident.
int64_t jitter_q30(uint32_t position) {
  uint32_t h = (position + 1) * 2654435761u;
  h ^= h >> 15;
  h *= 2246822519u;
  h ^= h >> 13;
  return (static_cast<int64_t>(1) << 29) + (h >> 3);
}

}  // namespace

bool EigenSolver::allocate(Arena& arena, const Counts& counts) {
  ordering_.allocate(arena, counts);
  factor_.allocate(arena, counts);
  matrix_.diagonal = arena.alloc<int64_t>(counts.vertices);
  const size_t entries = static_cast<size_t>(counts.vertices) * kBatch;
  vectors_ = arena.alloc<int32_t>(kBatches * entries);
  rhs_ = arena.alloc<int64_t>(entries);
  image_ = arena.alloc<int32_t>(entries);
  mass_ = arena.alloc<int64_t>(counts.vertices);
  small_ = arena.alloc<int64_t[kSpectralModes]>(kSpectralModes);
  rotation_ = arena.alloc<int64_t[kSpectralModes]>(kSpectralModes);
  orthonormalizer_ = arena.alloc<Orthonormalizer>(1);
  return arena.ok();
}

void EigenSolver::load(uint32_t position, int32_t* row) const {
  for (uint32_t b = 0; b < batches_; ++b) memcpy(row + b * kBatch, at(b, position), kBatch * sizeof(row[0]));
}

void EigenSolver::store(uint32_t position, const int32_t* row) {
  for (uint32_t b = 0; b < batches_; ++b) memcpy(at(b, position), row + b * kBatch, kBatch * sizeof(row[0]));
}

// One column per run of vertices in Morton order (compact pieces of about equal mass and vertex count); small
// parts get the identity. Columns do not overlap, so they are orthogonal from the start.
void EigenSolver::start() {
  const uint32_t rows = matrix_.rows;
  memset(vectors_, 0, static_cast<size_t>(batches_) * rows * kBatch * sizeof(vectors_[0]));
  const uint32_t* vertices = matrix_.mesh->part_vertices;
  const uint32_t first = matrix_.mesh->part_offsets[matrix_.mesh->part[ordering_.order[0]]];
  int64_t before = 0;  // Q40 of the part's mass
  uint32_t begin = 0, column = 0;
  while (begin < rows) {
    // Runs end where vertex count and mass together reach the next of `columns_` equal shares.
    uint32_t end = begin;
    int64_t norm = 0;  // Q40
    while (end < rows) {
      const int64_t m = mass_[ordering_.position[vertices[first + end]]];
      const int64_t share =
          rows <= columns_ ? end
                           : ((((static_cast<int64_t>(end) << kMassBits) / rows + before) / 2) * columns_) >> kMassBits;
      if (end > begin && share > column) break;
      before += m;
      norm += mul_shift(m, mul_shift(jitter_q30(end), jitter_q30(end), 30), 30);
      ++end;
    }
    // The jitter over the root of its sum: mass norm 1.
    const int64_t root = isqrt64(static_cast<uint64_t>(norm > 1 ? norm : 1) << (2 * kRootMassBits - kMassBits));
    if (column >= columns_) column = columns_ - 1;
    for (uint32_t i = begin; i < end; ++i) {
      const int64_t value = jitter_q30(i) * (static_cast<int64_t>(1) << kVectorBits) / (root > 0 ? root : 1);
      at(column / kBatch, ordering_.position[vertices[first + i]])[column % kBatch] =
          clamp32(value, -kVectorLimit, kVectorLimit);
    }
    ++column;
    begin = end;
  }
}

// Batch <- (L / 16 + M)^-1 M batch, into image_.
void EigenSolver::image(uint32_t batch) {
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const int32_t* x = at(batch, k);
    const int64_t m = matrix_.to_matrix(mass_[k]);
    int64_t* r = rhs_ + static_cast<size_t>(k) * kBatch;
    for (uint32_t member = 0; member < kBatch; ++member) r[member] = mul_shift(m, x[member], kRhsShift);
  }
  factor_.solve(matrix_.rows, rhs_, image_);
  for (size_t i = 0; i < static_cast<size_t>(matrix_.rows) * kBatch; ++i) {
    image_[i] = clamp32(image_[i], -kVectorLimit, kVectorLimit);
  }
}

// Gram matrix of the columns under the masses, Q60, lower triangle.
void EigenSolver::gram() {
  memset(small_, 0, sizeof(small_[0]) * kSpectralModes);
  int32_t tile[kSpectralModes][kTile];  // sqrt(mass) times value, Q30
  for (uint32_t first = 0; first < matrix_.rows; first += kTile) {
    const uint32_t count = matrix_.rows - first < kTile ? matrix_.rows - first : kTile;
    for (uint32_t r = 0; r < kTile; ++r) {
      const int64_t root = r < count ? op_->root_mass[ordering_.order[first + r]] : 0;
      int32_t row[kSpectralModes] = {};
      if (r < count) load(first + r, row);
      for (uint32_t j = 0; j < columns_; ++j) {
        tile[j][r] = clamp32((root * row[j]) >> kVectorBits, -kRootLimit, kRootLimit);
      }
    }
    for (uint32_t i = 0; i < columns_; ++i) {
      for (uint32_t j = 0; j <= i; ++j) {
        uint64_t sum = 0;
        for (uint32_t r = 0; r < kTile; ++r)
          sum += static_cast<uint64_t>(static_cast<int64_t>(tile[i][r]) * tile[j][r]);
        small_[i][j] = wrapping_add(small_[i][j], static_cast<int64_t>(sum));
      }
    }
  }
}

void EigenSolver::orthonormalize() {
  gram();
  orthonormalizer_->prepare(small_, columns_);
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    int32_t row[kSpectralModes] = {};
    load(k, row);
    orthonormalizer_->apply(row, columns_);
    store(k, row);
  }
}

// Columns of this batch of X^T M (L / 16 + M)^-1 M X, rows from this batch on (the rest is symmetric): those of X that
// are still there while the images replace it batch by batch. Q60 sums.
void EigenSolver::project(uint32_t batch) {
  const uint32_t from = batch * kBatch;
  for (uint32_t k = 0; k < matrix_.rows; ++k) {
    const int64_t root = op_->root_mass[ordering_.order[k]];
    int64_t y[kBatch];
    const int32_t* z = image_ + static_cast<size_t>(k) * kBatch;
    for (uint32_t member = 0; member < kBatch; ++member)
      y[member] = clamp32((root * z[member]) >> kVectorBits, -kRootLimit, kRootLimit);
    for (uint32_t b = batch; b < batches_; ++b) {
      const int32_t* x = at(b, k);
      for (uint32_t i = 0; i < kBatch; ++i) {
        const int64_t left = clamp32((root * x[i]) >> kVectorBits, -kRootLimit, kRootLimit);
        int64_t* target = small_[b * kBatch + i] + from;
        for (uint32_t member = 0; member < kBatch; ++member)
          target[member] = wrapping_add(target[member], left * y[member]);
      }
    }
  }
}

void EigenSolver::finish(Eigenpairs* out) {
  const uint32_t n = columns_;
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j <= i; ++j) {
      small_[i][j] = clamp32(round_shift(small_[i][j], kGramBits - kProjectedBits), -kRootLimit, kRootLimit);
      small_[j][i] = small_[i][j];
    }
  }
  symmetric_eigenpairs(small_, rotation_, n);
  // By falling ratio; the largest, 1, is the constant vector's.
  uint32_t order[kSpectralModes];
  for (uint32_t i = 0; i < n; ++i) {
    uint32_t position = i;
    for (; position > 0 && small_[order[position - 1]][order[position - 1]] < small_[i][i]; --position)
      order[position] = order[position - 1];
    order[position] = i;
  }
  out->count = 0;
  for (uint32_t i = 1; i < n; ++i) {
    const int64_t ratio = small_[order[i]][order[i]];
    if (ratio < kSmallestRatio) break;
    const int64_t rest = (static_cast<int64_t>(1) << kProjectedBits) - ratio;
    out->value[out->count] = (rest > 0 ? rest : 0) * kShift / ratio;
    out->column[out->count++] = order[i];
  }
  // Columns of Z V / ratio; the projection saw X, and one more inverse step for nothing comes with it.
  int32_t(*weights)[kSpectralModes] = orthonormalizer_->upper;  // [row of V][index in `column`] Q20
  for (uint32_t k = 0; k < out->count; ++k) {
    const int64_t ratio = small_[out->column[k]][out->column[k]];
    for (uint32_t i = 0; i < n; ++i) {
      // A product, since a left shift of a negative number is undefined in C++17.
      const int64_t quotient =
          rotation_[out->column[k]][i] * (static_cast<int64_t>(1) << (kProjectedBits - 10)) / ratio;
      weights[i][k] = clamp32(quotient, -(1 << 30), 1 << 30);
    }
  }
  int64_t norm[kSpectralModes] = {};  // Q44
  for (uint32_t p = 0; p < matrix_.rows; ++p) {
    int32_t row[kSpectralModes] = {};
    load(p, row);
    uint64_t sum[kSpectralModes] = {};
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t k = 0; k < out->count; ++k)
        sum[k] += static_cast<uint64_t>(static_cast<int64_t>(row[i]) * weights[i][k]);
    }
    const int64_t root = op_->root_mass[ordering_.order[p]];
    memset(row, 0, sizeof(row));
    for (uint32_t k = 0; k < out->count; ++k) {
      row[k] = clamp32(round_shift(static_cast<int64_t>(sum[k]), 20), -kVectorLimit, kVectorLimit);
      const int64_t y = clamp32((root * row[k]) >> kVectorBits, -kRootLimit, kRootLimit);
      norm[k] += (y * y) >> 16;
    }
    store(p, row);
  }
  for (uint32_t k = 0; k < out->count; ++k) {
    out->column[k] = k;
    const int64_t q30 = norm[k] >> 14;
    out->square_scale[k] = (static_cast<int64_t>(1) << 60) / (q30 > (1 << 29) ? q30 : 1 << 29);
  }
}

bool EigenSolver::solve(const Mesh& mesh, SpectralOperator& op, uint32_t part, Eigenpairs* out) {
  op_ = &op;
  op.weigh_vertices(mesh, part);
  matrix_.mesh = &mesh;
  matrix_.edges = &op.edges;
  matrix_.ordering = &ordering_;
  matrix_.rows = mesh.part_sizes[part];
  columns_ = matrix_.rows < kSpectralModes ? matrix_.rows : kSpectralModes;
  batches_ = (columns_ + kBatch - 1) / kBatch;
  ordering_.dissect(mesh, part);
  for (uint32_t k = 0; k < matrix_.rows; ++k) mass_[k] = op.mass[ordering_.order[k]];
  if (!factor_.analyze(matrix_)) return false;
  matrix_.assemble(mass_, kFactorDiagonalBits);
  factor_.factorise(matrix_);

  start();
  const uint32_t steps = matrix_.rows <= kSpectralModes ? 1 : kSubspaceSteps;
  for (uint32_t step = 0; step < steps; ++step) {
    const bool last = step + 1 == steps;
    if (step > 0) orthonormalize();
    if (last) memset(small_, 0, sizeof(small_[0]) * kSpectralModes);
    for (uint32_t b = 0; b < batches_; ++b) {
      image(b);
      if (last) project(b);
      memcpy(at(b, 0), image_, static_cast<size_t>(matrix_.rows) * kBatch * sizeof(image_[0]));
    }
  }
  finish(out);
  return true;
}

}  // namespace sinew
