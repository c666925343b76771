// SPDX-License-Identifier: MIT
// Runs the folds of a cross-family validation side by side, each to its own checkpoint and file of figures, and
// collects them.
#include "sinew_trainer/crossval.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr size_t kCalibrationSamples = 40;  // as many as quantize and eval take

struct Measured {
  std::string name, family;
  CrossvalFigures figures;
};

// A folder's samples and where their characters are.
struct MeasuredSet {
  std::vector<const Sample*> samples;
  std::map<std::string, std::string> paths;  // by character name
};

std::string path_in(const CrossvalOptions& options, const std::string& name) {
  return (fs::path(options.folder) / name).string();
}

std::map<std::string, std::string> paths_by_name(const std::string& folder) {
  std::map<std::string, std::string> paths;
  const std::vector<std::string> found = list_characters(folder), names = character_names(folder, found);
  for (size_t i = 0; i < found.size(); ++i) paths[names[i]] = found[i];
  return paths;
}

CrossvalFigures figures_of(const Metrics& network, const Metrics& heat) {
  return {network.l1, network.argmax, network.avg_dist, heat.l1, heat.argmax, heat.avg_dist};
}

// Heat's figures are the same in every fold and seed: measured once per character.
class HeatFigures {
 public:
  Metrics of(const Character& character, const Sample& sample) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = known_.find(&sample);
      if (found != known_.end()) return found->second;
    }
    const Metrics metrics = measure(character, sample_influences(sample, sample.heat, kKeptInfluences), sample.name);
    const std::lock_guard<std::mutex> lock(mutex_);
    return known_[&sample] = metrics;
  }

 private:
  std::mutex mutex_;
  std::map<const Sample*, Metrics> known_;
};

// One training run: a fold of a seed, or (fold 0) the run that leaves nothing out and is measured on the val folder.
struct Job {
  uint64_t seed = 0;
  uint32_t fold = 0;
  std::string stem;  // of its files
  size_t work = 0;   // characters it is trained on: the longest start first
};

class Crossval {
 public:
  Crossval(const TrainConfig& config, const CrossvalOptions& options) : config_(config), options_(options) {}

  CrossvalReport run() {
    plan();
    std::vector<Job> jobs;
    for (const Job& job : all_jobs_) {
      if (!fs::exists(figures_path(job))) jobs.push_back(job);
    }
    if (!options_.quiet && jobs.size() < all_jobs_.size()) {
      std::fprintf(stderr, "%zu of %zu runs are there already\n", all_jobs_.size() - jobs.size(), all_jobs_.size());
    }
    std::stable_sort(jobs.begin(), jobs.end(), [](const Job& a, const Job& b) { return a.seed < b.seed; });
    for (size_t begin = 0, end = 0; begin < jobs.size() && !stopped(); begin = end) {
      // Augmented variants depend on the seed; without them all seeds share one set of samples.
      end = jobs.size();
      if (config_.variants > 0 && config_.variant_share > 0) {
        end = begin + 1;
        while (end < jobs.size() && jobs[end].seed == jobs[begin].seed) ++end;
      }
      run_jobs({jobs.begin() + static_cast<std::ptrdiff_t>(begin), jobs.begin() + static_cast<std::ptrdiff_t>(end)});
    }
    return collect();
  }

 private:
  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  std::string figures_path(const Job& job) const { return path_in(options_, job.stem + ".json"); }

  TrainOptions train_options(const Job& job) const {
    TrainOptions out;
    out.data_dir = options_.data_dir;
    out.output = path_in(options_, job.stem + ".ckpt");
    out.cache_dir = options_.cache_dir.empty() ? path_in(options_, "cache") : options_.cache_dir;
    out.threads = options_.threads;
    out.minutes = options_.minutes;
    out.quiet = options_.quiet;
    out.stop = options_.stop;
    if (job.fold > 0) out.leave_out = folds_[job.fold - 1];
    out.label =
        "seed " + std::to_string(job.seed) + (job.fold > 0 ? " fold " + std::to_string(job.fold) : " val") + ": ";
    out.resume = fs::exists(out.output);
    return out;
  }

  std::map<std::string, size_t> left_out_families(std::map<std::string, size_t> families) const {
    if (options_.leave_out.empty()) return families;
    const auto found = options_.groups.means.find(options_.leave_out);
    if (found == options_.groups.means.end())
      throw Error("leave out: the groups file has no mean named " + options_.leave_out);
    std::erase_if(families, [&](const auto& f) { return found->second.count(options_.groups.group(f.first)) == 0; });
    return families;
  }

