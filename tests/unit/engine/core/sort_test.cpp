// SPDX-License-Identifier: MIT
// Sorting against the standard library: lengths around every switch of method, equal keys, digits that all keys share.
#include "core/sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace sinew {
namespace {

TEST(HeapSort, OrdersByTheGivenComparison) {
  std::mt19937 random(1);
  for (size_t count = 0; count < 200; ++count) {
    std::vector<uint32_t> values(count);
    for (uint32_t& value : values) value = static_cast<uint32_t>(random()) % 50;
    std::vector<uint32_t> want = values;
    std::sort(want.begin(), want.end(), std::greater<uint32_t>());
    heap_sort(values.data(), count, std::greater<uint32_t>());
    ASSERT_EQ(values, want) << count;
  }
}

TEST(SortAscending, EqualsStandardSortForShortAndLongRows) {
  std::mt19937 random(2);
  for (const size_t count : {0u, 1u, 2u, 3u, 17u, 127u, 128u, 129u, 130u, 1000u}) {
    std::vector<uint32_t> values(count);
    for (uint32_t& value : values) value = static_cast<uint32_t>(random()) % 100;
    std::vector<uint32_t> want = values;
    std::sort(want.begin(), want.end());
    sort_ascending(values.data(), count);
    ASSERT_EQ(values, want) << count;
  }
}

using Pairs = std::vector<std::pair<uint64_t, uint32_t>>;

Pairs radix_sorted(const std::vector<uint64_t>& keys) {
  std::vector<uint64_t> sorted = keys, scratch_keys(keys.size(), 0xA5);
  std::vector<uint32_t> payloads, scratch(keys.size(), 0xA5);
  for (uint32_t i = 0; i < keys.size(); ++i) payloads.push_back(i);
  radix_sort_pairs(sorted.data(), payloads.data(), keys.size(), scratch_keys.data(), scratch.data());
  Pairs out;
  for (size_t i = 0; i < keys.size(); ++i) out.emplace_back(sorted[i], payloads[i]);
  return out;
}

// Each mask leaves other digits to sort: none, one (the result ends in the scratch), two, far apart, all.
TEST(RadixSortPairs, IsStableWhateverDigitsDiffer) {
  std::mt19937_64 random(3);
  for (const uint64_t mask :
       {uint64_t{0}, uint64_t{0x0F}, uint64_t{0xFFFF}, uint64_t{0xFF000000000000F0}, ~uint64_t{0}}) {
    for (const size_t count : {0u, 1u, 2u, 300u, 5000u}) {
      std::vector<uint64_t> keys(count);
      for (uint64_t& key : keys) key = (random() & mask) | (~mask & 0x1234567890ABCDEF);
      Pairs want;
      for (uint32_t i = 0; i < count; ++i) want.emplace_back(keys[i], i);
      std::stable_sort(want.begin(), want.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      ASSERT_EQ(radix_sorted(keys), want) << count << " keys, mask " << mask;
    }
  }
}

}  // namespace
}  // namespace sinew
