// SPDX-License-Identifier: MIT
// Frames of an animated picture, for sprite sheets and loops.
#include <algorithm>
#include <cmath>
#include <string>

#include "sinew_character/picture/sprites.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr size_t kMostShots = 4096;
constexpr double kFramesASecond = 15;
constexpr float kMargin = 2;  // pixels

struct Shot {
  std::string name;
  uint32_t milliseconds = 0;
  Character posed;
};

// Whether the last frame is the first one again, but for where the body stands.
bool comes_back(const Clip& clip) {
  const MotionFrame &first = clip.frames.front(), &last = clip.frames.back();
  for (size_t j = 0; j < first.rotations.size(); ++j) {
    double dot = 0;
    for (size_t k = 0; k < 4; ++k) dot += first.rotations[j][k] * last.rotations[j][k];
    if (std::abs(dot) < 0.9995) return false;
  }
  return true;
}

std::vector<double> seconds_of(const Clip& clip, size_t wanted) {
  const double last = static_cast<double>(clip.frames.size() - 1) * clip.frame_time;
  if (last <= 0) return {0};
  size_t count = wanted > 0 ? wanted : static_cast<size_t>(std::max(1.0, std::round(last * kFramesASecond)));
  const bool loops = comes_back(clip);
  if (wanted == 0 && !loops) ++count;
  std::vector<double> times;
  for (size_t i = 0; i < count; ++i)
    times.push_back(last * static_cast<double>(i) /
                    static_cast<double>(std::max<size_t>(1, loops ? count : count - 1)));
  return times;
}

// How far the body has gone from the first to the last frame, along x.
double way_of(const Motion& motion, const Clip& clip) {
  for (size_t j = 0; j < motion.joints.size(); ++j)
    if (motion.joints[j].parent < 0)
      return clip.frames.back().translations[j][0] - clip.frames.front().translations[j][0];
  return 0;
}

void add_shots(const Character& character, const Motion& motion, const Clip& clip, CharacterDeformer* deformer,
               size_t wanted, std::vector<Shot>* shots) {
  const std::vector<double> times = seconds_of(clip, wanted);
  const double last = static_cast<double>(clip.frames.size() - 1) * clip.frame_time, way = way_of(motion, clip);
  const double between = times.size() > 1 ? times[1] : std::max(last, 0.1);
  for (size_t i = 0; i < times.size(); ++i) {
    const std::vector<Affine> palette = motion_palette(motion, frame_at(clip, times[i]), character.joints.size());
    Shot shot;
    shot.name = clip.name + " " + std::to_string(i);
    shot.milliseconds = static_cast<uint32_t>(std::lround(1000 * between));
    shot.posed = deformer != nullptr ? deformer->pose_character(character, palette) : apply_pose(character, palette);
    const auto gone = static_cast<float>(last > 0 ? way * times[i] / last : 0);
    for (Vec3& v : shot.posed.vertices) v.x -= gone;
    shots->push_back(std::move(shot));
  }
}

// In the rest pose: pixels of the picture per unit of the mesh.
float pixels_of(const PictureFile& picture, const Character& character) {
  float low = 1e9f, high = -1e9f, left = 1e9f, right = -1e9f;
  for (const auto& uv : character.corner_uvs) {
    const PicturePoint seen = seen_point(picture, {uv[0], 1 - uv[1]});
    left = std::min(left, seen.u), right = std::max(right, seen.u);
    low = std::min(low, seen.v), high = std::max(high, seen.v);
  }
  const float width = (right - left) * static_cast<float>(picture.pixels.width),
              height = (high - low) * static_cast<float>(picture.pixels.height);
  const Box box = box_of(character.vertices);
  return std::max(width, height) / std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1e-6f});
}

}  // namespace

std::vector<SpriteFrame> picture_frames(const PictureFile& picture, const Character& character, const Motion& motion,
                                        CharacterDeformer* deformer, const FrameOptions& options) {
  std::vector<Shot> shots;
  for (const Clip& clip : motion.clips) {
    const size_t more = seconds_of(clip, options.count).size();
    if (shots.size() + more > kMostShots)
      throw Error(picture.name + ": expected " + std::to_string(kMostShots) + " frames at most, found " +
                  std::to_string(shots.size() + more) + "; use fewer clips or frames");
    add_shots(character, motion, clip, deformer, options.count, &shots);
  }
  if (shots.empty()) throw Error(picture.name + ": no clip to draw");
  Box all = box_of(shots[0].posed.vertices);
  for (const Shot& shot : shots) {
    const Box box = box_of(shot.posed.vertices);
    all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y), 0};
    all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y), 0};
  }
  const float w = all.high.x - all.low.x, h = all.high.y - all.low.y;
  PlaneWindow window;
  window.pixels = std::min((static_cast<float>(options.side) - 2 * kMargin) / std::max({w, h, 1e-6f}),
                           pixels_of(picture, character));
  window.left = all.low.x - kMargin / window.pixels;
  window.top = all.high.y + kMargin / window.pixels;
  window.width = static_cast<uint32_t>(std::ceil(w * window.pixels + 2 * kMargin));
  window.height = static_cast<uint32_t>(std::ceil(h * window.pixels + 2 * kMargin));
  std::vector<SpriteFrame> frames;
  for (const Shot& shot : shots)
    frames.push_back({shot.name, draw_in_plane(picture, shot.posed, window), shot.milliseconds});
  return frames;
}

}  // namespace sinew
