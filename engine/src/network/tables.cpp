// SPDX-License-Identifier: MIT
// Means and maxima over parts and over the mesh, on one lane or shared by all of them.
#include "network/run.hpp"

namespace sinew::network {
namespace {

// Some channels of a table and where they come from.
struct TablePiece {
  const Layer& layer;
  RowsView values;  // their first channel
  uint32_t channels;
  int16_t* table;   // their index in the first row
  uint32_t stride;  // between rows of the table
};

constexpr uint32_t kPieceChannels = 16;

// Calls visit(piece) for the tables of the stage's global layers, or of its part layers. Segments of at least two times
// kPieceChannels are cut where that is asked for. A region of several writers gives one table behind the other.
template <class Visit>
void each_table_piece(const Run& run, uint32_t stage, bool global, uint32_t table_lane, bool cut, Visit visit) {
  for (uint32_t i = 0; i < run.plan.layer_count; ++i) {
    const Layer& layer = run.plan.layers[i];
    if (run.plan.stage[i] != stage || !uses_table(layer.kind) || by_part(layer.kind) == global) continue;
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

}  // namespace

void make_tables(const Run& run, uint32_t stage, bool global, const uint32_t* vertices, uint32_t count, uint32_t lane) {
  each_table_piece(run, stage, global, lane, false,
                   [&](const TablePiece& piece) { make_table_piece(run, piece, vertices, count, lane); });
}

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

}  // namespace sinew::network
