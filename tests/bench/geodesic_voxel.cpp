// SPDX-License-Identifier: MIT
// Voxels are the engine's; the shortest paths run through buckets (Dial 1969) over the 26 neighbors, one joint at a
// time, as the paper says.
#include "geodesic_voxel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "bind/pipeline.hpp"
#include "sinew/sinew.hpp"
#include "voxels/voxels.hpp"

namespace sinew_bench {
namespace {

using namespace sinew;

constexpr uint32_t kUnit = 40;  // length of a cell
constexpr std::array<uint32_t, 4> kStep = {0, 40, 57, 69};
constexpr uint32_t kNever = UINT32_MAX;
constexpr size_t kKept = 4;

class Paths {
 public:
  explicit Paths(const VoxelGrid& grid) : grid_(grid), distance_(grid.cell_count) {
    for (int z = -1; z <= 1; ++z) {
      for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
          const size_t axes = static_cast<size_t>((x != 0) + (y != 0) + (z != 0));
          if (axes != 0) steps_.push_back({(z * grid.size[1] + y) * grid.size[0] + x, kStep[axes]});
        }
      }
    }
  }

  void run(const std::vector<uint32_t>& seeds) {
    std::fill(distance_.begin(), distance_.end(), kNever);
    for (const uint32_t cell : seeds) offer(cell, 0);
    for (uint32_t at = 0, empty = 0; empty < buckets_.size(); ++at) {
      std::vector<uint32_t>& bucket = buckets_[at % buckets_.size()];
      empty = bucket.empty() ? empty + 1 : 0;
      for (size_t i = 0; i < bucket.size(); ++i) {
        const uint32_t cell = bucket[i];
        if (distance_[cell] != at) continue;
        for (const Step& step : steps_) {
          const uint32_t next = static_cast<uint32_t>(static_cast<int32_t>(cell) + step.offset);
          if (grid_.states[next] <= kCellSurface) offer(next, at + step.length);
        }
      }
      bucket.clear();
    }
  }
  uint32_t distance(uint32_t cell) const { return distance_[cell]; }

 private:
  struct Step {
    int32_t offset;
    uint32_t length;
  };
  void offer(uint32_t cell, uint32_t distance) {
    if (distance >= distance_[cell]) return;
    distance_[cell] = distance;
    buckets_[distance % buckets_.size()].push_back(cell);
  }

  const VoxelGrid& grid_;
  std::vector<uint32_t> distance_;
  std::vector<Step> steps_;
  std::array<std::vector<uint32_t>, kStep[3] + 1> buckets_;
};

// Cells along the bones from a joint to its children; a leaf has its own cell.
std::vector<uint32_t> bone_cells(const VoxelGrid& grid, const Skeleton& skeleton, uint32_t joint) {
  std::vector<uint32_t> cells = {grid.cell_of(skeleton.positions[joint])};
  const Vec3i head = skeleton.positions[joint];
  for (uint32_t child = 0; child < skeleton.joint_count; ++child) {
    if (skeleton.parents[child] != static_cast<int32_t>(joint)) continue;
    const Vec3i along = skeleton.positions[child] - head;
    const int32_t longest = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
    const int32_t parts = std::max(1, 2 * longest / grid.cell_size);
    for (int32_t i = 1; i <= parts; ++i) {
      const auto at = [&](int32_t from, int32_t way) {
        return from + static_cast<int32_t>(static_cast<int64_t>(way) * i / parts);
      };
      cells.push_back(grid.cell_of({at(head.x, along.x), at(head.y, along.y), at(head.z, along.z)}));
    }
  }
  return cells;
}

}  // namespace

GeodesicVoxelWeights bind_geodesic_voxel(const sinew_mesh& input, const sinew_skeleton& skeleton_input,
                                         uint32_t cells) {
  Counts counts;
  counts.vertices = input.vertex_count;
  counts.faces = input.face_count;
  counts.corners = input.corner_count;
  counts.joints = skeleton_input.joint_count;
  counts.grid = cells;
  Mesh mesh;
  Skeleton skeleton;
  VoxelGrid grid;
  uint32_t* queue = nullptr;
  const auto build = [&](Arena& arena) {
    mesh.allocate(arena, counts);
    skeleton.allocate(arena, counts);
    const sinew_status status = build_mesh_and_skeleton(input, skeleton_input, 0, counts, arena, &mesh, &skeleton);
    grid.allocate(arena, counts);
    queue = arena.alloc<uint32_t>(VoxelGrid::max_cells(counts));
    return status == SINEW_OK && arena.ok();
  };
  Arena measuring;
  (void)build(measuring);
  const Workspace block(measuring.high_water());
  Arena arena(block.data(), block.size());
  if (!build(arena)) return {};
  voxelise(mesh, counts, queue, &grid);

  GeodesicVoxelWeights out;
  out.joints.resize(size_t{input.vertex_count} * kKept);
  out.weights.resize(out.joints.size());
  std::vector<uint32_t> vertex_cell(mesh.welded_count);
  for (uint32_t v = 0; v < mesh.welded_count; ++v) vertex_cell[v] = grid.cell_of(mesh.positions[v]);
  std::vector<std::array<float, kKept>> best(mesh.welded_count, std::array<float, kKept>{});
  std::vector<std::array<uint16_t, kKept>> who(mesh.welded_count, std::array<uint16_t, kKept>{});
  Paths paths(grid);
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    paths.run(bone_cells(grid, skeleton, j));
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      const uint32_t distance = paths.distance(vertex_cell[v]);
      if (distance == kNever) continue;
      const float d = static_cast<float>(std::max(distance, kUnit / 2)) / static_cast<float>(kUnit * cells);
      float weight = 1 / (d * d * d * d);
      uint16_t joint = static_cast<uint16_t>(j);
      for (size_t k = 0; k < kKept; ++k) {
        if (weight <= best[v][k]) continue;
        std::swap(weight, best[v][k]);
        std::swap(joint, who[v][k]);
      }
    }
  }
  for (uint32_t v = 0; v < input.vertex_count; ++v) {
    const uint32_t w = mesh.vertex_to_welded[v];
    float sum = 0;
    for (const float weight : best[w]) sum += weight;
    for (size_t k = 0; k < kKept; ++k) {
      out.joints[v * kKept + k] = who[w][k];
      out.weights[v * kKept + k] = sum > 0 ? best[w][k] / sum : 0;
    }
  }
  return out;
}

}  // namespace sinew_bench
