// SPDX-License-Identifier: MIT
#include "usd/usd_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"
#include "usd/usd_transform.hpp"

namespace sinew {
namespace {

// An attribute with a value a point, a corner, a face, or one for all.
struct Primvar {
  std::vector<float> values;
  std::vector<size_t> indices;  // empty: its own order
  size_t width = 0;             // 0: there is none
  enum class On { kAll, kFace, kPoint, kCorner } on = On::kAll;

  const float* at(size_t face, size_t point, size_t corner) const {
    size_t i = on == On::kAll ? 0 : on == On::kFace ? face : on == On::kPoint ? point : corner;
    if (!indices.empty()) i = indices[i];
    return &values[width * i];
  }
};

class MeshReader {
 public:
  MeshReader(size_t place, const std::vector<UsdRig>& rigs, const std::map<std::string, int>& materials,
             UsdStage* stage)
      : place_(place),
        prim_(*stage->places[place].prim),
        rigs_(rigs),
        materials_(materials),
        stage_(*stage),
        where_(stage->where(prim_)) {}

  // False for a mesh without a face.
  bool read(UsdShapes* shapes) {
    points_ = floats("points", 3);
    read_faces();
    if (corners_.empty()) return false;
    normals_ = primvar("primvars:normals", 3, "vertex");
    if (normals_.width == 0) normals_ = primvar("normals", 3, "vertex");
    uvs_ = texture_coordinates();
    colours_ = primvar("primvars:displayColor", 3, "constant");
    if (colours_.width > 0 && colours_.on == Primvar::On::kAll) colours_.width = 0;  // one that materials say better
    opacities_ = primvar("primvars:displayOpacity", 1, "constant");
    if (opacities_.on == Primvar::On::kAll ||
        std::all_of(opacities_.values.begin(), opacities_.values.end(), [](float a) { return a >= 1; }))
      opacities_.width = 0;  // opaque, or one that materials say better
    find_rig();
    read_influences();
    read_materials();
    read_shapes(shapes);
    Json mesh = {{"name", UsdStage::name_of(prim_)}, {"primitives", Json::array()}};
    if (!shapes->tokens.empty()) mesh["extras"] = {{"targetNames", shapes->tokens}};
    for (const auto& [material, faces] : faces_of_) mesh["primitives"].push_back(primitive(material, faces));
    if (mesh["primitives"].empty()) return false;
    stage_.document()["meshes"].push_back(std::move(mesh));
    add_node(shapes);
    return true;
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(where_ + ": expected " + expected + ", found " + found);
  }

  std::vector<float> floats(const std::string& name, size_t width) const {
    std::vector<float> out;
    const UsdValue* value = find_value(prim_, name);
    if (value == nullptr) return out;
    if (value->numbers.size() % width != 0)
      fail(name + " in tuples of " + std::to_string(width), std::to_string(value->numbers.size()) + " numbers");
    for (const double number : value->numbers) {
      out.push_back(static_cast<float>(number));
      if (!std::isfinite(out.back())) fail("finite numbers in " + name, "another");
    }
    return out;
  }

  // Whole numbers below `limit`.
  std::vector<size_t> integers(const UsdPrim& prim, const std::string& name, size_t limit) const {
    std::vector<size_t> out;
    const UsdValue* value = find_value(prim, name);
    if (value == nullptr) return out;
    for (const double number : value->numbers) {
      if (!(number >= 0) || !(number < static_cast<double>(limit)) || number != std::floor(number))
        fail("whole numbers below " + std::to_string(limit) + " in " + name, print("%g", number));
      out.push_back(static_cast<size_t>(number));
    }
    return out;
  }

  void read_faces() {
    corners_ = integers(prim_, "faceVertexIndices", points_.size() / 3);
    const std::vector<size_t> counts = integers(prim_, "faceVertexCounts", corners_.size() + 1);
    size_t sum = 0;
    for (const size_t count : counts) {
      offsets_.push_back(sum);
      sum += count;
      if (sum > corners_.size()) break;
    }
    if (sum != corners_.size())
      fail(std::to_string(corners_.size()) + " corners in faceVertexCounts", std::to_string(sum));
    offsets_.push_back(sum);
  }

  size_t face_count() const { return offsets_.size() - 1; }

