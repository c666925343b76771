// SPDX-License-Identifier: MIT
// Frames spread over all clips; means of rotations by the sum of quaternions on one side.
#include <algorithm>
#include <numeric>

#include "sinew_character/motion/stance.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr size_t kMostFrames = 400;
constexpr double kAlike = 0.1;  // of a length, by how much mirror images may differ

// Near the mean of a few rounds, each with all quaternions on its side.
Quaternion mean_of(const std::vector<Quaternion>& all) {
  Quaternion mean = all.empty() ? kNoRotation4 : all[0];
  for (int round = 0; round < 3; ++round) {
    Quaternion sum{};
    for (const Quaternion& q : all) {
      const double sign = dot(q, mean) < 0 ? -1 : 1;
      for (size_t i = 0; i < 4; ++i) sum[i] += sign * q[i];
    }
    mean = normalized(sum);
  }
  return mean;
}

}  // namespace

MovingJoints::MovingJoints(const Motion& motion) : motion_(motion), tree_(motion.joints) {
  size_t frames = 0;
  for (const Clip& clip : motion.clips) frames += clip.frames.size();
  const size_t step = std::max<size_t>(1, (frames + kMostFrames - 1) / kMostFrames);
  size_t at = 0;
  for (const Clip& clip : motion.clips)
    for (const MotionFrame& frame : clip.frames)
      if (at++ % step == 0) poses_.push_back(world_pose(motion, frame));
  below_.assign(motion.joints.size(), 1);
  for (const MotionJoint& joint : motion.joints) lengths_.push_back(joint.parent < 0 ? 0 : length(joint.offset));
  for (size_t k = tree_.parents_first.size(); k-- > 0;) {
    const size_t j = tree_.parents_first[k];
    if (motion.joints[j].parent < 0) continue;
    below_[static_cast<size_t>(motion.joints[j].parent)] += below_[j];
    lengths_[static_cast<size_t>(motion.joints[j].parent)] += lengths_[j];
  }
}

std::vector<size_t> MovingJoints::best_frames(double share, const std::function<double(size_t)>& value) const {
  std::vector<double> values;
  for (size_t f = 0; f < poses_.size(); ++f) values.push_back(value(f));
  std::vector<size_t> frames(poses_.size());
  std::iota(frames.begin(), frames.end(), size_t{0});
  std::stable_sort(frames.begin(), frames.end(), [&](size_t a, size_t b) { return values[a] > values[b]; });
  frames.resize(std::max<size_t>(1, static_cast<size_t>(share * static_cast<double>(frames.size()))));
  return frames;
}

Quaternion MovingJoints::mean_rotation(const std::vector<size_t>& frames, int from, int joint) const {
  std::vector<Quaternion> all;
  for (const size_t f : frames) all.push_back(multiply(conjugate(rotation(f, from)), rotation(f, joint)));
  return mean_of(all);
}

Point3 MovingJoints::mean_difference(const std::vector<size_t>& frames, int from, int first, int last) const {
  Point3 sum{};
  for (const size_t f : frames)
    sum = sum + rotate(conjugate(rotation(f, from)), position(f, last) - position(f, first));
  return (1.0 / static_cast<double>(frames.size())) * sum;
}

Point3 MovingJoints::mean_direction(const std::vector<size_t>& frames, int from, const Point3& direction) const {
  Point3 sum{};
  for (const size_t f : frames) sum = sum + rotate(conjugate(rotation(f, from)), direction);
  return unit(sum);
}

bool MovingJoints::is_still(int joint) const {
  return std::all_of(poses_.begin(), poses_.end(), [&](const WorldPose& pose) {
    const size_t j = static_cast<size_t>(joint);
    return std::abs(dot(pose.rotations[j], poses_[0].rotations[j])) > 1 - 1e-6;
  });
}

std::vector<Point3> MovingJoints::posed(const std::vector<Quaternion>& rotations) const {
  std::vector<Point3> positions(rotations.size());
  for (const size_t j : tree_.parents_first) {
    const int up = motion_.joints[j].parent;
    if (up >= 0)
      positions[j] =
          positions[static_cast<size_t>(up)] + rotate(rotations[static_cast<size_t>(up)], motion_.joints[j].offset);
  }
  return positions;
}

int MovingJoints::trunk_root() const {
  int best = -1;
  for (size_t j = 0; j < motion_.joints.size(); ++j)
    if (motion_.joints[j].parent < 0 && (best < 0 || below_[j] > below_[static_cast<size_t>(best)]))
      best = static_cast<int>(j);
  while (best >= 0 && tree_.children[static_cast<size_t>(best)].size() == 1)
    best = tree_.children[static_cast<size_t>(best)][0];
  return best;
}

void MovingJoints::pair_below(int a, int b, std::vector<std::pair<int, int>>* pairs) const {
  std::vector<std::pair<int, int>> queue = {{a, b}};
  for (size_t i = 0; i < queue.size(); ++i) {
    pairs->push_back(queue[i]);
    const std::vector<int>& first = tree_.children[static_cast<size_t>(queue[i].first)];
    const std::vector<int>& second = tree_.children[static_cast<size_t>(queue[i].second)];
    for (size_t k = 0; k < first.size() && first.size() == second.size(); ++k) queue.emplace_back(first[k], second[k]);
  }
}

std::vector<std::pair<int, int>> MovingJoints::mirror_pairs() const {
  std::vector<std::pair<int, int>> pairs;
  std::vector<char> taken(motion_.joints.size(), 0);
  const auto alike = [&](int a, int b) {
    const size_t x = static_cast<size_t>(a), y = static_cast<size_t>(b);
    const double more = std::max(lengths_[x], lengths_[y]);
    return below_[x] == below_[y] && below_[x] > 2 && std::abs(lengths_[x] - lengths_[y]) <= kAlike * more;
  };
  for (const size_t j : tree_.parents_first) {
    const int up = motion_.joints[j].parent;
    if (up >= 0 && taken[static_cast<size_t>(up)] != 0) taken[j] = 1;  // inside of a pair
    if (taken[j] != 0) continue;
    for (size_t a = 0; a < tree_.children[j].size(); ++a)
      for (size_t b = a + 1; b < tree_.children[j].size(); ++b) {
        const int x = tree_.children[j][a], y = tree_.children[j][b];
        if (taken[static_cast<size_t>(x)] != 0 || taken[static_cast<size_t>(y)] != 0 || !alike(x, y)) continue;
        taken[static_cast<size_t>(x)] = taken[static_cast<size_t>(y)] = 1;
        pair_below(x, y, &pairs);
      }
  }
  return pairs;
}

}  // namespace sinew
