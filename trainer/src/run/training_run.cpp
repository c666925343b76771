// SPDX-License-Identifier: MIT
// Draws samples, steps, validates against the baseline, keeps the best weights and everything needed to go on.
#include "run/training_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <numeric>
#include <sstream>

#include "core/random.hpp"
#include "network/networks.hpp"
#include "run/optimizer.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/family_groups.hpp"

namespace sinew {
namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ValScore mean_scores(const std::vector<const NetworkSample*>& samples, const std::vector<double>& scores) {
  ValScore result;
  std::map<std::string, std::pair<double, size_t>> families;
  for (size_t i = 0; i < samples.size(); ++i) {
    result.samples += scores[i] / static_cast<double>(samples.size());
    auto& [sum, count] = families[samples[i]->family];
    sum += scores[i];
    ++count;
  }
  for (const auto& [name, family] : families) {
    result.families += family.first / static_cast<double>(family.second) / static_cast<double>(families.size());
  }
  return result;
}

void require_same_kind(const FloatNetwork& from, const FloatNetwork& to, const std::string& path) {
  const auto fail = [&](const std::string& what) {
    throw Error(path + ": cannot start from its weights: " + what + "; use the configuration it was trained with");
  };
  if (from.architecture != to.architecture) fail("it is a " + from.architecture + ", wanted is a " + to.architecture);
  if (from.task != to.task || from.input_names != to.input_names) fail("it is for another task");
  if (from.feature_set != to.feature_set) {
    fail("feature set " + std::to_string(from.feature_set) + ", wanted is " + std::to_string(to.feature_set));
  }
  if (from.candidate_count != to.candidate_count || from.grid_size != to.grid_size) {
    fail("made for " + std::to_string(from.candidate_count) + " candidates and grid " + std::to_string(from.grid_size) +
         ", wanted are " + std::to_string(to.candidate_count) + " and " + std::to_string(to.grid_size));
  }
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

// When to stop by a run's log: by the mean of some columns.
struct Course {
  size_t since_best = 0;  // lines behind the best one
  double last = 1e30;
};
Course course_of(const std::string& log, const std::vector<size_t>& columns) {
  std::istringstream lines(log);
  std::string line, cell;
  std::getline(lines, line);  // names
  Course course;
  double best = 1e30;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    double sum = 0;
    for (size_t column = 0; std::getline(cells, cell, ','); ++column)
      sum += std::count(columns.begin(), columns.end(), column) > 0 ? std::stod(cell) : 0;
    course.since_best = sum < best ? 0 : course.since_best + 1;
    best = std::min(best, sum);
    course.last = sum / static_cast<double>(columns.size());
  }
  return course;
}

}  // namespace

TrainingRun::TrainingRun(const TrainingTask& task, const RunConfig& config, const TrainOptions& options)
    : task_(task),
      config_(config),
      options_(options),
      items_(config.batch),
      main_(options.ranks == nullptr || options.ranks->rank() == 0) {
  options_.threads = std::max(options.threads, 1u);
  if (!main_) options_.quiet = true;
  recent_.assign(task.loss_names().size(), 0.0);
}

void TrainingRun::load(const TrainingItems& items) {
  for (uint32_t i = 0; i < items.choices.size(); ++i) {
    const std::vector<std::string>& out = options_.leave_out;
    if (std::find(out.begin(), out.end(), items.families[i]) != out.end()) continue;
    drawn_.push_back(items.choices[i]);
    families_.push_back(items.families[i]);
  }
  if (options_.ranks != nullptr) {
    uint64_t content = checkpoint_.state.step;
    for (const char c : checkpoint_.state.config_json) content = mix_seeds(content, static_cast<uint8_t>(c));
    for (const std::vector<const NetworkSample*>& choices : drawn_) {
      for (const NetworkSample* sample : choices)
        content = mix_seeds(content, sample->vertices, sample->candidate.size());
    }
    options_.ranks->require_same(content, "a configuration, checkpoint or characters");
  }
  if (drawn_.empty()) throw Error(options_.output + ": nothing to train on, every family is left out");
  val_ = items.validation;
  std::vector<double> baseline(val_.size());
  parallel_for(val_.size(), options_.threads,
               [&](size_t i, unsigned) { baseline[i] = task_.baseline_score(*val_[i]); });
  baseline_ = mean_scores(val_, baseline);
}

