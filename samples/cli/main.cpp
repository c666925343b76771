// SPDX-License-Identifier: MIT
// The sinew command: what users do with their own characters. sinew_lab.cpp has what trains and measures.
#include <string>
#include <vector>

#include "commands.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// A command of sinew-lab says where it is.
std::vector<std::string> read_words(const CLI::App&, std::vector<std::string> words) {
  if (!words.empty() && is_lab_command(words[0]))
    throw UsageError(words[0] + " is a command of sinew-lab, which trains and measures: sinew-lab " + words[0] +
                     " ...");
  return words;
}

const Program& sinew_program() {
  static const Program program = {
      "sinew",
      "Rigs, binds and animates characters with small int16 networks.",
      "Example:\n  sinew bind hero.obj --skeleton hero.rig.txt -o hero.glb --png hero.png\n"
      "Every subcommand has its own --help. Exit status: 0 done, 1 the job failed, 2 wrong usage,\n"
      "3 done, but --gate found it wanting. sinew-lab trains and measures.\n"
      "SINEW_KERNEL=ref|avx2|avxvnni|vnni in the environment chooses the instructions; results never\n"
      "depend on it.",
      {{"rig", add_rig},
       {"bind", add_bind},
       {"transfer", add_transfer},
       {"inspect", add_inspect},
       {"pose", add_pose},
       {"simplify", add_simplify},
       {"lod", add_lod},
       {"map", add_map},
       {"animate", add_animate},
       {"springs", add_springs},
       {"bake", add_bake},
       {"check", add_check},
       {"serve", add_serve}},
      read_words};
  return program;
}

}  // namespace
}  // namespace sinew::cli

int main(int argc, char** argv) { return sinew::cli::run_program(sinew::cli::sinew_program(), argc, argv); }
