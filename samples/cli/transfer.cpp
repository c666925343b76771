// SPDX-License-Identifier: MIT
// sinew transfer: the weights of a finished character go to other meshes.
#include "sinew_character/bind/transfer.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "commands.hpp"
#include "option_groups.hpp"
#include "options.hpp"
#include "sinew/published.h"
#include "sinew_character/check/check.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"
#include "transfer_target.hpp"

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct TransferCommandSettings {
  std::string source, output, model, lock, png, png_confidence;
  std::string up = "y", source_up, format = "glb";
  std::vector<std::string> targets, pairs;
  TargetSource from;
  ProfileSettings profile;
  uint32_t method = SINEW_TRANSFER_AUTO;
  unsigned influences = 4, threads = 1;
  bool as_drawn = false, heat = false, json = false;
};

const char* reason_text(uint32_t reason) {
  switch (reason) {
    case SINEW_TRANSFER_STYLE:
      return "transferred: the source's weights differ from a bind, and the match is good";
    case SINEW_TRANSFER_MISMATCH:
      return "rebound: the match error exceeds the difference between the source's weights and a bind";
    case SINEW_TRANSFER_PLAIN:
      return "rebound: the source's weights equal a bind";
    case SINEW_TRANSFER_NEAR:
      return "transferred: it lies on the body";
    case SINEW_TRANSFER_FAR:
      return "rebound: it lies away from the body";
    case SINEW_TRANSFER_NO_MATCH:
      return "rebound: nothing of the source matches it";
    case SINEW_TRANSFER_KEPT:
      return "kept: locked";
    default:
      return "as asked";
  }
}

// V=W: a vertex of the source and one of the target.
sinew_vertex_pair parse_pair(const std::string& text, const Character& source, const Character& target) {
  const size_t equals = text.find('=');
  const auto number = [&](const std::string& word, const Character& of) {
    char* end = nullptr;
    const unsigned long long value = std::strtoull(word.c_str(), &end, 10);
    if (word.empty() || word[0] < '0' || word[0] > '9' || *end != 0)
      throw UsageError("--pair " + text + ": expected V=W, a vertex of " + source.name + " and one of " + target.name);
    if (value >= of.vertices.size())
      throw UsageError("--pair " + text + ": " + of.name + " has vertices 0 to " +
                       std::to_string(of.vertices.size() - 1));
    return static_cast<uint32_t>(value);
  };
  const std::string first = text.substr(0, equals);
  return {number(first, source), number(equals == std::string::npos ? "" : text.substr(equals + 1), target)};
}

// [V] non-zero: keeps its weights; empty without --lock.
std::vector<uint8_t> read_locks(const TransferCommandSettings& s, const std::string& path, const Character& character) {
  if (s.lock.empty()) return {};
  if (character.influences.empty())
    throw Error(s.lock + ": --lock keeps weights of the file, but " + path + " has none for its skeleton");
  return read_vertex_locks(s.lock, character);
}

struct Transferred {
  TransferTarget target;
  TransferResult result;
};

Transferred transfer_one(const TransferCommandSettings& s, const Character& source, const LoadedModel* model,
                         const std::string& path, TargetReader* reader) {
  Transferred done;
  done.target = reader->read(path);
  Character& character = done.target.character;
  TransferOptions options;
  options.method = s.method;
  options.model = model != nullptr ? &model->model : nullptr;
  options.influence_count = s.influences;
  options.up_axis = axis_of(s.up);
  options.source_up_axis = axis_of(s.source_up.empty() ? s.up : s.source_up);
  options.garment = s.from.garment;
  options.as_drawn = s.as_drawn;
  for (const std::string& pair : s.pairs) options.pairs.push_back(parse_pair(pair, source, character));
  options.locked = read_locks(s, path, character);
  options.thread_count = s.threads;
  ThreadPool pool(s.threads);
  options.parallel_for = ThreadPool::parallel_for;
  options.parallel_user = &pool;
  done.result = transfer(source, character, done.target.mapping, options);
  character.influences = done.result.influences;
  add_checked_note(&character);
  return done;
}

Json part_json(const sinew_transfer_part& part) {
  constexpr double kUnit = 1.0 / 65536;
  Json json;
  json["vertex"] = part.vertex;
  json["vertices"] = part.vertex_count;
  json["carried"] = kUnit * part.carried_q16;
  json["style"] = kUnit * part.style_q16;
  json["mismatch"] = kUnit * part.mismatch_q16;
  json["distance"] = kUnit * part.distance_q16;
  json["reason"] = reason_text(part.reason);
  return json;
}

