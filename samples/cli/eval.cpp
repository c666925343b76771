// SPDX-License-Identifier: MIT
// sinew eval: binds every character of a folder and compares the weights with the reference; the accuracy report.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "commands.hpp"
#include "dataset.hpp"
#include "eval_hands.hpp"
#include "eval_rig.hpp"
#include "eval_studies.hpp"
#include "model/layout.hpp"
#include "progress.hpp"
#include "sinew_character/bind_character.hpp"
#include "sinew_character/skeleton_repair.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_quant/quantize.hpp"
#include "sinew_trainer/bend_pictures.hpp"
#include "sinew_trainer/calibrate.hpp"
#include "sinew_trainer/engine_logits.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/garment_pictures.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/parallel.hpp"
#include "sinew_trainer/reliability_plot.hpp"
#include "sinew_trainer/report.hpp"
#include "sinew_trainer/weight_difference.hpp"
#include "style_options.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

constexpr const char* kNearest = "nearest bone";

using Rows = std::vector<std::vector<Influence>>;

struct Settings {
  std::string task = "bind", folder, model, checkpoint, method, predictions, report, json, calibrate, label, hints;
  std::string joints;
  std::vector<std::string> peers;  // NAME=DIR
  StyleOptions style;              // of what is evaluated, not of heat beside it
  unsigned influences = 4, jobs = 1, questions = 0;
  bool first_as_style = false;  // of each family, with `questions`
  bool bind = false, known = false, against_nearest = false, confidence = false, robustness = false;
};

struct Prediction {
  Rows rows;
  double seconds = 0;
  std::vector<float> logits;        // for signal to noise; empty when not known
  std::vector<uint8_t> confidence;  // [V]; empty when the binder tells none
};

// One way of binding. `sample` is null unless some variant asks for it.
struct Variant {
  std::string label;
  int bits = 0;
  size_t size_bytes = 0;
  std::string confidence = "the largest weight of a vertex";
  uint32_t candidates = 0, grid = 0, feature_set = 0;  // of the sample it needs; 0 = none
  std::function<Prediction(const Character&, const Sample*)> predict;
  std::vector<std::pair<std::string, Metrics>> figures;
  std::map<std::string, std::vector<double>> pose_distances;
  LogitNoise noise;
  WeightDifference difference;  // from the first variant
};

std::vector<uint8_t> known_joints(const Character& character) {
  std::vector<uint8_t> flags(character.joints.size(), 0);
  for (const auto& row : character.influences) {
    for (const Influence& i : row) {
      if (i.weight > 0) flags[i.joint] = SINEW_JOINT_DEFORMS;
    }
  }
  return flags;
}

Prediction bind_with(const Settings& s, const sinew_model* model, const Character& character) {
  BindOptions options;
  options.method = model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  options.model = model;
  options.influence_count = s.influences;
  if (s.known) options.joint_flags = known_joints(character);
  if (model != nullptr || s.method == "heat") apply_style(s.style, &options);
  if (s.joints.empty() || s.joints == "all") {
    BindResult result = bind(character, options);
    return {std::move(result.influences), result.seconds, {}, std::move(result.confidence)};
  }
  Character whole_body = character;
  (void)infer_parents(&whole_body.joints);
  const JointChoice choice =
      choose_joints(whole_body, s.joints == "own" ? JointsFrom::kOwn : JointsFrom::kNames, options.joint_flags);
  CharacterBindOptions whole;
  whole.bind = options;
  CharacterBind result = bind_character(whole_body, choice, whole);
  return {std::move(result.influences), result.seconds, {}, std::move(result.confidence)};
}

Variant heat_variant(const Settings& s) {
  Variant variant;
  variant.label = "heat";
  variant.predict = [&s](const Character& c, const Sample*) { return bind_with(s, nullptr, c); };
  return variant;
}

Variant nearest_variant(const Settings& s) {
  Variant variant;
  variant.label = kNearest;
  variant.predict = [&s](const Character& c, const Sample*) {
    return Prediction{nearest_bone(c, s.known ? known_joints(c) : std::vector<uint8_t>{}), 0, {}, {}};
  };
  return variant;
}

