// SPDX-License-Identifier: MIT
// The sinew-lab command: data sets, training, quantization and measurements.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>
#include <vector>

#include "commands.hpp"
#include "sinew_trainer/ranks.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// Wrong usage and a failure that the ranks of mpirun share are the same on all of them: only the first says it. The
// others end without complaint, or mpirun might kill the first before it has spoken.
bool is_reported_elsewhere(const std::vector<std::string>& words, const std::exception& error) {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  if (rank == nullptr) rank = std::getenv("PMI_RANK");
  const bool shared = dynamic_cast<const CLI::ParseError*>(&error) != nullptr ||
                      dynamic_cast<const UsageError*>(&error) != nullptr ||
                      dynamic_cast<const RanksError*>(&error) != nullptr;
  return shared && !words.empty() && words[0] == "train" && rank != nullptr && std::string(rank) != "0";
}

// `sinew-lab eval DIR` is `sinew-lab eval weights DIR`.
std::vector<std::string> read_words(const CLI::App& app, std::vector<std::string> words) {
  if (words.size() < 2 || words[0] != "eval" || words[1] == "--help" || words[1] == "-h" || words[1] == "--help-all")
    return words;
  const auto named = [&](const CLI::App* study) { return study->get_name() == words[1]; };
  if (app.get_subcommand("eval")->get_subcommands(named).empty()) words.insert(words.begin() + 1, "weights");
  return words;
}

const Program& lab_program() {
  static const Program program = {"sinew-lab",
                                  "Train, quantize and evaluate the networks of sinew.",
                                  "Example:\n  sinew-lab train characters/train --val characters/val -o studio.ckpt "
                                  "--minutes 30\nExit status: 0 done, 1 failed, 2 wrong usage.",
                                  {{"train", add_train},
                                   {"crossval", add_crossval},
                                   {"quantize", add_quantize},
                                   {"dataset", add_dataset},
                                   {"eval", add_eval}},
                                  read_words,
                                  is_reported_elsewhere};
  return program;
}

}  // namespace
}  // namespace sinew::cli

int main(int argc, char** argv) { return sinew::cli::run_program(sinew::cli::lab_program(), argc, argv); }