Json summary_json(const TransferCommandSettings& s, const Character& source, const Transferred& done,
                  const std::string& path, const std::string& output) {
  const TransferResult& r = done.result;
  Json json = {{"sinew_transfer", 1}};
  json["source"] = s.source;
  json["target"] = path;
  json["output"] = output;
  json["method"] = kTransferMethod[s.method];
  json["skeleton"] = done.target.skeleton;
  json["mapped_joints"] = mapped_count(done.target.mapping);
  json["source_joints"] = source.joints.size();
  json["mapped_by"] = done.target.mapped_by;
  json["bound_by"] = !r.bound ? "" : r.bound_by == SINEW_METHOD_HEAT ? "heat" : "model";
  json["carried"] = r.carried;
  json["style"] = r.style;
  json["mismatch"] = r.mismatch;
  if (r.reference_count > 0) json["references"] = r.reference_count;
  json["seconds"] = r.seconds;
  json["workspace_bytes"] = r.workspace_bytes;
  for (const sinew_transfer_part& part : r.parts) json["parts"].push_back(part_json(part));
  json["notes"] = done.target.character.notes;
  return json;
}

void tell(const TransferCommandSettings& s, const Character& source, const Transferred& done, const std::string& path,
          const std::string& output, std::FILE* out) {
  if (s.json) {
    std::fprintf(out, "%s\n", json_line(summary_json(s, source, done, path, output)).c_str());
    return;
  }
  constexpr size_t kMostParts = 8;
  const TransferResult& r = done.result;
  std::fprintf(out, "%s: skeleton %s%s, %zu of %zu joints of %s mapped by %s\n", printable(path).c_str(),
               done.target.fitted ? "fitted from " : "", printable(done.target.skeleton).c_str(),
               mapped_count(done.target.mapping), source.joints.size(), printable(source.name).c_str(),
               printable(done.target.mapped_by).c_str());
  if (r.reference_count > 0) std::fprintf(out, "  %u reference points\n", r.reference_count);
  if (r.bound)
    std::fprintf(
        out, "  %.0f %% transferred, the rest rebound by %s; %s differs from a bind by %.2f, the match error is %.2f\n",
        100 * r.carried, r.bound_by == SINEW_METHOD_HEAT ? "heat" : "the model", printable(source.name).c_str(),
        r.style, r.mismatch);
  for (size_t p = 0; p < r.parts.size() && p < kMostParts && r.bound; ++p) {
    const sinew_transfer_part& part = r.parts[p];
    std::fprintf(out, "  part of vertex %u, %u vertices, %.0f %% transferred; %s\n", part.vertex, part.vertex_count,
                 100.0 * part.carried_q16 / 65536, reason_text(part.reason));
  }
  if (r.bound && r.parts.size() > kMostParts)
    std::fprintf(out, "  and %zu smaller parts; --json lists all\n", r.parts.size() - kMostParts);
  for (const std::string& note : done.target.character.notes) std::fprintf(out, "  %s\n", printable(note).c_str());
  std::fprintf(out, "  %.0f ms", 1e3 * r.seconds);
  if (output != "-") std::fprintf(out, ", wrote %s", printable(output).c_str());
  std::fprintf(out, "\n");
}

void write_one(const TransferCommandSettings& s, const std::string& output, Transferred* done) {
  Character& character = done->target.character;
  write_as(s.profile, output, character, &character.notes);
  RenderOptions view;
  view.up = axis_of(s.up);
  if (!s.png.empty()) write_file(s.png, encode_png(render(character, weight_colors(character), view)));
  if (s.png_confidence.empty()) return;
  std::vector<float> doubt;
  for (const uint8_t c : done->result.confidence) doubt.push_back(1.0f - static_cast<float>(c) / 255.0f);
  write_file(s.png_confidence, encode_png(render(character, heat_colors(doubt, 0.5f), view)));
}

