// SPDX-License-Identifier: MIT
// The sinew command's options as a whole: one meaning a name, help on one screen.
#include <map>
#include <regex>

#include "cli_fixture.hpp"

namespace sinew {
namespace {

constexpr size_t kLines = 40, kColumns = 100;

struct OptionText {
  std::string value, meaning;  // FILE; the first sentence
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Without the usual value, "(required)" and the choices, which may differ.
std::string first_sentence(std::string text) {
  text = text.substr(0, text.find(". "));
  return std::regex_replace(text, std::regex(" *(\\[[^\\]]*\\]|\\(required\\))$"), "");
}

// The options of every command, as `sinew --help-all` prints them.
using Commands = std::map<std::string, std::map<std::string, OptionText>>;
Commands commands_of(const std::string& help) {
  Commands commands;
  std::string command, name, value, text;
  const auto keep = [&] {
    if (!name.empty()) commands[command][name] = {value, first_sentence(text)};
    name.clear();
  };
  const std::regex option("  ((?:-[a-z],)?(?:[a-z]+,)?--[a-z0-9-]+[a-z0-9,!-]*)((?: [^ ]+)*)(?:  +(.*))?");
  for (const std::string& line : lines_of(help)) {
    std::smatch match;
    if (line.rfind("Usage: ", 0) == 0) {
      keep();
      command = line.substr(7, std::min(line.find(" [OPTIONS]"), line.size()) - 7);
      command = std::regex_replace(command, std::regex(" [\\[A-Z].*"), "");
      commands[command];
    } else if (std::regex_match(line, match, option)) {
      keep();
      name = match[1].str();
      name = name.substr(name.find("--"));
      value = match[2].str();
      text = match[3].str();
    } else if (line.rfind(std::string(20, ' '), 0) == 0) {
      text += (text.empty() ? "" : " ") + line.substr(line.find_first_not_of(' '));
    } else {
      keep();
    }
  }
  keep();
  return commands;
}

class CliOptions : public Cli {};

TEST_F(CliOptions, ANameMeansTheSameInEveryCommand) {
  const Commands commands = commands_of(good("--help-all").out + good("lab --help-all").out);
  EXPECT_GT(commands.size(), 28u);
  std::map<std::string, std::pair<std::string, OptionText>> first;
  size_t uses = 0;
  for (const auto& [command, options] : commands) {
    for (const auto& [name, text] : options) {
      ++uses;
      const auto [other, is_new] = first.emplace(name, std::pair(command, text));
      if (is_new || name == "--gate") continue;  // of check with bounds of the user's own, of rig with built-in ones
      EXPECT_EQ(text.meaning, other->second.second.meaning)
          << name << " of " << command << " and of " << other->second.first;
      EXPECT_EQ(text.value, other->second.second.value)
          << name << " of " << command << " and of " << other->second.first;
    }
  }
  EXPECT_GT(uses, 220u) << "options were found";
  EXPECT_GT(first.size(), 120u);
}

TEST_F(CliOptions, HelpFitsAScreen) {
  for (const auto& [command, options] : commands_of(good("--help-all").out)) {
    const std::string words = command.substr(std::min(command.size(), std::string("sinew ").size()));
    const std::vector<std::string> lines = lines_of(good(words + " --help").out);
    EXPECT_LE(lines.size(), kLines) << command;
    for (const std::string& line : lines) EXPECT_LE(line.size(), kColumns) << command << ": " << line;
    EXPECT_NE(lines.back().find(command + " --help-all"), std::string::npos) << lines.back();
    // Everything else is told by --help-all.
    const std::string all = good(words + " --help-all").out;
    for (const auto& [name, text] : options) EXPECT_NE(all.find(name), std::string::npos) << command;
    for (const std::string& line : lines_of(all)) EXPECT_LE(line.size(), kColumns) << command << ": " << line;
  }
}

TEST_F(CliOptions, EvalOfAFolderMeasuresWeights) {
  fs::create_directories(folder_ / "rig");
  for (const char* file : {"snake__long.obj", "snake__long.rig.txt"}) fs::copy(kData + "/" + file, folder_ / "rig");
  const auto table = [&](const std::string& arguments) {  // without the seconds in its last two columns
    return std::regex_replace(good(arguments).out, std::regex(" [0-9.]+ \\| [0-9.]+ \\|\n"), "\n");
  };
  const std::string expected = table("eval weights rig --method nearest");
  EXPECT_EQ(table("eval --method nearest ./rig"), expected);
  EXPECT_EQ(table("eval ./rig --method nearest"), expected);
  bad(2, "eval rig --method nearest");
  bad(1, "eval nowhere --method nearest");
}

}  // namespace
}  // namespace sinew
