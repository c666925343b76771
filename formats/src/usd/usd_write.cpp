// SPDX-License-Identifier: MIT
// The frame of a USD file, and its meshes.
#include "usd/usd_write.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "gltf/control_points.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "usd/usd_text.hpp"

namespace sinew {
namespace {

constexpr const char* kIn = "        ";

// Names of pictures are made safe: a path in the text ends at @.
std::string picture_stem(const std::string& path) {
  std::string stem = stem_of(path);
  std::replace(stem.begin(), stem.end(), '@', '_');
  return stem;
}

class UsdWriter {
 public:
  UsdWriter(const std::string& path, const tinygltf::Model& model)
      : path_(path),
        model_(model),
        nodes_(gltf_nodes(path, model)),
        skeleton_(path, model_, nodes_),
        materials_(picture_stem(path), model_) {}

  std::vector<NamedBytes> write() {
    std::string meshes;
    for (size_t n = 0; n < model_.nodes.size(); ++n)
      if (nodes_.in_scene[n] != 0 && model_.nodes[n].mesh >= 0) meshes += mesh(n);
    const std::string body = skeleton_.text(moving_shapes()) + meshes + materials_.text();
    std::string text = "#usda 1.0\n(\n    defaultPrim = \"Character\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n";
    if (skeleton_.has_clips())
      text += print(
          "    startTimeCode = 0\n    endTimeCode = %.8g\n    timeCodesPerSecond = %g\n    framesPerSecond = %g\n",
          skeleton_.last_time_code(), kUsdTimeCodes, kUsdTimeCodes);
    text +=
        ")\n\ndef SkelRoot \"Character\" (\n    prepend apiSchemas = [\"SkelBindingAPI\"]\n    kind = \"component\"\n"
        ")\n{\n" +
        body + "}\n";
    NamedBytes layer = {path_, {text.begin(), text.end()}};
    if (has_extension(path_, ".usdz")) {
      std::vector<NamedBytes> inside = {{picture_stem(path_) + ".usda", std::move(layer.bytes)}};
      inside.insert(inside.end(), materials_.files().begin(), materials_.files().end());
      return {{path_, usd_package(path_, inside)}};
    }
    std::vector<NamedBytes> files;
    for (const NamedBytes& picture : materials_.files())
      files.push_back({(std::filesystem::path(path_).parent_path() / picture.path).string(), picture.bytes});
    files.push_back(std::move(layer));
    return files;
  }

 private:
  std::string mesh(size_t n) {
    const tinygltf::Node& node = model_.nodes[n];
    const ControlPoints points = control_points(path_, model_, n);
    if (points.corners.empty()) return "";
    const std::string called = node.name.empty() ? points.name : node.name, prim = usd_free_name(called, &prims_);
    const int joint = node.skin >= 0 ? -1 : skeleton_.joint_above(n);
    const bool skinned = node.skin >= 0 || joint >= 0;
    std::string out = "    def Mesh \"" + prim + "\" (\n        prepend apiSchemas = [" +
                      std::string(skinned || !points.shapes.empty() ? "\"SkelBindingAPI\", " : "") +
                      "\"MaterialBindingAPI\"]\n" + usd_name_line(kIn, prim, called) + "    )\n    {\n";
    const std::string in = kIn, corner = " (\n            interpolation = \"faceVarying\"\n        )\n";
    out += in + "uniform token subdivisionScheme = \"none\"\n";
    if (std::any_of(points.materials.begin(), points.materials.end(), [&](int m) { return materials_.two_sided(m); }))
      out += in + "uniform bool doubleSided = 1\n";
    out += in + "int[] faceVertexCounts = " + usd_list(std::vector<int>(points.corners.size() / 3, 3)) + "\n";
    out += in + "int[] faceVertexIndices = " + usd_list(points.corners) + "\n";
    out += in + "point3f[] points = " + usd_tuples(points.positions, 3) + "\n";
    out += in + "float3[] extent = " + extent(points.positions) + "\n";
    if (points.has_normals) out += in + "normal3f[] normals = " + usd_tuples(points.normals, 3) + corner;
    if (points.has_uvs) out += in + "texCoord2f[] primvars:st = " + usd_tuples(points.uvs, 2) + corner;
    if (points.has_colors) out += in + "color3f[] primvars:displayColor = " + colors(points) + corner;
    if (points.has_colors && !opaque(points))
      out += in + "float[] primvars:displayOpacity = " + opacities(points) + corner;
    if (node.skin >= 0)
      out += influences(points, static_cast<size_t>(node.skin));
    else if (joint >= 0)
      out += held_by(points, joint, n);
    else
      out += in + "matrix4d xformOp:transform = " + usd_matrix(nodes_.worlds[n]) + "\n" + in +
             "uniform token[] xformOpOrder = [\"xformOp:transform\"]\n";
    out += bound_materials(points);
    out += shapes(points, n, "/Character/" + prim);
    return out + "    }\n\n";
  }

