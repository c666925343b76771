// SPDX-License-Identifier: MIT
// Commands and options that have another name now.
#ifndef SINEW_CLI_RETIRED_HPP
#define SINEW_CLI_RETIRED_HPP

#include <optional>
#include <string>
#include <vector>

namespace sinew::cli {

// What to write in place of a word that the parser's `error` complains about; nullopt where no row has it.
std::optional<std::string> retired_word(const std::vector<std::string>& words, const std::string& error);

}  // namespace sinew::cli
#endif
