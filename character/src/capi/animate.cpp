// SPDX-License-Identifier: MIT
// sinew_character_animate(): the job of `sinew animate`.
#include <cmath>

#include "corrections_of.hpp"
#include "handle.hpp"
#include "motion_of.hpp"
#include "rig_of.hpp"
#include "sinew_character/check/checked_note.hpp"
#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/motion/motion_file.hpp"
#include "sinew_character/picture/plane_motion.hpp"

namespace sinew {
namespace {

AnimateOptions job_of(const sinew_character_animate_options& options, const sinew_character& character) {
  check_at_most("method", options.method, SINEW_ANIMATE_STREAM);
  check_at_most("target_up", options.target_up, SINEW_UP_Z);
  check_at_most("motion_up", options.motion_up, SINEW_UP_Z);
  if (!std::isfinite(options.fps + options.from + options.to) || options.fps < 0 || options.from < 0 ||
      options.to < 0 || (options.to != 0 && options.to < options.from))
    throw Failure(SINEW_ERROR_ARGUMENT, "fps, from, to: expected 0 or more, and to behind from");
  AnimateOptions job;
  job.character = file_of(character);
  job.up = maybe_axis(options.target_up);
  job.motion_up = maybe_axis(options.motion_up);
  job.map = text_or_empty(options.map);
  if (options.sources != nullptr)
    job.sources.assign(options.sources, options.sources + character.character.joints.size());
  job.method = static_cast<AnimateMethod>(options.method);
  job.limits = text_or_empty(options.limits);
  job.in_place = options.in_place != 0;
  job.range = options.no_range == 0;
  job.report = options.report != 0;
  job.force = options.force != 0;
  job.translations = options.translations != 0;
  job.fps = options.fps;
  job.from = options.from;
  if (options.to != 0) job.to = options.to;
  job.reference.area_power = options.area_power;
  job.reference.falloff = static_cast<float>(options.falloff);
  job.reference.no_own_limb = options.no_own_limb;
  job.reference.own_limb = options.own_limb;
  job.reference.legs = options.legs;
  job.reference.head = options.head;
  job.reference.torso = options.torso;
  job.reference.source_points = options.source_points;
  return job;
}

// The clips that `sinew animate` reads from the file of a motion, or those that were added to a character.
MotionFile motion_of_handle(sinew_character* motion, const sinew_character_animate_options& options,
                            const AnimateOptions& job, const Character& target) {
  if (plays_its_file(*motion)) {
    const FilesOf scope(*motion);
    return read_motion_for({motion->path, job.fps, text_or_empty(options.layout), text_or_empty(options.actor), job.up},
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

void fill_result(const AnimatedCharacter& made, uint32_t first_clip, ResultViews* views,
                 sinew_character_animate_result* result) {
  if (result == nullptr) return;
  *views = {};
  sinew_character_animate_result filled = SINEW_INIT(sinew_character_animate_result);
  filled.clip_count = count32(made.made.size());
  filled.first_clip = first_clip;
  filled.rigged = made.rigged ? 1 : 0;
  filled.shape_count = count32(made.morphs.shapes.size());
  filled.certainty = made.certainty;
  for (const AnimatedClip& one : made.made) {
    filled.mapped = count32(one.mapped);
    filled.limb_count = count32(one.report.before.size());
    views->text = one.map;
    views->before.insert(views->before.end(), one.report.before.begin(), one.report.before.end());
    views->after.insert(views->after.end(), one.report.after.begin(), one.report.after.end());
  }
  views->sources.assign(made.map.sources.begin(), made.map.sources.end());
  filled.limbs_before = views->before.data();
  filled.limbs_after = views->after.data();
  filled.mapped_by = views->text.c_str();
  filled.sources = views->sources.data();
  give(filled, result);
}

void animate(const sinew_character_animate_options& options, ProgressOfCaller* progress, sinew_character* target,
             sinew_character* motion, sinew_character_animate_result* result) {
  const std::optional<sinew_deform_options> deform = corrections_of(options.deform, options);
  const uint32_t first = count32(own_clip_count(target) + target->clips.size());
  AnimateOptions job = job_of(options, *target);
  std::shared_ptr<const PictureCharacter> picture = target->picture;
  if (options.depth != 0 && picture == nullptr)
    throw Failure(SINEW_ERROR_ARGUMENT, "depth: is for characters of pictures, and this is none");
  AnimatedCharacter made = start(*target, options, progress, &picture);
  sinew_character own;  // a picture's clip, where none is given
  if (motion == nullptr) {
    own.path = default_clip(picture->body);
    own.character.name = own.path;
    job.force = true;  // nobody asked for it: a warning will do
    motion = &own;
  }
  const MotionFile source = motion_of_handle(motion, options, job, made.character);
  MotionInput input;
  input.file = file_of(*motion);
  input.clip = text_or_empty(options.clip);
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
  if (deform) bake_clips(*deform, options.shapes == 0 ? 16 : options.shapes, steps, &made);
  for (MorphClip& clip : made.morphs.clips) clip.animation += target->clips.size();
  if (deform && !target->morphs.shapes.empty())
    throw Error(made.character.name + ": has corrective shapes already; animate it before they are baked");
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
  fill_result(made, first, &target->results, result);
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
        need(motion != nullptr || character->picture != nullptr, "motion");
        check_result(result);
        animate(options_of(given), &progress, character, motion, result);
      },
      &progress);
}
