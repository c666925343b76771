// SPDX-License-Identifier: MIT
// Means, tables and files of a cross-family validation.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/crossval.hpp"
#include "sinew_trainer/evaluate.hpp"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kWorse = 0.03;  // L1 above heat's that counts as worse

struct FoldFigure {
  const char* key;
  double CrossvalFigures::*value;
};
constexpr FoldFigure kFigures[] = {{"l1", &CrossvalFigures::l1},
                                   {"argmax", &CrossvalFigures::argmax},
                                   {"distance", &CrossvalFigures::distance},
                                   {"heat_l1", &CrossvalFigures::heat_l1},
                                   {"heat_argmax", &CrossvalFigures::heat_argmax},
                                   {"heat_distance", &CrossvalFigures::heat_distance}};

template <class Weight>
CrossvalFigures mean(const std::vector<CrossvalFamily>& families, Weight&& weight) {
  CrossvalFigures out;
  double sum = 0;
  for (const CrossvalFamily& family : families) sum += weight(family);
  if (sum <= 0) return out;
  for (const CrossvalFamily& family : families) {
    for (const FoldFigure& f : kFigures) out.*f.value += weight(family) / sum * family.figures.*f.value;
  }
  return out;
}

// Families of all seeds, figures averaged over the seeds that have them.
std::vector<CrossvalFamily> over_seeds(const std::vector<CrossvalSeed>& seeds,
                                       std::vector<CrossvalFamily> CrossvalSeed::*member) {
  std::map<std::string, std::vector<CrossvalFamily>> by_name;
  for (const CrossvalSeed& seed : seeds) {
    for (const CrossvalFamily& family : seed.*member) by_name[family.family].push_back(family);
  }
  std::vector<CrossvalFamily> out;
  for (const auto& [name, rows] : by_name) {
    out.push_back(rows[0]);
    out.back().figures = mean(rows, [](const CrossvalFamily&) { return 1.0; });
  }
  return out;
}

CrossvalMean mean_of(const std::string& name, const std::vector<CrossvalFamily>& families) {
  CrossvalMean out;
  out.name = name;
  out.families = families.size();
  out.figures = mean(families, [](const CrossvalFamily&) { return 1.0; });
  for (const CrossvalFamily& family : families) {
    out.characters += family.characters;
    const double difference = family.figures.l1 - family.figures.heat_l1;
    if (difference > kWorse) ++out.worse;
    if (out.worst_family.empty() || difference > out.worst_difference) {
      out.worst_family = family.family;
      out.worst_difference = difference;
    }
  }
  return out;
}

double below_heat(const CrossvalFigures& f) { return f.heat_l1 > 0 ? 100 * (1 - f.l1 / f.heat_l1) : 0; }

std::string figure_cells(const CrossvalFigures& f) {
  return print(" | %.3f | %.3f | %+.3f | %.1f | %.1f | %.4f | %.4f |\n", f.l1, f.heat_l1, f.l1 - f.heat_l1,
               100 * f.argmax, 100 * f.heat_argmax, f.distance, f.heat_distance);
}

Json family_json(const CrossvalFamily& family) {
  Json out = {
      {"family", family.family}, {"group", family.group}, {"fold", family.fold}, {"characters", family.characters}};
  for (const FoldFigure& f : kFigures) out[f.key] = family.figures.*f.value;
  return out;
}

Json figures_json(const CrossvalFigures& figures) {
  Json out;
  for (const FoldFigure& f : kFigures) out[f.key] = figures.*f.value;
  return out;
}

CrossvalFamily family_from(const Json& row) {
  CrossvalFamily family;
  family.family = row.at("family").get<std::string>();
  family.group = row.at("group").get<std::string>();
  family.fold = row.at("fold").get<uint32_t>();
  family.characters = row.at("characters").get<size_t>();
  for (const FoldFigure& f : kFigures) family.figures.*f.value = row.at(f.key).get<double>();
  return family;
}

}  // namespace

