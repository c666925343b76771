// SPDX-License-Identifier: MIT
// The joints of a glTF document as a Skeleton of UsdSkel, and its animations as SkelAnimations.
#ifndef SINEW_FORMATS_USD_USD_SKELETON_HPP
#define SINEW_FORMATS_USD_USD_SKELETON_HPP

#include <map>
#include <string>
#include <vector>

#include "gltf/animation_track.hpp"
#include "gltf/gltf_model.hpp"
#include "sinew_formats/base/affine.hpp"

namespace sinew {

constexpr double kUsdTimeCodes = 30;  // a second

// A blend shape, and its weight at the times of every animation, one behind the other.
struct UsdShape {
  std::string token;
  std::vector<double> curve;
};

class UsdSkeleton {
 public:
  // Throws Error naming `path` for accessors that are broken.
  UsdSkeleton(const std::string& path, const tinygltf::Model& model, const GltfNodes& nodes);

  size_t joint_count() const { return joints_.size(); }
  int joint_of(int node) const { return node < 0 ? -1 : joint_of_node_[static_cast<size_t>(node)]; }
  // The nearest joint that a node hangs on, itself included; -1 for none.
  int joint_above(size_t node) const;
  const Affine& bind(int joint) const { return binds_[static_cast<size_t>(joint)]; }
  const Affine& skin_frame_of(size_t skin) const { return frames_[skin]; }
  // How shape `shape` of a mesh node goes in all animations; `rest` where an animation leaves it alone.
  std::vector<double> shape_curve(size_t node, size_t shape, size_t shape_count, double rest) const;

  // The prim; "" without joints and without shapes that move.
  std::string text(const std::vector<UsdShape>& shapes) const;
  bool has_clips() const { return !clips_.empty(); }
  double last_time_code() const { return last_time_; }

 private:
  struct Clip {
    std::string name, where;
    std::vector<double> times;  // seconds, of all keys
    std::map<size_t, std::map<std::string, Track>> tracks;
    std::map<size_t, const tinygltf::AnimationSampler*> weights;
  };

  void find_joints();
  void find_binds();
  void find_clips();
  std::vector<Affine> locals(const std::vector<Affine>& worlds) const;
  std::vector<Affine> worlds_at(const Clip& clip, double seconds) const;
  std::string animation(const Clip& clip, const std::string& prim, const std::vector<UsdShape>& shapes,
                        size_t first_time) const;

  const std::string& path_;
  const tinygltf::Model& model_;
  const GltfNodes& nodes_;
  std::vector<size_t> order_, joints_;        // nodes
  std::vector<int> joint_of_node_, parents_;  // [N], [J]
  std::vector<std::string> paths_, names_;
  std::vector<Affine> binds_, frames_;  // [J] world, [skins]
  std::vector<Clip> clips_;
  double last_time_ = 0;
};

}  // namespace sinew
#endif
