// SPDX-License-Identifier: MIT
// Animations: feet against the floor, joints against the frame before.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "check/findings.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/median.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr double kNear = 0.015;  // of the height: a foot this near to its lowest stands

class ClipCheck {
 public:
  ClipCheck(const RigFacts& facts, const Motion& motion, const Clip& clip, Findings* findings)
      : facts_(facts), motion_(motion), clip_(clip), findings_(findings) {
    for (const MotionFrame& frame : clip.frames) poses_.push_back(world_pose(motion, frame));
    const Box box = box_of(facts.character.vertices.empty() ? positions() : facts.character.vertices);
    height_ = static_cast<double>(box.high.y - box.low.y);
    if (!(height_ > 0)) height_ = facts.size;
    floor_ = static_cast<double>(box.low.y);
    for (size_t j = 0; j < facts.character.joints.size(); ++j)
      if (is_foot(j)) feet_.push_back(j);
  }

  void look() {
    if (poses_.empty()) return;
    turns_over();
    jumps();
    if (feet_.size() < 2) return;
    heights();
    slides();
  }

 private:
  std::vector<Vec3> positions() const {
    std::vector<Vec3> out;
    for (const Joint& joint : facts_.character.joints) out.push_back(joint.position);
    return out;
  }

  // The first foot of each leg.
  bool is_foot(size_t joint) const {
    if (facts_.verdicts.classes[joint] != SINEW_CLASS_FOOT || facts_.verdicts.roles[joint] != SINEW_ROLE_DEFORMS)
      return false;
    for (int up = facts_.character.joints[joint].parent; up >= 0;
         up = facts_.character.joints[static_cast<size_t>(up)].parent)
      if (facts_.verdicts.classes[static_cast<size_t>(up)] == SINEW_CLASS_FOOT) return false;
    return static_cast<double>(facts_.character.joints[joint].position.y) - floor_ < 0.25 * height_;
  }

  // Over where it stands at rest, of the height.
  double lifted(size_t frame, size_t foot) const {
    return (poses_[frame].positions[foot][1] - static_cast<double>(facts_.character.joints[foot].position.y)) / height_;
  }

  RigFinding finding_at(size_t joint, size_t frame) const {
    RigFinding finding;
    finding.joint = static_cast<int>(joint);
    finding.clip = clip_.name;
    finding.seconds = clip_.frame_time * static_cast<double>(frame);
    return finding;
  }

  void turns_over() {
    for (size_t j = 0; j < motion_.joints.size() && j < facts_.character.joints.size(); ++j) {
      double worst = 1;
      size_t at = 0;
      for (size_t f = 1; f < clip_.frames.size(); ++f) {
        const double c = std::abs(inner(f - 1, f, j));
        if (c >= worst) continue;
        // Turning on at that rate is a spin. There and back is a flip of one frame.
        const auto quick = [&](size_t from, size_t to) { return std::abs(inner(from, to, j)) < kQuick; };
        if (f >= 2 && quick(f - 2, f - 1) && quick(f - 2, f)) continue;
        if (f + 1 < clip_.frames.size() && quick(f, f + 1) && quick(f - 1, f + 1)) continue;
        worst = c, at = f;
      }
      if (at == 0) continue;
      RigFinding finding = finding_at(j, at);
      finding.value = std::round(2 * std::acos(std::min(1.0, worst)) * 180 / std::numbers::pi);
      finding.what = findings_->quoted(finding.joint) + print(" rotates by %.0f degrees within a frame", finding.value);
      findings_->add("clip-flip", std::move(finding));
    }
  }

  static constexpr double kQuick = 0.96592582628906829;  // cosine of 15 degrees: half of 30
  double inner(size_t a, size_t b, size_t joint) const {
    const Quaternion &p = clip_.frames[a].rotations[joint], &q = clip_.frames[b].rotations[joint];
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
  }

  double step(size_t frame, size_t joint) const {
    return length(poses_[frame].positions[joint] - poses_[frame - 1].positions[joint]) / height_;
  }

