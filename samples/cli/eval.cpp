// SPDX-License-Identifier: MIT
// sinew eval: the subcommands together, weights, skeletons, fingers and studies.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include "commands.hpp"
#include "eval_check.hpp"
#include "eval_hands.hpp"
#include "eval_rig.hpp"
#include "eval_stability.hpp"
#include "eval_studies.hpp"
#include "eval_weights.hpp"
#include "options.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// The folder and the options that every subcommand has.
void add_folder(CLI::App* sub, std::string* folder, unsigned* jobs) {
  *jobs = std::max(1u, std::thread::hardware_concurrency());
  sub->add_option("dir", *folder, "Folder of FAMILY__NAME.obj + .rig.txt pairs and .glb files, sub-folders too")
      ->required()
      ->type_name("DIR");
  add_jobs(sub, *jobs)->capture_default_str();
}

void add_figures(CLI::App* sub, std::string* output, bool* json) {
  shared_option(sub, "-o,--output", *output, "All figures as .json");
  shared_flag(sub, "--json", *json, "All figures, in place of the table");
}

void check_weights(const WeightsEvaluation& s) {
  if (!s.model.empty() && !s.checkpoint.empty()) throw UsageError("--model and --checkpoint: give one of the two");
  if (!s.method.empty() && !(s.model.empty() && s.checkpoint.empty()))
    throw UsageError("--method " + s.method + " needs neither --model nor --checkpoint");
  if (!s.report.empty()) check_output(s.report, {".html", ".htm"});
  if (!s.output.empty()) check_output(s.output, {".json"});
  if (!s.joints.empty() && (s.known || !s.checkpoint.empty() || s.method == "nearest"))
    throw UsageError("--joints works with --model and --method heat only, and without --known");
  if (s.known && !s.checkpoint.empty()) throw UsageError("--known works with --model and --method only");
  if (!s.calibrate.empty() && s.checkpoint.empty()) throw UsageError("--calibrate belongs to --checkpoint");
  if (style_text(s.style).empty()) return;
  if (!s.checkpoint.empty() || s.method == "nearest")
    throw UsageError("--rigid-parts and --softness work with --model and --method heat only");
  BindOptions options;
  options.method = s.method == "heat" ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  apply_style(s.style, &options);
}

void add_weights(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("weights", "Bind every character, compare with the reference's weights");
  auto s = std::make_shared<WeightsEvaluation>();
  add_folder(sub, &s->folder, &s->jobs);
  shared_option(sub, "--model", s->model)->default_str("bundled");
  shared_option(sub, "--method", s->method, "heat: no model; nearest: every vertex rigid to the nearest bone")
      ->check(CLI::IsMember({"heat", "nearest"}));
  shared_option(sub, "--checkpoint", s->checkpoint, "In place of a model");
  shared_option(sub, "--joints", s->joints,
                "As in sinew bind, own are those of the reference, mesh by mesh; all unless "
                "given")
      ->check(CLI::IsMember({"own", "names", "all"}));
  sub->add_flag("--known", s->known, "Tell the binder which joints have reference weight");
  add_influences(sub, s->influences);
  shared_option(sub, "--report", s->report,
                "Plots and characters, heat and nearest bone beside; with --checkpoint also int16, 12, 10 and 8 bits "
                "against float");
  add_figures(sub, &s->output, &s->json);
  sub->add_option("--save-predictions", s->predictions, "Folder for NAME.rig.txt of every character and status.json")
      ->type_name("DIR");
  sub->add_option("--with", s->peers, "Another binder's predictions, DIR/NAME.rig.txt of every character, as a column")
      ->type_name("NAME=DIR");
  sub->add_flag("--against-nearest", s->against_nearest, "List the characters on which nearest bone is better");
  shared_option(sub, "--label", s->label);
  add_style_options(sub, &s->style);
  section(sub, "The rest");
  shared_option(sub, "--calibrate", s->calibrate, "With --checkpoint --report; those of DIR unless given");
  sub->footer(
      "Examples:\n  sinew eval weights characters/val --report out.html\n"
      "  sinew eval characters/val --method heat --known --json     # weights may be left out\n"
      "  sinew eval toys --rigid-parts always\n\n"
      "  sinew eval characters/train --against-nearest\n"
      "  sinew eval characters/val --report out.html --with blender=blender_weights\n"
      "  sinew eval characters/val --checkpoint run.ckpt --calibrate characters/train --report bits.html\n"
      "SOURCE_DATE_EPOCH puts its date on the report; without it the same inputs give the same page.");
  sub->callback([s] {
    check_weights(*s);
    evaluate_weights(*s);
  });
}

