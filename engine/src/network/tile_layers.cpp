// SPDX-License-Identifier: MIT
// The arithmetic of every kind of layer over one tile, with the kernels that the caller chose.
#include "network/tile_layers.hpp"

namespace sinew::network {
namespace {

RowsRead rows_read(const Tile& tile, uint32_t index) {
  return kHasPackedWeights && tile.shared ? tile.run.packed.rows_read[index] : RowsRead::kAll;
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

// Layers of neighbors: rows of neighbors come from storage, whatever tile they belong to.
void run_ring(const Tile& tile, uint32_t index) {
  const Run& run = tile.run;
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates, slots = slots_of(run, layer.out);
  const bool mean = layer.kind == LayerKind::kRingMean, far = !kSmallCode && (layer.flags & kLayerFar) != 0;
  const uint32_t* const offsets = far ? run.input.far_offsets : run.input.row_offsets;
  const uint32_t* const neighbors_of = far ? run.input.far_indices : run.input.col_indices;
  for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
    const Segment segment = segment_at(run.plan.layers, run.plan.input_count, index, layer.in, channel);
    const RowsView values = whole_mesh(run, layer.in.buffer, segment.producer, channel);
    for (uint32_t row = 0; row < tile.count * slots; ++row) {
      const uint32_t vertex = tile.vertices()[row / slots];
      const uint32_t* ring = neighbors_of + offsets[vertex];
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
        const uint32_t neighbors = joint == kNoJoint ? 0 : valence;  // an absent slot has none
        if (mean) {
          run.kernels.ring_mean_pair(values, segment.count, run.input.joints, k, joint, ring, neighbors, out);
        } else {
          run.kernels.ring_max_pair(values, segment.count, run.input.joints, k, joint, ring, neighbors, out);
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
  const bool by_joint = pair && by_part(layer.kind);
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

void run_candidate_max(const Tile& tile, uint32_t index) {
  const Run& run = tile.run;
  const Layer& layer = run.plan.layers[index];
  const uint32_t k = run.plan.candidates, out_stride = run.plan.buffers[layer.out.buffer].channels;
  const int part_mean = table_of_maximum(run.plan, index);
  const uint32_t out_slots = rows_read(tile, index) == RowsRead::kAll ? k : 1;
  for (uint32_t i = 0; i < tile.count; ++i) {
    const size_t row = static_cast<size_t>(i) * k;
    RowsView values = {tile_row(tile, layer.in, row), run.plan.buffers[layer.in.buffer].channels};
    if (part_mean >= 0) {
      values = {table_of(run, static_cast<uint32_t>(part_mean), tile.table_lane), layer.in.channels};
    }
    run.kernels.candidate_max(values, part_mean >= 0, layer.in.channels, tile.joints() + row, k,
                              tile_row(tile, layer.out, row), out_stride, out_slots);
  }
}

// Hands the slots of a vertex its values: all of them, or to each slot its own ones.
void run_to_slots(const Tile& tile, uint32_t index, bool own_values) {
  const Layer& layer = tile.run.plan.layers[index];
  const uint32_t k = tile.run.plan.candidates;
  const uint32_t step = own_values || rows_read(tile, index) == RowsRead::kAll ? 1 : k;
  for (uint32_t row = 0; row < tile.count * k; row += step) {
    int16_t* out = tile_row(tile, layer.out, row);
    if (tile.joints()[row] == kNoJoint) {
      memset(out, 0, layer.out.channels * sizeof(int16_t));
    } else {
      const uint32_t first = own_values ? (row % k) * layer.out.channels : 0;
      copy_values(out, tile_row(tile, layer.in, row / k) + first, layer.out.channels);
    }
  }
}

// Absent slots are 0 already.
void run_pair_to_vertex(const Tile& tile, uint32_t index) {
  const Layer& layer = tile.run.plan.layers[index];
  const uint32_t k = tile.run.plan.candidates;
  for (uint32_t row = 0; row < tile.count * k; ++row) {
    copy_values(tile_row(tile, layer.out, row / k) + (row % k) * layer.in.channels, tile_row(tile, layer.in, row),
                layer.in.channels);
  }
}

void run_copy(const Tile& tile, uint32_t index) {
  const Layer& layer = tile.run.plan.layers[index];
  for (uint32_t row = 0; row < tile.count * slots_of(tile.run, layer.out); ++row) {
    copy_values(tile_row(tile, layer.out, row), tile_row(tile, layer.in, row), layer.out.channels);
  }
}

}  // namespace

void run_layer(const Tile& tile, uint32_t index) {
  switch (tile.run.plan.layers[index].kind) {
    case LayerKind::kLinear:
      return run_linear(tile, index);
    case LayerKind::kRingMean:
    case LayerKind::kRingMax:
      return run_ring(tile, index);
    case LayerKind::kPartMean:
    case LayerKind::kGlobalMean:
    case LayerKind::kGlobalMax:
      return run_table(tile, index);
    case LayerKind::kCandidateMax:
      return run_candidate_max(tile, index);
    case LayerKind::kVertexToPair:
      return run_to_slots(tile, index, false);
    case LayerKind::kPairToVertex:
      return run_pair_to_vertex(tile, index);
    case LayerKind::kVertexToSlots:
      return run_to_slots(tile, index, true);
    case LayerKind::kCopy:
      return run_copy(tile, index);
  }
}

}  // namespace sinew::network
