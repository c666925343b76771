// SPDX-License-Identifier: MIT
// The one meaning that an option's name has in every command, and how a command declares its options.
#ifndef SINEW_CLI_OPTIONS_HPP
#define SINEW_CLI_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "enum_words.hpp"
#include "sinew_character/pose/character_transform.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew::cli {

// ".obj, .glb, ...": what is read, for help texts and errors.
std::string mesh_files();
std::string picture_files();
std::string skeleton_files();
std::string motion_files();
constexpr uint32_t kWritesWhole = kWritesSkin | kWritesWithMesh;  // all in one file
// Names of files with these uses as --format has them, "glb".
std::vector<std::string> format_names(uint32_t uses);
// Where a skeleton with weights goes, for -o; `more`: of standard output and folders.
std::string skin_output_text(const std::string& more);

struct OptionWord {
  const char* name;     // --like-this
  const char* value;    // what stands behind it; "" for a flag
  const char* meaning;  // one sentence, without its full stop
};
// Description of an option that several commands have. std::logic_error for another name.
const OptionWord& option_word(const std::string& names);

// Help texts: the first sentence is what --help shows; what follows ". " is for --help-all.
std::string sentences(const std::string& meaning, const std::string& more);

// An option whose name several commands have, with the meaning and the kind of value that it has in all of them. `more`
// is what this command adds.
template <class T>
CLI::Option* shared_option(CLI::App* sub, const std::string& names, T& value, const std::string& more = "") {
  const OptionWord& word = option_word(names);
  return sub->add_option(names, value, sentences(word.meaning, more))->type_name(word.value);
}
// An option that takes one of these words, as the number that it has in them.
template <class Number>
CLI::Option* word_option(CLI::App* sub, const std::string& names, Number& value, const Words& words,
                         const std::string& text) {
  const auto set = [&value, &words](const std::string& word) {
    value = static_cast<Number>(std::find(words.begin(), words.end(), word) - words.begin());
  };
  return sub->add_option_function<std::string>(names, set, text)
      ->check(CLI::IsMember(words))
      ->default_str(words[static_cast<size_t>(value)]);
}
template <class Number>
CLI::Option* shared_word_option(CLI::App* sub, const std::string& names, Number& value, const Words& words,
                                const std::string& more) {
  const OptionWord& word = option_word(names);
  return word_option(sub, names, value, words, sentences(word.meaning, more))->type_name(word.value);
}
CLI::Option* shared_flag(CLI::App* sub, const std::string& name, bool& value, const std::string& more = "");

// The axis of a checked --up: "x", "y", "z"; "auto" is none; y for "-y".
inline MaybeAxis maybe_axis(const std::string& word) {
  return word == "auto" ? std::nullopt : MaybeAxis(static_cast<Axis>(word.back() - 'x'));
}
// The axis that points down: y of "-y".
inline MaybeAxis down_axis(const std::string& word) { return word[0] == '-' ? maybe_axis(word) : std::nullopt; }
inline Axis axis_of(const std::string& letter) { return maybe_axis(letter).value_or(Axis::kY); }

// The options that follow are shown under this heading, and by --help-all alone.
void section(CLI::App* sub, const std::string& heading);

// Numbers with a range that several commands share.
CLI::Option* add_influences(CLI::App* sub, unsigned& count);
CLI::Option* add_jobs(CLI::App* sub, unsigned& jobs, const std::string& more = "");

// Where a mesh is rotated and put, under a heading of its own.
void add_transform_options(CLI::App* sub, CharacterTransform* transform);

}  // namespace sinew::cli
#endif
