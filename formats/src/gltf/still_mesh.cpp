// SPDX-License-Identifier: MIT
// The mesh nodes of a character's document in a document of their own.
#include "sinew_formats/still_mesh.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/surface_normals.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr const char* kTexCoord = "TEXCOORD_";

const tinygltf::Primitive& primitive_of(const GltfSource& source, const GltfPart& part) {
  const int mesh = source.model.nodes[static_cast<size_t>(part.node)].mesh;
  return source.model.meshes[static_cast<size_t>(mesh)].primitives[static_cast<size_t>(part.primitive)];
}

// [N] those of the Character's corners, which are the document's own; the surface's where a vertex has none.
std::vector<Vec3> corner_normals(const std::string& path, const Character& character, const GltfSource& source) {
  const SurfaceNormals surface(character);
  const bool has_normals = character.corner_normals.size() == character.face_vertices.size();
  std::vector<Vec3> normals;
  size_t corner = 0;
  for (const GltfPart& part : source.parts) {
    const size_t first = normals.size();
    for (const uint32_t v : part.vertex_of) {
      const Point3& normal = surface.rest(v);
      normals.push_back(dot(normal, normal) > 0 ? to_vec3(normal) : Vec3{0, 1, 0});
    }
    for (const auto& triangle :
         primitive_triangles(path, source.model, primitive_of(source, part), part.vertex_of.size()))
      for (const uint32_t v : triangle) {
        const Vec3 own = has_normals ? character.corner_normals[corner] : Vec3{};
        if (own.x != 0 || own.y != 0 || own.z != 0) normals[first + v] = own;
        ++corner;
      }
  }
  return normals;
}

// [N] of a document that was made of the character, in world axes.
std::vector<Vec3> made_normals(const std::string& path, const GltfSource& source) {
  std::vector<Vec3> normals;
  for (const GltfPart& part : source.parts) {
    const std::vector<float> values =
        accessor_floats(path, source.model, primitive_of(source, part).attributes.at("NORMAL"), 3);
    for (size_t i = 0; i + 2 < values.size(); i += 3) normals.push_back({values[i], values[i + 1], values[i + 2]});
  }
  return normals;
}

// Calls each(key, value) for all members of all objects in `json`.
void visit_members(Json* json, const std::function<void(const std::string&, Json*)>& each) {
  for (auto& [key, value] : json->items()) {
    if (json->is_object()) each(key, &value);
    if (value.is_structured()) visit_members(&value, each);
  }
}

// Extensions that the elements which are left have, and that of quantized attributes.
void keep_used_extensions(const Json& from, Json* document) {
  std::set<std::string> names = {"KHR_mesh_quantization"};
  visit_members(document, [&](const std::string& key, Json* value) {
    if (key == "extensions")
      for (const auto& [name, unused] : value->items()) names.insert(name);
  });
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    Json kept = Json::array();
    if (from.contains(key))
      std::copy_if(from[key].begin(), from[key].end(), std::back_inserter(kept),
                   [&](const Json& name) { return names.count(name.get<std::string>()) != 0; });
    if (!kept.empty()) (*document)[key] = kept;
  }
}

// Texture coordinates and colors, with room for set 1.
Json kept_attributes(const Json& attributes) {
  Json kept = Json::object();
  for (const auto& [key, accessor] : attributes.items()) {
    if (key.rfind("COLOR_", 0) == 0) kept[key] = accessor;
    if (key.rfind(kTexCoord, 0) != 0) continue;
    const int set = std::stoi(key.substr(std::string(kTexCoord).size()));
    kept[kTexCoord + std::to_string(set + (set > 0 ? 1 : 0))] = accessor;
  }
  return kept;
}

void move_texture_sets(Json* materials) {
  visit_members(materials, [](const std::string& key, Json* value) {
    if (key == "texCoord" && value->is_number_integer() && value->get<int>() > 0) *value = value->get<int>() + 1;
  });
}

}  // namespace

