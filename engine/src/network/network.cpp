// SPDX-License-Identifier: MIT
// Executes a model's layer list stage by stage, tile by tile, with the kernels that this processor runs best.
#include "network/network.hpp"

#include <string.h>

#include "kernels/select.hpp"
#include "model/regions.hpp"
#include "network/plan.hpp"

namespace sinew {
namespace {

struct Sizes {
  uint32_t vertices = 0, joints = 0, tile = 0;
};

// Scratch of one stage.
struct StageScratch {
  int16_t* tile[kMaxBuffers];  // [tile x slots x channels] rows of each buffer the stage touches, else null
  bool load[kMaxLayers];       // outputs of earlier stages that this stage reads row by row
  bool load_input[2];
  int16_t* table[kMaxLayers];  // part and global layers: [joints x channels] or [channels]
  int64_t* sums;               // for the table being made
  uint32_t* vertices;          // [tile] vertex of each tile row
  uint16_t* joints;            // [tile x K] their candidates
};

// A count that does not fit size_t becomes SIZE_MAX, which no arena grants.
size_t checked(uint64_t count) { return count > SIZE_MAX ? SIZE_MAX : static_cast<size_t>(count); }

bool uses_table(LayerKind kind) {
  return kind == LayerKind::kPartMean || kind == LayerKind::kGlobalMean || kind == LayerKind::kGlobalMax;
}

uint64_t table_values(const NetworkPlan& plan, const Layer& layer, const Sizes& sizes) {
  const bool by_joint = layer.kind == LayerKind::kPartMean && plan.buffers[layer.in.buffer].domain == Domain::kPair;
  return static_cast<uint64_t>(layer.in.channels) * (by_joint ? sizes.joints : 1u);
}

int16_t* allocate_storage(const NetworkPlan& plan, const Sizes& sizes, Arena& arena) {
  return arena.alloc<int16_t>(checked(plan.store_values * sizes.vertices));
}

LinearView make_linear_view(const ModelTables& tables, const Layer& layer) {
  const LinearRecord record = tables.linear(layer.parameters);
  LinearView view;
  view.weights = tables.int16_at(record.weights);
  view.bias = tables.bytes() + record.bias;
  view.residual = (layer.flags & kLayerResidual) != 0 ? tables.int16_at(record.residual) : nullptr;
  view.shifts = tables.bytes() + record.shifts;
  view.in = record.in;
  view.out = record.out;
  view.block = record.block;
  view.wide = record.accumulator == AccumulatorClass::kWide;
  view.low = range_low(record.range);
  view.high = range_high(record.range);
  return view;
}

// Whether memory is asked for rearranged weights. Does not look at the processor, so that the size query is the same
// everywhere; a processor whose kernels do not want them leaves the memory unused.
bool wants_packed(const NetworkOptions& options) {
  return !options.weights_in_place && options.kernel != SINEW_KERNEL_REF;
}

// A pair layer whose columns are partly the same in all slots of a vertex: those are multiplied once per vertex.
struct SharedColumns {
  ColumnRange own[kMaxRanges], shared[kMaxRanges];
  uint16_t own_count = 0, shared_count = 0;  // shared 0 = all columns are the row's own
};

// True when every present slot of a vertex has the same values there.
bool same_in_all_slots(const NetworkPlan& plan, const Segment& segment) {
  if (segment.producer < 0) return false;
  const LayerKind kind = plan.layers[segment.producer].kind;
  return kind == LayerKind::kCandidateMax || kind == LayerKind::kVertexToPair || kind == LayerKind::kGlobalMean ||
         kind == LayerKind::kGlobalMax;
}

// Adds columns [first, first + count) behind the last range, or to it. False when there is no room.
bool add_range(uint32_t first, uint32_t count, ColumnRange* ranges, uint16_t* range_count) {
  if (*range_count > 0) {
    ColumnRange& last = ranges[*range_count - 1];
    if (last.first + last.count == first) {
      last.count = static_cast<uint16_t>(last.count + count);
      return true;
    }
  }
  if (*range_count == kMaxRanges) return false;
  ranges[*range_count].first = static_cast<uint16_t>(first);
  ranges[*range_count].count = static_cast<uint16_t>(count);
  ++*range_count;
  return true;
}

SharedColumns find_shared_columns(const NetworkPlan& plan, uint32_t index, const LinearRecord& record) {
  const Layer& layer = plan.layers[index];
  SharedColumns columns;
  if (plan.buffers[layer.in.buffer].domain != Domain::kPair || record.accumulator != AccumulatorClass::kNarrow) {
    return SharedColumns();
  }
  for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
    const Segment segment = segment_at(plan.layers, index, layer.in, channel);
    const uint32_t first = channel - layer.in.offset;
    const bool shared = same_in_all_slots(plan, segment);
    // Ranges start at whole pairs of columns, and so must what follows them.
    if (first % 2 != 0) return SharedColumns();
    if (!add_range(first, segment.count, shared ? columns.shared : columns.own,
                   shared ? &columns.shared_count : &columns.own_count)) {
      return SharedColumns();
    }
    channel += segment.count;
  }
  return columns;
}

// Where each linear layer's rearranged parameters are; null = nowhere.
struct PackedLayers {
  uint8_t* memory[kMaxLayers];
  bool has_shared = false;           // some layer has shared columns
  SharedColumns* columns = nullptr;  // [layers]
  int32_t* starts = nullptr;         // [tile x widest layer's outputs] sums of shared columns