  static std::string extent(const std::vector<double>& positions) {
    std::vector<double> bounds(positions.begin(), positions.begin() + 3);
    bounds.insert(bounds.end(), positions.begin(), positions.begin() + 3);
    for (size_t i = 0; i < positions.size(); ++i) {
      bounds[i % 3] = std::min(bounds[i % 3], positions[i]);
      bounds[3 + i % 3] = std::max(bounds[3 + i % 3], positions[i]);
    }
    return usd_tuples(bounds, 3);
  }

  static std::string colors(const ControlPoints& points) {
    std::vector<double> rgb;
    for (size_t i = 0; i < points.colors.size(); ++i)
      if (i % 4 != 3) rgb.push_back(points.colors[i]);
    return usd_tuples(rgb, 3);
  }

  static bool opaque(const ControlPoints& points) {
    for (size_t i = 3; i < points.colors.size(); i += 4)
      if (points.colors[i] < 1) return false;
    return true;
  }

  static std::string opacities(const ControlPoints& points) {
    std::vector<double> alpha;
    for (size_t i = 3; i < points.colors.size(); i += 4) alpha.push_back(points.colors[i]);
    return usd_list(alpha);
  }

  static std::string bound(const Affine& frame, size_t width, const std::vector<int>& joints,
                           const std::vector<double>& weights) {
    const std::string tail = " (\n            elementSize = " + std::to_string(width) +
                             "\n            interpolation = \"vertex\"\n        )\n";
    return kIn + ("matrix4d primvars:skel:geomBindTransform = " + usd_matrix(frame)) + "\n" + kIn +
           "int[] primvars:skel:jointIndices = " + usd_list(joints) + tail + kIn +
           "float[] primvars:skel:jointWeights = " + usd_list(weights) + tail + kIn +
           "rel skel:skeleton = </Character/Skeleton>\n";
  }

  std::string influences(const ControlPoints& points, size_t skin) const {
    size_t longest = 1;
    for (const auto& row : points.rows) longest = std::max(longest, row.size());
    std::vector<int> joints;
    std::vector<double> weights;
    for (const auto& row : points.rows) {
      double sum = 0;
      for (const Influence& one : row) sum += static_cast<double>(one.weight);
      for (size_t k = 0; k < longest; ++k) {
        const int joint = k < row.size() && row[k].joint < model_.skins[skin].joints.size()
                              ? skeleton_.joint_of(model_.skins[skin].joints[row[k].joint])
                              : -1;
        joints.push_back(std::max(0, joint));
        weights.push_back(joint < 0 || !(sum > 0) ? 0.0 : static_cast<double>(row[k].weight) / sum);
      }
    }
    return bound(skeleton_.skin_frame_of(skin), longest, joints, weights);
  }

  // A rigid part: all of it moves with one joint.
  std::string held_by(const ControlPoints& points, int joint, size_t node) const {
    size_t holder = node;  // the joint's node
    while (skeleton_.joint_of(static_cast<int>(holder)) < 0) holder = static_cast<size_t>(nodes_.parents[holder]);
    const Affine back = inverse(nodes_.worlds[holder]).value_or(kIdentity);
    const size_t count = points.rows.size();
    return bound(multiply(multiply(skeleton_.bind(joint), back), nodes_.worlds[node]), 1,
                 std::vector<int>(count, joint), std::vector<double>(count, 1.0));
  }

