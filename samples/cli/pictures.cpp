// SPDX-License-Identifier: MIT
// Maps as skeletons of lines and discs, seen a little from the side so that what lies behind each other stays apart;
// motions as a sheet of frames.
#include "pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "sinew_character/draw/pose_frame.hpp"
#include "sinew_character/picture/picture_mesh.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew::cli {
namespace {

using Color = std::array<uint8_t, 3>;

constexpr int kPictureWidth = 700, kPictureHeight = 900, kRim = 40;
constexpr float kYaw = 0.45f, kPitch = 0.17f;  // radians
constexpr Color kPaper = {255, 255, 255}, kAlone = {190, 190, 190};

struct Spot {
  float x, y;
};

class Panel {
 public:
  Panel() {
    image_.width = kPictureWidth;
    image_.height = kPictureHeight;
    image_.rgb.assign(size_t{3} * kPictureWidth * kPictureHeight, kPaper[0]);
  }

  void disc(Spot at, float radius, Color color) {
    for (int y = static_cast<int>(at.y - radius); y <= static_cast<int>(at.y + radius) + 1; ++y) {
      for (int x = static_cast<int>(at.x - radius); x <= static_cast<int>(at.x + radius) + 1; ++x) {
        const float dx = static_cast<float>(x) - at.x, dy = static_cast<float>(y) - at.y;
        if (dx * dx + dy * dy <= radius * radius) put(x, y, color);
      }
    }
  }
  void line(Spot from, Spot to, float radius, Color color) {
    const int steps = 1 + static_cast<int>(std::max(std::fabs(to.x - from.x), std::fabs(to.y - from.y)));
    for (int i = 0; i <= steps; ++i) {
      const float t = static_cast<float>(i) / static_cast<float>(steps);
      disc({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}, radius, color);
    }
  }
  Image take() { return std::move(image_); }

 private:
  void put(int x, int y, Color color) {
    if (x < 0 || y < 0 || x >= kPictureWidth || y >= kPictureHeight) return;
    std::copy(color.begin(), color.end(), image_.rgb.begin() + 3 * (static_cast<long>(y) * kPictureWidth + x));
  }
  Image image_;
};

// Where joints are in the panel: the whole rig fills it.
std::vector<Spot> project(const MapRig& rig, MaybeAxis up) {
  std::vector<Spot> spots;
  for (const Joint& joint : rig.joints) {
    Vec3 p = joint.position;
    if (up == Axis::kZ) p = {p.x, p.z, -p.y};
    if (up == Axis::kX) p = {-p.y, p.x, p.z};
    const float x = std::cos(kYaw) * p.x - std::sin(kYaw) * p.z, z = std::sin(kYaw) * p.x + std::cos(kYaw) * p.z;
    spots.push_back({x, -(std::cos(kPitch) * p.y - std::sin(kPitch) * z)});
  }
  Spot low = spots[0], high = spots[0];
  for (const Spot& s : spots) {
    low = {std::min(low.x, s.x), std::min(low.y, s.y)};
    high = {std::max(high.x, s.x), std::max(high.y, s.y)};
  }
  const float side =
      std::max({(high.x - low.x) / (kPictureWidth - 2 * kRim), (high.y - low.y) / (kPictureHeight - 2 * kRim), 1e-20f});
  for (Spot& s : spots) {
    s.x = kPictureWidth / 2.0f + (s.x - (low.x + high.x) / 2) / side;
    s.y = kPictureHeight / 2.0f + (s.y - (low.y + high.y) / 2) / side;
  }
  return spots;
}

Image draw(const MapRig& rig, MaybeAxis up, const std::vector<Color>& colors) {
  Panel panel;
  const std::vector<Spot> spots = project(rig, up);
  for (const bool alone : {true, false}) {  // what is mapped lies on top
    for (size_t j = 0; j < spots.size(); ++j) {
      if ((colors[j] == kAlone) != alone) continue;
      const int parent = rig.joints[j].parent;
      if (parent >= 0) panel.line(spots[static_cast<size_t>(parent)], spots[j], 1.6f, colors[j]);
    }
  }
  for (const bool alone : {true, false}) {
    for (size_t j = 0; j < spots.size(); ++j)
      if ((colors[j] == kAlone) == alone) panel.disc(spots[j], alone ? 3.0f : 5.0f, colors[j]);
  }
  return panel.take();
}

}  // namespace

Image draw_map(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
               const MappedSkeleton& map) {
  std::vector<Color> left(target.joints.size(), kAlone), right(source.joints.size(), kAlone);
  for (size_t j = 0; j < left.size(); ++j) {
    if (map.sources[j] < 0) continue;
    left[j] = joint_color(j);
    right[static_cast<size_t>(map.sources[j])] = left[j];
  }
  return beside({draw(target, target_up, left), draw(source, source_up, right)});
}

namespace {

constexpr size_t kColumns = 8, kMostRows = 12;
constexpr int kSide = 300;

}  // namespace

Image motion_sheet(const Character& character, const Motion& motion, Axis up, CharacterDeformer* deformer,
                   const PictureFile* picture) {
  const auto colors = picture != nullptr ? picture_colors(*picture, character) : weight_colors(character);
  RenderOptions view;
  view.width = view.height = kSide;
  view.draw_skeleton = false;
  view.up = up;
  if (picture != nullptr) view.yaw_degrees = view.pitch_degrees = 0;
  Image sheet;
  for (size_t c = 0; c < std::min(motion.clips.size(), kMostRows); ++c) {
    const Clip& clip = motion.clips[c];
    std::vector<Character> poses;
    const size_t columns = std::min(kColumns, clip.frames.size());
    for (size_t i = 0; i < columns; ++i) {
      const size_t f = columns == 1 ? 0 : i * (clip.frames.size() - 1) / (columns - 1);
      const std::vector<Affine> palette = motion_palette(motion, clip.frames[f], character.joints.size());
      poses.push_back(deformer != nullptr ? deformer->pose_character(character, palette)
                                          : apply_pose(character, palette));
    }
    const PoseFrame frame = frame_poses(character, poses, up);
    view.focus_radius = frame.radius;
    std::vector<Image> row;
    for (size_t i = 0; i < columns; ++i) {
      view.focus = frame.middles[i];
      row.push_back(render(poses[i], colors, view));
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
