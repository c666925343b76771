// SPDX-License-Identifier: MIT
// Tools of a server: commands with the arguments that a program may give them, as JSON Schema and as a command line.
#ifndef SINEW_CLI_TOOLS_HPP
#define SINEW_CLI_TOOLS_HPP

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "serve/served_folder.hpp"

namespace sinew::cli {

using OrderedJson = nlohmann::ordered_json;

// The tools with their schemas, as the Model Context Protocol lists them.
OrderedJson tools_json();

// A call: the words of a command line, run in the served folder.
struct ToolRun {
  std::vector<std::string> words;    // without the program
  std::vector<std::string> outputs;  // names of files that it writes, below the folder
  bool json = false;                 // it prints JSON
};

// Throws Error with one line for an unknown tool, and for arguments that it has not, that are missing, of another type or that no
// file of the folder goes with.
ToolRun tool_run(const std::string& tool, const OrderedJson& arguments, const ServedFolder& folder);

}  // namespace sinew::cli
#endif
