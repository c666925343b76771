// SPDX-License-Identifier: MIT
// One file from its mesh to its weights.
#include "bind_one.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "bind_like.hpp"
#include "bind_questions.hpp"
#include "sinew_character/answers.hpp"
#include "sinew_character/bind_character.hpp"
#include "sinew_character/engine_views.hpp"
#include "sinew_character/skeleton_repair.hpp"
#include "sinew_character/style.hpp"
#include "sinew_datasets/image.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"
#include "thread_pool.hpp"

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
    throw Error(settings.lock + ": vertices can keep only weights they have, and neither " + settings.mesh +
                " nor its skeleton file brings any");
  }
  std::vector<uint8_t> locked(character.vertices.size(), 0);
  for (size_t v : read_vertex_list(settings.lock, character)) {
    if (character.influences[v].empty())
      throw Error(settings.lock + ": vertex " + std::to_string(v) + " has no weights to keep");
    locked[v] = 1;
  }
  return locked;
}

// Rows of the hint file go where the mesh's own are; joints are matched by name.
void set_hints(const BindSettings& settings, Character* character, std::vector<uint8_t>* hints) {
  if (settings.hints.empty()) return;
  Character painted;
  painted.name = character->name;
  painted.vertices = character->vertices;
  painted.gltf = character->gltf;
  read_skeleton(settings.hints, true, &painted);
  std::vector<uint32_t> joint_of(painted.joints.size());
  for (size_t j = 0; j < painted.joints.size(); ++j) {
    const auto at = std::find_if(character->joints.begin(), character->joints.end(),
                                 [&](const Joint& joint) { return joint.name == painted.joints[j].name; });
    joint_of[j] = static_cast<uint32_t>(at - character->joints.begin());
  }
  hints->assign(character->vertices.size(), 0);
  character->influences.resize(character->vertices.size());
  size_t count = 0;
  for (size_t v = 0; v < painted.influences.size(); ++v) {
    if (painted.influences[v].empty()) continue;
    for (Influence& influence : painted.influences[v]) {
      if (joint_of[influence.joint] == character->joints.size()) {
        throw Error(settings.hints + ": vertex " + std::to_string(v) + " is painted with joint " +
                    painted.joints[influence.joint].name + ", which the skeleton does not have");
      }
      influence.joint = joint_of[influence.joint];
    }
    character->influences[v] = std::move(painted.influences[v]);
    (*hints)[v] = 1;
    ++count;
  }
  if (count == 0) throw Error(settings.hints + ": paints no vertex; expected weights (skin lines) for some of them");
}

JointsFrom joints_from(const BindSettings& settings) {
  if (settings.joints == "own") return JointsFrom::kOwn;
  if (settings.joints == "names") return JointsFrom::kNames;
  if (settings.joints == "all") return JointsFrom::kAll;
  return settings.skeleton.empty() ? JointsFrom::kAuto : JointsFrom::kNames;
}

