// SPDX-License-Identifier: MIT
// From the probabilities that joints hang together to a tree of them.
#ifndef SINEW_TRAINER_NETWORK_CONNECTION_TREE_HPP
#define SINEW_TRAINER_NETWORK_CONNECTION_TREE_HPP

#include <cstdint>
#include <vector>

namespace sinew {

// An edge of the graph over `count` joints.
struct Connection {
  uint32_t a = 0, b = 0;
  double weight = 0;  // small where both hang together
};

// The weight function: -ln(probability + 0.01), so that a path of sure connections is light, and one that the network rules
// out costs no more than 4.6.
double connection_weight(double probability);

// Takes edges away from the heaviest to the lightest, each whose ends hang together without it, of equal ones the last
// first; what is left is the lightest spanning tree of a connected graph (Kruskal 1956, "On the shortest spanning
// subtree of a graph", construction A'), in the order given.
std::vector<Connection> without_redundant(uint32_t count, const std::vector<Connection>& connections);

// The parents of all joints, -1 for the root and for what does not hang on it.
std::vector<int> parents_from(uint32_t root, uint32_t count, const std::vector<Connection>& tree);

}  // namespace sinew
#endif
