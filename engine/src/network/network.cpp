// SPDX-License-Identifier: MIT
// Executes a model's layer list stage by stage, tile by tile, with the kernels that the caller chose.
#include "network/network.hpp"

#include <string.h>

#include "core/build.hpp"
#include "model/regions.hpp"
#include "network/packed_layers.hpp"
#include "network/plan.hpp"

namespace sinew {
namespace {

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

bool uses_table(LayerKind kind) {
  return kind == LayerKind::kPartMean || kind == LayerKind::kGlobalMean || kind == LayerKind::kGlobalMax;
}

uint64_t table_values(const NetworkPlan& plan, const Layer& layer, const Sizes& sizes) {
  const bool by_joint = layer.kind == LayerKind::kPartMean && has_slots(plan.buffers[layer.in.buffer].domain);
  return static_cast<uint64_t>(layer.in.channels) * (by_joint ? sizes.joints : 1u);
}

int16_t* allocate_storage(const NetworkPlan& plan, const Sizes& sizes, Arena& arena) {
  return arena.alloc<int16_t>(checked(plan.store_values * sizes.vertices));
}

// Marks what a stage reads from a region row by row.
void mark_loads(const NetworkPlan& plan, uint32_t stage, uint32_t reader, const Region& region, StageScratch* scratch,
                bool* touched) {
  touched[region.buffer] = true;
  for (uint32_t channel = region.offset; channel < region_end(region);) {
    const Segment segment = segment_at(plan.layers, plan.input_count, reader, region, channel);
    if (segment.producer == kFromInput) {
      scratch->load_input[region.buffer] = true;
    } else if (plan.stage[segment.producer] < stage) {
      scratch->load[segment.producer] = true;
    }
    channel += segment.count;
  }
}

// All allocations of one stage, measured and real alike; also notes what to load. Returns arena.ok().
bool allocate_stage(const NetworkPlan& plan, const ModelTables& tables, const NetworkOptions& options, uint32_t stage,
                    const Sizes& sizes, Arena& arena, StageScratch* scratch) {
  bool touched[kMaxBuffers] = {};
  for (uint32_t i = 0; i < kMaxLayers; ++i) scratch->load[i] = false;
  for (uint32_t i = 0; i < kMaxInputs; ++i) scratch->load_input[i] = false;
  uint64_t sums = 0, joint_sums = 0;
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    scratch->table[i] = nullptr;
    if (plan.stage[i] != stage) continue;
    const Layer& layer = plan.layers[i];
    touched[layer.out.buffer] = true;
    if (!reads_other_rows(layer.kind)) mark_loads(plan, stage, i, layer.in, scratch, touched);
    if ((layer.flags & kLayerResidual) != 0) mark_loads(plan, stage, i, layer.residual, scratch, touched);
    if (uses_table(layer.kind)) {
      const uint64_t values = table_values(plan, layer, sizes);
      scratch->table[i] = arena.alloc<int16_t>(checked(values * sizes.lanes));
      if (values > sums) sums = values;
    }
    if (kHasPackedWeights && layer.kind == LayerKind::kLinear && wants_packed(options)) {
      const LinearRecord record = tables.linear(layer.parameters);
      scratch->joint_sums[i] = checked(joint_sums);
      if (find_shared_columns(plan, i, record).by_joint.count > 0) {
        joint_sums += static_cast<uint64_t>(sizes.joints) * padded_outputs(record.out);
      }
    }
  }
  if (joint_sums / 2 > sums) sums = joint_sums / 2;  // padded_outputs() is even
  scratch->sums = arena.alloc<int64_t>(checked(sums * sizes.lanes));
  scratch->lane_sums = sums;
  for (uint32_t b = 0; b < plan.buffer_count; ++b) {
    scratch->tile[b] = nullptr;
    if (!touched[b]) continue;
    scratch->tile[b] = arena.alloc<int16_t>(
        checked(sizes.tile_vertices() * plan.slots(static_cast<uint16_t>(b)) * plan.buffers[b].channels));
  }
  scratch->vertices = arena.alloc<uint32_t>(checked(sizes.tile_vertices()));
  scratch->joints = arena.alloc<uint16_t>(checked(sizes.tile_vertices() * plan.candidates));
  return arena.ok();
}

// One run over one mesh: everything the steps below share.
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

// Some vertices of a run on their way through a stage.
struct Tile {
  const Run& run;
  uint32_t lane;        // whose scratch they use
  uint32_t table_lane;  // whose tables they read
  uint32_t count;       // vertices
  bool shared;          // its shared columns are multiplied once
  const uint32_t* vertices() const { return run.scratch.vertices + first(); }
  const uint16_t* joints() const { return run.scratch.joints + first() * run.plan.candidates; }
  size_t first() const { return static_cast<size_t>(lane) * run.sizes.tile; }  // vertex of the scratch
};

uint32_t slots_of(const Run& run, const Region& region) { return run.plan.slots(region.buffer); }
int16_t* table_of(const Run& run, uint32_t index, uint32_t lane) {
  return run.scratch.table[index] +
         static_cast<size_t>(table_values(run.plan, run.plan.layers[index], run.sizes)) * lane;
}

int64_t* sums_of(const Run& run, uint32_t lane) {
  return run.scratch.sums + static_cast<size_t>(run.scratch.lane_sums) * lane;
}
int32_t* joint_sums_of(const Run& run, uint32_t index, uint32_t lane) {
  return static_cast<int32_t*>(static_cast<void*>(sums_of(run, lane))) + run.scratch.joint_sums[index];
}

// Rows of a stored output, or of an input, for the whole mesh; `channel` is the buffer's.
RowsView whole_mesh(const Run& run, uint16_t buffer, int producer, uint32_t channel) {
  if (producer == kFromInput) {
    return {run.input.inputs[buffer] + channel, run.plan.buffers[buffer].channels};
  }
  const Region& out = run.plan.layers[producer].out;
  const int16_t* rows = run.storage + static_cast<size_t>(run.plan.store_offset[producer]) * run.sizes.vertices;
  return {rows + (channel - out.offset), out.channels};
}

int16_t* tile_row(const Tile& tile, const Region& region, size_t row) {
  const NetworkPlan& plan = tile.run.plan;
  return tile.run.scratch.tile[region.buffer] +
         (tile.first() * plan.slots(region.buffer) + row) * plan.buffers[region.buffer].channels + region.offset;
}
RowsView tile_rows(const Tile& tile, const Region& region) {
  return {tile_row(tile, region, 0), tile.run.plan.buffers[region.buffer].channels};
}

// Of the usual 16 to 96 bytes a call of memcpy would be most of the work.
void copy_values(int16_t* to, const int16_t* from, uint32_t count) {
  constexpr uint32_t kPiece = 8;
  for (; !kSmallCode && count >= kPiece; count -= kPiece, to += kPiece, from += kPiece)
    memcpy(to, from, kPiece * sizeof(int16_t));
  if (count != 0) memcpy(to, from, count * sizeof(int16_t));
}

// Some channels of a table and where they come from.
struct TablePiece {
  const Layer& layer;
  RowsView values;  // their first channel
  uint32_t channels;
  int16_t* table;   // their place in the first row
  uint32_t stride;  // between rows of the table
};

constexpr uint32_t kPieceChannels = 16;

// Calls visit(piece) for the tables of the stage's global layers, or of its part layers. Segments of at least two times
// kPieceChannels are cut where that is asked for. A region of several writers gives one table behind the other.
template <class Visit>
void each_table_piece(const Run& run, uint32_t stage, bool global, uint32_t table_lane, bool cut, Visit visit) {
  for (uint32_t i = 0; i < run.plan.layer_count; ++i) {
    const Layer& layer = run.plan.layers[i];
    if (run.plan.stage[i] != stage || !uses_table(layer.kind) || (layer.kind != LayerKind::kPartMean) != global)
      continue;
    const bool by_joint = !global && has_slots(run.plan.buffers[layer.in.buffer].domain);
    int16_t* table = table_of(run, i, table_lane);
    for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
      const Segment segment = segment_at(run.plan.layers, run.plan.input_count, i, layer.in, channel);
      const RowsView values = whole_mesh(run, layer.in.buffer, segment.producer, channel);
      const uint32_t step = cut && segment.count >= 2 * kPieceChannels ? kPieceChannels : segment.count;
      uint32_t first = 0;
      do {
        const uint32_t channels = segment.count - first < step ? segment.count - first : step;
        visit(TablePiece{layer, {values.data + first, values.stride}, channels, table + first, segment.count});
        first += step;
      } while (kHasThreads && first < segment.count);
      table += static_cast<size_t>(segment.count) * (by_joint ? run.sizes.joints : 1u);
      channel += segment.count;
    }
  }
}

