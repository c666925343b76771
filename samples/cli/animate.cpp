// SPDX-License-Identifier: MIT
// sinew animate: motion of any skeleton for a character, into its own file.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "animate_report.hpp"
#include "animate_vat.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "pictures.hpp"
#include "progress.hpp"
#include "sinew_character/check/check.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/jobs/plane_motion.hpp"
#include "sinew_character/jobs/springs_job.hpp"
#include "sinew_character/motion/motion_file.hpp"
#include "sinew_character/profile/vrm_clips.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct MotionChoice {
  std::string file, clip;
  bool of_folder = false;
};
// FILE or FILE#CLIP; a file whose own name has a # is one. FOLDER: all of its motions.
std::vector<MotionChoice> parse_choices(const std::vector<std::string>& texts) {
  std::vector<MotionChoice> choices;
  for (const std::string& text : texts) {
    const size_t mark = text.rfind('#');
    std::error_code ignored;
    if (std::filesystem::is_directory(text, ignored)) {
      const std::vector<std::string> files = list_motions(text);
      if (files.empty())
        throw Error(text + ": expected a folder with motions (" + motion_files() + "), found none in it");
      for (const std::string& file : files) choices.push_back({file, "", true});
    } else if (mark == std::string::npos || std::filesystem::is_regular_file(text, ignored)) {
      choices.push_back({text, ""});
    } else {
      choices.push_back({text.substr(0, mark), text.substr(mark + 1)});
    }
  }
  return choices;
}

// A bound character as it is; a mesh without a skeleton gets one, a picture a mesh as well.
Animated read_animated(const AnimateSettings& s) {
  const std::string& path = s.character;
  if (is_picture(path)) {
    RigJobOptions job;
    if (s.deform.as_drawn) job.method = RigMethod::kRegions;
    PictureCharacter made = rig_picture(path, picture_job(s.picture), job);
    Animated out;
    static_cast<AnimatedCharacter&>(out) = animated_character(made.rigged.character, path);
    out.rigged = true;
    for (const std::string& note : made.rigged.character.notes)  // the result is checked with its motion
      if (note.rfind("checked: ", 0) != 0) out.motion.notes.push_back(note);
    out.picture = std::move(made);
    return out;
  }
  std::error_code ignored;
  const bool pair = has_extension(path, ".rig.txt") ||
                    (has_extension(path, ".obj") && std::filesystem::is_regular_file(rig_path_beside(path), ignored));
  return {animated_character(pair ? read_character(path) : read_mesh(path), path), {}};
}

AnimateOptions animate_options(const AnimateSettings& s) {
  AnimateOptions options = s;
  options.up = maybe_axis(s.up_name);
  options.motion_up = maybe_axis(s.motion_up_name);
  options.map_as_drawn = s.deform.as_drawn && is_picture(s.character);
  // A default clip or a comparison that does not fit is played with a warning.
  options.force = s.force || s.motions.empty() || options.map_as_drawn;
  options.reference.area_power = s.area_power == 0 ? SINEW_NO_AREA : s.area_power;
  options.reference.falloff = s.falloff == 0 ? SINEW_NO_FALLOFF : static_cast<float>(s.falloff);
  options.reference.own_limb = s.own_limb ? 1 : 0;
  options.reference.legs = s.legs ? 1 : 0;
  options.reference.head = s.head ? 1 : 0;
  options.reference.torso = s.torso ? 1 : 0;
  options.reference.source_points = s.source_points ? 1 : 0;
  options.reference.as_drawn = s.deform.as_drawn ? 1 : 0;
  return options;
}

// A line that counts, and an end at Ctrl-C.
StepsOf counted(std::string what, const std::atomic<bool>& stop) {
  return [what = std::move(what), &stop](size_t steps) {
    auto progress = std::make_shared<Progress>(steps, what);
    return [progress, &stop] {
      progress->step();
      return !stop;
    };
  };
}

