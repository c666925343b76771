// SPDX-License-Identifier: MIT
#include "usd/usd_rig.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gltf/matrix_columns.hpp"
#include "gltf/node_parts.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"
#include "usd/usd_transform.hpp"

namespace sinew {
namespace {

// Translation, rotation and scale, which animations change; a matrix where these cannot say it.
void put(const Affine& local, Json* node) {
  if (local == kIdentity) return;
  const NodeParts parts = parts_of(local, NodeParts());
  const Affine again = parts.affine();
  double size = 1e-12, apart = 0;
  for (size_t i = 0; i < 12; ++i)
    size = std::max(size, std::abs(local[i])), apart = std::max(apart, std::abs(local[i] - again[i]));
  if (!(apart <= 1e-5 * size)) {
    (*node)["matrix"] = columns_of(local);
    return;
  }
  if (parts.translation != Point3{0, 0, 0}) (*node)["translation"] = parts.translation;
  if (parts.rotation != kNoRotation4) (*node)["rotation"] = parts.rotation;
  bool even = true;
  for (const double scale : parts.scale) even = even && std::abs(scale - 1) < 1e-9;
  if (!even) (*node)["scale"] = parts.scale;
}

std::vector<int> parents_of(const std::vector<std::string>& joints) {
  std::map<std::string, int> numbers;
  for (size_t j = 0; j < joints.size(); ++j) numbers.emplace(joints[j], static_cast<int>(j));
  std::vector<int> parents;
  for (std::string up : joints) {
    int parent = -1;
    for (size_t end; parent < 0 && (end = up.rfind('/')) != std::string::npos;) {
      up.resize(end);
      if (const auto at = numbers.find(up); at != numbers.end()) parent = at->second;
    }
    parents.push_back(parent);
  }
  return parents;
}

UsdRig rig_of(const UsdStage& stage, size_t place) {
  const UsdPrim& prim = *stage.places[place].prim;
  const std::string where = stage.where(prim);
  UsdRig rig;
  rig.place = place;
  if (const UsdValue* joints = find_value(prim, "joints")) rig.joints = joints->texts;
  rig.parents = parents_of(rig.joints);
  const size_t count = rig.joints.size();
  const UsdValue *binds = find_value(prim, "bindTransforms"), *rests = find_value(prim, "restTransforms");
  if (binds != nullptr) rig.binds = usd_affines(where + ", bindTransforms", *binds, count);
  if (rests != nullptr) rig.rests = usd_affines(where + ", restTransforms", *rests, count);
  if (count > 0 && binds == nullptr && rests == nullptr)
    throw Error(where + ": expected bindTransforms of its joints, found none");
  if (binds == nullptr) {
    rig.binds.assign(count, kIdentity);
    for (size_t j = 0; j < count; ++j) {
      Affine world = rig.rests[j];
      for (int up = rig.parents[j]; up >= 0; up = rig.parents[static_cast<size_t>(up)])
        world = multiply(rig.rests[static_cast<size_t>(up)], world);
      rig.binds[j] = world;
    }
  }
  for (size_t j = 0; j < count; ++j) {
    const std::optional<Affine> back = inverse(rig.binds[j]);
    if (!back)
      throw Error(where + ": expected bind transforms with an inverse, found another at joint " +
                  in_quotes(rig.joints[j]));
  }
  for (size_t j = 0; j < count && rests == nullptr; ++j) {
    const int parent = rig.parents[j];
    rig.rests.push_back(parent < 0 ? rig.binds[j]
                                   : multiply(*inverse(rig.binds[static_cast<size_t>(parent)]), rig.binds[j]));
  }
  return rig;
}

void add_joints(UsdRig* rig, UsdStage* stage) {
  const UsdPlace& place = stage->places[rig->place];
  const UsdValue* names = find_value(*place.prim, "jointNames");
  const bool named = names != nullptr && names->texts.size() == rig->joints.size();
  const size_t first = stage->document()["nodes"].size();
  for (size_t j = 0; j < rig->joints.size(); ++j) {
    const std::string& path = rig->joints[j];
    const std::string name = named ? names->texts[j] : path.substr(path.rfind('/') + 1);  // npos + 1 is 0
    Json node = {{"name", name}};
    put(rig->rests[j], &node);
    rig->nodes.push_back(first + j);
    stage->document()["nodes"].push_back(std::move(node));
  }
  std::vector<size_t> roots;
  for (size_t j = 0; j < rig->joints.size(); ++j) {
    if (rig->parents[j] < 0)
      roots.push_back(rig->nodes[j]);
    else
      stage->document()["nodes"][rig->nodes[static_cast<size_t>(rig->parents[j])]]["children"].push_back(rig->nodes[j]);
  }
  const Affine world = multiply(stage->to_metres, place.world);
  if (world == kIdentity) {
    stage->roots.insert(stage->roots.end(), roots.begin(), roots.end());
    return;
  }
  Json node = {{"name", UsdStage::name_of(*place.prim)}, {"children", roots}};
  put(world, &node);
  stage->roots.push_back(stage->document()["nodes"].size());
  stage->document()["nodes"].push_back(std::move(node));
}

// One attribute of a SkelAnimation: rows of values by time.
struct Rows {
  std::vector<double> times;  // seconds from the first key of the animation
  std::vector<const std::vector<double>*> values;
};

class Animation {
 public:
  Animation(const UsdPrim& prim, UsdStage* stage) : prim_(prim), stage_(*stage), where_(stage->where(prim)) {
    json_ = {{"name", UsdStage::name_of(prim)}, {"channels", Json::array()}, {"samplers", Json::array()}};
    bool any = false;
    for (const char* name : {"translations", "rotations", "scales", "blendShapeWeights"}) {
      const UsdProperty* property = find_property(prim, name);
      if (property == nullptr || property->samples.empty()) continue;
      const double begin = property->samples.begin()->first;
      start_ = any ? std::min(start_, begin) : begin;
      any = true;
    }
  }

