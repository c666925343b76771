// SPDX-License-Identifier: MIT
// Compressed geometry made plain: which extensions there are, and meshoptimizer's; Draco's is in gltf_draco.cpp.
#include "gltf/gltf_decompress.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/print.hpp"
#include "text/text_lines.hpp"

#ifdef SINEW_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

namespace sinew {
namespace {

constexpr std::array<const char*, 3> kCompressions = {"EXT_meshopt_compression", "KHR_meshopt_compression",
                                                      "KHR_draco_mesh_compression"};

// The extensions of kCompressions in `list` go out of it.
void remove_from(Json* document, const char* list, const std::string& name) {
  if (!document->contains(list)) return;
  Json kept = Json::array();
  for (const Json& used : (*document)[list])
    if (used != name) kept.push_back(used);
  if (kept.empty())
    document->erase(list);
  else
    (*document)[list] = std::move(kept);
}

// All bytes that a view names into one buffer; what was compressed, or stood in for it, is left behind.
std::vector<uint8_t> gather(CompressedGltf* gltf) {
  std::vector<uint8_t> bytes;
  std::map<std::array<size_t, 3>, size_t> known;  // buffer, offset, length: views that show the same bytes
  Json& views = gltf->document["bufferViews"];
  for (size_t i = 0; i < views.size(); ++i) {
    Json& view = views[i];
    const ByteRange from = gltf->views[i] ? ByteRange{gltf->views[i]->data(), gltf->views[i]->size()}
                                          : bytes_of(*gltf, gltf->path + ": buffer view " + std::to_string(i), view);
    if (bytes.size() + from.size > UINT32_MAX - (size_t{1} << 20))
      throw Error(gltf->path + ": expected less than 4 GiB of geometry once decompressed, found more");
    const size_t buffer = gltf->views[i] ? SIZE_MAX - i : view.at("buffer").get<size_t>();
    const auto [at, is_new] = known.try_emplace({buffer, view.value("byteOffset", size_t{0}), from.size}, 0);
    if (is_new) {
      bytes.resize((bytes.size() + 7) / 8 * 8);
      at->second = bytes.size();
      bytes.insert(bytes.end(), from.first, from.first + from.size);
    }
    view["buffer"] = 0;
    view["byteOffset"] = at->second;
    view["byteLength"] = from.size;
  }
  gltf->document["buffers"] = Json::array({Json::object()});
  return bytes;
}

}  // namespace

ByteRange bytes_of(const CompressedGltf& gltf, const std::string& where, const Json& view) {
  const size_t buffer = view.at("buffer").get<size_t>();
  const size_t offset = view.value("byteOffset", size_t{0}), length = view.at("byteLength").get<size_t>();
  if (buffer >= gltf.buffers.size())
    throw Error(where + ": expected a buffer below " + std::to_string(gltf.buffers.size()) + ", found " +
                std::to_string(buffer));
  const std::vector<uint8_t>& bytes = gltf.buffers[buffer];
  if (offset > bytes.size() || length > bytes.size() - offset)
    throw Error(where + ": expected bytes inside of buffer " + std::to_string(buffer) + " of " +
                std::to_string(bytes.size()) + " bytes, found " + std::to_string(offset) + " + " +
                std::to_string(length));
  return {bytes.data() + offset, length};
}

std::optional<std::vector<uint8_t>> decompress_gltf(const std::string& path, const std::vector<uint8_t>& file,
                                                    std::vector<std::string>* notes) {
  const std::string_view text = gltf_text(file);
  const auto named = [&](const char* name) { return text.find(name) != std::string_view::npos; };
  if (std::none_of(kCompressions.begin(), kCompressions.end(), named)) return std::nullopt;
  CompressedGltf gltf;
  gltf.path = path;
  gltf.document = Json::parse(text.begin(), text.end(), nullptr, false);
  if (!gltf.document.is_object()) return std::nullopt;  // the loader reports the error
  try {
    std::string found;
    for (const char* name : kCompressions) {
      const Json used = gltf.document.value("extensionsUsed", Json::array());
      if (std::find(used.begin(), used.end(), name) == used.end()) continue;
      if (found.empty()) {
        gltf.buffers = load_buffers(path, file, gltf.document);
        if (!gltf.document.contains("bufferViews")) gltf.document["bufferViews"] = Json::array();
        gltf.views.resize(gltf.document["bufferViews"].size());
      }
      remove_from(&gltf.document, "extensionsUsed", name);
      remove_from(&gltf.document, "extensionsRequired", name);
      if (name == std::string("KHR_draco_mesh_compression"))
        decode_draco(&gltf);
      else
        decode_meshopt(name, &gltf);
      found.append(found.empty() ? "" : " and ").append(name);
    }
    if (found.empty()) return std::nullopt;
    std::vector<uint8_t> bytes = gather(&gltf);
    notes->push_back(
        print("%s: decompressed; a glTF output is written uncompressed, %.0f kB of geometry instead of %.0f kB (%.1f "
              "times as much)",
              found.c_str(), static_cast<double>(gltf.plain_bytes) / 1e3, static_cast<double>(gltf.packed_bytes) / 1e3,
              static_cast<double>(gltf.plain_bytes) / static_cast<double>(std::max<size_t>(1, gltf.packed_bytes))));
    return pack_glb(path, &gltf.document, std::move(bytes));
  } catch (const nlohmann::json::exception& error) {
    throw Error(path + ": expected the fields of compressed glTF, found others: " + one_line(error.what()));
  } catch (const std::bad_alloc&) {
    throw OutOfMemory(path + ": expected compressed geometry that fits into memory, found more");
  }
}

// EXT_meshopt_compression: buffer views decoded by meshoptimizer. Its decoders read no further than their input, but
// assert on sizes, so these are checked first.

#ifdef SINEW_HAS_MESHOPT

namespace {

[[noreturn]] void fail(const std::string& where, const std::string& expected, const std::string& found) {
  throw Error(where + ": expected " + expected + ", found " + found);
}

void apply_filter(const std::string& where, const std::string& filter, size_t count, size_t stride,
                  std::vector<uint8_t>* bytes) {
  if (filter == "NONE") return;
  if (filter == "OCTAHEDRAL") {
    if (stride != 4 && stride != 8) fail(where, "a byteStride of 4 or 8 with " + filter, std::to_string(stride));
    meshopt_decodeFilterOct(bytes->data(), count, stride);
  } else if (filter == "QUATERNION") {
    if (stride != 8) fail(where, "a byteStride of 8 with " + filter, std::to_string(stride));
    meshopt_decodeFilterQuat(bytes->data(), count, stride);
  } else if (filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(bytes->data(), count, stride);  // strides of attributes are multiples of 4
  } else {
    fail(where, "the filter NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL", in_quotes(filter));
  }
}

std::vector<uint8_t> decode_view(const std::string& where, const Json& extension, ByteRange packed) {
  const size_t count = extension.at("count").get<size_t>(), stride = extension.at("byteStride").get<size_t>();
  const std::string mode = extension.at("mode").get<std::string>(), filter = extension.value("filter", "NONE");
  const bool attributes = mode == "ATTRIBUTES", triangles = mode == "TRIANGLES";
  if (!attributes && !triangles && mode != "INDICES")
    fail(where, "the mode ATTRIBUTES, TRIANGLES or INDICES", in_quotes(mode));
  if (attributes && (stride == 0 || stride > 256 || stride % 4 != 0))
    fail(where, "a byteStride of 4, 8, ... or 256", std::to_string(stride));
  if (!attributes && stride != 2 && stride != 4)
    fail(where, "a byteStride of 2 or 4 for indices", std::to_string(stride));
  if (triangles && count % 3 != 0) fail(where, "indices in threes", std::to_string(count));
  // No encoder packs further: a byte codes 64 bytes of vertices, or a triangle. Saves memory from a count out of thin
  // air.
  constexpr size_t kMostPacked = 128;
  if (count == 0 || count > UINT32_MAX || count > (packed.size * kMostPacked + 4096) / stride)
    fail(where, "a count of elements that " + std::to_string(packed.size) + " bytes can hold", std::to_string(count));
  std::vector<uint8_t> bytes(count * stride);
  const int status = attributes  ? meshopt_decodeVertexBuffer(bytes.data(), count, stride, packed.first, packed.size)
                     : triangles ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, packed.first, packed.size)
                                 : meshopt_decodeIndexSequence(bytes.data(), count, stride, packed.first, packed.size);
  if (status == -1)
    fail(where, "data of a version that meshoptimizer " + std::to_string(MESHOPTIMIZER_VERSION) + " knows",
         "another version, or no such data; decode the file first (gltf-transform copy)");
  if (status != 0) fail(where, mode + " that decode to " + std::to_string(count) + " elements", "broken data");
  if (attributes)
    apply_filter(where, filter, count, stride, &bytes);
  else if (filter != "NONE")
    fail(where, "no filter for " + mode, in_quotes(filter));
  return bytes;
}

// Checks that belong to the view around the packed data.
std::vector<uint8_t> decode_view_of(const std::string& where, const Json& view, const Json& extension,
                                    ByteRange packed) {
  if (view.contains("byteStride") && view["byteStride"] != extension.at("byteStride"))
    fail(where, "the byteStride of its view, " + view["byteStride"].dump(), extension["byteStride"].dump());
  return decode_view(where, extension, packed);
}

}  // namespace

