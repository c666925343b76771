// SPDX-License-Identifier: MIT
// IQM (Inter-Quake Model, version 2) to glTF: meshes, joints, weights and animations. Z is up there; materials are names alone.
// Source: the format's own description, lsalzman/iqm, iqm.txt.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_from_scene.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr size_t kHeaderBytes = 124, kMeshBytes = 24, kArrayBytes = 20, kTriangleBytes = 12, kJointBytes = 48,
                 kPoseBytes = 88, kAnimationBytes = 20;
constexpr double kIqmFps = 30;  // where an animation says 0

// Places of the header's numbers.
enum Header : size_t {
  kVersion = 16,
  kTextCount = 28,
  kText = 32,
  kMeshCount = 36,
  kMeshes = 40,
  kArrayCount = 44,
  kVertexCount = 48,
  kArrays = 52,
  kTriangleCount = 56,
  kTriangles = 60,
  kJointCount = 68,
  kJoints = 72,
  kPoseCount = 76,
  kPoses = 80,
  kAnimationCount = 84,
  kAnimations = 88,
  kFrameCount = 92,
  kChannelCount = 96,
  kFrames = 100
};
// Contents and number type of a vertex array.
enum ArrayType : uint32_t { kPosition = 0, kTexcoord = 1, kNormal = 2, kBlendIndices = 4, kBlendWeights = 5 };
enum NumberFormat : uint32_t { kUnsignedByte = 1, kUnsignedInt = 5, kFloat = 7 };

// Translation, rotation and scale of a joint, as the file has them: x y z, x y z w, x y z.
using Channels = std::array<double, 10>;

Affine affine_of(const Channels& c) {
  const Rotation r = rotation_of(normalized({c[3], c[4], c[5], c[6]}));
  Affine m{};
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) m[4 * row + column] = r[3 * row + column] * c[7 + column];
    m[4 * row + 3] = c[row];
  }
  return m;
}

class IqmConverter {
 public:
  IqmConverter(const std::string& path, const std::vector<uint8_t>& bytes) : path_(path), bytes_(bytes) {}

  std::vector<uint8_t> convert(std::vector<std::string>* notes) {
    check_header();
    document() = {{"asset", {{"version", "2.0"}, {"generator", "sinew"}}}, {"scene", 0}};
    const double half = std::sqrt(0.5);  // z up to y up
    document()["nodes"] = {{{"name", "iqm"}, {"rotation", {-half, 0, 0, half}}}};
    read_joints();
    read_meshes();
    document()["scenes"] = {{{"nodes", roots_}}};
    for (size_t a = 0; a < number(kAnimationCount); ++a) read_animation(number(kAnimations) + a * kAnimationBytes);
    *notes = std::move(source_.notes);
    return pack_glb(path_, &document(), std::move(source_.bytes));
  }