void TrainingRun::start() {
  const std::string config = task_.config_text();
  if (options_.resume) {
    checkpoint_ = read_checkpoint(options_.output);
    // Settings that came later than the checkpoint have their defaults.
    const std::string saved = task_.normalized_config(checkpoint_.state.config_json, options_.output);
    require_same_config(saved, config, options_.output);
    task_.check(checkpoint_.latest, options_.output);
    task_.check(checkpoint_.network, options_.output);
    return;
  }
  FloatNetwork network = task_.make_network();
  if (!options_.init.empty()) {
    const bool model = std::filesystem::path(options_.init).extension() == ".sinew";
    const FloatNetwork given =
        model ? read_model_network(options_.init, network) : read_checkpoint(options_.init).network;
    require_same_kind(given, network, options_.init);
    widen(given, options_.init, &network);
    task_.check(network, options_.init);
  }
  task_.prepare(&network);
  checkpoint_.latest = checkpoint_.network = network;
  if (config_.average_decay > 0) checkpoint_.state.averages = {network};
  if (config_.init_share > 0 && !options_.init.empty()) checkpoint_.state.averages.push_back(network);
  checkpoint_.state.config_json = config;
  checkpoint_.state.rng = {mix_seeds(config_.seed, 3)};
  std::string& log = checkpoint_.state.log_csv;
  log = "step,seconds";
  for (const std::string& name : task_.loss_names()) log += "," + name;
  const std::string score = task_.score_name(), baseline = task_.baseline_name() + "_";
  log += ",gradient_norm,learning_rate,val_" + score + ",val_family_" + score + "," + baseline + score + "," +
         baseline + "family_" + score + ",best\n";
}

void TrainingRun::go() {
  TrainingState& state = checkpoint_.state;
  if (options_.resume && (progress() >= 1 || !settled().empty())) {
    say_finished();
    return;
  }
  const double started = seconds_now() - state.seconds;
  const uint64_t first_step = state.step;
  uint64_t steps_left = options_.stop_after;
  bool validated = false;
  gradient_ = std::make_unique<BatchGradient>(task_, config_, options_.threads, options_.ranks);
  agree();
  while (progress() < 1 && settled().empty() && !stopping_ && (options_.stop_after == 0 || steps_left-- > 0)) {
    const double rate = config_.learning_rate * schedule(progress());
    step(rate);
    state.seconds = seconds_now() - started;
    agree();
    validated = state.step % config_.validate_every == 0;
    if (validated) validate(rate);
    show(rate, validated);
  }
  if (!validated && (progress() >= 1)) validate(config_.learning_rate * schedule(1));
  save();
  if (!options_.quiet && !settled().empty())
    std::fprintf(stderr, "%s%s: stopped at step %llu\n", options_.label.c_str(), settled().c_str(),
                 static_cast<unsigned long long>(state.step));
  if (!options_.quiet && options_.label.empty()) std::fprintf(stderr, "\n");
  show_speed(state.step - first_step);
}

// A resumed run whose time or steps are used up is left as it is.
void TrainingRun::say_finished() const {
  if (options_.quiet) return;
  char text[240];
  const std::string why = settled();
  if (!why.empty()) {
    std::snprintf(text, sizeof text, "%s; use --init to train on from its weights", why.c_str());
  } else if (options_.minutes > 0) {
    std::snprintf(text, sizeof text, "its %.4g minutes are used up (%.1f spent, %llu steps); give more --minutes",
                  options_.minutes, checkpoint_.state.seconds / 60,
                  static_cast<unsigned long long>(checkpoint_.state.step));
  } else {
    std::snprintf(text, sizeof text, "all %llu steps are done; use --init to train on from its weights",
                  static_cast<unsigned long long>(config_.steps));
  }
  std::fprintf(stderr, "%s%s: nothing to do: %s\n", options_.label.c_str(), options_.output.c_str(), text);
}

