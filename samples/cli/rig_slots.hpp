// SPDX-License-Identifier: MIT
// The published method in sinew rig and eval: which options it takes, its network, its skeletons.
#ifndef SINEW_CLI_RIG_SLOTS_HPP
#define SINEW_CLI_RIG_SLOTS_HPP

#include "sinew_character/jobs/rig_job.hpp"

namespace CLI {
class App;
}

namespace sinew::cli {

// --method and --class of sinew rig.
struct MethodOptions {
  RigMethod method = RigMethod::kAuto;
  uint32_t category = SINEW_CATEGORY_ANY;
  bool slots() const { return method == RigMethod::kSlots; }
  // From the mesh alone, without a model.
  bool extracts() const { return method == RigMethod::kShape || method == RigMethod::kRegions; }
};
void add_method_options(CLI::App* sub, MethodOptions* options);
// Throws UsageError for options that the method does not take. Called before any work.
void check_method(const CLI::App& sub, const MethodOptions& options);

}  // namespace sinew::cli
#endif
