// SPDX-License-Identifier: MIT
// One run of a network over one mesh: its sizes, the memory of a stage, and where rows lie.
#ifndef SINEW_NETWORK_RUN_HPP
#define SINEW_NETWORK_RUN_HPP

#include <string.h>

#include "core/build.hpp"
#include "model/regions.hpp"
#include "network/network.hpp"
#include "network/packed_layers.hpp"
#include "network/plan.hpp"

namespace sinew::network {

struct Sizes {
  uint32_t vertices = 0, joints = 0, tile = 0, lanes = 0;
  // Vertices of the tiles of all lanes, which lie behind one another.
  uint64_t tile_vertices() const { return static_cast<uint64_t>(tile) * lanes; }
};

// Scratch of one stage. Every lane has a tile of its own. It has tables of its own as well, because a lane takes small
// parts whole, tables included.
struct StageScratch {
  int16_t*
      tile[kMaxBuffers];  // [lanes x tile x slots x channels] rows of a buffer; null if the stage does not touch it
  bool load[kMaxLayers];  // whether the stage reads the layer's output row by row, and an earlier stage made it
  bool load_input[kMaxInputs];    // whether it reads the input row by row
  int16_t* table[kMaxLayers];     // of part means [lanes x joints x channels], of global layers [lanes x channels]
  int64_t* sums;                  // [lanes x lane_sums] of the table that is being made; then sums of columns by joint
  size_t joint_sums[kMaxLayers];  // where a linear layer's sums by joint begin in a lane's sums, counted in int32
  uint64_t lane_sums;
  uint32_t* vertices;  // [lanes x tile] the vertex of each row of the tile
  uint16_t* joints;    // [lanes x tile x K] the candidates of that vertex
};

// int16 values of a layer's table in one lane.
uint64_t table_values(const NetworkPlan& plan, const Layer& layer, const Sizes& sizes);
// All outputs that outlive their stage.
int16_t* allocate_storage(const NetworkPlan& plan, const Sizes& sizes, Arena& arena);
// All allocations of one stage, measured and real alike; also notes what to load. Returns arena.ok().
bool allocate_stage(const NetworkPlan& plan, const ModelTables& tables, const NetworkOptions& options, uint32_t stage,
                    const Sizes& sizes, Arena& arena, StageScratch* scratch);

// One run over one mesh: what tables, tiles and the walk over a stage share.
struct Run {
  const NetworkPlan& plan;
  const NetworkInput& input;
  const ModelTables tables;
  const Kernels& kernels;
  LinearKernel linear;  // of `kernels`: the one for packed weights or the one for the model's bytes
  const PackedLayers& packed;
  Sizes sizes;
  int16_t* storage = nullptr;
  int16_t* logits = nullptr;
  StageScratch scratch;
};

inline uint32_t slots_of(const Run& run, const Region& region) { return run.plan.slots(region.buffer); }
inline int16_t* table_of(const Run& run, uint32_t index, uint32_t lane) {
  return run.scratch.table[index] +
         static_cast<size_t>(table_values(run.plan, run.plan.layers[index], run.sizes)) * lane;
}

inline int64_t* sums_of(const Run& run, uint32_t lane) {
  return run.scratch.sums + static_cast<size_t>(run.scratch.lane_sums) * lane;
}
inline int32_t* joint_sums_of(const Run& run, uint32_t index, uint32_t lane) {
  return static_cast<int32_t*>(static_cast<void*>(sums_of(run, lane))) + run.scratch.joint_sums[index];
}

// Rows of a stored output, or of an input, for the whole mesh; `channel` is the buffer's.
inline RowsView whole_mesh(const Run& run, uint16_t buffer, int producer, uint32_t channel) {
  if (producer == kFromInput) {
    return {run.input.inputs[buffer] + channel, run.plan.buffers[buffer].channels};
  }
  const Region& out = run.plan.layers[producer].out;
  const int16_t* rows = run.storage + static_cast<size_t>(run.plan.store_offset[producer]) * run.sizes.vertices;
  return {rows + (channel - out.offset), out.channels};
}

// For the usual 16 to 96 bytes a call of memcpy would be most of the work.
inline void copy_values(int16_t* to, const int16_t* from, uint32_t count) {
  constexpr uint32_t kPiece = 8;
  for (; !kSmallCode && count >= kPiece; count -= kPiece, to += kPiece, from += kPiece)
    memcpy(to, from, kPiece * sizeof(int16_t));
  if (count != 0) memcpy(to, from, count * sizeof(int16_t));
}

// Tables of the stage's global layers, or of its part layers for one part (vertices, count), in a lane's memory.
void make_tables(const Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count, uint32_t lane);
// The same in the first lane's memory, on all lanes.
void share_tables(const Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count);
// Multiplies the columns by_joint of the stage's linear layers with the means of one part: one product per joint that is a
// candidate in the part. The sums lie where the tables' scratch was. `met` has a bit for every such joint.
void multiply_part_means(const Run& run, uint32_t stage, const uint32_t* vertices, uint32_t count, uint32_t lane);

}  // namespace sinew::network
#endif
