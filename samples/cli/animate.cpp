// SPDX-License-Identifier: MIT
// sinew animate: motion of any skeleton for a character, into its own file.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "deform_options.hpp"
#include "motion_sheet.hpp"
#include "options.hpp"
#include "picture_options.hpp"
#include "profile_options.hpp"
#include "progress.hpp"
#include "sinew_character/animate_job.hpp"
#include "sinew_character/checked_note.hpp"
#include "sinew_character/motion_file.hpp"
#include "sinew_character/plane_motion.hpp"
#include "sinew_datasets/image.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion_layout.hpp"
#include "sinew_formats/print.hpp"
#include "sprite_options.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string character, output, map, method = "auto", up = "auto", motion_up = "auto", sheet, layout, actor, limits;
  std::vector<std::string> motions;
  DeformSettings deform;
  PictureOptions picture;
  SpriteSettings sprites;
  ProfileSettings profile;
  size_t shapes = 16;
  double fps = 0, from = 0, to = 1e9;
  uint32_t area_power = 3;
  double falloff = 0.05;
  bool own_limb = false, legs = false, head = false, torso = false, source_points = false, range = true;
  bool in_place = false, json = false, report = false, force = false, translations = false, depth = false;
};

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

struct Animated : AnimatedCharacter {
  std::optional<PictureCharacter> picture;  // what it was made of
};