// The vertices are those of the part. Scratch is the lane's.
void make_table_piece(const Run& run, const TablePiece& piece, const uint32_t* vertices, uint32_t count,
                      uint32_t lane) {
  const uint32_t k = run.plan.candidates;
  int64_t* const sums = sums_of(run, lane);
  const bool pair = has_slots(run.plan.buffers[piece.layer.in.buffer].domain);
  const uint16_t* present = pair ? run.input.joints : nullptr;
  const size_t rows = static_cast<size_t>(run.sizes.vertices) * slots_of(run, piece.layer.in);
  if (piece.layer.kind == LayerKind::kGlobalMean) {
    run.kernels.global_mean(piece.values, piece.channels, present, rows, sums, piece.table);
  } else if (piece.layer.kind == LayerKind::kGlobalMax) {
    run.kernels.global_max(piece.values, piece.channels, present, rows, piece.table);
  } else if (!pair) {
    run.kernels.part_mean_vertex(piece.values, piece.channels, vertices, count, sums, piece.table);
  } else if (!kHasThreads || piece.channels == piece.stride) {
    run.kernels.part_mean_pair(piece.values, piece.channels, run.input.joints, k, vertices, count, sums, piece.table);
  } else {
    // The lane's sums have room for all channels, at least twice these, and so for the means of these behind them. Rows
    // of joints that are not met are copied as they are.
    const size_t size = static_cast<size_t>(run.sizes.joints) * piece.channels;
    int16_t* const means = static_cast<int16_t*>(static_cast<void*>(sums + size));
    memset(means, 0, size * sizeof(int16_t));
    run.kernels.part_mean_pair(piece.values, piece.channels, run.input.joints, k, vertices, count, sums, means);
    for (uint32_t joint = 0; joint < run.sizes.joints; ++joint) {
      copy_values(piece.table + static_cast<size_t>(joint) * piece.stride,
                  means + static_cast<size_t>(joint) * piece.channels, piece.channels);
    }
  }
}

