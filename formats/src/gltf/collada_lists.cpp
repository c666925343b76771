// SPDX-License-Identifier: MIT
#include "gltf/collada_lists.hpp"

#include <algorithm>
#include <string_view>

#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

bool is_list(std::string_view name) { return name == "p" || name == "h" || name == "v" || name == "vcount"; }

bool holds_lists(std::string_view name) { return name == "library_geometries" || name == "library_controllers"; }

// Where the tag that begins at `at` ends: at its '>', which a quoted value may have as well.
size_t end_of_tag(std::string_view text, size_t at) {
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0)
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      break;
  }
  return at;
}

}  // namespace

void check_collada_lists(const std::string& path, const std::vector<uint8_t>& file) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  bool inside = false;
  for (size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    if (text.substr(at, 4) == "<!--") {
      at = std::min(text.find("-->", at + 4), text.size() - 1);
      continue;
    }
    const bool closes = text.substr(at, 2) == "</";
    const size_t first = at + (closes ? 2 : 1);
    const std::string_view name = text.substr(first, text.find_first_of(" \t\r\n/>", first) - first);
    if (holds_lists(name)) inside = !closes;
    const size_t end = end_of_tag(text, first);
    if (!inside || closes || !is_list(name) || end == text.size() || text[end - 1] == '/') continue;
    const size_t wrong = text.find_first_not_of("0123456789+- \t\r\n", end + 1);
    if (wrong == std::string_view::npos || text[wrong] == '<') continue;
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(wrong), '\n');
    throw Error(path + ":" + std::to_string(line) + ": expected whole numbers in <" + std::string(name) + ">, found " +
                in_quotes(text.substr(wrong, 1)) + "; export it again");
  }
}

}  // namespace sinew