void run_rig(RigEvaluation s) {
  if (!s.method.empty() && !s.predictions.empty()) throw UsageError("--predictions and --method: give one of the two");
  if (!s.predictions.empty() && !s.model.empty()) throw UsageError("--predictions and --model: give one of the two");
  if (!s.checkpoint.empty() && (!s.predictions.empty() || (!s.method.empty() && s.method != "votes")))
    throw UsageError(
        "--checkpoint is measured beside the model that was made of it: leave out --predictions and --method");
  if (!s.output.empty()) check_output(s.output, {".json"});
  if (!s.report.empty()) {
    check_output(s.report, {".html", ".htm"});
    std::string command = "sinew eval rig " + s.folder;
    if (!s.method.empty()) command += " --method " + s.method;
    if (!s.model.empty()) command += " --model " + s.model;
    if (!s.predictions.empty()) command += " --predictions " + s.predictions;
    s.facts = {{"command", command + " --report " + s.report}, {"sinew", sinew_version()}};
    if (s.predictions.empty() && (s.method.empty() || s.method == "votes")) {
      const std::unique_ptr<LoadedModel> model = load_model(s.model, ModelUse::kRig);
      s.facts.emplace_back("model", model_label(s.model) + print(", checksum %08x", model->model.checksum));
    }
    const std::string date = report_date();
    if (!date.empty()) s.facts.emplace_back("date", date);
  }
  evaluate_rigs(s);
}

void add_rig_study(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("rig", "Predict skeletons, or read them, and compare with the reference's");
  auto s = std::make_shared<RigEvaluation>();
  add_folder(sub, &s->folder, &s->jobs);
  shared_option(sub, "--model", s->model, "Of skeletons")->default_str("bundled");
  shared_option(sub, "--method", s->method,
                "shape and regions need no model; slots: the published method, by its own model; votes unless given")
      ->check(CLI::IsMember({"votes", "shape", "regions", "slots"}));
  shared_option(sub, "--checkpoint", s->checkpoint, "Measured beside the model that was made of it");
  sub->add_option("--predictions", s->predictions, "Folder to read the predicted NAME.rig.txt of every character from")
      ->type_name("DIR");
  sub->add_flag(
      "--bind", s->bind,
      "Bind every mesh to its predicted skeleton too. Prints how much of the surface moves with a joint of the "
      "reference's class and side");
  shared_option(sub, "--report", s->report, "Every character's skeleton beside the reference");
  add_figures(sub, &s->output, &s->json);
  sub->footer(
      "Example:\n  sinew eval rig characters/val --predictions skeletons --json\n\n"
      "A predicted joint counts by its place, its parent and the class that its name says (upperarm.L,\n"
      "mixamorig:LeftArm); a leaf called NAME_end or NAME_tip is a bone end. The reference is what sinew\n"
      "dataset target writes. Lengths are shares of the mesh's longest side; J2J, J2B, B2B: between joints,\n"
      "joints and bones, bones; precision, recall, IoU: joints in pairs at most 0.05 apart; joined: bones\n"
      "between pairs that the prediction has too; class: pairs of one class; symmetric: skeletons that are\n"
      "their own mirror image.");
  sub->callback([s] { run_rig(*s); });
}

void add_hands_study(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("hands", "Predict fingers and compare with the reference's");
  auto s = std::make_shared<HandsEvaluation>();
  add_folder(sub, &s->folder, &s->jobs);
  shared_option(sub, "--model", s->model, "Of hands; bodies are the bundled model's")->default_str("bundled");
  add_figures(sub, &s->output, &s->json);
  sub->footer("Example:\n  sinew eval hands characters/val");
  sub->callback([s] {
    if (!s->output.empty()) check_output(s->output, {".json"});
    evaluate_hands(*s);
  });
}

// A study that binds with a model or by heat alone.
struct StudySettings {
  Study study;
  std::string model, method = "model", give = "random:5";
  unsigned questions = 3;
};

std::shared_ptr<StudySettings> add_study(CLI::App* sub, const std::string& name) {
  auto s = std::make_shared<StudySettings>();
  add_folder(sub, &s->study.folder, &s->study.jobs);
  shared_option(sub, "--model", s->model)->default_str("bundled");
  shared_option(sub, "--method", s->method, "heat: no model")
      ->check(CLI::IsMember({"model", "heat"}))
      ->capture_default_str();
  add_influences(sub, s->study.influences);
  sub->footer("Example:\n  sinew eval " + name + " characters/val");
  return s;
}

template <class Body>
void run_study(const StudySettings& s, const Body& body) {
  if (s.method == "heat" && !s.model.empty()) throw UsageError("--method heat uses no model: leave out --model");
  const std::unique_ptr<LoadedModel> model = s.method == "heat" ? nullptr : load_model(s.model);
  Study study = s.study;
  study.model = model ? &model->model : nullptr;
  body(study);
}

