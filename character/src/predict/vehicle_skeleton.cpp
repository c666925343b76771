// SPDX-License-Identifier: MIT
// Parts that are round about an axle, that stand on the hull, or that are flat at its side.
#include "sinew_character/predict/vehicle_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "predict/part_box.hpp"
#include "sinew_character/rig/mesh_surface.hpp"

namespace sinew {
namespace {

// Limits of a wheel: how much higher than long it may be, how far inside its radius its corners may lie and how far
// outside, its width in diameters, its diameter in lengths of the vehicle, and where its middle is at most, in
// heights.
constexpr double kRound = 0.1, kInside = 0.9, kOutside = 1.08, kWidest = 1.3, kLeastWheel = 0.05, kMostWheel = 0.7,
                 kHighest = 0.6;
constexpr size_t kSectors = 8;
// A gun is so many times as long as thick; a turret's bottom lies so high in the vehicle.
constexpr double kSlenderGun = 4, kTurretBottom = 0.35;
// Thickness, height and length of a door, shares of those of the vehicle.
constexpr double kDoorThick = 0.2, kDoorLow = 0.2, kDoorShort = 0.1, kDoorLong = 0.45;

class Vehicle {
 public:
  Vehicle(const Character& mesh, Axis up, const std::array<float, 3>& front)
      : mesh_(mesh), of_(connected_parts(mesh)), axes_(up, front), boxes_(of_.count), joint_(of_.count, 0) {
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
      const Point3 p = axes_.local(mesh.vertices[v]);
      boxes_[of_.part[v]].add(p);
      whole_.add(p);
    }
    find_wheels();
  }
  size_t wheels() const { return wheels_.size(); }

  PartSkeleton skeleton(const std::array<float, 3>& front) {
    out_.front = front;
    Point3 root = whole_.middle();
    root[kUp] = whole_.low[kUp];
    out_.joints.push_back({"Root", axes_.world(root), -1, true});
    add_wheels();
    add_turret();
    add_doors();
    for (size_t v = 0; v < mesh_.vertices.size(); ++v) out_.joint_of.push_back(joint_[of_.part[v]]);
    return std::move(out_);
  }

 private:
  // Every corner of the outline, seen along the axle, lies at one distance from the middle, in every direction.
  void find_wheels() {
    std::vector<std::array<double, kSectors>> reach(of_.count, std::array<double, kSectors>{});
    std::vector<double> farthest(of_.count, 0.0);
    for (size_t v = 0; v < mesh_.vertices.size(); ++v) {
      const size_t p = of_.part[v];
      const Point3 off = axes_.local(mesh_.vertices[v]) - boxes_[p].middle();
      const double radius = std::hypot(off[kUp], off[kFront]);
      const double turn = (std::atan2(off[kUp], off[kFront]) / 6.283185307179586 + 1) * kSectors;
      double& sector = reach[p][static_cast<size_t>(turn) % kSectors];
      sector = std::max(sector, radius);
      farthest[p] = std::max(farthest[p], radius);
    }
    for (size_t p = 0; p < of_.count; ++p) {
      const PartBox& box = boxes_[p];
      const double high = box.side(kUp), half = 0.5 * high, size = whole_.longest();
      if (std::abs(high - box.side(kFront)) > kRound * high || box.side(kLeft) > kWidest * high) continue;
      if (high < kLeastWheel * size || high > kMostWheel * size) continue;
      if (box.middle()[kUp] > whole_.low[kUp] + kHighest * whole_.side(kUp)) continue;
      const double least = *std::min_element(reach[p].begin(), reach[p].end());
      if (least >= kInside * half && farthest[p] <= kOutside * half) wheels_.push_back(p);
    }
    // A rim within a tyre is no wheel of its own.
    std::erase_if(wheels_, [&](size_t p) {
      return std::any_of(wheels_.begin(), wheels_.end(), [&](size_t q) {
        return q != p && gap(boxes_[p], boxes_[q]) <= 0 && boxes_[q].side(kUp) > boxes_[p].side(kUp);
      });
    });
  }

  uint32_t add(const std::string& name, const Point3& at, uint32_t parent) {
    std::string unique = name;
    const auto taken = [&](const Joint& joint) { return joint.name == unique; };
    for (int number = 1; std::any_of(out_.joints.begin(), out_.joints.end(), taken); ++number)
      unique = name + std::to_string(number);
    out_.joints.push_back({unique, axes_.world(at), static_cast<int>(parent), true});
    return static_cast<uint32_t>(out_.joints.size() - 1);
  }
  std::string side_of(const Point3& at) const { return at[kLeft] > whole_.middle()[kLeft] ? "Left" : "Right"; }

