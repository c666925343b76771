// SPDX-License-Identifier: MIT
// What `sinew animate` does with one character by default: clips chosen, joints mapped, contacts kept, corrections as morph targets.
#ifndef SINEW_CHARACTER_ANIMATE_JOB_HPP
#define SINEW_CHARACTER_ANIMATE_JOB_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sinew_character/bake/bake.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_character/motion/retarget.hpp"
#include "sinew_character/springs/play_springs.hpp"
#include "sinew_character/springs/swing_inside.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

enum class AnimateMethod { kAuto, kCopy, kContacts, kReferencePoints, kStream, kNodeOffsets };  // kAuto: contacts

struct AnimateOptions {
  std::string character;  // its file, for messages
  MaybeAxis up, motion_up;
  std::string map;                  // a map's file, or empty
  std::vector<int> sources;         // [J] joint of the motion or -1, in place of a map; or empty
  std::vector<sinew_map_pin> pins;  // that a found map keeps
  bool map_as_drawn = false;        // a map is found as published: branches by the least sum of costs
  AnimateMethod method = AnimateMethod::kAuto;
  std::string limits;  // of joint_limits(), or empty
  bool in_place = false, range = true, report = false;
  bool translations = false;  // bones of the body stretch as the source's do
  bool force = false;         // plays a motion whose map reaches less than kLeastCover, with a note; an Error else
  double fps = 0, from = 0, to = 1e9;  // seconds
  sinew_reference_options reference = SINEW_INIT(sinew_reference_options);
};

struct MotionInput {
  std::string file;  // for messages
  std::string clip;  // by name or number; empty: all
  const Motion* motion = nullptr;
  std::function<std::optional<Character>()>
      body;  // the mesh of the motion's own file; asked where a method looks at it
};

// What became of one clip.
struct AnimatedClip {
  std::string file, clip, map;
  size_t frames = 0, mapped = 0;
  double frame_time = 0;
  ClipReport report;
  size_t shapes = 0;  // of bake_clips(), and how far the clip is from the corrected poses with them
  BakeError error = {};
  SpringPlay springs = {};  // of swing_clips()
  struct SwingReport {
    size_t vertices = 0;       // that swing
    InsideShare rigid, swung;  // without springs and with them
  };
  std::optional<SwingReport> swing = {};  // of swing_clips(), where it measures
};

struct AnimatedCharacter {
  Character character;
  Motion motion;                             // of its joints
  std::vector<AnimatedClip> animated_clips;  // [motion.clips]
  Morphs morphs;                             // of bake_clips()
  bool rigged = false;                       // was a bare mesh
  MotionMap map;                             // of the last motion
  float certainty = 1;  // how sure its front and sides are, and no more than what it covers of both bodies
};

// Told how many steps there are, gives what is asked before each; that says false to stop, which ends the work with an Error.
using StepsOf = std::function<std::function<bool()>(size_t steps)>;

// A bound character; a mesh without a skeleton gets one by the bundled models. Throws Error, which begins with `path`, for a skeleton
// without weights.
AnimatedCharacter animated_character(Character character, const std::string& path);
// Clips whose name an earlier file's clip has, or all with `always`, are called by their file.
//   made  what there is so far
void name_clips(const std::string& file, bool always, const Motion& made, Motion* motion);
void add_motion(const AnimateOptions& options, const MotionInput& input, const StepsOf& steps, AnimatedCharacter* out);
// Every clip's corrections as morph targets that move in it alone, `shapes` a clip at most.
void bake_clips(const sinew_deform_options& deform, size_t shapes, const StepsOf& steps, AnimatedCharacter* out);

}  // namespace sinew
#endif
