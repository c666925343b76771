// SPDX-License-Identifier: MIT
// Pieces of a page that needs nothing else: text, tables and pictures inside one HTML file, readable on a phone, in the
// dark and on paper.
#ifndef SINEW_CHARACTER_HTML_HPP
#define SINEW_CHARACTER_HTML_HPP

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace sinew::html {

std::string escape(const std::string& text);   // for text and attribute values
std::string number(double value, int digits);  // fixed, no thousands separators
std::string count(size_t value);               // with thin spaces between thousands
// Color of a series in plots and keys; there are eight, further ones start over.
std::string color(size_t series);
// <img> with the PNG inside; `lazy` pictures are decoded when they come into view.
std::string image(const std::vector<uint8_t>& png, const std::string& alt, bool lazy = false);
// A row of colored keys.
std::string legend(const std::vector<std::string>& labels);
// Definition list of (term, fact), nothing for an empty list.
std::string facts(const std::vector<std::pair<std::string, std::string>>& list);
// A heading with a framed box below it; `note` is a paragraph between them, plain text.
std::string card(const std::string& heading, const std::string& content, const std::string& note = "");
// The whole document around the body.
std::string page(const std::string& title, const std::string& body);

// Rows of cells under headings.
struct Column {
  std::string heading;
  bool text = false;  // left-aligned words instead of numbers
};
struct Cell {
  std::string text;     // escaped by the table unless `markup`
  bool best = false;    // bold
  bool markup = false;  // already HTML
};
std::string table(const std::vector<Column>& columns, const std::vector<std::vector<Cell>>& rows);

}  // namespace sinew::html
#endif