void add_motion_file(const AnimateSettings& s, const MotionChoice& choice, const std::atomic<bool>& stop,
                     Animated* out) {
  const std::string layout = choice.of_folder && !takes_layout(choice.file) ? "" : s.layout;
  MotionFile source = read_motion_for({choice.file, s.fps, layout, s.actor, maybe_axis(s.up_name),
                                       down_axis(s.motion_up_name), s.motion_up_name == "auto"},
                                      map_rig_of(out->character));
  if (choice.of_folder || choice.clip.empty()) name_clips(choice.file, choice.of_folder, out->motion, &source.motion);
  const auto body = [&] { return source.whole ? body_of_motion(choice.file) : std::nullopt; };
  const MotionInput input = {choice.file, choice.clip, &source.motion, body};
  const StepsOf steps = counted("frames of " + file_name(choice.file), stop);
  if (out->picture)
    add_picture_motion(*out->picture, s.depth, animate_options(s), input, steps, out);
  else
    add_motion(animate_options(s), input, steps, out);
}

// Files of a folder that are not motions, or do not fit the character, are skipped with a note.
void add_motions(const AnimateSettings& s, const std::atomic<bool>& stop, Animated* out) {
  std::string first_error;
  const std::vector<std::string> own = {out->picture ? default_clip(out->picture->body) : ""};
  const std::vector<MotionChoice> choices = parse_choices(s.motions.empty() ? own : s.motions);
  const bool laid_out =
      std::any_of(choices.begin(), choices.end(), [](const MotionChoice& choice) { return takes_layout(choice.file); });
  if (!s.layout.empty() && !laid_out) check_layout(choices[0].file);
  for (const MotionChoice& choice : choices) {
    try {
      add_motion_file(s, choice, stop, out);
    } catch (const OutOfMemory&) {
      throw;
    } catch (const Error& error) {
      if (!choice.of_folder || stop) throw;
      if (first_error.empty()) first_error = error.what();
      out->motion.notes.push_back("left out: " + std::string(error.what()));
    }
  }
  if (out->motion.clips.empty()) throw Error(first_error);
}

// A picture's clips alone.
bool is_loop(const AnimateSettings& s) { return is_picture(s.character) && has_extension(s.output, ".apng"); }

// Errors that can be reported without reading files. The output folder of a folder is created later.
void check_settings(const AnimateSettings& s, bool of_folder) {
  const bool picture = is_picture(s.character);
  if (!s.vat.empty()) {
    check_vat_folder(s.vat);
    if (is_loop(s)) throw UsageError("--vat writes a mesh, but " + s.output + " is an animated picture; write a .glb");
    if (s.output.empty() && (!s.profile.profile.empty() || !s.profile.controls.empty()))
      throw UsageError("--for and --controls change the file of -o, which is missing; --vat textures have no skeleton");
  }
  if (s.motions.empty() && !picture)
    throw UsageError("--motion is required" + (has_use(s.character, kReadsMesh) ? "" : remedy(s.character)));
  if (!picture)
    refuse_given({{"--class", !s.picture.body.empty()}, {"--cut", s.picture.cut}, {"--depth", s.depth}},
                 " is for pictures (" + picture_files() + "), but " + s.character + " is not one");
  if (is_loop(s)) {
    if (!s.sprites.loop.empty() || !s.profile.profile.empty() || !s.profile.controls.empty())
      throw UsageError(
          s.output +
          ": an animated picture holds no character; leave out --loop, --for and --controls, or write a .glb");
  } else if ((!of_folder && !s.output.empty()) || has_extension(s.output, ".apng")) {
    check_output(s.output, kWritesMotion);
  }
  check_sprite_options(s.sprites, s.character);
  if (!s.sheet.empty()) check_output(s.sheet, {".png"});
  if (!(s.from <= s.to)) throw UsageError(print("--start %g is after --end %g", s.from, s.to));
  if (is_motion_alone(s.output) && !s.profile.controls.empty())
    throw UsageError(s.output + ": a clip alone has no character for --controls; write a .glb");
  if (!s.deform.method.empty() && is_motion_alone(s.output) && s.sheet.empty() && s.vat.empty())
    throw UsageError(s.output + ": a clip alone has no mesh for --deform to correct; write a .glb, or a --sheet");
}

