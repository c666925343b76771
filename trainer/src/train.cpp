// SPDX-License-Identifier: MIT
// The training run: draws characters, steps, validates against heat, keeps the best weights and everything needed to go
// on.
#include "sinew_trainer/train.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numeric>

#include "family_queue.hpp"
#include "features/features.hpp"
#include "layer_runner.hpp"
#include "loss.hpp"
#include "networks.hpp"
#include "optimizer.hpp"
#include "parallel.hpp"
#include "random.hpp"
#include "sample_cache.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

constexpr uint32_t kKeep = 4;  // influences per vertex that validation counts: the default of a bind

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct ValScore {
  double l1 = 0, family_l1 = 0;  // mean over characters, mean over families
  double mean() const { return 0.5 * (l1 + family_l1); }
};
ValScore score(const std::vector<Sample>& samples, const std::vector<double>& l1) {
  ValScore result;
  std::map<std::string, std::pair<double, size_t>> families;
  for (size_t i = 0; i < samples.size(); ++i) {
    result.l1 += l1[i] / static_cast<double>(samples.size());
    auto& [sum, count] = families[samples[i].family];
    sum += l1[i];
    ++count;
  }
  for (const auto& [name, family] : families) {
    result.family_l1 += family.first / static_cast<double>(family.second) / static_cast<double>(families.size());
  }
  return result;
}

void require_same_shape(const FloatNetwork& from, const FloatNetwork& to, const std::string& path) {
  const auto fail = [&](const std::string& what) {
    throw Error(path + ": cannot start from its weights: " + what + "; use the configuration it was trained with");
  };
  if (from.architecture != to.architecture) fail("it is a " + from.architecture + ", wanted is a " + to.architecture);
  if (from.feature_set != to.feature_set) {
    fail("feature set " + std::to_string(from.feature_set) + ", this program has " + std::to_string(to.feature_set));
  }
  if (from.candidate_count != to.candidate_count || from.grid_size != to.grid_size) {
    fail("made for " + std::to_string(from.candidate_count) + " candidates and grid " + std::to_string(from.grid_size) +
         ", wanted are " + std::to_string(to.candidate_count) + " and " + std::to_string(to.grid_size));
  }
  bool same = from.parameters.size() == to.parameters.size() && from.layers.size() == to.layers.size();
  for (size_t i = 0; same && i < to.parameters.size(); ++i) {
    same = from.parameters[i].in == to.parameters[i].in && from.parameters[i].out == to.parameters[i].out;
  }
  if (!same) fail("its layers have other shapes");
}

// Names the settings that differ, for a resume with another configuration.
void require_same_config(const std::string& saved, const std::string& given, const std::string& path) {
  if (saved == given) return;
  std::string lines;
  size_t a = 0, b = 0;
  while (a < saved.size() && b < given.size()) {
    const size_t a_end = saved.find('\n', a), b_end = given.find('\n', b);
    const std::string was = saved.substr(a, a_end - a), is = given.substr(b, b_end - b);
    if (was != is) {
      lines = "saved " + was.substr(was.find('"')) + " given " + is.substr(is.find('"'));
      break;
    }
    if (a_end == std::string::npos || b_end == std::string::npos) break;
    a = a_end + 1;
    b = b_end + 1;
  }
  throw Error(path + ": cannot resume with another configuration (" + lines +
              "); use --init to start a new run from its weights");
}

void drop_unlabelled(std::vector<Sample>* samples) {
  const auto unlabelled = [](const Sample& sample) {
    const bool labelled =
        std::any_of(sample.importance.begin(), sample.importance.end(), [](float i) { return i > 0; });
    if (!labelled) std::fprintf(stderr, "left out: %s: no vertex has reference weights\n", sample.name.c_str());
    return !labelled;
  };
  samples->erase(std::remove_if(samples->begin(), samples->end(), unlabelled), samples->end());
}

