// SPDX-License-Identifier: MIT
// KHR_draco_mesh_compression: the vertices and triangles of primitives decoded by Draco into accessors of their own.
#ifdef SINEW_HAS_DRACO
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#include <draco/compression/decode.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#endif

#include <algorithm>
#include <cstring>
#include <set>

#include "gltf/gltf_decompress.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";

}  // namespace

#ifdef SINEW_HAS_DRACO

namespace {

template <class T>
std::vector<uint8_t> values_as(const draco::PointAttribute& attribute, size_t point_count, size_t width) {
  std::vector<T> values(point_count * width);
  for (size_t p = 0; p < point_count; ++p) {
    const draco::AttributeValueIndex at = attribute.mapped_index(draco::PointIndex(static_cast<uint32_t>(p)));
    if (at.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(at, static_cast<int8_t>(width), &values[p * width]))
      throw Error("values that do not convert");
  }
  const uint8_t* first = reinterpret_cast<const uint8_t*>(values.data());
  return {first, first + values.size() * sizeof(T)};
}

std::vector<uint8_t> values_of_type(const draco::PointAttribute& attribute, size_t points, size_t width, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return values_as<int8_t>(attribute, points, width);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return values_as<uint8_t>(attribute, points, width);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return values_as<int16_t>(attribute, points, width);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return values_as<uint16_t>(attribute, points, width);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return values_as<uint32_t>(attribute, points, width);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return values_as<float>(attribute, points, width);
    default:
      throw Error("component type " + std::to_string(type));
  }
}

// glTF wants the elements of vertex attributes at multiples of 4.
size_t pad_elements(size_t count, std::vector<uint8_t>* bytes) {
  const size_t element = bytes->size() / count, stride = (element + 3) / 4 * 4;
  if (element == stride) return 0;
  std::vector<uint8_t> padded(count * stride, 0);
  for (size_t i = 0; i < count; ++i)
    std::copy_n(bytes->begin() + static_cast<std::ptrdiff_t>(i * element), element,
                padded.begin() + static_cast<std::ptrdiff_t>(i * stride));
  *bytes = std::move(padded);
  return stride;
}

}  // namespace

#endif

namespace {

class DracoDecoder {
 public:
  explicit DracoDecoder(CompressedGltf* gltf) : gltf_(*gltf), document_(gltf->document) {}

  void decode() {
    if (!document_.contains("meshes")) return;
    for (size_t m = 0; m < document_["meshes"].size(); ++m) {
      Json& primitives = document_["meshes"][m].at("primitives");
      for (size_t p = 0; p < primitives.size(); ++p) {
        if (!primitives[p].contains("extensions") || !primitives[p]["extensions"].contains(kDraco)) continue;
        where_ = gltf_.path + ": mesh " + std::to_string(m) + ", primitive " + std::to_string(p) + ", " + kDraco;
        const Json extension = primitives[p]["extensions"][kDraco];
        primitives[p]["extensions"].erase(kDraco);
        if (primitives[p]["extensions"].empty()) primitives[p].erase("extensions");
        packed_views_.insert(extension.at("bufferView").get<size_t>());
        if (!has_plain_values(primitives[p], extension)) decode_primitive(extension, &primitives[p]);
      }
    }
    // The compressed views.
    for (auto at = packed_views_.rbegin(); at != packed_views_.rend(); ++at) {  // from behind: numbers stay
      const size_t view = *at;
      if (view >= gltf_.views.size()) continue;
      if (drop_unused_view(view, &document_))
        gltf_.views.erase(gltf_.views.begin() + static_cast<std::ptrdiff_t>(view));
      else
        gltf_.views[view] = std::vector<uint8_t>(4, 0);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(where_ + ": expected " + expected + ", found " + found);
  }

  Json& accessor(const Json& number) {
    const size_t index = number.get<size_t>();
    if (index >= document_["accessors"].size())
      fail("an accessor below " + std::to_string(document_["accessors"].size()), std::to_string(index));
    return document_["accessors"][index];
  }

  // Files may carry the same values uncompressed, for readers without Draco.
  bool has_plain_values(const Json& primitive, const Json& extension) {
    if (primitive.contains("indices") && !accessor(primitive["indices"]).contains("bufferView")) return false;
    for (const auto& [name, id] : extension.at("attributes").items())
      if (!primitive.at("attributes").contains(name) || !accessor(primitive["attributes"][name]).contains("bufferView"))
        return false;
    return true;
  }

#ifndef SINEW_HAS_DRACO
  void decode_primitive(const Json&, Json*) {
    throw Error(
        where_ +
        ": cannot read, this sinew was built without Draco; install libdraco-dev and build again, or decode the "
        "file first (gltf-transform copy)");
  }
#else
  // Gives the accessor its bytes. One that has some already (of another mesh, or for readers without Draco) stays, and a
  // copy takes them; one that came with the same vertices before is left.
  Json fill(const Json& number, Json made, std::vector<uint8_t> bytes, size_t stride, int target) {
    Json& old = accessor(number);
    if (filled_.count(number.get<size_t>()) != 0) return number;
    Json view = {{"buffer", 0}, {"byteLength", bytes.size()}, {"target", target}};
    if (stride != 0) view["byteStride"] = stride;
    gltf_.plain_bytes += bytes.size();
    gltf_.views.emplace_back(std::move(bytes));
    document_["bufferViews"].push_back(std::move(view));
    const bool has_bytes = old.contains("bufferView");
    made["bufferView"] = gltf_.views.size() - 1;
    made.erase("byteOffset");
    made.erase("sparse");
    if (has_bytes) {
      document_["accessors"].push_back(std::move(made));
      return document_["accessors"].size() - 1;
    }
    old = std::move(made);
    filled_.insert(number.get<size_t>());
    return number;
  }

  void decode_primitive(const Json& extension, Json* primitive) {
    const size_t view_number = extension["bufferView"].get<size_t>();
    if (view_number >= gltf_.views.size())
      fail("a buffer view below " + std::to_string(gltf_.views.size()), std::to_string(view_number));
    const ByteRange packed = gltf_.views[view_number]
                                 ? ByteRange{gltf_.views[view_number]->data(), gltf_.views[view_number]->size()}
                                 : bytes_of(gltf_, where_, document_["bufferViews"][view_number]);
    gltf_.packed_bytes += packed.size;
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(packed.first), packed.size);
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) fail("a mesh that Draco reads", one_line(decoded.status().error_msg_string()));
    const draco::Mesh& mesh = *decoded.value();
    const size_t point_count = mesh.num_points(), face_count = mesh.num_faces();
    if (point_count == 0 || face_count == 0) fail("a mesh with faces", "an empty one");