// A bound character as it is; a mesh without a skeleton gets one, a picture a mesh as well.
Animated read_animated(const Settings& s) {
  const std::string& path = s.character;
  if (is_picture(path)) {
    PictureCharacter made = rig_picture(path, picture_job(s.picture));
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

AnimateOptions animate_options(const Settings& s) {
  AnimateOptions options;
  options.character = s.character;
  options.up = s.up;
  options.motion_up = s.motion_up;
  options.map = s.map;
  options.method = s.method == "copy"               ? AnimateMethod::kCopy
                   : s.method == "contacts"         ? AnimateMethod::kContacts
                   : s.method == "reference-points" ? AnimateMethod::kReferencePoints
                                                    : AnimateMethod::kAuto;
  options.limits = s.limits;
  options.in_place = s.in_place;
  options.range = s.range;
  options.report = s.report;
  options.force = s.force || s.motions.empty();  // of a picture, whose clip nobody asked for: a warning will do
  options.translations = s.translations;
  options.fps = s.fps;
  options.from = s.from;
  options.to = s.to;
  options.reference.area_power = s.area_power == 0 ? SINEW_NO_AREA : s.area_power;
  options.reference.falloff = s.falloff == 0 ? SINEW_NO_FALLOFF : static_cast<float>(s.falloff);
  options.reference.own_limb = s.own_limb ? 1 : 0;
  options.reference.legs = s.legs ? 1 : 0;
  options.reference.head = s.head ? 1 : 0;
  options.reference.torso = s.torso ? 1 : 0;
  options.reference.source_points = s.source_points ? 1 : 0;
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

void add_motion_file(const Settings& s, const MotionChoice& choice, const std::atomic<bool>& stop, Animated* out) {
  const std::string layout = choice.of_folder && !takes_layout(choice.file) ? "" : s.layout;
  MotionFile source = read_motion_for({choice.file, s.fps, layout, s.actor, s.up}, map_rig_of(out->character));
  if (choice.of_folder || choice.clip.empty()) name_clips(choice.file, choice.of_folder, out->motion, &source.motion);
  const auto body = [&] { return source.whole ? body_of_motion(choice.file) : std::nullopt; };
  const MotionInput input = {choice.file, choice.clip, &source.motion, body};
  const StepsOf steps = counted("frames of " + file_name(choice.file), stop);
  if (out->picture)
    add_picture_motion(*out->picture, s.depth, animate_options(s), input, steps, out);
  else
    add_motion(animate_options(s), input, steps, out);
}

Json limb_json(const sinew_limb_measure& limb) {
  return {{"deep_frames", limb.deep_frames},       {"depth", limb.depth}, {"greatest_depth", limb.greatest_depth},
          {"contact_frames", limb.contact_frames}, {"error", limb.error}, {"greatest_error", limb.greatest_error},
          {"range_frames", limb.range_frames}};
}

// What a folder has that is no motion, or none for this character, is left out and told.
void add_motions(const Settings& s, const std::atomic<bool>& stop, Animated* out) {
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

// A line a limb: copied, then as the method left it.
void tell_report(const Character& character, const ClipReport& report) {
  if (report.before.empty()) std::printf("  no arms or legs to measure\n");
  for (size_t i = 0; i < report.before.size(); ++i) {
    const sinew_limb_measure &a = report.before[i], &b = report.after[i];
    const auto percent = [](float share) { return 100 * static_cast<double>(share); };
    const bool leg = a.leg != 0;
    std::printf("  %s: %s in %u of %u frames -> %u, at most %.2f %% of the height -> %.2f",
                printable(character.joints[a.joint].name).c_str(), leg ? "under the floor" : "in the body",
                a.deep_frames, a.frames, b.deep_frames, percent(a.greatest_depth), percent(b.greatest_depth));
    if (a.contact_frames > 0)
      std::printf("; %s in %u, %s %.3f %% -> %.3f", leg ? "stands" : "touches", a.contact_frames,
                  leg ? "slides a frame" : "distance off by", percent(a.error), percent(b.error));
    if (a.range_frames + b.range_frames > 0)
      std::printf("; %s out of range in %u -> %u", leg ? "knee" : "elbow", a.range_frames, b.range_frames);
    std::printf("\n");
  }
}

void tell(const Settings& s, const Animated& animated) {
  const size_t joints = animated.character.joints.size();
  if (s.json) {
    Json json = {{"sinew_animate", 1}};
    json["character"] = s.character;
    json["output"] = s.output;
    json["joints"] = joints;
    json["rigged"] = animated.rigged;
    if (animated.picture) json["picture"] = picture_json(*animated.picture);
    for (const AnimatedClip& one : animated.made) {
      json["clips"].push_back({{"motion", one.file},
                               {"name", one.clip},
                               {"frames", one.frames},
                               {"fps", 1 / one.frame_time},
                               {"mapped", one.mapped},
                               {"map", one.map}});
      for (size_t i = 0; i < one.report.before.size(); ++i)
        json["clips"].back()["report"].push_back({{"joint", animated.character.joints[one.report.before[i].joint].name},
                                                  {"limb", one.report.before[i].leg != 0 ? "leg" : "arm"},
                                                  {"before", limb_json(one.report.before[i])},
                                                  {"after", limb_json(one.report.after[i])}});
      if (s.deform.method.empty()) continue;
      json["clips"].back()["shapes"] = one.shapes;
      json["clips"].back()["error"] = {{"linear", one.error.linear}, {"baked", one.error.baked}};
    }
    json["notes"] = animated.motion.notes;
    std::printf("%s\n", json_line(json).c_str());
    return;
  }
  if (animated.rigged)
    std::printf("%s: had no skeleton and got one of %zu joints\n", printable(s.character).c_str(), joints);
  for (const AnimatedClip& one : animated.made) {
    std::printf("%s, %s: %zu frames, %.4g a second; %zu of %zu joints move by %s\n", printable(one.file).c_str(),
                printable(one.clip).c_str(), one.frames, 1 / one.frame_time, one.mapped, joints,
                printable(one.map).c_str());
    if (s.report) tell_report(animated.character, one.report);
  }
  for (const AnimatedClip& one : animated.made)
    if (!s.deform.method.empty())
      std::printf("  %s: %zu shapes, %.3f %% of the size from the corrected poses, linear skinning alone %.3f %%\n",
                  printable(one.clip).c_str(), one.shapes, 100 * one.error.baked, 100 * one.error.linear);
  for (const std::string& note : animated.motion.notes) std::printf("  %s\n", printable(note).c_str());
  std::printf("wrote %s\n", printable(s.output).c_str());
}

void run(const Settings& s) {
  settle_profile(s.profile, nullptr);
  if (s.motions.empty() && !is_picture(s.character)) throw UsageError("--motion is required");
  if (s.depth && !is_picture(s.character)) throw UsageError("--depth is for pictures, and " + s.character + " is none");
  check_output(s.output, kWritesMotion);
  check_sprite_options(s.sprites, s.character);
  if (!s.sheet.empty()) check_output(s.sheet, {".png"});
  if (!(s.from <= s.to)) throw UsageError(print("--start %g is behind --end %g", s.from, s.to));
  const bool as_bvh = has_extension(s.output, ".bvh");
  const std::optional<sinew_deform_options> deform = deform_options(s.deform);
  if (as_bvh && !s.profile.controls.empty())
    throw UsageError(s.output + ": a BVH has no character that --controls could be of; write a .glb");
  if (deform && as_bvh && s.sheet.empty())
    throw UsageError(s.output + ": a BVH has no mesh that --deform could correct; write a .glb, or a --sheet");
  const std::atomic<bool>& stop = stop_on_signals();
  Animated animated = read_animated(s);
  add_motions(s, stop, &animated);
  if (as_bvh && animated.motion.clips.size() != 1)
    throw UsageError(s.output + ": a BVH holds one clip, and there are " +
                     std::to_string(animated.motion.clips.size()) +
                     "; say which with --motion FILE#CLIP, or write a .glb");
  if (deform && !as_bvh) bake_clips(*deform, s.shapes, counted("corrected poses", stop), &animated);
  if (std::string note = checked_note(animated.character, &animated.motion); !note.empty())
    animated.motion.notes.push_back(std::move(note));
  std::vector<uint8_t> sheet;
  std::optional<CharacterDeformer> deformer;
  if (deform && (!s.sheet.empty() || wants_sprites(s.sprites))) deformer.emplace(animated.character, *deform);
  if (!s.sheet.empty())
    sheet = encode_png(motion_sheet(animated.character, animated.motion, s.up == "z", deformer ? &*deformer : nullptr,
                                    animated.picture ? animated.picture->picture.get() : nullptr));
  std::vector<NamedBytes> sprites;
  if (animated.picture)
    sprites = sprite_files(s.sprites, s.output, *animated.picture->picture, animated.character, animated.motion,
                           deformer ? &*deformer : nullptr);
  if (stop) throw Error(s.output + ": cannot write, the work was interrupted");
  if (as_bvh) {
    write_bvh(s.output, animated.motion, animated.motion.clips[0]);
  } else {
    GlbOptions options;
    options.keep_skin = !animated.rigged;
    options.motion = &animated.motion;
    write_as(s.profile, s.output, animated.character, &animated.motion.notes, options, animated.morphs);
  }
  if (!s.sheet.empty()) write_file(s.sheet, sheet);
  if (animated.picture) write_mask(s.picture, *animated.picture);
  if (!sprites.empty()) write_files(sprites);
  tell(s, animated);
}

void add_inputs(CLI::App* sub, Settings* s) {
  sub->add_option("character", s->character,
                  "Skinned file, NAME.obj with NAME.rig.txt beside it, a bare mesh, or a picture of a character (" +
                      picture_files() + "). What has no skeleton gets one first; " + mesh_files())
      ->required()
      ->type_name("CHARACTER");
  sub->add_option(
         "--motion", s->motions,
         "Motion: all animations of a file or the one behind #, of every file of a folder, or a clip that ships: "
         "builtin:walk, builtin: lists them; may be repeated. A picture has one of its class unless given. " +
             motion_files())
      ->type_name("FILE[#CLIP]|FOLDER")
      ->allow_extra_args(false);
  shared_option(sub, "-o,--output", s->output,
                "The character with its new animations, or one clip as .bvh: " + extensions_text(kWritesMotion))
      ->required();
  shared_option(sub, "--map", s->map, "By anatomy and names unless given");
  shared_option(
      sub, "--method", s->method,
      "copy: every joint rotates as its source does, rest poses aligned; contacts: then feet stay where they "
      "stand, arms stay out of the body, and where the motion has a body of the same mesh, hands keep in touch "
      "with it; reference-points: the published method, by points of both bodies, for comparison; auto: contacts")
      ->check(CLI::IsMember({"auto", "copy", "contacts", "reference-points"}))
      ->capture_default_str();
  sub->add_option("--sheet", s->sheet, "Also draw frames of every clip side by side")->type_name("FILE");
  shared_option(sub, "--up", s->up, "For the character")
      ->check(CLI::IsMember({"auto", "x", "y", "z"}))
      ->capture_default_str();
  shared_option(sub, "--from-up", s->motion_up, "For the motions")
      ->check(CLI::IsMember({"auto", "x", "y", "z"}))
      ->capture_default_str();
  shared_option(sub, "--layout", s->layout, motion_layouts() + ". Guessed by their count unless given");
  shared_option(sub, "--actor", s->actor, "The first unless given, where all are alike");
  sub->add_flag("--measure", s->report,
                "Say for every limb what the method changed. Copied and then: frames in the body or under the floor, "
                "contacts, sliding, frames out of the natural range");
  sub->add_flag("--force", s->force,
                "Play a motion that does not fit the character, such as a person's on a horse. Refused unless given");
  shared_flag(sub, "--json", s->json);
}

void add_clip_options(CLI::App* sub, Settings* s) {
  section(sub, "The clip");
  sub->add_flag("--in-place", s->in_place, "Stay above where the character stands at rest");
  sub->add_flag(
      "--translations", s->translations,
      "Spine, arms and legs stretch as the motion's do. Elsewhere than between equal rigs they keep their lengths "
      "unless given");
  sub->add_option(
         "--limits", s->limits,
         "How far joints may turn, contacts or not. A robot's .urdf, a text file of lines hinge, ball and fixed "
         "(formats/spec/limits.md), or human: what bodies can do")
      ->type_name("FILE|human");
  sub->add_option("--fps", s->fps, "Frames a second. As many as the motion has unless given")
      ->check(CLI::Range(0.1, 1000.0))
      ->type_name("N");
  sub->add_option("--start", s->from, "First second of the motion")->check(CLI::NonNegativeNumber)->type_name("T");
  sub->add_option("--end", s->to, "Last second of the motion")->check(CLI::NonNegativeNumber)->type_name("T");
  sub->add_flag("--range,!--no-range", s->range,
                "Contacts keep knees and elbows in their natural range, or not. They do unless told");
}

// --area-power, --falloff, --own-limb and --legs.
std::vector<CLI::Option*> add_reference_options(CLI::App* sub, Settings* s) {
  section(sub, "Reference points");
  return {
      sub->add_option("--area-power", s->area_power, "A triangle's influence grows with its area to this power")
          ->check(CLI::Range(0, 4))
          ->type_name("N")
          ->capture_default_str(),
      sub->add_option("--falloff", s->falloff,
                      "Influence falls by exp(-(distance / so many heights of the body)^2); 0: not at all, as drawn")
          ->check(CLI::Range(0.0, 100.0))
          ->type_name("X")
          ->capture_default_str(),
      sub->add_flag("--own-limb,!--no-own-limb", s->own_limb,
                    "Triangles of the limb itself count, or not. They do not unless told"),
      sub->add_flag("--legs", s->legs, "Knees and ankles as well. Feet leave the floor by it"),
      sub->add_flag("--head", s->head, "The head as well"),
      sub->add_flag("--torso", s->torso, "Torso joints lie as the source's do, not as its turns bend them"),
      sub->add_flag("--source-points", s->source_points, "Reference points of the source's body, not the target's")};
}

void add_corrections(CLI::App* sub, Settings* s) {
  section(sub, "Corrections");
  add_deform_options(sub, {"volume", "xpbd", "delta-mush"}, "The file gets morph targets and their weights over time. ",
                     &s->deform);
  shared_option(sub, "--shapes", s->shapes, "A clip")->check(CLI::Range(1u, 256u))->capture_default_str();
  add_solver_options(sub, &s->deform);
}

}  // namespace

void add_animate(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("animate", "Play motion of another skeleton on a character");
  auto s = std::make_shared<Settings>();
  add_inputs(sub, s.get());
  add_clip_options(sub, s.get());
  add_picture_options(sub, &s->picture);
  add_picture_class(sub, &s->picture);
  sub->add_flag("--depth", s->depth, "Bones of a picture's character leave its plane as the motion's do");
  add_sprite_options(sub, &s->sprites);
  add_corrections(sub, s.get());
  const std::vector<CLI::Option*> of_reference = add_reference_options(sub, s.get());
  add_profile_options(sub, &s->profile);
  add_controls_option(sub, &s->profile);
  sub->footer(
      "Examples:\n  sinew animate hero.glb --motion walk.bvh -o walking.glb --sheet walking.png\n"
      "  sinew animate hero.glb --motion walk.bvh --motion moves.glb#jump --map map.txt -o moves.glb\n"
      "  sinew animate mesh.obj --motion builtin:walk -o walking.glb\n"
      "  sinew animate drawing.png -o drawing.glb --sheet drawing-frames.png\n\n"
      "  sinew animate broad.glb --motion walking.glb --method reference-points -o other.glb\n"
      "  sinew animate hero.glb --motion walk.bvh --deform volume -o walking.glb");
  sub->callback([s, of_reference, sub] {
    check_picture_options(*sub, s->character);
    if (!s->picture.body.empty() && !is_picture(s->character))
      throw UsageError("--class is for pictures (" + picture_files() + "), and " + s->character + " is none");
    for (const CLI::Option* option : of_reference)
      if (option->count() > 0 && s->method != "reference-points")
        throw UsageError(option->get_name() + " goes with --method reference-points");
    run(*s);
  });
}

}  // namespace sinew::cli