// All ranks use rank 0's clock, and all stop when one gets a signal.
void TrainingRun::agree() {
  std::vector<double> shared = {options_.stop != nullptr && options_.stop->load() ? 1.0 : 0.0,
                                main_ ? checkpoint_.state.seconds : 0.0};
  if (options_.ranks != nullptr) options_.ranks->maximum(&shared);
  stopping_ = shared[0] > 0;
  checkpoint_.state.seconds = shared[1];
}

// How well threads and ranks were used: processor time against the time that passed; and, apart from what else the
// machine does, against that of the busiest thread of every step.
void TrainingRun::show_speed(uint64_t steps) {
  const uint32_t ranks = options_.ranks == nullptr ? 1 : options_.ranks->size();
  std::vector<double> work = {gradient_->team().work_seconds()}, busiest = {gradient_->team().busiest_seconds()};
  if (ranks > 1) {
    work = options_.ranks->gather(work, std::vector<size_t>(ranks, 1));
    options_.ranks->maximum(&busiest);
  }
  if (options_.quiet || steps == 0 || ranks * options_.threads == 1 || options_.threads_now != nullptr) return;
  const double total = std::accumulate(work.begin(), work.end(), 0.0), wall = gradient_->wall_seconds();
  const double even = total / std::max(ranks * options_.threads * busiest[0], 1e-9);
  std::fprintf(stderr,
               "%s%u rank%s x %u thread%s: %llu steps in %.1f s, %.1f s of processor time: %.2f times as fast as one, "
               "shared out to %.0f %%\n",
               options_.label.c_str(), ranks, ranks == 1 ? "" : "s", options_.threads, options_.threads == 1 ? "" : "s",
               static_cast<unsigned long long>(steps), wall, total, total / std::max(wall, 1e-9), 100 * even);
}

uint32_t TrainingRun::threads() const {
  return options_.threads_now == nullptr ? options_.threads
                                         : std::clamp(options_.threads_now->load(), 1u, options_.threads);
}
// Share of the run that is done, by time when minutes are given.
double TrainingRun::progress() const {
  if (options_.minutes > 0) return checkpoint_.state.seconds / (60 * options_.minutes);
  return static_cast<double>(checkpoint_.state.step) / static_cast<double>(config_.steps);
}

// Why the run is over before its time, or nothing. By the log, which a resumed run has too.
std::string TrainingRun::settled() const {
  if (config_.patience == 0 && !(config_.stop_below > 0)) return "";  // asked before every step
  const std::vector<size_t> loss = {2};                               // behind step and seconds
  const size_t score = loss[0] + task_.loss_names().size() + 2;       // behind the losses, norm and rate
  const double now = course_of(checkpoint_.state.log_csv, loss).last;
  char text[160];
  if (config_.stop_below > 0 && now < config_.stop_below) {
    std::snprintf(text, sizeof text, "%s %.4g is below %.4g (stop_below)", task_.loss_names()[0].c_str(), now,
                  config_.stop_below);
    return text;
  }
  const std::vector<size_t> columns = val_.empty() ? loss : std::vector<size_t>{score, score + 1};
  const Course course = course_of(checkpoint_.state.log_csv, columns);
  const std::string what = val_.empty() ? task_.loss_names()[0] : task_.score_name();
  if (config_.patience == 0 || course.since_best < config_.patience) return "";
  std::snprintf(text, sizeof text, "%s has stopped falling (patience %u)", what.c_str(), config_.patience);
  return text;
}

const std::vector<const NetworkSample*>& TrainingRun::draw() {
  TrainingState& state = checkpoint_.state;
  if (state.queue.empty()) {
    Random random(state.rng.at(0));
    state.queue = draw_round(families_, config_.family_power, config_.family_shares, &random);
    state.rng[0] = random.state();
  }
  const uint32_t item = state.queue.back();
  state.queue.pop_back();
  if (item >= drawn_.size())
    throw Error(options_.output + ": cannot resume: the characters of the data folder have changed");
  return drawn_[item];
}