CrossvalMeans crossval_means(const CrossvalReport& report) {
  CrossvalMeans means;
  const auto one = [](const CrossvalFamily&) { return 1.0; };
  const std::vector<CrossvalFamily> families = over_seeds(report.seeds, &CrossvalSeed::families);
  std::vector<CrossvalFamily> outside;
  for (const CrossvalFamily& family : families) {
    if (report.apart.count(family.group) == 0) outside.push_back(family);
  }
  const CrossvalMean whole = mean_of("", families);
  means.worse = whole.worse, means.worst_family = whole.worst_family, means.worst_difference = whole.worst_difference;
  for (const auto& [name, groups] : report.means) {
    std::vector<CrossvalFamily> members;
    for (const CrossvalFamily& family : families) {
      if (groups.count(family.group) > 0) members.push_back(family);
    }
    if (!members.empty()) means.named.push_back(mean_of(name, members));
  }
  means.families = families.size();
  means.all = mean(families, one);
  means.outside_families = outside.size();
  means.outside = mean(outside, one);
  double low = INFINITY, high = -INFINITY;
  for (const CrossvalSeed& seed : report.seeds) {
    if (seed.families.size() != families.size()) continue;
    const double l1 = mean(seed.families, one).l1;
    low = std::min(low, l1);
    high = std::max(high, l1);
  }
  means.spread = high > low ? high - low : 0;
  const std::vector<CrossvalFamily> val = over_seeds(report.seeds, &CrossvalSeed::val);
  for (const CrossvalFamily& family : val) means.val_characters += family.characters;
  means.val = mean(val, [](const CrossvalFamily& family) { return static_cast<double>(family.characters); });
  means.val_families = mean(val, one);
  return means;
}

std::string crossval_markdown(const CrossvalReport& report) {
  const CrossvalMeans means = crossval_means(report);
  const std::vector<CrossvalFamily> families = over_seeds(report.seeds, &CrossvalSeed::families);
  std::set<uint32_t> folds;
  for (const CrossvalFamily& family : families) folds.insert(family.fold);
  std::string out = report.label + ": each family measured by a network that saw no family of its group; " +
                    print("%zu of %u folds, mean of %zu seed%s\n\n", folds.size(), report.fold_count,
                          report.seeds.size(), report.seeds.size() == 1 ? "" : "s");
  const std::string head =
      "| family | fold | n | L1 | heat | L1 - heat | argmax % | heat | distance | heat |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  out += head;
  size_t characters = 0, outside = 0;
  for (const CrossvalFamily& family : families) {
    out += "| " + markdown_cell(family.family) + print(" | %u | %zu", family.fold, family.characters) +
           figure_cells(family.figures);
    characters += family.characters;
    if (report.apart.count(family.group) == 0) outside += family.characters;
  }
  out += print("| **mean of %zu families** | | %zu", means.families, characters) + figure_cells(means.all);
  if (means.outside_families != means.families && means.outside_families > 0) {
    std::string apart;
    for (const std::string& group : report.apart) apart += (apart.empty() ? "" : ", ") + group;
    out += print("| **mean of the %zu outside %s** | | %zu", means.outside_families, markdown_cell(apart).c_str(),
                 outside) +
           figure_cells(means.outside);
  }
  for (const CrossvalMean& m : means.named) {
    out += "| **mean of the " + print("%zu of ", m.families) + markdown_cell(m.name) +
           print("** | | %zu", m.characters) + figure_cells(m.figures);
  }
  if (means.val_characters > 0) {
    out +=
        print("| *val, %zu characters* | | %zu", means.val_characters, means.val_characters) + figure_cells(means.val);
    out += print("| *val, its families* | | %zu", means.val_characters) + figure_cells(means.val_families);
  }
  out += print("\nL1 %.1f %% below heat's over all families, %.1f %% outside; %zu families more than %.2f above heat",
               below_heat(means.all), below_heat(means.outside), means.worse, kWorse);
  if (!means.worst_family.empty())
    out += print("; worst %s: %+.3f", means.worst_family.c_str(), means.worst_difference);
  for (const CrossvalMean& m : means.named) {
    out += print("; %s: %.1f %% below, %zu of %zu worse, worst ", m.name.c_str(), below_heat(m.figures), m.worse,
                 m.families) +
           m.worst_family + print(" %+.3f", m.worst_difference);
  }
  if (report.seeds.size() > 1) out += print("; seeds differ by %.4f", means.spread);
  return out + "\n";
}

