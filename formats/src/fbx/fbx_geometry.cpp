// SPDX-License-Identifier: MIT
// Meshes as geometries, with their skins and shapes.
#include "fbx/fbx_write.hpp"
#include "gltf/control_points.hpp"

namespace sinew {
namespace {

class Geometry {
 public:
  Geometry(const std::string& whose, const tinygltf::Model& model, size_t node)
      : model_(model), node_(node), mesh_(control_points(whose, model, node)) {}

  int64_t write(const Affine& frame, const std::vector<int64_t>& clusters, FbxScene* scene, std::vector<int>* materials,
                std::vector<int64_t>* channels) {
    if (mesh_.corners.empty()) return 0;
    *materials = mesh_.materials;
    int64_t id = 0;
    FbxNode geometry = scene->object("Geometry", mesh_.name, "Geometry", "Mesh", &id);
    geometry.add("Properties70");
    geometry.add("GeometryVersion").integer(124);
    geometry.add("Vertices").numbers(scaled(mesh_.positions));
    std::vector<int32_t> corners = mesh_.corners;
    for (size_t c = 2; c < corners.size(); c += 3) corners[c] = ~corners[c];  // the last of a polygon
    geometry.add("PolygonVertexIndex").integers(corners);
    add_layers(&geometry);
    scene->add("Geometry", std::move(geometry));
    if (!clusters.empty()) write_skin(id, frame, clusters, scene);
    if (!mesh_.shapes.empty()) write_shapes(id, scene, channels);
    return id;
  }

 private:
  static std::vector<double> scaled(const std::vector<double>& values) {
    std::vector<double> out;
    for (const double value : values) out.push_back(kFbxUnits * value);
    return out;
  }

  static FbxNode layer(const char* kind, const char* name, const char* mapping, const char* reference) {
    FbxNode element(kind);
    element.integer(0);
    element.add("Version").integer(101);
    element.add("Name").text(name);
    element.add("MappingInformationType").text(mapping);
    element.add("ReferenceInformationType").text(reference);
    return element;
  }

