// SPDX-License-Identifier: MIT
// sinew_character_animate(): the job of `sinew animate`.
#include <cmath>

#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/check/check.hpp"
#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/jobs/plane_motion.hpp"
#include "sinew_character/jobs/springs_job.hpp"
#include "sinew_character/motion/motion_file.hpp"

namespace sinew {
namespace {

AnimateOptions job_of(const sinew_character_animate_options& options, const sinew_motion_source& source,
                      const sinew_character& character) {
  check_at_most("method", options.method, SINEW_ANIMATE_NODE_OFFSETS);
  check_at_most("target_up", options.target_up, SINEW_UP_Z);
  check_at_most("motion_up", source.up, SINEW_UP_Z);
  check_without(options.without, SINEW_WITHOUT_RANGE);
  if (!std::isfinite(source.fps + source.from + source.to) || source.fps < 0 || source.from < 0 || source.to < 0 ||
      (source.to != 0 && source.to < source.from))
    throw Failure(SINEW_ERROR_ARGUMENT, "fps, from, to: expected 0 or more, with to after from");
  if (!(std::abs(options.arm_spread) <= 90.0f)) throw Failure(SINEW_ERROR_ARGUMENT, "arm_spread: expected -90 to 90");
  AnimateOptions job;
  job.character = file_of(character);
  job.up = maybe_axis(options.target_up);
  job.motion_up = maybe_axis(source.up);
  job.map = text_or_empty(options.map);
  if (options.sources != nullptr)
    job.sources.assign(options.sources, options.sources + character.character.joints.size());
  job.method = static_cast<AnimateMethod>(options.method);
  need(options.pins != nullptr || options.pin_count == 0, "pins");
  job.pins.assign(options.pins, options.pins + options.pin_count);
  job.limits = text_or_empty(options.limits);
  job.in_place = options.in_place != 0;
  job.arm_spread = static_cast<double>(options.arm_spread);
  job.range = options.without == 0;
  job.report = options.report != 0;
  job.force = options.force != 0;
  job.translations = options.translations != 0;
  job.fps = source.fps;
  job.from = source.from;
  if (source.to != 0) job.to = source.to;
  job.reference = options_of(options.reference);
  job.reference.progress = nullptr;  // this call's own tells more
  return job;
}

// The clips that `sinew animate` reads from the file of a motion, or those that were added to a character.
MotionFile motion_of_handle(sinew_character* motion, const sinew_motion_source& source, const AnimateOptions& job,
                            const Character& target) {
  if (plays_its_file(*motion)) {
    const FilesOf scope(*motion);
    return read_motion_for({motion->path, job.fps, text_or_empty(source.layout), text_or_empty(source.actor), job.up},
                           map_rig_of(target));
  }
  return added_motion(*motion);
}

AnimatedCharacter start(const sinew_character& from, const sinew_character_animate_options& options,
                        ProgressOfCaller* progress, std::shared_ptr<const PictureCharacter>* picture) {
  Character character = from.character;
  if (character.vertices.empty()) throw Error(character.name + ": has no mesh to animate");
  if (!character.joints.empty() || (options.models == nullptr && from.picture == nullptr))
    return animated_character(std::move(character), file_of(from));
  sinew_character_rig_options rig = SINEW_INIT(sinew_character_rig_options);
  rig.models = options.models;
  AnimatedCharacter out = animated_character(rig_of(from, rig, progress, picture).character, file_of(from));
  out.rigged = true;
  return out;
}

void fill_result(const AnimatedCharacter& made, const Motion& source, uint32_t first_clip, ResultViews* views,
                 sinew_character_animate_result* result) {
  if (result == nullptr) return;
  *views = {};
  sinew_character_animate_result filled = SINEW_INIT(sinew_character_animate_result);
  filled.clip_count = count32(made.animated_clips.size());
  filled.first_clip = first_clip;
  filled.rigged = made.rigged ? 1 : 0;
  filled.shape_count = count32(made.morphs.shapes.size());
  filled.certainty = made.certainty;
  for (const AnimatedClip& one : made.animated_clips) {
    filled.mapped = count32(one.mapped);
    filled.limb_count = count32(one.report.before.size());
    views->text = one.map;
    views->before.insert(views->before.end(), one.report.before.begin(), one.report.before.end());
    views->after.insert(views->after.end(), one.report.after.begin(), one.report.after.end());
    for (size_t s = 0; s < one.report.spots.size(); ++s) {
      const sinew_contact_spot& spot = one.report.spots[s];
      if (s % SINEW_MAX_MOTION_LIMBS >= filled.limb_count) continue;
      views->spot_kinds.push_back(static_cast<uint8_t>(spot.kind));
      views->spot_positions.insert(views->spot_positions.end(), spot.position, spot.position + 3);
      views->spot_errors.push_back(spot.error);
    }
  }
  for (const MotionJoint& joint : source.joints) {
    views->joint_names += (views->ends.empty() ? "" : "\n") + joint.name;
    views->ends.push_back(joint.end ? 1 : 0);
  }
  views->reasons = made.map.reasons;
  views->sources.assign(made.map.sources.begin(), made.map.sources.end());
  filled.limbs_before = views->before.data();
  filled.limbs_after = views->after.data();
  filled.mapped_by = views->text.c_str();
  filled.sources = views->sources.data();
  filled.reasons = views->reasons.data();
  filled.source_count = count32(views->ends.size());
  filled.source_ends = views->ends.data();
  filled.source_names = views->joint_names.c_str();
  filled.spot_count = count32(views->spot_kinds.size());
  filled.spot_kinds = views->spot_kinds.data();
  filled.spot_positions = views->spot_positions.data();
  filled.spot_errors = views->spot_errors.data();
  give(filled, result);
}

void animate(const sinew_character_animate_options& options, ProgressOfCaller* progress, sinew_character* target,
             sinew_character* motion, sinew_character_animate_result* result) {
  const std::optional<sinew_deform_options> deform = corrections_of(options.deform);
  const sinew_motion_source played = options_of(options.motion);
  need(motion != nullptr || played.file != nullptr || target->picture != nullptr, "motion");
  const uint32_t first = count32(own_clip_count(target) + target->clips.size());
  AnimateOptions job = job_of(options, played, *target);
  std::shared_ptr<const PictureCharacter> picture = target->picture;
  if (options.depth != 0 && picture == nullptr)
    throw Failure(SINEW_ERROR_ARGUMENT, "depth: needs a character of a picture");
  AnimatedCharacter made = start(*target, options, progress, &picture);
  sinew_character own;  // a file's, or a picture's clip
  if (motion == nullptr) {
    own.path = played.file != nullptr ? played.file : default_clip(picture->body);
    own.character.name = own.path;
    if (played.file != nullptr)
      open_into(&own);
    else
      job.force = true;  // a clip that the caller did not request gives only a warning
    motion = &own;
  }
  MotionFile source = motion_of_handle(motion, played, job, made.character);
  check_pins(options.pins, options.pin_count, made.character.joints.size(), source.motion.joints.size());
  if (played.clip == nullptr) {
    Motion before;
    for (const Clip& clip : target->clips) before.clips.emplace_back().name = clip.name;
    name_clips(file_of(*motion), false, before, &source.motion);
  }
  MotionInput input;
  input.file = file_of(*motion);
  input.clip = text_or_empty(played.clip);
  input.motion = &source.motion;
  input.body = [motion, &source]() -> std::optional<Character> {
    const Character* body = body_of(*motion, source);
    return body != nullptr ? std::optional<Character>(*body) : std::nullopt;
  };
  const StepsOf steps = steps_of(progress);
  if (picture != nullptr)
    add_picture_motion(*picture, options.depth != 0, job, input, steps, &made);
  else
    add_motion(job, input, steps, &made);
  check_at_most("springs", options.springs, 1);
  if (options.springs != 0 && target->springs)
    swing_clips(*target->springs, false, &made);
  else if (options.springs != 0)
    swing_clips(SpringsOptions(), file_of(*target), false, &made);
  if (deform) bake_clips(*deform, options.shapes == 0 ? 16 : options.shapes, steps, &made);
  for (MorphClip& clip : made.morphs.clips) clip.animation += target->clips.size();
  if (deform && !target->morphs.shapes.empty())
    throw Error(made.character.name + ": has corrective shapes already; animate it before baking");
  for (const std::string& note : made.motion.notes) made.character.notes.push_back(note);
  if (const std::string note = checked_note(made.character, &made.motion); !note.empty())
    made.character.notes.push_back(note);
  if (made.rigged) {
    target->own_skeleton = true;
    changed(target);
  }
  target->picture = picture;
  target->viewed = false;
  target->clip_views.clear();
  target->character = made.character;
  target->clips.insert(target->clips.end(), made.motion.clips.begin(), made.motion.clips.end());
  if (deform) target->morphs = made.morphs;
  fill_result(made, source.motion, first, &target->results, result);
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_animate(sinew_character* character, sinew_character* motion,
                                                const sinew_character_animate_options* given,
                                                sinew_character_animate_result* result) {
  ProgressOfCaller progress = progress_of(given);
  return guarded(
      character,
      [&] {
        need(character != nullptr, "character");
        check_result(result);
        animate(options_of(given), &progress, character, motion, result);
      },
      &progress);
}