std::string crossval_csv(const CrossvalReport& report) {
  std::string out = "seed,set,family,group,fold,characters,l1,argmax,distance,heat_l1,heat_argmax,heat_distance\n";
  for (const CrossvalSeed& seed : report.seeds) {
    for (const auto& [set, rows] : {std::pair{"crossval", &seed.families}, std::pair{"val", &seed.val}}) {
      for (const CrossvalFamily& family : *rows) {
        out += print("%llu,%s,%s,%s,%u,%zu", static_cast<unsigned long long>(seed.seed), set, family.family.c_str(),
                     family.group.c_str(), family.fold, family.characters);
        for (const FoldFigure& f : kFigures) out += print(",%.6f", family.figures.*f.value);
        out += "\n";
      }
    }
  }
  return out;
}

std::string crossval_json(const CrossvalReport& report) {
  const CrossvalMeans means = crossval_means(report);
  Json out;
  out["crossval"] = 1;  // version of this layout
  out["label"] = report.label;
  out["config"] = Json::parse(report.config_json);
  out["folds"] = report.fold_count;
  out["apart"] = report.apart;
  out["means"] = report.means;
  out["seeds"] = Json::array();
  for (const CrossvalSeed& seed : report.seeds) {
    Json row = {{"seed", seed.seed}, {"families", Json::array()}, {"val", Json::array()}};
    for (const CrossvalFamily& family : seed.families) row["families"].push_back(family_json(family));
    for (const CrossvalFamily& family : seed.val) row["val"].push_back(family_json(family));
    out["seeds"].push_back(std::move(row));
  }
  // For other readers; read_crossval() computes them again.
  out["mean"] = figures_json(means.all);
  out["mean_outside"] = figures_json(means.outside);
  out["worse_than_heat"] = means.worse;
  if (means.val_characters > 0) {
    out["val_mean"] = figures_json(means.val);
    out["val_family_mean"] = figures_json(means.val_families);
  }
  return out.dump(1) + "\n";
}

CrossvalReport read_crossval(const std::string& path) {
  const std::string file =
      std::filesystem::is_directory(path) ? (std::filesystem::path(path) / "crossval.json").string() : path;
  const std::vector<uint8_t> bytes = read_file(file);
  CrossvalReport report;
  try {
    const Json json = Json::parse(bytes.begin(), bytes.end());
    if (json.value("crossval", 0) != 1) throw Error(file + ": not written by sinew-lab crossval");
    report.label = json.at("label").get<std::string>();
    report.config_json = json.at("config").dump(2);
    report.fold_count = json.at("folds").get<uint32_t>();
    report.apart = json.at("apart").get<std::set<std::string>>();
    report.means = json.value("means", report.means);  // older files have none
    for (const Json& row : json.at("seeds")) {
      CrossvalSeed seed;
      seed.seed = row.at("seed").get<uint64_t>();
      for (const Json& family : row.at("families")) seed.families.push_back(family_from(family));
      for (const Json& family : row.at("val")) seed.val.push_back(family_from(family));
      report.seeds.push_back(std::move(seed));
    }
  } catch (const nlohmann::json::exception& error) {
    throw Error(file + ": not a report of sinew-lab crossval: " + error.what());
  }
  return report;
}

