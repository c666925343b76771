// SPDX-License-Identifier: MIT
// The table of words, in the languages that rigs are named in.
#include "springs/swing_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "sinew_formats/base/lower_case.hpp"

namespace sinew {
namespace {

using K = SpringKind;

struct Word {
  const char* text;
  SpringKind kind;
};
// Whole words of names; an s behind them does not matter. Skirts before coats: VRoid's CoatSkirt is one.
constexpr std::array<Word, 61> kWords = {{
    {"skirt", K::kSkirt},    {"dress", K::kSkirt},     {"hakama", K::kSkirt},   {"kilt", K::kSkirt},
    {"apron", K::kSkirt},    {"loincloth", K::kSkirt}, {"tunic", K::kSkirt},    {"hem", K::kSkirt},
    {"suso", K::kSkirt},     {"quill", K::kHair},      {"bun", K::kHair},       {"earflap", K::kEar},
    {"hair", K::kHair},      {"bang", K::kHair},       {"fringe", K::kHair},    {"braid", K::kHair},
    {"ponytail", K::kHair},  {"pigtail", K::kHair},    {"twintail", K::kHair},  {"ahoge", K::kHair},
    {"sidelock", K::kHair},  {"lock", K::kHair},       {"mane", K::kHair},      {"beard", K::kHair},
    {"mustache", K::kHair},  {"moustache", K::kHair},  {"kami", K::kHair},      {"dreadlock", K::kHair},
    {"cape", K::kCape},      {"cloak", K::kCape},      {"mantle", K::kCape},    {"coat", K::kCape},
    {"robe", K::kCape},      {"poncho", K::kCape},     {"shawl", K::kCape},     {"veil", K::kCape},
    {"cloth", K::kCape},     {"tail", K::kTail},       {"ear", K::kEar},        {"ribbon", K::kRibbon},
    {"sleeve", K::kRibbon},  {"sode", K::kRibbon},     {"scarf", K::kRibbon},   {"tie", K::kRibbon},
    {"necktie", K::kRibbon}, {"strap", K::kRibbon},    {"tassel", K::kRibbon},  {"antenna", K::kRibbon},
    {"feeler", K::kRibbon},  {"tentacle", K::kRibbon}, {"whisker", K::kRibbon}, {"string", K::kRibbon},
    {"sash", K::kRibbon},    {"pendant", K::kRibbon},  {"earring", K::kRibbon}, {"dangle", K::kRibbon},
    {"bust", K::kBust},      {"breast", K::kBust},     {"boob", K::kBust},      {"mune", K::kBust},
    {"oppai", K::kBust},
}};
// Anywhere in a name: these languages have no gaps between words.
constexpr std::array<Word, 13> kInnerWords = {{{"スカート", K::kSkirt},
                                               {"髪", K::kHair},
                                               {"もみあげ", K::kHair},
                                               {"おさげ", K::kHair},
                                               {"ツインテール", K::kHair},
                                               {"マント", K::kCape},
                                               {"しっぽ", K::kTail},
                                               {"尻尾", K::kTail},
                                               {"耳", K::kEar},
                                               {"リボン", K::kRibbon},
                                               {"袖", K::kRibbon},
                                               {"ネクタイ", K::kRibbon},
                                               {"胸", K::kBust}}};
constexpr std::array<const char*, 18> kStiff = {"weapon", "sword",    "gun",     "rifle",  "shield",  "bag",
                                                "pack",   "backpack", "holster", "quiver", "helmet",  "armor",
                                                "armour", "prop",     "gear",    "tank",   "glasses", "horn"};

// Words of ASCII letters in lower case, cut where another byte or a capital begins: J_SecHair1 is j, sec, hair.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool upper = c >= 'A' && c <= 'Z', letter = upper || (c >= 'a' && c <= 'z');
    const bool after_lower = i > 0 && name[i - 1] >= 'a' && name[i - 1] <= 'z';
    if (!letter || (upper && after_lower)) words.emplace_back();
    if (letter) words.back() += c;
  }
  for (std::string& word : words) word = lower_case(word);
  return words;
}

// Glued to words without a gap: hairfront, backhair.
constexpr std::array<std::string_view, 18> kPlaces = {"s",   "front", "back",  "side", "left",   "right",
                                                      "top", "upper", "lower", "mid",  "middle", "center",
                                                      "tip", "root",  "base",  "end",  "inner",  "outer"};
bool is_place(std::string_view word) { return std::find(kPlaces.begin(), kPlaces.end(), word) != kPlaces.end(); }

bool is_word(std::string_view word, std::string_view of_table) {
  if (word.size() < of_table.size()) return false;
  const size_t rest = word.size() - of_table.size();
  if (word.substr(0, of_table.size()) == of_table) return rest == 0 || is_place(word.substr(of_table.size()));
  return rest > 1 && word.substr(rest) == of_table && is_place(word.substr(0, rest));
}

}  // namespace

std::optional<SwingWord> swing_word(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  for (const Word& one : kWords)
    for (const std::string& word : words)
      if (is_word(word, one.text)) return SwingWord{one.kind, one.text};
  for (const Word& one : kInnerWords)
    if (name.find(one.text) != std::string::npos) return SwingWord{one.kind, one.text};
  return std::nullopt;
}

bool names_stiff_thing(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return std::any_of(kStiff.begin(), kStiff.end(), [&](const char* one) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return is_word(word, one); });
  });
}

}  // namespace sinew
