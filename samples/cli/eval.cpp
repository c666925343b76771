// SPDX-License-Identifier: MIT
// sinew-lab eval: the subcommands together, weights, skeletons, fingers, confidences, findings.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <thread>

#include "commands.hpp"
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
  sub->add_option("dir", *folder, "Folder of FAMILY__NAME.obj + .rig.txt pairs and .glb files, with subfolders")
      ->required()
      ->type_name("DIR");
  add_jobs(sub, *jobs)->capture_default_str();
}

void add_figures(CLI::App* sub, std::string* output, bool* json) {
  shared_option(sub, "-o,--output", *output, "Per-character figures as .json");
  shared_flag(sub, "--json", *json, "All figures instead of the table");
}

void check_weights(const WeightsEvaluation& s) {
  if (!s.model.empty() && !s.checkpoint.empty()) throw UsageError("--model and --checkpoint: give one of the two");
  if (!s.method.empty() && !(s.model.empty() && s.checkpoint.empty()))
    throw UsageError("--method " + s.method + " uses no model: leave out --model and --checkpoint");
  if (!s.report.empty()) check_output(s.report, {".html", ".htm"});
  if (!s.output.empty()) check_output(s.output, {".json"});
  if (!s.joints.empty() && (s.known || !s.checkpoint.empty() || s.method == "nearest"))
    throw UsageError("--joints needs --model or --method heat, without --known");
  if (s.known && !s.checkpoint.empty()) throw UsageError("--known needs --model or --method");
  if (!s.calibrate.empty() && s.checkpoint.empty()) throw UsageError("--calibrate needs --checkpoint");
  if (style_text(s.style).empty()) return;
  if (!s.checkpoint.empty() || s.method == "nearest")
    throw UsageError("--rigid-parts and --softness need --model or --method heat");
  BindOptions options;
  options.method = s.method == "heat" ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  apply_style(s.style, &options);
}

void add_weights(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("weights", "Bind every character and compare with the reference weights");
  auto s = std::make_shared<WeightsEvaluation>();
  add_folder(sub, &s->folder, &s->jobs);
  shared_option(sub, "--model", s->model)->default_str("bundled");
  shared_option(sub, "--method", s->method, "heat: without a model; nearest: each vertex rigid to the nearest bone")
      ->check(CLI::IsMember({"heat", "nearest"}));
  shared_option(sub, "--checkpoint", s->checkpoint, "Instead of a model");
  shared_option(sub, "--joints", s->joints, "As in sinew bind; own: those of the reference, per mesh. By default all")
      ->check(CLI::IsMember({"own", "names", "all"}));
  sub->add_flag("--known", s->known, "Show the binder which joints have reference weight");
  add_influences(sub, s->influences);
  shared_option(sub, "--report", s->report,
                "Plots and characters, with heat and nearest bone for comparison; with --checkpoint also int16, 12, 10 "
                "and 8 bits against float");
  add_figures(sub, &s->output, &s->json);
  sub->add_option("--save-predictions", s->predictions, "Folder for NAME.rig.txt of each character and status.json")
      ->type_name("DIR");
  sub->add_option("--with", s->peers,
                  "Add a column with the predictions of another binder, DIR/NAME.rig.txt per character")
      ->type_name("NAME=DIR");
  sub->add_flag("--against-nearest", s->against_nearest, "List the characters on which nearest bone is better");
  shared_option(sub, "--label", s->label);
  add_style_options(sub, &s->style);
  section(sub, "Other options");
  shared_option(sub, "--calibrate", s->calibrate, "With --checkpoint --report; by default those of DIR");
  sub->footer(
      "Examples:\n  sinew-lab eval weights characters/val --report out.html\n  sinew-lab eval characters/val --method "
      "heat --known --json     # weights may be left out\n  sinew-lab eval toys --rigid-parts always\n\n  sinew-lab "
      "eval characters/train --against-nearest\n  sinew-lab eval characters/val --report out.html --with "
      "blender=blender_weights\n  sinew-lab eval characters/val --checkpoint run.ckpt --calibrate characters/train "
      "--report bits.html\nSOURCE_DATE_EPOCH sets the date of the report; without it the same inputs give the same "
      "page.");
  sub->callback([s] {
    check_weights(*s);
    evaluate_weights(*s);
  });
}