// Predictions that lie in a folder as NAME.rig.txt, made by another binder or an earlier run.
Variant peer_variant(const std::string& name_and_folder) {
  const size_t at = name_and_folder.find('=');
  if (at == 0 || at == std::string::npos || at + 1 == name_and_folder.size())
    throw UsageError("--with " + name_and_folder + ": expected NAME=DIR");
  Variant variant;
  variant.label = name_and_folder.substr(0, at);
  variant.predict = [folder = name_and_folder.substr(at + 1)](const Character& c, const Sample*) {
    const std::string path = (std::filesystem::path(folder) / (c.name + ".rig.txt")).string();
    Character predicted = c;
    predicted.joints.clear();
    predicted.influences.clear();
    read_skeleton(path, true, &predicted);
    // The joints by name: another tool may have written them in another order.
    std::map<std::string, uint32_t> index;
    for (uint32_t j = 0; j < c.joints.size(); ++j) index.emplace(c.joints[j].name, j);
    Prediction prediction;
    for (auto& row : predicted.influences) {
      prediction.rows.emplace_back();
      for (const Influence& i : row) {
        const auto found = index.find(predicted.joints[i.joint].name);
        if (found == index.end())
          throw Error(path + ": binds to the joint " + predicted.joints[i.joint].name + ", which the character lacks");
        prediction.rows.back().push_back({found->second, i.weight});
      }
    }
    return prediction;
  };
  return variant;
}

Variant model_variant(const Settings& s, const std::string& label, std::shared_ptr<LoadedModel> model) {
  Variant variant;
  variant.label = label;
  variant.bits = 16;
  variant.size_bytes = model->model.size_bytes;
  if (model->model.confidence_count > 0) variant.confidence = "the strongest joint's share through the model's table";
  variant.predict = [&s, model](const Character& c, const Sample*) { return bind_with(s, &model->model, c); };
  return variant;
}

// The float network first; with a report also the same network in integers, at fewer and fewer bits.
std::vector<Variant> checkpoint_variants(const Settings& s) {
  auto checkpoint = std::make_shared<Checkpoint>(read_checkpoint(s.checkpoint));
  const FloatNetwork& network = checkpoint->network;
  std::vector<Variant> variants(1);
  variants[0].label = s.label.empty() ? "float checkpoint" : s.label;
  variants[0].bits = 32;
  variants[0].candidates = network.candidate_count;
  variants[0].grid = network.grid_size;
  variants[0].feature_set = network.feature_set;
  for (const LinearParameters& p : network.parameters) variants[0].size_bytes += 4 * (p.weights.size() + p.bias.size());
  variants[0].predict = [&s, checkpoint](const Character&, const Sample* sample) {
    Prediction prediction;
    prediction.logits = forward(checkpoint->network, *sample);
    prediction.rows = sample_influences(*sample, softmax(*sample, prediction.logits), s.influences);
    return prediction;
  };
  if (s.report.empty()) return variants;
  const std::string calibrate_on = s.calibrate.empty() ? s.folder : s.calibrate;
  const Calibration calibration = calibrate(
      network, calibration_samples(calibrate_on, 40, network.candidate_count, network.grid_size, network.feature_set));
  for (int bits : {16, 12, 10, 8}) {
    QuantizeOptions options;
    options.weight_bits = bits;
    options.activation_bits = std::min(bits, options.activation_bits);
    const QuantizedModel quantised = quantize(network, calibration, options);
    std::shared_ptr<LoadedModel> model = model_from_bytes(quantised.bytes, "the quantised network");
    Variant variant;
    variant.label = bits == 16 ? "int16 model" : std::to_string(bits) + " bits";
    variant.bits = bits;
    // The file format keeps 16 bits; fewer are counted as if weights were packed.
    variant.size_bytes =
        quantised.bytes.size() - static_cast<size_t>(model->model.parameter_count) * static_cast<size_t>(16 - bits) / 8;
    variant.candidates = network.candidate_count;
    variant.grid = network.grid_size;
    variant.feature_set = network.feature_set;
    // int16 goes the product's whole way; the narrower ones only differ in the network, so features are not computed
    // again.
    variant.predict = [&s, model, bits](const Character& c, const Sample* sample) {
      Prediction prediction;
      if (bits == 16) prediction = bind_with(s, &model->model, c);
      prediction.logits = engine_logits(model->model, *sample);
      if (bits != 16) prediction.rows = sample_influences(*sample, softmax(*sample, prediction.logits), s.influences);
      return prediction;
    };
    variants.push_back(std::move(variant));
  }
  return variants;
}

