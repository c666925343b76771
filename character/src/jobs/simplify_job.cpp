// SPDX-License-Identifier: MIT
// Fewer joints, and motion for them.
#include "sinew_character/jobs/simplify_job.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sinew_character/motion/retarget.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {
namespace {

constexpr double kMostError = 0.0095;  // of the height; the promise is 1 %
constexpr size_t kSampledFrames = 24;  // over all clips
constexpr size_t kSampledVertices = 6000;
constexpr size_t kMostRounds = 64;

struct Sample {
  Vec3 at;
  std::vector<Influence> influences;
};

// Vertices with their weights; joints where nothing has any.
std::vector<Sample> samples_of(const Character& c) {
  std::vector<Sample> samples;
  const size_t step = c.influences.size() / kSampledVertices + 1;
  for (size_t v = 0; v < c.influences.size(); v += step)
    if (!c.influences[v].empty()) samples.push_back({c.vertices[v], c.influences[v]});
  if (!samples.empty()) return samples;
  for (size_t j = 0; j < c.joints.size(); ++j)
    samples.push_back({c.joints[j].position, {{static_cast<uint32_t>(j), 1.0f}}});
  return samples;
}

double height_of(const std::vector<Sample>& samples) {
  double low[3] = {}, high[3] = {}, height = 0;
  for (const Sample& sample : samples) {
    const double at[3] = {sample.at.x, sample.at.y, sample.at.z};
    for (size_t axis = 0; axis < 3; ++axis) {
      low[axis] = &sample == samples.data() ? at[axis] : std::min(low[axis], at[axis]);
      high[axis] = &sample == samples.data() ? at[axis] : std::max(high[axis], at[axis]);
      height = std::max(height, high[axis] - low[axis]);
    }
  }
  return height;
}

// How far a sample moves in one pose because its joints became parts of others.
double error_of(const Sample& sample, const std::vector<Affine>& palette, const std::vector<uint32_t>& into) {
  Point3 moved = {};
  for (const Influence& influence : sample.influences) {
    if (into[influence.joint] == influence.joint) continue;
    const Vec3& at = sample.at;
    const Point3 was = transform_point(palette[influence.joint], at.x, at.y, at.z),
                 is = transform_point(palette[into[influence.joint]], at.x, at.y, at.z);
    for (size_t axis = 0; axis < 3; ++axis) moved[axis] += influence.weight * (was[axis] - is[axis]);
  }
  return std::sqrt(moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2]);
}

std::vector<std::vector<Affine>> sampled_poses(const std::vector<const Motion*>& motions, size_t joints) {
  size_t frames = 0, number = 0;
  for (const Motion* motion : motions)
    for (const Clip& clip : motion->clips) frames += clip.frames.size();
  const size_t step = std::max<size_t>(1, frames / kSampledFrames);
  std::vector<std::vector<Affine>> poses;
  for (const Motion* motion : motions)
    for (const Clip& clip : motion->clips)
      for (const MotionFrame& frame : clip.frames)
        if (number++ % step == 0) poses.push_back(motion_palette(*motion, frame, joints));
  return poses;
}

// Joints that must stay for the motions' sake.
std::vector<uint32_t> joints_that_move(const SimplifyOptions& options, const std::vector<const Motion*>& motions,
                                       const Character& character) {
  SimplifyOptions own = options;
  const std::vector<std::vector<Affine>> poses = sampled_poses(motions, character.joints.size());
  if (poses.empty()) return own.keep_joints;
  const std::vector<Sample> samples = samples_of(character);
  const double limit = kMostError * height_of(samples);
  for (size_t round = 0; round < kMostRounds; ++round) {
    const std::vector<uint32_t> into = joints_to_merge(own, character);
    std::vector<uint8_t> stays(character.joints.size(), 0);
    for (const Sample& sample : samples) {
      for (const std::vector<Affine>& palette : poses) {
        if (error_of(sample, palette, into) <= limit) continue;
        const Influence* most = nullptr;
        for (const Influence& one : sample.influences)
          if (into[one.joint] != one.joint && (most == nullptr || one.weight > most->weight)) most = &one;
        if (most != nullptr) stays[most->joint] = 1;
        break;
      }
    }
    const size_t before = own.keep_joints.size();
    for (size_t j = 0; j < stays.size(); ++j)
      if (stays[j] != 0) own.keep_joints.push_back(static_cast<uint32_t>(j));
    if (own.keep_joints.size() == before) break;
  }
  return own.keep_joints;
}

// A remark where the file's springs lose chains with their joints; "" where they do not, or where `check` has to speak of broken ones.
std::string lost_chains_text(const Character& before, const Character& after) {
  try {
    const std::optional<Springs> all = read_springs(before.name, before), left = read_springs(after.name, after);
    const size_t had = all ? all->chains.size() : 0, has = left ? left->chains.size() : 0;
    if (has >= had) return "";
    return std::to_string(had - has) + " of " + std::to_string(had) +
           " chains that swing are left out with their joints; keep them with --level high or a larger number of "
           "joints";
  } catch (const Error&) {
    return "";
  }
}

}  // namespace

SimplifiedCharacter simplify_character(const SimplifyOptions& options, const std::vector<const Motion*>& motions,
                                       Character* character) {
  Character left = *character;
  SimplifyOptions own = options;
  if (!options.low && options.joints == 0 && !options.as_drawn)
    own.keep_joints = joints_that_move(options, motions, *character);
  SimplifiedCharacter out;
  out.simplified = simplify_skeleton(own, &left);
  out.motion = motion_of(left.joints);
  std::vector<int> sources(left.joints.size(), -1);
  for (size_t j = 0; j < out.simplified.number.size(); ++j)
    if (out.simplified.number[j] >= 0) sources[static_cast<size_t>(out.simplified.number[j])] = static_cast<int>(j);
  RetargetSettings settings;
  settings.method = SINEW_RETARGET_COPY;
  settings.scale = 1;
  for (const Motion* one : motions) {
    Retargeter retargeter(*one, left.joints, sources, std::vector<uint8_t>(left.joints.size(), SINEW_CLASS_OTHER),
                          settings);
    for (const Clip& clip : one->clips) out.motion.clips.push_back(retargeter.run(clip));
  }
  if (std::string text = lost_chains_text(*character, left); !text.empty()) left.notes.push_back(std::move(text));
  *character = std::move(left);
  return out;
}

}  // namespace sinew
