// SPDX-License-Identifier: MIT
// One row a word; a command line that does not parse is searched for them.
#include "retired.hpp"

namespace sinew::cli {
namespace {

struct Retired {
  const char *command, *word;  // a command or one with its subcommand; no word: the command itself
  const char* value;           // nullptr: any; else one word that stands behind it
  const char* now;
};

constexpr Retired kRetired[] = {
    {"extract", nullptr, nullptr, "sinew rig MESH --method shape (or regions)"},
    {"rig", "--category", nullptr, "--class KIND"},
    {"bind", "--all-joints", nullptr, "--joints all"},
    {"bind", "--deform", nullptr, "--joints FILE"},
    {"bind", "--compare", nullptr, "--changes"},
    {"pose", "--dual-quaternion", nullptr, "--deform dual-quaternion"},
    {"pose", "--deform", "none", "--deform linear"},
    {"transfer", "--source-up", nullptr, "--from-up"},
    {"animate", "--motion-up", nullptr, "--from-up"},
    {"animate", "--report", nullptr, "--measure"},
    {"animate", "--from", nullptr, "--start"},
    {"animate", "--to", nullptr, "--end"},
    {"map", "--no-ends", nullptr, "--ends none"},
    {"quantize", "--confidence", nullptr, "--calibrate-confidence DIR"},
    {"crossval", "--from", nullptr, "--reuse RUN"},
    {"eval weights", "--task", "rig", "sinew eval rig DIR"},
    {"eval weights", "--task", "hands", "sinew eval hands DIR"},
    {"eval weights", "--task", nullptr, "sinew eval DIR, sinew eval rig DIR or sinew eval hands DIR"},
    {"eval weights", "--confidence", nullptr, "sinew eval confidence DIR"},
    {"eval weights", "--robustness", nullptr, "sinew eval robustness DIR"},
    {"eval weights", "--hints", nullptr, "sinew eval hints DIR --give KIND:PERCENT"},
    {"eval weights", "--style", nullptr, "sinew eval style DIR --questions N"},
    {"eval weights", "--questions", nullptr, "sinew eval questions DIR --questions N"},
    {"eval weights", "--bind", nullptr, "sinew eval rig DIR --bind"},
    {"eval weights", "--predictions", nullptr, "--save-predictions DIR"},
    {"eval weights", "--json", "-", "--json without a value, which prints; a file is written by -o FILE.json"},
    {"eval weights", "--json", nullptr, "-o FILE.json; --json without a value prints"},
    {"dataset", "--png", nullptr, "--pictures DIR"},
    {"dataset", "--picture", nullptr, "--picture-size N"},
    {"dataset", "--val", nullptr, "--val-share X"},
};

}  // namespace

std::optional<std::string> retired_word(const std::vector<std::string>& words, const std::string& error) {
  const auto complained = [&](const std::string& word) {
    return !word.empty() && error.find(word) != std::string::npos;
  };
  for (const Retired& one : kRetired) {
    if (words.empty() ||
        (words[0] != one.command && words[0] + " " + (words.size() > 1 ? words[1] : "") != one.command))
      continue;
    if (one.word == nullptr) return std::string(one.command) + " is now " + one.now;
    const std::string option = one.word;
    for (size_t i = 1; i < words.size(); ++i) {
      const bool joined = words[i].rfind(option + "=", 0) == 0;
      if (!joined && words[i] != option) continue;
      const std::string value = joined ? words[i].substr(option.size() + 1) : i + 1 < words.size() ? words[i + 1] : "";
      if ((one.value != nullptr && value != one.value) || !(complained(option) || complained(value))) continue;
      const bool told = one.value != nullptr && value != "-";
      return option + (told ? " " + value : "") + " is now " + one.now;
    }
  }
  return std::nullopt;
}

}  // namespace sinew::cli