std::vector<Variant> make_variants(const Settings& s) {
  std::vector<Variant> variants;
  if (!s.checkpoint.empty()) {
    variants = checkpoint_variants(s);
  } else if (!s.method.empty()) {
    variants.push_back(s.method == "heat" ? heat_variant(s) : nearest_variant(s));
    variants[0].label = s.label.empty() ? s.method : s.label;
  } else {
    const std::string label = !s.label.empty() ? s.label : model_label(s.model);
    variants.push_back(model_variant(s, label, load_model(s.model)));
  }
  if (!s.report.empty() && s.method != "heat") variants.push_back(heat_variant(s));
  for (const std::string& peer : s.peers) variants.push_back(peer_variant(peer));
  if (s.method != "nearest" && (s.against_nearest || !s.report.empty())) variants.push_back(nearest_variant(s));
  return variants;
}

// The command as it would be typed, without what does not change the numbers.
std::string command_line(const Settings& s) {
  std::string line = "sinew eval " + s.folder;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) line += std::string(" ") + option + " " + value;
  };
  add("--model", s.model);
  add("--checkpoint", s.checkpoint);
  add("--method", s.method);
  add("--calibrate", s.calibrate);
  if (s.influences != 4) add("--influences", std::to_string(s.influences));
  if (s.known) line += " --known";
  add("--joints", s.joints);
  line += style_text(s.style);
  for (const std::string& peer : s.peers) add("--with", peer);
  add("--report", s.report);
  return line;
}

// Only what the caller passes: a page with the clock in it would differ every time.
std::string build_date() {
  const char* const text = std::getenv("SOURCE_DATE_EPOCH");
  if (text == nullptr || *text == 0) return "";
  char* end = nullptr;
  const long long seconds = std::strtoll(text, &end, 10);
  if (*end != 0 || seconds < 0)
    throw Error(std::string("SOURCE_DATE_EPOCH: expected seconds since 1970, found ") + text);
  const std::time_t when = static_cast<std::time_t>(seconds);
  std::tm parts{};
  if (gmtime_r(&when, &parts) == nullptr) throw Error(std::string("SOURCE_DATE_EPOCH: out of range: ") + text);
  char date[64];
  std::strftime(date, sizeof date, "%Y-%m-%d", &parts);
  return date;
}

class Evaluation {
 public:
  explicit Evaluation(const Settings& s) : s_(s), found_(characters_in(s.folder)), variants_(make_variants(s)) {
    main_ = 0;
    for (size_t i = 0; i < variants_.size(); ++i) {
      if (variants_[i].label == "int16 model") main_ = i;  // the report shows what ships
    }
  }

  void run() {
    if (!s_.predictions.empty()) std::filesystem::create_directories(s_.predictions);
    bind_all();
    finish();
  }

 private:
  void bind_all() {
    Progress progress(found_.size(), "characters");
    parallel_for(found_.size(), s_.jobs, [&](size_t i, unsigned) {
      try {
        one(found_[i]);
      } catch (const Error& error) {
        const std::lock_guard<std::mutex> guard(lock_);
        failures_[found_[i].name] = error.what();
      }
      progress.step();
    });
  }

