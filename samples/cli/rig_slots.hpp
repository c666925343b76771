// SPDX-License-Identifier: MIT
// The published method in sinew rig and eval: which options it takes, its network, its skeletons.
#ifndef SINEW_CLI_RIG_SLOTS_HPP
#define SINEW_CLI_RIG_SLOTS_HPP

#include <string>

#include "sinew_character/jobs/rig_job.hpp"

namespace CLI {
class App;
}

namespace sinew::cli {

// --method and --class of sinew rig.
struct MethodOptions {
  std::string method = "auto", category = "any";
  bool slots() const { return method == "slots"; }
  // From the mesh alone, without a model.
  bool extracts() const { return method == "shape" || method == "regions"; }
  RigMethod job_method() const {
    return method == "shape"     ? RigMethod::kShape
           : method == "regions" ? RigMethod::kRegions
           : method == "slots"   ? RigMethod::kSlots
           : method == "votes"   ? RigMethod::kVotes
                                 : RigMethod::kAuto;
  }
};
void add_method_options(CLI::App* sub, MethodOptions* options);
// Throws UsageError for options that the method does not take. Called before any work.
void check_method(const CLI::App& sub, const MethodOptions& options);
// Number of a category that is one.
uint32_t category_number(const std::string& name);

}  // namespace sinew::cli
#endif
