// SPDX-License-Identifier: MIT
// The K nearest joints of every vertex: all bones grow through the voxels at once, nearest first, and a cell passes on
// only the first K joints that reach it. The cost is K times the cells visited, whatever the joint count.
#include "candidates/candidates.hpp"

#include "candidates/propagation.hpp"
#include "core/build.hpp"
#include "core/sort.hpp"
#include "core/vector_math.hpp"
#include "skeleton/bones.hpp"

namespace sinew {
namespace {

// Length of `v` in fortieths of a cell.
uint32_t cell_length(const VoxelGrid& grid, Vec3i v) {
  return static_cast<uint32_t>(length(v) * kCellLength / static_cast<uint64_t>(grid.cell_size));
}

// Offers a joint to every cell along a segment, with the cell center's distance to the segment. Parts outside the grid
// go to the nearest cell, whose distance then holds the gap. `start` is added to all.
void seed_segment(Vec3i a, Vec3i b, uint32_t joint, uint32_t start, Propagation* p) {
  const Vec3i along = b - a;  // below 2^25 per axis
  const int64_t square = dot(along, along);
  const int64_t samples = static_cast<int64_t>(length(along)) / (p->grid.cell_size / 2) + 1;
  uint32_t before = UINT32_MAX;
  for (int64_t i = 0; i <= samples; ++i) {
    const Vec3i point = {a.x + static_cast<int32_t>(along.x * i / samples),
                         a.y + static_cast<int32_t>(along.y * i / samples),
                         a.z + static_cast<int32_t>(along.z * i / samples)};
    const uint32_t cell = p->grid.cell_of(point);
    if (cell == before) continue;
    before = cell;
    const Vec3i from_a = p->grid.center(cell) - a;
    // Position along the segment in Q10: |dot| < 2^50, and 2^15 units of a longest segment are no more than its cell.
    const int64_t t = square == 0 ? 0 : clamp32(dot(from_a, along) * 1024 / square, 0, 1024);
    const Vec3i gap = {from_a.x - static_cast<int32_t>((along.x * t) >> 10),
                       from_a.y - static_cast<int32_t>((along.y * t) >> 10),
                       from_a.z - static_cast<int32_t>((along.z * t) >> 10)};
    p->seed(cell, make_label(start + cell_length(p->grid, gap), joint));
  }
}

// Offers every usable joint along its bones. starts [J] in fortieths of a cell.
void seed_bones(const Skeleton& skeleton, const Vec3i* tips, const uint32_t* starts, Propagation* p) {
  each_bone(skeleton, tips, [&](uint32_t joint, Vec3i head, Vec3i tail) {
    if (skeleton.usable[joint] != 0) seed_segment(head, tail, joint, starts[joint], p);
  });
}

// Late starts: without them the many small bones of a face or foot fill all K slots, and the head, which moves the
// whole face, is left out. A joint whose longest bone is shorter than a sixteenth of the side starts later, up to 1/32
// of the side. Measured at K = 8, 64 cells: recall on train 99.04 -> 99.27 %, on val 99.68 -> 99.73 %. The delay is
// taken off again in the result.
constexpr int64_t kShortBone = kSide / 16;
constexpr int64_t kLongestDelay = kSide / 32;

// starts [J] out; lengths [J] scratch.
void find_starts(const Skeleton& skeleton, const Vec3i* tips, const VoxelGrid& grid, int64_t* lengths,
                 uint32_t* starts) {
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) lengths[j] = 0;
  each_bone(skeleton, tips, [&](uint32_t joint, Vec3i head, Vec3i tail) {
    const int64_t bone = static_cast<int64_t>(length(tail - head));
    if (bone > lengths[joint]) lengths[joint] = bone;
  });
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    const int64_t missing = lengths[j] < kShortBone ? kShortBone - lengths[j] : 0;
    starts[j] = static_cast<uint32_t>(kLongestDelay * missing / kShortBone * kCellLength / grid.cell_size);
  }
}

// The cells a vertex reads, its own and those of the 2 x 2 x 2 block around it that are not outside, and its distance
// from their centers.
struct Around {
  uint32_t count;
  uint32_t cells[8];  // numbers in the propagation
  uint32_t costs[8];  // in the bits of a label's distance

