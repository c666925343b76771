// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cstring>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// A number as stored in a file, normalized or not.
double number_at(const uint8_t* at, int component_type) {
  const auto read = [at](auto value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  };
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return read(int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return read(uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return read(int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read(uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return read(uint32_t{});
    default:
      return read(float{});
  }
}

struct Values {
  std::vector<uint8_t> bytes;
  size_t stride = 0, components = 0;
  int component_type = TINYGLTF_COMPONENT_TYPE_FLOAT;
};

void set_bounds(const Values& values, size_t count, Json* accessor) {
  const size_t size =
      static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(values.component_type)));
  Json low = Json::array(), high = Json::array();
  for (size_t c = 0; c < values.components; ++c) {
    double least = 1e300, most = -1e300;
    for (size_t v = 0; v < count; ++v) {
      const double value = number_at(values.bytes.data() + v * values.stride + c * size, values.component_type);
      least = std::min(least, value), most = std::max(most, value);
    }
    low.push_back(least);
    high.push_back(most);
  }
  (*accessor)["min"] = std::move(low);
  (*accessor)["max"] = std::move(high);
}

}  // namespace

int pick_vertices(const std::string& where, const GltfSource& read, int accessor, const std::vector<uint32_t>& vertices,
                  bool all_stay, GltfSource* written) {
  const tinygltf::Accessor& old = read.model.accessors.at(static_cast<size_t>(accessor));
  const Json& json = read.document["accessors"][static_cast<size_t>(accessor)];
  const bool floats = old.sparse.isSparse || old.bufferView < 0;
  Values values;
  values.components = static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(old.type)));
  if (!floats) values.component_type = old.componentType;
  const size_t size =
      values.components *
      static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(values.component_type)));
  values.stride = (size + 3) / 4 * 4;
  values.bytes.assign(vertices.size() * values.stride, 0);
  // Also checks that the accessor lies in its buffer.
  const std::vector<float> resolved = accessor_floats(where, read.model, accessor, static_cast<int>(values.components));
  const uint8_t* from = reinterpret_cast<const uint8_t*>(resolved.data());
  size_t step = size;
  if (!floats) {
    const tinygltf::BufferView& view = read.model.bufferViews[static_cast<size_t>(old.bufferView)];
    from = read.model.buffers[static_cast<size_t>(view.buffer)].data.data() + view.byteOffset + old.byteOffset;
    step = static_cast<size_t>(old.ByteStride(view));
  }
  for (size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v] >= old.count)
      throw Error(where + ": expected a value for every vertex, found " + std::to_string(old.count));
    std::copy_n(from + vertices[v] * step, size, values.bytes.data() + v * values.stride);
  }
  const int number =
      add_accessor(written, values.bytes.data(), values.bytes.size(), json["type"].get<std::string>().c_str(),
                   values.component_type, vertices.size(), true, !floats && old.normalized);
  written->document["bufferViews"].back()["byteStride"] = values.stride;
  Json& made = written->document["accessors"][static_cast<size_t>(number)];
  if (json.contains("min") && !all_stay && !vertices.empty()) {
    set_bounds(values, vertices.size(), &made);
  } else {
    for (const char* bound : {"min", "max"})
      if (json.contains(bound)) made[bound] = json[bound];
  }
  return number;
}

}  // namespace sinew