// Tables of the stage's global layers, or of its part layers for one part (vertices, count), in a lane's memory.
void make_tables(const Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count, uint32_t lane) {
  each_table_piece(run, stage, global, lane, false,
                   [&](const TablePiece& piece) { make_table_piece(run, piece, vertices, count, lane); });
}

// The same in the first lane's memory, on all lanes.
void share_tables(const Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count) {
  if (!kHasThreads || run.sizes.lanes == 1) return make_tables(run, stage, global, vertices, count, 0);
  uint32_t pieces = 0;
  each_table_piece(run, stage, global, 0, true, [&](const TablePiece&) { ++pieces; });
  run.input.threads.each(pieces, [&](uint32_t index, uint32_t lane) {
    uint32_t at = 0;
    each_table_piece(run, stage, global, 0, true, [&](const TablePiece& piece) {
      if (at++ == index) make_table_piece(run, piece, vertices, count, lane);
    });
  });
}

// Multiplies the columns by_joint of the stage's linear layers with the means of one part: one product per joint that is a
// candidate in the part. The sums lie where the tables' scratch was. `met` has a bit for every such joint.
void multiply_part_means(const Run& run, uint32_t stage, const uint32_t* vertices, uint32_t count, uint32_t lane) {
  if (!kHasPackedWeights || !run.packed.has_shared) return;
  const uint32_t k = run.plan.candidates, words = (run.sizes.joints + 31) / 32;
  uint32_t met[SINEW_MAX_JOINTS / 32];
  for (uint32_t word = 0; word < words; ++word) met[word] = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const uint16_t* const joints = run.input.joints + static_cast<size_t>(vertices[i]) * k;
    for (uint32_t slot = 0; slot < k; ++slot) {
      if (joints[slot] != kNoJoint) met[joints[slot] / 32] |= 1u << joints[slot] % 32;
    }
  }
  for (uint32_t i = 0; i < run.plan.layer_count; ++i) {
    if (run.plan.stage[i] != stage || run.plan.layers[i].kind != LayerKind::kLinear ||
        run.packed.columns[i].by_joint.count == 0)
      continue;
    const SharedColumns& columns = run.packed.columns[i];
    LinearView linear = make_linear_view(run.tables, run.plan.layers[i]);
    linear.packed = run.packed.view(linear, i);
    linear.packed.bias = nullptr;
    linear.packed.weights += static_cast<size_t>(columns.by_joint.first) * kPackOutputs;
    linear.packed.ranges[0] = {0, columns.by_joint.count};
    linear.packed.range_count = 1;
    const int16_t* const table = table_of(run, columns.part_mean, lane);
    int32_t* const sums = joint_sums_of(run, i, lane);
    for (uint32_t joint = 0; joint < run.sizes.joints; ++joint) {
      if ((met[joint / 32] >> joint % 32 & 1) == 0) continue;
      run.kernels.linear_sums(linear, {table + static_cast<size_t>(joint) * columns.by_joint.count, 0}, 1,
                              sums + static_cast<size_t>(joint) * padded_outputs(linear.out));
    }
  }
}