// Joints that the user binds vertices to, by hints and by answers.
std::vector<size_t> joints_said(const Character& character, const std::vector<uint8_t>& hints,
                                const std::vector<sinew_answer>& answers) {
  std::vector<size_t> joints;
  for (const sinew_answer& answer : answers)
    if (answer.kind == SINEW_ANSWER_RIGID) joints.push_back(answer.joint);
  for (size_t v = 0; v < hints.size(); ++v) {
    if (hints[v] == 0) continue;
    for (const Influence& influence : character.influences[v]) joints.push_back(influence.joint);
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

// What every bind of a file has in common, read once: a file is bound again with more answers.
struct BindJob {
  CharacterBindOptions options;
  std::vector<uint8_t> said;  // [J] SINEW_JOINT_* of --joints FILE and --never, or empty
  JointChoice choice;         // before answers take joints back
};

// Puts the rows of the hints into the character.
BindJob make_job(const BindSettings& settings, const Binder& binder, const std::vector<uint8_t>& locked,
                 Character* character) {
  BindJob job;
  job.options.keep_tips = settings.keep_tips;
  job.options.bind_props = settings.bind_props;
  BindOptions& options = job.options.bind;
  options.method = binder.model == nullptr ? binder.method : SINEW_METHOD_MODEL;
  options.model = binder.model;
  options.influence_count = settings.influences;
  options.up_axis = settings.up == "z" ? 1 : 0;
  set_flags(settings, *character, &job.said);
  // Hints are no weights of the file: the choice comes first.
  job.choice = choose_joints(*character, joints_from(settings), job.said);
  options.locked = locked;
  set_hints(settings, character, &options.hints);
  add_hints_like(settings, binder, locked, character, &options.hints);
  options.symmetric = settings.symmetric;
  apply_style(settings.style, &options);
  options.thread_count = settings.threads;
  return job;
}

CharacterBind bind_with(const BindJob& job, const std::vector<sinew_answer>& answers, uint32_t questions, bool progress,
                        const Character& character, JointChoice* choice) {
  CharacterBindOptions character_options = job.options;
  BindOptions& options = character_options.bind;
  options.answers = answers;
  options.question_count = questions;
  *choice = job.choice;
  take_back_joints(joints_said(character, options.hints, answers), job.said, choice);
  for (const sinew_answer& answer : answers) {
    if (answer.kind == SINEW_ANSWER_RIGID && (choice->flags[answer.joint] & SINEW_JOINT_NEVER) != 0)
      throw Error("answer rigid:" + character.joints[answer.joint].name + ": --never, or --joints for other joints, " +
                  "says that this joint gets no weight");
  }
  uint32_t shown = 0;
  if (progress) {
    options.progress = show_progress;
    options.progress_user = &shown;
  }
  ThreadPool pool(options.thread_count);
  options.parallel_for = ThreadPool::parallel_for;
  options.parallel_user = &pool;
  return bind_character(character, *choice, character_options);
}

void draw(const BindSettings& settings, const Character& character, const std::vector<uint8_t>& confidence) {
  RenderOptions view;
  view.up_z = settings.up == "z";
  if (!settings.png.empty()) write_file(settings.png, encode_png(render(character, weight_colours(character), view)));
  if (settings.png_confidence.empty()) return;
  // Red is the least sure vertex of this character: a table of measured hits has few low entries.
  constexpr float kLeastScale = 0.1f;
  std::vector<float> doubt;
  for (const uint8_t c : confidence) doubt.push_back(1.0f - static_cast<float>(c) / 255.0f);
  float largest = kLeastScale;
  for (const float d : doubt) largest = std::max(largest, d);
  write_file(settings.png_confidence, encode_png(render(character, heat_colours(doubt, largest), view)));
}

BindSummary summarise(const BindSettings& settings, const Binder& binder, const Character& character,
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

// "slot: handslot.l, handslot.r; root: root", the reasons in the order of their first joint; --json names every joint.
std::string left_out_text(const Character& character, const JointChoice& choice) {
  constexpr size_t kMostNames = 200;  // of a reason
  std::vector<std::pair<std::string, std::vector<std::string>>> names;
  for (const LeftOutJoint& left : choice.left_out) {
    auto at = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == left.why; });
    if (at == names.end()) at = names.insert(names.end(), {left.why, {}});
    at->second.push_back(character.joints[left.joint].name);
  }
  std::string text;
  for (const auto& [why, joints] : names) {
    text += (text.empty() ? "" : "; ") + why + ": ";
    for (size_t j = 0; j < joints.size() && j < kMostNames; ++j) text += (j == 0 ? "" : ", ") + joints[j];
    if (joints.size() > kMostNames) text += " and " + std::to_string(joints.size() - kMostNames) + " more";
  }
  return text;
}

void add_notes(const Character& character, const JointChoice& choice, const CharacterBind& result,
               BindSummary* summary) {
  std::vector<std::string>& notes = summary->notes;
  for (const LeftOutJoint& left : choice.left_out)
    summary->left_out.emplace_back(character.joints[left.joint].name, left.why);
  if (!choice.left_out.empty())
    notes.push_back(std::to_string(choice.left_out.size()) + " joints get no weight (" +
                    left_out_text(character, choice) + "); --joints all gives it to all");
  if (result.folded_tips > 0)
    notes.push_back(std::to_string(result.folded_tips) +
                    " joints that end chains gave their weight to their parents; --keep-tips keeps it");
  if (result.kept_meshes > 0)
    notes.push_back(std::to_string(result.kept_meshes) + " attached meshes kept as they are; --bind-props binds them");
}

// Warns of a skeleton that lies elsewhere than its mesh, or mends it.
void fit_skeleton(const BindSettings& settings, Character* character) {
  const std::optional<SkeletonFit> fit = find_skeleton_fit(*character);
  if (!fit) return;
  if (settings.fit) {
    apply_skeleton_fit(*fit, &character->joints);
    character->notes.push_back(fit->what + "; --fit has mended that");
  } else {
    character->notes.push_back("warning: " + fit->what + ", so that the weights are hardly right; --fit mends that");
  }
}

// What the file says before it is bound anew.
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

}  // namespace

