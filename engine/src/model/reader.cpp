// SPDX-License-Identifier: MIT
// Opens a model file in place: header, tables, layer order, accumulator proofs. Runs once, before stage 8 can.
#include "model/reader.hpp"

#include "features/features.hpp"
#include "model/layout.hpp"
#include "model/regions.hpp"

namespace sinew {
namespace {

bool all_zero(const uint8_t* bytes, uint64_t count) {
  for (uint64_t i = 0; i < count; ++i) {
    if (bytes[i] != 0) return false;
  }
  return true;
}

bool is_zero(const Region& region) { return region.buffer == 0 && region.offset == 0 && region.channels == 0; }

// The decoded layer list while it is checked, about 5 KB of stack.
struct LayerList {
  Layer layers[kMaxLayers];
  ValueRange ranges[kMaxLayers];
  Buffer buffers[kMaxBuffers];
  uint32_t buffer_count = 0;
  uint32_t candidates = 0;
  uint32_t vertex_channels = 0;
};

sinew_status check_header(const uint8_t* bytes, size_t size_bytes) {
  if (size_bytes < kHeaderBytes) return SINEW_ERROR_MODEL_TRUNCATED;
  for (size_t i = 0; i < sizeof(kModelMagic); ++i) {
    if (bytes[i] != kModelMagic[i]) return SINEW_ERROR_MODEL_MAGIC;
  }
  if (load_u32(bytes + kHeaderFormat) != kModelFormat) return SINEW_ERROR_MODEL_VERSION;
  if (load_u64(bytes + kHeaderSize) != size_bytes) return SINEW_ERROR_MODEL_TRUNCATED;
  if (load_u32(bytes + kHeaderChecksum) != model_checksum(bytes, size_bytes)) return SINEW_ERROR_MODEL_CHECKSUM;
  if ((load_u32(bytes + kHeaderFeatureSet) & ~kFeatureFlags) != kFeatureSet) return SINEW_ERROR_MODEL_VERSION;

  const uint32_t k = load_u32(bytes + kHeaderCandidates), grid = load_u32(bytes + kHeaderGrid);
  const uint32_t buffers = load_u32(bytes + kHeaderBuffers), layers = load_u32(bytes + kHeaderLayers);
  const uint32_t linears = load_u32(bytes + kHeaderLinears);
  const bool legal = k >= 1 && k <= SINEW_MAX_CANDIDATES && grid >= 16 && grid <= 128 && buffers >= 3 &&
                     buffers <= kMaxBuffers && layers >= 1 && layers <= kMaxLayers && linears <= layers &&
                     all_zero(bytes + kHeaderReserved, kHeaderBytes - kHeaderReserved) &&
                     tables_bytes(buffers, layers, linears) <= size_bytes;
  return legal ? SINEW_OK : SINEW_ERROR_MODEL_LAYOUT;
}

sinew_status read_buffers(const ModelTables& tables, LayerList* list) {
  list->buffer_count = tables.buffer_count();
  for (uint32_t i = 0; i < tables.buffer_count(); ++i) {
    const uint8_t* row = tables.buffer_row(i);
    const Buffer buffer = tables.buffer(i);
    if (row[0] > static_cast<uint8_t>(Domain::kPair) || row[1] != 0 || load_u32(row + 4) != 0 || buffer.channels == 0 ||
        buffer.channels > kMaxChannels) {
      return SINEW_ERROR_MODEL_LAYOUT;
    }
    list->buffers[i] = buffer;
  }
  if (list->buffers[kVertexInput].domain != Domain::kVertex || list->buffers[kPairInput].domain != Domain::kPair) {
    return SINEW_ERROR_MODEL_LAYOUT;
  }
  const bool same_inputs = list->buffers[kVertexInput].channels == list->vertex_channels &&
                           list->buffers[kPairInput].channels == kPairFeatures;
  return same_inputs ? SINEW_OK : SINEW_ERROR_MODEL_VERSION;
}

bool inside(const LayerList& list, const Region& region) {
  return region.buffer < list.buffer_count && region.channels > 0 &&
         region_end(region) <= list.buffers[region.buffer].channels;
}

// All channels of the region are inputs or were written by a layer before `before`.
bool written(const LayerList& list, uint32_t before, const Region& region) {
  for (uint32_t channel = region.offset; channel < region_end(region);) {
    const Segment segment = segment_at(list.layers, before, region, channel);
    if (segment.producer == kNotWritten) return false;
    channel += segment.count;
  }
  return true;
}

// The regions are known to lie inside their buffers.
bool legal_shape(const LayerList& list, const Layer& layer) {
  return layer_fits(layer.kind, list.buffers[layer.in.buffer].domain, list.buffers[layer.out.buffer].domain,
                    layer.in.channels, layer.out.channels, list.candidates);
}

// One linear layer's record: consistent with its layer, data where the canonical order puts it (*offset moves behind
// it).
sinew_status check_linear_record(const ModelTables& tables, const Layer& layer, size_t size_bytes, uint64_t* offset) {
  const uint8_t* row = tables.linear_row(layer.parameters);
  const LinearRecord record = tables.linear(layer.parameters);
  const bool relu = (layer.flags & kLayerRelu) != 0, residual = (layer.flags & kLayerResidual) != 0;
  const bool wide = record.accumulator == AccumulatorClass::kWide;
  bool legal = record.in == layer.in.channels && record.out == layer.out.channels &&
               row[4] <= static_cast<uint8_t>(AccumulatorClass::kWide) &&
               row[5] <= static_cast<uint8_t>(ValueRange::kLogits) && relu == (record.range == ValueRange::kPositive) &&
               record.block >= 1 && record.block <= record.in && (wide || record.block == record.in) &&
               load_u64(row + 24) == 0;
  legal = legal && record.bias == *offset;
  *offset += bias_bytes(record);
  legal = legal && record.weights == *offset;
  *offset += weight_bytes(record);
  legal = legal && record.residual == (residual ? *offset : 0);
  if (residual) *offset += residual_bytes(record);
  legal = legal && record.shifts == *offset;
  *offset += shift_bytes(record);
  if (!legal || *offset > size_bytes) return SINEW_ERROR_MODEL_LAYOUT;

  const uint64_t weights = static_cast<uint64_t>(record.in) * record.out;
  const uint8_t* bytes = tables.bytes();
  if (!all_zero(bytes + record.weights + 2 * weights, weight_bytes(record) - 2 * weights) ||
      (residual && !all_zero(bytes + record.residual + 2u * record.out, residual_bytes(record) - 2u * record.out)) ||
      !all_zero(bytes + record.shifts + record.out, shift_bytes(record) - record.out)) {
    return SINEW_ERROR_MODEL_LAYOUT;
  }
  const uint32_t max_shift = wide ? kMaxShiftWide : kMaxShiftNarrow;
  for (uint32_t n = 0; n < record.out; ++n) {
    if (bytes[record.shifts + n] < 1 || bytes[record.shifts + n] > max_shift) return SINEW_ERROR_MODEL_LAYOUT;
    // -32768 is no weight: kernels may rely on |w| <= 32767.
    for (uint32_t k = 0; k < record.in; ++k) {
      if (file_int16(tables.int16_at(record.weights), static_cast<size_t>(n) * record.in + k) == INT16_MIN) {
        return SINEW_ERROR_MODEL_LAYOUT;
      }
    }
    if (residual && file_int16(tables.int16_at(record.residual), n) == INT16_MIN) return SINEW_ERROR_MODEL_LAYOUT;
  }
  return SINEW_OK;
}

// The accumulator of every output channel stays inside its type for every possible input. Class N: bias + all products
// in int32. Class W: every block of products in int32, the whole below 2^62.
bool proven(const ModelTables& tables, const LayerList& list, uint32_t layer_index) {
  const Layer& layer = list.layers[layer_index];
  const LinearRecord record = tables.linear(layer.parameters);
  const bool wide = record.accumulator == AccumulatorClass::kWide;
  const int16_t* weights = tables.int16_at(record.weights);
  for (uint32_t n = 0; n < record.out; ++n) {
    const int64_t bias = load_i64(tables.bytes() + record.bias + 8u * n);
    if (bias <= -kWideLimit || bias >= kWideLimit) return false;  // keeps the sums below inside int64
    SumBound total, block;
    uint32_t in_block = 0;
    for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
      const Segment segment = segment_at(list.layers, layer_index, layer.in, channel);
      const ValueRange range = segment.producer >= 0 ? list.ranges[segment.producer] : ValueRange::kSigned;
      for (uint32_t c = 0; c < segment.count; ++c, ++channel) {
        const size_t column = channel - layer.in.offset;
        block.add(file_int16(weights, static_cast<size_t>(n) * record.in + column), range);
        if (++in_block == record.block || column + 1 == record.in) {
          if (wide && !block.below(kNarrowLimit)) return false;
          total.add(block);
          block = SumBound();
          in_block = 0;
        }
      }
    }
    if ((layer.flags & kLayerResidual) != 0) {
      // The residual's channels may come from several writers; the widest of them is asked.
      total.add(file_int16(tables.int16_at(record.residual), n),
                region_range(list.layers, layer_index, list.ranges, layer.residual));
    }
    total.low += bias;
    total.high += bias;
    if (!total.below(wide ? kWideLimit : kNarrowLimit)) return false;
  }
  return true;
}

sinew_status check_layer(const ModelTables& tables, uint32_t index, size_t size_bytes, LayerList* list,
                         uint32_t* linear_index, uint64_t* offset) {
  const uint8_t* row = tables.layer_row(index);
  const Layer& layer = list->layers[index] = tables.layer(index);
  const bool linear = layer.kind == LayerKind::kLinear;
  const bool residual = (layer.flags & kLayerResidual) != 0;
  if (load_u16(row + 2) != 0 || load_u16(row + 22) != 0 || load_u32(row + 28) != 0) return SINEW_ERROR_MODEL_LAYOUT;
  if (!inside(*list, layer.in) || !inside(*list, layer.out) || !legal_shape(*list, layer))
    return SINEW_ERROR_MODEL_LAYOUT;
  if (layer.flags != 0 && (!linear || (layer.flags & ~(kLayerRelu | kLayerResidual)) != 0))
    return SINEW_ERROR_MODEL_LAYOUT;
  if (layer.parameters != (linear ? *linear_index : 0)) return SINEW_ERROR_MODEL_LAYOUT;

  // Order: inputs are never written, nothing is written twice, everything is written before it is read.
  if (layer.out.buffer == kVertexInput || layer.out.buffer == kPairInput) return SINEW_ERROR_MODEL_LAYOUT;
  for (uint32_t i = 0; i < index; ++i) {
    if (regions_overlap(list->layers[i].out, layer.out)) return SINEW_ERROR_MODEL_LAYOUT;
  }
  if (!written(*list, index, layer.in)) return SINEW_ERROR_MODEL_LAYOUT;
  if (residual) {
    if (!inside(*list, layer.residual) || layer.residual.channels != layer.out.channels ||
        list->buffers[layer.residual.buffer].domain != list->buffers[layer.out.buffer].domain ||
        !written(*list, index, layer.residual)) {
      return SINEW_ERROR_MODEL_LAYOUT;
    }
  } else if (!is_zero(layer.residual)) {
    return SINEW_ERROR_MODEL_LAYOUT;
  }

  if (!linear) {
    list->ranges[index] = region_range(list->layers, index, list->ranges, layer.in);
    return SINEW_OK;
  }
  if (*linear_index >= tables.linear_count()) return SINEW_ERROR_MODEL_LAYOUT;
  const sinew_status status = check_linear_record(tables, layer, size_bytes, offset);
  if (status != SINEW_OK) return status;
  list->ranges[index] = tables.linear(layer.parameters).range;
  ++*linear_index;
  return proven(tables, *list, index) ? SINEW_OK : SINEW_ERROR_MODEL_OVERFLOW;
}

// The section at `offset`, which must reach to the end of the file.
bool legal_confidence(const uint8_t* bytes, uint64_t offset, size_t size_bytes) {
  const uint64_t rest = size_bytes - offset;
  const uint8_t* section = bytes + offset;
  if (rest < kConfidenceHeader || load_u32(section) != kConfidenceTag) return false;
  const uint32_t count = load_u32(section + 8);
  if (count < kMinConfidenceEntries || count > kMaxConfidenceEntries || load_u32(section + 12) != 0) return false;
  if (confidence_bytes(count) != rest || load_u32(section + 4) != rest) return false;
  const uint8_t* entry = section + kConfidenceHeader;
  for (uint32_t i = 1; i < count; ++i) {
    if (load_u16(entry + 4 * i) <= load_u16(entry + 4 * (i - 1))) return false;
    if (load_u16(entry + 4 * i + 2) < load_u16(entry + 4 * (i - 1) + 2)) return false;
  }
  return all_zero(entry + 4 * count, rest - kConfidenceHeader - 4 * count);
}

}  // namespace

