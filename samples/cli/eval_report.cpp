// SPDX-License-Identifier: MIT
// The page of sinew-lab eval weights --report.
#include <cstdio>
#include <memory>
#include <optional>

#include "eval_weights.hpp"
#include "model/layout.hpp"
#include "sinew/sinew.h"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/confidence.hpp"
#include "sinew_trainer/report.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// The command as it would be typed, without what does not change the numbers.
std::string command_line(const WeightsEvaluation& s) {
  std::string line = "sinew-lab eval " + s.folder;
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

// How the numbers were made.
std::vector<std::pair<std::string, std::string>> facts_of(const WeightsEvaluation& s) {
  std::vector<std::pair<std::string, std::string>> facts = {{"command", command_line(s)}, {"sinew", sinew_version()}};
  if (!s.checkpoint.empty()) {
    const std::vector<uint8_t> bytes = read_file(s.checkpoint);
    facts.emplace_back("checkpoint",
                       file_name(s.checkpoint) + ", CRC-32 " + print("%08x", crc32(0, bytes.data(), bytes.size())));
    facts.emplace_back("bytes at 12, 10 and 8 bits", "as if weights were packed");
  } else if (s.method.empty()) {
    const std::unique_ptr<LoadedModel> model = load_model(s.model);
    facts.emplace_back("model", model_label(s.model) + print(", checksum %08x", model->model.checksum));
  }
  const std::string date = report_date();
  if (!date.empty()) facts.emplace_back("date", date);
  return facts;
}

void add_reliability(const WeightsEvaluation& s, const WeightsFigures& figures, ReportData* data) {
  std::vector<JudgedConfidence> judged;
  for (const auto& [name, one] : figures.confidence) judged.push_back(one);
  data->reliability = reliability(judged);
  data->confidence = figures.variants[figures.main].confidence;
  // A checkpoint has no table yet; what counts is the confidence with one, on families that it was not fitted on.
  if (s.checkpoint.empty() || figures.scores[figures.main].families.size() <= 1) return;
  data->reliability = reliability_across_families(judged);
  data->confidence = "the strongest joint's share through a table fitted on the other half of the families";
}

void add_rows(const WeightsEvaluation& s, const WeightsFigures& figures, ReportData* data) {
  for (size_t i = 0; i < figures.variants.size(); ++i) {
    const Variant& variant = figures.variants[i];
    ReportVariant row;
    row.label = variant.label;
    row.scores = figures.scores[i];
    row.bits = variant.bits;
    row.size_bytes = variant.size_bytes;
    row.pose_distances = variant.pose_distances;
    if (i > 0 && !s.checkpoint.empty() && variant.bits > 0) {
      row.argmax_flips = variant.difference.flip_share();
      row.close_unorm8 = variant.difference.close_share();
      row.logit_snr_db = variant.noise.decibels();
      if (variant.bits == 16) data->integers = variant.difference;
    }
    data->variants.push_back(std::move(row));
  }
}

// The drawn character with most bends by joint names, among these the finest mesh, with its predicted weights.
void draw_bends(const WeightsFigures& figures, ReportData* data) {
  const Scores& scores = figures.scores[figures.main];
  std::optional<ReportPicture> best;
  size_t vertices = 0;
  for (const auto& [heading, name] : best_median_worst(scores)) {
    const auto& [path, rows] = figures.drawn.at(name);
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

// The character with most bends under cloth, among these the one whose cloth lies cleanest on the skin.
void draw_cloth(const WeightsEvaluation& s, const WeightsFigures& figures, ReportData* data) {
  const std::string* best = nullptr;
  for (const auto& [name, clothing] : figures.dressed) {
    const Clothing* const other = best == nullptr ? nullptr : &figures.dressed.at(*best);
    if (other == nullptr || clothing.bends > other->bends ||
        (clothing.bends == other->bends && clothing.crossings < other->crossings))
      best = &name;
  }
  if (best == nullptr) return;
  const bool by_heat = s.method == "heat" || s.method == "nearest";
  const std::unique_ptr<LoadedModel> model = by_heat ? nullptr : load_model(s.model);
  data->pictures.push_back(
      garment_pictures(read_character(figures.drawn.at(*best).first), model ? &model->model : nullptr));
}

}  // namespace

void write_weights_report(const WeightsEvaluation& s, const WeightsFigures& figures) {
  ReportData data;
  data.summary = print("%zu characters in %zu families, %u influences per vertex, joints that deform %s.",
                       figures.variants[0].figures.size(), figures.scores[figures.main].families.size(), s.influences,
                       s.known ? "given" : "not given");
  data.facts = facts_of(s);
  add_reliability(s, figures, &data);
  data.beaten_by_nearest = figures.beaten();
  add_rows(s, figures, &data);
  data.main_variant = figures.main;
  for (const auto& [heading, name] : best_median_worst(figures.scores[figures.main])) {
    const auto& [path, rows] = figures.drawn.at(name);
    data.pictures.push_back(report_picture(read_character(path), rows, heading));
  }
  draw_bends(figures, &data);
  draw_cloth(s, figures, &data);
  write_text_file(s.report, report_html(data));
  if (data.variants.size() > 1) std::printf("%s\n", quantization_table_markdown(data).c_str());
}

}  // namespace sinew::cli
