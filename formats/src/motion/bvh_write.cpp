// SPDX-License-Identifier: MIT
// A clip as BVH.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "text/decimal.hpp"
#include "text/joint_names.hpp"

namespace sinew {
namespace {

// Angles of R = Rz Rx Ry in degrees; where x is a rotation by 90 degrees, only a sum of the others is known and y is 0.
Point3 angles_zxy(const Quaternion& q) {
  const Rotation r = rotation_of(q);
  const double sine = std::clamp(r[7], -1.0, 1.0);
  constexpr double kDegrees = 180 / std::numbers::pi;
  const double x = std::asin(sine);
  if (std::abs(sine) > 1 - 1e-10) return {std::atan2(r[3], r[0]) * kDegrees, x * kDegrees, 0};
  return {std::atan2(-r[1], r[4]) * kDegrees, x * kDegrees, std::atan2(-r[6], r[8]) * kDegrees};
}

std::string length_text(double value) { return shortest_decimal(static_cast<float>(value) + 0.0f); }
std::string angle_text(double value) {
  const std::string text = fixed_decimal(value, 6);
  return text == "-0.000000" ? "0.000000" : text;
}

class BvhWriter {
 public:
  BvhWriter(const std::string& path, const Motion& motion, const Clip& clip) : motion_(motion), clip_(clip) {
    std::vector<Joint> named;
    for (const MotionJoint& joint : motion.joints) named.push_back({joint.name, {}, joint.parent});
    names_ = names_without_blanks(named);
    children_.resize(motion.joints.size());
    for (size_t j = 0; j < motion.joints.size(); ++j) {
      const int parent = motion.joints[j].parent;
      if (parent >= 0)
        children_[static_cast<size_t>(parent)].push_back(j);
      else
        roots_.push_back(j);
    }
    if (roots_.empty()) throw Error(path + ": cannot write a BVH without a root joint");
    find_moving();
  }

  std::string text() {
    text_ = "HIERARCHY\n";
    write_tree();
    text_ += "MOTION\nFrames: " + std::to_string(clip_.frames.size()) +
             "\nFrame Time: " + print("%.10g", clip_.frame_time) + "\n";
    for (const MotionFrame& frame : clip_.frames) write_frame(frame);
    return std::move(text_);
  }

 private:
  void find_moving() {
    double size = 0;
    for (const MotionJoint& joint : motion_.joints)
      for (const double x : joint.offset) size = std::max(size, std::abs(x));
    for (size_t j = 0; j < motion_.joints.size(); ++j) {
      bool moves = motion_.joints[j].parent < 0;
      for (const MotionFrame& frame : clip_.frames)
        for (size_t i = 0; i < 3; ++i)
          moves = moves || std::abs(frame.translations[j][i] - motion_.joints[j].offset[i]) > 1e-5 * size;
      moving_.push_back(moves);
    }
  }

  // An End Site is the only child of its joint.
  bool is_end_site(size_t j) const {
    const int parent = motion_.joints[j].parent;
    return motion_.joints[j].end && parent >= 0 && children_[static_cast<size_t>(parent)].size() == 1;
  }

  void line(size_t depth, const std::string& words) { text_ += std::string(depth, '\t') + words + "\n"; }
  void offset(size_t depth, const Point3& p) {
    line(depth, "OFFSET " + length_text(p[0]) + " " + length_text(p[1]) + " " + length_text(p[2]));
  }
  void end_site(size_t depth, const Point3& p) {
    line(depth, "End Site");
    line(depth, "{");
    offset(depth + 1, p);
    line(depth, "}");
  }

  // Depth first, without recursion: a joint is on the stack once to be opened and once to be closed.
  void write_tree() {
    struct Step {
      size_t joint, depth;
      bool closes;
    };
    std::vector<Step> stack;
    for (size_t r = roots_.size(); r-- > 0;) stack.push_back({roots_[r], 0, false});
    while (!stack.empty()) {
      const Step step = stack.back();
      stack.pop_back();
      if (step.closes) {
        line(step.depth, "}");
        continue;
      }
      const MotionJoint& joint = motion_.joints[step.joint];
      if (is_end_site(step.joint)) {
        end_site(step.depth, joint.offset);
        continue;
      }
      line(step.depth, (joint.parent < 0 ? "ROOT " : "JOINT ") + names_[step.joint]);
      line(step.depth, "{");
      offset(step.depth + 1, joint.offset);
      line(step.depth + 1, moving_[step.joint]
                               ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"
                               : "CHANNELS 3 Zrotation Xrotation Yrotation");
      columns_.push_back(step.joint);
      if (children_[step.joint].empty())  // other readers want one: half a bone on
        end_site(step.depth + 1, {0.5 * joint.offset[0], 0.5 * joint.offset[1], 0.5 * joint.offset[2]});
      stack.push_back({step.joint, step.depth, true});
      const std::vector<size_t>& below = children_[step.joint];
      for (size_t c = below.size(); c-- > 0;) stack.push_back({below[c], step.depth + 1, false});
    }
  }

  void write_frame(const MotionFrame& frame) {
    std::string row;
    for (const size_t j : columns_) {
      if (moving_[j])
        for (const double x : frame.translations[j]) row += length_text(x) + " ";
      for (const double angle : angles_zxy(frame.rotations[j])) row += angle_text(angle) + " ";
    }
    if (!row.empty()) row.pop_back();
    text_ += row + "\n";
  }

  const Motion& motion_;
  const Clip& clip_;
  std::vector<std::string> names_;
  std::vector<std::vector<size_t>> children_;
  std::vector<size_t> roots_, columns_;
  std::vector<bool> moving_;
  std::string text_;
};

}  // namespace

void write_bvh(const std::string& path, const Motion& motion, const Clip& clip) {
  write_text_file(path, BvhWriter(path, motion, clip).text());
}

}  // namespace sinew
