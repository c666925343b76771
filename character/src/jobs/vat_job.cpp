// SPDX-License-Identifier: MIT
// Clips as vertex animation textures.
#include "sinew_character/jobs/vat_job.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "sinew_character/picture/picture_file.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/still_mesh.hpp"

namespace sinew {
namespace {

constexpr double kLoopGap = 0.01;         // of the height
constexpr size_t kBytesPerTexel = 3 * 4;  // GPUs keep RGB of 8 bits as RGBA

// In a file with y up.
Vec3 upright(const Vec3& v, Axis up) { return up == Axis::kZ ? Vec3{v.x, v.z, -v.y} : v; }

// The still mesh's vertices in any pose.
class Poser {
 public:
  Poser(const AnimatedCharacter& animated, const StillMesh& mesh, const std::optional<sinew_deform_options>& deform,
        std::function<bool()> keep_going)
      : character_(animated.character), motion_(animated.motion), mesh_(mesh), keep_going_(std::move(keep_going)) {
    if (deform) deformer_.emplace(character_, *deform);
  }

  // Positions of the Character's vertices [V], y up, and matrices for normals().
  std::vector<Vec3> pose(const MotionFrame& frame) {
    if (!keep_going_()) throw Error(character_.name + ": textures were interrupted");
    const std::vector<Affine> palette = motion_palette(motion_, frame, character_.joints.size());
    matrices_.clear();
    for (const auto& row : character_.influences) matrices_.push_back(blended_matrix(row, palette));
    const std::vector<float>* corrected = deformer_ ? &deformer_->pose(palette) : nullptr;
    std::vector<Vec3> positions;
    positions.reserve(matrices_.size());
    for (size_t v = 0; v < matrices_.size(); ++v) {
      const Point3 rest = point(character_.vertices[v]);
      const Vec3 posed = corrected != nullptr
                             ? Vec3{(*corrected)[3 * v], (*corrected)[3 * v + 1], (*corrected)[3 * v + 2]}
                             : to_vec3(transform_point(matrices_[v], rest[0], rest[1], rest[2]));
      positions.push_back(upright(posed, character_.up));
    }
    return positions;
  }

  // [N] of the last pose.
  std::vector<Vec3> normals() const {
    std::vector<Vec3> normals;
    for (size_t i = 0; i < mesh_.vertices().size(); ++i) {
      const Point3 rest = point(mesh_.normals()[i]);
      const Point3 posed = unit(transform_normal(matrices_[mesh_.vertices()[i]], rest[0], rest[1], rest[2]));
      normals.push_back(upright(dot(posed, posed) > 0 ? to_vec3(posed) : mesh_.normals()[i], character_.up));
    }
    return normals;
  }

 private:
  const Character& character_;
  const Motion& motion_;
  const StillMesh& mesh_;
  std::optional<CharacterDeformer> deformer_;
  std::function<bool()> keep_going_;
  std::vector<Affine> matrices_;  // [V]
};

// Mean and largest of many distances.
class Distances {
 public:
  void add(const Point3& a, const Point3& b) {
    const double distance = length(a - b);
    largest_ = std::max(largest_, distance);
    sum_ += distance;
    ++count_;
  }
  VatDistance result() const { return {largest_, count_ > 0 ? sum_ / static_cast<double>(count_) : 0}; }

 private:
  double largest_ = 0, sum_ = 0;
  size_t count_ = 0;
};

double angle_between(const Vec3& a, const Vec3& b) {
  const Point3 p = point(a), q = point(b);
  return std::atan2(length(cross(p, q)), dot(p, q)) * 180 / std::numbers::pi;
}

// The colors of a PNG, as engines get them.
Image decoded(const NamedBytes& file) {
  const Pixels pixels = decode_picture(file.path, file.bytes).pixels;
  Image image;
  image.width = static_cast<int>(pixels.width);
  image.height = static_cast<int>(pixels.height);
  image.rgb.reserve(pixels.rgba.size() / 4 * 3);
  for (size_t i = 0; i < pixels.rgba.size(); ++i)
    if (i % 4 != 3) image.rgb.push_back(pixels.rgba[i]);
  return image;
}

// Compares what a shader makes of the textures with poses.
class Measure {
 public:
  Measure(const VertexTextures& textures, const StillMesh& mesh) : textures_(textures), mesh_(mesh) {}

  // `share` of the interval from frame to frame + 1, as shaders interpolate.
  void add(const std::vector<Vec3>& exact, size_t frame, double share, Distances* distances) const {
    for (size_t i = 0; i < mesh_.vertices().size(); ++i) {
      Point3 shown = at(i, frame);
      if (share > 0) shown = shown + share * (at(i, frame + 1) - shown);
      distances->add(shown, point(exact[mesh_.vertices()[i]]));
    }
  }

  double largest_angle(const std::vector<Vec3>& exact, size_t frame) const {
    double largest = 0;
    for (size_t i = 0; i < exact.size(); ++i)
      largest = std::max(largest, angle_between(exact[i], normal_at(textures_, textures_.layout.texel(i, frame))));
    return largest;
  }