// Reads, moves and writes one character.
Animated animate_one(const AnimateSettings& s, const std::atomic<bool>& stop) {
  const bool alone = is_motion_alone(s.output);
  DeformSettings corrections = s.deform;
  corrections.as_drawn = corrections.as_drawn && corrections.method == "xpbd";  // or the motion's alone
  const std::optional<sinew_deform_options> deform = deform_options(corrections);
  Animated animated = read_animated(s);
  add_motions(s, stop, &animated);
  if (has_extension(s.output, ".bvh") && animated.motion.clips.size() != 1)
    throw UsageError(s.output + ": a BVH holds one clip, found " + std::to_string(animated.motion.clips.size()) +
                     "; choose one with --motion FILE#CLIP, or write a .glb");
  if (s.springs) swing_clips({}, s.character, s.report, &animated);
  if (deform && !alone && !s.output.empty()) bake_clips(*deform, s.shapes, counted("corrected poses", stop), &animated);
  if (std::string note = checked_note(animated.character, &animated.motion); !note.empty())
    animated.motion.notes.push_back(std::move(note));
  SpriteSettings wanted = s.sprites;
  if (is_loop(s)) wanted.loop = s.output;
  std::vector<uint8_t> sheet;
  std::optional<CharacterDeformer> deformer;
  if (deform && (!s.sheet.empty() || wants_sprites(wanted))) deformer.emplace(animated.character, *deform);
  if (!s.sheet.empty())
    sheet = encode_png(motion_sheet(animated.character, animated.motion, axis_of(s.up_name),
                                    deformer ? &*deformer : nullptr,
                                    animated.picture ? animated.picture->picture.get() : nullptr));
  std::vector<NamedBytes> sprites;
  if (animated.picture)
    sprites = sprite_files(wanted, s.output, *animated.picture->picture, animated.character, animated.motion,
                           deformer ? &*deformer : nullptr);
  if (!s.vat.empty())
    animated.vat = vertex_animation(stem_of(s.character), animated, deform, counted("poses for textures", stop));
  if (stop) throw Error(s.output + ": cannot write, the job was interrupted");
  if (animated.vat) write_vat(s.vat, *animated.vat);
  if (alone) {
    write_clips(s.output, animated.character, animated.motion);
  } else if (!s.output.empty() && !is_loop(s)) {
    GlbOptions options;
    options.keep_skin = !animated.rigged;
    options.motion = &animated.motion;
    write_as(s.profile, s.output, animated.character, &animated.motion.notes, options, animated.morphs);
  }
  if (!s.sheet.empty()) write_file(s.sheet, sheet);
  if (animated.picture) write_mask(s.picture, *animated.picture);
  if (!sprites.empty()) write_files(sprites);
  return animated;
}

void run_animate_folder(AnimateSettings s, const std::atomic<bool>& stop) {
  refuse_given({{"--sheet", !s.sheet.empty()},
                {"--vat", !s.vat.empty()},
                {"--loop", !s.sprites.loop.empty()},
                {"--controls", !s.profile.controls.empty()}},
               " takes one character, but " + s.character + " is a folder");
  const std::string output = s.output;
  const std::vector<FolderFile> files = folder_files(s.character, output, "." + s.format, true);
  const auto settings_of = [&s](const FolderFile& file) {
    AnimateSettings one = s;
    one.character = file.mesh;
    one.output = file.output;
    return one;
  };
  for (const FolderFile& file : files) check_settings(settings_of(file), true);
  Progress progress(files.size(), "characters");
  size_t failed = 0;
  for (const FolderFile& file : files) {
    const AnimateSettings one = settings_of(file);
    try {
      make_folder(std::filesystem::path(file.output).parent_path().string());
      const Animated animated = animate_one(one, stop);
      if (s.json) progress.say(stdout, json_line(animate_json(one, animated)));
    } catch (const Error& error) {
      if (stop) throw;
      ++failed;
      progress.say(stderr, "sinew: error: " + printable(error.what()));
    }
    progress.step();
  }
  check_failed(failed, files.size(), "characters");
  if (!s.json) std::printf("wrote %zu files to %s\n", files.size(), printable(output).c_str());
}

void run_animate(const AnimateSettings& s) {
  settle_profile(s.profile, nullptr);
  const std::atomic<bool>& stop = stop_on_signals();
  std::error_code ignored;
  if (std::filesystem::is_directory(s.character, ignored)) return run_animate_folder(s, stop);
  check_settings(s, false);
  tell_animated(s, animate_one(s, stop));
}