  void find(const Propagation& p, Vec3i position) {
    const VoxelGrid& grid = p.grid;
    const int32_t value[3] = {position.x, position.y, position.z};
    const int32_t low[3] = {grid.low.x, grid.low.y, grid.low.z};
    const int32_t strides[3] = {1, grid.size[0], grid.size[0] * grid.size[1]};
    int32_t own = 0, step[3];
    uint64_t squares[3][2];  // of the distance along an axis from the centers of the own and the other cell
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t at = grid.coordinate(axis, value[axis]);
      const int64_t offset = value[axis] - (low[axis] + at * grid.cell_size + grid.cell_size / 2);
      const int64_t other = offset < 0 ? offset + grid.cell_size : offset - grid.cell_size;
      own += at * strides[axis];
      step[axis] = offset < 0 ? -strides[axis] : strides[axis];
      squares[axis][0] = static_cast<uint64_t>(offset * offset);
      squares[axis][1] = static_cast<uint64_t>(other * other);
    }
    count = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
      const uint32_t cell = p.solid_cell(static_cast<uint32_t>(own + x * step[0] + y * step[1] + z * step[2]));
      cells[count] = cell;
      const uint32_t length = isqrt64(squares[0][x] + squares[1][y] + squares[2][z]);  // below 2^17
      costs[count] = length * kCellLength / static_cast<uint32_t>(grid.cell_size) << kJointBits;
      count += cell != 0;
    }
  }
};

// The `keep` nearest joints of a vertex over the cells it reads, in any order; returns their number.
SINEW_ONCE uint32_t nearest_labels(const Propagation& p, Vec3i position, uint32_t keep, uint32_t* nearest) {
  Around around;
  around.find(p, position);
  const uint32_t per_cell = p.capacity();
  // No joint beyond the last one of any cell is among them.
  uint32_t farthest = UINT32_MAX;
  for (uint32_t i = 0; i < around.count; ++i) {
    const uint32_t last = p.labels(around.cells[i])[per_cell - 1] + around.costs[i];
    if (last < farthest) farthest = last;
  }
  // Most labels name a joint that another cell has named: slots by a joint's low bits hold its index.
  constexpr uint32_t kEntries = 64;
  constexpr uint8_t kNone = 0xFF;
  uint8_t entries[kEntries];
  for (uint8_t& entry : entries) entry = kNone;
  uint32_t labels[8 * SINEW_MAX_CANDIDATES];
  static_assert(8 * SINEW_MAX_CANDIDATES < kNone, "places are too small");
  uint32_t count = 0;
  for (uint32_t i = 0; i < around.count; ++i) {
    const uint32_t* const row = p.labels(around.cells[i]);
    for (uint32_t k = 0; k < per_cell; ++k) {
      const uint32_t label = row[k] + around.costs[i];
      if (label > farthest) break;
      uint8_t& entry = entries[label % kEntries];
      uint32_t at = entry;
      if (at == kNone || ((labels[at] ^ label) & kJointMask) != 0) {
        at = at == kNone ? count : 0;
        while (at < count && ((labels[at] ^ label) & kJointMask) != 0) ++at;
        entry = static_cast<uint8_t>(at);
        if (at == count) labels[count++] = UINT32_MAX;
      }
      if (label < labels[at]) labels[at] = label;
    }
  }
  while (count > keep) {
    uint32_t last = 0;
    for (uint32_t i = 1; i < count; ++i) {
      if (labels[i] > labels[last]) last = i;
    }
    labels[last] = labels[--count];
  }
  for (uint32_t i = 0; i < count; ++i) nearest[i] = labels[i];
  return count;
}

constexpr uint64_t kTipExtentPercent = 85;
constexpr uint32_t kLeastTerritory = 3;  // vertices below which a leaf's surroundings say nothing about its direction

constexpr uint32_t kCandidatePiece = 256;  // vertices that a lane takes at a time

void find_tips(const Mesh& mesh, const Skeleton& skeleton, const Propagation& p, const Threads& threads,
               const CandidateSearch& scratch, Candidates* out) {
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    scratch.sums[j] = {0, 0, 0};
    scratch.extents[j] = 0;
    scratch.counts[j] = 0;
  }
  threads.ranges(mesh.welded_count, kCandidatePiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) {
      uint32_t nearest;
      nearest_labels(p, mesh.positions[v], 1, &nearest);  // finds one: the vertex's own cell is solid
      scratch.nearest[v] = static_cast<uint16_t>(nearest & kJointMask);
    }
  });
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const uint32_t joint = scratch.nearest[v];
    const Vec3i to_vertex = mesh.positions[v] - skeleton.positions[joint];
    scratch.sums[joint].x += to_vertex.x;
    scratch.sums[joint].y += to_vertex.y;
    scratch.sums[joint].z += to_vertex.z;
    ++scratch.counts[joint];
  }
  constexpr int kDirectionBits = 14;
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) out->tips[j] = unit_vector(scratch.sums[j], kDirectionBits);
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const uint32_t joint = scratch.nearest[v];
    const int64_t extent = dot(mesh.positions[v] - skeleton.positions[joint], out->tips[joint]) >> kDirectionBits;
    if (extent > scratch.extents[joint]) scratch.extents[joint] = extent;
  }
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    out->territory[j] = static_cast<uint32_t>((static_cast<uint64_t>(scratch.counts[j]) << 16) / mesh.welded_count);
    const Vec3i direction = out->tips[j];
    out->tips[j] = skeleton.bone_tail[j];
    if (skeleton.child_count[j] != 0 || scratch.counts[j] < kLeastTerritory || scratch.extents[j] == 0) continue;
    const int64_t reach = scratch.extents[j] * static_cast<int64_t>(kTipExtentPercent) / 100;
    out->tips[j] =
        skeleton.positions[j] + Vec3i{static_cast<int32_t>(round_shift(direction.x * reach, kDirectionBits)),
                                      static_cast<int32_t>(round_shift(direction.y * reach, kDirectionBits)),
                                      static_cast<int32_t>(round_shift(direction.z * reach, kDirectionBits))};
  }
}