// Output paths: one file for one target, a folder for several.
std::vector<std::string> outputs_of(const TransferCommandSettings& s) {
  if (s.targets.size() == 1) {
    const std::string output =
        s.output.empty() ? stem_of(s.targets[0]) + ".transferred" + container_of(s.profile) : s.output;
    check_output(output, kWritesSkin, true);
    return {output};
  }
  if (s.output.empty()) throw UsageError("several targets need a folder; give -o OUTDIR");
  refuse_given({{"--png", !s.png.empty()},
                {"--lock", !s.lock.empty()},
                {"--png-confidence", !s.png_confidence.empty()},
                {"--pair", !s.pairs.empty()}},
               " takes one target, found several");
  std::error_code ignored;
  if (!std::filesystem::is_directory(s.output, ignored))
    throw Error("-o " + s.output + ": expected a folder for the files of several targets; create it first");
  std::vector<std::string> outputs;
  std::set<std::string> taken;
  for (const std::string& target : s.targets) {
    outputs.push_back((std::filesystem::path(s.output) / (stem_of(target) + "." + s.format)).string());
    if (!taken.insert(outputs.back()).second)
      throw UsageError("two targets would become " + outputs.back() + "; transfer one after the other");
  }
  return outputs;
}

// Neither the source nor a target is written over.
void check_inputs_stay(const TransferCommandSettings& s, const std::vector<std::string>& outputs) {
  std::vector<std::string> inputs = s.targets;
  inputs.push_back(s.source);
  if (has_extension(s.source, ".obj")) inputs.push_back(rig_path_beside(s.source));
  if (!s.from.skeleton.empty()) inputs.push_back(s.from.skeleton);
  for (const std::string& output : outputs) {
    for (const std::string& input : inputs) {
      std::error_code ignored;
      if (output != "-" && std::filesystem::equivalent(output, input, ignored))
        throw UsageError("-o " + output + " is one of the inputs; give another name");
    }
  }
}

void check_transfer(const TransferCommandSettings& s) {
  if (s.method == SINEW_TRANSFER_BIHARMONIC && s.from.garment)
    throw UsageError("--garment does not work with --method biharmonic; use auto, nearest or rebind");
  if (s.method != SINEW_TRANSFER_BIHARMONIC && (!s.pairs.empty() || s.as_drawn))
    throw UsageError("--pair and --as-drawn need --method biharmonic");
  if (s.from.garment && !(s.from.skeleton.empty() && s.from.map.empty()))
    throw UsageError("--garment uses the skeleton of the source: leave out --skeleton and --map");
  if (s.from.garment && !s.source_up.empty() && s.source_up != s.up)
    throw UsageError("--garment uses the axes of the source: leave out --from-up");
  if (s.from.garment && !s.lock.empty()) throw UsageError("--garment ignores weights of the target: leave out --lock");
  if (s.pairs.size() > SINEW_MAX_TRANSFER_PAIRS)
    throw UsageError(std::to_string(s.pairs.size()) + " pairs, at most " + std::to_string(SINEW_MAX_TRANSFER_PAIRS));
  if (s.heat && !s.model.empty()) throw UsageError("--heat uses no model: leave out --model");
  if (!s.png.empty()) check_output(s.png, {".png"});
  if (!s.png_confidence.empty()) check_output(s.png_confidence, {".png"});
}

void run_transfer(const TransferCommandSettings& s) {
  check_transfer(s);
  settle_profile(s.profile, nullptr);
  const std::vector<std::string> outputs = outputs_of(s);
  check_inputs_stay(s, outputs);
  if (outputs[0] == "-" && s.json)
    throw UsageError("-o - and --json both write to standard output; give the weights a file name");
  const Character source = read_character(s.source);
  if (source.influences.empty())
    throw Error(s.source +
                ": has no weights to transfer; expected a bound character: a file with a skin, or NAME.obj with a "
                "NAME.rig.txt beside it that has skin lines");
  std::unique_ptr<LoadedModel> model;
  const bool binds = s.method == SINEW_TRANSFER_AUTO || s.method == SINEW_TRANSFER_REBIND;
  if (binds && !s.heat) model = load_model(s.model);
  TargetReader reader(source, s.from);
  size_t failed = 0;
  for (size_t i = 0; i < s.targets.size(); ++i) {
    try {
      Transferred done = transfer_one(s, source, model.get(), s.targets[i], &reader);
      write_one(s, outputs[i], &done);
      tell(s, source, done, s.targets[i], outputs[i], outputs[i] == "-" ? stderr : stdout);
    } catch (const UsageError&) {
      throw;
    } catch (const Error& error) {
      if (s.targets.size() == 1) throw;
      ++failed;
      std::fprintf(stderr, "sinew: error: %s\n", printable(error.what()).c_str());
    }
  }
  check_failed(failed, s.targets.size(), "targets");
}