SampleSource sample_source(const TrainConfig& config, const TrainOptions& options) {
  SampleSource source;
  source.candidates = config.field.candidates;
  source.grid = config.field.grid;
  source.seed = config.seed;
  source.cache_dir = options.cache_dir.empty() ? options.output + ".cache" : options.cache_dir;
  source.threads = std::max(options.threads, 1u);
  source.quiet = options.quiet;
  return source;
}

class Run {
 public:
  Run(const TrainConfig& config, const TrainOptions& options) : config_(config), options_(options) {
    loss_ = {config.loss_kl, config.loss_l1, config.loss_regret, config.loss_part};
  }

  void load(const TrainingSet& set) {
    set_ = &set;
    for (uint32_t i = 0; i < set.characters.size(); ++i) {
      const std::vector<std::string>& out = options_.leave_out;
      if (std::find(out.begin(), out.end(), set.families[i]) != out.end()) continue;
      drawn_.push_back(i);
      families_.push_back(set.families[i]);
    }
    if (drawn_.empty()) throw Error(options_.output + ": nothing to train on, every family is left out");
    if (options_.val_dir.empty()) return;
    const SampleSource source = sample_source(config_, options_);
    val_ =
        load_samples(options_.val_dir, source.candidates, source.grid, source.cache_dir, source.threads, source.quiet);
    drop_unlabelled(&val_);
    std::vector<double> l1(val_.size());
    parallel_for(val_.size(), options_.threads,
                 [&](size_t i, unsigned) { l1[i] = sample_l1(val_[i], val_[i].heat, kKeep); });
    heat_ = score(val_, l1);
  }

  void start() {
    const std::string config_json = train_config_json(config_);
    if (options_.resume) {
      checkpoint_ = read_checkpoint(options_.output);
      require_same_config(checkpoint_.state.config_json, config_json, options_.output);
      check_network(checkpoint_.latest);
      check_network(checkpoint_.network);
      return;
    }
    FloatNetwork network = config_.architecture == "classic"
                               ? make_classic(config_.field.candidates, config_.field.grid, config_.seed)
                               : make_field(config_.field, config_.seed);
    if (!options_.init.empty()) {
      FloatNetwork given = read_checkpoint(options_.init).network;
      check_network(given);
      require_same_shape(given, network, options_.init);
      network = std::move(given);
    }
    checkpoint_.latest = checkpoint_.network = network;
    if (config_.average_decay > 0) checkpoint_.state.averages = {network};
    checkpoint_.state.config_json = config_json;
    checkpoint_.state.rng = {mix_seeds(config_.seed, 3)};
    checkpoint_.state.log_csv =
        "step,seconds,loss,l1,kl,regret,part,gradient_norm,learning_rate,val_l1,val_family_l1,heat_l1,heat_family_l1,"
        "best\n";
  }

  void go() {
    TrainingState& state = checkpoint_.state;
    if (options_.resume && progress() >= 1) {
      say_finished();
      return;
    }
    const double started = now() - state.seconds;
    uint64_t steps_left = options_.stop_after;
    bool validated = false;
    runners_.clear();
    for (uint32_t t = 0; t < options_.threads; ++t) runners_.push_back(std::make_unique<LayerRunner<float>>());
    slots_.resize(config_.batch);
    for (Slot& slot : slots_) slot.gradients = zero_blocks<float>(checkpoint_.latest);
    while (progress() < 1 && !stopped() && (options_.stop_after == 0 || steps_left-- > 0)) {
      const double rate = config_.learning_rate * schedule(progress());
      step(rate);
      state.seconds = now() - started;
      validated = state.step % config_.validate_every == 0;
      if (validated) validate(rate);
      show(rate, validated);
    }
    if (!validated && (progress() >= 1)) validate(config_.learning_rate * schedule(1));
    save();
    if (!options_.quiet && options_.label.empty()) std::fprintf(stderr, "\n");
  }

