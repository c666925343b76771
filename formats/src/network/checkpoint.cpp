// SPDX-License-Identifier: MIT
// The checkpoint file (formats/spec/checkpoint.md): a header that proves the file whole, then a cereal portable binary
// archive.
#include "sinew_formats/checkpoint.hpp"

#include <array>
#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {

// One function per struct, used for both directions; the order of the fields is the file format.
template <class Archive>
void serialize(Archive& archive, Region& region) {
  archive(region.buffer, region.offset, region.channels);
}
template <class Archive>
void serialize(Archive& archive, Layer& layer) {
  archive(layer.kind, layer.flags, layer.in, layer.out, layer.residual, layer.parameters);
}
template <class Archive>
void serialize(Archive& archive, Buffer& buffer) {
  archive(buffer.domain, buffer.channels);
}
template <class Archive>
void serialize(Archive& archive, LinearParameters& parameters) {
  archive(parameters.in, parameters.out, parameters.weights, parameters.bias);
}
template <class Archive>
void serialize(Archive& archive, FloatNetwork& network) {
  archive(network.architecture, network.feature_set, network.candidate_count, network.grid_size, network.buffers,
          network.layers, network.parameters);
}
template <class Archive>
void serialize(Archive& archive, TrainingState& state) {
  archive(state.step, state.seconds, state.averages, state.adam_m, state.adam_v, state.rng, state.queue,
          state.best_score, state.config_json, state.log_csv);
}
template <class Archive>
void serialize(Archive& archive, Checkpoint& checkpoint) {
  archive(checkpoint.network, checkpoint.latest, checkpoint.state);
}

namespace {

constexpr char kMagic[8] = {'S', 'I', 'N', 'E', 'W', 'C', 'K', 'P'};
constexpr uint32_t kVersion = 1;
constexpr size_t kHeaderBytes = 24;  // magic, version u32, CRC-32 u32, payload bytes u64; all little-endian

uint32_t crc32(const uint8_t* bytes, size_t size) {
  static const std::array<uint32_t, 256> table = [] {
    std::array<uint32_t, 256> made{};
    for (uint32_t i = 0; i < 256; ++i) {
      uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = (c >> 1) ^ ((c & 1) != 0 ? 0xedb88320u : 0u);
      made[i] = c;
    }
    return made;
  }();
  uint32_t crc = 0xffffffffu;
  for (size_t i = 0; i < size; ++i) crc = (crc >> 8) ^ table[(crc ^ bytes[i]) & 0xff];
  return ~crc;
}

void put(uint64_t value, size_t byte_count, uint8_t* to) {
  for (size_t i = 0; i < byte_count; ++i) to[i] = static_cast<uint8_t>(value >> (8 * i));
}

uint64_t get(const uint8_t* from, size_t byte_count) {
  uint64_t value = 0;
  for (size_t i = 0; i < byte_count; ++i) value |= static_cast<uint64_t>(from[i]) << (8 * i);
  return value;
}

// What cereal cannot know: that the numbers of a network fit together. Users index by them without looking again.
void check_network(const std::string& path, const char* which, const FloatNetwork& network) {
  const auto fail = [&](const std::string& what) {
    throw Error(path + ": damaged checkpoint, " + which + " network: " + what);
  };
  for (size_t i = 0; i < network.buffers.size(); ++i)
    if (network.buffers[i].domain > Domain::kPair) fail("buffer " + std::to_string(i) + " has an unknown domain");
  for (size_t i = 0; i < network.layers.size(); ++i) {
    const Layer& layer = network.layers[i];
    const std::string name = "layer " + std::to_string(i);
    if (layer.kind < LayerKind::kLinear || layer.kind > LayerKind::kCopy) fail(name + " is of an unknown kind");
    const bool has_residual = layer.kind == LayerKind::kLinear && (layer.flags & kLayerResidual) != 0;
    for (const Region* region : {&layer.in, &layer.out, has_residual ? &layer.residual : &layer.out})
      if (region->buffer >= network.buffers.size() ||
          region->offset + region->channels > network.buffers[region->buffer].channels)
        fail(name + " reaches outside of its buffers");
    if (layer.kind == LayerKind::kLinear && layer.parameters >= network.parameters.size())
      fail(name + " has no weights");
  }
  for (size_t i = 0; i < network.parameters.size(); ++i) {
    const LinearParameters& block = network.parameters[i];
    if (block.weights.size() != static_cast<size_t>(block.in) * block.out || block.bias.size() != block.out)
      fail("weight block " + std::to_string(i) + " is not " + std::to_string(block.out) + " x " +
           std::to_string(block.in));
  }
}

}  // namespace

Checkpoint read_checkpoint(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  if (bytes.size() < sizeof kMagic || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
    throw Error(path + ": expected a sinew checkpoint, found a file that does not begin with SINEWCKP");
  if (bytes.size() < kHeaderBytes)
    throw Error(path + ": truncated checkpoint, expected " + std::to_string(kHeaderBytes) + " bytes of header, found " +
                std::to_string(bytes.size()));
  const uint64_t version = get(bytes.data() + 8, 4), length = get(bytes.data() + 16, 8);
  if (version != kVersion)
    throw Error(path + ": expected checkpoint version " + std::to_string(kVersion) + ", found " +
                std::to_string(version));
  const size_t payload_bytes = bytes.size() - kHeaderBytes;
  if (length != payload_bytes)
    throw Error(path + ": truncated checkpoint, expected " + std::to_string(length) +
                " bytes after the header, found " + std::to_string(payload_bytes));
  if (get(bytes.data() + 12, 4) != crc32(bytes.data() + kHeaderBytes, payload_bytes))
    throw Error(path + ": damaged checkpoint, the checksum does not match");

  Checkpoint checkpoint;
  try {
    std::istringstream stream(std::string(bytes.begin() + kHeaderBytes, bytes.end()));
    cereal::PortableBinaryInputArchive archive(stream);
    archive(checkpoint);
    if (stream.peek() != std::istringstream::traits_type::eof()) throw Error("bytes left over");
  } catch (const std::exception& problem) {
    throw Error(path + ": damaged checkpoint, " + one_line(problem.what()));
  }
  check_network(path, "evaluated", checkpoint.network);
  check_network(path, "latest", checkpoint.latest);
  for (const FloatNetwork& average : checkpoint.state.averages) check_network(path, "averaged", average);
  return checkpoint;
}

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  std::ostringstream stream;
  {
    // Little-endian on every host, so that the same training gives the same file.
    cereal::PortableBinaryOutputArchive archive(stream, cereal::PortableBinaryOutputArchive::Options::LittleEndian());
    archive(checkpoint);
  }
  const std::string payload = stream.str();
  std::vector<uint8_t> bytes(kHeaderBytes + payload.size());
  std::memcpy(bytes.data(), kMagic, sizeof kMagic);
  std::memcpy(bytes.data() + kHeaderBytes, payload.data(), payload.size());
  put(kVersion, 4, bytes.data() + 8);
  put(crc32(bytes.data() + kHeaderBytes, payload.size()), 4, bytes.data() + 12);
  put(payload.size(), 8, bytes.data() + 16);
  write_file(path, bytes);
}

bool is_checkpoint(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return false;
  char magic[sizeof kMagic] = {};
  const bool whole = std::fread(magic, 1, sizeof magic, file) == sizeof magic;
  std::fclose(file);
  return whole && std::memcmp(magic, kMagic, sizeof kMagic) == 0;
}

}  // namespace sinew
