// SPDX-License-Identifier: MIT
// Families of characters: which look alike, how they are dealt to folds, and how often training draws from each.
#ifndef SINEW_TRAINER_FAMILY_GROUPS_HPP
#define SINEW_TRAINER_FAMILY_GROUPS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sinew {

class Random;  // core/random.hpp

// Which families look alike and are therefore left out together. A family that the file does not name follows the rule:
// mh_* is "mh", every other is named by itself without the digits at its end (q_men19 -> q_men).
struct FamilyGroups {
  std::map<std::string, std::string> group_of;         // family -> group
  std::set<std::string> apart = {"mh"};                // groups that the second mean leaves out
  std::map<std::string, std::set<std::string>> means;  // further means: name -> groups
  std::string group(const std::string& family) const;
};
// {"groups": {"GROUP": ["FAMILY", ...], ...}, "apart": ["GROUP", ...], "means": {"NAME": ["GROUP", ...], ...}}, all
// optional. Throws Error that names the line.
FamilyGroups read_family_groups(const std::string& path);

// Families of every fold, sorted; folds hold about as many families. The largest group goes first to the fold with the
// fewest families (then the fewest characters, then the lowest number), so the same input gives the same folds.
// families: name -> number of characters. Throws Error when there are fewer groups than folds.
std::vector<std::vector<std::string>> make_folds(const std::map<std::string, size_t>& families,
                                                 const FamilyGroups& groups, uint32_t fold_count);

// One round of about as many draws as there are characters, shuffled. `families` names the family of each character.
// Families in `shares` have that share of the round, the others divide the rest. The fraction of a draw that is left over
// is drawn by chance, so that shares are exact in the long run.
std::vector<uint32_t> draw_round(const std::vector<std::string>& families, double power,
                                 const std::map<std::string, double>& shares, Random* random);

}  // namespace sinew
#endif
