// SPDX-License-Identifier: MIT
// Counts what a glTF document holds and compares its rest with its bind pose.
#include "sinew_formats/gltf_summary.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

double distance(const Point3& a, const Point3& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

Point3 moved(const Affine& m, const Point3& p) { return transform_point(m, p[0], p[1], p[2]); }

std::string numbered(const std::string& name, const char* kind, size_t index) {
  return name.empty() ? std::string(kind) + "_" + std::to_string(index) : name;
}

// The vertices of a skin with the joints that have weight on each.
struct SkinVertices {
  std::vector<Point3> points;  // in the mesh's space
  std::vector<std::vector<uint32_t>> joints;
};

class Summarizer {
 public:
  explicit Summarizer(const std::string& path)
      : path_(path), source_(load_gltf(path, read_file(path))), nodes_(gltf_nodes(path, source_.model)) {}

  GltfSummary summarize() {
    summary_.generator = model().asset.generator;
    summary_.nodes = model().nodes.size();
    summary_.extensions_used = model().extensionsUsed;
    summary_.extensions_required = model().extensionsRequired;
    for (size_t m = 0; m < model().materials.size(); ++m)
      summary_.materials.push_back(numbered(model().materials[m].name, "material", m));
    for (size_t s = 0; s < model().skins.size(); ++s) check_skin(s);
    add_meshes();
    for (size_t s = 0; s < model().skins.size(); ++s) summary_.skins.push_back(skin(s));
    add_images();
    add_animations();
    return std::move(summary_);
  }

 private:
  const tinygltf::Model& model() const { return source_.model; }

  std::string skin_name(size_t s) const {
    return path_ + ": skin " + std::to_string(s) + " " + in_quotes(model().skins[s].name);
  }

  void check_skin(size_t s) const {
    for (const int joint : model().skins[s].joints) {
      if (joint < 0 || static_cast<size_t>(joint) >= model().nodes.size())
        throw Error(skin_name(s) + ": expected joints below " + std::to_string(model().nodes.size()) + ", found " +
                    std::to_string(joint));
    }
  }

  bool is_joint(int node) const {
    return std::any_of(model().skins.begin(), model().skins.end(), [node](const tinygltf::Skin& one) {
      return std::find(one.joints.begin(), one.joints.end(), node) != one.joints.end();
    });
  }

  std::string node_name(int node) const {
    return numbered(model().nodes[static_cast<size_t>(node)].name, "node", static_cast<size_t>(node));
  }

  size_t count_of(int accessor) const {
    return accessor >= 0 && static_cast<size_t>(accessor) < model().accessors.size()
               ? model().accessors[static_cast<size_t>(accessor)].count
               : 0;
  }

  GltfMeshSummary mesh(size_t index) const {
    const tinygltf::Mesh& from = model().meshes[index];
    GltfMeshSummary out;
    out.name = numbered(from.name, "mesh", index);
    out.primitives = from.primitives.size();
    size_t targets = 0;
    for (const tinygltf::Primitive& primitive : from.primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (position != primitive.attributes.end()) out.vertices += count_of(position->second);
      targets = std::max(targets, primitive.targets.size());
    }
    for (size_t t = 0; t < targets; ++t) out.morph_targets.push_back(target_name(index, t));
    return out;
  }

  // Exporters leave the names in the mesh's extras.
  std::string target_name(size_t mesh_index, size_t target) const {
    const Json& json = source_.document["meshes"][mesh_index];
    const Json names = json.value("extras", Json::object()).is_object()
                           ? json.value("extras", Json::object()).value("targetNames", Json::array())
                           : Json::array();
    const bool named = names.is_array() && target < names.size() && names[target].is_string();
    return named ? names[target].get<std::string>() : "target_" + std::to_string(target);
  }

  void add_meshes() {
    std::vector<char> shown(model().meshes.size(), 0);
    for (size_t n = 0; n < model().nodes.size(); ++n) {
      const tinygltf::Node& node = model().nodes[n];
      if (node.mesh < 0) continue;
      if (static_cast<size_t>(node.mesh) >= model().meshes.size() ||
          (node.skin >= 0 && static_cast<size_t>(node.skin) >= model().skins.size()))
        throw Error(path_ + ": node " + std::to_string(n) + " " + in_quotes(node.name) +
                    ": expected a mesh and a skin of the file, found numbers beyond them");
      shown[static_cast<size_t>(node.mesh)] = 1;
      GltfMeshSummary out = mesh(static_cast<size_t>(node.mesh));
      out.node = node_name(static_cast<int>(n));
      out.in_scene = nodes_.in_scene[n] != 0;
      out.skin = node.skin;
      if (node.skin < 0) {
        int above = static_cast<int>(n);
        while (above >= 0 && !is_joint(above)) above = nodes_.parents[static_cast<size_t>(above)];
        if (above >= 0) out.joint = node_name(above);
      }
      summary_.meshes.push_back(std::move(out));
    }
    for (size_t m = 0; m < shown.size(); ++m)
      if (shown[m] == 0) summary_.meshes.push_back(mesh(m));
  }

  SkinVertices vertices_of(size_t s) const {
    SkinVertices out;
    for (size_t n = 0; n < model().nodes.size(); ++n) {
      const tinygltf::Node& node = model().nodes[n];
      if (node.skin != static_cast<int>(s) || node.mesh < 0 || nodes_.in_scene[n] == 0) continue;
      for (const tinygltf::Primitive& primitive : model().meshes[static_cast<size_t>(node.mesh)].primitives)
        add_vertices(path_ + ": mesh " + std::to_string(node.mesh), primitive, model().skins[s].joints.size(), &out);
    }
    return out;
  }

  void add_vertices(const std::string& where, const tinygltf::Primitive& primitive, size_t joint_count,
                    SkinVertices* out) const {
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return;
    const std::vector<float> positions = accessor_floats(where, model(), position->second, 3);
    const size_t first = out->points.size(), count = positions.size() / 3;
    for (size_t v = 0; v < count; ++v)
      out->points.push_back({static_cast<double>(positions[v * 3]), static_cast<double>(positions[v * 3 + 1]),
                             static_cast<double>(positions[v * 3 + 2])});
    out->joints.resize(out->points.size());
    for (int set = 0;; ++set) {
      const auto joints_at = primitive.attributes.find("JOINTS_" + std::to_string(set));
      const auto weights_at = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (joints_at == primitive.attributes.end() || weights_at == primitive.attributes.end()) return;
      const std::vector<uint32_t> joints = accessor_integers(where, model(), joints_at->second, 4);
      const std::vector<float> weights = accessor_floats(where, model(), weights_at->second, 4);
      for (size_t i = 0; i < std::min({joints.size(), weights.size(), count * 4}); ++i)
        if (weights[i] > 0 && joints[i] < joint_count) out->joints[first + i / 4].push_back(joints[i]);
    }
  }

  GltfSkinSummary skin(size_t s) const {
    const tinygltf::Skin& from = model().skins[s];
    GltfSkinSummary out;
    out.name = numbered(from.name, "skin", s);
    out.joints = from.joints.size();
    for (const GltfMeshSummary& one : summary_.meshes)
      out.meshes += one.skin == static_cast<int>(s) && one.in_scene ? 1 : 0;
    const SkinVertices vertices = vertices_of(s);
    std::vector<char> has_weight(out.joints, 0);
    for (const std::vector<uint32_t>& row : vertices.joints)
      for (const uint32_t joint : row) has_weight[joint] = 1;
    out.joints_with_weight = static_cast<size_t>(std::count(has_weight.begin(), has_weight.end(), 1));
    if (!vertices.points.empty() && out.joints > 0) compare_poses(s, vertices, has_weight, &out);
    return out;
  }

  void compare_poses(size_t s, const SkinVertices& vertices, const std::vector<char>& has_weight,
                     GltfSkinSummary* out) const {
    const std::vector<Affine> binds = inverse_bind_matrices(skin_name(s), model(), model().skins[s]);
    const std::vector<Affine> palette = skin_palette(skin_name(s), model(), nodes_, static_cast<int>(s));
    const double mesh_size = longest_side(vertices.points, kIdentity);
    const Affine& common = palette[most_agreed(palette, mesh_size)];
    const double size = longest_side(vertices.points, common);
    if (!(size > 0)) return;
    std::vector<double> apart(binds.size(), 0);
    for (size_t j = 0; j < binds.size(); ++j) {
      const std::optional<Affine> bind = inverse(binds[j]);
      if (has_weight[j] == 0 && bind) apart[j] = difference(palette[j], common, {(*bind)[3], (*bind)[7], (*bind)[11]});
    }
    for (size_t v = 0; v < vertices.points.size(); ++v)
      for (const uint32_t j : vertices.joints[v])
        apart[j] = std::max(apart[j], difference(palette[j], common, vertices.points[v]));
    for (size_t j = 0; j < apart.size(); ++j) {
      apart[j] /= size;
      out->joints_apart += apart[j] > kGltfPoseTolerance ? 1 : 0;
      if (apart[j] <= out->deviation) continue;
      out->deviation = apart[j];
      out->farthest = node_name(model().skins[s].joints[j]);
    }
  }

  static double difference(const Affine& a, const Affine& b, const Point3& p) {
    return distance(moved(a, p), moved(b, p));
  }

  static double longest_side(const std::vector<Point3>& points, const Affine& m) {
    Point3 low = moved(m, points[0]), high = low;
    for (const Point3& point : points) {
      const Point3 p = moved(m, point);
      for (size_t c = 0; c < 3; ++c) {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }

  // The joint whose matrix most others share; the first of equals. A handful of candidates is enough: where none of
  // them has followers, the file was saved in a pose.
  static size_t most_agreed(const std::vector<Affine>& palette, double size) {
    constexpr size_t kCandidates = 64;
    const Point3 corners[] = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    size_t best = 0, most = 0;
    for (size_t c = 0; c < palette.size() && c < kCandidates; ++c) {
      size_t followers = 0;
      const double scale = std::max(distance(moved(palette[c], corners[0]), moved(palette[c], corners[1])), 1e-30);
      for (const Affine& other : palette) {
        double largest = 0;
        for (const Point3& corner : corners) largest = std::max(largest, difference(palette[c], other, corner));
        followers += largest <= kGltfPoseTolerance * scale ? 1 : 0;
      }
      if (followers > most) {
        most = followers;
        best = c;
      }
    }
    return best;
  }

  void add_images() {
    for (size_t i = 0; i < model().images.size(); ++i) {
      const tinygltf::Image& image = model().images[i];
      const std::string file = image.uri.rfind("data:", 0) == 0 ? "" : image.uri;
      summary_.images.push_back({numbered(image.name.empty() ? file : image.name, "image", i), image.image.size()});
    }
  }

  void add_animations() {
    for (size_t a = 0; a < model().animations.size(); ++a) {
      const tinygltf::Animation& animation = model().animations[a];
      GltfAnimationSummary out;
      out.name = numbered(animation.name, "animation", a);
      out.channels = animation.channels.size();
      const std::string where = path_ + ": animation " + std::to_string(a);
      for (const tinygltf::AnimationSampler& sampler : animation.samplers)
        for (const float seconds : accessor_floats(where, model(), sampler.input, 1))
          out.seconds = std::max(out.seconds, static_cast<double>(seconds));
      summary_.animations.push_back(std::move(out));
    }
  }

  const std::string path_;
  const GltfSource source_;
  const GltfNodes nodes_;
  GltfSummary summary_;
};

}  // namespace

GltfSummary summarize_gltf(const std::string& path) { return Summarizer(path).summarize(); }

}  // namespace sinew
