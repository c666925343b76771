// SPDX-License-Identifier: MIT
// Groups of families that look alike, how they are dealt to folds, and the order in which training draws characters, so that many
// look-alikes do not drown the few.
#include "sinew_trainer/family_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/random.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

std::string FamilyGroups::group(const std::string& family) const {
  const auto found = group_of.find(family);
  if (found != group_of.end()) return found->second;
  if (family.rfind("mh_", 0) == 0) return "mh";
  const size_t last = family.find_last_not_of("0123456789");
  return last == std::string::npos ? family : family.substr(0, last + 1);
}

FamilyGroups read_family_groups(const std::string& path) {
  using Json = nlohmann::ordered_json;
  const std::vector<uint8_t> bytes = read_file(path);
  Json root;
  try {
    root = Json::parse(bytes.begin(), bytes.end());
  } catch (const Json::parse_error& error) {
    throw Error(path + ": not JSON, byte " + std::to_string(error.byte));
  }
  const auto require = [&](bool good, const std::string& where, const std::string& expected) {
    if (!good) throw Error(path + ": " + where + ": expected " + expected);
  };
  const auto names = [&](const Json& list, const std::string& where) {
    require(list.is_array(), where, "a list of names");
    std::vector<std::string> out;
    for (const Json& name : list) {
      require(name.is_string(), where, "names, found " + name.dump());
      out.push_back(name.get<std::string>());
    }
    return out;
  };
  require(root.is_object(), "the file", "an object with \"groups\", \"apart\" and \"means\"");
  FamilyGroups groups;
  for (const auto& [key, value] : root.items()) {
    if (key == "groups") {
      require(value.is_object(), key, "an object: group to list of families");
      for (const auto& [group, families] : value.items()) {
        for (const std::string& family : names(families, "group " + group)) {
          const auto [at, fresh] = groups.group_of.try_emplace(family, group);
          require(fresh, "group " + group, "each family once, but " + family + " is in " + at->second + " too");
        }
      }
    } else if (key == "apart") {
      groups.apart.clear();
      for (const std::string& group : names(value, key)) groups.apart.insert(group);
    } else if (key == "means") {
      require(value.is_object(), key, "an object: name to list of groups");
      for (const auto& [mean, members] : value.items()) {
        for (const std::string& group : names(members, "mean " + mean)) groups.means[mean].insert(group);
        require(!groups.means[mean].empty(), "mean " + mean, "at least one group");
      }
    } else {
      throw Error(path + ": unknown key \"" + key + "\"");
    }
  }
  return groups;
}

std::vector<std::vector<std::string>> make_folds(const std::map<std::string, size_t>& families,
                                                 const FamilyGroups& groups, uint32_t fold_count) {
  struct Group {
    std::string name;
    std::vector<std::string> families;
    size_t characters = 0;
  };
  std::map<std::string, Group> by_name;
  for (const auto& [family, count] : families) {
    Group& group = by_name[groups.group(family)];
    group.families.push_back(family);
    group.characters += count;
  }
  if (fold_count < 2) throw Error("folds: at least 2 are needed, found " + std::to_string(fold_count));
  if (by_name.size() < fold_count) {
    throw Error(std::to_string(fold_count) + " folds need at least as many groups of families, found " +
                std::to_string(by_name.size()) + "; a family is the part of a character's name before \"__\"");
  }
  std::vector<Group> order;
  for (auto& [name, group] : by_name) {
    order.push_back(std::move(group));
    order.back().name = name;
  }
  std::stable_sort(order.begin(), order.end(), [](const Group& a, const Group& b) {
    if (a.families.size() != b.families.size()) return a.families.size() > b.families.size();
    return a.characters > b.characters;  // equal ones stay in the order of their names
  });
  std::vector<std::vector<std::string>> folds(fold_count);
  std::vector<size_t> characters(fold_count, 0);
  for (const Group& group : order) {
    size_t best = 0;
    for (size_t f = 1; f < fold_count; ++f) {
      const bool fewer = folds[f].size() < folds[best].size() ||
                         (folds[f].size() == folds[best].size() && characters[f] < characters[best]);
      if (fewer) best = f;
    }
    folds[best].insert(folds[best].end(), group.families.begin(), group.families.end());
    characters[best] += group.characters;
  }
  for (std::vector<std::string>& fold : folds) std::sort(fold.begin(), fold.end());
  return folds;
}

namespace {

void shuffle(std::vector<uint32_t>* items, Random* random) {
  for (size_t i = items->size(); i > 1; --i)
    std::swap((*items)[i - 1], (*items)[random->below(static_cast<uint32_t>(i))]);
}

}  // namespace

std::vector<uint32_t> draw_round(const std::vector<std::string>& families, double power,
                                 const std::map<std::string, double>& shares, Random* random) {
  std::map<std::string, std::vector<uint32_t>> members;
  for (uint32_t i = 0; i < families.size(); ++i) members[families[i]].push_back(i);
  double sum = 0, rest = 1;  // of the families without a share of their own
  for (const auto& [name, characters] : members) {
    if (const auto given = shares.find(name); given != shares.end()) {
      rest -= given->second;
    } else {
      sum += std::pow(static_cast<double>(characters.size()), power);
    }
  }
  std::vector<uint32_t> round;
  for (auto& [name, characters] : members) {
    const auto given = shares.find(name);
    const double share =
        given != shares.end() ? given->second : rest * std::pow(static_cast<double>(characters.size()), power) / sum;
    size_t quota = static_cast<size_t>(share * static_cast<double>(families.size()) + random->uniform());
    while (quota > 0) {
      shuffle(&characters, random);
      const size_t take = std::min(quota, characters.size());
      round.insert(round.end(), characters.begin(), characters.begin() + static_cast<std::ptrdiff_t>(take));
      quota -= take;
    }
  }
  shuffle(&round, random);
  return round;
}

}  // namespace sinew
