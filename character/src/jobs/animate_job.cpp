// SPDX-License-Identifier: MIT
// Motion of any skeleton for a character.
#include "sinew_character/jobs/animate_job.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/motion/joint_limits.hpp"
#include "sinew_character/motion/map_source.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// What programs call a clip that nobody named.
bool is_unnamed(const std::string& clip) {
  return clip.empty() || clip.find("mixamo.com") != std::string::npos || clip == "Take 001" || clip == "Unreal Take" ||
         clip == "Default Take";
}

std::vector<Clip> chosen_clips(const AnimateOptions& s, const std::string& file, const std::string& name,
                               const Motion& motion) {
  std::vector<Clip> chosen;
  if (!name.empty() && !motion.clips.empty())
    chosen.push_back(find_clip(motion, file, name));
  else
    std::copy_if(motion.clips.begin(), motion.clips.end(), std::back_inserter(chosen),
                 [](const Clip& clip) { return !clip.frames.empty(); });
  if (chosen.empty()) throw Error(file + ": expected a motion, found a skeleton without frames");
  for (Clip& clip : chosen) {
    const double seconds = static_cast<double>(clip.frames.size() - 1) * clip.frame_time;
    clip = cut(clip, s.from, s.to);
    if (clip.frames.empty())
      throw Error(file + ": clip " + clip.name +
                  print(" has no frame between --start %g and --end %g; it lasts %g seconds", s.from, s.to, seconds));
    if (s.fps > 0 && clip.frame_time * s.fps != 1) clip = resample(clip, s.fps);
  }
  return chosen;
}

// By the method; the motion's body, if it has one, gives the contacts.
void set_method(const AnimateOptions& s, const std::string& file, const std::optional<Character>& source,
                AnimatedCharacter* out, Retargeter* retargeter) {
  const bool as_copied = s.method == AnimateMethod::kCopy || s.method == AnimateMethod::kNodeOffsets;
  if (as_copied && !s.report) return;
  const size_t shared = retargeter->take_bodies(out->character, source ? &*source : nullptr);
  if (as_copied) return;
  if (s.method == AnimateMethod::kReferencePoints) {
    const Retargeter::PointsOf points =
        retargeter->follow_reference_points(s.reference, out->character, source ? &*source : nullptr);
    if (points == Retargeter::PointsOf::kTwoMeshes)
      out->motion.notes.push_back(file + ": its body has another mesh; only corresponding reference points are used");
    if (points == Retargeter::PointsOf::kCapsules)
      out->motion.notes.push_back(file + ": has no body, so its reference points are on capsules around the bones");
    return;
  }
  if (s.method == AnimateMethod::kStream)
    retargeter->play_as_stream();
  else
    retargeter->keep_contacts();
  if (s.range) retargeter->keep_range();
  if (s.method == AnimateMethod::kContacts && shared == 0)
    out->motion.notes.push_back(
        file + ": has no body with the character's mesh, so hands keep no contacts with the body; feet and arms do");
}

// The caller's map, a file's, or a found one.
MotionMap map_of(const AnimateOptions& s, const MapRig& target, const MapRig& from) {
  if (s.sources.empty()) {
    MapSkeletonOptions options;
    options.target_up = s.up;
    options.source_up = s.motion_up;
    options.pins = s.pins;
    if (s.map_as_drawn) {
      options.method = SINEW_MAP_BRANCHES;
      options.branches_cost = SINEW_BRANCHES_SUM;
    }
    return map_motion(target, from, options, s.map);
  }
  MotionMap map;
  map.sources = s.sources;
  map.reasons.assign(s.sources.size(), SINEW_MAP_PINNED);
  map.how = "what was given";
  return map;
}

// Adds a note if the user plays it anyway.
void refuse_misfit(const AnimateOptions& s, const MotionInput& input, const MotionMap& map, const MapRig& target,
                   std::vector<std::string>* notes) {
  if (map.cover.share >= kLeastCover) return;
  const std::string what = input.file + ": does not fit " + target.name + ": " + map.cover.missing + ", " +
                           std::to_string(moved_joints(map)) + " of its " + std::to_string(target.joints.size()) +
                           " joints ";
  if (!s.force) throw Error(what + "would move; map them with --map FILE, or play it anyway with --force");
  notes->push_back("warning: " + what + "move; the rest keeps its pose");
}

// Upper arms and forearms have sources.
bool has_arms(const MotionMap& map, const std::vector<uint8_t>& classes) {
  const auto moves = [&](sinew_joint_class wanted) {
    for (size_t t = 0; t < classes.size(); ++t)
      if (classes[t] == wanted && map.sources[t] >= 0) return true;
    return false;
  };
  return moves(SINEW_CLASS_UPPER_ARM) && moves(SINEW_CLASS_FOREARM);
}

// Parts of the body that do not move as they should, and parts that do not move.
void tell_parts(const std::string& file, const MapCover& cover, std::vector<std::string>* notes) {
  std::string text;
  for (const std::string& warning : cover.warnings) text += (text.empty() ? "" : "; ") + warning;
  if (!text.empty())
    notes->push_back("warning: " + file + ": " + text + "; check the result, and map the joints with --map");
  if (cover.legless) notes->push_back(file + ": the character has no legs, so only arms, torso and head move");
  if (!cover.rigid.empty())
    notes->push_back(file + ": has no match for " + cover.rigid + ", which keep their rest pose");
}

}  // namespace