#endif

void decode_meshopt(const std::string& name, CompressedGltf* gltf) {
  nlohmann::json& views = gltf->document["bufferViews"];
  for (size_t i = 0; i < views.size(); ++i) {
    if (!views[i].contains("extensions") || !views[i]["extensions"].contains(name)) continue;
    const std::string where = gltf->path + ": buffer view " + std::to_string(i) + ", " + name;
    const nlohmann::json extension = views[i]["extensions"][name];
    views[i]["extensions"].erase(name);
    if (views[i]["extensions"].empty()) views[i].erase("extensions");
#ifdef SINEW_HAS_MESHOPT
    const ByteRange packed = bytes_of(*gltf, where, extension);
    gltf->views[i] = decode_view_of(where, views[i], extension, packed);
    gltf->packed_bytes += packed.size;
    gltf->plain_bytes += gltf->views[i]->size();
#else
    // The same bytes may lie there plain, for readers like this one.
    const size_t buffer = views[i].at("buffer").get<size_t>();
    if (buffer < gltf->buffers.size() && !gltf->buffers[buffer].empty()) continue;
    throw Error(where +
                ": cannot read, this sinew was built without meshoptimizer; install libmeshoptimizer-dev and build "
                "again, or decode the file first (gltf-transform copy)");
#endif
  }
}

}  // namespace sinew