  // Folds from the names in the data folder; what a resumed run must agree with; the list of runs.
  void plan() {
    std::map<std::string, size_t> families;
    for (const auto& [name, path] : paths_by_name(options_.data_dir)) ++families[family_of(name)];
    folds_ = make_folds(left_out_families(families), options_.groups, options_.fold_count);
    if (options_.only_fold > options_.fold_count) {
      throw Error("fold " + std::to_string(options_.only_fold) + ": there are " + std::to_string(options_.fold_count));
    }
    std::error_code failure;
    fs::create_directories(options_.folder, failure);
    if (failure) throw Error(options_.folder + ": cannot create the folder: " + failure.message());
    if (!options_.from.empty()) require_same_folds();
    Json plan;
    plan["config"] = Json::parse(train_config_json(config_));
    plan["minutes"] = options_.minutes;
    plan["arithmetic"] = options_.arithmetic;
    plan["folds"] = folds_;
    plan["families"] = families;
    const std::string path = path_in(options_, "plan.json"), text = plan.dump(1) + "\n";
    if (fs::exists(path)) {
      const std::vector<uint8_t> bytes = read_file(path);
      if (!options_.resume) {
        throw Error(options_.folder + ": a cross-validation exists there; give --resume to continue it, or another -o");
      }
      if (std::string(bytes.begin(), bytes.end()) != text) require_same_plan(bytes, plan, path);
    } else {
      write_text_file(path, text);
    }

    for (uint64_t i = 0; i < options_.seed_count; ++i) {
      const uint64_t seed = config_.seed + i;
      const std::string stem = "seed" + std::to_string(seed) + ".";
      size_t all = 0;
      for (const auto& [family, count] : families) all += count;
      for (uint32_t fold = 1; fold <= options_.fold_count; ++fold) {
        if (options_.only_fold != 0 && options_.only_fold != fold) continue;
        size_t work = all;
        for (const std::string& family : folds_[fold - 1]) work -= families[family];
        all_jobs_.push_back({seed, fold, stem + "fold" + std::to_string(fold), work});
      }
      if (!options_.val_dir.empty() && options_.only_fold == 0) all_jobs_.push_back({seed, 0, stem + "val", all});
    }
  }

  // Else a network would be measured on what it has seen.
  void require_same_folds() const {
    const std::string path = (fs::path(options_.from) / "plan.json").string();
    const std::vector<uint8_t> bytes = read_file(path);
    try {
      const Json folds = Json::parse(bytes.begin(), bytes.end()).at("folds");
      if (folds != Json(folds_)) throw Error(path + ": its folds differ from those of --groups and --folds");
    } catch (const nlohmann::json::exception& error) {
      throw Error(path + ": expected the plan of a cross-validation: " + error.what());
    }
  }

  static void require_same_plan(const std::vector<uint8_t>& bytes, const Json& plan, const std::string& path) {
    Json saved;
    try {
      saved = Json::parse(bytes.begin(), bytes.end());
    } catch (const Json::parse_error&) {
      throw Error(path + ": expected JSON; remove the folder to start anew");
    }
    for (const auto& [key, value] : plan.items()) {
      if (saved.contains(key) && saved[key] == value) continue;
      std::string where = key;
      if (key == "config" && saved.contains(key)) {
        for (const auto& [inner, setting] : value.items()) {
          if (!saved[key].contains(inner) || saved[key][inner] != setting) where = "config." + inner;
        }
      }
      throw Error(path + ": cannot resume: " + where + " has changed since; give another -o");
    }
  }