    for (const auto& [name, id] : extension.at("attributes").items()) {
      const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id.get<uint32_t>());
      if (attribute == nullptr) fail("a Draco attribute " + id.dump() + " for " + name, "none of that number");
      if (!primitive->at("attributes").contains(name)) continue;
      Json made = accessor((*primitive)["attributes"][name]);
      if (made.at("count").get<size_t>() != point_count)
        fail(std::to_string(made["count"].get<size_t>()) + " values of " + name, std::to_string(point_count));
      const std::string type = made.at("type").get<std::string>();
      const size_t width = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
      if (width == 0) fail("an accessor of numbers or vectors for " + name, in_quotes(type));
      std::vector<uint8_t> bytes;
      try {
        bytes = values_of_type(*attribute, point_count, width, made.at("componentType").get<int>());
      } catch (const Error& error) {
        fail("values of " + name + " that the accessor can hold", error.what());
      }
      if (name == "POSITION") set_bounds(bytes, &made);
      const size_t stride = pad_elements(point_count, &bytes);
      Json& number = (*primitive)["attributes"][name];
      number = fill(number, std::move(made), std::move(bytes), stride, TINYGLTF_TARGET_ARRAY_BUFFER);
    }

    std::vector<uint32_t> indices;
    for (size_t f = 0; f < face_count; ++f)
      for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(static_cast<uint32_t>(f)))) {
        if (corner.value() >= point_count)
          fail("corners below " + std::to_string(point_count), std::to_string(corner.value()));
        indices.push_back(corner.value());
      }
    const bool small = point_count < 65535;
    std::vector<uint8_t> bytes;
    for (const uint32_t index : indices)
      for (int byte = 0; byte < (small ? 2 : 4); ++byte) bytes.push_back(static_cast<uint8_t>(index >> (8 * byte)));
    const int type = small ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    primitive->erase("mode");  // Draco keeps triangles, whatever was there before
    if (!primitive->contains("indices")) {
      document_["accessors"].push_back(Json::object());
      (*primitive)["indices"] = document_["accessors"].size() - 1;
    }
    Json& number = (*primitive)["indices"];
    number = fill(number, {{"componentType", type}, {"count", indices.size()}, {"type", "SCALAR"}}, std::move(bytes), 0,
                  TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }

  // Draco rounds: the bounds of the values as they were do not hold to the last bit.
  static void set_bounds(const std::vector<uint8_t>& bytes, Json* made) {
    if ((*made)["componentType"] != TINYGLTF_COMPONENT_TYPE_FLOAT || bytes.size() < 12) return;
    std::vector<float> values(bytes.size() / 4);
    std::memcpy(values.data(), bytes.data(), values.size() * 4);
    std::array<float, 3> low = {values[0], values[1], values[2]}, high = low;
    for (size_t i = 0; i < values.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], values[i]);
      high[i % 3] = std::max(high[i % 3], values[i]);
    }
    (*made)["min"] = low;
    (*made)["max"] = high;
  }

#endif

  CompressedGltf& gltf_;
  Json& document_;
  std::string where_;
  std::set<size_t> packed_views_;  // compressed
  std::set<size_t> filled_;        // accessors that got their bytes here
};

}  // namespace

void decode_draco(CompressedGltf* gltf) {
  try {
    DracoDecoder(gltf).decode();
  } catch (const Error& error) {  // a library that is missing knows of no file
    const std::string text = error.what();
    if (text.rfind(gltf->path, 0) == 0) throw;
    throw Error(gltf->path + ": " + text);
  }
}

}  // namespace sinew
