// SPDX-License-Identifier: MIT
// Mirror partners by a sorted grid of cells, and means of mirrored rows (stage 9).
#include "weights/symmetry.hpp"

#include "core/sort.hpp"

namespace sinew {
namespace {

constexpr int32_t kTolerance = kSide / 512;
constexpr int64_t kTolerance2 = static_cast<int64_t>(kTolerance) * kTolerance;

Vec3i mirrored(Vec3i p, int32_t plane) { return {plane - p.x, p.y, p.z}; }
int64_t distance2(Vec3i a, Vec3i b) {
  const Vec3i d = a - b;
  return dot(d, d);
}

// Vertices sorted by the cell they lie in; a cell is as wide as the tolerance, so a partner is in one of 27.
struct Cells {
  uint64_t* keys = nullptr;      // [U]
  uint32_t* vertices = nullptr;  // [U]
  uint64_t* scratch_keys = nullptr;
  uint32_t* scratch = nullptr;
  uint32_t* nearest = nullptr;  // [U]

  bool allocate(Arena& arena, const Counts& counts) {
    keys = arena.alloc<uint64_t>(counts.vertices);
    vertices = arena.alloc<uint32_t>(counts.vertices);
    scratch_keys = arena.alloc<uint64_t>(counts.vertices);
    scratch = arena.alloc<uint32_t>(counts.vertices);
    nearest = arena.alloc<uint32_t>(counts.vertices);
    return arena.ok();
  }

  // Positions lie within +-2^21 and mirrored ones within +-2^24: 2^25 keeps both positive.
  static uint64_t cell(int32_t value) { return static_cast<uint64_t>((value + (1 << 25)) / kTolerance); }
  static uint64_t key(uint64_t x, uint64_t y, uint64_t z) { return x << 42 | y << 21 | z; }

  void sort(const Mesh& mesh) {
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      const Vec3i p = mesh.positions[v];
      keys[v] = key(cell(p.x), cell(p.y), cell(p.z));
      vertices[v] = v;
    }
    radix_sort_pairs(keys, vertices, mesh.welded_count, scratch_keys, scratch);
  }

