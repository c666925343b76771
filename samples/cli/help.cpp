// SPDX-License-Identifier: MIT
// Lays the help texts out in columns.
#include <CLI/CLI.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "commands.hpp"

namespace sinew::cli {
namespace {

constexpr size_t kTextWidth = 100, kColumn = 27;

// Words in lines of at most kTextWidth columns, behind a name that has the first kColumn of them.
std::string row(const std::string& name, const std::string& text) {
  std::string out, line = "  " + name;
  const auto end_line = [&] {
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    line.clear();
  };
  if (line.size() + 2 > kColumn) end_line();
  line.resize(kColumn, ' ');
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() > kColumn && line.size() + 1 + word.size() > kTextWidth) {
      end_line();
      line.assign(kColumn, ' ');
    }
    line += (line.size() > kColumn ? " " : "") + word;
  }
  end_line();
  return out;
}

std::string wrapped(const std::string& text) {
  std::string out, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kTextWidth) {
      out += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return out + line + "\n";
}

// Indented examples are unchanged; the text around them is wrapped to the screen.
std::string footer_text(const std::string& footer) {
  std::string out, paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) out += wrapped(paragraph);
    paragraph.clear();
  };
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    const bool prose = !line.empty() && line[0] != ' ';
    if (!prose) end_paragraph();
    if (prose)
      paragraph += line + " ";
    else
      out += line + "\n";
    if (prose && line.back() == ':') end_paragraph();
  }
  end_paragraph();
  return out;
}

// Up to the first full stop that ends a sentence.
std::string first_sentence(const std::string& text) { return text.substr(0, text.find(". ")); }

// CLI11 puts what values are allowed behind their kind: "METHOD:{heat,model}".
struct OptionValue {
  std::string kind, choices;
};
OptionValue value_of(const CLI::Option& option) {
  const std::string whole = option.get_type_name();
  const size_t colon = whole.find(":{");
  OptionValue value = {whole.substr(0, whole.find(':')), ""};
  if (colon != std::string::npos) value.choices = whole.substr(colon + 2, whole.rfind('}') - colon - 2);
  const char* const between = value.choices.size() < kTextWidth / 2 ? "|" : "| ";  // long lists may be broken
  for (size_t at = value.choices.find(','); at != std::string::npos; at = value.choices.find(','))
    value.choices.replace(at, 1, between);
  return value;
}

bool has_no_name(const CLI::Option& option) { return option.get_positional() && option.get_lnames().empty(); }

std::string option_row(const CLI::Option& option, bool full) {
  const OptionValue value = value_of(option);
  const bool positional = has_no_name(option);
  std::string name = positional ? value.kind : option.get_name(false, true);
  for (size_t at = name.find("{false}"); at != std::string::npos; at = name.find("{false}")) name.erase(at, 7);
  if (!positional && option.get_type_size() != 0 && !value.kind.empty()) name += " " + value.kind;
  if (option.get_expected_max() == CLI::detail::expected_max_vector_size) name += " ...";
  std::string text = full ? option.get_description() : first_sentence(option.get_description());
  if (!value.choices.empty()) text += (full ? ". One of " : ": ") + value.choices;
  const std::string usual = option.get_default_str();
  if (!usual.empty() && usual != "\"\"") text += " [" + usual + "]";
  if (option.get_required() && !positional) text += " (required)";
  return row(name, text);
}

// Options without a heading first, then heading by heading.
std::vector<const CLI::Option*> in_groups(const CLI::App& app) {
  std::vector<const CLI::Option*> options = app.get_options([](const CLI::Option* o) { return has_no_name(*o); });
  for (const std::string& group : app.get_groups())
    for (const CLI::Option* option :
         app.get_options([&](const CLI::Option* o) { return !has_no_name(*o) && o->get_group() == group; }))
      options.push_back(option);
  return options;
}

std::string usage(const CLI::App& app, const std::string& name) {
  std::string text = "Usage: " + name;
  const auto subcommands = app.get_subcommands([](const CLI::App*) { return true; });
  if (!subcommands.empty()) return text + " SUBCOMMAND\n";
  for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); })) {
    std::string word = value_of(*option).kind;
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) word += " ...";
    text += " " + (option->get_required() ? word : "[" + word + "]");
  }
  return text + " [OPTIONS]\n";
}

class HelpText : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

std::string HelpText::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  const bool full = mode == CLI::AppFormatMode::All;
  std::string out = wrapped(app->get_description()) + usage(*app, name);
  const auto subcommands = app->get_subcommands([](const CLI::App*) { return true; });
  if (!subcommands.empty()) out += "\nSubcommands:\n";
  for (const CLI::App* sub : subcommands) out += row(sub->get_name(), sub->get_description());
  size_t left_out = 0;
  std::string heading;
  for (const CLI::Option* option : in_groups(*app)) {
    const bool about_help = option == app->get_help_ptr() || option == app->get_help_all_ptr();
    const std::string group = has_no_name(*option) ? "Positionals" : option->get_group();
    if (!full && (about_help || option->get_group() != "Options")) {
      left_out += about_help ? 0 : 1;
      continue;
    }
    if (group != heading) out += "\n" + (heading = group) + ":\n";
    out += option_row(*option, full);
  }
  std::string footer = app->get_footer();
  if (!full) footer = footer.substr(0, footer.find("\n\n"));
  if (!footer.empty()) out += "\n" + footer_text(footer);
  if (!full) {
    out += "\n" + (left_out > 0 ? std::to_string(left_out) + " more options and all details: " : "All details: ") +
           name + " --help-all\n";
    return out;
  }
  for (const CLI::App* sub : subcommands)
    out += "\n" + std::string(kTextWidth, '-') + "\n" + make_help(sub, name + " " + sub->get_name(), mode);
  return out;
}

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_text() { return std::make_shared<HelpText>(); }

}  // namespace sinew::cli
