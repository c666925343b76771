// SPDX-License-Identifier: MIT
// Style sheet, escaping and the small blocks that the report and the page of a data set are made of.
#include "sinew_character/page/html.hpp"

#include <algorithm>
#include <cstdio>

#include "sinew_formats/base64.hpp"
#include "sinew_formats/print.hpp"

namespace sinew::html {
namespace {

constexpr size_t kSeries = 8;  // colors of the style sheet

constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; --page: #f7f7f8; --card: #ffffff; --text: #1d2026; --soft: #5d6470; --rule: #dfe2e7; --warn: #b4561c;
  --s0: #2f6fde; --s1: #e0752b; --s2: #1f9e77; --s3: #b04ac0; --s4: #c9a21a; --s5: #d23f57; --s6: #4fb3c8; --s7: #7b7f8a; }
@media (prefers-color-scheme: dark) { :root { --page: #15171b; --card: #1e2127; --text: #e8eaee; --soft: #a0a7b4; --rule: #343943; --warn: #ffb27d;
  --s0: #6ea0ff; --s1: #ff9c57; --s2: #45c99d; --s3: #d886e6; --s4: #e6c44a; --s5: #ff7387; --s6: #7ad4e6; --s7: #a4a9b5; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--text); font: 15px/1.5 system-ui, "Segoe UI", Roboto, "Helvetica Neue", sans-serif; }
main { max-width: 1360px; margin: 0 auto; padding: 32px 24px 64px; }
h1 { font-size: 26px; margin: 0 0 4px; letter-spacing: -0.01em; }
h2 { font-size: 18px; margin: 36px 0 10px; }
p { margin: 4px 0 12px; max-width: 75ch; }
.soft { color: var(--soft); }
.warn { color: var(--warn); }
code { font: 12.5px/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
.card { background: var(--card); border: 1px solid var(--rule); border-radius: 10px; padding: 16px 18px; overflow-x: auto; }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: 2px 18px; margin: 14px 0 0; font-size: 14px; }
.facts dt { color: var(--soft); } .facts dd { margin: 0; overflow-wrap: anywhere; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 12px; margin: 20px 0 0; }
.figures div { background: var(--card); border: 1px solid var(--rule); border-radius: 10px; padding: 12px 16px; }
.figures b { display: block; font-size: 24px; line-height: 1.25; letter-spacing: -0.01em; font-variant-numeric: tabular-nums; }
.figures span { display: block; font-size: 13px; color: var(--soft); line-height: 1.35; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; font-variant-numeric: tabular-nums; }
th { font-weight: 600; color: var(--soft); text-align: right; padding: 5px 7px; border-bottom: 1px solid var(--rule); vertical-align: bottom; line-height: 1.25; }
td { text-align: right; padding: 5px 7px; border-bottom: 1px solid var(--rule); white-space: nowrap; }
tr:last-child td { border-bottom: 0; }
th.name, td.name { text-align: left; }
td.best { font-weight: 700; }
.wide th, .wide td { padding-left: 4px; padding-right: 6px; }
.wide small { display: block; color: var(--soft); font-size: 12px; line-height: 1.3; white-space: normal; overflow-wrap: anywhere; min-width: 130px; padding-left: 18px; }
.key { display: inline-block; width: 10px; height: 10px; border-radius: 3px; margin-right: 8px; }
.grid { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(460px, 100%), 1fr)); gap: 0 16px; }
.grid > div { min-width: 0; }
svg { width: 100%; height: auto; display: block; font: 12px system-ui, "Segoe UI", Roboto, sans-serif; }
svg text { fill: var(--text); } svg .tick { fill: var(--soft); } svg .value { fill: var(--soft); font-size: 9.5px; } svg .rule { stroke: var(--rule); stroke-width: 1; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 18px; font-size: 13px; margin: 0 0 8px; }
.legend span { white-space: nowrap; }
.panels { display: grid; grid-template-columns: repeat(3, 1fr); gap: 10px; }
.panels.four { grid-template-columns: repeat(4, 1fr); }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(180px, 1fr)); gap: 14px 12px; }
.ramp { display: inline-block; width: 130px; height: 10px; border-radius: 5px; vertical-align: middle; margin: 0 6px;
  background: linear-gradient(to right, rgb(34,48,102), rgb(58,116,158), rgb(246,222,110), rgb(238,128,44), rgb(196,22,34)); }
