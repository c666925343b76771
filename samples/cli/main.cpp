// SPDX-License-Identifier: MIT
// The sinew command: what users do with their own characters. sinew_lab.cpp has what trains and measures.
#include <string>
#include <vector>

#include "commands.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// Error for a command of sinew-lab.
std::vector<std::string> read_words(const CLI::App&, std::vector<std::string> words) {
  if (!words.empty() && is_lab_command(words[0]))
    throw UsageError(words[0] + " is a command of sinew-lab (training and evaluation): sinew-lab " + words[0] + " ...");
  return words;
}

const Program& sinew_program() {
  static const Program program = {
      "sinew",
      "Auto-rigging, skin weights and retargeting for character meshes.",
      "Example:\n  sinew rig hero.obj -o hero.glb --png hero.png\nExit status: 0 done, 1 failed, 2 wrong usage, 3 "
      "done but --gate failed. sinew-lab trains and evaluates.\nThe environment variable "
      "SINEW_KERNEL=ref|avx2|avxvnni|vnni selects the instructions; results are\nthe same for each.",
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