 private:
  struct Slot {
    const Sample* sample = nullptr;
    uint64_t seed = 0;
    std::vector<LinearBlock<float>> gradients;
    std::vector<float> d_logits;
    LossTerms terms;
  };

  // A resumed run whose time or steps are used up is left as it is.
  void say_finished() const {
    if (options_.quiet) return;
    char text[160];
    if (options_.minutes > 0) {
      std::snprintf(text, sizeof text, "its %.4g minutes are used up (%.1f spent, %llu steps); give more --minutes",
                    options_.minutes, checkpoint_.state.seconds / 60,
                    static_cast<unsigned long long>(checkpoint_.state.step));
    } else {
      std::snprintf(text, sizeof text, "all %llu steps are done; use --init to train on from its weights",
                    static_cast<unsigned long long>(config_.steps));
    }
    std::fprintf(stderr, "%s%s: nothing to do: %s\n", options_.label.c_str(), options_.output.c_str(), text);
  }

  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  uint32_t threads() const {
    return options_.threads_now == nullptr ? options_.threads
                                           : std::clamp(options_.threads_now->load(), 1u, options_.threads);
  }
  // Share of the run that is done, by time when minutes are given.
  double progress() const {
    if (options_.minutes > 0) return checkpoint_.state.seconds / (60 * options_.minutes);
    return static_cast<double>(checkpoint_.state.step) / static_cast<double>(config_.steps);
  }

  uint32_t draw() {
    TrainingState& state = checkpoint_.state;
    if (state.queue.empty()) {
      Random random(state.rng.at(0));
      state.queue = draw_round(families_, config_.family_power, &random);
      state.rng[0] = random.state();
    }
    const uint32_t character = state.queue.back();
    state.queue.pop_back();
    if (character >= drawn_.size())
      throw Error(options_.output + ": cannot resume: the data folder has other characters now");
    return drawn_[character];
  }