  void add(const UsdRig* rig, const std::vector<UsdShapes>& shapes) {
    if (rig != nullptr) add_joints(*rig);
    add_shapes(shapes);
    if (json_["channels"].empty()) {
      stage_.out.notes.push_back("animation " + in_quotes(json_["name"].get<std::string>()) +
                                 " moves no joint and was left out");
      return;
    }
    stage_.document()["animations"].push_back(std::move(json_));
  }

 private:
  Rows rows(const char* name, size_t width) const {
    Rows rows;
    const UsdProperty* property = find_property(prim_, name);
    if (property == nullptr) return rows;
    for (const auto& [time, value] : property->samples) {
      rows.times.push_back((time - start_) / stage_.time_codes);
      rows.values.push_back(&value.numbers);
    }
    if (rows.times.empty() && property->has_value) rows = {{0}, {&property->value.numbers}};
    for (const std::vector<double>* row : rows.values) {
      if (row->size() != width)
        throw Error(where_ + ": expected " + std::to_string(width) + " numbers in " + name + ", found " +
                    std::to_string(row->size()));
      for (const double number : *row)
        if (!std::isfinite(static_cast<float>(number)))
          throw Error(where_ + ": expected finite numbers in " + name + ", found another");
    }
    return rows;
  }

  void add_joints(const UsdRig& rig) {
    const UsdValue* joints = find_value(prim_, "joints");
    if (joints == nullptr) return;
    const size_t count = joints->texts.size();
    const Rows moves = rows("translations", 3 * count), turns = rows("rotations", 4 * count),
               sizes = rows("scales", 3 * count);
    for (size_t i = 0; i < count; ++i) {
      const int joint = rig.joint_of(joints->texts[i]);
      if (joint < 0) continue;
      const size_t node = rig.nodes[static_cast<size_t>(joint)];
      const size_t before = json_["channels"].size();
      const NodeParts rest = parts_of(rig.rests[static_cast<size_t>(joint)], NodeParts());
      add_track(moves, node, "translation", 3 * i, {0, 1, 2},
                {rest.translation[0], rest.translation[1], rest.translation[2]});
      add_track(turns, node, "rotation", 4 * i, {1, 2, 3, 0}, {});
      add_track(sizes, node, "scale", 3 * i, {0, 1, 2}, {rest.scale[0], rest.scale[1], rest.scale[2]});
      // glTF lets no animation touch a node that has a matrix.
      Json& json = stage_.document()["nodes"][node];
      if (json_["channels"].size() > before && json.contains("matrix")) {
        json.erase("matrix");
        json["translation"] = rest.translation, json["rotation"] = rest.rotation, json["scale"] = rest.scale;
      }
    }
  }

  //   rest  what needs no track where it stands still there
  void add_track(const Rows& rows, size_t node, const char* what, size_t at, const std::vector<size_t>& order,
                 const std::vector<double>& rest) {
    std::vector<float> values;
    for (const std::vector<double>* row : rows.values) {
      std::vector<double> value;
      for (const size_t i : order) value.push_back((*row)[at + i]);
      if (order.size() == 4) {
        const Quaternion q = normalised({value[0], value[1], value[2], value[3]});
        value.assign(q.begin(), q.end());
      }
      for (const double number : value) values.push_back(static_cast<float>(number));
    }
    bool still = true;
    for (size_t k = 0; k < values.size(); ++k) still = still && values[k] == values[k % order.size()];
    if (still && !rest.empty() && !values.empty()) {
      double apart = 0;
      for (size_t i = 0; i < rest.size(); ++i)
        apart = std::max(apart, std::abs(rest[i] - static_cast<double>(values[i])));
      if (apart < 1e-6) return;
    }
    add_channel(rows.times, values, still ? 1 : rows.times.size(), order.size(), node, what);
  }