  void one(const FoundCharacter& found) {
    const Character character = read_found(found);
    const std::string& name = found.name;
    if (character.influences.empty()) throw Error(found.path + ": has no reference weights to compare with");
    std::unique_ptr<Sample> sample;
    double sample_seconds = 0;
    for (const Variant& variant : variants_) {
      if (variant.candidates == 0 || sample) continue;
      const auto start = std::chrono::steady_clock::now();
      sample = std::make_unique<Sample>(make_sample(character, variant.candidates, variant.grid, variant.feature_set));
      sample_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    std::vector<Prediction> predictions;
    std::vector<Metrics> metrics;
    std::vector<std::vector<double>> poses(variants_.size());
    for (const Variant& variant : variants_) {
      const auto start = std::chrono::steady_clock::now();
      predictions.push_back(variant.predict(character, sample.get()));
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (predictions.back().seconds == 0) predictions.back().seconds = seconds + sample_seconds;
      metrics.push_back(measure(character, predictions.back().rows, name, 10, nullptr, &poses[metrics.size()]));
      metrics.back().seconds = predictions.back().seconds;
    }
    if (!s_.predictions.empty()) {
      Character predicted = character;
      predicted.influences = predictions[0].rows;
      const std::filesystem::path path = std::filesystem::path(s_.predictions) / (name + ".rig.txt");
      make_folder(path.parent_path().string());
      write_rig(path.string(), predicted);
    }
    const Prediction& main = predictions[main_];
    JudgedConfidence judged;
    Clothing clothing;
    if (!s_.report.empty()) {
      judged =
          judge_confidence(character, main.rows, main.confidence.empty() ? top_weights(main.rows) : main.confidence);
      clothing = measure_clothing(character);
    }
    const std::lock_guard<std::mutex> guard(lock_);
    for (size_t i = 0; i < variants_.size(); ++i) {
      Variant& variant = variants_[i];
      variant.figures.emplace_back(name, metrics[i]);
      variant.pose_distances[name] = std::move(poses[i]);
      if (i > 0 && variant.bits > 0) variant.difference.add(predictions[0].rows, predictions[i].rows);
      if (i > 0 && !predictions[i].logits.empty())
        variant.noise.add(*sample, predictions[0].logits, predictions[i].logits);
    }
    if (s_.report.empty()) return;
    // Kept by name: sums of doubles must not depend on which thread was first.
    confidence_[name] = judged;
    if (clothing.bends > 0) dressed_[name] = clothing;
    drawn_[name] = {found.path, std::move(predictions[main_].rows)};
  }

  void finish() {
    std::vector<Scores> scores;
    for (Variant& variant : variants_) {
      std::sort(variant.figures.begin(), variant.figures.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      scores.push_back(summarise(variant.figures));
      scores.back().failures = failures_;
    }
    if (!s_.predictions.empty()) write_status();
    if (!variants_[0].figures.empty()) {
      if (s_.json != "-") {
        for (size_t i = 0; i < variants_.size(); ++i)
          std::printf("%s\n", scores_markdown(variants_[i].label, scores[i]).c_str());
        print_beaten(scores);
      }
      if (!s_.report.empty()) write_report(scores);
    }
    if (!s_.json.empty()) write_json(scores);
    if (!failures_.empty()) {
      throw Error(print("%zu of %zu characters failed; the first: ", failures_.size(), found_.size()) +
                  failures_.begin()->first + ": " + failures_.begin()->second);
    }
  }

  std::optional<std::vector<std::pair<std::string, double>>> beaten(const std::vector<Scores>& scores) const {
    for (size_t i = 0; i < variants_.size(); ++i)
      if (i != main_ && variants_[i].label == kNearest) return beaten_by(scores[main_], scores[i]);
    return std::nullopt;
  }

  void print_beaten(const std::vector<Scores>& scores) const {
    const auto list = beaten(scores);
    if (!list) return;
    std::printf("nearest bone is better than %s on %zu of %zu characters%s\n", variants_[main_].label.c_str(),
                list->size(), scores[main_].characters.size(), list->empty() ? "" : " (L1 above it):");
    for (const auto& [name, loss] : *list) std::printf("  %s %.4f\n", name.c_str(), loss);
    std::printf("\n");
  }

  void write_status() const {
    nlohmann::ordered_json status = nlohmann::ordered_json::object();
    for (const auto& [name, metrics] : variants_[0].figures) {
      status[name] = {{"seconds", metrics.seconds}, {"ok", true}, {"note", ""}};
    }
    for (const auto& [name, note] : failures_) status[name] = {{"seconds", 0.0}, {"ok", false}, {"note", note}};
    write_text_file((std::filesystem::path(s_.predictions) / "status.json").string(),
                    status.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }

  void write_json(const std::vector<Scores>& scores) const {
    nlohmann::ordered_json whole = nlohmann::ordered_json::parse(scores_json(variants_[0].label, scores[0]));
    for (size_t i = 1; i < variants_.size(); ++i) {
      whole.update(nlohmann::ordered_json::parse(scores_json(variants_[i].label, scores[i])));
    }
    write_text_file(s_.json, whole.dump(1) + "\n");
  }

  void write_report(const std::vector<Scores>& scores) {
    ReportData data;
    data.summary = print("%zu characters in %zu families, %u influences per vertex, joints that deform %s.",
                         variants_[0].figures.size(), scores[main_].families.size(), s_.influences,
                         s_.known ? "given" : "not given");
    data.facts = {{"command", command_line(s_)}, {"sinew", sinew_version()}};
    if (!s_.checkpoint.empty()) {
      const std::vector<uint8_t> bytes = read_file(s_.checkpoint);
      data.facts.emplace_back(
          "checkpoint", file_name(s_.checkpoint) + ", CRC-32 " + print("%08x", crc32(0, bytes.data(), bytes.size())));
      data.facts.emplace_back("bytes at 12, 10 and 8 bits", "as if weights were packed");
    } else if (s_.method.empty()) {
      const std::unique_ptr<LoadedModel> model = load_model(s_.model);
      data.facts.emplace_back("model", model_label(s_.model) + print(", checksum %08x", model->model.checksum));
    }
    const std::string date = build_date();
    if (!date.empty()) data.facts.emplace_back("date", date);
    std::vector<JudgedConfidence> judged;
    for (const auto& [name, one] : confidence_) judged.push_back(one);
    data.reliability = reliability(judged);
    data.confidence = variants_[main_].confidence;
    // A checkpoint has no table yet; what counts is the confidence with one, on families that it was not fitted on.
    if (!s_.checkpoint.empty() && scores[main_].families.size() > 1) {
      data.reliability = reliability_across_families(judged);
      data.confidence = "the strongest joint's share through a table that was fitted on the other half of the families";
    }
    data.beaten_by_nearest = beaten(scores);
    for (size_t i = 0; i < variants_.size(); ++i) {
      ReportVariant row;
      row.label = variants_[i].label;
      row.scores = scores[i];
      row.bits = variants_[i].bits;
      row.size_bytes = variants_[i].size_bytes;
      row.pose_distances = variants_[i].pose_distances;
      if (i > 0 && !s_.checkpoint.empty() && variants_[i].bits > 0) {
        row.argmax_flips = variants_[i].difference.flip_share();
        row.close_unorm8 = variants_[i].difference.close_share();
        row.logit_snr_db = variants_[i].noise.decibels();
        if (variants_[i].bits == 16) data.integers = variants_[i].difference;
      }
      data.variants.push_back(std::move(row));
    }
    data.main_variant = main_;
    for (const auto& [heading, name] : best_median_worst(scores[main_])) {
      const auto& [path, rows] = drawn_.at(name);
      data.pictures.push_back(report_picture(read_character(path), rows, heading));
    }
    draw_bends(scores[main_], &data);
    draw_cloth(&data);
    write_text_file(s_.report, report_html(data));
    if (data.variants.size() > 1) std::printf("%s\n", quantisation_table_markdown(data).c_str());
  }

  // Of the drawn character whose joints' names tell most bends, of these the finest mesh, with the weights that it got.
  void draw_bends(const Scores& scores, ReportData* data) {
    std::optional<ReportPicture> best;
    size_t vertices = 0;
    for (const auto& [heading, name] : best_median_worst(scores)) {
      const auto& [path, rows] = drawn_.at(name);
      Character character = read_character(path);
      character.influences = rows;
      ReportPicture bends = bend_pictures(character);
      if (best && std::pair(bends.panels.size(), character.vertices.size()) <= std::pair(best->panels.size(), vertices))
        continue;
      best = std::move(bends);
      vertices = character.vertices.size();
    }
    if (best && !best->panels.empty()) data->pictures.push_back(std::move(*best));
  }

  // Of the character with most bends under cloth, of these the one whose cloth lies cleanest on the skin.
  void draw_cloth(ReportData* data) {
    const std::string* best = nullptr;
    for (const auto& [name, clothing] : dressed_) {
      const Clothing* const other = best == nullptr ? nullptr : &dressed_.at(*best);
      if (other == nullptr || clothing.bends > other->bends ||
          (clothing.bends == other->bends && clothing.crossings < other->crossings))
        best = &name;
    }
    if (best == nullptr) return;
    const bool by_heat = s_.method == "heat" || s_.method == "nearest";
    const std::unique_ptr<LoadedModel> model = by_heat ? nullptr : load_model(s_.model);
    data->pictures.push_back(garment_pictures(read_character(drawn_.at(*best).first), model ? &model->model : nullptr));
  }

  const Settings& s_;
  std::vector<FoundCharacter> found_;
  std::vector<Variant> variants_;
  size_t main_ = 0;
  std::mutex lock_;
  std::map<std::string, std::string> failures_;
  std::map<std::string, std::pair<std::string, Rows>> drawn_;  // name -> path, main variant's rows
  std::map<std::string, JudgedConfidence> confidence_;
  std::map<std::string, Clothing> dressed_;  // the dressed ones
};

template <class Body>
void run_study(const Settings& s, const char* option, const Body& study) {
  if (!s.checkpoint.empty()) throw UsageError(std::string(option) + " works with --model and --method heat only");
  const std::unique_ptr<LoadedModel> model = s.method == "heat" ? nullptr : load_model(s.model);
  study({s.folder, model ? &model->model : nullptr, s.influences, s.jobs});
}

// KIND:PERCENT
void run_hints(const Settings& s) {
  const size_t colon = s.hints.find(':');
  const std::string kind = s.hints.substr(0, colon);
  char* end = nullptr;
  const double percent = colon == std::string::npos ? 0 : std::strtod(s.hints.c_str() + colon + 1, &end);
  if ((kind != "random" && kind != "patch") || end == nullptr || *end != 0 || !(percent > 0 && percent <= 100))
    throw UsageError("--hints " + s.hints + ": expected random:PERCENT or patch:PERCENT, for example random:5");
  if (!s.checkpoint.empty() || s.method == "nearest")
    throw UsageError("--hints works with --model and --method heat only");
  const std::unique_ptr<LoadedModel> model = s.method == "heat" ? nullptr : load_model(s.model);
  study_hints({s.folder, model ? &model->model : nullptr, s.influences, s.jobs}, kind, percent / 100);
}

void check_style(const Settings& s) {
  if (!s.checkpoint.empty() || s.method == "nearest")
    throw UsageError("--rigid-parts and --softness work with --model and --method heat only");
  if (s.confidence || s.robustness || !s.hints.empty())
    throw UsageError("--rigid-parts and --softness do not go with --hints, --confidence and --robustness");
  BindOptions options;
  options.method = s.method == "heat" ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  apply_style(s.style, &options);
}

void run_rig(const Settings& s, const CLI::App& sub) {
  for (const CLI::Option* option : sub.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 0 && name != "dir" && name != "--task" && name != "--predictions" && name != "--model" &&
        name != "--json" && name != "--jobs" && name != "--report" && name != "--bind" && name != "--method" &&
        name != "--checkpoint")
      throw UsageError(name +
                       " does not go with --task rig, which takes --method, --predictions, --model, --checkpoint, "
                       "--bind, --report, --json and --jobs");
    if (s.task == "hands" && option->count() > 0 && name != "dir" && name != "--task" && name != "--model" &&
        name != "--json" && name != "--jobs")
      throw UsageError(name + " does not go with --task hands, which takes --model, --json and --jobs");
  }
  if (s.method == "heat" || s.method == "nearest")
    throw UsageError("--method " + s.method + " binds; with --task rig it is votes, shape, regions or slots");
  if (!s.method.empty() && !s.predictions.empty()) throw UsageError("--predictions and --method: give one of the two");
  if (!s.json.empty()) check_output(s.json, {".json"}, true);
  if (!s.predictions.empty() && !s.model.empty()) throw UsageError("--predictions and --model: give one of the two");
  if (s.task == "hands") return evaluate_hands({s.folder, s.model, s.json, s.jobs});
  if (!s.checkpoint.empty() && (!s.predictions.empty() || (!s.method.empty() && s.method != "votes")))
    throw UsageError(
        "--checkpoint is measured beside the model that was made of it: leave out --predictions and --method");
  RigEvaluation evaluation{s.folder, s.predictions, s.model, s.method, s.json,
                           s.bind,   s.report,      {},      s.jobs,   s.checkpoint};
  if (!s.report.empty()) {
    check_output(s.report, {".html", ".htm"});
    std::string command = "sinew eval " + s.folder + " --task rig";
    if (!s.method.empty()) command += " --method " + s.method;
    if (!s.model.empty()) command += " --model " + s.model;
    if (!s.predictions.empty()) command += " --predictions " + s.predictions;
    evaluation.facts = {{"command", command + " --report " + s.report}, {"sinew", sinew_version()}};
    if (s.predictions.empty() && (s.method.empty() || s.method == "votes")) {
      const std::unique_ptr<LoadedModel> model = load_model(s.model, ModelUse::kRig);
      evaluation.facts.emplace_back("model", model_label(s.model) + print(", checksum %08x", model->model.checksum));
    }
    const std::string date = build_date();
    if (!date.empty()) evaluation.facts.emplace_back("date", date);
  }
  evaluate_rigs(evaluation);
}

void run(const Settings& s) {
  if (!s.model.empty() && !s.checkpoint.empty())
    throw UsageError("--model and --checkpoint: give one of the two; with --task rig they are measured side by side");
  if (s.bind) throw UsageError("--bind goes with --task rig only");
  if (s.method == "votes" || s.method == "slots" || s.method == "shape" || s.method == "regions")
    throw UsageError("--method " + s.method + " predicts skeletons: it goes with --task rig");
  if (!s.method.empty() && !(s.model.empty() && s.checkpoint.empty()))
    throw UsageError("--method " + s.method + " needs neither --model nor --checkpoint");
  if (!s.report.empty()) check_output(s.report, {".html", ".htm"});
  if (!s.json.empty()) check_output(s.json, {".json"}, true);
  if (!s.joints.empty() && (s.known || !s.checkpoint.empty() || s.method == "nearest"))
    throw UsageError("--joints works with --model and --method heat only, and without --known");
  if (s.known && !s.checkpoint.empty()) throw UsageError("--known works with --model and --method only");
  if (!style_text(s.style).empty()) check_style(s);
  if (!s.calibrate.empty() && s.checkpoint.empty()) throw UsageError("--calibrate belongs to --checkpoint");
  if (s.confidence) return run_study(s, "--confidence", study_confidence);
  if (s.robustness) return run_study(s, "--robustness", study_robustness);
  if (s.first_as_style && s.questions == 0)
    throw UsageError("--style needs --questions N: how many the artist answers");
  if (s.questions > 0)
    return run_study(s, "--questions", [&](const Study& study) {
      s.first_as_style ? study_style(study, s.questions) : study_questions(study, s.questions);
    });
  if (!s.hints.empty()) {
    run_hints(s);
    return;
  }
  Evaluation(s).run();
}

}  // namespace

void add_eval(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("eval", "Bind every character of a folder and compare with the reference weights");
  auto s = std::make_shared<Settings>();
  s->jobs = std::max(1u, std::thread::hardware_concurrency());
  sub->add_option("dir", s->folder, "Folder of FAMILY__NAME.obj + .rig.txt pairs and .glb files, sub-folders too")
      ->required()
      ->type_name("DIR");
  sub->add_option("--task", s->task,
                  "What to compare: bind = skin weights; rig = skeletons, of a model or those that lie in the folder "
                  "of --predictions; hands = fingers, of --model and the bundled model of skeletons")
      ->check(CLI::IsMember({"bind", "rig", "hands"}))
      ->capture_default_str();
  sub->add_option("--model", s->model, "Model file, or bundled = the one in the program [bundled]")->type_name("FILE");
  sub->add_option("--checkpoint", s->checkpoint,
                  "Float checkpoint instead of a model; with --task rig beside the model that was made of it")
      ->type_name("FILE");
  sub->add_option(
         "--method", s->method,
         "heat: no model; nearest: every vertex rigid to the nearest bone; with --task rig votes, or slots = the "
         "published method, of --model CKPT")
      ->check(CLI::IsMember({"heat", "nearest", "votes", "shape", "regions", "slots"}));
  sub->add_option("--predictions", s->predictions,
                  "Folder for NAME.rig.txt of every character and status.json; with --task rig the folder to read the "
                  "predicted NAME.rig.txt from")
      ->type_name("DIR");
  sub->add_option(
         "--report", s->report,
         "Page with tables, plots and pictures, heat and nearest bone beside; with --checkpoint also int16, 12, "
         "10 and 8 bits against float; with --task rig every character's skeleton beside the reference")
      ->type_name("OUT.html");
  sub->add_option("--with", s->peers, "Another binder's predictions, DIR/NAME.rig.txt of every character, as a column")
      ->type_name("NAME=DIR");
  sub->add_flag(
      "--bind", s->bind,
      "With --task rig: bind every mesh to its predicted skeleton, and print how much of the surface moves with "
      "a joint of the reference's class and side");
  sub->add_flag("--against-nearest", s->against_nearest, "List the characters on which nearest bone is better");
  sub->add_option("--json", s->json, "All figures as JSON; - for standard output instead of the table")
      ->type_name("OUT.json");
  sub->add_option("--calibrate", s->calibrate, "With --checkpoint --report: characters to calibrate on [DIR]")
      ->type_name("DIR");
  sub->add_option("--jobs", s->jobs, "Characters at the same time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--influences", s->influences, "Most joints per vertex")
      ->check(CLI::Range(1, 12))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--joints", s->joints,
                  "Which joints may get weight, as in sinew bind: own (those of the reference, mesh by mesh), names, "
                  "all [all]")
      ->check(CLI::IsMember({"own", "names", "all"}));
  sub->add_flag("--known", s->known, "Tell the binder which joints have reference weight");
  add_style_options(sub, &s->style);
  sub->add_flag("--confidence", s->confidence,
                "Instead: print how often the strongest joint is right at each confidence, and the calibration error");
  sub->add_option(
         "--questions", s->questions,
         "Instead: let the reference answer the N questions of every character that are worth most (sinew bind "
         "--questions), and print what the answers gain")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_QUESTIONS)))
      ->type_name("N");
  sub->add_flag("--style", s->first_as_style,
                "With --questions: ask about each family's first character alone, and print what a style file of the "
                "answers gains the family's others");
  sub->add_flag("--robustness", s->robustness,
                "Instead: print how far the weights move when the same character is moved, scaled, turned, mirrored, "
                "renumbered, unwelded, its faces split or merged, decimated, subdivided");
  sub->add_option("--hints", s->hints,
                  "Instead: give the reference weights of this share of the vertices as hints, single ones anywhere "
                  "(random:PERCENT) or one region (patch:PERCENT), and print what the others gain")
      ->type_name("KIND:PERCENT");
  sub->add_option("--label", s->label, "Name in the table")->type_name("TEXT");
  sub->footer(
      "Examples:\n  sinew eval characters/val --predictions out --report out.html\n"
      "  sinew eval characters/val --method heat --known --json -\n"
      "  sinew eval characters/train --against-nearest\n"
      "  sinew eval toys --rigid-parts always\n"
      "  sinew eval characters/val --report out.html --with blender=blender_weights\n"
      "  sinew eval characters/val --checkpoint run.sinewckpt --calibrate characters/train --report bits.html\n"
      "  sinew eval characters/val --task rig --predictions skeletons --json -\n"
      "With --task rig a predicted joint counts by its place, its parent and the class that its name says "
      "(upperarm.L,\n"
      "mixamorig:LeftArm); a leaf called NAME_end or NAME_tip is a bone end. The reference is what sinew dataset "
      "target\n"
      "writes. Lengths are shares of the mesh's longest side; J2J, J2B, B2B: between joints, joints and bones, bones;\n"
      "precision, recall, IoU: joints in pairs at most 0.05 apart; joined: bones between pairs that the prediction "
      "has\n"
      "too; class: pairs of one class; symmetric: skeletons that are their own mirror image.\n"
      "SOURCE_DATE_EPOCH puts its date on the report; without it the same inputs give the same page.");
  sub->callback([s, sub] { s->task != "bind" ? run_rig(*s, *sub) : run(*s); });
}

}  // namespace sinew::cli