void TrainingRun::step(double rate) {
  TrainingState& state = checkpoint_.state;
  FloatNetwork& network = checkpoint_.latest;
  for (uint32_t i = 0; i < config_.batch; ++i) {
    const std::vector<const NetworkSample*>& choices = draw();
    items_[i].seed = mix_seeds(config_.seed, state.step, i);
    Random random(items_[i].seed);
    const bool variant = choices.size() > 1 && random.uniform() < config_.variant_share;
    items_[i].sample = choices[variant ? 1 + random.below(static_cast<uint32_t>(choices.size() - 1)) : 0];
  }
  std::vector<LinearBlock<float>> sum = gradient_->run(network, items_, threads(), &losses_);
  const double norm = clip_gradients(&sum, config_.clip);
  if (!std::isfinite(norm)) {
    throw Error(options_.output + ": the gradient is not finite at step " + std::to_string(state.step) + " (" +
                items_[0].sample->name + " ...); lower learning_rate");
  }
  optimizer_step(config_, rate, sum, &network, &state);
  ++state.step;
  if (config_.average_decay > 0) update_average(network, config_.average_decay, state.step, &state.averages[0]);
  for (const std::vector<double>& losses : losses_) {
    for (size_t i = 0; i < losses.size(); ++i) recent_[i] += losses[i];
    ++recent_count_;
  }
  recent_norm_ += norm * static_cast<double>(losses_.size());
}

void TrainingRun::validate(double rate) {
  TrainingState& state = checkpoint_.state;
  FloatNetwork candidate = task_.finished(config_.average_decay > 0 ? state.averages[0] : checkpoint_.latest);
  // Behind the running average, if there is one, lie the weights that the run started from.
  const size_t first = config_.average_decay > 0 ? 1 : 0;
  if (state.averages.size() > first) blend(state.averages[first], config_.init_share, &candidate);
  ValScore val;
  if (!val_.empty()) {
    val = mean_scores(val_, gradient_->scores(candidate, val_, threads()));
  }
  if (val_.empty() || val.mean() < state.best_score) {
    state.best_score = val_.empty() ? state.best_score : val.mean();
    checkpoint_.network = candidate;
  }
  last_val_ = val;
  const double n = static_cast<double>(std::max<size_t>(recent_count_, 1));
  const auto add = [&state](const char* format, double value) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    state.log_csv += text;
  };
  state.log_csv += std::to_string(state.step);
  add(",%.1f", state.seconds);
  for (const double sum : recent_) add(",%.6f", sum / n);
  add(",%.4f", recent_norm_ / n);
  add(",%.3e", rate);
  for (const double value : {val.samples, val.families, baseline_.samples, baseline_.families}) add(",%.5f", value);
  add(",%.5f\n", val_.empty() ? 0.0 : state.best_score);
  shown_loss_ = recent_[0] / n;
  recent_.assign(recent_.size(), 0.0);
  recent_count_ = 0;
  recent_norm_ = 0;
  save();
}

void TrainingRun::save() {
  if (!main_) return;
  write_checkpoint(options_.output, checkpoint_);
  write_text_file(options_.output + ".csv", checkpoint_.state.log_csv);
}

void TrainingRun::show(double rate, bool validated) {
  if (options_.quiet) return;
  const bool terminal = isatty(STDERR_FILENO) != 0 && options_.label.empty();
  if (!terminal && !validated) return;
  const TrainingState& state = checkpoint_.state;
  if (recent_count_ != 0) shown_loss_ = recent_[0] / static_cast<double>(recent_count_);
  const double done = std::max(progress(), 1e-9), left = state.seconds * (1 - std::min(done, 1.0)) / done;
  std::string bar(20, '.');
  std::fill_n(bar.begin(), static_cast<size_t>(std::min(done, 1.0) * 20), '#');
  std::string figures;
  if (!val_.empty() && last_val_.samples > 0) {
    const std::string name = task_.baseline_name();
    char text[160];
    std::snprintf(text, sizeof text, "  val %.4f (%s %.4f)  families %.4f (%s %.4f)", last_val_.samples, name.c_str(),
                  baseline_.samples, last_val_.families, name.c_str(), baseline_.families);
    figures = text;
  }
  std::fprintf(stderr, "%s%s[%s] step %llu  loss %.4f%s  rate %.1e  left %d:%02d%s", terminal ? "\r\033[K" : "",
               options_.label.c_str(), bar.c_str(), static_cast<unsigned long long>(state.step), shown_loss_,
               figures.c_str(), rate, static_cast<int>(left) / 60, static_cast<int>(left) % 60,
               terminal && !validated ? "" : "\n");
}

}  // namespace sinew