// Permille of this stage's progress when each step ends; during a propagation it stands still.
namespace step_ends_at {
constexpr uint32_t kVoxels = 200;
constexpr uint32_t kFirstPropagation = 300;
constexpr uint32_t kTips = 400;
constexpr uint32_t kSecondPropagation = 600;
constexpr uint32_t kRows = Progress::kWhole;
}  // namespace step_ends_at

void write_candidates(const Mesh& mesh, const Propagation& p, const uint32_t* starts, uint32_t begin, uint32_t end,
                      Candidates* out) {
  for (uint32_t v = begin; v < end; ++v) {
    uint32_t row[SINEW_MAX_CANDIDATES];
    const uint32_t count = nearest_labels(p, mesh.positions[v], out->k, row);
    for (uint32_t k = 0; k < count; ++k) row[k] -= starts[row[k] & kJointMask] << kJointBits;
    sort_ascending(row, count);
    uint16_t* const joints = out->joints + static_cast<size_t>(v) * out->k;
    uint32_t* const distances = out->distances + static_cast<size_t>(v) * out->k;
    for (uint32_t k = 0; k < out->k; ++k) {
      joints[k] = k < count ? static_cast<uint16_t>(row[k] & kJointMask) : kNoJoint;
      distances[k] = k < count ? static_cast<uint32_t>(static_cast<uint64_t>(row[k] >> kJointBits) *
                                                       static_cast<uint64_t>(p.grid.cell_size) / kCellLength)
                               : 0;
    }
  }
}

}  // namespace

bool Candidates::allocate(Arena& arena, const Counts& counts) {
  k = counts.candidates;
  joints = arena.alloc<uint16_t>(static_cast<size_t>(counts.vertices) * k);
  distances = arena.alloc<uint32_t>(static_cast<size_t>(counts.vertices) * k);
  tips = arena.alloc<Vec3i>(counts.joints);
  territory = arena.alloc<uint32_t>(counts.joints);
  return arena.ok();
}

bool CandidateSearch::allocate(Arena& arena, const Counts& counts_of_bind) {
  propagation.allocate(arena, counts_of_bind);
  sums = arena.alloc<Vec3l>(counts_of_bind.joints);
  extents = arena.alloc<int64_t>(counts_of_bind.joints);
  counts = arena.alloc<uint32_t>(counts_of_bind.joints);
  starts = arena.alloc<uint32_t>(counts_of_bind.joints);
  nearest = arena.alloc<uint16_t>(counts_of_bind.vertices);
  return arena.ok();
}

bool CandidateSearch::run(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts_of_bind,
                          const Progress& progress, Candidates* candidates) {
  voxelise(mesh, counts_of_bind, propagation.queue(), &propagation.grid);
  propagation.survey();
  if (!progress.report(step_ends_at::kVoxels)) return false;

  uint32_t usable = 0;
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) usable += skeleton.usable[j];
  propagation.begin(1);
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) starts[j] = 0;
  seed_bones(skeleton, skeleton.bone_tail, starts, &propagation);
  if (!propagation.run(progress, step_ends_at::kFirstPropagation)) return false;
  find_tips(mesh, skeleton, propagation, counts_of_bind.threads, *this, candidates);
  if (!progress.report(step_ends_at::kTips)) return false;

  propagation.begin(usable < counts_of_bind.candidates ? usable : counts_of_bind.candidates);
  find_starts(skeleton, candidates->tips, propagation.grid, extents, starts);
  seed_bones(skeleton, candidates->tips, starts, &propagation);
  return propagation.run(progress, step_ends_at::kSecondPropagation);
}

void CandidateSearch::write(const Mesh& mesh, const Threads& threads, Candidates* candidates) const {
  threads.ranges(mesh.welded_count, kCandidatePiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    write_candidates(mesh, propagation, starts, begin, end, candidates);
  });
}

sinew_status find_candidates(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts, const Progress& progress,
                             Arena& arena, Candidates* candidates) {
  const ArenaScope scope(arena);
  CandidateSearch search;
  if (!search.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  if (!search.run(mesh, skeleton, counts, progress, candidates)) return SINEW_ERROR_CANCELLED;
  search.write(mesh, counts.threads, candidates);
  return progress.report(step_ends_at::kRows) ? SINEW_OK : SINEW_ERROR_CANCELLED;
}

}  // namespace sinew