  Primvar primvar(const std::string& name, size_t width, const std::string& usual) const {
    Primvar out;
    const UsdProperty* property = find_property(prim_, name);
    if (property == nullptr) return out;
    out.values = floats(name, width);
    if (out.values.empty()) return out;
    const auto at = property->metadata.find("interpolation");
    const std::string how = at == property->metadata.end() || at->second.texts.empty() ? usual : at->second.texts[0];
    size_t count = 1;
    if (how == "uniform") out.on = Primvar::On::kFace, count = face_count();
    if (how == "vertex" || how == "varying") out.on = Primvar::On::kPoint, count = points_.size() / 3;
    if (how == "faceVarying") out.on = Primvar::On::kCorner, count = corners_.size();
    out.indices = integers(prim_, name + ":indices", out.values.size() / width);
    const size_t found = out.indices.empty() ? out.values.size() / width : out.indices.size();
    if (found < count) fail(std::to_string(count) + " values of " + name + " (" + how + ")", std::to_string(found));
    out.width = width;
    return out;
  }

  // primvars:st, else the first that is of this kind.
  Primvar texture_coordinates() const {
    if (find_property(prim_, "primvars:st") != nullptr) return primvar("primvars:st", 2, "constant");
    for (const auto& [name, property] : prim_.properties)
      if (name.rfind("primvars:", 0) == 0 && property.type.rfind("texCoord2", 0) == 0)
        return primvar(name, 2, "constant");
    return {};
  }

  void find_rig() {
    if (find_property(prim_, "primvars:skel:jointIndices") == nullptr || rigs_.empty()) return;
    const UsdProperty* skeleton = stage_.inherited(place_, "skel:skeleton");
    for (const UsdRig& rig : rigs_)
      if (skeleton != nullptr && !skeleton->targets.empty() &&
          stage_.places[rig.place].prim->path == skeleton->targets[0])
        rig_ = &rig;
    if (skeleton == nullptr && rigs_.size() == 1) rig_ = rigs_.data();
  }

  void read_influences() {
    if (rig_ == nullptr) return;
    std::vector<int> joint_of;  // of the mesh's own order
    const UsdProperty* own = stage_.inherited(place_, "skel:joints");
    if (own != nullptr && own->has_value)
      for (const std::string& path : own->value.texts) {
        joint_of.push_back(rig_->joint_of(path));
        if (joint_of.back() < 0) fail("joints of its skeleton in skel:joints", in_quotes(path));
      }
    else
      for (size_t j = 0; j < rig_->joints.size(); ++j) joint_of.push_back(static_cast<int>(j));
    const std::vector<size_t> joints = integers(prim_, "primvars:skel:jointIndices", joint_of.size());
    const std::vector<float> weights = floats("primvars:skel:jointWeights", 1);
    const UsdMetadata& metadata = find_property(prim_, "primvars:skel:jointIndices")->metadata;
    const auto size = metadata.find("elementSize");
    const auto how = metadata.find("interpolation");
    const bool rigid = how != metadata.end() && !how->second.texts.empty() && how->second.texts[0] == "constant";
    const size_t count = points_.size() / 3, rows = rigid ? 1 : count;
    double width = size == metadata.end() || size->second.numbers.empty() ? 1 : size->second.numbers[0];
    if (rigid) width = static_cast<double>(joints.size());
    if (weights.size() != joints.size() || width * static_cast<double>(rows) != static_cast<double>(joints.size()))
      fail(print("%g joints and weights for each of %zu points", width, rows),
           std::to_string(joints.size()) + " and " + std::to_string(weights.size()));
    for (size_t row = 0; row < rows; ++row) {
      std::map<int, float> sums;
      float sum = 0;
      for (size_t k = row * joints.size() / rows; k < (row + 1) * joints.size() / rows; ++k)
        if (weights[k] > 0) sums[joint_of[joints[k]]] += weights[k], sum += weights[k];
      std::vector<std::pair<int, float>> influences(sums.begin(), sums.end());
      std::stable_sort(influences.begin(), influences.end(),
                       [](const auto& a, const auto& b) { return a.second > b.second; });
      for (auto& [joint, weight] : influences) weight /= sum;
      influences_.push_back(std::move(influences));
    }
    if (rigid) influences_.resize(count, influences_.empty() ? Row() : influences_[0]);
  }

  int material_of(size_t place) const {
    const UsdProperty* binding = stage_.inherited(place, "material:binding");
    if (binding == nullptr || binding->targets.empty()) return -1;
    const auto at = materials_.find(binding->targets[0]);
    return at == materials_.end() ? -1 : at->second;
  }

  void read_materials() {
    std::vector<int> of_face(face_count(), material_of(place_));
    for (const UsdPrim& child : prim_.children) {
      const auto place = stage_.by_path.find(child.path);
      if (child.type != "GeomSubset" || place == stage_.by_path.end() ||
          text_of(child, "elementType", "face") != "face" || find_property(child, "material:binding") == nullptr)
        continue;
      for (const size_t face : integers(child, "indices", face_count())) of_face[face] = material_of(place->second);
    }
    for (size_t f = 0; f < of_face.size(); ++f) faces_of_[of_face[f]].push_back(f);
  }

