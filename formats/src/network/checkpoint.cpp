// SPDX-License-Identifier: MIT
// The checkpoint file (formats/spec/checkpoint.md): a header that proves the file whole, then a cereal portable binary
// archive.
#include "sinew_formats/checkpoint.hpp"

#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "core/bytes.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr char kMagic[8] = {'S', 'I', 'N', 'E', 'W', 'C', 'K', 'P'};
constexpr uint32_t kVersion = 2, kOldestVersion = 1;
constexpr size_t kCheckpointHeader = 24;  // magic, version u32, CRC-32 u32, payload bytes u64; all little-endian

uint32_t version_of(cereal::PortableBinaryOutputArchive&) { return kVersion; }
// cereal hands every struct the archive that it began with, so the version travels in it.
struct InputArchive : cereal::PortableBinaryInputArchive {
  InputArchive(std::istream& stream, uint32_t file_version)
      : cereal::PortableBinaryInputArchive(stream), version(file_version) {}
  const uint32_t version;
};
uint32_t version_of(cereal::PortableBinaryInputArchive& archive) {
  return static_cast<const InputArchive&>(archive).version;
}

}  // namespace

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
// Version 1 knew bind alone.
template <class Archive>
void serialize(Archive& archive, FloatNetwork& network) {
  if (version_of(archive) >= 2) archive(network.task, network.input_names);
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

Checkpoint read_checkpoint(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  if (bytes.size() < sizeof kMagic || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
    throw Error(path + ": expected a sinew checkpoint, found a file that does not begin with SINEWCKP");
  if (bytes.size() < kCheckpointHeader)
    throw Error(path + ": truncated checkpoint, expected " + std::to_string(kCheckpointHeader) +
                " bytes of header, found " + std::to_string(bytes.size()));
  const uint32_t version = load_u32(bytes.data() + 8);
  const uint64_t length = load_u64(bytes.data() + 16);
  if (version < kOldestVersion || version > kVersion)
    throw Error(path + ": expected checkpoint version " + std::to_string(kOldestVersion) + " to " +
                std::to_string(kVersion) + ", found " + std::to_string(version));
  const size_t payload_bytes = bytes.size() - kCheckpointHeader;
  if (length != payload_bytes)
    throw Error(path + ": truncated checkpoint, expected " + std::to_string(length) +
                " bytes after the header, found " + std::to_string(payload_bytes));
  if (load_u32(bytes.data() + 12) != crc32(0, bytes.data() + kCheckpointHeader, payload_bytes))
    throw Error(path + ": damaged checkpoint, the checksum does not match");

  Checkpoint checkpoint;
  try {
    std::istringstream stream(std::string(bytes.begin() + kCheckpointHeader, bytes.end()));
    InputArchive archive(stream, version);
    static_cast<cereal::PortableBinaryInputArchive&>(archive)(checkpoint);
    if (stream.peek() != std::istringstream::traits_type::eof()) throw Error("bytes left over");
  } catch (const std::exception& problem) {
    throw Error(path + ": damaged checkpoint, " + one_line(problem.what()));
  }
  check_network(checkpoint.network, path + ": evaluated network");
  // A released checkpoint has nothing to go on from.
  if (!checkpoint.latest.buffers.empty()) check_network(checkpoint.latest, path + ": latest network");
  for (const FloatNetwork& average : checkpoint.state.averages) check_network(average, path + ": averaged network");
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
  std::vector<uint8_t> bytes(kCheckpointHeader + payload.size());
  std::memcpy(bytes.data(), kMagic, sizeof kMagic);
  std::memcpy(bytes.data() + kCheckpointHeader, payload.data(), payload.size());
  store_u32(bytes.data() + 8, kVersion);
  store_u32(bytes.data() + 12, crc32(0, bytes.data() + kCheckpointHeader, payload.size()));
  store_u64(bytes.data() + 16, payload.size());
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
