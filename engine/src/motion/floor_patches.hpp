// SPDX-License-Identifier: MIT
// Parts of a body that touch the floor besides its feet: hands, elbows and knees, seat and chest, by their lowest
// vertices.
#ifndef SINEW_MOTION_FLOOR_PATCHES_HPP
#define SINEW_MOTION_FLOOR_PATCHES_HPP

#include "motion/clip_scene.hpp"

namespace sinew::motion {

// Patches of a body: the end of limb l is l, its middle kMostLimbs + l.
constexpr uint32_t kSeat = 2 * kMostLimbs, kChest = kSeat + 1, kPatchCount = kChest + 1;
constexpr uint32_t middle_patch(uint32_t limb) { return kMostLimbs + limb; }

// A patch of the source in one frame.
struct FloorPatch {
  double weight = 0;        // 0: far from its floor, 1: on it
  double height = 0;        // over the floor, in the target's units
  Vec3d wrist = {0, 0, 0};  // of a wrist of the target's, over the floor, as it was copied
};

class FloorPatches {
 public:
  // Works with a measuring arena. Returns arena.ok().
  bool allocate(Arena& arena, uint32_t target_joints, uint32_t vertices, uint32_t frames);
  // Which vertices and joints a patch has, of a scene that is open and must outlive this.
  void open(ClipScene* scene);
  // Where the source touches the floor in every frame, as those were copied. `source_floor`: its height, in the source's units.
  void look(double source_floor);

  bool any() const { return any_; }  // some patch in some frame
  const FloorPatch& at(uint32_t frame, uint32_t patch) const { return patches_[size_t{frame} * kPatchCount + patch]; }
  // In the plan's target pose, how far the lowest vertex of a patch in `mask` is to rise. 0 for one that is far from the floor.
  // rises [kPatchCount]
  void find_rises(uint32_t frame, uint64_t mask, double* rises) const;
  double rise(uint32_t frame, uint32_t patch) const {
    double rises[kPatchCount];
    find_rises(frame, uint64_t{1} << patch, rises);
    return rises[patch];
  }

 private:
  static constexpr uint8_t kNoPatch = 255;
  void look_at(uint32_t frame, double source_floor);
  uint8_t patch_of(uint32_t joint, Vec3d position) const;
  uint64_t near_floor(double source_floor, uint32_t (&lowest_joints)[kPatchCount]) const;
  // Heights of the patches in `mask`, over the target's floor or as they are.
  void find_lowest(const PosedBody& posed, uint64_t mask, bool over_floor, double* heights) const;

  ClipScene* s_ = nullptr;
  uint8_t* vertex_patches_ = nullptr;  // [vertices]
  uint8_t* joint_patches_ = nullptr;   // [target joints]
  FloorPatch* patches_ = nullptr;      // [frames x kPatchCount]
  bool any_ = false;
};

}  // namespace sinew::motion
#endif