sinew_status open_model(const void* data, size_t size_bytes, sinew_model* model) {
  if (reinterpret_cast<uintptr_t>(data) % 8 != 0) return SINEW_ERROR_MODEL_ALIGNMENT;
  const uint8_t* bytes = static_cast<const uint8_t*>(data);
  sinew_status status = check_header(bytes, size_bytes);
  if (status != SINEW_OK) return status;

  const ModelTables tables(bytes);
  LayerList list;
  list.candidates = load_u32(bytes + kHeaderCandidates);
  list.vertex_channels = vertex_channels(load_u32(bytes + kHeaderFeatureSet));
  status = read_buffers(tables, &list);
  if (status != SINEW_OK) return status;

  uint64_t offset = tables_bytes(tables.buffer_count(), tables.layer_count(), tables.linear_count());
  uint32_t linear_index = 0, parameter_count = 0;
  for (uint32_t i = 0; i < tables.layer_count(); ++i) {
    status = check_layer(tables, i, size_bytes, &list, &linear_index, &offset);
    if (status != SINEW_OK) return status;
  }
  if (linear_index != tables.linear_count()) return SINEW_ERROR_MODEL_LAYOUT;
  const bool has_confidence = offset < size_bytes;
  if (has_confidence && !legal_confidence(bytes, offset, size_bytes)) return SINEW_ERROR_MODEL_LAYOUT;

  // The last layer gives one Q10 logit per pair.
  const uint32_t last = tables.layer_count() - 1;
  const Layer& output = list.layers[last];
  const bool logits = (output.kind == LayerKind::kLinear || output.kind == LayerKind::kVertexToSlots) &&
                      list.buffers[output.out.buffer].domain == Domain::kPair && output.out.channels == 1 &&
                      list.ranges[last] == ValueRange::kLogits;
  if (!logits) return SINEW_ERROR_MODEL_LAYOUT;

  for (uint32_t i = 0; i < tables.linear_count(); ++i) {
    const LinearRecord record = tables.linear(i);
    parameter_count += static_cast<uint32_t>(record.out) * (static_cast<uint32_t>(record.in) + 1);
  }
  *model = {};
  model->bytes = bytes;
  model->size_bytes = size_bytes;
  model->format_version = kModelFormat;
  model->candidate_count = list.candidates;
  model->grid_size = load_u32(bytes + kHeaderGrid);
  model->feature_set = load_u32(bytes + kHeaderFeatureSet);
  for (uint32_t i = 0; i < tables.layer_count(); ++i) {
    const LayerKind kind = list.layers[i].kind;
    if (kind == LayerKind::kPairToVertex || kind == LayerKind::kVertexToSlots) model->fixed_candidates = 1;
  }
  model->layer_count = tables.layer_count();
  model->parameter_count = parameter_count;
  model->checksum = load_u32(bytes + kHeaderChecksum);
  model->confidence_offset = has_confidence ? static_cast<uint32_t>(offset + kConfidenceHeader) : 0;
  model->confidence_count = has_confidence ? load_u32(bytes + offset + 8) : 0;
  return SINEW_OK;
}

}  // namespace sinew
