// SPDX-License-Identifier: MIT
// The sinew command: reads the command line, runs one subcommand, turns every failure into one line and an exit status.
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
#include <exception>
#include <iterator>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "sinew/sinew.h"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/ranks.hpp"
#include "support.hpp"

namespace {

int fail(const std::string& text, int status) {
  std::fflush(stdout);
  std::fprintf(stderr, "sinew: error: %s\n", sinew::cli::printable(text).c_str());
  return status;
}

// The deepest subcommand on the command line, for "see sinew ... --help".
std::string chosen_command(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* sub : app.get_subcommands()) name += " " + chosen_command(*sub);
  return name;
}

std::string see_help(const CLI::App& app) { return "; see " + chosen_command(app) + " --help"; }

// Wrong usage and a failure that the ranks of mpirun share are the same on all of them: only the first says it. The
// others end without complaint, or mpirun might kill the first before it has spoken.
bool repeated(const std::vector<std::string>& words) {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  if (rank == nullptr) rank = std::getenv("PMI_RANK");
  return !words.empty() && words[0] == "train" && rank != nullptr && std::string(rank) != "0";
}

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

// What is wrong with a command line, and what to do about it.
std::string complaint(const CLI::App& app, const std::vector<std::string>& words, const std::string& error) {
  return unknown_command(app, words).value_or(plain_bound(error)) + see_help(app);
}

// `sinew eval DIR` is `sinew eval weights DIR`.
std::vector<std::string> whole_words(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2 || words[0] != "eval" || words[1] == "--help" || words[1] == "-h" || words[1] == "--help-all")
    return words;
  const auto named = [&](const CLI::App* study) { return study->get_name() == words[1]; };
  if (app.get_subcommand("eval")->get_subcommands(named).empty()) words.insert(words.begin() + 1, "weights");
  return words;
}

// The options of all commands are a millisecond of the program's start, so only the one that is asked for declares its own; all do for
// the list of them, and to say that a word is none.
void add_commands(const std::string& first_word, CLI::App& app) {
  using namespace sinew::cli;
  struct Command {
    const char* name;
    void (*add)(CLI::App&);
  };
  constexpr Command kCommands[] = {{"rig", add_rig},           {"bind", add_bind},         {"transfer", add_transfer},
                                   {"eval", add_eval},         {"train", add_train},       {"crossval", add_crossval},
                                   {"quantize", add_quantize}, {"dataset", add_dataset},   {"inspect", add_inspect},
                                   {"pose", add_pose},         {"simplify", add_simplify}, {"lod", add_lod},
                                   {"map", add_map},           {"animate", add_animate},   {"bake", add_bake},
                                   {"check", add_check},       {"serve", add_serve}};
  const auto asked = [&](const Command& command) { return command.name == first_word; };
  const bool all = first_word != "--version" && std::none_of(std::begin(kCommands), std::end(kCommands), asked);
  for (const Command& command : kCommands)
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

}  // namespace

int main(int argc, char** argv) {
  prepare_heap();
  CLI::App app("Binds character meshes to their skeletons with a small int16 network.", "sinew");
  app.formatter(sinew::cli::help_text());
  app.set_help_flag("-h,--help", "Print one screen of help");
  app.set_help_all_flag("--help-all", "Print every option with all details");
  app.set_version_flag("--version", std::string("sinew ") + sinew_version(), "Print the version");
  app.require_subcommand(1);
  app.footer(
      "Example:\n  sinew bind hero.obj --skeleton hero.rig.txt -o hero.glb --png hero.png\n"
      "Every subcommand has its own --help. Exit status: 0 done, 1 the job failed, 2 wrong usage,\n"
      "3 done, but --gate found it wanting.\n"
      "SINEW_KERNEL=ref|avx2|avxvnni|vnni in the environment chooses the instructions; results never\n"
      "depend on it.");
  add_commands(argc > 1 ? argv[1] : "", app);
  const std::vector<std::string> words = whole_words(app, argc, argv);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // runs the chosen subcommand's callback
  } catch (const CLI::Success& done) {
    return app.exit(done);  // --help, --version
  } catch (const CLI::ParseError& error) {
    return repeated(words) ? 0 : fail(complaint(app, words, error.what()), 2);
  } catch (const sinew::cli::UsageError& error) {
    return repeated(words) ? 0 : fail(error.what() + see_help(app), 2);
  } catch (const sinew::cli::GateError& error) {
    return fail(error.what(), 3);
  } catch (const sinew::RanksError& error) {
    return repeated(words) ? 0 : fail(error.what(), 1);
  } catch (const sinew::Error& error) {
    return fail(error.what(), 1);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
  return 0;
}