void add_transfer_inputs(CLI::App* sub, TransferCommandSettings* s) {
  sub->add_option("source", s->source,
                  "Bound character: a skinned file, or NAME.obj with NAME.rig.txt. " + mesh_files())
      ->required()
      ->type_name("SOURCE");
  sub->add_option("targets", s->targets, "Meshes to bind. " + mesh_files())->required()->type_name("TARGET");
  shared_option(sub, "-o,--output", s->output, skin_output_text("for several targets, a folder"))
      ->default_str("TARGET.transferred.glb");
  shared_option(sub, "--skeleton", s->from.skeleton,
                "For the targets: " + skeleton_files() +
                    "; by default the target's own or the NAME.rig.txt beside NAME.obj, else the source's, fitted");
  shared_option(sub, "--map", s->from.map,
                "As written by sinew map; by default joints of equal names, else matched by anatomy");
  sub->add_flag("--garment", s->from.garment,
                "The targets are worn by the source: same space, same skeleton. They get the body's weights near it, "
                "and a bind of the dressed character elsewhere");
  shared_word_option(sub, "--method", s->method, kTransferMethod,
                     "auto: nearest or rebind, whichever suits each vertex; nearest: the source's weights alone; "
                     "biharmonic: by distances along the surface; rebind: by the binder that suits the source");
  add_influences(sub, s->influences);
  shared_option(sub, "--png", s->png, "The target with its joints, colored by weight");
  shared_flag(sub, "--json", s->json, "One line per target");
}

void add_transfer_rest(CLI::App* sub, TransferCommandSettings* s) {
  section(sub, "Biharmonic");
  sub->add_option("--pair", s->pairs,
                  "With --method biharmonic: vertex V of the source matches vertex W of the target. Give at least four")
      ->type_name("V=W")
      ->allow_extra_args(false);
  shared_flag(sub, "--as-drawn", s->as_drawn,
              "With --method biharmonic: distances to all reference points, unscaled, with equal weight");
  section(sub, "Models");
  shared_option(sub, "--model", s->model, "For rebinding")->default_str("bundled");
  sub->add_flag("--heat", s->heat, "Rebind by heat diffusion, without a model");
  sub->add_option("--rig-model", s->from.rig_model, "Model of skeletons for targets without one")
      ->type_name("FILE")
      ->default_str("bundled");
  section(sub, "Other options");
  shared_option(sub, "--lock", s->lock);
  shared_option(sub, "--up", s->up)->check(CLI::IsMember({"y", "z"}))->capture_default_str();
  shared_option(sub, "--from-up", s->source_up, "Of the source; by default as --up")->check(CLI::IsMember({"y", "z"}));
  shared_option(sub, "--format", s->format, "For several targets")
      ->check(CLI::IsMember(format_names(kWritesSkin)))
      ->capture_default_str();
  shared_option(sub, "--threads", s->threads, "For one mesh; the result is the same for any N")
      ->check(CLI::Range(1, static_cast<int>(SINEW_MAX_THREADS)))
      ->capture_default_str();
  shared_option(sub, "--png-confidence", s->png_confidence);
  add_profile_options(sub, &s->profile);
}

}  // namespace

void add_transfer(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("transfer", "Transfer the weights of a finished character to other meshes");
  auto s = std::make_shared<TransferCommandSettings>();
  add_transfer_inputs(sub, s.get());
  add_transfer_rest(sub, s.get());
  sub->footer(
      "Examples:\n  sinew transfer hero.glb villain.obj --skeleton villain.rig.txt -o villain.glb\n"
      "  sinew transfer hero.glb orc.glb --map orc_to_hero.txt -o orc.bound.glb\n"
      "  sinew transfer body.glb jacket.obj shoes.glb --garment -o dressed\n\n"
      "  sinew transfer a.glb b.glb --method biharmonic --pair 10=22 --pair 4=90 --pair 7=1 --pair 80=5");
  sub->callback([s] {
    s->from.up_axis = axis_of(s->up);
    run_transfer(*s);
  });
}

}  // namespace sinew::cli