  bool allocate(const NetworkPlan& plan, const ModelTables& tables, const NetworkOptions& options, Arena& arena) {
    uint32_t outputs = 0;
    for (uint32_t i = 0; i < plan.layer_count; ++i) {
      memory[i] = nullptr;
      if (plan.layers[i].kind != LayerKind::kLinear || !wants_packed(options)) continue;
      const LinearRecord record = tables.linear(plan.layers[i].parameters);
      memory[i] = arena.alloc<uint8_t>(checked(packed_linear_bytes(record.in, record.out, record.block)));
      if (find_shared_columns(plan, i, record).shared_count > 0 && padded_outputs(record.out) > outputs) {
        outputs = padded_outputs(record.out);
      }
    }
    columns = arena.alloc<SharedColumns>(outputs > 0 ? plan.layer_count : 0);
    starts = arena.alloc<int32_t>(checked(static_cast<uint64_t>(options.tile_vertices) * outputs));
    has_shared = outputs > 0;
    return arena.ok();
  }
  // Leaves the memory unused where no kernel wants it.
  void fill(const NetworkPlan& plan, const ModelTables& tables, bool wanted) {
    for (uint32_t i = 0; i < plan.layer_count; ++i) {
      if (!wanted) memory[i] = nullptr;
      if (memory[i] == nullptr) continue;
      pack_linear(make_linear_view(tables, plan.layers[i]), memory[i]);
      if (has_shared) columns[i] = find_shared_columns(plan, i, tables.linear(plan.layers[i].parameters));
    }
  }
};

// Marks what a stage reads from a region row by row.
void mark_loads(const NetworkPlan& plan, uint32_t stage, uint32_t reader, const Region& region, StageScratch* scratch,
                bool* touched) {
  touched[region.buffer] = true;
  for (uint32_t channel = region.offset; channel < region_end(region);) {
    const Segment segment = segment_at(plan.layers, reader, region, channel);
    if (segment.producer == kFromInput) {
      scratch->load_input[region.buffer] = true;
    } else if (plan.stage[segment.producer] < stage) {
      scratch->load[segment.producer] = true;
    }
    channel += segment.count;
  }
}

// All allocations of one stage, measured and real alike; also notes what to load. Returns arena.ok().
bool allocate_stage(const NetworkPlan& plan, uint32_t stage, const Sizes& sizes, Arena& arena, StageScratch* scratch) {
  bool touched[kMaxBuffers] = {};
  for (uint32_t i = 0; i < kMaxLayers; ++i) scratch->load[i] = false;
  scratch->load_input[0] = scratch->load_input[1] = false;
  uint64_t sums = 0;
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    scratch->table[i] = nullptr;
    if (plan.stage[i] != stage) continue;
    const Layer& layer = plan.layers[i];
    touched[layer.out.buffer] = true;
    if (!reads_other_rows(layer.kind)) mark_loads(plan, stage, i, layer.in, scratch, touched);
    if ((layer.flags & kLayerResidual) != 0) mark_loads(plan, stage, i, layer.residual, scratch, touched);
    if (uses_table(layer.kind)) {
      const uint64_t values = table_values(plan, layer, sizes);
      scratch->table[i] = arena.alloc<int16_t>(checked(values));
      if (values > sums) sums = values;
    }
  }
  scratch->sums = arena.alloc<int64_t>(checked(sums));
  for (uint32_t b = 0; b < plan.buffer_count; ++b) {
    scratch->tile[b] = nullptr;
    if (!touched[b]) continue;
    scratch->tile[b] = arena.alloc<int16_t>(
        checked(static_cast<uint64_t>(sizes.tile) * plan.slots(static_cast<uint16_t>(b)) * plan.buffers[b].channels));
  }
  scratch->vertices = arena.alloc<uint32_t>(sizes.tile);
  scratch->joints = arena.alloc<uint16_t>(checked(static_cast<uint64_t>(sizes.tile) * plan.candidates));
  return arena.ok();
}

