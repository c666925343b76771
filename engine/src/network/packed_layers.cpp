// SPDX-License-Identifier: MIT
// Where packed parameters lie, and what rows share.
#include "network/packed_layers.hpp"

#include "core/build.hpp"
#include "model/regions.hpp"

namespace sinew {
namespace {

// True for rows of the stage's own table of part means: of one writer, the whole table's width.
bool same_in_joint(const NetworkPlan& plan, uint32_t reader, const Segment& segment) {
  if (segment.producer < 0) return false;
  const Layer& layer = plan.layers[segment.producer];
  return by_part(layer.kind) && plan.stage[segment.producer] == plan.stage[reader] &&
         segment.count == layer.out.channels &&
         segment_at(plan.layers, plan.input_count, static_cast<uint32_t>(segment.producer), layer.in, layer.in.offset)
                 .count == segment.count;
}

// Adds columns [first, first + count) behind the last range, or to it. False when there is no room.
bool add_range(uint32_t first, uint32_t count, uint32_t most, ColumnRange* ranges, uint8_t* range_count) {
  if (*range_count > 0) {
    ColumnRange& last = ranges[*range_count - 1];
    if (last.first + last.count == first) {
      last.count = static_cast<uint16_t>(last.count + count);
      return true;
    }
  }
  if (*range_count == most) return false;
  ranges[*range_count].first = static_cast<uint16_t>(first);
  ranges[*range_count].count = static_cast<uint16_t>(count);
  ++*range_count;
  return true;
}

// Where each linear layer's packed parameters lie behind the first one's. Returns the bytes of all.
uint64_t packed_offsets(const NetworkPlan& plan, const ModelTables& tables, size_t* offsets) {
  uint64_t bytes = 0;
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    offsets[i] = checked(bytes);
    if (!has_weights(plan.layers[i].kind)) continue;
    const LinearRecord record = tables.linear(plan.layers[i].parameters);
    bytes += packed_linear_bytes(record.in, record.out, record.block);
  }
  return bytes;
}

void pack_layers(const NetworkPlan& plan, const ModelTables& tables, const size_t* offsets, uint8_t* memory) {
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    if (has_weights(plan.layers[i].kind)) pack_linear(make_linear_view(tables, plan.layers[i]), memory + offsets[i]);
  }
}

// columns: null = no layer has shared ones.
RowsRead find_rows_read(const NetworkPlan& plan, const SharedColumns* columns, uint32_t index) {
  const Layer& layer = plan.layers[index];
  if (plan.stored[index] || !has_slots(plan.buffers[layer.out.buffer].domain)) return RowsRead::kAll;
  RowsRead rows = RowsRead::kNone;
  for (uint32_t i = index + 1; i < plan.layer_count; ++i) {
    const Layer& reader = plan.layers[i];
    if ((reader.flags & kLayerResidual) != 0 && regions_overlap(reader.residual, layer.out)) return RowsRead::kAll;
    if (!regions_overlap(reader.in, layer.out) || table_of_maximum(plan, i) == static_cast<int>(index)) continue;
    if (!has_weights(reader.kind) || columns == nullptr || !columns[i].any()) return RowsRead::kAll;
    if (columns[i].by_joint.count > 0 && columns[i].part_mean == index) continue;
    if (!traits_of(layer.kind).same_in_all_slots) return RowsRead::kAll;
    rows = RowsRead::kFirstOfVertex;
  }
  return index + 1 == plan.layer_count ? RowsRead::kAll : rows;
}

}  // namespace

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

bool wants_packed(const NetworkOptions& options) { return kHasPackedWeights && !options.weights_in_place; }

