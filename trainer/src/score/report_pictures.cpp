// SPDX-License-Identifier: MIT
// Pictures of the report: which characters are shown, and one character beside its artist's weights.
#include <algorithm>
#include <cmath>

#include "sinew_character/draw/image.hpp"
#include "sinew_character/page/html.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/report.hpp"

namespace sinew {
namespace {

constexpr float kFarApart = 0.05f;  // of the longest side: red in the picture of distances

}  // namespace

std::vector<std::pair<std::string, std::string>> best_median_worst(const Scores& scores) {
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, m] : scores.characters) order.emplace_back(m.l1, name);
  std::sort(order.begin(), order.end());
  std::vector<std::pair<std::string, std::string>> out;
  if (order.empty()) return out;
  out.emplace_back("best", order.front().second);
  if (order.size() > 2) out.emplace_back("median", order[order.size() / 2].second);
  if (order.size() > 1) out.emplace_back("worst", order.back().second);
  return out;
}

ReportPicture report_picture(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                             const std::string& heading, Axis up, int side) {
  std::vector<float> errors;
  const Metrics m = measure(reference, predicted, reference.name, 10, &errors);
  Character bound = reference;
  bound.influences = predicted;
  std::vector<std::array<double, 3>> positions;
  for (const Joint& joint : reference.joints) {
    positions.push_back({static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
                         static_cast<double>(joint.position.z)});
  }
  const std::vector<Affine> pose = random_poses(reference, reference.name, positions).front();
  const Character posed_reference = apply_pose(reference, pose), posed = apply_pose(bound, pose);
  const float size = box_of(reference.vertices).longest_side();
  std::vector<float> distances;
  for (size_t v = 0; v < posed.vertices.size(); ++v) {
    const Vec3 &a = posed.vertices[v], &b = posed_reference.vertices[v];
    distances.push_back(size > 0 ? std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) / size : 0);
  }

  RenderOptions bare;
  bare.width = bare.height = side;
  bare.up = up;
  bare.draw_skeleton = false;
  RenderOptions with_skeleton = bare;
  with_skeleton.draw_skeleton = true;
  const auto panel = [](const char* caption, const Image& image) {
    return ReportPicture::Panel{caption, encode_png(image)};
  };
  ReportPicture picture;
  picture.heading = heading;
  picture.character = reference.name;
  picture.note = "L1 " + html::number(m.l1, 3) + ", argmax " + html::number(100 * m.argmax, 1) + " %, avg dist " +
                 html::number(m.avg_dist, 4);
  picture.panels = {
      panel("artist's weights", render(reference, weight_colors(reference), with_skeleton)),
      panel("predicted weights", render(bound, weight_colors(bound), with_skeleton)),
      panel("L1 per vertex: blue 0, red 1 or more", render(bound, heat_colors(errors, 1.0f), bare)),
      panel("posed with the artist's weights", render(posed_reference, weight_colors(posed_reference), bare)),
      panel("posed with the prediction", render(posed, weight_colors(posed), bare)),
      panel("distance between the two: blue 0, red 5 % of the size or more",
            render(posed, heat_colors(distances, kFarApart), bare))};
  return picture;
}

}  // namespace sinew
