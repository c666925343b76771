// SPDX-License-Identifier: MIT
// EXT_meshopt_compression: buffer views decoded by meshoptimizer. Its decoders read no further than their input, but
// assert on sizes, so these are checked first.
#ifdef SINEW_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include "gltf/gltf_decompress.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {

#ifdef SINEW_HAS_MESHOPT

namespace {

using Json = nlohmann::json;

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