  void run_jobs(std::vector<Job> jobs) {
    TrainConfig config = config_;
    config.seed = jobs[0].seed;
    const TrainingSet set = load_training_set(config, train_options(jobs[0]));
    MeasuredSet left_out, val;
    left_out.paths = paths_by_name(options_.data_dir);
    std::vector<Sample> whole, val_samples;  // what a family is measured on is never decimated
    if (config.vertex_limit > 0) {
      whole = load_samples(options_.data_dir, config.field.candidates, config.field.grid,
                           train_options(jobs[0]).cache_dir, options_.threads, options_.quiet, feature_flags(config));
      for (const Sample& sample : whole) left_out.samples.push_back(&sample);
    } else {
      for (const std::vector<Sample>& character : set.characters) left_out.samples.push_back(&character[0]);
    }
    std::set<std::string> usable;
    for (const std::vector<Sample>& character : set.characters) usable.insert(character[0].name);
    std::erase_if(left_out.samples,
                  [&](const Sample* s) { return usable.count(s->name) == 0 || left_out.paths.count(s->name) == 0; });
    if (!options_.val_dir.empty()) {
      val_samples =
          load_samples(options_.val_dir, config.field.candidates, config.field.grid, train_options(jobs[0]).cache_dir,
                       options_.threads, options_.quiet, feature_flags(config));
      val.paths = paths_by_name(options_.val_dir);
      for (const Sample& sample : val_samples) val.samples.push_back(&sample);
    }

    // Long runs first, so that threads end together. A fold has one thread while folds are waiting; the last ones share
    // all of them, which changes no number.
    std::stable_sort(jobs.begin(), jobs.end(), [](const Job& a, const Job& b) { return a.work > b.work; });
    const uint32_t at_once = options_.at_once == 0 ? options_.threads : std::min(options_.at_once, options_.threads);
    std::atomic<size_t> unfinished{jobs.size()};
    std::atomic<uint32_t> threads_each{1};
    const auto share = [&] {
      const auto running = static_cast<uint32_t>(std::clamp<size_t>(unfinished.load(), 1, at_once));
      threads_each = std::max(1u, options_.threads / running);
    };
    share();
    HeatFigures heat;
    parallel_for(jobs.size(), at_once, [&](size_t i, unsigned) {
      const Job& job = jobs[i];
      if (stopped()) return;
      TrainConfig fold_config = config_;
      fold_config.seed = job.seed;
      TrainOptions options = train_options(job);
      options.threads_now = &threads_each;
      if (options_.from.empty()) {
        train(fold_config, options, set);
      } else {
        take_over(job);
      }
      if (stopped()) return;
      const auto start = std::chrono::steady_clock::now();
      const std::vector<Measured> measured = measure_run(job, set, job.fold > 0 ? left_out : val, threads_each, &heat);
      write_figures(job, measured);
      if (!options_.quiet) {
        double l1 = 0, heat_l1 = 0;
        for (const Measured& m : measured) l1 += m.figures.l1, heat_l1 += m.figures.heat_l1;
        const double n = static_cast<double>(std::max<size_t>(1, measured.size()));
        std::fprintf(stderr, "%sdone, %zu characters: L1 %.4f (heat %.4f), measured in %.0f s\n", options.label.c_str(),
                     measured.size(), l1 / n, heat_l1 / n,
                     std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      }
      --unfinished;
      share();
    });
  }

  // The network of the same run in options_.from, which must have been trained alike but for its correction.
  void take_over(const Job& job) const {
    const std::string source = (fs::path(options_.from) / (job.stem + ".ckpt")).string();
    Checkpoint checkpoint = read_checkpoint(source);
    change_correction(config_.correction, source, &checkpoint);
    TrainConfig expected = config_;
    expected.seed = job.seed;
    const Json theirs = Json::parse(checkpoint.state.config_json), ours = Json::parse(train_config_json(expected));
    for (const auto& [key, value] : ours.items()) {
      if (theirs.at(key) != value) throw Error(source + ": was trained with another configuration: " + key);
    }
    write_checkpoint(train_options(job).output, checkpoint);
  }

  std::vector<Measured> measure_run(const Job& job, const TrainingSet& set, const MeasuredSet& on, uint32_t threads,
                                    HeatFigures* heat) const {
    const FloatNetwork network = read_checkpoint(train_options(job).output).network;
    std::vector<const Sample*> samples;
    const auto is_left_out = [&](const std::string& family) {
      return job.fold > 0 && std::binary_search(folds_[job.fold - 1].begin(), folds_[job.fold - 1].end(), family);
    };
    for (const Sample* sample : on.samples) {
      if (job.fold == 0 || is_left_out(sample->family)) samples.push_back(sample);
    }
    LogitsFunction logits = [&](const Sample& sample) { return forward(network, sample); };
    if (options_.logits) {
      std::vector<const Sample*> seen, some;
      for (size_t i = 0; i < set.characters.size(); ++i) {
        if (!is_left_out(set.families[i])) seen.push_back(&set.characters[i][0]);
      }
      const size_t count = std::min(seen.size(), kCalibrationSamples);
      for (size_t i = 0; i < count; ++i) some.push_back(seen[i * seen.size() / count]);
      logits = options_.logits(network, some);
    }
    std::vector<Measured> out(samples.size());
    parallel_for(samples.size(), threads, [&](size_t i, unsigned) {
      const Sample& sample = *samples[i];
      const Character character = read_character(on.paths.at(sample.name));
      const Metrics metrics =
          measure(character, sample_influences(sample, softmax(sample, logits(sample)), kKeptInfluences), sample.name);
      out[i] = {sample.name, sample.family, figures_of(metrics, heat->of(character, sample))};
    });
    return out;
  }

  void write_figures(const Job& job, const std::vector<Measured>& measured) const {
    Json rows = Json::array();
    for (const Measured& m : measured) {
      const CrossvalFigures& f = m.figures;
      rows.push_back({{"name", m.name},
                      {"family", m.family},
                      {"l1", f.l1},
                      {"argmax", f.argmax},
                      {"distance", f.distance},
                      {"heat_l1", f.heat_l1},
                      {"heat_argmax", f.heat_argmax},
                      {"heat_distance", f.heat_distance}});
    }
    const Json out = {{"seed", job.seed}, {"fold", job.fold}, {"characters", rows}};
    write_text_file(figures_path(job), out.dump(1) + "\n");
  }

  // Collects every run whose figures are on disk, including other seeds and folds than those of this call.
  CrossvalReport collect() const {
    CrossvalReport report;
    report.label = options_.label;
    report.config_json = train_config_json(config_);
    report.apart = options_.groups.apart;
    report.means = options_.groups.means;
    report.fold_count = options_.fold_count;
    std::map<uint64_t, CrossvalSeed> seeds;
    for (const fs::directory_entry& entry : fs::directory_iterator(options_.folder)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("seed", 0) != 0 || entry.path().extension() != ".json") continue;
      add_run(entry.path().string(), &seeds);
    }
    for (auto& [number, seed] : seeds) {
      seed.seed = number;
      for (std::vector<CrossvalFamily>* families : {&seed.families, &seed.val}) {
        std::sort(families->begin(), families->end(),
                  [](const CrossvalFamily& a, const CrossvalFamily& b) { return a.family < b.family; });
      }
      report.seeds.push_back(std::move(seed));
    }
    if (!report.seeds.empty()) {
      write_text_file(path_in(options_, "crossval.json"), crossval_json(report));
      write_text_file(path_in(options_, "crossval.csv"), crossval_csv(report));
      write_text_file(path_in(options_, "crossval.md"), crossval_markdown(report));
    }
    return report;
  }