RowsRead rows_read(const Tile& tile, uint32_t index) {
  return kHasPackedWeights && tile.shared ? tile.run.packed.rows_read[index] : RowsRead::kAll;
}

// Shared columns are read from the first slot's row, which must be present if any is. Candidates that the engine found
// are so. A tile of other candidates is computed row by row.
bool first_slot_speaks_for_all(const uint16_t* joints, uint32_t vertices, uint32_t k) {
  for (uint32_t i = 0; i < vertices; ++i) {
    const uint16_t* row = joints + static_cast<size_t>(i) * k;
    for (uint32_t slot = 1; row[0] == kNoJoint && slot < k; ++slot) {
      if (row[slot] != kNoJoint) return false;
    }
  }
  return true;
}

// Prepares a linear layer with shared columns for one tile. The columns `shared` are multiplied here, from the row of each
// vertex' first slot. The view is changed so that the kernel starts each row from that sum and from its joint's sum, and
// multiplies the row's own columns alone.
void add_shared_columns(const Tile& tile, uint32_t index, LinearView* linear) {
  const Run& run = tile.run;
  const SharedColumns& columns = run.packed.columns[index];
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates;
  if (columns.shared_count > 0) {
    int32_t* const starts = run.packed.starts + tile.first() * run.packed.outputs;
    linear->packed.range_count = columns.shared_count;
    memcpy(linear->packed.ranges, columns.shared, sizeof(columns.shared));
    const RowsView first_slots = {tile_row(tile, layer.in, 0), run.plan.buffers[layer.in.buffer].channels * k};
    run.kernels.linear_sums(*linear, first_slots, tile.count, starts);
    linear->packed.starts = starts;
    linear->packed.rows_per_start = k;
  }
  if (columns.by_joint.count > 0) linear->packed.joint_starts = joint_sums_of(run, index, tile.table_lane);
  linear->packed.range_count = columns.own_count;
  memcpy(linear->packed.ranges, columns.own, sizeof(columns.own));
}

