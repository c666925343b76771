// SPDX-License-Identifier: MIT
// Lays the tables and parameter blocks of a model file one behind the other; the last step of quantizing.
#include "sinew_quant/model_writer.hpp"

#include <algorithm>
#include <cstddef>

namespace sinew {
namespace {

LinearRecord make_record(const IntegerLinear& linear, uint64_t* offset) {
  LinearRecord record;
  record.in = linear.in;
  record.out = linear.out;
  record.accumulator = linear.accumulator;
  record.range = linear.range;
  record.block = linear.block;
  record.bias = static_cast<uint32_t>(*offset);
  *offset += bias_bytes(record);
  record.weights = static_cast<uint32_t>(*offset);
  *offset += weight_bytes(record);
  if (!linear.residual.empty()) {
    record.residual = static_cast<uint32_t>(*offset);
    *offset += residual_bytes(record);
  }
  record.shifts = static_cast<uint32_t>(*offset);
  *offset += shift_bytes(record);
  return record;
}

void put_record(uint8_t* row, const LinearRecord& record) {
  store_u16(row, record.in);
  store_u16(row + 2, record.out);
  row[4] = static_cast<uint8_t>(record.accumulator);
  row[5] = static_cast<uint8_t>(record.range);
  store_u16(row + 6, record.block);
  store_u32(row + 8, record.bias);
  store_u32(row + 12, record.weights);
  store_u32(row + 16, record.residual);
  store_u32(row + 20, record.shifts);
}

void put_int16(uint8_t* at, const std::vector<int16_t>& values) {
  for (size_t i = 0; i < values.size(); ++i) store_u16(at + 2 * i, static_cast<uint16_t>(values[i]));
}

}  // namespace

void seal_model(std::vector<uint8_t>* bytes) {
  store_u32(bytes->data() + kHeaderChecksum, model_checksum(bytes->data(), bytes->size()));
}

std::vector<uint8_t> write_model(const IntegerModel& model) {
  uint64_t size = tables_bytes(static_cast<uint32_t>(model.buffers.size()), static_cast<uint32_t>(model.layers.size()),
                               static_cast<uint32_t>(model.linears.size()));
  std::vector<LinearRecord> records;
  for (const IntegerLinear& linear : model.linears) records.push_back(make_record(linear, &size));

  std::vector<uint8_t> bytes(size, 0);
  uint8_t* header = bytes.data();
  std::copy(std::begin(kModelMagic), std::end(kModelMagic), header);
  store_u32(header + kHeaderFormat, kModelFormat);
  store_u64(header + kHeaderSize, size);
  store_u32(header + kHeaderCandidates, model.candidate_count);
  store_u32(header + kHeaderGrid, model.grid_size);
  store_u32(header + kHeaderFeatureSet, model.feature_set);
  store_u32(header + kHeaderBuffers, static_cast<uint32_t>(model.buffers.size()));
  store_u32(header + kHeaderLayers, static_cast<uint32_t>(model.layers.size()));
  store_u32(header + kHeaderLinears, static_cast<uint32_t>(model.linears.size()));

  store_u32(header + kHeaderTask, model.task);
  store_u32(header + kHeaderInputs, static_cast<uint32_t>(model.input_names.size()));

  uint8_t* row = header + kHeaderBytes;
  for (size_t i = 0; i < model.buffers.size(); ++i, row += kBufferBytes) {
    row[0] = static_cast<uint8_t>(model.buffers[i].domain);
    store_u16(row + 2, model.buffers[i].channels);
    if (i < model.input_names.size()) store_u32(row + 4, model.input_names[i]);
  }
  for (const Layer& layer : model.layers) {
    row[0] = static_cast<uint8_t>(layer.kind);
    row[1] = layer.flags;
    store_region(row + 4, layer.in);
    store_region(row + 10, layer.out);
    store_region(row + 16, layer.residual);
    store_u32(row + 24, layer.parameters);
    row += kLayerBytes;
  }
  for (size_t i = 0; i < records.size(); ++i) {
    const IntegerLinear& linear = model.linears[i];
    put_record(row, records[i]);
    row += kLinearBytes;
    for (size_t n = 0; n < linear.bias.size(); ++n) {
      store_u64(header + records[i].bias + 8 * n, static_cast<uint64_t>(linear.bias[n]));
    }
    put_int16(header + records[i].weights, linear.weights);
    if (!linear.residual.empty()) put_int16(header + records[i].residual, linear.residual);
    std::copy(linear.shifts.begin(), linear.shifts.end(), header + records[i].shifts);
  }
  seal_model(&bytes);
  return bytes;
}

std::vector<uint8_t> with_second_network(std::vector<uint8_t> first, const std::vector<uint8_t>& second) {
  const size_t end = first.size();
  first.resize(end + kSecondHeader, 0);
  first.insert(first.end(), second.begin(), second.end());
  store_u32(first.data() + end, kSecondTag);
  store_u32(first.data() + end + 4, static_cast<uint32_t>(first.size() - end));
  store_u64(first.data() + kHeaderSize, first.size());
  seal_model(&first);
  return first;
}

std::vector<uint8_t> write_confidence(const std::vector<uint8_t>& model, size_t parameters_end,
                                      const std::vector<ConfidenceEntry>& entries) {
  std::vector<uint8_t> bytes(model.begin(), model.begin() + static_cast<std::ptrdiff_t>(parameters_end));
  if (!entries.empty()) {
    const uint32_t count = static_cast<uint32_t>(entries.size());
    bytes.resize(parameters_end + confidence_bytes(count), 0);
    uint8_t* section = bytes.data() + parameters_end;
    store_u32(section, kConfidenceTag);
    store_u32(section + 4, static_cast<uint32_t>(confidence_bytes(count)));
    store_u32(section + 8, count);
    for (size_t i = 0; i < count; ++i) {
      store_u16(section + kConfidenceHeader + 4 * i, entries[i].share);
      store_u16(section + kConfidenceHeader + 4 * i + 2, entries[i].hits);
    }
  }
  store_u64(bytes.data() + kHeaderSize, bytes.size());
  seal_model(&bytes);
  return bytes;
}

}  // namespace sinew
