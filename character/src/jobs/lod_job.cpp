// SPDX-License-Identifier: MIT
// Levels of detail: which pose the triangles are left out in, and how far the result is from the input.
#include "sinew_character/jobs/lod_job.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "check/rig_facts.hpp"
#include "sinew_character/jobs/character_file.hpp"
#include "sinew_character/jobs/simplify_job.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/lod_document.hpp"
#include "sinew_formats/memory_files.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {
namespace {

constexpr size_t kMostSamples = 2000;
constexpr double kMissed = 1.25,
                 kFewTriangles =
                     8;  // a level with more than this factor times the requested triangles, plus some, gets a warning

using Triangles = std::vector<std::array<uint32_t, 3>>;

std::vector<Vec3> posed(const Character& character, const std::vector<Affine>& palette) {
  return morphed_pose(character, {}, {}, palette);
}

// Squared, of a point from a triangle: from its plane where the foot is inside, else from the nearest edge.
double squared_distance(const Point3& p, const std::array<Point3, 3>& corners) {
  const Point3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area = dot(normal, normal);
  bool inside = area > 0;
  double least = 1e300;
  for (size_t e = 0; e < 3; ++e) {
    const Point3 &a = corners[e], along = corners[(e + 1) % 3] - a, to = p - a;
    inside = inside && dot(cross(along, to), normal) >= 0;
    const double size = dot(along, along), share = size > 0 ? std::clamp(dot(to, along) / size, 0.0, 1.0) : 0;
    const Point3 gap = to - share * along;
    least = std::min(least, dot(gap, gap));
  }
  const double above = dot(p - corners[0], normal);
  return inside ? above * above / area : least;
}

struct Distance {
  double largest = 0, mean = 0;
};

// A triangle with a ball around it.
struct Corners {
  std::array<Point3, 3> at;
  Point3 middle;
  double radius;
};

std::vector<Corners> corners_of(const std::vector<Vec3>& surface, const Triangles& triangles) {
  std::vector<Corners> out;
  for (const auto& one : triangles) {
    Corners corners = {{point(surface[one[0]]), point(surface[one[1]]), point(surface[one[2]])}, {}, 0};
    corners.middle = (1.0 / 3) * (corners.at[0] + corners.at[1] + corners.at[2]);
    for (const Point3& corner : corners.at) corners.radius = std::max(corners.radius, length(corner - corners.middle));
    out.push_back(corners);
  }
  return out;
}

// Distances of vertices from the surface of the triangles.
Distance distance(const std::vector<Vec3>& vertices, const std::vector<Vec3>& surface, const Triangles& triangles) {
  Distance out;
  const std::vector<Corners> all = corners_of(surface, triangles);
  const size_t step = vertices.size() / kMostSamples + 1;
  size_t count = 0, near = 0;  // the triangle of the vertex before
  for (size_t v = 0; v < vertices.size(); v += step, ++count) {
    const Point3 p = point(vertices[v]);
    double least = near < all.size() ? squared_distance(p, all[near].at) : 1e300, far = std::sqrt(least);
    for (size_t t = 0; t < all.size(); ++t) {
      const Point3 to = p - all[t].middle;
      const double reach = far + all[t].radius;
      if (dot(to, to) > reach * reach) continue;
      const double squared = squared_distance(p, all[t].at);
      if (squared < least) least = squared, far = std::sqrt(least), near = t;
    }
    out.largest = std::max(out.largest, far);
    out.mean += far;
  }
  out.mean /= static_cast<double>(std::max<size_t>(count, 1));
  return out;
}

// The character as a document with its pictures inside, whatever it is from.
Character through_glb(const Character& character) {
  GlbOptions options;
  options.keep_skin = true;
  std::vector<NamedBytes> written;
  {
    const MemoryFiles scope(memory_inputs(), &written);
    write_gltf(character.name + ".glb", character, options);
  }
  const FileBytes files = {{written[0].path, written[0].bytes}};
  const MemoryFiles scope(&files, nullptr);
  return read_gltf(written[0].path);
}

OwnMotion motion_of_bytes(const std::string& name, const std::vector<uint8_t>& glb) {
  const FileBytes files = {{name, glb}};
  const MemoryFiles scope(&files, nullptr);
  return read_own_motion(name);
}

Character character_of_bytes(const std::string& name, const std::vector<uint8_t>& glb) {
  const FileBytes files = {{name, glb}};
  const MemoryFiles scope(&files, nullptr);
  return read_gltf(name);
}

// Why a level has more triangles than it should.
std::string missed_text(const Character& whole, size_t left, size_t wanted) {
  std::vector<uint32_t> piece(whole.vertices.size());
  std::iota(piece.begin(), piece.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (piece[v] != v) v = piece[v] = piece[piece[v]];
    return v;
  };
  for (size_t f = 0; f < whole.face_count(); ++f)
    for (uint32_t c = whole.face_offsets[f] + 1; c < whole.face_offsets[f + 1]; ++c)
      piece[root(whole.face_vertices[c])] = root(whole.face_vertices[whole.face_offsets[f]]);
  size_t pieces = 0;
  for (uint32_t v = 0; v < piece.size(); ++v) pieces += piece[v] == v ? 1 : 0;
  return "warning: " + std::to_string(left) + " triangles are left instead of " + std::to_string(wanted) +
         ": the mesh has " + std::to_string(pieces) +
         " separate pieces, each of which keeps its last triangles and borders; join vertices in your modeling program";
}

class LodBuilder {
 public:
  LodBuilder(const LodOptions& options, const Character& character)
      : options_(options), whole_(through_glb(character)), facts_(whole_), poses_(test_poses(facts_)) {
    float low = whole_.vertices[0].y, high = low;
    for (const Vec3& p : whole_.vertices) low = std::min(low, p.y), high = std::max(high, p.y);
    height_ = std::max(static_cast<double>(high) - static_cast<double>(low), 1e-9);
    for (const TestPose& pose : poses_) posed_.push_back(posed(whole_, pose.palette));
    triangles_ = fan_triangles(whole_).size();
  }