  // Steps of a root that are much longer than those around them.
  void jumps() {
    constexpr double kMuchLonger = 5;
    for (size_t j = 0; j < facts_.character.joints.size() && j < motion_.joints.size(); ++j) {
      if (facts_.character.joints[j].parent >= 0) continue;
      RigFinding worst;
      for (size_t f = 1; f < poses_.size(); ++f) {
        const double here = step(f, j);
        const double before = f >= 2 ? step(f - 1, j) : 0, after = f + 1 < poses_.size() ? step(f + 1, j) : 0;
        if (here <= worst.value || here < kMuchLonger * std::max(before, after)) continue;
        worst = finding_at(j, f);
        worst.value = here;
      }
      if (worst.joint < 0) continue;
      worst.what = findings_->quoted(worst.joint) + print(" moves by %.2f of the height within a frame", worst.value);
      findings_->add("clip-jump", std::move(worst));
    }
  }

  void heights() {
    double lowest = 1e300, deepest = 0;
    size_t foot = feet_[0], at = 0;
    for (size_t f = 0; f < poses_.size(); ++f)
      for (const size_t j : feet_) {
        const double here = lifted(f, j);
        lowest = std::min(lowest, here);
        if (-here > deepest) deepest = -here, foot = j, at = f;
      }
    RigFinding sinks = finding_at(foot, at), floats = finding_at(foot, 0);
    sinks.value = deepest;
    sinks.what =
        findings_->quoted(sinks.joint) + print(" sinks %.2f of the height below its lowest resting position", deepest);
    findings_->add("foot-sink", std::move(sinks));
    floats.value = lowest;
    floats.what = print("both feet stay %.2f of the height above their resting height in the whole clip", lowest);
    findings_->add("foot-float", std::move(floats));
  }

  // Speed of planted feet relative to the ground, which moves if a clip stays in place.
  void slides() {
    struct Stance {
      size_t foot, frame;
      Point3 velocity;
    };
    std::vector<Stance> stances;
    std::vector<double> x, z;
    for (const size_t j : feet_) {
      double lowest = 1e300;
      for (size_t f = 0; f < poses_.size(); ++f) lowest = std::min(lowest, lifted(f, j));
      for (size_t f = 1; f < poses_.size(); ++f) {
        if (lifted(f, j) > lowest + kNear || lifted(f - 1, j) > lowest + kNear) continue;
        const Point3 v = (1 / (height_ * clip_.frame_time)) * (poses_[f].positions[j] - poses_[f - 1].positions[j]);
        stances.push_back({j, f, v});
        x.push_back(v[0]);
        z.push_back(v[2]);
      }
    }
    if (stances.size() < 4) return;
    const Point3 ground = {median(&x), 0, median(&z)};
    for (const size_t j : feet_) {
      std::vector<double> speeds;
      size_t at = 0;
      double most = 0;
      for (const Stance& s : stances) {
        if (s.foot != j) continue;
        const double dx = s.velocity[0] - ground[0], dz = s.velocity[2] - ground[2],
                     speed = std::sqrt(dx * dx + dz * dz);
        speeds.push_back(speed);
        if (speed > most) most = speed, at = s.frame;
      }
      if (speeds.size() < 4) continue;
      RigFinding finding = finding_at(j, at);
      finding.value = median(&speeds);
      finding.what = findings_->quoted(finding.joint) +
                     print(" slides by %.2f of the height per second while it is planted", finding.value);
      findings_->add("foot-slide", std::move(finding));
    }
  }

  const RigFacts& facts_;
  const Motion& motion_;
  const Clip& clip_;
  Findings* findings_;
  std::vector<WorldPose> poses_;  // [frames]
  std::vector<size_t> feet_;
  double height_ = 1, floor_ = 0;
};

}  // namespace

void check_clips(const RigFacts& facts, const Motion& motion, Findings* findings) {
  for (const Clip& clip : motion.clips) ClipCheck(facts, motion, clip, findings).look();
}

}  // namespace sinew
