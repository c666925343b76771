// SPDX-License-Identifier: MIT
// Words of enumerations of C by number, for options. Generated from the C headers by scripts/declarations.py; a test compares.
#ifndef SINEW_CLI_ENUM_WORDS_HPP
#define SINEW_CLI_ENUM_WORDS_HPP

#include <string>
#include <vector>

namespace sinew::cli {

using Words = std::vector<std::string>;

inline const Words kRigidParts = {"auto", "always", "never"};
inline const Words kTetWeights = {"skin", "distance"};
inline const Words kMapMethod = {"auto", "sinew", "branches"};
inline const Words kCategory = {"any", "biped", "quadruped", "bird", "fish", "snake", "many-legged", "vehicle"};
inline const Words kTransferMethod = {"auto", "nearest", "biharmonic", "rebind"};
inline const Words kBranchesFirst = {"both", "target", "source"};
inline const Words kBranchesCost = {"mean", "sum"};
inline const Words kCharacterRigMethod = {"auto", "votes", "shape", "regions", "slots"};
inline const Words kCharacterDetail = {"body", "hands", "full"};
inline const Words kAnimateMethod = {"auto", "copy", "contacts", "reference-points", "stream", "node-offsets"};

}  // namespace sinew::cli
#endif