AnimatedCharacter animated_character(Character character, const std::string& path) {
  AnimatedCharacter out;
  out.character = std::move(character);
  if (out.character.joints.empty()) {
    out.character = rig_bare_mesh(std::move(out.character));
    out.rigged = true;
  }
  if (out.character.influences.empty())
    throw Error(path + ": has a skeleton but no skin weights to animate; bind it first with sinew bind");
  out.motion = motion_of(out.character.joints);
  if (!out.rigged && out.character.gltf != nullptr && found_up(map_rig_of(out.character)) == Axis::kZ)
    out.motion.notes.push_back("warning: " + path +
                               ": its body stands along z, but up is y in glTF, so it lies down in every viewer, and "
                               "so does the output; rotate it with sinew bind FILE --lock all --turn -x -o OUT");
  return out;
}

void name_clips(const std::string& file, bool always, const Motion& made, Motion* motion) {
  bool taken = always || (motion->clips.size() == 1 && is_unnamed(motion->clips.front().name));
  for (const Clip& clip : motion->clips)
    for (const Clip& other : made.clips) taken = taken || other.name == clip.name;
  if (!taken) return;
  for (Clip& clip : motion->clips)
    clip.name = motion->clips.size() == 1 ? stem_of(file) : stem_of(file) + "." + clip.name;
}

void add_motion(const AnimateOptions& s, const MotionInput& choice, const StepsOf& steps, AnimatedCharacter* out) {
  const std::optional<Character> body = choice.body ? choice.body() : std::nullopt;
  MapSource read = map_source_of(*choice.motion, body ? &*body : nullptr, out->character.joints, s.motion_up);
  if (read.standing)
    out->motion.notes.push_back(
        choice.file + ": its rest pose is not a standing pose, so one was guessed from its frames; check the result");
  const Motion& source = read.standing ? *read.standing : *choice.motion;
  const std::vector<Clip> clips = chosen_clips(s, choice.file, choice.clip, source);
  MapRig target = map_rig_of(out->character), &from = read.rig;
  target.name = s.character;
  from.name = choice.file;
  out->map = map_of(s, target, from);
  const MotionMap& map = out->map;
  refuse_misfit(s, choice, map, target, &out->motion.notes);
  RetargetSettings settings;
  settings.method = s.method == AnimateMethod::kCopy          ? SINEW_RETARGET_COPY
                    : s.method == AnimateMethod::kNodeOffsets ? SINEW_RETARGET_NODE_OFFSETS
                                                              : SINEW_RETARGET_AUTO;
  settings.in_place = s.in_place ? 1 : 0;
  settings.translations = s.translations ? 1 : 0;
  settings.arm_spread = static_cast<float>(s.arm_spread);
  const std::vector<uint8_t> classes = motion_classes(target, from, s.up, map.sources);
  if (s.arm_spread != 0 && !has_arms(map, classes))
    out->motion.notes.push_back(choice.file + ": moves no arms of the character, so the arm spread has no effect");
  Retargeter retargeter(source, out->character.joints, map.sources, classes, settings,
                        {engine_up(s.motion_up), engine_up(s.up)});
  set_method(s, choice.file, body, out, &retargeter);
  if (!s.limits.empty()) retargeter.keep_limits(joint_limits(s.limits, target, s.up));
  const size_t mapped = moved_joints(map);
  size_t frames = 0;
  for (const Clip& clip : clips) frames += clip.frames.size();
  tell_parts(choice.file, map.cover, &out->motion.notes);
  const std::function<bool()> keep_going = steps(frames);
  for (const Clip& clip : clips) {
    ClipReport report;
    out->motion.clips.push_back(retargeter.run(clip, keep_going, s.report ? &report : nullptr));
    out->animated_clips.push_back(
        {choice.file, clip.name, map.how, clip.frames.size(), mapped, clip.frame_time, report});
  }
  out->certainty = std::min(map.certainty, map.cover.share);
  if (map.certainty < kDoubtfulSides)
    out->motion.notes.push_back(choice.file +
                                print(": the front is uncertain (%.0f %%), so left and right may be exchanged; fix one "
                                      "pair with sinew map --set and give the map with --map",
                                      100 * static_cast<double>(map.certainty)));
  for (const std::string& note : source.notes) out->motion.notes.push_back(choice.file + ": " + note);
}

// Every clip's corrections as morph targets that move in it alone.
void bake_clips(const sinew_deform_options& deform, size_t shapes, const StepsOf& steps, AnimatedCharacter* out) {
  size_t frames = 0;
  for (const Clip& clip : out->motion.clips) frames += clip.frames.size();
  const BakeProgress step = steps(2 * frames);
  BakeSettings settings;
  settings.deform = deform;
  Morphs& morphs = out->morphs;
  for (size_t c = 0; c < out->motion.clips.size(); ++c) {
    const Clip& clip = out->motion.clips[c];
    std::vector<Palette> poses;
    for (const MotionFrame& frame : clip.frames)
      poses.push_back(motion_palette(out->motion, frame, out->character.joints.size()));
    MorphClip keys;
    Morphs own = bake_clip(out->character, poses, settings, shapes, step, &keys.weights);
    out->animated_clips[c].shapes = own.shapes.size();
    out->animated_clips[c].error = bake_error(out->character, own, poses, deform, step, &keys.weights);
    keys.is_new = true;
    keys.animation = c;
    keys.frame_time = clip.frame_time;
    for (std::vector<float>& row : keys.weights) row.insert(row.begin(), morphs.shapes.size(), 0.0f);
    for (MorphShape& shape : own.shapes) {
      shape.name = clip.name + "." + std::to_string(morphs.shapes.size() + 1);
      morphs.shapes.push_back(std::move(shape));
    }
    morphs.clips.push_back(std::move(keys));
  }
  for (MorphClip& clip : morphs.clips)
    for (std::vector<float>& row : clip.weights) row.resize(morphs.shapes.size(), 0.0f);
}

}  // namespace sinew
