// SPDX-License-Identifier: MIT
// One file from its mesh to its weights.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "bind_files.hpp"
#include "bind_summary.hpp"
#include "options.hpp"
#include "sinew_character/bind/answers.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/jobs/bind_job.hpp"
#include "sinew_character/style/style.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

int show_progress(void* user, uint32_t done_permille) {
  uint32_t* shown = static_cast<uint32_t*>(user);
  if (done_permille / 10 != *shown) {
    *shown = done_permille / 10;
    std::fprintf(stderr, "\rbinding %3u %%", *shown);
    if (*shown >= 100) std::fprintf(stderr, "\r              \r");
    std::fflush(stderr);
  }
  return 0;
}

void set_flags(const BindSettings& settings, const Character& character, std::vector<uint8_t>* flags) {
  if (settings.deform.empty() && settings.never.empty()) return;
  flags->assign(character.joints.size(), 0);
  if (!settings.deform.empty()) {
    for (size_t j : read_joint_list(settings.deform, character)) (*flags)[j] |= SINEW_JOINT_DEFORMS;
  }
  if (!settings.never.empty()) {
    for (size_t j : read_joint_list(settings.never, character)) (*flags)[j] |= SINEW_JOINT_NEVER;
  }
}

// [V] non-zero: keeps its weights; empty without --lock.
std::vector<uint8_t> read_locks(const BindSettings& settings, const Character& character) {
  if (settings.lock.empty()) return {};
  if (character.influences.empty()) {
    throw Error(settings.lock + ": --lock keeps weights of the file, but neither " + settings.mesh +
                " nor its skeleton file has any");
  }
  return read_vertex_locks(settings.lock, character);
}

// Weights that a file has for some of the vertices.
std::optional<BindHints> read_hints(const BindSettings& settings, const Character& character) {
  if (settings.hints.empty()) return std::nullopt;
  Character painted;
  painted.name = character.name;
  painted.vertices = character.vertices;
  painted.gltf = character.gltf;
  read_skeleton(settings.hints, true, &painted);
  return BindHints{settings.hints, std::move(painted.joints), std::move(painted.influences)};
}

std::optional<Character> read_like(const BindSettings& settings) {
  if (settings.like.empty()) return std::nullopt;
  Character source = read_character(settings.like);
  if (source.joints.empty() || source.influences.empty())
    throw Error(settings.like + ": --like needs a bound character, found no skin weights");
  return source;
}

JointsFrom joints_from(const BindSettings& settings) {
  if (settings.joints == "own") return JointsFrom::kOwn;
  if (settings.joints == "names") return JointsFrom::kNames;
  if (settings.joints == "all") return JointsFrom::kAll;
  return settings.skeleton.empty() ? JointsFrom::kAuto : JointsFrom::kNames;
}

BindJobOptions job_options(const BindSettings& settings, const Binder& binder, const Character& character) {
  BindJobOptions job;
  job.mesh = settings.mesh;
  job.joints = joints_from(settings);
  job.keep_tips = settings.keep_tips;
  job.bind_props = settings.bind_props;
  job.fit = settings.fit;
  job.symmetric = settings.symmetric;
  job.seams = !settings.no_seams;
  job.cut = settings.cut;
  job.to_pose = settings.to_pose;
  job.pose_preferred = settings.pose_preferred;
  job.influence_count = settings.influences;
  job.up_axis = axis_of(settings.up);
  job.thread_count = settings.threads;
  set_flags(settings, character, &job.joint_flags);
  BindOptions style;
  style.method = binder.model == nullptr ? binder.method : uint32_t{SINEW_METHOD_MODEL};
  apply_style(settings.style, &style);
  job.rigid_parts = style.rigid_parts;
  job.softness_percent = style.softness_percent;
  job.surface_vertices = style.surface_vertices;
  return job;
}

void draw(const BindSettings& settings, const Character& character, const std::vector<uint8_t>& confidence) {
  RenderOptions view;
  view.up = axis_of(settings.up);
  if (!settings.png.empty()) write_file(settings.png, encode_png(render(character, weight_colors(character), view)));
  if (settings.png_confidence.empty()) return;
  // Red is the least sure vertex of this character: a table of measured hits has few low entries.
  constexpr float kLeastScale = 0.1f;
  std::vector<float> doubt;
  for (const uint8_t c : confidence) doubt.push_back(1.0f - static_cast<float>(c) / 255.0f);
  float largest = kLeastScale;
  for (const float d : doubt) largest = std::max(largest, d);
  write_file(settings.png_confidence, encode_png(render(character, heat_colors(doubt, largest), view)));
}