  void read_shapes(UsdShapes* shapes) {
    const UsdValue* tokens = find_value(prim_, "skel:blendShapes");
    const UsdProperty* targets = find_property(prim_, "skel:blendShapeTargets");
    if (tokens == nullptr || targets == nullptr) return;
    for (size_t s = 0; s < std::min(tokens->texts.size(), targets->targets.size()); ++s) {
      const auto place = stage_.by_path.find(targets->targets[s]);
      if (place == stage_.by_path.end()) continue;
      const UsdPrim& shape = *stage_.places[place->second].prim;
      const UsdValue* offsets = find_value(shape, "offsets");
      const std::vector<size_t> points = integers(shape, "pointIndices", points_.size() / 3);
      std::vector<float> moves(points_.size(), 0);
      const size_t count = offsets == nullptr ? 0 : offsets->numbers.size() / 3;
      if (count > (points.empty() ? points_.size() / 3 : points.size()))
        fail("an offset a point in " + in_quotes(shape.name), std::to_string(count));
      for (size_t i = 0; i < 3 * count; ++i) {
        const float move = static_cast<float>(offsets->numbers[i]);
        if (!std::isfinite(move)) fail("finite offsets in " + in_quotes(shape.name), "another");
        moves[3 * (points.empty() ? i / 3 : points[i / 3]) + i % 3] = move;
      }
      shapes->tokens.push_back(tokens->texts[s]);
      moves_.push_back(std::move(moves));
    }
  }

  // Corners that agree in everything are one vertex.
  struct Vertices {
    std::vector<size_t> points;
    std::vector<float> normals, uvs, colours;
    std::vector<uint32_t> indices;
  };

  Vertices vertices_of(const std::vector<size_t>& faces) const {
    Vertices out;
    std::unordered_map<std::string, uint32_t> numbers;
    const auto vertex = [&](size_t face, size_t corner) {
      const size_t point = corners_[corner];
      std::string key(reinterpret_cast<const char*>(&point), sizeof point);
      const auto add = [&](const Primvar& from) {
        if (from.width == 0) return;
        key.append(reinterpret_cast<const char*>(from.at(face, point, corner)), from.width * sizeof(float));
      };
      add(normals_), add(uvs_), add(colours_), add(opacities_);
      const auto [at, is_new] = numbers.emplace(std::move(key), static_cast<uint32_t>(out.points.size()));
      if (is_new) {
        out.points.push_back(point);
        if (normals_.width > 0) add_normal(normals_.at(face, point, corner), &out.normals);
        if (uvs_.width > 0) {
          const float* uv = uvs_.at(face, point, corner);
          out.uvs.insert(out.uvs.end(), {uv[0], 1 - uv[1]});
        }
        for (size_t i = 0; i < 3 && (colours_.width > 0 || opacities_.width > 0); ++i)
          out.colours.push_back(colours_.width > 0 ? std::clamp(colours_.at(face, point, corner)[i], 0.0f, 1.0f) : 1);
        if (opacities_.width > 0) out.colours.push_back(std::clamp(opacities_.at(face, point, corner)[0], 0.0f, 1.0f));
      }
      out.indices.push_back(at->second);
    };
    const bool left_handed = text_of(prim_, "orientation") == "leftHanded";
    for (const size_t face : faces)
      for (size_t c = offsets_[face] + 1; c + 1 < offsets_[face + 1]; ++c) {
        vertex(face, offsets_[face]);
        vertex(face, left_handed ? c + 1 : c);
        vertex(face, left_handed ? c : c + 1);
      }
    return out;
  }

  static void add_normal(const float* n, std::vector<float>* out) {
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const bool fine = std::isfinite(length) && length > 1e-20f;
    for (size_t i = 0; i < 3; ++i) out->push_back(fine ? n[i] / length : i == 1 ? 1.0f : 0.0f);
  }

