// SPDX-License-Identifier: MIT
// Options of sinew rig for the method and the skeleton: edits, and a skeleton from a file.
#ifndef SINEW_CLI_RIG_OPTIONS_HPP
#define SINEW_CLI_RIG_OPTIONS_HPP

#include <memory>
#include <string>
#include <vector>

#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/predict/edit_skeleton.hpp"
#include "sinew_character/predict/own_skeleton.hpp"

namespace CLI {
class App;
}

namespace CLI {
class App;
class Option;
}  // namespace CLI

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

// --move, --add, --remove, --parent, --rename: each any number of times.
class EditOptions {
 public:
  explicit EditOptions(CLI::App* sub);  // declares them
  // As on the command line. Throws UsageError.
  std::vector<SkeletonEdit> in_order() const;

 private:
  struct One {
    EditKind kind;
    CLI::Option* option;
    std::shared_ptr<std::vector<std::string>> texts;
  };
  CLI::App* sub_;
  std::vector<One> options_;
};

// Throws UsageError for a template that does not exist and for a mesh. Called before any work.
void check_skeleton_source(const std::string& source);

}  // namespace sinew::cli
#endif
