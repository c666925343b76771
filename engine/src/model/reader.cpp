// SPDX-License-Identifier: MIT
// Opens a model file in place: header, tables, layer order, accumulator proofs. Runs once, before stage 8 can.
#include "model/reader.hpp"

#include "core/counts.hpp"
#include "model/layer_list.hpp"
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

// The decoded tables while they are checked, about 5 KB of stack.
struct DecodedTables {
  Layer layers[kMaxLayers];
  ValueRange ranges[kMaxLayers];
  Buffer buffers[kMaxBuffers];
  LayerList list;
};

sinew_status check_counts(const uint8_t* bytes, size_t size_bytes, const ModelTask& task) {
  const uint32_t k = load_u32(bytes + kHeaderCandidates), grid = load_u32(bytes + kHeaderGrid);
  const uint32_t buffers = load_u32(bytes + kHeaderBuffers), layers = load_u32(bytes + kHeaderLayers);
  const uint32_t linears = load_u32(bytes + kHeaderLinears), inputs = load_u32(bytes + kHeaderInputs);
  const bool legal = k >= 1 && k <= SINEW_MAX_CANDIDATES && is_legal_grid(grid) && buffers > task.input_count &&
                     buffers <= kMaxBuffers && layers >= 1 && layers <= kMaxLayers && linears <= layers &&
                     inputs <= kMaxInputs && all_zero(bytes + kHeaderReserved, kHeaderBytes - kHeaderReserved) &&
                     tables_bytes(buffers, layers, linears) <= size_bytes;
  if (!legal) return SINEW_ERROR_MODEL_LAYOUT;
  return inputs == 0 || inputs == task.input_count ? SINEW_OK : SINEW_ERROR_MODEL_VERSION;
}

sinew_status read_buffers(const ModelTables& tables, const ModelTask& task, DecodedTables* decoded) {
  const bool named = tables.input_count() != 0;
  bool same_inputs = true;
  for (uint32_t i = 0; i < tables.buffer_count(); ++i) {
    const uint8_t* row = tables.buffer_row(i);
    const bool input = i < task.input_count;
    if (row[0] >= kDomains || row[1] != 0 || (tables.buffer_name(i) != 0 && !(named && input)))
      return SINEW_ERROR_MODEL_LAYOUT;
    const Buffer buffer = tables.buffer(i);
    if (buffer.channels == 0 || buffer.channels > kMaxChannels) return SINEW_ERROR_MODEL_LAYOUT;
    // A network runs over vertices or over joints.
    if (without_slots(buffer.domain) != without_slots(task.output.domain)) return SINEW_ERROR_MODEL_LAYOUT;
    if (input) {
      const TaskInput& wanted = task.inputs[i];
      if (buffer.domain != wanted.buffer.domain) return SINEW_ERROR_MODEL_LAYOUT;
      same_inputs =
          same_inputs && buffer.channels == wanted.buffer.channels && (!named || tables.buffer_name(i) == wanted.name);
    }
    decoded->buffers[i] = buffer;
  }
  return same_inputs ? SINEW_OK : SINEW_ERROR_MODEL_VERSION;
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
bool proven(const ModelTables& tables, const DecodedTables& decoded, uint32_t layer_index) {
  const uint32_t inputs = decoded.list.input_count;
  const Layer& layer = decoded.layers[layer_index];
  const LinearRecord record = tables.linear(layer.parameters);
  const bool wide = record.accumulator == AccumulatorClass::kWide;
  const int16_t* weights = tables.int16_at(record.weights);
  for (uint32_t n = 0; n < record.out; ++n) {
    const int64_t bias = load_i64(tables.bytes() + record.bias + 8u * n);
    if (bias <= -kWideLimit || bias >= kWideLimit) return false;  // keeps the sums below inside int64
    SumBound total, block;
    uint32_t in_block = 0;
    for (uint32_t channel = layer.in.offset; channel < region_end(layer.in);) {
      const Segment segment = segment_at(decoded.layers, inputs, layer_index, layer.in, channel);
      const ValueRange range = segment.producer >= 0 ? decoded.ranges[segment.producer] : ValueRange::kSigned;
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
                region_range(decoded.layers, inputs, layer_index, decoded.ranges, layer.residual));
    }
    total.low += bias;
    total.high += bias;
    if (!total.below(wide ? kWideLimit : kNarrowLimit)) return false;
  }
  return true;
}

sinew_status check_layer(const ModelTables& tables, uint32_t index, size_t size_bytes, DecodedTables* decoded,
                         uint32_t* linear_index, uint64_t* offset) {
  const uint8_t* row = tables.layer_row(index);
  const Layer& layer = decoded->layers[index] = tables.layer(index);
  if (load_u16(row + 2) != 0 || load_u16(row + 22) != 0 || load_u32(row + 28) != 0) return SINEW_ERROR_MODEL_LAYOUT;
  if (find_layer_fault(decoded->list, index) != LayerFault::kNone) return SINEW_ERROR_MODEL_LAYOUT;
  const bool linear = has_weights(layer.kind);
  if (layer.parameters != (linear ? *linear_index : 0)) return SINEW_ERROR_MODEL_LAYOUT;
  if ((layer.flags & kLayerResidual) == 0 && !is_zero(layer.residual)) return SINEW_ERROR_MODEL_LAYOUT;

  if (!linear) {
    decoded->ranges[index] = region_range(decoded->layers, decoded->list.input_count, index, decoded->ranges, layer.in);
    return SINEW_OK;
  }
  if (*linear_index >= tables.linear_count()) return SINEW_ERROR_MODEL_LAYOUT;
  const sinew_status status = check_linear_record(tables, layer, size_bytes, offset);
  if (status != SINEW_OK) return status;
  decoded->ranges[index] = tables.linear(layer.parameters).range;
  ++*linear_index;
  return proven(tables, *decoded, index) ? SINEW_OK : SINEW_ERROR_MODEL_OVERFLOW;
}

