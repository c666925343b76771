// SPDX-License-Identifier: MIT
// A skeleton from joints that are posed: who carries whom.
#include "motion/posed_joints.hpp"

#include <algorithm>
#include <cmath>

#include "motion/named_skeletons.hpp"
#include "motion/person.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/print.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kCarried = 0.01;    // of the body's size: how far a carried joint may move in its parent's axes
constexpr double kAsClosely = 1e-4;  // of the body's size: parents that carry a joint as closely as the best one
constexpr size_t kMostFramesTried = 64, kMostJoints = 512;

class PosedSkeleton {
 public:
  PosedSkeleton(const std::string& file, const PosedJoints& joints) : file_(file), joints_(joints) {
    for (const Point3& p : joints.positions[0]) size_ = std::max(size_, 2 * length(p - joints.positions[0][0]));
    step_ = (joints.positions.size() + kMostFramesTried - 1) / kMostFramesTried;
  }

  Motion read() {
    find_names();
    Motion motion;
    for (size_t j = 0; j < parents_.size(); ++j) {
      const std::string& name = names_[j];
      const bool end = name.size() > 3 && name.compare(name.size() - 3, 3, "End") == 0;
      const Point3 offset = parents_[j] < 0 ? Point3{} : carry(static_cast<size_t>(parents_[j]), j).offset;
      motion.joints.push_back({name, parents_[j], offset, end});
    }
    motion.joints[0].offset = {0, -lowest_at_rest(motion), 0};  // the lowest joint is on the floor
    Clip clip;
    for (size_t f = 0; f < joints_.positions.size(); ++f) clip.frames.push_back(frame_at(motion, f));
    motion.clips.push_back(std::move(clip));
    motion.notes.push_back(note_);
    return motion;
  }

 private:
  // The mean offset of a joint in the axes of another, and how far it is from that at most.
  struct Carry {
    Point3 offset{};
    double deviation = 0;
  };

  Carry carry(size_t parent, size_t joint) const {
    std::vector<Point3> offsets;
    Carry out;
    for (size_t f = 0; f < joints_.positions.size(); f += step_) {
      const std::vector<Point3>& at = joints_.positions[f];
      offsets.push_back(rotate(conjugate(joints_.rotations[f][parent]), at[joint] - at[parent]));
      out.offset = out.offset + offsets.back();
    }
    out.offset = (1 / static_cast<double>(offsets.size())) * out.offset;
    for (const Point3& offset : offsets) out.deviation = std::max(out.deviation, length(offset - out.offset));
    return out;
  }

  void find_names() {
    const size_t count = joints_.positions[0].size();
    for (const NamedSkeleton& skeleton : named_skeletons())
      if (skeleton.joints.size() == count && is_carried_by(skeleton.parents)) {
        names_ = skeleton.joints;
        parents_ = skeleton.parents;
        note_ = std::string("the skeleton was taken as ") + skeleton.name +
                ", from its number of joints and their motion; rename joints if wrong";
        return;
      }
    if (count > kMostJoints)
      throw Error(file_ + ": expected at most " + std::to_string(kMostJoints) + " joints, found " +
                  std::to_string(count));
    for (size_t j = 0; j < count; ++j) {
      names_.push_back("joint_" + std::to_string(j));
      parents_.push_back(j == 0 ? -1 : static_cast<int>(parent_of(j)));
    }
    note_ = print(
        "%zu joints match no known skeleton, so their parents were guessed from the motion, without names; check the "
        "result",
        count);
  }

  bool is_carried_by(const std::vector<int>& parents) const {
    for (size_t j = 1; j < parents.size(); ++j)
      if (carry(static_cast<size_t>(parents[j]), j).deviation > kCarried * size_) return false;
    return true;
  }

  // The nearest of the joints before it that carry it most closely.
  size_t parent_of(size_t joint) const {
    std::vector<Carry> all;
    double least = 1e300, nearest = 1e300;
    for (size_t p = 0; p < joint; ++p) {
      all.push_back(carry(p, joint));
      least = std::min(least, all.back().deviation);
    }
    if (least > kCarried * size_)
      throw Error(
          file_ + ": expected rotations that move the joints, found joint " + std::to_string(joint) +
          print(" that moves by %.1f %% of the body's size in the axes of each joint before it", 100 * least / size_));
    size_t best = 0;
    for (size_t p = 0; p < joint; ++p) {
      const double distance = length(all[p].offset);
      if (all[p].deviation > least + kAsClosely * size_ || distance >= nearest) continue;
      nearest = distance;
      best = p;
    }
    return best;
  }

  MotionFrame frame_at(const Motion& motion, size_t f) const {
    MotionFrame frame;
    for (size_t j = 0; j < parents_.size(); ++j) {
      const MotionJoint& joint = motion.joints[j];
      const Quaternion& own = joints_.rotations[f][j];
      const Quaternion local =
          joint.parent < 0 ? own : multiply(conjugate(joints_.rotations[f][static_cast<size_t>(joint.parent)]), own);
      frame.rotations.push_back(joint.end ? kNoRotation4 : normalized(local));
      frame.translations.push_back(joint.parent < 0 ? joints_.positions[f][j] : joint.offset);
    }
    return frame;
  }

  const std::string& file_;
  const PosedJoints& joints_;
  double size_ = 0;
  size_t step_ = 1;  // between the frames that are asked
  std::vector<std::string> names_;
  std::vector<int> parents_;
  std::string note_;
};

}  // namespace

Motion motion_of_posed_joints(const std::string& file, const PosedJoints& joints) {
  return PosedSkeleton(file, joints).read();
}

}  // namespace sinew