  void step(double rate) {
    TrainingState& state = checkpoint_.state;
    FloatNetwork& network = checkpoint_.latest;
    for (uint32_t i = 0; i < config_.batch; ++i) {
      const std::vector<Sample>& choices = set_->characters[draw()];
      slots_[i].seed = mix_seeds(config_.seed, state.step, i);
      Random random(slots_[i].seed);
      const bool variant = choices.size() > 1 && random.uniform() < config_.variant_share;
      slots_[i].sample = &choices[variant ? 1 + random.below(static_cast<uint32_t>(choices.size() - 1)) : 0];
    }
    // The largest first, so that the threads end at about the same time. Which thread does what changes no number.
    std::vector<size_t> order(slots_.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return slots_[a].sample->vertices > slots_[b].sample->vertices; });
    const std::vector<LinearBlock<float>> parameters = copy_blocks<float>(network);
    parallel_for(order.size(), threads(), [&](size_t item, unsigned thread) {
      Slot& slot = slots_[order[item]];
      DropoutOptions dropout;
      dropout.activations = static_cast<float>(config_.dropout);
      dropout.features = static_cast<float>(config_.feature_dropout);
      dropout.kept_pair_features = {kPairLogRule, kPairLogParts};
      dropout.seed = slot.seed;
      const std::vector<float>& logits = runners_[thread]->forward(network, parameters, *slot.sample, dropout);
      slot.terms = weight_loss(*slot.sample, loss_, logits, &slot.d_logits);
      for (LinearBlock<float>& block : slot.gradients) {
        std::fill(block.weights.begin(), block.weights.end(), 0.0f);
        std::fill(block.bias.begin(), block.bias.end(), 0.0f);
      }
      runners_[thread]->backward(network, parameters, slot.d_logits, &slot.gradients);
    });
    std::vector<LinearBlock<float>>& sum = slots_[0].gradients;
    const float share = 1.0f / static_cast<float>(config_.batch);
    for (size_t block = 0; block < sum.size(); ++block) {
      const auto mean = [&](auto member) {
        std::vector<float>& total = sum[block].*member;
        for (size_t i = 1; i < slots_.size(); ++i) {
          const std::vector<float>& other = slots_[i].gradients[block].*member;
          for (size_t k = 0; k < total.size(); ++k) total[k] += other[k];
        }
        for (float& g : total) g *= share;
      };
      mean(&LinearBlock<float>::weights);
      mean(&LinearBlock<float>::bias);
    }
    const double norm = clip_gradients(&sum, config_.clip);
    if (!std::isfinite(norm)) {
      throw Error(options_.output + ": the gradient is not finite at step " + std::to_string(state.step) + " (" +
                  slots_[0].sample->name + " ...); lower learning_rate");
    }
    optimizer_step(config_, rate, sum, &network, &state);
    ++state.step;
    if (!state.averages.empty()) update_average(network, config_.average_decay, state.step, &state.averages[0]);
    for (const Slot& slot : slots_) {
      recent_.total += slot.terms.total;
      recent_.l1 += slot.terms.l1;
      recent_.kl += slot.terms.kl;
      recent_.regret += slot.terms.regret;
      recent_.part += slot.terms.part;
      ++recent_count_;
    }
    recent_norm_ += norm * static_cast<double>(slots_.size());
  }

  void validate(double rate) {
    TrainingState& state = checkpoint_.state;
    const FloatNetwork candidate = shrink_correction(state.averages.empty() ? checkpoint_.latest : state.averages[0],
                                                     config_.correction, kPairLogRule);
    ValScore val;
    if (!val_.empty()) {
      const std::vector<LinearBlock<float>> parameters = copy_blocks<float>(candidate);
      std::vector<double> l1(val_.size());
      parallel_for(val_.size(), threads(), [&](size_t i, unsigned thread) {
        const std::vector<float>& logits = runners_[thread]->forward(candidate, parameters, val_[i], {});
        l1[i] = sample_l1(val_[i], softmax(val_[i], logits), kKeep);
      });
      val = score(val_, l1);
    }
    if (val_.empty() || val.mean() < state.best_score) {
      state.best_score = val_.empty() ? state.best_score : val.mean();
      checkpoint_.network = candidate;
    }
    last_val_ = val;
    char line[320];
    const double n = static_cast<double>(std::max<size_t>(recent_count_, 1));
    std::snprintf(line, sizeof line, "%llu,%.1f,%.5f,%.5f,%.5f,%.5f,%.5f,%.4f,%.3e,%.5f,%.5f,%.5f,%.5f,%.5f\n",
                  static_cast<unsigned long long>(state.step), state.seconds, recent_.total / n, recent_.l1 / n,
                  recent_.kl / n, recent_.regret / n, recent_.part / n, recent_norm_ / n, rate, val.l1, val.family_l1,
                  heat_.l1, heat_.family_l1, val_.empty() ? 0.0 : state.best_score);
    state.log_csv += line;
    shown_loss_ = recent_.total / n;
    recent_ = {};
    recent_count_ = 0;
    recent_norm_ = 0;
    save();
  }

  void save() {
    write_checkpoint(options_.output, checkpoint_);
    write_text_file(options_.output + ".csv", checkpoint_.state.log_csv);
  }

  void show(double rate, bool validated) {
    if (options_.quiet) return;
    const bool terminal = isatty(STDERR_FILENO) != 0 && options_.label.empty();
    if (!terminal && !validated) return;
    const TrainingState& state = checkpoint_.state;
    if (recent_count_ != 0) shown_loss_ = recent_.total / static_cast<double>(recent_count_);
    const double done = std::max(progress(), 1e-9), left = state.seconds * (1 - std::min(done, 1.0)) / done;
    std::string bar(20, '.');
    std::fill_n(bar.begin(), static_cast<size_t>(std::min(done, 1.0) * 20), '#');
    std::string figures;
    if (!val_.empty() && last_val_.l1 > 0) {
      char text[120];
      std::snprintf(text, sizeof text, "  val %.4f (heat %.4f)  families %.4f (heat %.4f)", last_val_.l1, heat_.l1,
                    last_val_.family_l1, heat_.family_l1);
      figures = text;
    }
    std::fprintf(stderr, "%s%s[%s] step %llu  loss %.4f%s  rate %.1e  left %d:%02d%s", terminal ? "\r\033[K" : "",
                 options_.label.c_str(), bar.c_str(), static_cast<unsigned long long>(state.step), shown_loss_,
                 figures.c_str(), rate, static_cast<int>(left) / 60, static_cast<int>(left) % 60,
                 terminal && !validated ? "" : "\n");
  }

  TrainConfig config_;
  TrainOptions options_;
  const TrainingSet* set_ = nullptr;
  LossWeights loss_;
  std::vector<uint32_t> drawn_;        // characters of *set_ that are not left out
  std::vector<std::string> families_;  // of drawn_
  std::vector<Sample> val_;
  ValScore heat_, last_val_;
  Checkpoint checkpoint_;
  std::vector<std::unique_ptr<LayerRunner<float>>> runners_;  // one per thread
  std::vector<Slot> slots_;                                   // one per character of a batch
  LossTerms recent_;                                          // sums since the last line of the log
  double recent_norm_ = 0, shown_loss_ = 0;
  size_t recent_count_ = 0;
};

}  // namespace

