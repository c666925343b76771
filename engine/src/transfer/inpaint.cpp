// SPDX-License-Identifier: MIT
// One factorisation a part, eight joints at a time.
#include "transfer/inpaint.hpp"

#include <string.h>

#include "solve/ordering.hpp"
#include "transfer/sparse_ldl.hpp"

namespace sinew::transferring {
namespace {

constexpr uint32_t kMostUnknown = 32768;
constexpr uint32_t kNowhere = 0xFFFFFFFFu;

// Entries of L that are reserved: three times what solve/factor.hpp reserves for a Laplacian; the plate couples vertices two
// edges apart.
size_t plate_entries(uint32_t rows) {
  size_t levels = 0;
  for (uint32_t v = rows; v > 1; v = (v + 1) / 2) ++levels;
  const size_t a_row = 30 + levels * levels * 3 / 5;
  return a_row * rows;
}

struct Inpainting {
  ThinPlate plate;
  Ordering ordering;
  SparseLdl ldl;
  Rows filled;                   // of the unknown vertices of a part, in the order of elimination
  uint32_t* unknown = nullptr;   // [U] vertices of a part in that order
  uint32_t* position = nullptr;  // [U] and back, kNowhere for others
  uint16_t* joint_list = nullptr;
  uint8_t* is_listed = nullptr;  // [J]
  double* x = nullptr;           // [most unknown x kBatch]
  uint32_t most = 0;

  bool allocate(Arena& arena, const Counts& counts, uint32_t joints) {
    most = counts.vertices < kMostUnknown ? counts.vertices : kMostUnknown;
    (void)plate.allocate(arena, counts);
    (void)ordering.allocate(arena, counts);
    (void)ldl.allocate(arena, most, plate_entries(most));
    Counts few = counts;
    few.vertices = most;
    (void)filled.allocate(arena, few);
    unknown = arena.alloc<uint32_t>(counts.vertices);
    position = arena.alloc<uint32_t>(counts.vertices);
    joint_list = arena.alloc<uint16_t>(joints);
    is_listed = arena.alloc<uint8_t>(joints);
    x = arena.alloc<double>(static_cast<size_t>(most) * SparseLdl::kBatch);
    return arena.ok();
  }

  // Joints of the rows within two edges of the unknown vertices.
  uint32_t list_joints(const Rows& rows, uint32_t count, uint32_t joints) {
    memset(is_listed, 0, joints);
    for (uint32_t i = 0; i < count; ++i) {
      plate.plate(unknown[i], [&](uint32_t v, double) {
        if (position[v] != kNowhere) return;
        const uint16_t* const row = rows.joints_of(v);
        for (uint32_t s = 0; s < kRowSlots; ++s)
          if (row[s] != kNoJoint) is_listed[row[s]] = 1;
      });
    }
    uint32_t listed = 0;
    for (uint32_t j = 0; j < joints; ++j)
      if (is_listed[j] != 0) joint_list[listed++] = static_cast<uint16_t>(j);
    return listed;
  }

  void solve_joints(const Rows& rows, uint32_t count, const uint16_t* batch, uint32_t size) {
    memset(x, 0, static_cast<size_t>(count) * SparseLdl::kBatch * sizeof(double));
    for (uint32_t i = 0; i < count; ++i) {
      double* const rhs = x + static_cast<size_t>(i) * SparseLdl::kBatch;
      plate.plate(unknown[i], [&](uint32_t v, double value) {
        if (position[v] != kNowhere) return;
        for (uint32_t m = 0; m < size; ++m) rhs[m] -= value * rows.weight(v, batch[m]);
      });
    }
    ldl.solve(x);
    for (uint32_t i = 0; i < count; ++i) {
      for (uint32_t m = 0; m < size; ++m) {
        const double weight = x[static_cast<size_t>(i) * SparseLdl::kBatch + m];
        const uint32_t q16 = weight > 0 ? static_cast<uint32_t>(smaller_of(weight, 4.0 * kWholeRow) + 0.5) : 0;
        if (q16 > 0) filled.add(i, batch[m], q16);
      }
    }
  }
  static double smaller_of(double a, double b) { return a < b ? a : b; }

  void run_part(const Mesh& mesh, uint32_t part, const uint8_t* known, uint32_t joints, Rows* rows) {
    uint32_t count = 0;
    for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i)
      count += known[mesh.part_vertices[i]] == 0 ? 1 : 0;
    if (count == 0 || count == mesh.part_sizes[part] || count > most) return;
    ordering.dissect(mesh, part);
    count = 0;
    for (uint32_t i = 0; i < mesh.part_sizes[part]; ++i) {
      const uint32_t v = ordering.order[i];
      if (known[v] != 0) continue;
      position[v] = count;
      unknown[count++] = v;
    }
    const bool fits = ldl.factorise(count, [&](uint32_t k, const auto& visit) {
      plate.plate(unknown[k], [&](uint32_t v, double value) {
        if (position[v] != kNowhere) visit(position[v], value);
      });
      visit(k, 1e-9);
    });
    if (fits) {
      const uint32_t listed = list_joints(*rows, count, joints);
      for (uint32_t i = 0; i < count; ++i) filled.clear(i);
      for (uint32_t first = 0; first < listed; first += SparseLdl::kBatch) {
        const uint32_t size = listed - first < SparseLdl::kBatch ? listed - first : SparseLdl::kBatch;
        solve_joints(*rows, count, joint_list + first, size);
      }
      for (uint32_t i = 0; i < count; ++i) take(i, unknown[i], rows);
    }
    for (uint32_t i = 0; i < count; ++i) position[unknown[i]] = kNowhere;
  }

  // The solution's row, scaled to a whole one; rows that came out all but empty keep the guess.
  void take(uint32_t from, uint32_t vertex, Rows* rows) const {
    uint32_t* const weights = filled.weights_of(from);
    uint64_t sum = 0;
    for (uint32_t s = 0; s < kRowSlots; ++s) sum += weights[s];
    if (sum < kWholeRow / 1024) return;
    for (uint32_t s = 0; s < kRowSlots; ++s)
      weights[s] = static_cast<uint32_t>((static_cast<uint64_t>(weights[s]) * kWholeRow + sum / 2) / sum);
    rows->copy(vertex, filled, from);
  }
};

}  // namespace

sinew_status inpaint(const Mesh& mesh, const uint8_t* known, uint32_t joints, const Counts& counts, Arena& arena,
                     Rows* rows) {
  const ArenaScope scope(arena);
  Inpainting inpainting;
  if (!inpainting.allocate(arena, counts, joints)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  inpainting.plate.fill(mesh);
  for (uint32_t v = 0; v < mesh.welded_count; ++v) inpainting.position[v] = kNowhere;
  for (uint32_t part = 0; part < mesh.part_count; ++part) inpainting.run_part(mesh, part, known, joints, rows);
  return SINEW_OK;
}

}  // namespace sinew::transferring