void run_linear(const Tile& tile, uint32_t index) {
  const Run& run = tile.run;
  const Layer& layer = run.plan.layers[index];
  const bool pair = has_slots(run.plan.buffers[layer.out.buffer].domain);
  const RowsView residual = (layer.flags & kLayerResidual) != 0 ? tile_rows(tile, layer.residual) : RowsView();
  LinearView linear = make_linear_view(run.tables, layer);
  if (kHasPackedWeights && run.packed.memory != nullptr) {
    linear.packed = run.packed.view(linear, index);
    if (tile.shared && run.packed.columns[index].any()) add_shared_columns(tile, index, &linear);
  }
  run.linear(linear, tile_rows(tile, layer.in), residual, pair ? tile.joints() : nullptr,
             tile.count * slots_of(run, layer.out), tile_row(tile, layer.out, 0),
             run.plan.buffers[layer.out.buffer].channels);
}

// Layers of neighbours: rows of neighbours come from storage, whatever tile they belong to.
void run_ring(const Tile& tile, uint32_t index) {
  const Run& run = tile.run;
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates, slots = slots_of(run, layer.out);
  const bool mean = layer.kind == LayerKind::kRingMean, far = !kSmallCode && (layer.flags & kLayerFar) != 0;
  const uint32_t* const offsets = far ? run.input.far_offsets : run.input.row_offsets;
  const uint32_t* const neighbours_of = far ? run.input.far_indices : run.input.col_indices;
  for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
    const Segment segment = segment_at(run.plan.layers, run.plan.input_count, index, layer.in, channel);
    const RowsView values = whole_mesh(run, layer.in.buffer, segment.producer, channel);
    for (uint32_t row = 0; row < tile.count * slots; ++row) {
      const uint32_t vertex = tile.vertices()[row / slots];
      const uint32_t* ring = neighbours_of + offsets[vertex];
      const uint32_t valence = offsets[vertex + 1] - offsets[vertex];
      int16_t* out = tile_row(tile, layer.out, row) + (channel - layer.in.offset);
      if (!has_slots(run.plan.buffers[layer.out.buffer].domain)) {
        if (mean) {
          run.kernels.ring_mean_vertex(values, segment.count, ring, valence, out);
        } else {
          run.kernels.ring_max_vertex(values, segment.count, ring, valence, out);
        }
      } else {
        const uint16_t joint = tile.joints()[row];
        const uint32_t neighbours = joint == kNoJoint ? 0 : valence;  // an absent slot has none
        if (mean) {
          run.kernels.ring_mean_pair(values, segment.count, run.input.joints, k, joint, ring, neighbours, out);
        } else {
          run.kernels.ring_max_pair(values, segment.count, run.input.joints, k, joint, ring, neighbours, out);
        }
      }
    }
    channel += segment.count;
  }
}

// Hands a table's row to the tile's rows.
void run_table(const Tile& tile, uint32_t index) {
  const Run& run = tile.run;
  const Layer& layer = run.plan.layers[index];
  const bool pair = has_slots(run.plan.buffers[layer.out.buffer].domain);
  const bool by_joint = pair && layer.kind == LayerKind::kPartMean;
  const uint32_t rows = tile.count * slots_of(run, layer.out);
  const int16_t* table = table_of(run, index, tile.table_lane);
  const RowsRead read = rows_read(tile, index);
  if (read == RowsRead::kNone) return;
  for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
    const Segment segment = segment_at(run.plan.layers, run.plan.input_count, index, layer.in, channel);
    for (uint32_t row = 0; row < rows; row += read == RowsRead::kFirstOfVertex ? run.plan.candidates : 1) {
      int16_t* out = tile_row(tile, layer.out, row) + (channel - layer.in.offset);
      const uint16_t joint = pair ? tile.joints()[row] : static_cast<uint16_t>(0);
      if (joint == kNoJoint) {
        memset(out, 0, segment.count * sizeof(int16_t));
      } else {
        copy_values(out, table + (by_joint ? static_cast<size_t>(joint) * segment.count : 0), segment.count);
      }
    }
    table += static_cast<size_t>(segment.count) * (by_joint ? run.sizes.joints : 1u);
    channel += segment.count;
  }
}

