// SPDX-License-Identifier: MIT
// Files of samples that are kept from one run to the next: whole or not there.
#ifndef SINEW_TRAINER_DATA_CACHE_FILE_HPP
#define SINEW_TRAINER_DATA_CACHE_FILE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace sinew {

uint64_t hash_bytes(const uint8_t* data, size_t size, uint64_t seed);

// 32 hexadecimal digits of everything that a file depends on.
std::string cache_key(const uint8_t* data, size_t size, uint64_t settings);

// Reads the contents written by write_cache_file(); nullopt when the file is missing or damaged. Nothing is parsed
// before its hash fits, so a damaged length cannot do harm.
//   version  of the payload's layout
std::optional<std::string> read_cache_file(const std::string& path, uint64_t version);
void write_cache_file(const std::string& path, uint64_t version, const std::string& payload);

}  // namespace sinew
#endif