// KIND:PERCENT
void run_hints(const StudySettings& s) {
  const size_t colon = s.give.find(':');
  const std::string kind = s.give.substr(0, colon);
  char* end = nullptr;
  const double percent = colon == std::string::npos ? 0 : std::strtod(s.give.c_str() + colon + 1, &end);
  if ((kind != "random" && kind != "patch") || end == nullptr || *end != 0 || !(percent > 0 && percent <= 100))
    throw UsageError("--give " + s.give + ": expected random:PERCENT or patch:PERCENT, for example random:5");
  run_study(s, [&](const Study& study) { study_hints(study, kind, percent / 100); });
}

void add_studies(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("confidence", "How often the strongest joint is right at each confidence");
  const auto confidence = add_study(sub, "confidence");
  sub->callback([confidence] { run_study(*confidence, study_confidence); });

  sub = parent->add_subcommand("hints", "What weights of some vertices gain the others");
  const auto hints = add_study(sub, "hints");
  sub->add_option("--give", hints->give,
                  "Which share of the vertices is given. Single ones anywhere (random:PERCENT) or one region "
                  "(patch:PERCENT)")
      ->type_name("KIND:PERCENT")
      ->capture_default_str();
  sub->callback([hints] { run_hints(*hints); });

  const auto add_questions = [](CLI::App* to, StudySettings* s) {
    shared_option(to, "--questions", s->questions, "Of every character; the reference answers them")
        ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_QUESTIONS)))
        ->capture_default_str();
  };
  sub = parent->add_subcommand("questions", "What answers of an artist gain a character");
  const auto questions = add_study(sub, "questions");
  add_questions(sub, questions.get());
  sub->callback([questions] {
    run_study(*questions, [&](const Study& study) { study_questions(study, questions->questions); });
  });

  sub = parent->add_subcommand("style", "What answers about each family's first character gain the others");
  const auto style = add_study(sub, "style");
  add_questions(sub, style.get());
  sub->callback([style] { run_study(*style, [&](const Study& study) { study_style(study, style->questions); }); });

  sub = parent->add_subcommand("robustness", "How far weights move when the character is changed");
  const auto robustness = add_study(sub, "robustness");
  sub->footer(
      "Example:\n  sinew eval robustness characters/val\n\n"
      "It is moved, scaled, rotated, mirrored, renumbered, unwelded, its faces split or merged, decimated,\n"
      "subdivided.");
  sub->callback([robustness] { run_study(*robustness, study_robustness); });

  sub = parent->add_subcommand("check", "How much damage sinew check finds, and how often it is wrong");
  struct CheckSettings {
    std::string folder;
    unsigned jobs = 1;
    bool names = false;
  };
  auto check = std::make_shared<CheckSettings>();
  add_folder(sub, &check->folder, &check->jobs);
  sub->add_flag("--names", check->names, "Also every miss and every alarm, by the character's name");
  sub->footer(
      "Example:\n  sinew eval check characters/val\n\n"
      "Every character is damaged in some thirty ways, one at a time; a damage is found where a rule that tells\n"
      "it has a finding that the untouched rig has not.");
  sub->callback([check] { study_check(check->folder, check->jobs, check->names); });

  sub = parent->add_subcommand("seams", "How much weight crosses where parts of the body have grown together");
  const auto seams = add_study(sub, "seams");
  sub->footer(
      "Example:\n  sinew eval seams characters/val\n\n"
      "Parts are apart that are far from each other along the skeleton and near in space; true seams are\n"
      "edges between parts by the reference's weights, and what counts is the surface within 5 % of the\n"
      "longest side around them.");
  sub->callback([seams] { run_study(*seams, study_seams); });
}

void add_stability(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("stability", "How far skeletons and weights move when a character is posed");
  const auto s = add_study(sub, "stability");
  auto own = std::make_shared<StabilitySettings>();
  sub->add_option("--per-character", own->poses, "Random poses of every character")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  add_figures(sub, &own->output, &own->json);
  sub->footer(
      "Example:\n  sinew eval stability characters/val\n\n"
      "The reference's weights pose it; every pose is rigged with the bundled model of skeletons and bound.\n"
      "Spread: J2J between joints carried back to rest and those of the mesh at rest, in shares of its longest\n"
      "side. Flips: vertices whose strongest joint is another one, of skeletons found anew and of the\n"
      "reference's own, which moves along.");
  sub->callback([s, own] {
    if (!own->output.empty()) check_output(own->output, {".json"});
    run_study(*s, [&](const Study& study) { study_stability(study, *own); });
  });
}

}  // namespace

void add_eval(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("eval", "Measure weights, skeletons and what artists say on a folder");
  sub->require_subcommand(1);
  add_weights(sub);
  add_rig_study(sub);
  add_hands_study(sub);
  add_studies(sub);
  add_stability(sub);
  sub->footer(
      "Example:\n  sinew eval characters/val\n"
      "sinew eval DIR is sinew eval weights DIR; a folder that is called like a subcommand is ./rig.");
}

}  // namespace sinew::cli