void run_local(const Tile& tile, uint32_t index) {
  const Run& run = tile.run;
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates;
  const uint16_t* joints = tile.joints();
  const uint32_t count = tile.count;
  const uint32_t out_stride = run.plan.buffers[layer.out.buffer].channels;
  const RowsRead read = rows_read(tile, index);
  switch (layer.kind) {
    case LayerKind::kLinear:
      run_linear(tile, index);
      break;
    case LayerKind::kCandidateMax: {
      const int part_mean = table_of_maximum(run.plan, index);
      const uint32_t out_slots = read == RowsRead::kAll ? k : 1;
      for (uint32_t i = 0; i < count; ++i) {
        const size_t row = static_cast<size_t>(i) * k;
        RowsView values = {tile_row(tile, layer.in, row), run.plan.buffers[layer.in.buffer].channels};
        if (part_mean >= 0) {
          values = {table_of(run, static_cast<uint32_t>(part_mean), tile.table_lane), layer.in.channels};
        }
        run.kernels.candidate_max(values, part_mean >= 0, layer.in.channels, joints + row, k,
                                  tile_row(tile, layer.out, row), out_stride, out_slots);
      }
      break;
    }
    case LayerKind::kVertexToPair:
      for (uint32_t row = 0; row < count * k; row += read == RowsRead::kAll ? 1 : k) {
        int16_t* out = tile_row(tile, layer.out, row);
        if (joints[row] == kNoJoint) {
          memset(out, 0, layer.out.channels * sizeof(int16_t));
        } else {
          copy_values(out, tile_row(tile, layer.in, row / k), layer.out.channels);
        }
      }
      break;
    case LayerKind::kPairToVertex:  // absent slots are 0 already
      for (uint32_t row = 0; row < count * k; ++row) {
        copy_values(tile_row(tile, layer.out, row / k) + (row % k) * layer.in.channels, tile_row(tile, layer.in, row),
                    layer.in.channels);
      }
      break;
    case LayerKind::kVertexToSlots:
      for (uint32_t row = 0; row < count * k; ++row) {
        int16_t* out = tile_row(tile, layer.out, row);
        if (joints[row] == kNoJoint) {
          memset(out, 0, layer.out.channels * sizeof(int16_t));
        } else {
          copy_values(out, tile_row(tile, layer.in, row / k) + (row % k) * layer.out.channels, layer.out.channels);
        }
      }
      break;
    default:  // kCopy: the reader knows no other kind
      for (uint32_t row = 0; row < count * slots_of(run, layer.out); ++row) {
        copy_values(tile_row(tile, layer.out, row), tile_row(tile, layer.in, row), layer.out.channels);
      }
      break;
  }
}

// Rows of the tile's vertices between a whole-mesh array and the tile. `region` is the array's place in its buffer.
void load_rows(const Tile& tile, const Region& region, RowsView from) {
  const uint32_t slots = slots_of(tile.run, region), stride = tile.run.plan.buffers[region.buffer].channels;
  int16_t* to = tile_row(tile, region, 0);
  for (uint32_t i = 0; i < tile.count; ++i) {
    const int16_t* row = from.data + static_cast<size_t>(tile.vertices()[i]) * slots * from.stride;
    for (uint32_t slot = 0; slot < slots; ++slot, to += stride, row += from.stride)
      copy_values(to, row, region.channels);
  }
}
void store_rows(const Tile& tile, const Region& region, int16_t* to) {
  const uint32_t slots = slots_of(tile.run, region), stride = tile.run.plan.buffers[region.buffer].channels;
  const int16_t* from = tile_row(tile, region, 0);
  for (uint32_t i = 0; i < tile.count; ++i) {
    int16_t* row = to + static_cast<size_t>(tile.vertices()[i]) * slots * region.channels;
    for (uint32_t slot = 0; slot < slots; ++slot, from += stride, row += region.channels)
      copy_values(row, from, region.channels);
  }
}

