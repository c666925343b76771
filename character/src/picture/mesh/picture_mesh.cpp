// SPDX-License-Identifier: MIT
#include "sinew_character/picture/picture_mesh.hpp"

#include <algorithm>
#include <array>

#include "picture/mesh/plane_mesh.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace picture {
namespace {

constexpr size_t kPoints = 1100;  // about 2,000 vertices on both sides
// Limbs are nearly as deep as wide, trunks and skirts the less the wider: a height h becomes kDepth h / (1 + h / (kWide longest side)). Chosen by the joints that votes find
// in pictures of training characters.
constexpr float kDepth = 0.9f, kWide = 0.15f;
constexpr float kLeastHeight = 0.35f;  // pixels: no two sides at one position
constexpr float kCard = 0.005f;        // of the longest side
constexpr float kSlit = 2.2f;          // pixels of the mask from a slit's line to its borders
constexpr float kSlitLeft = 0.05f;     // of that, what stays open, so that nothing welds them

float height_at(const Grid<float>& height, const Point2& p) {
  const auto cell = [](double v, uint32_t n) {
    return static_cast<uint32_t>(std::clamp(v, 0.0, static_cast<double>(n - 1)));
  };
  return height.at(cell(p[0], height.width), cell(p[1], height.height));
}

// Points of the mask in the units asked for.
struct Plane {
  float left, bottom, scale, longest;  // pixels
  Vec3 at(const Point2& p, float z) const {
    return {(static_cast<float>(p[0]) - left) * scale, (bottom - static_cast<float>(p[1])) * scale, z * scale};
  }
};

Plane plane_of(const PictureFile& picture, const Figure& figure, const PlaneMesh& mesh, bool pixels) {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const Point2& p : mesh.points) {
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
    top = std::min(top, p[1]);
    bottom = std::max(bottom, p[1]);
  }
  const auto step = static_cast<float>(figure.step), longest = static_cast<float>(std::max(right - left, bottom - top));
  if (pixels) return {0, static_cast<float>(picture.pixels.height) / step, step, longest};
  return {static_cast<float>(0.5 * (left + right)), static_cast<float>(bottom), 1 / longest, longest};
}

}  // namespace
}  // namespace picture

Character picture_mesh(const PictureFile& picture, const Figure& figure, const PictureMeshOptions& options) {
  using namespace picture;
  const Inflation inflation = inflate(figure.mask);
  const PlaneMesh mesh = triangulate(figure.mask, inflation, kPoints);
  if (mesh.triangles.size() < 8)
    throw Error(picture.name + ": the figure has too few pixels for a mesh; give a larger picture");
  const Plane plane = plane_of(picture, figure, mesh, options.pixels);
  Character out;
  out.name = picture.name;
  std::vector<uint32_t> front(mesh.points.size()), back(mesh.points.size());
  std::vector<std::array<float, 2>> uvs;
  for (const bool behind : {false, true})
    for (size_t p = 0; p < mesh.points.size(); ++p) {
      (behind ? back : front)[p] = static_cast<uint32_t>(out.vertices.size());
      if (behind && mesh.rim[p] != 0) {
        back[p] = front[p];
        continue;
      }
      const float round = height_at(inflation.height, mesh.points[p]);
      const float high = std::max(kLeastHeight, kDepth * round / (1 + round / (kWide * plane.longest)));
      out.vertices.push_back(plane.at(mesh.points[p], mesh.rim[p] != 0 ? 0 : behind ? -high : high));
    }
  const auto step = static_cast<double>(figure.step);
  for (const Point2& p : mesh.points) {
    const PicturePoint seen = {static_cast<float>(std::clamp(p[0] * step / picture.pixels.width, 0.0, 1.0)),
                               static_cast<float>(std::clamp(p[1] * step / picture.pixels.height, 0.0, 1.0))};
    const PicturePoint in_file = file_point(picture, seen);
    uvs.push_back({in_file.u, 1 - in_file.v});  // as in an OBJ, v runs up
  }
  for (const bool behind : {false, true})
    for (const auto& t : mesh.triangles) {
      // Left about with y down is right about with y up.
      const std::array<uint32_t, 3> corners = behind ? std::array{t[0], t[1], t[2]} : std::array{t[0], t[2], t[1]};
      for (const uint32_t p : corners) {
        out.face_vertices.push_back((behind ? back : front)[p]);
        out.corner_uvs.push_back(uvs[p]);
      }
      out.face_offsets.push_back(static_cast<uint32_t>(out.face_vertices.size()));
    }
  Material material;
  material.base_color_texture = picture.bytes;
  material.unlit = true;
  material.cut_out = figure.source == FigureSource::kAlpha;
  out.material_names = {"picture"};
  out.materials = {material};
  out.face_materials.assign(out.face_count(), 0);
  out.notes = figure.notes;
  if (options.flat) flatten(&out);
  return out;
}

PicturePlane picture_plane(const Figure& figure, const Character& mesh) {
  uint32_t left = figure.mask.width, right = 0, bottom = 0;
  for (uint32_t y = 0; y < figure.mask.height; ++y)
    for (uint32_t x = 0; x < figure.mask.width; ++x) {
      if (!figure.mask.at(x, y)) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      bottom = y + 1;
    }
  const Box box = box_of(mesh.vertices);
  const float wide = static_cast<float>(right) - static_cast<float>(left);
  return {static_cast<float>(left), static_cast<float>(bottom), box.low.x, box.low.y,
          (box.high.x - box.low.x) / std::max(wide, 1.0f)};
}

void close_slits(const Figure& figure, const PicturePlane& plane, Character* mesh) {
  for (Vec3& v : mesh->vertices) {
    const std::array<float, 2> at = plane.to_mask(v);
    std::array<float, 2> nearest = {};
    float least = picture::kSlit * picture::kSlit;
    for (const auto& line : figure.slits)
      for (const auto& p : line) {
        const float dx = p[0] - at[0], dy = p[1] - at[1];
        if (dx * dx + dy * dy >= least) continue;
        least = dx * dx + dy * dy;
        nearest = p;
      }
    if (least == picture::kSlit * picture::kSlit) continue;
    const auto goal = plane.to_mesh({nearest[0] + picture::kSlitLeft * (at[0] - nearest[0]),
                                     nearest[1] + picture::kSlitLeft * (at[1] - nearest[1])});
    v.x = goal[0], v.y = goal[1];
  }
}

std::vector<std::array<uint8_t, 3>> picture_colors(const PictureFile& picture, const Character& mesh) {
  std::vector<std::array<uint8_t, 3>> out(mesh.vertices.size(), std::array<uint8_t, 3>{});
  const Pixels& pixels = picture.pixels;
  for (size_t c = 0; c < mesh.face_vertices.size(); ++c) {
    const PicturePoint seen = seen_point(picture, {mesh.corner_uvs[c][0], 1 - mesh.corner_uvs[c][1]});
    const auto x = static_cast<uint32_t>(seen.u * static_cast<float>(pixels.width - 1)),
               y = static_cast<uint32_t>(seen.v * static_cast<float>(pixels.height - 1));
    const uint8_t* p = &pixels.rgba[(size_t{y} * pixels.width + x) * 4];
    out[mesh.face_vertices[c]] = {p[0], p[1], p[2]};
  }
  return out;
}

void flatten(Character* mesh) {
  if (mesh->vertices.empty()) return;
  const float thick = picture::kCard * box_of(mesh->vertices).longest_side();
  for (Vec3& v : mesh->vertices) v.z = v.z > 0 ? thick : v.z < 0 ? -thick : 0;
}

}  // namespace sinew
