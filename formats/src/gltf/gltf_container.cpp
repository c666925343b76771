// SPDX-License-Identifier: MIT
// GLB and .gltf taken apart and put together; accessors added to a document.
#include "gltf/gltf_container.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

bool is_glb(const std::vector<uint8_t>& file) { return file.size() >= 20 && std::memcmp(file.data(), "glTF", 4) == 0; }

// The chunk behind the JSON; empty when there is none.
std::vector<uint8_t> binary_chunk(const std::vector<uint8_t>& file) {
  if (!is_glb(file)) return {};
  const size_t text_end = size_t{20} + read_u32(file, 12);
  if (text_end > file.size() || file.size() - text_end < 8) return {};
  const size_t length = std::min<size_t>(read_u32(file, text_end), file.size() - text_end - 8);
  const auto first = file.begin() + static_cast<std::ptrdiff_t>(text_end + 8);
  return {first, first + static_cast<std::ptrdiff_t>(length)};
}

bool is_fallback(const nlohmann::json& buffer) {
  if (!buffer.contains("extensions")) return false;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    if (buffer["extensions"].contains(name) && buffer["extensions"][name].value("fallback", false)) return true;
  return false;
}

}  // namespace

std::string_view gltf_text(const std::vector<uint8_t>& file) {
  const char* first = reinterpret_cast<const char*>(file.data());
  if (!is_glb(file)) return {first, file.size()};
  const size_t length = read_u32(file, 12);
  return length > file.size() - 20 ? std::string_view() : std::string_view(first + 20, length);
}

std::vector<std::vector<uint8_t>> load_buffers(const std::string& path, const std::vector<uint8_t>& file,
                                               const nlohmann::json& document) {
  std::vector<std::vector<uint8_t>> buffers;
  if (!document.contains("buffers")) return buffers;
  for (const nlohmann::json& buffer : document["buffers"]) {
    const std::string where = path + ": buffer " + std::to_string(buffers.size());
    const size_t length = buffer.at("byteLength").get<size_t>();
    std::vector<uint8_t> bytes;
    const std::string uri = buffer.value("uri", std::string());
    if (uri.empty() && is_fallback(buffer)) {
      buffers.emplace_back();
      continue;
    }
    if (uri.empty()) {
      if (!buffers.empty() || !is_glb(file))
        throw Error(where + ": expected a uri, found none; only the first buffer of a GLB may be in the file itself");
      bytes = binary_chunk(file);
    } else if (tinygltf::IsDataURI(uri)) {
      std::string type;
      if (!tinygltf::DecodeDataURI(&bytes, type, uri, 0, false))
        throw Error(where + ": expected a data URI in base64, found another");
    } else {
      bytes = read_file((std::filesystem::path(path).parent_path() / percent_decoded(uri)).string());
    }
    if (bytes.size() < length)
      throw Error(where + ": expected " + std::to_string(length) + " bytes, found " + std::to_string(bytes.size()));
    bytes.resize(length);
    buffers.push_back(std::move(bytes));
  }
  return buffers;
}

std::vector<uint8_t> pack_glb(const std::string& path, nlohmann::json* document, std::vector<uint8_t> bytes) {
  if (document->contains("buffers") && !(*document)["buffers"].empty())
    (*document)["buffers"][0]["byteLength"] = bytes.size();
  std::string text = document->dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  bytes.resize((bytes.size() + 3) / 4 * 4);
  const uint64_t total = 12 + 8 + text.size() + (bytes.empty() ? 0 : 8 + bytes.size());
  if (total > UINT32_MAX)
    throw Error(path + ": cannot write, a GLB holds at most 4 GiB, this one needs " + std::to_string(total) + " bytes");
  std::vector<uint8_t> glb;
  glb.reserve(static_cast<size_t>(total));
  const auto put = [&](size_t value) {
    for (size_t i = 0; i < 4; ++i) glb.push_back(static_cast<uint8_t>(value >> (8 * i)));
  };
  put(0x46546c67);  // "glTF"
  put(2);
  put(static_cast<size_t>(total));
  put(text.size());
  put(0x4e4f534a);  // "JSON"
  glb.insert(glb.end(), text.begin(), text.end());
  if (!bytes.empty()) {
    put(bytes.size());
    put(0x004e4942);  // "BIN"
    glb.insert(glb.end(), bytes.begin(), bytes.end());
  }
  return glb;
}

int add_accessor(GltfSource* source, const void* values, size_t size_bytes, const char* type, int component_type,
                 size_t count, bool vertex_attribute, bool normalized) {
  Json& document = source->document;
  source->bytes.resize((source->bytes.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", source->bytes.size()}, {"byteLength", size_bytes}};
  if (vertex_attribute) view["target"] = TINYGLTF_TARGET_ARRAY_BUFFER;
  const uint8_t* bytes = static_cast<const uint8_t*>(values);
  source->bytes.insert(source->bytes.end(), bytes, bytes + size_bytes);
  document["bufferViews"].push_back(std::move(view));
  Json accessor = {{"bufferView", document["bufferViews"].size() - 1},
                   {"componentType", component_type},
                   {"count", count},
                   {"type", type}};
  if (normalized) accessor["normalized"] = true;
  document["accessors"].push_back(std::move(accessor));
  if (!document.contains("buffers")) document["buffers"] = Json::array({Json::object()});
  return static_cast<int>(document["accessors"].size()) - 1;
}

int add_vectors(GltfSource* source, const std::vector<float>& values, size_t width, bool with_bounds) {
  constexpr const char* kTypes[] = {"VEC2", "VEC3", "VEC4"};
  const int accessor = add_accessor(source, values.data(), values.size() * sizeof(float), kTypes[width - 2],
                                    TINYGLTF_COMPONENT_TYPE_FLOAT, values.size() / width, true, false);
  if (!with_bounds) return accessor;
  std::vector<float> low(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)), high = low;
  for (size_t i = 0; i < values.size(); ++i) {
    low[i % width] = std::min(low[i % width], values[i]);
    high[i % width] = std::max(high[i % width], values[i]);
  }
  source->document["accessors"].back()["min"] = low;
  source->document["accessors"].back()["max"] = high;
  return accessor;
}

int add_key_times(GltfSource* source, const std::vector<float>& times) {
  const int accessor = add_accessor(source, times.data(), times.size() * sizeof(float), "SCALAR",
                                    TINYGLTF_COMPONENT_TYPE_FLOAT, times.size(), false, false);
  source->document["accessors"].back()["min"] = {times.front()};
  source->document["accessors"].back()["max"] = {times.back()};
  return accessor;
}

}  // namespace sinew
