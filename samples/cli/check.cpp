// SPDX-License-Identifier: MIT
// sinew check: whether rigs hold, as text, JSON, SARIF and a page, and held against a profile.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_character/check/check_output.hpp"
#include "sinew_character/page/pages.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct CheckCommandSettings {
  std::vector<std::string> inputs;
  std::string sarif, report, gate, against;
  bool json = false, no_poses = false, rules = false, score = false;
};

// Lines stay, all else that a terminal would obey goes.
std::string printable_lines(const std::string& text) {
  std::string out;
  for (size_t from = 0; from <= text.size();) {
    const size_t end = std::min(text.find('\n', from), text.size());
    out += (from == 0 ? "" : "\n") + printable(text.substr(from, end - from));
    from = end + 1;
  }
  return out;
}

void list_rules() {
  for (const CheckRule& rule : check_rules())
    std::printf("%-15s %-7s above %g: %s (%s)\n", rule.name, severity_text(rule.severity), rule.bound, rule.title,
                rule.value);
}

void check_settings(const CheckCommandSettings& s) {
  if (s.inputs.empty()) throw UsageError("expected files or folders to check, found none");
  if (!s.sarif.empty()) check_output(s.sarif, {".sarif", ".json"});
  if (!s.report.empty()) check_output(s.report, {".html", ".htm"});
  if (!s.against.empty() && s.inputs.size() != 1)
    throw UsageError("--against compares one file with an older version; give one file");
}

// Checks one file; a file that cannot be read is reported and counted, the others continue.
std::optional<CheckedFile> look(const CheckCommandSettings& s, const std::optional<CheckGate>& gate,
                                const FoundCharacter& found, Progress* progress) {
  CheckOptions options;
  options.poses = !s.no_poses;
  if (gate) options.bounds = gate->bounds;
  try {
    CheckedFile file = check_file(found.path, options);
    if (!s.against.empty()) check_against(s.against, options, &file);
    if (s.score) file.score = weight_score(file.character);
    if (gate) file.failures = check_failures(*gate, file);
    progress->say(stdout, s.json ? check_json(file) : printable_lines(check_text(file)));
    for (const std::string& line : file.failures) progress->say(stderr, "gate: " + printable(found.path) + ": " + line);
    return file;
  } catch (const OutOfMemory&) {
    throw;
  } catch (const Error& error) {
    progress->say(stderr, "sinew: error: " + printable(error.what()));
    return std::nullopt;
  }
}

void run_check(const CheckCommandSettings& s) {
  if (s.rules) {
    list_rules();
    return;
  }
  check_settings(s);
  const std::optional<CheckGate> gate =
      s.gate.empty() ? std::nullopt : std::optional<CheckGate>(read_check_gate(s.gate));
  const std::vector<FoundCharacter> inputs = expand(s.inputs);
  std::vector<CheckedFile> files;
  size_t broken = 0, failed = 0;
  {
    Progress progress(inputs.size(), "characters");
    for (const FoundCharacter& found : inputs) {
      std::optional<CheckedFile> file = look(s, gate, found, &progress);
      broken += file ? 0 : 1;
      failed += file && !file->failures.empty() ? 1 : 0;
      // Pages and SARIF are of all files; without them none is kept.
      if (file && !(s.report.empty() && s.sarif.empty())) files.push_back(std::move(*file));
      progress.step();
    }
  }
  if (!s.sarif.empty()) write_text_file(s.sarif, check_sarif(files));
  if (!s.report.empty()) write_text_file(s.report, check_html(files));
  if (broken > 0) throw Error(print("%zu of %zu files could not be read; see above", broken, inputs.size()));
  if (failed > 0)
    throw GateError(print("%zu of %zu files do not pass %s; see above", failed, inputs.size(), s.gate.c_str()));
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* sub =
      app.add_subcommand("check", "Check weights, joints, names, matrices, test poses and animations of rigs");
  auto s = std::make_shared<CheckCommandSettings>();
  sub->add_option("inputs", s->inputs, "Characters, or folders of them. " + mesh_files())->type_name("FILE|DIR");
  shared_flag(sub, "--json", s->json, "One line per file");
  sub->add_option("--sarif", s->sarif, "Also write all findings as SARIF 2.1.0, for code review")->type_name("FILE");
  shared_option(sub, "--report", s->report, "A picture per finding");
  sub->add_option("--gate", s->gate,
                  "Exit with status 3 if a file has more findings than this profile allows. JSON: most, ignore, bounds")
      ->type_name("PROFILE.json");
  sub->add_option("--against", s->against,
                  "Older version of the file: report new and fixed findings. A gate then counts new ones only")
      ->type_name("OLD");
  sub->add_flag("--no-poses", s->no_poses, "Leave out the test poses");
  sub->add_flag("--score", s->score,
                "Score the weights by similarity to those of three methods, 0 to 100. For weights made by a program; "
                "an artist's own style lowers the score");
  sub->add_flag("--rules", s->rules, "List all rules with their bounds");
  sub->footer(
      "Examples:\n  sinew check hero.glb --report hero.check.html\n  sinew check characters --json --gate studio.json "
      "--sarif check.sarif\n  sinew check new.glb --against old.glb\n\nAn error breaks the character, a warning shows "
      "in some motion, a note deserves a look. Exit status: 0 whatever is\nfound, 1 if a file cannot be read, 3 if "
      "--gate fails.");
  sub->callback([s] { run_check(*s); });
}

}  // namespace sinew::cli
