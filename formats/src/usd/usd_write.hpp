// SPDX-License-Identifier: MIT
// A glTF document as USD: its text form with pictures beside it, or one package of both.
#ifndef SINEW_FORMATS_USD_USD_WRITE_HPP
#define SINEW_FORMATS_USD_USD_WRITE_HPP

#include <map>
#include <set>
#include <string>
#include <vector>

#include "gltf/animation_track.hpp"
#include "gltf/gltf_model.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

// A .usda with its pictures beside it, the .usda last, or a .usdz: y up, meters, UsdSkel (openusd.org, "UsdSkel: Skeleton Schemas"): one skeleton
// with bind and rest transforms, meshes with influences and blend shapes, an animation a clip of which the first is bound, UsdPreviewSurface.
// A mesh without a skin below a joint gets weight 1 for it. Left out: animations of nodes that are no joints, alpha
// of colors.
//   path   ends with .usda or .usdz; pictures are named after it
//   model  a document as it was read
// Throws Error naming `path` for accessors that are broken.
std::vector<NamedBytes> usd_of(const std::string& path, const tinygltf::Model& model);

// A .usdz: a zip of stored files whose bytes begin at multiples of 64 (openusd.org, "Usdz File Format Specification").
// Names are those inside, in this order: the first file is the one that programs open. The same bytes for the same files.
// Throws Error naming `path` above 4 GiB.
std::vector<uint8_t> usd_package(const std::string& path, const std::vector<NamedBytes>& files);

// The joints of a glTF document as a Skeleton of UsdSkel, and its animations as SkelAnimations.

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
  // Returns the nearest ancestor joint of a node, or the node itself; -1 for none.
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

// Materials of a glTF document as UsdPreviewSurface, and their pictures as files.
class UsdMaterials {
 public:
  //   stem  pictures are called STEM_0.png and so on
  UsdMaterials(std::string stem, const tinygltf::Model& model);

  // "</Character/Materials/NAME>", "" for -1.
  std::string path_of(int material) const;
  bool two_sided(int material) const;
  // The scope with all of them; "" for none. Pictures are then in files().
  std::string text();
  const std::vector<NamedBytes>& files() const { return files_; }

 private:
  struct Picture;
  std::string material(size_t m);
  std::string shader(const std::string& at, const Picture& picture);
  std::string picture_of(int texture);

  const std::string stem_;
  const tinygltf::Model& model_;
  std::vector<std::string> names_;
  std::set<int> pictures_;
  std::vector<NamedBytes> files_;
};

}  // namespace sinew
#endif