  void add_layers(FbxNode* geometry) const {
    FbxNode all("Layer");
    all.integer(0);
    all.add("Version").integer(100);
    const auto take = [&](const char* kind, FbxNode element) {
      geometry->add(std::move(element));
      FbxNode entry("LayerElement");
      entry.add("Type").text(kind);
      entry.add("TypedIndex").integer(0);
      all.add(std::move(entry));
    };
    if (mesh_.has_normals) {
      FbxNode element = layer("LayerElementNormal", "", "ByPolygonVertex", "Direct");
      element.add("Normals").numbers(mesh_.normals);
      take("LayerElementNormal", std::move(element));
    }
    const auto indexed = [&](const char* kind, const char* name, const char* values_name, const char* index_name,
                             const std::vector<double>& values, size_t width) {
      FbxNode element = layer(kind, name, "ByPolygonVertex", "IndexToDirect");
      std::vector<int32_t> indices(values.size() / width);
      for (size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<int32_t>(i);
      element.add(values_name).numbers(values);
      element.add(index_name).integers(indices);
      take(kind, std::move(element));
    };
    if (mesh_.has_colors) indexed("LayerElementColor", "Col", "Colors", "ColorIndex", mesh_.colors, 4);
    if (mesh_.has_uvs) indexed("LayerElementUV", "UVMap", "UV", "UVIndex", mesh_.uvs, 2);
    const bool one = mesh_.materials.size() < 2;
    FbxNode element = layer("LayerElementMaterial", "", one ? "AllSame" : "ByPolygon", "IndexToDirect");
    element.add("Materials").integers(one ? std::vector<int32_t>{0} : mesh_.polygon_materials);
    take("LayerElementMaterial", std::move(element));
    geometry->add(std::move(all));
  }

  // A cluster for each joint, also of those that hold nothing: they tell where it was bound.
  void write_skin(int64_t geometry, const Affine& frame, const std::vector<int64_t>& clusters, FbxScene* scene) const {
    const tinygltf::Skin& skin = model_.skins[static_cast<size_t>(model_.nodes[node_].skin)];
    const std::vector<Affine> binds = inverse_bind_matrices(mesh_.where, model_, skin);
    std::vector<std::vector<int32_t>> points(clusters.size());
    std::vector<std::vector<double>> weights(clusters.size());
    for (size_t p = 0; p < mesh_.rows.size(); ++p)
      for (const Influence& one : mesh_.rows[p]) {
        if (one.joint >= clusters.size()) continue;
        points[one.joint].push_back(static_cast<int32_t>(p));
        weights[one.joint].push_back(static_cast<double>(one.weight));
      }
    int64_t id = 0;
    FbxNode deformer = scene->object("Deformer", mesh_.name, "Deformer", "Skin", &id);
    deformer.add("Version").integer(101);
    deformer.add("Link_DeformAcuracy").number(50);
    deformer.add("SkinningType").text("Linear");
    scene->add("Deformer", std::move(deformer));
    scene->connect(id, geometry);
    for (size_t k = 0; k < clusters.size(); ++k) {
      const std::optional<Affine> back = inverse(binds[k]);
      if (clusters[k] == 0 || !back) continue;
      int64_t cluster = 0;
      FbxNode link = scene->object("Deformer", model_.nodes[static_cast<size_t>(skin.joints[k])].name, "SubDeformer",
                                   "Cluster", &cluster);
      link.add("Version").integer(100);
      link.add("UserData").text("").text("");
      if (!points[k].empty()) {
        link.add("Indexes").integers(points[k]);
        link.add("Weights").numbers(weights[k]);
      }
      link.add("Transform").matrix(in_fbx_units(binds[k]));
      link.add("TransformLink").matrix(in_fbx_units(multiply(frame, *back)));
      scene->add("Deformer", std::move(link));
      scene->connect(cluster, id);
      scene->connect(clusters[k], cluster);
    }
  }

  void write_shapes(int64_t geometry, FbxScene* scene, std::vector<int64_t>* channels) const {
    int64_t id = 0;
    FbxNode deformer = scene->object("Deformer", mesh_.name, "Deformer", "BlendShape", &id);
    deformer.add("Version").integer(100);
    scene->add("Deformer", std::move(deformer));
    scene->connect(id, geometry);
    for (size_t t = 0; t < mesh_.shapes.size(); ++t) {
      const double percent = 100 * mesh_.shapes[t].weight;
      int64_t channel = 0, shape = 0;
      FbxNode sub = scene->object("Deformer", mesh_.shapes[t].name, "SubDeformer", "BlendShapeChannel", &channel);
      sub.add("Version").integer(100);
      sub.add("DeformPercent").number(percent);
      sub.add("FullWeights").numbers({100});
      FbxNode properties("Properties70");
      properties.property("DeformPercent", "Number", "", "A").number(percent);
      sub.add(std::move(properties));
      scene->add("Deformer", std::move(sub));
      FbxNode moved = scene->object("Geometry", mesh_.shapes[t].name, "Geometry", "Shape", &shape);
      moved.add("Properties70");
      moved.add("Version").integer(100);
      moved.add("Indexes").integers(mesh_.shapes[t].points);
      moved.add("Vertices").numbers(scaled(mesh_.shapes[t].moves));
      moved.add("Normals").numbers(mesh_.shapes[t].normals);
      scene->add("Geometry", std::move(moved));
      scene->connect(channel, id);
      scene->connect(shape, channel);
      channels->push_back(channel);
    }
  }

  const tinygltf::Model& model_;
  const size_t node_;
  const ControlPoints mesh_;
};

}  // namespace

int64_t add_fbx_geometry(const std::string& whose, const tinygltf::Model& model, size_t node, const Affine& frame,
                         const std::vector<int64_t>& clusters, FbxScene* scene, std::vector<int>* materials,
                         std::vector<int64_t>* channels) {
  return Geometry(whose, model, node).write(frame, clusters, scene, materials, channels);
}

}  // namespace sinew