  // First index whose key is not below `wanted`.
  uint32_t lower_bound(uint64_t wanted, uint32_t count) const {
    uint32_t low = 0, high = count;
    while (low < high) {
      const uint32_t middle = low + (high - low) / 2;
      if (keys[middle] < wanted) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  // Nearest vertex to `position` within the tolerance, ties: `self` first, then the lower index.
  uint32_t find(const Mesh& mesh, Vec3i position, uint32_t self) const {
    const uint64_t cx = cell(position.x), cy = cell(position.y), cz = cell(position.z);
    uint32_t best = kNoPartner;
    int64_t best_distance = kTolerance2 + 1;
    for (uint64_t x = cx - 1; x <= cx + 1; ++x) {
      for (uint64_t y = cy - 1; y <= cy + 1; ++y) {
        // The three cells along z lie side by side in the order.
        const uint64_t last = key(x, y, cz + 1);
        for (uint32_t i = lower_bound(key(x, y, cz - 1), mesh.welded_count); i < mesh.welded_count && keys[i] <= last;
             ++i) {
          const uint32_t v = vertices[i];
          const int64_t d = distance2(mesh.positions[v], position);
          if (d < best_distance || (d == best_distance && best != self && (v == self || v < best))) {
            best = v;
            best_distance = d;
          }
        }
      }
    }
    return best;
  }

  uint32_t pair(const Mesh& mesh, int32_t plane, uint32_t* partner) const {
    for (uint32_t v = 0; v < mesh.welded_count; ++v) nearest[v] = find(mesh, mirrored(mesh.positions[v], plane), v);
    uint32_t count = 0;
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      const bool mutual = nearest[v] != kNoPartner && nearest[nearest[v]] == v;
      partner[v] = mutual ? nearest[v] : kNoPartner;
      count += mutual ? 1 : 0;
    }
    return count;
  }
};

bool alike(const Skeleton& s, const uint16_t* partner, uint32_t a, uint32_t b) {
  if (s.child_count[a] != s.child_count[b] || s.depth[a] != s.depth[b] || s.usable[a] != s.usable[b]) return false;
  if (s.parents[a] < 0 || s.parents[b] < 0) return s.parents[a] < 0 && s.parents[b] < 0;
  return partner[s.parents[a]] == s.parents[b];
}

uint32_t nearest_joint(const Skeleton& s, const uint16_t* partner, int32_t plane, uint32_t j) {
  const Vec3i position = mirrored(s.positions[j], plane);
  uint32_t best = kNoPartner;
  int64_t best_distance = kTolerance2 + 1;
  for (uint32_t other = 0; other < s.joint_count; ++other) {
    if (!alike(s, partner, j, other)) continue;
    const int64_t d = distance2(s.positions[other], position);
    if (d < best_distance || (d == best_distance && other == j)) {
      best = other;
      best_distance = d;
    }
  }
  return best;
}

// Parents before children, so that alike() sees the parents' partners. Both of a pair are set at once.
uint32_t pair_joints(const Skeleton& s, int32_t plane, uint16_t* partner) {
  for (uint32_t j = 0; j < s.joint_count; ++j) partner[j] = kNoJoint;
  uint32_t count = 0;
  for (uint32_t i = 0; i < s.joint_count; ++i) {
    const uint32_t j = s.order[i];
    if (partner[j] != kNoJoint) continue;
    const uint32_t other = nearest_joint(s, partner, plane, j);
    if (other == kNoPartner || partner[other] != kNoJoint || nearest_joint(s, partner, plane, other) != j) continue;
    partner[j] = static_cast<uint16_t>(other);
    partner[other] = static_cast<uint16_t>(j);
    count += other == j ? 1 : 2;
  }
  return count;
}

// x of the joint in the middle: half of the joints lie on either side.
int32_t middle_joint_x(const Skeleton& s) {
  for (uint32_t j = 0; j < s.joint_count; ++j) {
    uint32_t below = 0, equal = 0;
    for (uint32_t other = 0; other < s.joint_count; ++other) {
      below += s.positions[other].x < s.positions[j].x ? 1 : 0;
      equal += s.positions[other].x == s.positions[j].x ? 1 : 0;
    }
    if (below <= s.joint_count / 2 && below + equal > s.joint_count / 2) return s.positions[j].x;
  }
  return 0;
}

// A row while it is put together: twice as many joints as a row has slots.
struct WideRow {
  uint16_t joints[2 * kRowSlots];
  uint32_t weights[2 * kRowSlots];
  uint32_t count = 0;

  void add(uint16_t joint, uint32_t weight) {
    for (uint32_t i = 0; i < count; ++i) {
      if (joints[i] != joint) continue;
      weights[i] += weight;
      return;
    }
    joints[count] = joint;
    weights[count++] = weight;
  }
  // Adds the row itself and, with `partners`, its mirror image; joints without partner are left out.
  void add_row(const Rows& rows, uint32_t vertex, const uint16_t* partner, bool mirrored_too, bool itself) {
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      const uint16_t joint = rows.joints_of(vertex)[i];
      if (joint == kNoJoint || rows.weights_of(vertex)[i] == 0 || partner[joint] == kNoJoint) continue;
      if (itself) add(joint, rows.weights_of(vertex)[i]);
      if (mirrored_too) add(partner[joint], rows.weights_of(vertex)[i]);
    }
  }
  // By descending weight; of equal weights partners are adjacent.
  void sort(const uint16_t* partner) {
    const auto rank = [&](uint32_t i) {
      const uint32_t joint = joints[i], other = partner[joint];
      return (joint < other ? joint : other) << 16 | joint;
    };
    for (uint32_t i = 1; i < count; ++i) {
      for (uint32_t j = i;
           j > 0 && (weights[j] > weights[j - 1] || (weights[j] == weights[j - 1] && rank(j) < rank(j - 1))); --j) {
        const uint16_t joint = joints[j];
        const uint32_t weight = weights[j];
        joints[j] = joints[j - 1];
        weights[j] = weights[j - 1];
        joints[j - 1] = joint;
        weights[j - 1] = weight;
      }
    }
  }
  void store(uint32_t vertex, const Rows& rows) const {
    rows.clear(vertex);
    for (uint32_t i = 0; i < count && i < kRowSlots; ++i) {
      rows.joints_of(vertex)[i] = joints[i];
      rows.weights_of(vertex)[i] = weights[i];
    }
  }
};

// The mirror image of a row instead of another; false when nothing of it has a partner.
bool store_mirrored(const Symmetry& symmetry, const Rows& from, uint32_t from_vertex, const Rows& to,
                    uint32_t to_vertex) {
  WideRow row;
  row.add_row(from, from_vertex, symmetry.joint, true, false);
  if (row.count == 0) return false;
  row.sort(symmetry.joint);
  row.store(to_vertex, to);
  return true;
}

// Keeps whole pairs only while they fit.
void cut_to_pairs(const Symmetry& symmetry, uint32_t influence_count, WideRow* row) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < row->count; ++i) {
    const uint16_t joint = row->joints[i], partner = symmetry.joint[joint];
    const bool second = i > 0 && row->joints[i - 1] == partner && partner != joint;
    if (second) continue;  // it went with the first
    const uint32_t needed = partner == joint ? 1 : 2;
    if (kept + needed > influence_count) break;
    kept += needed;
  }
  if (kept > 0) row->count = kept;
}

}  // namespace