  std::string bound_materials(const ControlPoints& points) const {
    const auto binding = [&](const std::string& in, int material) {
      const std::string path = materials_.path_of(material);
      return path.empty() ? path : in + "rel material:binding = " + path + "\n";
    };
    if (points.materials.size() == 1) return binding(kIn, points.materials[0]);
    std::string out = std::string(kIn) + "uniform token subsetFamily:materialBind:familyType = \"partition\"\n";
    for (size_t m = 0; m < points.materials.size(); ++m) {
      std::vector<int> faces;
      for (size_t f = 0; f < points.polygon_materials.size(); ++f)
        if (points.polygon_materials[f] == static_cast<int32_t>(m)) faces.push_back(static_cast<int>(f));
      const std::string in = std::string(kIn) + "    ";
      out += "\n" + (kIn + ("def GeomSubset \"part_" + std::to_string(m))) + "\" (\n" + in +
             "prepend apiSchemas = [\"MaterialBindingAPI\"]\n" + kIn + ")\n" + kIn + "{\n" + in +
             "uniform token elementType = \"face\"\n" + in + "uniform token familyName = \"materialBind\"\n" + in +
             "int[] indices = " + usd_list(faces) + "\n" + binding(in, points.materials[m]) + kIn + "}\n";
    }
    return out;
  }

  std::string shapes(const ControlPoints& points, size_t node, const std::string& mesh) {
    if (points.shapes.empty()) return "";
    std::vector<std::string> tokens;
    std::string targets, prims;
    std::set<std::string> taken;
    for (size_t s = 0; s < points.shapes.size(); ++s) {
      const ControlShape& shape = points.shapes[s];
      const std::string prim = usd_free_name("shape_" + shape.name, &taken), in = std::string(kIn) + "    ";
      tokens.push_back(token(shape.name, skeleton_.shape_curve(node, s, points.shapes.size(), shape.weight), tokens));
      targets += (targets.empty() ? "<" : ", <") + mesh + "/" + prim + ">";
      prims += "\n" + (kIn + ("def BlendShape \"" + prim)) + "\"\n" + kIn + "{\n" + in +
               "uniform vector3f[] offsets = " + usd_tuples(shape.moves, 3) + "\n" + in +
               "uniform vector3f[] normalOffsets = " + usd_tuples(shape.normals, 3) + "\n" + in +
               "uniform int[] pointIndices = " + usd_list(shape.points) + "\n" + kIn + "}\n";
    }
    return kIn + ("uniform token[] skel:blendShapes = " + usd_tokens(tokens)) + "\n" + kIn +
           "rel skel:blendShapeTargets = [" + targets + "]\n" + prims;
  }

  // Animations name shapes: those of one name that go alike on several meshes share one.
  //   of_mesh  what the shapes before it on the same mesh are called
  std::string token(const std::string& name, const std::vector<double>& curve,
                    const std::vector<std::string>& of_mesh) {
    std::string out = name;
    const auto fits = [&] {
      return std::find(of_mesh.begin(), of_mesh.end(), out) == of_mesh.end() &&
             (curves_.try_emplace(out, curve).second || curves_.at(out) == curve);
    };
    for (size_t number = 2; !fits(); ++number) out = name + "_" + std::to_string(number);
    return out;
  }

  std::vector<UsdShape> moving_shapes() const {
    std::vector<UsdShape> moving;
    for (const auto& [token, curve] : curves_)
      if (std::any_of(curve.begin(), curve.end(), [](double weight) { return weight != 0; }))
        moving.push_back({token, curve});
    return moving;
  }

  const std::string path_;
  const tinygltf::Model& model_;
  const GltfNodes nodes_;
  const UsdSkeleton skeleton_;
  UsdMaterials materials_;
  std::set<std::string> prims_ = {"Skeleton", "Materials"};
  std::map<std::string, std::vector<double>> curves_;  // by the name that animations call a shape
};

}  // namespace

std::vector<NamedBytes> usd_of(const std::string& path, const tinygltf::Model& model) {
  return UsdWriter(path, model).write();
}

}  // namespace sinew
