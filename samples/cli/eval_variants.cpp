// SPDX-License-Identifier: MIT
// Ways of binding a character, each a column of the table.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "eval_weights.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/rig/skeleton_repair.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_quant/quantize.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/network.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

std::vector<uint8_t> known_joints(const Character& character) {
  std::vector<uint8_t> flags(character.joints.size(), 0);
  for (const auto& row : character.influences) {
    for (const Influence& i : row) {
      if (i.weight > 0) flags[i.joint] = SINEW_JOINT_DEFORMS;
    }
  }
  return flags;
}

Prediction bind_with(const WeightsEvaluation& s, const sinew_model* model, const Character& character) {
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

Variant heat_variant(const WeightsEvaluation& s) {
  Variant variant;
  variant.label = "heat";
  variant.predict = [&s](const Character& c, const Sample*) { return bind_with(s, nullptr, c); };
  return variant;
}

Variant nearest_variant(const WeightsEvaluation& s) {
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
          throw Error(path + ": binds to joint " + predicted.joints[i.joint].name + ", which the character lacks");
        prediction.rows.back().push_back({found->second, i.weight});
      }
    }
    return prediction;
  };
  return variant;
}

Variant model_variant(const WeightsEvaluation& s, const std::string& label, std::shared_ptr<LoadedModel> model) {
  Variant variant;
  variant.label = label;
  variant.bits = 16;
  variant.size_bytes = model->model.size_bytes;
  if (model->model.confidence_count > 0) variant.confidence = "the strongest joint's share through the model's table";
  variant.predict = [&s, model](const Character& c, const Sample*) { return bind_with(s, &model->model, c); };
  return variant;
}

// The float network first; with a report also the same network in integers, at fewer and fewer bits.
std::vector<Variant> checkpoint_variants(const WeightsEvaluation& s) {
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
    const QuantizedModel quantized = quantize(network, calibration, options);
    std::shared_ptr<LoadedModel> model = model_from_bytes(quantized.bytes, "the quantized network");
    Variant variant;
    variant.label = bits == 16 ? "int16 model" : std::to_string(bits) + " bits";
    variant.bits = bits;
    // The file format keeps 16 bits; fewer are counted as if weights were packed.
    variant.size_bytes =
        quantized.bytes.size() - static_cast<size_t>(model->model.parameter_count) * static_cast<size_t>(16 - bits) / 8;
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

}  // namespace

std::vector<Variant> make_variants(const WeightsEvaluation& s) {
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

}  // namespace sinew::cli