bool Symmetry::allocate(Arena& arena, const Counts& counts) {
  joint = arena.alloc<uint16_t>(counts.joints);
  vertex = arena.alloc<uint32_t>(counts.vertices);
  return arena.ok();
}

sinew_status find_symmetry(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts, Arena& arena,
                           Symmetry* out) {
  const ArenaScope scope(arena);
  Cells cells;
  if (!cells.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  cells.sort(mesh);
  const int32_t other_plane = 2 * middle_joint_x(skeleton);
  out->plane = 0;
  out->paired_count = cells.pair(mesh, 0, out->vertex);
  if (other_plane != 0) {
    const uint32_t count = cells.pair(mesh, other_plane, out->vertex);
    if (count > out->paired_count) {
      out->plane = other_plane;
      out->paired_count = count;
    } else {
      (void)cells.pair(mesh, 0, out->vertex);
    }
  }
  const uint32_t joints = pair_joints(skeleton, out->plane, out->joint);
  out->symmetric =
      2 * static_cast<uint64_t>(out->paired_count) >= mesh.welded_count && 2 * joints >= skeleton.joint_count;
  return SINEW_OK;
}

void mirror_given_rows(const Mesh& mesh, const Symmetry& symmetry, GivenRows* given) {
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const uint32_t partner = symmetry.vertex[v];
    if (given->kind[v] == GivenKind::kFree || partner == kNoPartner || given->kind[partner] != GivenKind::kFree)
      continue;
    if (store_mirrored(symmetry, given->rows, v, given->rows, partner)) given->kind[partner] = given->kind[v];
  }
}

void mirror_rows(const Mesh& mesh, const GivenRows& given, uint32_t influence_count, Rows* rows, Symmetry* found) {
  const Symmetry& symmetry = *found;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const uint32_t partner = symmetry.vertex[v];
    if (given.kind[v] != GivenKind::kFree) rows->copy(v, given.rows, v);
    if (partner == kNoPartner || partner < v) continue;
    WideRow row;
    const bool given_row = given.kind[v] != GivenKind::kFree || given.kind[partner] != GivenKind::kFree;
    if (!given_row) {
      row.add_row(*rows, v, symmetry.joint, partner == v, true);
      if (partner != v) row.add_row(*rows, partner, symmetry.joint, true, false);
    }
    if (row.count == 0) {  // given rows are mirrored already
      symmetry.vertex[v] = symmetry.vertex[partner] = kNoPartner;
      continue;
    }
    row.sort(symmetry.joint);
    if (partner == v) cut_to_pairs(symmetry, influence_count, &row);
    row.store(v, *rows);
    if (partner != v) (void)store_mirrored(symmetry, *rows, v, *rows, partner);
  }
}

void mirror_influences(const Symmetry& symmetry, uint32_t influence_count, uint16_t* joints, uint16_t* weights) {
  for (uint32_t i = 0; i < influence_count && weights[i] > 0; ++i) {
    const uint16_t joint = symmetry.joint[joints[i]], weight = weights[i];
    uint32_t position = i;
    for (; position > 0 && weights[position - 1] == weight && joints[position - 1] > joint; --position) {
      joints[position] = joints[position - 1];
      weights[position] = weights[position - 1];
    }
    joints[position] = joint;
    weights[position] = weight;
  }
}

}  // namespace sinew