// One run over one mesh: everything the steps below share.
struct Run {
  const NetworkPlan& plan;
  const NetworkInput& input;
  const ModelTables tables;
  const Kernels& kernels;
  const PackedLayers& packed;
  Sizes sizes;
  int16_t* storage = nullptr;
  int16_t* logits = nullptr;
  StageScratch scratch;
};

uint32_t slots_of(const Run& run, const Region& region) { return run.plan.slots(region.buffer); }

// Rows of a stored output, or of an input, for the whole mesh; `channel` is the buffer's.
RowsView whole_mesh(const Run& run, uint16_t buffer, int producer, uint32_t channel) {
  if (producer == kFromInput) {
    const int16_t* rows = buffer == kVertexInput ? run.input.vertex_features : run.input.pair_features;
    return {rows + channel, run.plan.buffers[buffer].channels};
  }
  const Region& out = run.plan.layers[producer].out;
  const int16_t* rows = run.storage + static_cast<size_t>(run.plan.store_offset[producer]) * run.sizes.vertices;
  return {rows + (channel - out.offset), out.channels};
}

int16_t* tile_row(const Run& run, const Region& region, size_t row) {
  return run.scratch.tile[region.buffer] + row * run.plan.buffers[region.buffer].channels + region.offset;
}
RowsView tile_rows(const Run& run, const Region& region) {
  return {tile_row(run, region, 0), run.plan.buffers[region.buffer].channels};
}

void copy_values(int16_t* to, const int16_t* from, uint32_t count) { memcpy(to, from, count * sizeof(int16_t)); }

// Tables of the stage's global layers, or of its part layers for one part (vertices, count).
void make_tables(Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count) {
  const uint32_t k = run.plan.candidates;
  for (uint32_t i = 0; i < run.plan.layer_count; ++i) {
    const Layer& layer = run.plan.layers[i];
    if (run.plan.stage[i] != stage || !uses_table(layer.kind) || (layer.kind != LayerKind::kPartMean) != global)
      continue;
    const bool pair = run.plan.buffers[layer.in.buffer].domain == Domain::kPair;
    const uint16_t* present = pair ? run.input.joints : nullptr;
    const size_t rows = static_cast<size_t>(run.sizes.vertices) * slots_of(run, layer.in);
    // A region of several writers gives one table behind the other.
    int16_t* table = run.scratch.table[i];
    for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
      const Segment segment = segment_at(run.plan.layers, i, layer.in, channel);
      const RowsView values = whole_mesh(run, layer.in.buffer, segment.producer, channel);
      size_t made = segment.count;
      if (layer.kind == LayerKind::kGlobalMean) {
        run.kernels.global_mean(values, segment.count, present, rows, run.scratch.sums, table);
      } else if (layer.kind == LayerKind::kGlobalMax) {
        run.kernels.global_max(values, segment.count, present, rows, table);
      } else if (pair) {
        run.kernels.part_mean_pair(values, segment.count, run.input.joints, k, vertices, count, run.scratch.sums,
                                   table);
        made *= run.sizes.joints;
      } else {
        run.kernels.part_mean_vertex(values, segment.count, vertices, count, run.scratch.sums, table);
      }
      table += made;
      channel += segment.count;
    }
  }
}