 private:
  Json& document() { return source_.document; }
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(path_ + ": expected " + expected + ", found " + found);
  }
  template <class T>
  T at(size_t place) const {
    T value;
    std::memcpy(&value, &bytes_[place], sizeof value);
    return value;
  }
  size_t number(size_t place) const { return at<uint32_t>(place); }
  double real(size_t place, const char* what) const {
    const float value = at<float>(place);
    if (!std::isfinite(value))
      fail(std::string("finite numbers of ") + what, "another at byte " + std::to_string(place));
    return static_cast<double>(value);
  }
  void need(size_t place, size_t count, size_t size, const char* what) const {
    if (place <= bytes_.size() && (size == 0 || count <= (bytes_.size() - place) / size)) return;
    throw Error(path_ + ": truncated IQM, expected " + std::to_string(count) + " " + what + " at byte " +
                std::to_string(place) + ", found " + std::to_string(bytes_.size()) + " bytes");
  }
  std::string text(size_t offset) const {
    const size_t begin = number(kText) + std::min(offset, number(kTextCount));
    const size_t end = number(kText) + number(kTextCount);
    std::string out;
    for (size_t i = begin; i < end && bytes_[i] != 0; ++i) out += static_cast<char>(bytes_[i]);
    return out;
  }

  void check_header() const {
    if (bytes_.size() < kHeaderBytes || std::memcmp(bytes_.data(), "INTERQUAKEMODEL", 16) != 0)
      fail("an IQM (INTERQUAKEMODEL)", "other bytes");
    if (number(kVersion) != 2) fail("version 2 of IQM", "version " + std::to_string(number(kVersion)));
    need(number(kText), number(kTextCount), 1, "letters");
    need(number(kMeshes), number(kMeshCount), kMeshBytes, "meshes");
    need(number(kArrays), number(kArrayCount), kArrayBytes, "vertex arrays");
    need(number(kTriangles), number(kTriangleCount), kTriangleBytes, "triangles");
    need(number(kJoints), number(kJointCount), kJointBytes, "joints");
    need(number(kPoses), number(kPoseCount), kPoseBytes, "poses");
    need(number(kAnimations), number(kAnimationCount), kAnimationBytes, "animations");
    need(number(kFrames), number(kFrameCount), 2 * number(kChannelCount), "frames");
    if (number(kFrameCount) > kMostRotations / std::max<size_t>(1, number(kPoseCount)))
      fail("at most " + std::to_string(kMostRotations) + " frames times joints",
           std::to_string(number(kFrameCount)) + " frames");
    if (number(kPoseCount) != 0 && number(kPoseCount) != number(kJointCount))
      fail("poses of all " + std::to_string(number(kJointCount)) + " joints", std::to_string(number(kPoseCount)));
  }

  // Joint j is node j + 1.
  void read_joints() {
    std::vector<Affine> worlds;
    std::vector<float> binds;
    Json joints = Json::array();
    for (size_t j = 0; j < number(kJointCount); ++j) {
      const size_t place = number(kJoints) + j * kJointBytes;
      const int32_t parent = at<int32_t>(place + 4);
      if (parent >= static_cast<int32_t>(j))
        fail("parents before joints", "joint " + std::to_string(j) + " above itself");
      Channels& rest = rests_.emplace_back();
      for (size_t c = 0; c < rest.size(); ++c) rest[c] = real(place + 8 + 4 * c, "joints");
      const Affine local = affine_of(rest);
      worlds.push_back(parent < 0 ? local : multiply(worlds[static_cast<size_t>(parent)], local));
      const std::optional<Affine> back = inverse(worlds.back());
      if (!back) fail("joints with a scale other than 0", "joint " + in_quotes(text(number(place))));
      append_columns(*back, &binds);
      const Quaternion rotation = normalized({rest[3], rest[4], rest[5], rest[6]});
      document()["nodes"].push_back({{"name", text(number(place))},
                                     {"translation", {rest[0], rest[1], rest[2]}},
                                     {"rotation", rotation},
                                     {"scale", {rest[7], rest[8], rest[9]}}});
      document()["nodes"][parent < 0 ? 0 : static_cast<size_t>(parent) + 1]["children"].push_back(j + 1);
      joints.push_back(j + 1);
    }
    if (joints.empty()) return;
    const int accessor = add_accessor(&source_, binds.data(), binds.size() * 4, "MAT4", TINYGLTF_COMPONENT_TYPE_FLOAT,
                                      joints.size(), false, false);
    document()["skins"] = {{{"joints", joints}, {"inverseBindMatrices", accessor}}};
  }

  // An array of `width` numbers a vertex, of vertices `first` and on; empty where the file has none. Bytes of weights become parts of 1.
  std::vector<float> vertex_array(ArrayType type, size_t width, size_t first, size_t count) const {
    for (size_t a = 0; a < number(kArrayCount); ++a) {
      const size_t place = number(kArrays) + a * kArrayBytes;
      const size_t format = number(place + 8), stride = number(place + 12), begin = number(place + 16);
      if (number(place) != type) continue;
      const size_t bytes = format == kUnsignedByte ? 1 : format == kFloat || format == kUnsignedInt ? 4 : 0;
      if (bytes == 0 || stride < width)
        fail("vertices as bytes, integers or floats",
             "format " + std::to_string(format) + " of " + std::to_string(stride));
      need(begin, number(kVertexCount), stride * bytes, "vertices");
      std::vector<float> values;
      for (size_t v = first; v < first + count; ++v)
        for (size_t i = 0; i < width; ++i) {
          const size_t own = begin + (v * stride + i) * bytes;
          const double value = bytes == 1         ? static_cast<double>(bytes_[own])
                               : format == kFloat ? real(own, "vertices")
                                                  : static_cast<double>(number(own));
          values.push_back(static_cast<float>(type == kBlendWeights && bytes == 1 ? value / 255 : value));
        }
      return values;
    }
    return {};
  }

  void read_meshes() {
    roots_ = {0};
    Json primitives = Json::array();
    for (size_t m = 0; m < number(kMeshCount); ++m) {
      const size_t place = number(kMeshes) + m * kMeshBytes;
      const size_t first = number(place + 8), count = number(place + 12), first_triangle = number(place + 16),
                   triangles = number(place + 20);
      if (first > number(kVertexCount) || count > number(kVertexCount) - first ||
          first_triangle > number(kTriangleCount) || triangles > number(kTriangleCount) - first_triangle)
        fail("meshes within the file's vertices and triangles", "mesh " + in_quotes(text(number(place))));
      if (count == 0 || triangles == 0) continue;
      Json primitive = {{"attributes", attributes_of(first, count)}};
      std::vector<uint32_t> indices;
      for (size_t t = first_triangle; t < first_triangle + triangles; ++t)
        for (const size_t corner : {2, 1, 0}) {  // to the other side's order
          const size_t v = number(number(kTriangles) + t * kTriangleBytes + 4 * corner);
          if (v < first || v >= first + count)
            fail("triangles within their mesh's vertices",
                 "vertex " + std::to_string(v) + " in triangle " + std::to_string(t));
          indices.push_back(static_cast<uint32_t>(v - first));
        }
      primitive["indices"] = add_accessor(&source_, indices.data(), indices.size() * 4, "SCALAR",
                                          TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, indices.size(), false, false);
      primitive["material"] = document().contains("materials") ? document()["materials"].size() : 0;
      document()["materials"].push_back({{"name", text(number(place + 4))}});
      primitives.push_back(std::move(primitive));
    }
    if (primitives.empty()) return;
    document()["meshes"] = {{{"name", text(number(number(kMeshes)))}, {"primitives", primitives}}};
    Json node = {{"name", text(number(number(kMeshes)))}, {"mesh", 0}};
    const size_t number_of_node = document()["nodes"].size();
    if (document().contains("skins")) {
      node["skin"] = 0;
      roots_.push_back(number_of_node);
    } else {
      document()["nodes"][0]["children"].push_back(number_of_node);
    }
    document()["nodes"].push_back(std::move(node));
  }

  Json attributes_of(size_t first, size_t count) {
    Json attributes;
    const auto add = [&](const char* name, const std::vector<float>& values, size_t width) {
      if (!values.empty()) attributes[name] = add_vectors(&source_, values, width, false);
    };
    const std::vector<float> positions = vertex_array(kPosition, 3, first, count);
    if (positions.empty()) fail("positions of vertices", "none");
    attributes["POSITION"] = add_vectors(&source_, positions, 3, true);
    add("NORMAL", vertex_array(kNormal, 3, first, count), 3);
    add("TEXCOORD_0", vertex_array(kTexcoord, 2, first, count), 2);
    const std::vector<float> weights = vertex_array(kBlendWeights, 4, first, count);
    std::vector<uint16_t> joints;
    for (const float joint : vertex_array(kBlendIndices, 4, first, count)) {
      if (!(joint < static_cast<float>(rests_.size())))
        fail("blend indices below " + std::to_string(rests_.size()), std::to_string(static_cast<int>(joint)));
      joints.push_back(static_cast<uint16_t>(joint));
    }
    if (rests_.empty() || weights.empty() || joints.empty()) return attributes;
    add("WEIGHTS_0", weights, 4);
    attributes["JOINTS_0"] = add_accessor(&source_, joints.data(), joints.size() * 2, "VEC4",
                                          TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, count, true, false);
    return attributes;
  }

  // All joints' channels in a frame. [joints]
  std::vector<Channels> pose_at(size_t frame) const {
    std::vector<Channels> poses(rests_.size());
    size_t value = number(kFrames) + 2 * frame * number(kChannelCount);
    const size_t end = value + 2 * number(kChannelCount);
    for (size_t j = 0; j < poses.size(); ++j) {
      const size_t place = number(kPoses) + j * kPoseBytes;
      for (size_t c = 0; c < 10; ++c) {
        poses[j][c] = real(place + 8 + 4 * c, "poses");
        if ((number(place + 4) >> c & 1) == 0) continue;
        if (value + 2 > end) fail("as many channels as the poses' masks say", std::to_string(number(kChannelCount)));
        poses[j][c] += at<uint16_t>(value) * real(place + 48 + 4 * c, "poses");
        value += 2;
      }
    }
    return poses;
  }

  void read_animation(size_t place) {
    const std::string name = text(number(place));
    const size_t first = number(place + 4), count = number(place + 8);
    if (first > number(kFrameCount) || count > number(kFrameCount) - first)
      fail("animations within the file's " + std::to_string(number(kFrameCount)) + " frames",
           "animation " + in_quotes(name));
    if (count == 0 || number(kPoseCount) == 0) return;
    double fps = real(place + 12, "animations");
    if (!(fps > 0)) {
      fps = kIqmFps;
      source_.notes.push_back("animation " + in_quotes(name) +
                              " has no frame rate; 30 frames per second were assumed, so its speed may be wrong");
    }
    std::vector<float> times;
    std::vector<std::vector<Channels>> poses;
    for (size_t f = 0; f < count; ++f) {
      times.push_back(static_cast<float>(static_cast<double>(f) / fps));
      poses.push_back(pose_at(first + f));
    }
    const int input = add_key_times(&source_, times);
    Json animation = {{"name", name}, {"channels", Json::array()}, {"samplers", Json::array()}};
    struct Part {
      const char *path, *type;
      size_t begin, width;
    };
    constexpr Part kParts[] = {{"translation", "VEC3", 0, 3}, {"rotation", "VEC4", 3, 4}, {"scale", "VEC3", 7, 3}};
    for (size_t j = 0; j < rests_.size(); ++j)
      for (const Part& part : kParts) {
        std::vector<float> values;
        for (const std::vector<Channels>& pose : poses) {
          Channels own = pose[j];
          const Quaternion q = normalized({own[3], own[4], own[5], own[6]});
          std::copy(q.begin(), q.end(), own.begin() + 3);
          for (size_t i = 0; i < part.width; ++i) values.push_back(static_cast<float>(own[part.begin + i]));
        }
        const int output = add_accessor(&source_, values.data(), values.size() * 4, part.type,
                                        TINYGLTF_COMPONENT_TYPE_FLOAT, count, false, false);
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size()}, {"target", {{"node", j + 1}, {"path", part.path}}}});
        animation["samplers"].push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
      }
    document()["animations"].push_back(std::move(animation));
  }

  const std::string& path_;
  const std::vector<uint8_t>& bytes_;
  GltfSource source_;
  std::vector<Channels> rests_;  // [joints]
  std::vector<size_t> roots_;
};

}  // namespace

std::vector<uint8_t> iqm_to_glb(const std::string& path, std::vector<std::string>* notes) {
  const std::vector<uint8_t> bytes = read_file(path);
  return IqmConverter(path, bytes).convert(notes);
}

}  // namespace sinew
