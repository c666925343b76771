// SPDX-License-Identifier: MIT
// Text in tables of Markdown.
#ifndef SINEW_TRAINER_CORE_MARKDOWN_HPP
#define SINEW_TRAINER_CORE_MARKDOWN_HPP

#include <string>

namespace sinew {

// A bar would end the cell.
inline std::string markdown_cell(std::string text) {
  for (size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

}  // namespace sinew
#endif
