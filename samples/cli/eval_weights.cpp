// SPDX-License-Identifier: MIT
// Binds every character with every variant, measures, prints and writes the figures.
#include "eval_weights.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>

#include "progress.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/confidence.hpp"
#include "support.hpp"

namespace sinew::cli {

std::optional<std::vector<std::pair<std::string, double>>> WeightsFigures::beaten() const {
  for (size_t i = 0; i < variants.size(); ++i)
    if (i != main && variants[i].label == kNearest) return beaten_by(scores[main], scores[i]);
  return std::nullopt;
}

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class Evaluation {
 public:
  explicit Evaluation(const WeightsEvaluation& s) : s_(s), found_(characters_in(s.folder)) {
    figures_.variants = make_variants(s);
    for (size_t i = 0; i < figures_.variants.size(); ++i) {
      if (figures_.variants[i].label == "int16 model") figures_.main = i;  // the report shows what ships
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
        figures_.failures[found_[i].name] = error.what();
      }
      progress.step();
    });
  }

  // One character, bound with every variant.
  struct BoundCharacter {
    std::unique_ptr<Sample> sample;  // of the variants that need one
    std::vector<Prediction> predictions;
    std::vector<Metrics> metrics;
    std::vector<std::vector<double>> poses;
  };

  BoundCharacter bind_one(const Character& character, const std::string& name) const {
    BoundCharacter bound;
    double sample_seconds = 0;
    for (const Variant& variant : figures_.variants) {
      if (variant.candidates == 0 || bound.sample) continue;
      const auto start = std::chrono::steady_clock::now();
      bound.sample =
          std::make_unique<Sample>(make_sample(character, variant.candidates, variant.grid, variant.feature_set));
      sample_seconds = seconds_since(start);
    }
    for (const Variant& variant : figures_.variants) {
      const auto start = std::chrono::steady_clock::now();
      bound.predictions.push_back(variant.predict(character, bound.sample.get()));
      Prediction& prediction = bound.predictions.back();
      if (prediction.seconds == 0) prediction.seconds = seconds_since(start) + sample_seconds;
      bound.poses.emplace_back();
      bound.metrics.push_back(measure(character, prediction.rows, name, 10, nullptr, &bound.poses.back()));
      bound.metrics.back().seconds = prediction.seconds;
    }
    return bound;
  }

  void write_prediction(const Character& character, const std::string& name, const Rows& rows) const {
    Character predicted = character;
    predicted.influences = rows;
    const std::filesystem::path path = std::filesystem::path(s_.predictions) / (name + ".rig.txt");
    make_folder(path.parent_path().string());
    write_rig(path.string(), predicted);
  }

  void one(const FoundCharacter& found) {
    const Character character = read_found(found);
    const std::string& name = found.name;
    if (character.influences.empty()) throw Error(found.path + ": has no reference weights to compare with");
    BoundCharacter bound = bind_one(character, name);
    std::vector<Prediction>& predictions = bound.predictions;
    if (!s_.predictions.empty()) write_prediction(character, name, predictions[0].rows);
    const Prediction& main = predictions[figures_.main];
    JudgedConfidence judged;
    Clothing clothing;
    if (!s_.report.empty()) {
      judged =
          judge_confidence(character, main.rows, main.confidence.empty() ? top_weights(main.rows) : main.confidence);
      clothing = measure_clothing(character);
    }
    const std::lock_guard<std::mutex> guard(lock_);
    for (size_t i = 0; i < figures_.variants.size(); ++i) {
      Variant& variant = figures_.variants[i];
      variant.figures.emplace_back(name, bound.metrics[i]);
      variant.pose_distances[name] = std::move(bound.poses[i]);
      if (i > 0 && variant.bits > 0) variant.difference.add(predictions[0].rows, predictions[i].rows);
      if (i > 0 && !predictions[i].logits.empty())
        variant.noise.add(*bound.sample, predictions[0].logits, predictions[i].logits);
    }
    if (s_.report.empty()) return;
    figures_.confidence[name] = judged;
    if (clothing.bends > 0) figures_.dressed[name] = clothing;
    figures_.drawn[name] = {found.path, std::move(predictions[figures_.main].rows)};
  }

  void finish() {
    for (Variant& variant : figures_.variants) {
      std::sort(variant.figures.begin(), variant.figures.end(),
                [](const auto& a, const auto& b) { return a.first < b.first; });
      figures_.scores.push_back(summarize(variant.figures));
      figures_.scores.back().failures = figures_.failures;
    }
    if (!s_.predictions.empty()) write_status();
    if (!figures_.variants[0].figures.empty()) {
      if (!s_.json) {
        for (size_t i = 0; i < figures_.variants.size(); ++i)
          std::printf("%s\n", scores_markdown(figures_.variants[i].label, figures_.scores[i]).c_str());
        print_beaten();
      }
      if (!s_.report.empty()) write_weights_report(s_, figures_);
    }
    if (!s_.output.empty()) write_text_file(s_.output, figures_json());
    if (s_.json) std::printf("%s", figures_json().c_str());
    check_failed(figures_.failures, found_.size());
  }

  void print_beaten() const {
    const auto list = figures_.beaten();
    if (!list) return;
    std::printf("nearest bone is better than %s on %zu of %zu characters%s\n",
                figures_.variants[figures_.main].label.c_str(), list->size(),
                figures_.scores[figures_.main].characters.size(), list->empty() ? "" : " (L1 above it):");
    for (const auto& [name, loss] : *list) std::printf("  %s %.4f\n", name.c_str(), loss);
    std::printf("\n");
  }

  void write_status() const {
    nlohmann::ordered_json status = nlohmann::ordered_json::object();
    for (const auto& [name, metrics] : figures_.variants[0].figures) {
      status[name] = {{"seconds", metrics.seconds}, {"ok", true}, {"note", ""}};
    }
    for (const auto& [name, note] : figures_.failures) status[name] = {{"seconds", 0.0}, {"ok", false}, {"note", note}};
    write_text_file((std::filesystem::path(s_.predictions) / "status.json").string(),
                    status.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }

  std::string figures_json() const {
    const std::vector<Variant>& variants = figures_.variants;
    nlohmann::ordered_json whole = nlohmann::ordered_json::parse(scores_json(variants[0].label, figures_.scores[0]));
    for (size_t i = 1; i < variants.size(); ++i)
      whole.update(nlohmann::ordered_json::parse(scores_json(variants[i].label, figures_.scores[i])));
    return with_version("eval", "study", "weights", whole.dump());
  }

  const WeightsEvaluation& s_;
  std::vector<FoundCharacter> found_;
  WeightsFigures figures_;
  std::mutex lock_;
};

}  // namespace

void evaluate_weights(const WeightsEvaluation& evaluation) { Evaluation(evaluation).run(); }

}  // namespace sinew::cli