// Present slots of a vertex stand before absent ones, wherever candidates come from the engine; a tile where they do
// not is computed row by row.
bool first_slot_speaks_for_all(const uint16_t* joints, uint32_t vertices, uint32_t k) {
  for (uint32_t i = 0; i < vertices; ++i) {
    const uint16_t* row = joints + static_cast<size_t>(i) * k;
    for (uint32_t slot = 1; row[0] == kNoJoint && slot < k; ++slot) {
      if (row[slot] != kNoJoint) return false;
    }
  }
  return true;
}

// Multiplies what a vertex' slots share once, from its first slot's row, and lets the rows start from it.
void add_shared_columns(const Run& run, uint32_t index, uint32_t rows, LinearView* linear) {
  const SharedColumns& columns = run.packed.columns[index];
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates;
  if (columns.shared_count == 0 || !first_slot_speaks_for_all(run.scratch.joints, rows / k, k)) return;
  linear->packed.range_count = columns.shared_count;
  memcpy(linear->packed.ranges, columns.shared, sizeof(columns.shared));
  const RowsView first_slots = {tile_row(run, layer.in, 0), run.plan.buffers[layer.in.buffer].channels * k};
  run.kernels.linear_sums(*linear, first_slots, rows / k, run.packed.starts);
  linear->packed.starts = run.packed.starts;
  linear->packed.rows_per_start = k;
  linear->packed.range_count = columns.own_count;
  memcpy(linear->packed.ranges, columns.own, sizeof(columns.own));
}

void run_linear(const Run& run, uint32_t index, uint32_t rows, const uint16_t* present) {
  const Layer& layer = run.plan.layers[index];
  const RowsView residual = (layer.flags & kLayerResidual) != 0 ? tile_rows(run, layer.residual) : RowsView();
  LinearView linear = make_linear_view(run.tables, layer);
  if (run.packed.memory[index] != nullptr) {
    linear.packed = packed_view(linear, run.packed.memory[index]);
    if (run.packed.has_shared) add_shared_columns(run, index, rows, &linear);
  }
  run.kernels.linear(linear, tile_rows(run, layer.in), residual, present, rows, tile_row(run, layer.out, 0),
                     run.plan.buffers[layer.out.buffer].channels);
}

