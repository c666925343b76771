// SPDX-License-Identifier: MIT
// A sheet is drawn, its drawing is rigged, and the joints come back to the sheet.
#include "jobs/sheet_skeleton.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "sinew_character/jobs/picture_view.hpp"
#include "sinew_character/picture/mesh_drawing.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

constexpr float kSheetDepth = 0.06f;  // of the longest side: a sheet is no deeper
constexpr uint32_t kSheetPixels = 480;

// The picture's axes in those of the mesh: x to the right, y up, z from the sheet's middle to who looks.
struct SheetAxes {
  Point3 right, up, near;
  double depth = 0;  // of the sheet's middle

  Point3 to(const Vec3& p) const { return {dot(point(p), right), dot(point(p), up), dot(point(p), near) - depth}; }
  Vec3 from(const Vec3& p) const {
    return to_vec3(static_cast<double>(p.x) * right + static_cast<double>(p.y) * up +
                   (static_cast<double>(p.z) + depth) * near);
  }
};

// Both faces of a sheet look alike, so nothing but the user tells which is the front: else it is the usual one.
std::optional<SheetAxes> axes_of(const Character& mesh, const PredictedSkeleton& votes, bool front_given) {
  const Box box = box_of(mesh.vertices);
  const Point3 size = point(box.high) - point(box.low);
  const size_t up = votes.up_axis == Axis::kZ ? 2 : 1, beside = 3 - up;
  const size_t flat = size[0] < size[beside] ? 0 : beside;
  if (size[flat] > static_cast<double>(kSheetDepth * box.longest_side())) return std::nullopt;
  SheetAxes axes{};
  axes.up[up] = 1;
  const bool back = front_given ? votes.front[flat] < 0 : flat == 1;  // with z up it is -y
  axes.near[flat] = back ? -1 : 1;
  axes.right = cross(axes.up, axes.near);
  axes.depth = 0.5 * dot(point(box.low) + point(box.high), axes.near);
  return axes;
}

}  // namespace

std::optional<PredictedSkeleton> sheet_skeleton(const RigJobOptions& job, const RigModels& models,
                                                const PredictedSkeleton& votes, Character* character) {
  const bool front_given = job.front != SINEW_FRONT_AUTO;
  const std::optional<SheetAxes> axes = axes_of(*character, votes, front_given);
  const std::vector<std::array<uint32_t, 3>> triangles = fan_triangles(*character);
  if (!axes || triangles.empty()) return std::nullopt;
  std::vector<Point3> vertices;
  for (const Vec3& v : character->vertices) vertices.push_back(axes->to(v));
  const MeshDrawing drawing(vertices, triangles, kSheetPixels);
  RigModels bodies = models;
  bodies.hands = nullptr;
  std::optional<BodyClass> body;
  if (job.category != SINEW_CATEGORY_ANY) body = body_of_category(job.category);
  character->notes.push_back("this mesh is flat, so its joints come from its outline, as for a picture");
  SeenBody seen =
      see_body(drawing.round_mesh(), body, class_of_outline(drawing.figure().mask), job, bodies, &character->notes);
  PredictedSkeleton made = std::move(seen.skeleton);
  made.usable = std::min(made.usable.value_or(1.0f), seen.certainty);  // no better than the guess of what it is
  for (Joint& joint : made.joints) joint.position = axes->from(joint.position);
  const Point3 front = seen.view == PictureView::kFront        ? axes->near
                       : seen.view == PictureView::kFacesRight ? axes->right
                                                               : -1.0 * axes->right;
  made.front = {static_cast<float>(front[0]), static_cast<float>(front[1]), static_cast<float>(front[2])};
  take_the_place_of(votes, &made);
  made.front_confidence = front_given ? 1.0f : 0.5f;
  // The plane's axis counts towards positive x, or y.
  if (axes->right[0] + axes->right[1] + axes->right[2] < 0) made.plane = -made.plane;
  return made;
}

}  // namespace sinew