// The tile's vertices go through all layers of the stage.
void run_tile(Tile tile, uint32_t stage) {
  const Run& run = tile.run;
  const uint32_t k = run.plan.candidates;
  for (uint32_t i = 0; i < tile.count; ++i) {
    memcpy(run.scratch.joints + (tile.first() + i) * k, run.input.joints + static_cast<size_t>(tile.vertices()[i]) * k,
           k * sizeof(uint16_t));
  }
  tile.shared = kHasPackedWeights && run.packed.has_shared && first_slot_speaks_for_all(tile.joints(), tile.count, k);
  for (uint16_t b = 0; b < run.plan.input_count; ++b) {
    if (!run.scratch.load_input[b]) continue;
    load_rows(tile, {b, 0, run.plan.buffers[b].channels}, whole_mesh(run, b, kFromInput, 0));
  }
  for (uint32_t i = 0; i < run.plan.layer_count; ++i) {
    const Layer& layer = run.plan.layers[i];
    if (run.scratch.load[i]) {
      load_rows(tile, layer.out, whole_mesh(run, layer.out.buffer, static_cast<int>(i), layer.out.offset));
    }
    if (run.plan.stage[i] != stage) continue;
    if (layer.kind == LayerKind::kRingMean || layer.kind == LayerKind::kRingMax) {
      run_ring(tile, i);
    } else if (uses_table(layer.kind)) {
      run_table(tile, i);
    } else {
      run_local(tile, i);
    }
    if (run.plan.stored[i]) {
      store_rows(tile, layer.out, run.storage + static_cast<size_t>(run.plan.store_offset[i]) * run.sizes.vertices);
    }
    if (i + 1 == run.plan.layer_count) store_rows(tile, layer.out, run.logits);
  }
}

bool has_part_layer(const NetworkPlan& plan, uint32_t stage) {
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    if (plan.stage[i] == stage && plan.layers[i].kind == LayerKind::kPartMean) return true;
  }
  return false;
}

// One walk over the vertices of a stage.
class StageWalk {
 public:
  StageWalk(const Run& run, uint32_t stage, const Progress& progress)
      : run_(run),
        stage_(stage),
        progress_(progress),
        by_part_(has_part_layer(run.plan, stage)),
        small_part_(uint64_t{run.sizes.tile} * kSmallPart),
        round_(run.sizes.tile_vertices() * kTilesPerRound),
        done_(static_cast<uint64_t>(stage) * run.sizes.vertices) {}

  // Part by part when a layer wants part means, so that one part's table is enough; else in order. Returns false when
  // the caller cancelled.
  bool run() {
    share_tables(run_, stage_, true, nullptr, 0);
    for (uint32_t lane = 1; lane < run_.sizes.lanes; ++lane) copy_global_tables(lane);
    if (!by_part_) return run_range(0, run_.sizes.vertices);
    const uint32_t* offsets = run_.input.part_offsets;
    for (uint32_t part = 0; part < run_.input.part_count;) {
      // A part that keeps all lanes busy, or as many small parts as a round holds: a lane takes those whole.
      uint32_t end = part;
      while (end < run_.input.part_count && offsets[end + 1] - offsets[end] < small_part_ &&
             offsets[end + 1] - offsets[part] <= round_) {
        ++end;
      }
      if (end == part) {
        share_part_tables(part);
        if (!run_range(offsets[part], offsets[part + 1])) return false;
        ++part;
      } else {
        if (!run_parts(part, end)) return false;
        part = end;
      }
    }
    return true;
  }

 private:
  static constexpr uint32_t kTilesPerRound = 32;  // of each lane between two reports of progress
  static constexpr uint32_t kSmallPart = 4;       // tiles

  bool report(uint32_t vertices) {
    const uint64_t all = static_cast<uint64_t>(run_.plan.stage_count) * run_.sizes.vertices;
    const bool go_on = progress_.report(static_cast<uint32_t>(done_ * 1000 / all));
    done_ += vertices;
    return go_on;
  }

  // Global layers are computed once; every lane's own table has them, beside its parts'.
  void copy_global_tables(uint32_t lane) const {
    for (uint32_t i = 0; i < run_.plan.layer_count; ++i) {
      const Layer& layer = run_.plan.layers[i];
      if (run_.plan.stage[i] != stage_ || !uses_table(layer.kind) || layer.kind == LayerKind::kPartMean) continue;
      copy_values(table_of(run_, i, lane), table_of(run_, i, 0), layer.in.channels);
    }
  }