void add_animate_inputs(CLI::App* sub, AnimateSettings* s) {
  sub->add_option("character", s->character,
                  "Skinned file, NAME.obj with NAME.rig.txt, bare mesh, picture of a character (" + picture_files() +
                      "), or a folder of them. A mesh without a skeleton is rigged first. " + mesh_files())
      ->required()
      ->type_name("CHARACTER|DIR");
  sub->add_option("--motion", s->motions,
                  "Motion to play: all animations of a file, FILE#CLIP for one of them, all files of a folder, or a "
                  "built-in clip (builtin:walk, builtin:walk:lively; builtin: lists them); repeatable. Required, "
                  "except for pictures, which get a built-in clip of their class. " +
                      motion_files())
      ->type_name("FILE[#CLIP]|FOLDER")
      ->allow_extra_args(false);
  shared_option(sub, "-o,--output", s->output,
                "The character with its new animations; a clip alone as .bvh or .vrma; an animated picture as .apng; a "
                "folder for a folder. Optional with --vat. " +
                    extensions_text(kWritesMotion));
  shared_option(sub, "--map", s->map, "By default joints are matched by anatomy and names");
  shared_word_option(
      sub, "--method", s->method, kAnimateMethod,
      "copy: copy joint rotations between aligned rest poses; contacts: copy, then keep planted feet in place, arms "
      "out of the body, and hands in contact if the motion file has a body with the same mesh; stream: contacts from "
      "past frames only, as for live capture; auto: contacts. For comparison, as published: reference-points (points "
      "on both bodies), node-offsets (joint alignment, which stretches bones)");
  sub->add_option("--sheet", s->sheet, "Also draw frames of every clip side by side")->type_name("FILE");
  add_vat_option(sub, &s->vat);
  shared_option(sub, "--up", s->up_name, "Of the character")
      ->check(CLI::IsMember({"auto", "x", "y", "z"}))
      ->capture_default_str();
  shared_option(sub, "--from-up", s->motion_up_name, "Of the motion; -y: y points down")
      ->check(CLI::IsMember({"auto", "x", "y", "z", "-x", "-y", "-z"}))
      ->capture_default_str();
  shared_option(sub, "--layout", s->layout, motion_layouts() + ". By default chosen by the number of keypoints");
  shared_option(sub, "--actor", s->actor, "Required if the actors differ; otherwise the first one");
  sub->add_flag(
      "--measure", s->report,
      "Report what the method changed on each limb. Before and after: frames in the body or under the floor, contacts, "
      "sliding, frames outside the natural range. With --springs: how much of the swinging mesh enters the body");
  sub->add_flag("--force", s->force,
                "Play a motion that does not fit the character. Such as a person's motion on a horse, which is an "
                "error by default");
  std::vector<std::string> formats = format_names(kWritesMotion);
  formats.emplace_back("apng");
  shared_option(sub, "--format", s->format, "For a folder; apng is for pictures")
      ->check(CLI::IsMember(formats))
      ->capture_default_str();
  shared_flag(sub, "--json", s->json);
}

void add_clip_options(CLI::App* sub, AnimateSettings* s) {
  section(sub, "The clip");
  sub->add_flag("--in-place", s->in_place, "Keep the character above its rest position");
  sub->add_option("--arm-spread", s->arm_spread, "Lift both arms away from the body; below 0: bring them nearer")
      ->check(CLI::Range(-90.0, 90.0))
      ->type_name("DEGREES");
  sub->add_flag("--translations", s->translations,
                "Stretch the spine, arms and legs as in the motion. By default they keep their lengths unless the rigs "
                "are equal");
  sub->add_option("--limits", s->limits,
                  "Rotation limits of joints, for every --method: a robot's .urdf, a text file with lines hinge, ball "
                  "and fixed (formats/spec/limits.md), or human (limits of the human body)")
      ->type_name("FILE|human");
  sub->add_option("--fps", s->fps, "Frames per second. By default those of the motion")
      ->check(CLI::Range(0.1, 1000.0))
      ->type_name("N");
  sub->add_option("--start", s->from, "First second of the motion to play")
      ->check(CLI::NonNegativeNumber)
      ->type_name("T");
  sub->add_option("--end", s->to, "Last second of the motion to play")->check(CLI::NonNegativeNumber)->type_name("T");
  sub->add_flag("--springs", s->springs, "Simulate hair, tails, ears and skirts as springs, as found by sinew springs");
  sub->add_flag("--range,!--no-range", s->range, "Keep knees and elbows in their natural range, with contacts [on]");
}

