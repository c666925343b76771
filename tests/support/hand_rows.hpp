// SPDX-License-Identifier: MIT
// Rows of weights made by hand, and a block of memory for the stages that work on them.
#ifndef SINEW_TESTS_SUPPORT_HAND_ROWS_HPP
#define SINEW_TESTS_SUPPORT_HAND_ROWS_HPP

#include <initializer_list>
#include <utility>
#include <vector>

#include "sinew/sinew.hpp"
#include "weights/rows.hpp"

namespace sinew_test {

// Rows of `vertices` vertices, empty at first.
class HandRows {
 public:
  explicit HandRows(uint32_t vertices)
      : joints_(size_t{vertices} * sinew::kRowSlots, sinew::kNoJoint),
        weights_(size_t{vertices} * sinew::kRowSlots, 0),
        kinds_(vertices, sinew::GivenKind::kFree) {
    rows.joints = joints_.data();
    rows.weights = weights_.data();
    given.rows = rows;
    given.kind = kinds_.data();
  }
  HandRows(const HandRows&) = delete;
  HandRows& operator=(const HandRows&) = delete;

  void set(uint32_t vertex, std::initializer_list<std::pair<uint16_t, uint32_t>> row) {
    rows.clear(vertex);
    for (const auto& [joint, weight] : row) rows.add(vertex, joint, weight);
  }
  void give(uint32_t vertex, sinew::GivenKind kind, std::initializer_list<std::pair<uint16_t, uint32_t>> row) {
    set(vertex, row);
    given.kind[vertex] = kind;
  }
  // All of a row, to compare it.
  std::vector<std::pair<uint16_t, uint32_t>> row(uint32_t vertex) const {
    std::vector<std::pair<uint16_t, uint32_t>> out;
    for (uint32_t i = 0; i < sinew::kRowSlots; ++i)
      out.emplace_back(rows.joints_of(vertex)[i], rows.weights_of(vertex)[i]);
    return out;
  }
  uint32_t sum(uint32_t vertex) const {
    uint32_t total = 0;
    for (uint32_t i = 0; i < sinew::kRowSlots; ++i) total += rows.weights_of(vertex)[i];
    return total;
  }

  sinew::Rows rows;
  sinew::GivenRows given;  // the same rows, as given ones

 private:
  std::vector<uint16_t> joints_;
  std::vector<uint32_t> weights_;
  std::vector<sinew::GivenKind> kinds_;
};

// Runs stage(arena) in a block of the size that it asks for itself, less `missing` bytes.
template <class Stage>
sinew_status run_measured(const Stage& stage, size_t missing = 0) {
  sinew::Arena measuring;
  const sinew_status measured = stage(measuring);
  if (measured != SINEW_OK) return measured;
  const sinew::Workspace block(measuring.high_water());
  sinew::Arena arena(block.data(), block.size() - missing);
  return stage(arena);
}

}  // namespace sinew_test
#endif
