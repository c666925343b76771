// SPDX-License-Identifier: MIT
// Maps joints of one skeleton to another by sinew/map.h; reads rigs from files, and maps from text.
#ifndef SINEW_CHARACTER_MAP_SKELETON_HPP
#define SINEW_CHARACTER_MAP_SKELETON_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew/published.h"
#include "sinew/sinew.h"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// A skeleton as input for mapping.
struct MapRig {
  std::string name;               // the file, for messages
  std::vector<Joint> joints;      // at least one
  std::vector<uint8_t> ends;      // [J] 1: only the end of a bone; empty = unknown
  JointSurfaces surfaces;         // for SINEW_MAP_BRANCHES and levels, like the next member; empty = no mesh is bound
  std::vector<uint8_t> animated;  // [J] 1: a clip moves it; empty = unknown
};

// Reads .rig.txt, .txt, .obj with its .rig.txt, .gltf, .glb, .vrm, .fbx, .dae, .bvh, or template:NAME. If the file
// has skin weights, leaves without weight are ends. Throws Error.
MapRig read_map_rig(const std::string& path);
// The same for a character or a motion in memory. Ends of a motion are its End Sites, and joints whose only child is
// an End Site with the same offset.
MapRig map_rig_of(const Character& character);
MapRig map_rig_of(const Motion& motion);

struct MapSkeletonOptions {
  uint32_t method = SINEW_MAP_AUTO;
  uint32_t branches_first = SINEW_BRANCHES_BOTH, branches_cost = SINEW_BRANCHES_MEAN;
  bool names = true, ends = true;  // uses them
  MaybeAxis target_up = Axis::kY, source_up = Axis::kY;
  std::vector<sinew_map_pin> pins;
};

struct MappedSkeleton {
  std::vector<int32_t> sources;   // [target J] -1 = none
  std::vector<float> confidence;  // [target J] 0..1
  std::vector<uint8_t> reasons;   // [target J] sinew_map_reason
  uint32_t method = 0;            // SINEW_MAP_SINEW or SINEW_MAP_BRANCHES
  size_t mapped = 0;
  float certainty = 0;  // 0..1, certainty of front, sides and torso
  size_t workspace_bytes = 0;
  double seconds = 0;  // duration of sinew_map()
};

// Up axis along the legs of a standing body with two legs, if they follow an axis; else y.
Axis found_up(const MapRig& rig, const MapSkeletonOptions& options = {});

// Throws Error with the file's name, and OutOfMemory.
MappedSkeleton map_skeleton(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options);

// Returns [target J] sinew_joint_class of arms, legs and other body parts, by sinew_limb_classes().
//   source, sources  null, or the rig and [target J] its joint that drives each joint, -1 = none
// Throws Error.
std::vector<uint8_t> limb_classes(const MapRig& target, MaybeAxis target_up, const MapRig* source = nullptr,
                                  const std::vector<int>& sources = {});

// Returns "" or a text such as "the source has no match" for a sinew_map_reason.
const char* map_reason_text(uint8_t reason);

// A map as text: a line TARGET_JOINT SOURCE_JOINT, or TARGET_JOINT - for none, for each joint; # begins a comment. Blanks
// in names are written as '_'.
std::string map_text(const MapRig& target, const MapRig& source, const MappedSkeleton& map);
// Joints that may occur in several lines of a map.
enum class MapRepeats : uint8_t {
  kNone,
  kSources,  // for motion: several joints may share a source
  kTargets   // for weights: several joints may share a target
};
// Reads the lines of such a file as pins: a joint with a line is fixed, others are free. Throws Error with the line,
// also for a joint that occurs twice and may not.
std::vector<sinew_map_pin> read_map_file(const std::string& path, const MapRig& target, const MapRig& source,
                                         MapRepeats repeats = MapRepeats::kNone);
// TARGET_JOINT=SOURCE_JOINT, or TARGET_JOINT=- for none. Throws Error.
sinew_map_pin parse_map_pin(const std::string& text, const MapRig& target, const MapRig& source);

// Holds pointers into the rig.
struct MapRigView : SkeletonView {
  MapRigView(const MapRig& rig, MaybeAxis up, const MapSkeletonOptions& options) : SkeletonView(rig.joints) {
    if (!options.names) skeleton.names = nullptr;
    if (options.ends && !rig.ends.empty()) skeleton.ends = rig.ends.data();
    skeleton.up = engine_up(up);
  }
};

}  // namespace sinew
#endif
