// SPDX-License-Identifier: MIT
// The default job of `sinew animate` for one character: selects clips, maps joints, keeps contacts and bakes
// corrections into morph targets.
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
  std::vector<int> sources;         // [J] joint of the motion or -1, instead of a map; or empty
  std::vector<sinew_map_pin> pins;  // pairs to keep in a map that is found
  bool map_as_drawn = false;        // finds a map as published: branches by the least sum of costs
  AnimateMethod method = AnimateMethod::kAuto;
  std::string limits;  // of joint_limits(), or empty
  bool in_place = false, range = true, report = false;
  bool translations = false;  // bones of the body stretch like the source's
  double arm_spread = 0;      // degrees, -90..90, as in sinew_retarget_options
  bool force = false;         // plays a motion whose map covers less than kLeastCover, with a note; otherwise an Error
  double fps = 0, from = 0, to = 1e9;  // seconds
  sinew_reference_options reference = SINEW_INIT(sinew_reference_options);
};

struct MotionInput {
  std::string file;  // for messages
  std::string clip;  // by name or number; empty: all
  const Motion* motion = nullptr;
  std::function<std::optional<Character>()> body;  // the mesh of the motion's own file; called if the method needs it
};

// Result for one clip.
struct AnimatedClip {
  std::string file, clip, map;
  size_t frames = 0, mapped = 0;
  double frame_time = 0;
  ClipReport report;
  size_t shapes = 0;  // of bake_clips(), and the clip's error relative to the corrected poses
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
  bool rigged = false;                       // a bare mesh was rigged first
  MotionMap map;                             // of the last motion
  float certainty = 1;  // certainty of its front and sides, at most the covered share of both bodies
};

// Called with the number of steps; returns a function that is called before each step and returns false to stop,
// which ends the job with an Error.
using StepsOf = std::function<std::function<bool()>(size_t steps)>;

// Reads a bound character; a mesh without a skeleton is rigged by the bundled models. Throws Error, which begins with
// `path`, for a skeleton without weights.
AnimatedCharacter animated_character(Character character, const std::string& path);
// Renames clips by their file if a clip of an earlier file has the same name, if the only one has a name that programs give by
// themselves ("mixamo.com", "Take 001"), or always with `always`.
//   made  the result so far
void name_clips(const std::string& file, bool always, const Motion& made, Motion* motion);
void add_motion(const AnimateOptions& options, const MotionInput& input, const StepsOf& steps, AnimatedCharacter* out);
// Bakes each clip's corrections into at most `shapes` morph targets, which move in this clip only.
void bake_clips(const sinew_deform_options& deform, size_t shapes, const StepsOf& steps, AnimatedCharacter* out);

}  // namespace sinew
#endif