@media (max-width: 700px) { main { padding: 20px 12px 40px; } .panels, .panels.four { grid-template-columns: repeat(2, 1fr); } .card { padding: 12px; }
  .gallery { grid-template-columns: repeat(2, 1fr); } .facts { grid-template-columns: 1fr; } .facts dd { margin-bottom: 6px; } }
@media print { :root { --page: #fff; --card: #fff; --text: #000; --soft: #444; --rule: #ccc; } main { max-width: none; padding: 0; }
  body { font-size: 12px; } .card, figure, .figures div { break-inside: avoid; } h2 { break-after: avoid; } .grid { grid-template-columns: 1fr 1fr; } }
figure { margin: 0; min-width: 0; } figure img { width: 100%; height: auto; border-radius: 8px; display: block; }
figcaption { font-size: 13px; color: var(--soft); margin-top: 4px; overflow-wrap: anywhere; }
figcaption b { color: var(--text); font-weight: 600; }
.character { margin-bottom: 16px; }
.character h3 { font-size: 15px; margin: 0 0 10px; } .character h3 span { font-weight: 400; color: var(--soft); margin-left: 10px; }
summary { cursor: pointer; }
)css";

}  // namespace

std::string escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string number(double value, int digits) { return print("%.*f", digits, value); }

std::string count(size_t value) {
  std::string digits = std::to_string(value);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, "\xE2\x80\xAF");
  return digits;
}

std::string color(size_t series) { return std::string("var(--s").append(std::to_string(series % kSeries)).append(")"); }

std::string image(const std::vector<uint8_t>& png, const std::string& alt, bool lazy) {
  return std::string("<img") + (lazy ? " loading=\"lazy\"" : "") + " alt=\"" + escape(alt) +
         "\" src=\"data:image/png;base64," + base64({reinterpret_cast<const char*>(png.data()), png.size()}) + "\" />";
}

std::string legend(const std::vector<std::string>& labels) {
  std::string out = "<div class=\"legend\">";
  for (size_t i = 0; i < labels.size(); ++i)
    out += "<span><i class=\"key\" style=\"background:" + color(i) + "\"></i>" + escape(labels[i]) + "</span>";
  return out + "</div>\n";
}

std::string facts(const std::vector<std::pair<std::string, std::string>>& list) {
  if (list.empty()) return "";
  std::string out = "<dl class=\"facts\">";
  for (const auto& [term, fact] : list) out += "<dt>" + escape(term) + "</dt><dd>" + escape(fact) + "</dd>";
  return out + "</dl>\n";
}

std::string card(const std::string& heading, const std::string& content, const std::string& note) {
  return "<div><h2>" + escape(heading) + "</h2>\n" +
         (note.empty() ? "" : "<p class=\"soft\">" + escape(note) + "</p>\n") + "<div class=\"card\">" + content +
         "</div></div>\n";
}

std::string page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\" />"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" /><title>" +
         escape(title) + "</title><style>" + kStyle + "</style></head>\n<body><main>\n" + body +
         "</main></body></html>\n";
}

std::string table(const std::vector<Column>& columns, const std::vector<std::vector<Cell>>& rows) {
  std::string out = "<table><thead><tr>";
  for (const Column& column : columns)
    out += std::string("<th") + (column.text ? " class=\"name\">" : ">") + escape(column.heading) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (const std::vector<Cell>& row : rows) {
    out += "<tr>";
    for (size_t i = 0; i < row.size(); ++i) {
      const bool text = i < columns.size() && columns[i].text;
      out += std::string("<td") +
             (row[i].best ? " class=\"best\">"
              : text      ? " class=\"name\">"
                          : ">") +
             (row[i].markup ? row[i].text : escape(row[i].text)) + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table>\n";
}

}  // namespace sinew::html
