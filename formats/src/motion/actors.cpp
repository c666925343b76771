// SPDX-License-Identifier: MIT
// Several people in one file: the skeletons that stand side by side.
#include <algorithm>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/motion.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr size_t kLeastJoints = 8, kLeastLeaves = 5, kLeastShare = 2;  // of the largest, one part in so many
constexpr size_t kNone = static_cast<size_t>(-1);

class ActorFinder {
 public:
  explicit ActorFinder(const Motion& motion) : motion_(motion), children_(motion.joints.size()) {
    for (size_t j = 0; j < motion.joints.size(); ++j) {
      if (const int parent = motion.joints[j].parent; parent >= 0)
        children_[static_cast<size_t>(parent)].push_back(j);
      else
        roots_.push_back(j);
    }
    std::vector<size_t> order = roots_;
    for (size_t next = 0; next < order.size(); ++next)
      order.insert(order.end(), children_[order[next]].begin(), children_[order[next]].end());
    sizes_.assign(motion.joints.size(), 1);
    leaves_.assign(motion.joints.size(), 0);
    for (size_t k = order.size(); k-- > 0;) {
      const size_t j = order[k];
      if (children_[j].empty()) leaves_[j] = 1;
      if (motion.joints[j].parent < 0) continue;
      sizes_[static_cast<size_t>(motion.joints[j].parent)] += sizes_[j];
      leaves_[static_cast<size_t>(motion.joints[j].parent)] += leaves_[j];
    }
  }

  // Where one root carries all, what stands side by side below it. A body's own parts are no actors: limbs have few ends, and two with hands are mirror images.
  std::vector<size_t> actors() const {
    std::vector<size_t> found = bodies(roots_);
    if (found.size() != 1) return has_mirrored(found) ? std::vector<size_t>() : found;
    size_t carrier = found[0];
    while (children_[carrier].size() == 1) carrier = children_[carrier][0];
    const std::vector<size_t> below = bodies(children_[carrier]);
    return below.size() > 1 && !has_mirrored(below) ? below : found;
  }

  // A joint and all below it, depth first.
  std::vector<size_t> below(size_t root) const {
    std::vector<size_t> list, open = {root};
    while (!open.empty()) {
      const size_t j = open.back();
      open.pop_back();
      list.push_back(j);
      open.insert(open.end(), children_[j].rbegin(), children_[j].rend());
    }
    return list;
  }

  // Numbers of children, depth first: two skeletons of one rig have the same.
  std::vector<size_t> shape(size_t root) const {
    std::vector<size_t> counts;
    for (const size_t j : below(root)) counts.push_back(children_[j].size());
    return counts;
  }

 private:
  std::vector<size_t> bodies(const std::vector<size_t>& candidates) const {
    size_t largest = 0;
    for (const size_t j : candidates) largest = std::max(largest, sizes_[j]);
    std::vector<size_t> found;
    for (const size_t j : candidates)
      if (sizes_[j] >= kLeastJoints && leaves_[j] >= kLeastLeaves && kLeastShare * sizes_[j] >= largest)
        found.push_back(j);
    return found;
  }

  bool has_mirrored(const std::vector<size_t>& candidates) const {
    for (size_t a = 0; a < candidates.size(); ++a)
      for (size_t b = a + 1; b < candidates.size(); ++b)
        if (are_mirrored(candidates[a], candidates[b])) return true;
    return false;
  }
  // Whether the bones below are of one shape and mirrored across an axis, not the same. People of one rig have the same ones.
  bool are_mirrored(size_t a, size_t b) const {
    if (shape(a) != shape(b)) return false;
    const std::vector<size_t> first = below(a), second = below(b);
    double same = 0;
    Point3 mirrored{};
    for (size_t k = 1; k < first.size(); ++k) {
      const Point3 &one = motion_.joints[first[k]].offset, &other = motion_.joints[second[k]].offset;
      same += length(one - other);
      for (size_t axis = 0; axis < 3; ++axis) {
        Point3 image = other;
        image[axis] = -image[axis];
        mirrored[axis] += length(one - image);
      }
    }
    return 4 * std::min({mirrored[0], mirrored[1], mirrored[2]}) < same;
  }

  const Motion& motion_;
  std::vector<std::vector<size_t>> children_;
  std::vector<size_t> roots_, sizes_, leaves_;  // joints and ends below each, itself among them
};

// The joints below `root` and those above it, which carry it.
Motion part_of(const Motion& motion, const std::vector<size_t>& below) {
  std::vector<size_t> kept = below;
  for (int j = motion.joints[below[0]].parent; j >= 0; j = motion.joints[static_cast<size_t>(j)].parent)
    kept.push_back(static_cast<size_t>(j));
  std::sort(kept.begin(), kept.end());
  std::vector<int> index(motion.joints.size(), -1);
  for (size_t k = 0; k < kept.size(); ++k) index[kept[k]] = static_cast<int>(k);
  Motion part = {motion.name, {}, {}, motion.notes};
  for (const size_t j : kept) {
    MotionJoint joint = motion.joints[j];
    if (joint.parent >= 0) joint.parent = index[static_cast<size_t>(joint.parent)];
    part.joints.push_back(std::move(joint));
  }
  for (const Clip& clip : motion.clips) {
    Clip& own = part.clips.emplace_back(Clip{clip.name, clip.frame_time, {}});
    for (const MotionFrame& frame : clip.frames) {
      MotionFrame& out = own.frames.emplace_back();
      for (const size_t j : kept) {
        out.rotations.push_back(frame.rotations[j]);
        out.translations.push_back(frame.translations[j]);
      }
    }
  }
  return part;
}

}  // namespace

std::optional<Motion> one_actor(const Motion& motion, const std::string& file, const std::string& actor) {
  const ActorFinder finder(motion);
  const std::vector<size_t> actors = finder.actors();
  std::string names;
  bool alike = actors.size() > 1;
  for (const size_t root : actors) {
    names += (names.empty() ? "" : ", ") + in_quotes(motion.joints[root].name);
    alike = alike && finder.shape(root) == finder.shape(actors[0]);
  }
  size_t chosen = kNone;
  for (size_t a = actors.size(); a-- > 0;)
    if (motion.joints[actors[a]].name == actor) chosen = a;
  const std::optional<int64_t> number = actor.empty() ? std::nullopt : to_integer(actor);
  if (chosen == kNone && number && *number >= 0 && static_cast<size_t>(*number) < actors.size())
    chosen = static_cast<size_t>(*number);
  if (chosen == kNone && !actor.empty())
    throw Error(file + ": expected one of its " + std::to_string(actors.size()) + " actors, " +
                (names.empty() ? "of which there are none" : names) + ", found " + in_quotes(actor));
  if (actor.empty() && !alike) return std::nullopt;
  Motion part = part_of(motion, finder.below(actors[actor.empty() ? 0 : chosen]));
  if (actor.empty())
    part.notes.push_back("has " + std::to_string(actors.size()) + " actors, " + names +
                         "; the first one plays, choose another with --actor");
  return part;
}

}  // namespace sinew
