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
      "Examples:\n  sinew-lab eval weights characters/val --report out.html\n"
      "  sinew-lab eval characters/val --method heat --known --json     # weights may be left out\n"
      "  sinew-lab eval toys --rigid-parts always\n\n"
      "  sinew-lab eval characters/train --against-nearest\n"
      "  sinew-lab eval characters/val --report out.html --with blender=blender_weights\n"
      "  sinew-lab eval characters/val --checkpoint run.ckpt --calibrate characters/train --report bits.html\n"
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
      "Example:\n  sinew-lab eval rig characters/val --predictions skeletons --json\n\n"
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
  sub->footer("Example:\n  sinew-lab eval hands characters/val");
  sub->callback([s] {
    if (!s->output.empty()) check_output(s->output, {".json"});
    evaluate_hands(*s);
  });
}

void add_confidence_study(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("confidence", "How often the strongest joint is right at each confidence");
  struct Settings {
    ConfidenceStudy study;
    std::string model, method = "model";
  };
  auto s = std::make_shared<Settings>();
  add_folder(sub, &s->study.folder, &s->study.jobs);
  shared_option(sub, "--model", s->model)->default_str("bundled");
  shared_option(sub, "--method", s->method, "heat: no model")
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
  CLI::App* sub = parent->add_subcommand("check", "How much damage sinew check finds, and how often it is wrong");
  struct CheckSettings {
    std::string folder;
    unsigned jobs = 1;
    bool names = false;
  };
  auto check = std::make_shared<CheckSettings>();
  add_folder(sub, &check->folder, &check->jobs);
  sub->add_flag("--names", check->names, "Also every miss and every alarm, by the character's name");
  sub->footer(
      "Example:\n  sinew-lab eval check characters/val\n\n"
      "Every character is damaged in some thirty ways, one at a time; a damage is found where a rule that tells\n"
      "it has a finding that the untouched rig has not.");
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
      "Example:\n  sinew-lab eval characters/val\n"
      "sinew-lab eval DIR is sinew-lab eval weights DIR; a folder that is called like a subcommand is ./rig.");
}

}  // namespace sinew::cli
