// SPDX-License-Identifier: MIT
// Compressed glTF made plain before it is read: EXT_meshopt_compression (and its KHR name) through meshoptimizer,
// KHR_draco_mesh_compression through Draco, where the build has them.
#ifndef SINEW_FORMATS_GLTF_GLTF_DECOMPRESS_HPP
#define SINEW_FORMATS_GLTF_GLTF_DECOMPRESS_HPP

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sinew {

// A document being made plain. Buffer views that are decoded, or made anew, have their bytes in `views`.
struct CompressedGltf {
  std::string path;
  nlohmann::json document;
  std::vector<std::vector<uint8_t>> buffers;
  std::vector<std::optional<std::vector<uint8_t>>> views;  // [bufferViews], nullopt = as the buffer has it
  size_t packed_bytes = 0, plain_bytes = 0;                // of what was decoded
};

// Bytes of a buffer view or of a view-like extension {buffer, byteOffset, byteLength}. Throws Error when they reach
// outside of the buffer.
struct ByteRange {
  const uint8_t* first = nullptr;
  size_t size = 0;
};
ByteRange bytes_of(const CompressedGltf& gltf, const std::string& where, const nlohmann::json& view);

// The same file as a plain GLB, with a remark for the user in `notes`; nullopt when nothing in it is compressed.
// Throws Error for broken data, and for a compression that this build cannot read.
std::optional<std::vector<uint8_t>> decompress_gltf(const std::string& path, const std::vector<uint8_t>& file,
                                                    std::vector<std::string>* notes);

// Each decodes what its extension `name` holds and takes the extension out of views or primitives.
void decode_meshopt(const std::string& name, CompressedGltf* gltf);
void decode_draco(CompressedGltf* gltf);

}  // namespace sinew
#endif