namespace {

// Answers from the style file, the command line and the terminal, in this order: the later one counts.
struct Answers {
  std::vector<sinew_answer> given;
  size_t by_style = 0;
};

CharacterBind bind_and_ask(const BindSettings& settings, const Binder& binder, const std::vector<uint8_t>& locked,
                           bool progress, Character* character, JointChoice* choice, Answers* answers) {
  std::vector<sinew_answer>& given = answers->given;
  Style style;
  if (!settings.studio_style.empty()) style = read_style(settings.studio_style);
  std::vector<sinew_answer> said;
  for (const std::string& answer : settings.answers) said.push_back(parse_answer(answer, *character));
  const BindJob job = make_job(settings, binder, locked, character);
  const auto bind_again = [&](uint32_t questions) {
    return bind_with(job, given, questions, progress, *character, choice);
  };
  // What there could be answers for, as proposed: what a style is matched with and made of.
  CharacterBind proposed;
  if (!settings.studio_style.empty() || !settings.save_style.empty()) {
    proposed = bind_again(SINEW_MAX_QUESTIONS);
    given = answer_by_style(style, *character, {proposed.questions, proposed.vertex_parts}, choice->flags);
    answers->by_style = given.size();
  }
  given.insert(given.end(), said.begin(), said.end());
  CharacterBind result = bind_again(settings.questions);
  if (settings.ask && !result.questions.empty()) {
    const std::vector<sinew_answer> typed =
        ask(*character, result, stem_of(settings.output), settings.up == "z", std::cin, std::cerr);
    given.insert(given.end(), typed.begin(), typed.end());
    said.insert(said.end(), typed.begin(), typed.end());
    if (!typed.empty()) result = bind_again(settings.questions);
  }
  if (!settings.save_style.empty()) {
    style.sheets.push_back(learn_style(*character, {proposed.questions, proposed.vertex_parts}, said));
    if (style.sheets.back().rules.empty())
      throw Error(settings.save_style +
                  ": there is no answer to keep; give some with --ask or --answer, about parts "
                  "that --questions lists");
    write_style(settings.save_style, style);
  }
  return result;
}

}  // namespace

BoundFile bind_one(const BindSettings& settings, const Binder& binder, bool progress) {
  Character character =
      read_mesh_and_skeleton(settings.mesh, settings.skeleton, !settings.lock.empty() || settings.compare);
  check_bindable(character);  // before anything that takes longer the more joints there are
  const std::vector<uint8_t> locked = read_locks(settings, character);
  const WeightsBefore before = weights_before(settings, character, locked);
  if (const size_t given = infer_parents(&character.joints); given > 0)
    character.notes.push_back(std::to_string(given) +
                              " joints had no parent and got the nearest one along the body; check the hierarchy");
  fit_skeleton(settings, &character);
  JointChoice choice;
  Answers answers;
  CharacterBind result = bind_and_ask(settings, binder, locked, progress, &character, &choice, &answers);
  character.influences = std::move(result.influences);
  if (settings.confidence) character.confidence = result.confidence;
  write_character(settings.output, character);
  draw(settings, character, result.confidence);
  BindSummary summary = summarise(settings, binder, character, result);
  summary.answers = answers.given.size();
  summary.answers_by_style = answers.by_style;
  summary.style = settings.save_style;
  if (!settings.ask) summary.questions = asked_parts(character, result);
  summary.notes.insert(summary.notes.end(), character.notes.begin(), character.notes.end());
  add_notes(character, choice, result, &summary);
  summary.compare = settings.compare;
  summary.replaced = compare_weights(character.joints, before.rows, character.influences, before.kept);
  return {std::move(character), std::move(summary)};
}

}  // namespace sinew::cli