// Where the parameters of a file end whose records are legal: what follows is a section, if anything.
uint64_t parameters_end(const ModelTables& tables) {
  if (tables.linear_count() == 0)
    return tables_bytes(tables.buffer_count(), tables.layer_count(), tables.linear_count());
  const LinearRecord last = tables.linear(tables.linear_count() - 1);
  return last.shifts + shift_bytes(last);
}

bool has_second(const uint8_t* bytes, uint64_t offset, size_t size_bytes) {
  return size_bytes - offset > kSecondHeader && load_u32(bytes + offset) == kSecondTag;
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

bool legal_second(const uint8_t* bytes, uint64_t offset, size_t size_bytes) {
  const uint8_t* const section = bytes + offset;
  return load_u32(section + 4) == size_bytes - offset && all_zero(section + 8, kSecondHeader - 8);
}

}  // namespace

sinew_status read_header(const void* data, size_t size_bytes, ModelHeader* header) {
  if (reinterpret_cast<uintptr_t>(data) % 8 != 0) return SINEW_ERROR_MODEL_ALIGNMENT;
  const uint8_t* bytes = static_cast<const uint8_t*>(data);
  if (size_bytes < kHeaderBytes) return SINEW_ERROR_MODEL_TRUNCATED;
  for (size_t i = 0; i < sizeof(kModelMagic); ++i) {
    if (bytes[i] != kModelMagic[i]) return SINEW_ERROR_MODEL_MAGIC;
  }
  if (load_u32(bytes + kHeaderFormat) != kModelFormat) return SINEW_ERROR_MODEL_VERSION;
  if (load_u64(bytes + kHeaderSize) != size_bytes) return SINEW_ERROR_MODEL_TRUNCATED;
  if (load_u32(bytes + kHeaderChecksum) != model_checksum(bytes, size_bytes)) return SINEW_ERROR_MODEL_CHECKSUM;
  header->task = load_u32(bytes + kHeaderTask);
  header->feature_set = load_u32(bytes + kHeaderFeatureSet);
  return SINEW_OK;
}

sinew_status open_model(const void* data, size_t size_bytes, const ModelTask& task, sinew_model* model,
                        bool with_second) {
  const uint8_t* bytes = static_cast<const uint8_t*>(data);
  sinew_status status = check_counts(bytes, size_bytes, task);
  if (status != SINEW_OK) return status;
  const ModelTables tables(bytes);
  DecodedTables decoded;
  LayerList& list = decoded.list;
  list = {
      decoded.buffers,   decoded.layers, tables.buffer_count(), task.input_count, load_u32(bytes + kHeaderCandidates),
      task.far_neighbors};
  status = read_buffers(tables, task, &decoded);
  if (status != SINEW_OK) return status;

  uint64_t offset = tables_bytes(tables.buffer_count(), tables.layer_count(), tables.linear_count());
  uint32_t linear_index = 0;
  for (uint32_t i = 0; i < tables.layer_count(); ++i) {
    status = check_layer(tables, i, size_bytes, &decoded, &linear_index, &offset);
    if (status != SINEW_OK) return status;
  }
  if (linear_index != tables.linear_count()) return SINEW_ERROR_MODEL_LAYOUT;
  if (offset < size_bytes) {
    const bool second = kHasExtras && with_second && has_second(bytes, offset, size_bytes);
    if (!(second ? legal_second(bytes, offset, size_bytes) : legal_confidence(bytes, offset, size_bytes)))
      return SINEW_ERROR_MODEL_LAYOUT;
  }

  const uint32_t last = tables.layer_count() - 1;
  if (!traits_of(decoded.layers[last].kind).ends_network || !writes_output(list, last, task.output) ||
      decoded.ranges[last] != ValueRange::kLogits) {
    return SINEW_ERROR_MODEL_LAYOUT;
  }

  *model = proven_model(bytes, size_bytes, task);
  return SINEW_OK;
}

sinew_model proven_model(const uint8_t* bytes, size_t size_bytes, const ModelTask& task) {
  const ModelTables tables(bytes);
  sinew_model model = {};
  model.bytes = bytes;
  model.size_bytes = size_bytes;
  model.format_version = kModelFormat;
  model.candidate_count = load_u32(bytes + kHeaderCandidates);
  model.grid_size = load_u32(bytes + kHeaderGrid);
  model.feature_set = load_u32(bytes + kHeaderFeatureSet);
  for (uint32_t i = 0; i < tables.layer_count(); ++i)
    if (fixes_candidates(tables.layer(i).kind)) model.fixed_candidates = 1;
  model.layer_count = tables.layer_count();
  for (uint32_t i = 0; i < tables.linear_count(); ++i) {
    const LinearRecord record = tables.linear(i);
    model.parameter_count += static_cast<uint32_t>(record.out) * (static_cast<uint32_t>(record.in) + 1);
  }
  model.checksum = load_u32(bytes + kHeaderChecksum);
  const uint64_t end = parameters_end(tables);
  if (end < size_bytes && !has_second(bytes, end, size_bytes)) {
    model.confidence_offset = static_cast<uint32_t>(end + kConfidenceHeader);
    model.confidence_count = load_u32(bytes + end + 8);
  }
  model.task = task.id;
  model.input_count = task.input_count;
  return model;
}

size_t second_network(const sinew_model& model) {
  const uint64_t end = parameters_end(ModelTables(model.bytes));
  return has_second(model.bytes, end, model.size_bytes) ? static_cast<size_t>(end + kSecondHeader) : 0;
}

}  // namespace sinew