SharedColumns find_shared_columns(const NetworkPlan& plan, uint32_t index, const LinearRecord& record) {
  const Layer& layer = plan.layers[index];
  SharedColumns columns;
  if (!has_slots(plan.buffers[layer.in.buffer].domain) || record.accumulator != AccumulatorClass::kNarrow) {
    return SharedColumns();
  }
  for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
    const Segment segment = segment_at(plan.layers, plan.input_count, index, layer.in, channel);
    const uint32_t first = channel - layer.in.offset;
    const bool shared = segment.producer >= 0 && traits_of(plan.layers[segment.producer].kind).same_in_all_slots;
    // Ranges start at whole pairs of columns, and so must what follows them.
    if (first % 2 != 0) return SharedColumns();
    if (columns.by_joint.count == 0 && same_in_joint(plan, index, segment)) {
      columns.by_joint = {static_cast<uint16_t>(first), static_cast<uint16_t>(segment.count)};
      columns.part_mean = static_cast<uint16_t>(segment.producer);
    } else if (!add_range(first, segment.count, shared ? kMaxRanges - 1 : kMaxRanges,
                          shared ? columns.shared : columns.own, shared ? &columns.shared_count : &columns.own_count)) {
      return SharedColumns();
    }
    channel += segment.count;
  }
  return columns;
}

int table_of_maximum(const NetworkPlan& plan, uint32_t index) {
  const Layer& layer = plan.layers[index];
  if (!kHasPackedWeights || layer.kind != LayerKind::kCandidateMax) return -1;
  const Segment segment = segment_at(plan.layers, plan.input_count, index, layer.in, layer.in.offset);
  return segment.count == layer.in.channels && same_in_joint(plan, index, segment) ? segment.producer : -1;
}

bool PackedLayers::allocate(const sinew_model& model, const NetworkPlan& plan, const ModelTables& tables,
                            const NetworkOptions& options, uint32_t lanes, Arena& arena) {
  if (!wants_packed(options)) return true;
  const uint64_t bytes = packed_offsets(plan, tables, offsets);
  memory = static_cast<const uint8_t*>(model.packed);
  if (memory == nullptr) memory = own = arena.alloc<uint8_t>(checked(bytes));
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    if (!has_weights(plan.layers[i].kind)) continue;
    const LinearRecord record = tables.linear(plan.layers[i].parameters);
    const SharedColumns shared = find_shared_columns(plan, i, record);
    has_shared = has_shared || shared.any();
    if (shared.shared_count > 0 && padded_outputs(record.out) > outputs) outputs = padded_outputs(record.out);
  }
  columns = arena.alloc<SharedColumns>(has_shared ? plan.layer_count : 0);
  starts = arena.alloc<int32_t>(checked(static_cast<uint64_t>(options.tile_vertices) * lanes * outputs));
  return arena.ok();
}

void PackedLayers::fill(const NetworkPlan& plan, const ModelTables& tables, bool wanted) {
  if (!wanted) memory = nullptr;
  has_shared = has_shared && wanted;
  if (memory == nullptr) return;
  if (own != nullptr) pack_layers(plan, tables, offsets, own);
  for (uint32_t i = 0; i < plan.layer_count && has_shared; ++i) {
    if (has_weights(plan.layers[i].kind))
      columns[i] = find_shared_columns(plan, i, tables.linear(plan.layers[i].parameters));
  }
  for (uint32_t i = 0; i < plan.layer_count; ++i)
    rows_read[i] = find_rows_read(plan, has_shared ? columns : nullptr, i);
}

size_t packed_bytes(const sinew_model& model) {
  if (!kHasPackedWeights) return 0;
  NetworkPlan plan;
  make_plan(model, model.candidate_count, &plan);
  size_t offsets[kMaxLayers];
  return checked(packed_offsets(plan, ModelTables(model.bytes), offsets));
}

void pack_model(const sinew_model& model, uint8_t* memory) {
  if (!kHasPackedWeights) return;
  NetworkPlan plan;
  make_plan(model, model.candidate_count, &plan);
  const ModelTables tables(model.bytes);
  size_t offsets[kMaxLayers];
  (void)packed_offsets(plan, tables, offsets);
  pack_layers(plan, tables, offsets, memory);
}

}  // namespace sinew