  void add_channel(const std::vector<double>& seconds, const std::vector<float>& values, size_t keys, size_t width,
                   size_t node, const char* what) {
    if (seconds.empty()) return;
    std::vector<float> times, kept;
    for (size_t k = 0; k < keys; ++k) {
      const float time = static_cast<float>(seconds[k]);
      if (!std::isfinite(time) || (!times.empty() && !(time > times.back()))) continue;
      times.push_back(time);
      kept.insert(kept.end(), values.begin() + static_cast<std::ptrdiff_t>(k * width),
                  values.begin() + static_cast<std::ptrdiff_t>((k + 1) * width));
    }
    if (times.empty()) return;
    const int input = add_vectors(times, 1, false, true, &stage_);
    const bool weights = std::string(what) == "weights";
    const int output = add_vectors(kept, weights ? 1 : width, false, false, &stage_);
    json_["channels"].push_back({{"sampler", json_["samplers"].size()}, {"target", {{"node", node}, {"path", what}}}});
    json_["samplers"].push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
  }

  void add_shapes(const std::vector<UsdShapes>& shapes) {
    const UsdValue* tokens = find_value(prim_, "blendShapes");
    if (tokens == nullptr || tokens->texts.empty()) return;
    const Rows weights = rows("blendShapeWeights", tokens->texts.size());
    for (const UsdShapes& mesh : shapes) {
      std::vector<size_t> from;
      bool moves = false;
      for (const std::string& token : mesh.tokens) {
        from.push_back(
            static_cast<size_t>(std::find(tokens->texts.begin(), tokens->texts.end(), token) - tokens->texts.begin()));
        moves = moves || from.back() < tokens->texts.size();
      }
      if (!moves) continue;
      std::vector<float> values;
      for (const std::vector<double>* row : weights.values)
        for (const size_t i : from) values.push_back(i < row->size() ? static_cast<float>((*row)[i]) : 0.0f);
      add_channel(weights.times, values, weights.times.size(), from.size(), mesh.node, "weights");
    }
  }

  const UsdPrim& prim_;
  UsdStage& stage_;
  const std::string where_;
  double start_ = 0;
  Json json_;
};

}  // namespace

int UsdRig::joint_of(const std::string& path) const {
  const auto at = std::find(joints.begin(), joints.end(), path);
  return at == joints.end() ? -1 : static_cast<int>(at - joints.begin());
}

std::vector<UsdRig> add_usd_rigs(UsdStage* stage) {
  std::vector<UsdRig> rigs;
  for (size_t p = 0; p < stage->places.size(); ++p) {
    if (stage->places[p].prim->type != "Skeleton") continue;
    UsdRig rig = rig_of(*stage, p);
    if (rig.joints.empty()) continue;
    add_joints(&rig, stage);
    rigs.push_back(std::move(rig));
  }
  return rigs;
}

size_t add_usd_skin(const UsdRig& rig, const Affine& frame, UsdStage* stage) {
  std::vector<float> values;
  for (const Affine& bind : rig.binds) {
    const std::vector<float> columns = columns_of(multiply(*inverse(bind), frame));
    values.insert(values.end(), columns.begin(), columns.end());
  }
  const int accessor = add_accessor(&stage->out, values.data(), values.size() * sizeof(float), "MAT4",
                                    TINYGLTF_COMPONENT_TYPE_FLOAT, rig.binds.size(), false, false);
  stage->document()["skins"].push_back({{"joints", rig.nodes}, {"inverseBindMatrices", accessor}});
  return stage->document()["skins"].size() - 1;
}

void add_usd_animations(const std::vector<UsdRig>& rigs, const std::vector<UsdShapes>& shapes, UsdStage* stage) {
  std::map<std::string, const UsdRig*> bound;  // by the animation's path
  for (size_t p = 0; p < stage->places.size(); ++p) {
    const UsdProperty* source = find_property(*stage->places[p].prim, "skel:animationSource");
    if (source == nullptr || source->targets.empty()) continue;
    for (const UsdRig& rig : rigs)
      for (int up = static_cast<int>(rig.place); up >= 0; up = stage->places[static_cast<size_t>(up)].parent)
        if (up == static_cast<int>(p)) bound.emplace(source->targets[0], &rig);
  }
  for (const UsdPlace& place : stage->places) {
    if (place.prim->type != "SkelAnimation") continue;
    const UsdRig* rig = nullptr;
    if (const auto at = bound.find(place.prim->path); at != bound.end()) rig = at->second;
    const UsdValue* joints = find_value(*place.prim, "joints");
    for (const UsdRig& one : rigs)
      if (rig == nullptr && joints != nullptr && !joints->texts.empty() && one.joint_of(joints->texts[0]) >= 0)
        rig = &one;
    Animation(*place.prim, stage).add(rig, shapes);
  }
}

}  // namespace sinew