StillMesh::StillMesh(const std::string& path, const Character& character) : path_(path) {
  const bool has_document = character.gltf && character.gltf->vertex_count == character.vertices.size();
  source_ = has_document ? character.gltf : std::make_shared<const GltfSource>(gltf_from_mesh(path, character));
  for (const GltfPart& part : source_->parts)
    vertices_.insert(vertices_.end(), part.vertex_of.begin(), part.vertex_of.end());
  normals_ = has_document ? corner_normals(path, character, *source_) : made_normals(path, *source_);
  if (vertices_.empty() || normals_.size() != vertices_.size())
    throw Error(path + ": expected a mesh with faces, found none");
}

std::vector<uint8_t> StillMesh::glb(const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
                                    const std::vector<std::array<float, 2>>& texels) const {
  try {
    GltfSource out = *source_;
    out.document = Json::object();
    for (const char* key :
         {"asset", "accessors", "bufferViews", "buffers", "materials", "textures", "images", "samplers"})
      if (source_->document.contains(key)) out.document[key] = source_->document[key];
    if (out.document.contains("materials")) move_texture_sets(&out.document["materials"]);
    size_t vertex = 0;
    const auto add = [&](const auto& values_of, size_t width, size_t count) {
      std::vector<float> values;
      for (size_t v = vertex; v < vertex + count; ++v) values_of(v, &values);
      return add_vectors(&out, values, width, width == 3);
    };
    const auto vectors = [](const std::vector<Vec3>& from) {
      return [&from](size_t v, std::vector<float>* values) {
        values->insert(values->end(), {from[v].x, from[v].y, from[v].z});
      };
    };
    for_each_node(source_->parts, [&](size_t first, size_t last) {
      const Json& node = source_->document["nodes"][static_cast<size_t>(source_->parts[first].node)];
      const Json& read = source_->document["meshes"][node["mesh"].get<size_t>()];
      Json mesh = Json::object();
      if (read.contains("name")) mesh["name"] = read["name"];
      for (size_t p = first; p < last; ++p) {
        const Json& old = read["primitives"][static_cast<size_t>(source_->parts[p].primitive)];
        const size_t count = source_->parts[p].vertex_of.size();
        Json primitive = Json::object();
        for (const char* key : {"indices", "material", "mode"})
          if (old.contains(key)) primitive[key] = old[key];
        primitive["attributes"] = kept_attributes(old["attributes"]);
        primitive["attributes"]["POSITION"] = add(vectors(positions), 3, count);
        primitive["attributes"]["NORMAL"] = add(vectors(normals), 3, count);
        const int texel = add(
            [&](size_t v, std::vector<float>* values) {
              values->insert(values->end(), {texels[v][0], texels[v][1]});
            },
            2, count);
        primitive["attributes"]["TEXCOORD_1"] = texel;
        if (!primitive["attributes"].contains("TEXCOORD_0")) primitive["attributes"]["TEXCOORD_0"] = texel;
        mesh["primitives"].push_back(std::move(primitive));
        vertex += count;
      }
      Json shown = {{"mesh", out.document["meshes"].size()}};
      if (node.contains("name")) shown["name"] = node["name"];
      out.document["scenes"][0]["nodes"].push_back(out.document["nodes"].size());
      out.document["nodes"].push_back(std::move(shown));
      out.document["meshes"].push_back(std::move(mesh));
    });
    out.document["scene"] = 0;
    keep_used_extensions(source_->document, &out.document);
    embed_images(path_, true, &out);
    std::vector<int> old_accessors(source_->model.accessors.size());
    for (size_t a = 0; a < old_accessors.size(); ++a) old_accessors[a] = static_cast<int>(a);
    drop_unused_accessors(std::move(old_accessors), &out);
    return pack_glb(path_, &out.document, std::move(out.bytes));
  } catch (const nlohmann::json::exception& error) {
    throw Error(path_ + ": cannot write, the input document has an unexpected form: " + one_line(error.what()));
  }
}

}  // namespace sinew