// --area-power, --falloff, --own-limb and --legs.
std::vector<CLI::Option*> add_reference_options(CLI::App* sub, AnimateSettings* s) {
  section(sub, "Reference points");
  return {
      sub->add_option("--area-power", s->area_power, "Exponent of a triangle's area in its influence")
          ->check(CLI::Range(0, 4))
          ->type_name("N")
          ->capture_default_str(),
      sub->add_option("--falloff", s->falloff, "Falloff of influence, exp(-(distance / (X * body height))^2); 0: none")
          ->check(CLI::Range(0.0, 100.0))
          ->type_name("X")
          ->capture_default_str(),
      sub->add_flag("--own-limb,!--no-own-limb", s->own_limb, "Count the triangles of the limb itself [off]"),
      sub->add_flag("--legs", s->legs, "Include knees and ankles. Feet may leave the floor"),
      sub->add_flag("--head", s->head, "Include the head"),
      sub->add_flag("--torso", s->torso, "Copy directions between torso joints, instead of rotations"),
      sub->add_flag("--source-points", s->source_points,
                    "Take reference points on the source's body instead of the target's")};
}

void add_corrections(CLI::App* sub, AnimateSettings* s) {
  section(sub, "Corrections");
  add_deform_options(sub, {"volume", "xpbd", "delta-mush"},
                     "Write corrections as morph targets with animated weights. ", &s->deform);
  shared_option(sub, "--shapes", s->shapes, "Per clip")->check(CLI::Range(1u, 256u))->capture_default_str();
  add_solver_options(sub, &s->deform);
  add_drawn_correction(sub, &s->deform,
                       "; with --method reference-points: one sum over all triangles of the source's body, including "
                       "the limb's own, for legs, head and torso too, without pushing out; with a picture: a skeleton "
                       "of its regions and a map by branches, without a model");
}

}  // namespace

void add_animate(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("animate", "Retarget a motion onto a character");
  auto s = std::make_shared<AnimateSettings>();
  add_animate_inputs(sub, s.get());
  add_clip_options(sub, s.get());
  add_picture_options(sub, &s->picture);
  add_picture_class(sub, &s->picture);
  shared_flag(sub, "--cut", s->picture.cut, kPictureCut);
  sub->add_flag("--depth", s->depth, "Let a picture's bones leave the picture plane as in the motion");
  add_sprite_options(sub, &s->sprites);
  add_corrections(sub, s.get());
  const std::vector<CLI::Option*> of_reference = add_reference_options(sub, s.get());
  add_profile_options(sub, &s->profile);
  add_controls_option(sub, &s->profile);
  sub->footer(
      "Examples:\n  sinew animate hero.glb --motion walk.bvh -o walking.glb --sheet walking.png\n"
      "  sinew animate mesh.obj --motion builtin:walk --motion moves.glb#jump --map map.txt -o moves.glb\n"
      "  sinew animate drawing.png -o drawing.glb --sheet drawing-frames.png\n\n"
      "  sinew animate broad.glb --motion walking.glb --method reference-points -o other.glb\n"
      "  sinew animate hero.glb --motion walk.bvh --deform volume -o walking.glb\n"
      "  sinew animate hero.glb --motion builtin:walk --in-place --vat crowd");
  sub->callback([s, of_reference, sub] {
    if (s->output.empty() && s->vat.empty()) throw CLI::RequiredError("--output");
    check_picture_options(*sub, s->character);
    for (const CLI::Option* option : of_reference)
      if (option->count() > 0 && s->method != AnimateMethod::kReferencePoints)
        throw UsageError(option->get_name() + " needs --method reference-points");
    for (const CLI::Option* option : of_reference)
      if (option->count() > 0 && s->deform.as_drawn)
        throw UsageError("--as-drawn fixes how reference points count: leave " + option->get_name() + " out");
    if (s->deform.as_drawn && s->method != AnimateMethod::kReferencePoints && s->deform.method != "xpbd" &&
        !is_picture(s->character))
      throw UsageError("--as-drawn needs a picture, --method reference-points or --deform xpbd");
    run_animate(*s);
  });
}

}  // namespace sinew::cli