void run_rig(RigEvaluation s) {
  if (!s.method.empty() && !s.predictions.empty()) throw UsageError("--predictions and --method: give one of the two");
  if (!s.predictions.empty() && !s.model.empty()) throw UsageError("--predictions and --model: give one of the two");
  if (!s.checkpoint.empty() && (!s.predictions.empty() || (!s.method.empty() && s.method != "votes")))
    throw UsageError("--checkpoint is compared with the model made from it: leave out --predictions and --method");
  if (!s.output.empty()) check_output(s.output, {".json"});
  if (!s.report.empty()) {
    check_output(s.report, {".html", ".htm"});
    std::string command = "sinew-lab eval rig " + s.folder;
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
  CLI::App* sub = parent->add_subcommand("rig", "Predict or read skeletons and compare with the reference");
  auto s = std::make_shared<RigEvaluation>();
  add_folder(sub, &s->folder, &s->jobs);
  shared_option(sub, "--model", s->model, "It predicts skeletons")->default_str("bundled");
  shared_option(sub, "--method", s->method,
                "shape and regions: without a model; slots: the published method, with its own model; by default votes")
      ->check(CLI::IsMember({"votes", "shape", "regions", "slots"}));
  shared_option(sub, "--checkpoint", s->checkpoint, "Compare with the model made from it");
  sub->add_option("--predictions", s->predictions, "Folder with the predicted NAME.rig.txt of each character")
      ->type_name("DIR");
  sub->add_flag("--bind", s->bind,
                "Also bind each mesh to its predicted skeleton. Prints how much of the surface moves with a joint of "
                "the reference's class and side");
  shared_option(sub, "--report", s->report, "Each skeleton next to its reference");
  add_figures(sub, &s->output, &s->json);
  sub->footer(
      "Example:\n  sinew-lab eval rig characters/val --predictions skeletons --json\n\nA predicted joint is compared "
      "by its position, its parent and the class of its name (upperarm.L,\nmixamorig:LeftArm); a leaf called NAME_end "
      "or NAME_tip is a bone end. The reference is the output of sinew-lab\ndataset target. Lengths are shares of the "
      "mesh's longest side; J2J, J2B, B2B: between joints,\njoints and bones, bones; precision, recall, IoU: joints in "
      "pairs at most 0.05 apart; joined: bones\nbetween pairs that the prediction has too; class: pairs of one class; "
      "symmetric: skeletons that are\ntheir own mirror image.");
  sub->callback([s] { run_rig(*s); });
}

void add_hands_study(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("hands", "Predict fingers and compare with the reference");
  auto s = std::make_shared<HandsEvaluation>();
  add_folder(sub, &s->folder, &s->jobs);
  shared_option(sub, "--model", s->model, "It predicts hands; bodies come from the bundled model")
      ->default_str("bundled");
  add_figures(sub, &s->output, &s->json);
  sub->footer("Example:\n  sinew-lab eval hands characters/val");
  sub->callback([s] {
    if (!s->output.empty()) check_output(s->output, {".json"});
    evaluate_hands(*s);
  });
}

void add_confidence_study(CLI::App* parent) {
  CLI::App* sub =
      parent->add_subcommand("confidence", "Measure how often the strongest joint is right at each confidence");
  struct Settings {
    ConfidenceStudy study;
    std::string model, method = "model";
  };
  auto s = std::make_shared<Settings>();
  add_folder(sub, &s->study.folder, &s->study.jobs);
  shared_option(sub, "--model", s->model)->default_str("bundled");
  shared_option(sub, "--method", s->method, "heat: without a model")
      ->check(CLI::IsMember({"model", "heat"}))
      ->capture_default_str();
  add_influences(sub, s->study.influences);
  sub->footer("Example:\n  sinew-lab eval confidence characters/val");
  sub->callback([s] {
    if (s->method == "heat" && !s->model.empty()) throw UsageError("--method heat uses no model: leave out --model");
    const std::unique_ptr<LoadedModel> model = s->method == "heat" ? nullptr : load_model(s->model);
    ConfidenceStudy study = s->study;
    study.model = model ? &model->model : nullptr;
    study_confidence(study);
  });
}

void add_check_study(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("check", "Measure how much damage sinew check finds, and its false alarms");
  struct CheckSettings {
    std::string folder;
    unsigned jobs = 1;
    bool names = false;
  };
  auto check = std::make_shared<CheckSettings>();
  add_folder(sub, &check->folder, &check->jobs);
  sub->add_flag("--names", check->names, "List every miss and every false alarm, by character");
  sub->footer(
      "Example:\n  sinew-lab eval check characters/val\n\nEach character is damaged in some thirty ways, one at a "
      "time. A damage is found if a rule for it reports a\nfinding that the untouched rig does not have.");
  sub->callback([check] { study_check(check->folder, check->jobs, check->names); });
}

}  // namespace

void add_eval(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("eval", "Measure weights, skeletons and findings on a folder");
  sub->require_subcommand(1);
  add_weights(sub);
  add_rig_study(sub);
  add_hands_study(sub);
  add_confidence_study(sub);
  add_check_study(sub);
  sub->footer(
      "Example:\n  sinew-lab eval characters/val\nsinew-lab eval DIR is sinew-lab eval weights DIR; write a folder "
      "named like a subcommand as ./rig.");
}

}  // namespace sinew::cli
