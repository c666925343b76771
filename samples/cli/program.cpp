// SPDX-License-Identifier: MIT
// Reads the command line, runs one of the subcommands, reports every failure as one line and an exit status.
#include <CLI/CLI.hpp>
#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>

#include "commands.hpp"
#include "sinew/sinew.h"
#include "sinew_formats/error.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

int fail(const std::string& program, const std::string& text, int status) {
  std::fflush(stdout);
  std::fprintf(stderr, "%s: error: %s\n", program.c_str(), printable(text).c_str());
  return status;
}

// The deepest subcommand on the command line, for "see sinew ... --help".
std::string chosen_command(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* sub : app.get_subcommands()) name += " " + chosen_command(*sub);
  return name;
}

std::string see_help(const CLI::App& app) { return "; see " + chosen_command(app) + " --help"; }

// CLI11 says of a wrong first word only that a subcommand is missing.
std::optional<std::string> unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* level = &app;
  while (!level->get_subcommands().empty()) level = level->get_subcommands().front();
  const size_t depth = level == &app ? 0 : 1;
  if (level->get_subcommands([](const CLI::App*) { return true; }).empty()) return std::nullopt;
  if (words.size() <= depth || words[depth][0] == '-') return std::nullopt;
  return "no such command: " + std::string(level == &app ? "" : level->get_name() + " ") + words[depth];
}

// CLI::PositiveNumber names the largest double, 309 digits long.
std::string plain_bound(std::string error) {
  const std::string endless = " not in range 0.000000 to 17976931348623157";
  const size_t at = error.find(endless);
  if (at == std::string::npos) return error;
  const size_t end = error.find_first_not_of("0123456789.", at + endless.size());
  return error.replace(at, (end == std::string::npos ? error.size() : end) - at, ", expected a number above 0");
}

// The error of a command line, and its remedy.
std::string complaint(const CLI::App& app, const std::vector<std::string>& words, const std::string& error) {
  return unknown_command(app, words).value_or(plain_bound(error)) + see_help(app);
}

// The options of all commands are a millisecond of the program's start, so only the requested command declares its
// own; all do for the list of commands and for an unknown word.
void add_commands(const std::vector<Command>& commands, const std::string& first_word, CLI::App& app) {
  const auto asked = [&](const Command& command) { return command.name == first_word; };
  const bool all = first_word != "--version" && std::none_of(commands.begin(), commands.end(), asked);
  for (const Command& command : commands)
    if (all || asked(command)) command.add(app);
}

// Page faults of 4 KiB each are a third of a bind's time. The heap keeps what it once had, and Linux is asked for pages of 2 MiB for its
// first part.
void prepare_heap() {
#ifdef __GLIBC__
  constexpr uintptr_t kLargePage = 2 << 20, kFirstPart = 64 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, kFirstPart);
  void* const block = std::malloc(1 << 20);  // makes the heap grow
  const uintptr_t first = (reinterpret_cast<uintptr_t>(block) + kLargePage - 1) / kLargePage * kLargePage;
  const uintptr_t end = reinterpret_cast<uintptr_t>(sbrk(0));
  if (block != nullptr && end > first && end - first <= 2 * kFirstPart)
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  std::free(block);
#endif
}

// The exit status of a failure, and its line where no other process reports it.
int report(const Program& program, const std::vector<std::string>& words, const std::exception& error,
           const std::string& text, int status) {
  const bool elsewhere = program.is_reported_elsewhere != nullptr && program.is_reported_elsewhere(words, error);
  return elsewhere ? 0 : fail(program.name, text, status);
}

}  // namespace

int run_program(const Program& program, int argc, char** argv) {
  prepare_heap();
  CLI::App app(program.description, program.name);
  app.formatter(help_text());
  app.set_help_flag("-h,--help", "Print one screen of help");
  app.set_help_all_flag("--help-all", "Print every option with all details");
  app.set_version_flag("--version", program.name + " " + sinew_version(), "Print the version");
  app.require_subcommand(1);
  app.footer(program.footer);
  add_commands(program.commands, argc > 1 ? argv[1] : "", app);
  std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (program.read_words != nullptr) words = program.read_words(app, words);
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // runs the chosen subcommand's callback
  } catch (const CLI::Success& done) {
    return app.exit(done);  // --help, --version
  } catch (const CLI::ParseError& error) {
    return report(program, words, error, complaint(app, words, error.what()), 2);
  } catch (const UsageError& error) {
    return report(program, words, error, error.what() + see_help(app), 2);
  } catch (const GateError& error) {
    return report(program, words, error, error.what(), 3);
  } catch (const std::bad_alloc& error) {
    return report(program, words, error, "out of memory", 1);
  } catch (const std::exception& error) {
    return report(program, words, error, error.what(), 1);
  }
  return 0;
}

}  // namespace sinew::cli