  Json primitive(int material, const std::vector<size_t>& faces) {
    const Vertices vertices = vertices_of(faces);
    if (vertices.indices.empty()) fail("faces of three corners or more", "others alone");
    Json attributes;
    std::vector<float> positions;
    for (const size_t point : vertices.points)
      positions.insert(positions.end(), &points_[3 * point], &points_[3 * point] + 3);
    attributes["POSITION"] = add_vectors(positions, 3, true, true, &stage_);
    if (!vertices.normals.empty()) attributes["NORMAL"] = add_vectors(vertices.normals, 3, true, false, &stage_);
    if (!vertices.uvs.empty()) attributes["TEXCOORD_0"] = add_vectors(vertices.uvs, 2, true, false, &stage_);
    if (!vertices.colours.empty())
      attributes["COLOR_0"] = add_vectors(vertices.colours, opacities_.width > 0 ? 4 : 3, true, false, &stage_);
    if (rig_ != nullptr) add_weights(vertices.points, &attributes);
    Json out = {{"attributes", attributes}};
    out["indices"] = add_accessor(&stage_.out, vertices.indices.data(), vertices.indices.size() * 4, "SCALAR",
                                  TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, vertices.indices.size(), false, false);
    stage_.document()["bufferViews"].back()["target"] = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    if (material >= 0) out["material"] = material;
    for (const std::vector<float>& shape : moves_) {
      std::vector<float> moves;
      for (const size_t point : vertices.points) moves.insert(moves.end(), &shape[3 * point], &shape[3 * point] + 3);
      out["targets"].push_back({{"POSITION", add_vectors(moves, 3, true, true, &stage_)}});
    }
    return out;
  }

  void add_weights(const std::vector<size_t>& points, Json* attributes) {
    size_t longest = 1;
    for (const size_t point : points) longest = std::max(longest, influences_[point].size());
    for (size_t set = 0; set * 4 < longest; ++set) {
      std::vector<uint16_t> joints;
      std::vector<float> weights;
      for (const size_t point : points)
        for (size_t k = set * 4; k < set * 4 + 4; ++k) {
          const bool known = k < influences_[point].size();
          joints.push_back(known ? static_cast<uint16_t>(influences_[point][k].first) : uint16_t{0});
          weights.push_back(known ? influences_[point][k].second : 0.0f);
        }
      (*attributes)["JOINTS_" + std::to_string(set)] =
          add_accessor(&stage_.out, joints.data(), joints.size() * 2, "VEC4", TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                       joints.size() / 4, true, false);
      (*attributes)["WEIGHTS_" + std::to_string(set)] = add_vectors(weights, 4, true, false, &stage_);
    }
  }

  void add_node(UsdShapes* shapes) {
    Json node = {{"name", UsdStage::name_of(prim_)}, {"mesh", stage_.document()["meshes"].size() - 1}};
    if (rig_ != nullptr) {
      const UsdValue* bind = find_value(prim_, "primvars:skel:geomBindTransform");
      const Affine frame = bind == nullptr ? kIdentity : usd_affines(where_ + ", geomBindTransform", *bind, 1)[0];
      node["skin"] = add_usd_skin(*rig_, frame, &stage_);
    } else {
      const Affine world = multiply(stage_.to_metres, stage_.places[place_].world);
      std::vector<double> columns;
      for (size_t c = 0; c < 4; ++c)
        for (size_t r = 0; r < 4; ++r) columns.push_back(r < 3 ? world[4 * r + c] : c == 3 ? 1.0 : 0.0);
      if (world != kIdentity) node["matrix"] = columns;
    }
    shapes->node = stage_.document()["nodes"].size();
    stage_.roots.push_back(shapes->node);
    stage_.document()["nodes"].push_back(std::move(node));
  }

  using Row = std::vector<std::pair<int, float>>;  // joint of the rig, weight

  const size_t place_;
  const UsdPrim& prim_;
  const std::vector<UsdRig>& rigs_;
  const std::map<std::string, int>& materials_;
  UsdStage& stage_;
  const std::string where_;
  std::vector<float> points_;              // [P x 3]
  std::vector<size_t> corners_, offsets_;  // points, [F + 1]
  Primvar normals_, uvs_, colours_, opacities_;
  const UsdRig* rig_ = nullptr;
  std::vector<Row> influences_;                  // [P]
  std::map<int, std::vector<size_t>> faces_of_;  // by material
  std::vector<std::vector<float>> moves_;        // [shapes][P x 3]
};

}  // namespace

std::vector<UsdShapes> add_usd_meshes(const std::vector<UsdRig>& rigs, const std::map<std::string, int>& materials,
                                      UsdStage* stage) {
  std::vector<UsdShapes> all;
  for (size_t p = 0; p < stage->places.size(); ++p) {
    if (stage->places[p].prim->type != "Mesh") continue;
    UsdShapes shapes;
    if (MeshReader(p, rigs, materials, stage).read(&shapes) && !shapes.tokens.empty()) all.push_back(std::move(shapes));
  }
  return all;
}

}  // namespace sinew