  LodLevel level(uint32_t number) const {
    const double share = std::pow(options_.ratio, number);
    std::optional<LodLevel> best;
    std::vector<uint8_t> kept;
    // At rest, and where elbows and knees are bent: triangles that a bend needs are flat at rest.
    for (size_t way = 0; way < (posed_.empty() ? size_t{1} : size_t{2}); ++way) {
      std::vector<uint8_t> glb = reduced_glb(whole_.name, whole_, way == 0 ? whole_.vertices : posed_[0], share);
      LodLevel made;
      made.character = character_of_bytes(whole_.name + ".glb", glb);
      made.character.name = whole_.name;
      measure(&made);
      if (best && !(made.posed_error < best->posed_error)) continue;
      best = std::move(made);
      kept = std::move(glb);
    }
    best->motion = motion_of_bytes(whole_.name + ".glb", kept).motion;
    const double wanted = share * static_cast<double>(triangles_);
    if (static_cast<double>(best->triangles) > kMissed * wanted + kFewTriangles)
      best->character.notes.push_back(missed_text(whole_, best->triangles, static_cast<size_t>(wanted)));
    if (options_.joints && number > 1) leave_out_joints(number > 2, &*best);
    return std::move(*best);
  }

 private:
  void measure(LodLevel* level) const {
    const Triangles triangles = fan_triangles(level->character);
    level->triangles = triangles.size();
    const Distance rest = distance(whole_.vertices, level->character.vertices, triangles);
    level->rest_error = level->posed_error = rest.largest / height_;
    level->mean_error = rest.mean / height_;
    for (size_t p = 0; p < poses_.size(); ++p) {
      const Distance far = distance(posed_[p], posed(level->character, poses_[p].palette), triangles);
      if (far.largest / height_ < level->posed_error) continue;
      level->posed_error = far.largest / height_;
      level->mean_error = far.mean / height_;
    }
  }

  static void leave_out_joints(bool low, LodLevel* level) {
    SimplifyOptions how;
    how.low = low;
    std::vector<const Motion*> motions;
    if (!level->motion.clips.empty()) motions.push_back(&level->motion);
    SimplifiedCharacter left = simplify_character(how, motions, &level->character);
    level->motion = std::move(left.motion);
  }

  const LodOptions& options_;
  const Character whole_;
  const RigFacts facts_;
  const std::vector<TestPose> poses_;
  std::vector<std::vector<Vec3>> posed_;  // [poses]
  double height_ = 1;
  size_t triangles_ = 0;
};

}  // namespace

std::vector<LodLevel> levels_of_detail(const LodOptions& options, const Character& character) {
  if (character.vertices.empty() || character.influences.empty() || character.joints.empty())
    throw Error(character.name + ": expected a mesh bound to a skeleton; bind or rig it first");
  const LodBuilder builder(options, character);
  std::vector<LodLevel> levels;
  for (uint32_t number = 1; number <= options.levels; ++number) levels.push_back(builder.level(number));
  return levels;
}

}  // namespace sinew
