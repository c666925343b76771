// SPDX-License-Identifier: MIT
// A fitted skeleton without limbs beside the mesh.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "predict/fit_details.hpp"
#include "predict/turn.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

constexpr double kNearMesh = 0.02;  // of the longest side

class InsideFitter {
 public:
  InsideFitter(const Character& mesh, FittedSkeleton* fitted)
      : mesh_(mesh),
        fitted_(*fitted),
        size_(box_of(mesh.vertices).longest_side()),
        old_(fitted->joints),
        placed_(fitted->joints.size(), 0) {}

  size_t run() {
    const std::vector<uint8_t> carried = chains();
    JointMirror mirror;
    if (fitted_.symmetric) mirror = find_joint_mirror(old_);
    size_t moved = 0;
    for (const size_t j : by_depth()) {
      if (carried[j] == 0 || placed_[j] != 0) continue;
      std::vector<size_t> pair = {j};
      const int partner = fitted_.symmetric ? mirror.partners[j] : -1;
      if (partner >= 0 && carried[static_cast<size_t>(partner)] != 0 && partner != static_cast<int>(j))
        pair.push_back(static_cast<size_t>(partner));
      double share = 1;
      for (const size_t one : pair) share = std::min(share, share_inside(one));
      for (const size_t one : pair) {
        fitted_.joints[one].position = on_bone(one, share);
        placed_[one] = 1;
        moved += share < 1 ? 1 : 0;
      }
    }
    return moved;
  }

 private:
  // Carried joints below others, with nothing below them that something spoke for.
  std::vector<uint8_t> chains() const {
    std::vector<uint8_t> carried(old_.size(), 0);
    for (size_t j = 0; j < old_.size(); ++j)
      carried[j] = fitted_.how[j] == FitHow::kCarried && old_[j].parent >= 0 ? 1 : 0;
    for (size_t j = 0; j < old_.size(); ++j)
      if (fitted_.how[j] != FitHow::kCarried)
        for (int above = old_[j].parent; above >= 0; above = old_[static_cast<size_t>(above)].parent)
          carried[static_cast<size_t>(above)] = 0;
    return carried;
  }
  std::vector<size_t> by_depth() const {
    std::vector<size_t> depth(old_.size(), 0), order(old_.size());
    for (size_t j = 0; j < old_.size(); ++j)
      for (int above = old_[j].parent; above >= 0; above = old_[static_cast<size_t>(above)].parent) ++depth[j];
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return depth[a] < depth[b]; });
    return order;
  }
  // A share of the bone that ends at j, from where it begins now.
  Vec3 on_bone(size_t j, double share) const {
    const auto above = static_cast<size_t>(old_[j].parent);
    const Point3 bone = point(old_[j].position) - point(old_[above].position);
    return to_vec3(point(fitted_.joints[above].position) + share * bone);
  }
  bool is_inside(const Vec3& p) const {
    for (const Vec3& v : mesh_.vertices)
      if (std::hypot(v.x - p.x, v.y - p.y, v.z - p.z) <= kNearMesh * size_) return true;
    return directions_with_mesh(mesh_, p) > kMostHitsOutside;
  }
  double share_inside(size_t j) const {
    for (int tenths = 10; tenths > 1; --tenths)
      if (is_inside(on_bone(j, 0.1 * tenths))) return 0.1 * tenths;
    return 0.1;
  }

  const Character& mesh_;
  FittedSkeleton& fitted_;
  double size_;
  std::vector<Joint> old_;
  std::vector<uint8_t> placed_;
};

}  // namespace

size_t keep_inside(const Character& mesh, FittedSkeleton* fitted) {
  return mesh.vertices.empty() ? 0 : InsideFitter(mesh, fitted).run();
}

}  // namespace sinew