  // From front to back.
  void add_wheels() {
    std::stable_sort(wheels_.begin(), wheels_.end(),
                     [&](size_t a, size_t b) { return boxes_[a].middle()[kFront] > boxes_[b].middle()[kFront]; });
    for (const size_t wheel : wheels_) {
      const Point3 at = boxes_[wheel].middle();
      const double across = 0.1 * whole_.side(kLeft), off = at[kLeft] - whole_.middle()[kLeft];
      const std::string side = std::abs(off) < across ? "" : side_of(at);
      joint_[wheel] = add(side + (at[kFront] > whole_.middle()[kFront] ? "FrontWheel" : "RearWheel"), at, 0);
    }
    for (size_t p = 0; p < of_.count; ++p) {
      for (const size_t wheel : wheels_) {
        const Point3 off = boxes_[p].middle() - boxes_[wheel].middle();
        const double room = 0.5 * boxes_[wheel].side(kUp) - 0.5 * std::max(boxes_[p].side(kUp), boxes_[p].side(kFront));
        const bool within = std::hypot(off[kUp], off[kFront]) <= room && gap(boxes_[p], boxes_[wheel]) <= 0 &&
                            boxes_[p].side(kLeft) <= 2 * boxes_[wheel].side(kLeft);
        if (joint_[p] == 0 && within) joint_[p] = joint_[wheel];
      }
    }
  }

  // A gun that lies along the vehicle, and what carries it: a part that is higher than the hull's middle and touches its rear end.
  void add_turret() {
    for (size_t gun = 0; gun < of_.count; ++gun) {
      const PartBox& box = boxes_[gun];
      const double thick = std::max(box.side(kUp), box.side(kLeft));
      if (joint_[gun] != 0 || box.side(kFront) < kSlenderGun * thick || box.low[kUp] < high(kTurretBottom)) continue;
      size_t turret = gun;
      for (size_t p = 0; p < of_.count; ++p) {
        const bool carries = p != gun && joint_[p] == 0 && gap(boxes_[p], box) <= 0 &&
                             boxes_[p].low[kUp] >= high(kTurretBottom) &&
                             volume(boxes_[p], 0) < 0.5 * volume(whole_, 0);
        if (carries && (turret == gun || volume(boxes_[p], 0) > volume(boxes_[turret], 0))) turret = p;
      }
      if (turret == gun) continue;
      Point3 foot = boxes_[turret].middle();
      foot[kUp] = boxes_[turret].low[kUp];
      joint_[turret] = add("Turret", foot, 0);
      Point3 hinge = common(box, boxes_[turret]).middle();
      joint_[gun] = add("Gun", hinge, joint_[turret]);
      for (size_t p = 0; p < of_.count; ++p) {  // hatches and lamps
        const bool on = joint_[p] == 0 && boxes_[p].low[kUp] >= boxes_[turret].low[kUp] &&
                        gap(boxes_[p], boxes_[turret]) <= 0 && volume(boxes_[p], 0) < volume(boxes_[turret], 0);
        if (on) joint_[p] = joint_[turret];
      }
      return;
    }
  }
  double high(double share) const { return whole_.low[kUp] + share * whole_.side(kUp); }

  void add_doors() {
    std::vector<size_t> doors;
    for (size_t p = 0; p < of_.count; ++p) {
      const PartBox& box = boxes_[p];
      const double edge = 0.15 * whole_.side(kLeft);
      const bool at_side = box.high[kLeft] > whole_.high[kLeft] - edge
                               ? box.low[kLeft] > whole_.middle()[kLeft]
                               : box.low[kLeft] < whole_.low[kLeft] + edge && box.high[kLeft] < whole_.middle()[kLeft];
      if (joint_[p] != 0 || !at_side || box.side(kLeft) > kDoorThick * whole_.side(kLeft)) continue;
      if (box.side(kUp) < kDoorLow * whole_.side(kUp)) continue;
      if (box.side(kFront) < kDoorShort * whole_.side(kFront) || box.side(kFront) > kDoorLong * whole_.side(kFront))
        continue;
      doors.push_back(p);
    }
    std::stable_sort(doors.begin(), doors.end(),
                     [&](size_t a, size_t b) { return boxes_[a].middle()[kFront] > boxes_[b].middle()[kFront]; });
    for (const size_t door : doors) {
      Point3 hinge = boxes_[door].middle();
      hinge[kFront] = boxes_[door].high[kFront];
      joint_[door] = add(side_of(hinge) + "Door", hinge, 0);
      for (size_t p = 0; p < of_.count; ++p) {  // its window and handle
        const double shared = volume(common(boxes_[p], boxes_[door]), 0);
        if (joint_[p] == 0 && gap(boxes_[p], boxes_[door]) <= 0 && shared > 0.5 * volume(boxes_[p], 0))
          joint_[p] = joint_[door];
      }
    }
  }

  const Character& mesh_;
  const MeshParts of_;
  const BodyAxes axes_;
  std::vector<PartBox> boxes_;
  std::vector<uint32_t> joint_;  // of each part
  PartBox whole_;
  std::vector<size_t> wheels_;
  PartSkeleton out_;
};

}  // namespace

PartSkeleton vehicle_skeleton(const Character& mesh, Axis up, const std::optional<std::array<float, 3>>& front) {
  if (front) return Vehicle(mesh, up, *front).skeleton(*front);
  const std::array<float, 3> along = up == Axis::kZ ? std::array<float, 3>{0, -1, 0} : std::array<float, 3>{0, 0, 1};
  const std::array<float, 3> across = {1, 0, 0};
  Vehicle first(mesh, up, along), second(mesh, up, across);
  return second.wheels() > first.wheels() ? second.skeleton(across) : first.skeleton(along);
}

}  // namespace sinew