TrainingSet load_training_set(const TrainConfig& config, const TrainOptions& options) {
  const std::vector<std::string> paths = list_characters(options.data_dir);
  if (paths.empty()) throw Error(options.data_dir + ": no characters (NAME.obj with NAME.rig.txt, or .glb)");
  // Variants are optional extras: one that fails (say, because decimation leaves nothing) is only left out.
  std::vector<SampleRequest> requests;
  for (uint32_t variant = 0; variant <= (config.variant_share > 0 ? config.variants : 0); ++variant) {
    for (const std::string& path : paths) requests.push_back({path, variant});
  }
  for (const BodyPlan plan :
       {BodyPlan::kBiped, BodyPlan::kQuadruped, BodyPlan::kBird, BodyPlan::kSnake, BodyPlan::kManyLegged}) {
    // Far from the small seeds that people look at and test with.
    for (uint32_t i = 0; i < config.synthetic; ++i) requests.push_back({"", 0, plan, 1000 + i});
  }
  SampleSource source = sample_source(config, options);
  source.vertex_limit = config.vertex_limit;
  std::vector<Sample> samples = load_requests(requests, source);
  drop_unlabelled(&samples);
  TrainingSet set;
  std::map<std::string, size_t> by_name;
  for (Sample& sample : samples) {
    const auto [at, fresh] = by_name.try_emplace(sample.name, set.characters.size());
    if (fresh) {
      set.characters.emplace_back();
      set.families.push_back(sample.family);
    }
    set.characters[at->second].push_back(std::move(sample));
  }
  if (set.characters.empty()) throw Error(options.data_dir + ": no character has reference weights");
  return set;
}

namespace {

void run_with(const TrainConfig& config, const TrainOptions& options, const TrainingSet* set) {
  TrainOptions checked = options;
  checked.threads = std::max(options.threads, 1u);
  // Throws for what a file could not hold either, naming the key.
  parse_train_config(train_config_json(config), "configuration");
  Run run(config, checked);
  run.start();  // before the samples, so that a resume that does not fit fails at once
  TrainingSet loaded;
  if (set == nullptr) loaded = load_training_set(config, checked);
  run.load(set == nullptr ? loaded : *set);
  run.go();
}

}  // namespace

void train(const TrainConfig& config, const TrainOptions& options) { run_with(config, options, nullptr); }

void train(const TrainConfig& config, const TrainOptions& options, const TrainingSet& set) {
  run_with(config, options, &set);
}

TrainConfig checkpoint_config(const std::string& path) {
  return parse_train_config(read_checkpoint(path).state.config_json, path);
}

}  // namespace sinew