BindSummary summarize(const BindSettings& settings, const Binder& binder, const Character& character,
                      const CharacterBind& result) {
  BindSummary summary;
  summary.mesh = settings.mesh;
  summary.name = character.name;
  summary.method = binder.name;
  summary.output = settings.output;
  summary.png = settings.png;
  summary.png_confidence = settings.png_confidence;
  count_weights(character, &summary);
  summary.influences = settings.influences;
  summary.hash = bind_hash(character.influences, settings.influences);
  summary.seconds = result.seconds;
  summary.workspace_bytes = result.workspace_bytes;
  summary.workspace_used_bytes = result.used_bytes;
  summary.symmetric = settings.symmetric;
  summary.symmetric_vertices = result.symmetric_vertices;
  summary.doubts = find_doubts(character, result.confidence);
  return summary;
}

// The file's weights before it is rebound.
struct WeightsBefore {
  std::vector<std::vector<Influence>> rows;
  std::vector<uint8_t> kept;  // [V] locked, or of an attached mesh; or empty
};

WeightsBefore weights_before(const BindSettings& settings, const Character& character,
                             const std::vector<uint8_t>& locked) {
  WeightsBefore before{character.influences, locked};
  if (character.vertex_meshes.empty()) return before;
  const std::vector<bool> kept = kept_meshes(character, settings.bind_props);
  before.kept.resize(character.vertices.size(), 0);
  for (size_t v = 0; v < before.kept.size(); ++v)
    if (kept[character.vertex_meshes[v]]) before.kept[v] = 1;
  return before;
}

// Answers from the style file, the command line and the terminal, in this order: the later one counts.
struct Answers {
  std::vector<sinew_answer> given;
  size_t by_style = 0;
};

CharacterBind bind_and_ask(const BindSettings& settings, const Character& character, BindJob* job, Answers* answers) {
  std::vector<sinew_answer>& given = answers->given;
  Style style;
  if (!settings.studio_style.empty()) style = read_style(settings.studio_style);
  std::vector<sinew_answer> said;
  for (const std::string& answer : settings.answers) said.push_back(parse_answer(answer, character));
  if (!settings.studio_style.empty()) given = job->answers_of(style);
  answers->by_style = given.size();
  given.insert(given.end(), said.begin(), said.end());
  CharacterBind result = job->bind(given, settings.questions);
  if (settings.ask && !result.questions.empty()) {
    const std::vector<sinew_answer> typed =
        ask(character, result, stem_of(settings.output), axis_of(settings.up), std::cin, std::cerr);
    given.insert(given.end(), typed.begin(), typed.end());
    said.insert(said.end(), typed.begin(), typed.end());
    if (!typed.empty()) result = job->bind(given, settings.questions);
  }
  if (!settings.save_style.empty())
    write_style(settings.save_style, job->learned(std::move(style), said, settings.save_style));
  return result;
}

}  // namespace

BoundFile bind_one(const BindSettings& settings, const Binder& binder, bool progress) {
  Character character =
      transformed(read_mesh_and_skeleton(settings.mesh, settings.skeleton, !settings.lock.empty() || settings.compare),
                  settings.transform, axis_of(settings.up));
  check_bindable(character);  // before anything that takes longer the more joints there are
  const std::vector<uint8_t> locked = read_locks(settings, character);
  const WeightsBefore before = weights_before(settings, character, locked);
  const std::optional<BindHints> hints = read_hints(settings, character);
  const std::optional<Character> like = read_like(settings);
  BindJobOptions options = job_options(settings, binder, character);
  options.locked = locked;
  options.hints = hints ? &*hints : nullptr;
  options.like = like ? &*like : nullptr;
  uint32_t shown = 0;
  if (progress) {
    options.progress = show_progress;
    options.progress_user = &shown;
  }
  BindJob job(options, binder, &character);
  Answers answers;
  CharacterBind result = bind_and_ask(settings, character, &job, &answers);
  const WeightsReplaced replaced = compare_weights(character.joints, before.rows, result.influences, before.kept);
  job.apply(&result);
  if (settings.confidence) character.confidence = result.confidence;
  write_as(settings.profile, settings.output, character, &character.notes);
  draw(settings, character, result.confidence);
  BindSummary summary = summarize(settings, binder, character, result);
  summary.locked_vertices = locked.size() - static_cast<size_t>(std::count(locked.begin(), locked.end(), 0));
  summary.answers = answers.given.size();
  summary.answers_by_style = answers.by_style;
  summary.style = settings.save_style;
  if (!settings.ask) summary.questions = part_questions(character, result);
  summary.notes.insert(summary.notes.end(), character.notes.begin(), character.notes.end());
  for (const LeftOutJoint& left : job.choice().left_out)
    summary.left_out.emplace_back(character.joints[left.joint].name, left.why);
  if (summary.locked_vertices < summary.vertices)  // else nothing got other weights
    for (std::string& note : bind_notes(character, job.choice(), result)) summary.notes.push_back(std::move(note));
  summary.compare = settings.compare;
  summary.replaced = replaced;
  summary.seams = seams_json(character.joints, result.seams);
  return {std::move(character), std::move(summary)};
}

}  // namespace sinew::cli
