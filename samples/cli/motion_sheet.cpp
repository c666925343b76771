// SPDX-License-Identifier: MIT
// Poses, draws and lays out the frames of a sheet.
#include <algorithm>

#include "pictures.hpp"
#include "sinew_character/picture/picture_mesh.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew::cli {
namespace {

constexpr size_t kColumns = 8, kMostRows = 12;
constexpr int kSide = 300;

}  // namespace

Image motion_sheet(const Character& character, const Motion& motion, Axis up, CharacterDeformer* deformer,
                   const PictureFile* picture) {
  const auto colours = picture != nullptr ? picture_colours(*picture, character) : weight_colours(character);
  const Box rest = box_of(character.vertices);
  RenderOptions view;
  view.width = view.height = kSide;
  view.draw_skeleton = false;
  view.up = up;
  if (picture != nullptr) view.yaw_degrees = view.pitch_degrees = 0;
  view.focus_radius = 0.62f * rest.longest_side();
  Image sheet;
  for (size_t c = 0; c < std::min(motion.clips.size(), kMostRows); ++c) {
    const Clip& clip = motion.clips[c];
    std::vector<Image> row;
    const size_t columns = std::min(kColumns, clip.frames.size());
    for (size_t i = 0; i < columns; ++i) {
      const size_t f = columns == 1 ? 0 : i * (clip.frames.size() - 1) / (columns - 1);
      const std::vector<Affine> palette = motion_palette(motion, clip.frames[f], character.joints.size());
      const Character posed =
          deformer != nullptr ? deformer->pose_character(character, palette) : apply_pose(character, palette);
      const Box box = box_of(posed.vertices);
      const auto middle = [](float a, float b) { return 0.5f * a + 0.5f * b; };
      view.focus = {middle(box.low.x, box.high.x), middle(box.low.y, box.high.y), middle(box.low.z, box.high.z)};
      (up == Axis::kZ ? view.focus.z : view.focus.y) =
          up == Axis::kZ ? middle(rest.low.z, rest.high.z) : middle(rest.low.y, rest.high.y);
      row.push_back(render(posed, colours, view));
    }
    Image line = beside(row);
    if (sheet.width < line.width) {  // the first row, or one with more frames than those above
      std::vector<uint8_t> wider(static_cast<size_t>(line.width) * static_cast<size_t>(sheet.height) * 3, 255);
      for (int y = 0; y < sheet.height; ++y)
        std::copy_n(sheet.rgb.begin() + static_cast<std::ptrdiff_t>(y) * sheet.width * 3, sheet.width * 3,
                    wider.begin() + static_cast<std::ptrdiff_t>(y) * line.width * 3);
      sheet.rgb = std::move(wider);
      sheet.width = line.width;
    }
    for (int y = 0; y < line.height; ++y) {
      const auto from = line.rgb.begin() + static_cast<std::ptrdiff_t>(y) * line.width * 3;
      sheet.rgb.insert(sheet.rgb.end(), from, from + line.width * 3);
      sheet.rgb.insert(sheet.rgb.end(), static_cast<size_t>(sheet.width - line.width) * 3, 255);
    }
    sheet.height += line.height;
  }
  return sheet;
}

}  // namespace sinew::cli