// One-ring layers: rows of neighbours come from storage, whatever tile they belong to.
void run_ring(const Run& run, uint32_t index, uint32_t count) {
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates, slots = slots_of(run, layer.out);
  const bool mean = layer.kind == LayerKind::kRingMean;
  for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
    const Segment segment = segment_at(run.plan.layers, index, layer.in, channel);
    const RowsView values = whole_mesh(run, layer.in.buffer, segment.producer, channel);
    for (uint32_t row = 0; row < count * slots; ++row) {
      const uint32_t vertex = run.scratch.vertices[row / slots];
      const uint32_t* ring = run.input.col_indices + run.input.row_offsets[vertex];
      const uint32_t valence = run.input.row_offsets[vertex + 1] - run.input.row_offsets[vertex];
      int16_t* out = tile_row(run, layer.out, row) + (channel - layer.in.offset);
      if (run.plan.buffers[layer.out.buffer].domain == Domain::kVertex) {
        if (mean) {
          run.kernels.ring_mean_vertex(values, segment.count, ring, valence, out);
        } else {
          run.kernels.ring_max_vertex(values, segment.count, ring, valence, out);
        }
      } else {
        const uint16_t joint = run.scratch.joints[row];
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
void run_table(const Run& run, uint32_t index, uint32_t count) {
  const Layer& layer = run.plan.layers[index];
  const bool pair = run.plan.buffers[layer.out.buffer].domain == Domain::kPair;
  const bool by_joint = pair && layer.kind == LayerKind::kPartMean;
  const uint32_t rows = count * slots_of(run, layer.out);
  const int16_t* table = run.scratch.table[index];
  for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
    const Segment segment = segment_at(run.plan.layers, index, layer.in, channel);
    for (uint32_t row = 0; row < rows; ++row) {
      int16_t* out = tile_row(run, layer.out, row) + (channel - layer.in.offset);
      const uint16_t joint = pair ? run.scratch.joints[row] : static_cast<uint16_t>(0);
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

void run_local(const Run& run, uint32_t index, uint32_t count) {
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates;
  const uint16_t* joints = run.scratch.joints;
  const uint32_t out_stride = run.plan.buffers[layer.out.buffer].channels;
  switch (layer.kind) {
    case LayerKind::kLinear: {
      const bool pair = run.plan.buffers[layer.out.buffer].domain == Domain::kPair;
      run_linear(run, index, count * slots_of(run, layer.out), pair ? joints : nullptr);
      break;
    }
    case LayerKind::kCandidateMax:
      for (uint32_t i = 0; i < count; ++i) {
        const size_t row = static_cast<size_t>(i) * k;
        run.kernels.candidate_max({tile_row(run, layer.in, row), run.plan.buffers[layer.in.buffer].channels},
                                  layer.in.channels, joints + row, k, tile_row(run, layer.out, row), out_stride);
      }
      break;
    case LayerKind::kVertexToPair:
      for (uint32_t row = 0; row < count * k; ++row) {
        int16_t* out = tile_row(run, layer.out, row);
        if (joints[row] == kNoJoint) {
          memset(out, 0, layer.out.channels * sizeof(int16_t));
        } else {
          copy_values(out, tile_row(run, layer.in, row / k), layer.out.channels);
        }
      }
      break;
    case LayerKind::kPairToVertex:  // absent slots are 0 already
      for (uint32_t row = 0; row < count * k; ++row) {
        copy_values(tile_row(run, layer.out, row / k) + (row % k) * layer.in.channels, tile_row(run, layer.in, row),
                    layer.in.channels);
      }
      break;
    case LayerKind::kVertexToSlots:
      for (uint32_t row = 0; row < count * k; ++row) {
        int16_t* out = tile_row(run, layer.out, row);
        if (joints[row] == kNoJoint) {
          memset(out, 0, layer.out.channels * sizeof(int16_t));
        } else {
          copy_values(out, tile_row(run, layer.in, row / k) + (row % k) * layer.out.channels, layer.out.channels);
        }
      }
      break;
    default:  // kCopy: the reader knows no other kind
      for (uint32_t row = 0; row < count * slots_of(run, layer.out); ++row) {
        copy_values(tile_row(run, layer.out, row), tile_row(run, layer.in, row), layer.out.channels);
      }
      break;
  }
}

// Rows of the tile's vertices between a whole-mesh array and the tile. `region` is the array's place in its buffer.
void load_rows(const Run& run, const Region& region, RowsView from, uint32_t count) {
  const uint32_t slots = slots_of(run, region);
  for (uint32_t row = 0; row < count * slots; ++row) {
    const size_t mesh_row = static_cast<size_t>(run.scratch.vertices[row / slots]) * slots + row % slots;
    copy_values(tile_row(run, region, row), from.data + mesh_row * from.stride, region.channels);
  }
}
void store_rows(const Run& run, const Region& region, int16_t* to, uint32_t count) {
  const uint32_t slots = slots_of(run, region);
  for (uint32_t row = 0; row < count * slots; ++row) {
    const size_t mesh_row = static_cast<size_t>(run.scratch.vertices[row / slots]) * slots + row % slots;
    copy_values(to + mesh_row * region.channels, tile_row(run, region, row), region.channels);
  }
}

// scratch.vertices[0, count) goes through all layers of the stage.
void run_tile(Run& run, uint32_t stage, uint32_t count) {
  const uint32_t k = run.plan.candidates;
  for (uint32_t i = 0; i < count; ++i) {
    memcpy(run.scratch.joints + static_cast<size_t>(i) * k,
           run.input.joints + static_cast<size_t>(run.scratch.vertices[i]) * k, k * sizeof(uint16_t));
  }
  for (uint16_t b = 0; b < 2; ++b) {
    if (!run.scratch.load_input[b]) continue;
    load_rows(run, {b, 0, run.plan.buffers[b].channels}, whole_mesh(run, b, kFromInput, 0), count);
  }
  for (uint32_t i = 0; i < run.plan.layer_count; ++i) {
    const Layer& layer = run.plan.layers[i];
    if (run.scratch.load[i]) {
      load_rows(run, layer.out, whole_mesh(run, layer.out.buffer, static_cast<int>(i), layer.out.offset), count);
    }
    if (run.plan.stage[i] != stage) continue;
    if (layer.kind == LayerKind::kRingMean || layer.kind == LayerKind::kRingMax) {
      run_ring(run, i, count);
    } else if (uses_table(layer.kind)) {
      run_table(run, i, count);
    } else {
      run_local(run, i, count);
    }
    if (run.plan.stored[i]) {
      store_rows(run, layer.out, run.storage + static_cast<size_t>(run.plan.store_offset[i]) * run.sizes.vertices,
                 count);
    }
    if (i + 1 == run.plan.layer_count) store_rows(run, layer.out, run.logits, count);
  }
}

bool has_part_layer(const NetworkPlan& plan, uint32_t stage) {
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    if (plan.stage[i] == stage && plan.layers[i].kind == LayerKind::kPartMean) return true;
  }
  return false;
}

// One walk over all vertices: part by part when a layer wants part means, so that one part's table is enough; else in
// order. Returns false when the caller cancelled.
bool run_stage(Run& run, uint32_t stage, const Progress& progress) {
  const bool by_part = has_part_layer(run.plan, stage);
  const uint32_t groups = by_part ? run.input.component_count : 1;
  uint64_t done = static_cast<uint64_t>(stage) * run.sizes.vertices;
  const uint64_t all = static_cast<uint64_t>(run.plan.stage_count) * run.sizes.vertices;
  make_tables(run, stage, true, nullptr, 0);
  for (uint32_t group = 0; group < groups; ++group) {
    const uint32_t begin = by_part ? run.input.component_offsets[group] : 0;
    const uint32_t end = by_part ? run.input.component_offsets[group + 1] : run.sizes.vertices;
    if (begin == end) continue;
    if (by_part) make_tables(run, stage, false, run.input.component_vertices + begin, end - begin);
    for (uint32_t first = begin; first < end; first += run.sizes.tile) {
      const uint32_t count = end - first < run.sizes.tile ? end - first : run.sizes.tile;
      if (!progress.report(static_cast<uint32_t>(done * 1000 / all))) return false;
      for (uint32_t i = 0; i < count; ++i) {
        run.scratch.vertices[i] = by_part ? run.input.component_vertices[first + i] : first + i;
      }
      run_tile(run, stage, count);
      done += count;
    }
  }
  return true;
}

}  // namespace

sinew_status run_network(const sinew_model& model, const NetworkInput& input, const Progress& progress, Arena& arena,
                         int16_t* logits, const NetworkOptions& options) {
  Kernels kernels;
  if (!select_kernels(options.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  if (wants_packed(options) && kernels.linear_packed != nullptr) kernels.linear = kernels.linear_packed;
  NetworkPlan plan;
  make_plan(model, input.candidate_count, &plan);
  const ModelTables tables(model.bytes);
  const size_t start = arena.mark();
  PackedLayers packed;
  (void)packed.allocate(plan, tables, options, arena);
  Run run = {plan,    input,  tables, kernels, packed, {input.vertex_count, input.joint_count, options.tile_vertices},
             nullptr, logits, {}};
  run.storage = allocate_storage(plan, run.sizes, arena);
  sinew_status status = arena.ok() ? SINEW_OK : SINEW_ERROR_WORKSPACE;
  if (status == SINEW_OK) packed.fill(plan, tables, kernels.linear_packed != nullptr);
  for (uint32_t stage = 0; stage < plan.stage_count && status == SINEW_OK; ++stage) {
    const size_t stage_start = arena.mark();
    if (!allocate_stage(plan, stage, run.sizes, arena, &run.scratch)) {
      status = SINEW_ERROR_WORKSPACE;
    } else if (!run_stage(run, stage, progress)) {
      status = SINEW_ERROR_CANCELLED;
    }
    arena.release(stage_start);
  }
  arena.release(start);
  return status;
}

void measure_run_network(Arena& arena, const sinew_model& model, const Counts& counts, const NetworkOptions& options) {
  NetworkPlan plan;
  make_plan(model, counts.candidates, &plan);
  const Sizes sizes = {counts.vertices, counts.joints, options.tile_vertices};
  const size_t start = arena.mark();
  PackedLayers packed;
  (void)packed.allocate(plan, ModelTables(model.bytes), options, arena);
  allocate_storage(plan, sizes, arena);
  for (uint32_t stage = 0; stage < plan.stage_count; ++stage) {
    StageScratch scratch;
    const size_t stage_start = arena.mark();
    allocate_stage(plan, stage, sizes, arena, &scratch);
    arena.release(stage_start);
  }
  arena.release(start);
}

}  // namespace sinew