  void add_run(const std::string& path, std::map<uint64_t, CrossvalSeed>* seeds) const {
    const std::vector<uint8_t> bytes = read_file(path);
    try {
      const Json json = Json::parse(bytes.begin(), bytes.end());
      const auto fold = json.at("fold").get<uint32_t>();
      std::map<std::string, CrossvalFamily> families;
      for (const Json& row : json.at("characters")) {
        CrossvalFamily& family = families[row.at("family").get<std::string>()];
        family.family = row.at("family").get<std::string>();
        family.group = options_.groups.group(family.family);
        family.fold = fold;
        ++family.characters;
        CrossvalFigures& f = family.figures;
        f.l1 += row.at("l1").get<double>();
        f.argmax += row.at("argmax").get<double>();
        f.distance += row.at("distance").get<double>();
        f.heat_l1 += row.at("heat_l1").get<double>();
        f.heat_argmax += row.at("heat_argmax").get<double>();
        f.heat_distance += row.at("heat_distance").get<double>();
      }
      CrossvalSeed& seed = (*seeds)[json.at("seed").get<uint64_t>()];
      for (auto& [name, family] : families) {
        const auto n = static_cast<double>(family.characters);
        CrossvalFigures& f = family.figures;
        for (double* figure : {&f.l1, &f.argmax, &f.distance, &f.heat_l1, &f.heat_argmax, &f.heat_distance})
          *figure /= n;
        (fold > 0 ? seed.families : seed.val).push_back(family);
      }
    } catch (const nlohmann::json::exception& error) {
      throw Error(path + ": expected figures of a fold (" + error.what() + "); remove it and --resume");
    }
  }

  TrainConfig config_;
  CrossvalOptions options_;
  std::vector<std::vector<std::string>> folds_;
  std::vector<Job> all_jobs_;
};

}  // namespace

CrossvalReport crossval(const TrainConfig& config, const CrossvalOptions& options) {
  CrossvalOptions checked = options;
  checked.threads = std::max(1u, options.threads);
  return Crossval(config, checked).run();
}

}  // namespace sinew