 private:
  Point3 at(size_t vertex, size_t frame) const {
    return point(position_at(textures_, textures_.layout.texel(vertex, frame)));
  }
  const VertexTextures& textures_;
  const StillMesh& mesh_;
};

void measure(const Motion& motion, const StillMesh& mesh, const VertexTextures& read_back, Poser* poser,
             VatResult* out) {
  const Measure measure(read_back, mesh);
  for (size_t c = 0; c < out->clips.size(); ++c) {
    VatClip& clip = out->clips[c];
    const std::vector<MotionFrame>& frames = motion.clips[c].frames;
    Distances at, between;
    for (size_t f = 0; f < frames.size(); ++f) {
      measure.add(poser->pose(frames[f]), clip.first_frame + f, 0, &at);
      clip.normal_angle = std::max(clip.normal_angle, measure.largest_angle(poser->normals(), clip.first_frame + f));
      if (f + 1 == frames.size()) continue;
      const double middle = (static_cast<double>(f) + 0.5) * clip.frame_time;
      measure.add(poser->pose(frame_at(motion.clips[c], middle)), clip.first_frame + f, 0.5, &between);
    }
    clip.at_frames = at.result();
    clip.between_frames = between.result();
  }
}

std::array<float, 3> numbers(const Vec3& v) { return {v.x, v.y, v.z}; }

std::string layout_text(const std::string& name, const VatResult& result) {
  using Json = nlohmann::ordered_json;
  Json json = {{"sinew_vat", 1},
               {"name", name},
               {"mesh", result.files[0].path},
               {"textures",
                {{"position_high", result.files[1].path},
                 {"position_low", result.files[2].path},
                 {"normal", result.files[3].path}}},
               {"texel_attribute", "TEXCOORD_1"},
               {"vertices", result.layout.vertices},
               {"frames", result.layout.frames},
               {"width", result.layout.width},
               {"height", result.layout.height()},
               {"rows_per_frame", result.layout.rows},
               {"position_encoding", "unorm16 in bounds, high and low bytes"},
               {"normal_encoding", "(byte - 128) / 127"},
               {"bounds", {{"min", numbers(result.bounds.low)}, {"max", numbers(result.bounds.high)}}},
               {"up", "y"},
               {"clips", Json::array()}};
  for (const VatClip& clip : result.clips)
    json["clips"].push_back({{"name", clip.name},
                             {"first_frame", clip.first_frame},
                             {"frames", clip.frames},
                             {"rate", 1 / clip.frame_time},
                             {"seconds", static_cast<double>(clip.frames - 1) * clip.frame_time},
                             {"loop", clip.loops}});
  return json.dump(2) + "\n";
}

}  // namespace

VatResult vertex_animation(const std::string& name, const AnimatedCharacter& animated,
                           const std::optional<sinew_deform_options>& deform, const StepsOf& steps) {
  const Motion& motion = animated.motion;
  const StillMesh mesh(name, animated.character);
  VatResult out;
  size_t frames = 0;
  for (const Clip& clip : motion.clips) {
    VatClip made;
    made.name = clip.name;
    made.first_frame = frames;
    made.frames = clip.frames.size();
    made.frame_time = clip.frame_time;
    frames += made.frames;
    out.clips.push_back(made);
  }
  out.layout = texture_layout(name, mesh.vertices().size(), frames);
  Poser poser(animated, mesh, deform, steps(3 * frames - out.clips.size()));

  std::vector<Vec3> rest;
  for (const Vec3& v : animated.character.vertices) rest.push_back(upright(v, animated.character.up));
  const Box rest_box = box_of(rest);
  out.height = static_cast<double>(rest_box.high.y) - static_cast<double>(rest_box.low.y);

  VertexTextures textures = blank_textures(out.layout, {});
  std::vector<std::vector<Vec3>> poses;  // [frames][V]
  for (size_t c = 0; c < out.clips.size(); ++c) {
    VatClip& clip = out.clips[c];
    for (const MotionFrame& frame : motion.clips[c].frames) {
      const size_t f = poses.size();
      poses.push_back(poser.pose(frame));
      const std::vector<Vec3> normals = poser.normals();
      for (size_t i = 0; i < normals.size(); ++i) set_normal(normals[i], out.layout.texel(i, f), &textures);
    }
    for (size_t v = 0; v < rest.size(); ++v)
      clip.gap = std::max(clip.gap, length(point(poses[clip.first_frame][v]) - point(poses.back()[v])));
    clip.loops = clip.frames > 1 && clip.gap <= kLoopGap * out.height;
    clip.bytes = clip.frames * out.layout.rows * out.layout.width * kBytesPerTexel;
  }
  textures.bounds = box_of(poses[0]);
  for (const std::vector<Vec3>& pose : poses)
    for (const Vec3& v : pose) textures.bounds.add(v);
  out.bounds = textures.bounds;
  for (size_t f = 0; f < poses.size(); ++f)
    for (size_t i = 0; i < mesh.vertices().size(); ++i)
      set_position(poses[f][mesh.vertices()[i]], out.layout.texel(i, f), &textures);
  poses.clear();

  std::vector<Vec3> positions, normals;
  std::vector<std::array<float, 2>> texels;
  for (size_t i = 0; i < mesh.vertices().size(); ++i) {
    positions.push_back(rest[mesh.vertices()[i]]);
    normals.push_back(upright(mesh.normals()[i], animated.character.up));
    texels.push_back(out.layout.coordinates(i));
  }
  const std::string stem = name + ".vat";
  out.files.push_back({stem + ".glb", mesh.glb(positions, normals, texels)});
  out.files.push_back({stem + ".position_high.png", encode_png(textures.position_high)});
  out.files.push_back({stem + ".position_low.png", encode_png(textures.position_low)});
  out.files.push_back({stem + ".normal.png", encode_png(textures.normal)});
  textures.position_high = decoded(out.files[1]);
  textures.position_low = decoded(out.files[2]);
  textures.normal = decoded(out.files[3]);
  measure(motion, mesh, textures, &poser, &out);
  const std::string text = layout_text(name, out);
  out.files.push_back({stem + ".json", {text.begin(), text.end()}});
  return out;
}

}  // namespace sinew
