// SPDX-License-Identifier: MIT
#include "data/cache_file.hpp"

#include <cstring>
#include <filesystem>
#include <vector>

#include "core/random.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// Magic, hash of the payload, payload.
constexpr char kMagic[8] = {'S', 'N', 'W', 'S', 'M', 'P', 'L', '1'};
constexpr size_t kHeader = sizeof kMagic + sizeof(uint64_t);

}  // namespace

uint64_t hash_bytes(const uint8_t* data, size_t size, uint64_t seed) {
  uint64_t hash = mix_seeds(seed, size);
  for (size_t i = 0; i + 8 <= size; i += 8) {
    uint64_t word;
    std::memcpy(&word, data + i, 8);
    hash = mix64(hash ^ word) + 0x9E3779B97F4A7C15ull;
  }
  uint64_t tail = 0;
  if (size % 8 != 0) std::memcpy(&tail, data + size - size % 8, size % 8);
  return mix64(hash ^ tail);
}

std::string cache_key(const uint8_t* data, size_t size, uint64_t settings) {
  return print("%016llx%016llx", static_cast<unsigned long long>(hash_bytes(data, size, settings)),
               static_cast<unsigned long long>(hash_bytes(data, size, ~settings)));
}

std::optional<std::string> read_cache_file(const std::string& path, uint64_t version) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const std::vector<uint8_t> bytes = read_file(path);
  if (bytes.size() < kHeader || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0) return std::nullopt;
  uint64_t expected;
  std::memcpy(&expected, bytes.data() + sizeof kMagic, sizeof expected);
  if (hash_bytes(bytes.data() + kHeader, bytes.size() - kHeader, version) != expected) return std::nullopt;
  return std::string(bytes.begin() + kHeader, bytes.end());
}

void write_cache_file(const std::string& path, uint64_t version, const std::string& payload) {
  const uint64_t hash = hash_bytes(reinterpret_cast<const uint8_t*>(payload.data()), payload.size(), version);
  std::vector<uint8_t> bytes(kHeader + payload.size());
  std::memcpy(bytes.data(), kMagic, sizeof kMagic);
  std::memcpy(bytes.data() + sizeof kMagic, &hash, sizeof hash);
  std::memcpy(bytes.data() + kHeader, payload.data(), payload.size());
  write_file(path, bytes);
}

}  // namespace sinew