std::string crossval_comparison(const std::vector<CrossvalReport>& reports) {
  std::set<std::string> named;  // means that some run has families of
  for (const CrossvalReport& report : reports) {
    for (const CrossvalMean& m : crossval_means(report).named) named.insert(m.name);
  }
  std::string out =
      "| run | seeds | families: L1 | below heat | argmax % | distance | outside mh: L1 | below heat | argmax % | "
      "worse by 0.03 | worst family |";
  std::string rule = "|---|---|---|---|---|---|---|---|---|---|---|";
  for (const std::string& name : named) {
    out += " " + markdown_cell(name) + ": L1 | below heat | worst family |";
    rule += "---|---|---|";
  }
  out += " val L1 | val families | val argmax % |\n" + rule + "---|---|---|\n";
  const auto heat_of = [](CrossvalFigures f) {
    f.l1 = f.heat_l1, f.argmax = f.heat_argmax, f.distance = f.heat_distance;
    return f;
  };
  const auto row = [&](const std::string& label, const std::string& seeds, const CrossvalMeans& m, double spread,
                       bool heat) {
    std::string text = "| " + markdown_cell(label) + " | " + seeds + print(" | %.4f", m.all.l1);
    if (spread > 0) text += print(" ± %.4f", spread / 2);
    text += heat ? " | " : print(" | %.1f %%", below_heat(m.all));
    text += print(" | %.1f | %.4f | %.4f", 100 * m.all.argmax, m.all.distance, m.outside.l1);
    text += heat ? " | " : print(" | %.1f %%", below_heat(m.outside));
    text += print(" | %.1f | ", 100 * m.outside.argmax);
    text +=
        heat ? " | " : print("%zu of %zu | %s %+.3f", m.worse, m.families, m.worst_family.c_str(), m.worst_difference);
    for (const std::string& name : named) {
      const auto found =
          std::find_if(m.named.begin(), m.named.end(), [&](const CrossvalMean& mean) { return mean.name == name; });
      if (found == m.named.end()) {
        text += " | | | ";
        continue;
      }
      text += print(" | %.4f | ", found->figures.l1);
      text += heat ? " | "
                   : print("%.1f %% | %s %+.3f", below_heat(found->figures), found->worst_family.c_str(),
                           found->worst_difference);
    }
    if (m.val_characters == 0) return text + " | | | |\n";
    return text + print(" | %.4f | %.4f | %.1f |\n", m.val.l1, m.val_families.l1, 100 * m.val.argmax);
  };
  std::optional<CrossvalFigures> shown;  // heat's row again only where it differs: other data or other K
  std::set<std::string> first_families;
  std::string warning;
  for (const CrossvalReport& report : reports) {
    CrossvalMeans means = crossval_means(report);
    CrossvalMeans heat = means;
    heat.all = heat_of(means.all), heat.outside = heat_of(means.outside);
    for (CrossvalMean& m : heat.named) m.figures = heat_of(m.figures);
    heat.val = heat_of(means.val), heat.val_families = heat_of(means.val_families);
    if (!shown || std::abs(shown->l1 - heat.all.l1) > 5e-5) {
      out += row(shown ? "heat (of the next row)" : "heat", "", heat, 0, true);
      shown = heat.all;
    }
    out += row(report.label, std::to_string(report.seeds.size()), means, means.spread, false);
    std::set<std::string> families;
    for (const CrossvalSeed& seed : report.seeds) {
      for (const CrossvalFamily& family : seed.families) families.insert(family.family);
    }
    if (&report == &reports.front()) first_families = families;
    if (families != first_families && warning.empty()) {
      warning = "\nNot comparable: " + report.label + " has " + std::to_string(families.size()) + " families, " +
                reports.front().label + " " + std::to_string(first_families.size()) + ", not the same ones.\n";
    }
  }
  return out + warning;
}

}  // namespace sinew