  void share_part_tables(uint32_t part) const {
    const uint32_t begin = run_.input.part_offsets[part], end = run_.input.part_offsets[part + 1];
    share_tables(run_, stage_, false, run_.input.part_vertices + begin, end - begin);
    if (kHasPackedWeights) multiply_part_means(run_, stage_, run_.input.part_vertices + begin, end - begin, 0);
  }

  void make_part_tables(uint32_t part, uint32_t lane) const {
    const uint32_t begin = run_.input.part_offsets[part], end = run_.input.part_offsets[part + 1];
    make_tables(run_, stage_, false, run_.input.part_vertices + begin, end - begin, lane);
    if (kHasPackedWeights) {
      multiply_part_means(run_, stage_, run_.input.part_vertices + begin, end - begin, lane);
    }
  }

  void run_tiles(uint32_t first, uint32_t end, uint32_t lane, uint32_t table_lane) const {
    for (; first < end; first += run_.sizes.tile) {
      const Tile tile = {run_, lane, table_lane, end - first < run_.sizes.tile ? end - first : run_.sizes.tile, false};
      for (uint32_t i = 0; i < tile.count; ++i) {
        run_.scratch.vertices[tile.first() + i] = by_part_ ? run_.input.part_vertices[first + i] : first + i;
      }
      run_tile(tile, stage_);
    }
  }

  bool run_range(uint32_t begin, uint32_t end) {
    for (uint32_t first = begin; first < end;) {
      const uint32_t last = end - first < round_ ? end : first + static_cast<uint32_t>(round_);
      if (!report(last - first)) return false;
      run_.input.threads.ranges(last - first, run_.sizes.tile, [&](uint32_t from, uint32_t to, uint32_t lane) {
        run_tiles(first + from, first + to, lane, 0);
      });
      first = last;
    }
    return true;
  }

  bool run_parts(uint32_t first, uint32_t end) {
    const uint32_t* offsets = run_.input.part_offsets;
    if (!report(offsets[end] - offsets[first])) return false;
    run_.input.threads.each(end - first, [&](uint32_t index, uint32_t lane) {
      const uint32_t part = first + index;
      if (offsets[part] == offsets[part + 1]) return;
      make_part_tables(part, lane);
      run_tiles(offsets[part], offsets[part + 1], lane, lane);
    });
    return true;
  }

  const Run& run_;
  const uint32_t stage_;
  const Progress& progress_;
  const bool by_part_;
  const uint64_t small_part_, round_;  // vertices
  uint64_t done_;
};

}  // namespace

sinew_status run_network(const sinew_model& model, const NetworkInput& input, const Kernels& kernels,
                         const Progress& progress, Arena& arena, int16_t* logits, const NetworkOptions& options) {
  const ArenaScope scope(arena);
  NetworkPlan plan;
  make_plan(model, input.candidate_count, &plan);
  const ModelTables tables(model.bytes);
  PackedLayers packed;
  const Sizes sizes = {input.vertex_count, input.joint_count, options.tile_vertices, input.threads.lane_count()};
  if (kHasPackedWeights) (void)packed.allocate(model, plan, tables, options, sizes.lanes, arena);
  const bool reads_packed = wants_packed(options) && kernels.linear_packed != nullptr;
  const LinearKernel linear = reads_packed ? kernels.linear_packed : kernels.linear;
  Run run = {plan, input, tables, kernels, linear, packed, sizes, nullptr, logits, {}};
  run.storage = allocate_storage(plan, run.sizes, arena);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (kHasPackedWeights && !arena.measuring()) packed.fill(plan, tables, kernels.linear_packed != nullptr);
  for (uint32_t stage = 0; stage < plan.stage_count; ++stage) {
    const ArenaScope stage_scope(arena);
    if (!allocate_stage(plan, tables, options, stage, run.sizes, arena, &run.scratch)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring() && !StageWalk(run, stage, progress).run()) return SINEW_ERROR_CANCELLED;
  }
  return SINEW_OK;
}

}  // namespace sinew
