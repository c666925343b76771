// SPDX-License-Identifier: MIT
// Constants that the page downloads together with the code that reads them.
#ifndef SINEW_FORMATS_LATE_CONSTANTS_HPP
#define SINEW_FORMATS_LATE_CONSTANTS_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>

namespace sinew {

#if defined(__EMSCRIPTEN__)
namespace late {

template <typename Value>
constexpr uint64_t eight_bytes(const Value* values, size_t count, size_t from) {
  constexpr size_t kPer = 8 / sizeof(Value);
  uint64_t out = 0;
  for (size_t i = 0; i < kPer && from + i < count; ++i)
    out |= (uint64_t{static_cast<std::make_unsigned_t<Value>>(values[from + i])}) << (8 * sizeof(Value) * i);
  return out;
}

template <uint64_t kEight>
char write_eight(void* to) {
  const uint64_t eight = kEight;
  std::memcpy(to, &eight, sizeof eight);
  return 0;
}

template <const auto& kValues, size_t... kEights>
[[gnu::noinline]] void write(char* to, std::index_sequence<kEights...> /*eights*/) {
  constexpr size_t kPer = 8 / sizeof(kValues[0]);
  const char done[] = {write_eight<eight_bytes(kValues, std::size(kValues), kPer * kEights)>(to + 8 * kEights)...};
  (void)done;
}

}  // namespace late

// Takes kValues, a constexpr array of integers. The page loads all constants of a module with its first part, but
// values that are written by code with the part that has the code.
template <const auto& kValues>
const auto* late_constants() {
  using Value = std::remove_cvref_t<decltype(kValues[0])>;
  constexpr size_t kEights = (sizeof(kValues) + 7) / 8;
  alignas(8) static Value values[8 * kEights / sizeof(Value)];
  static const bool is_written =
      (late::write<kValues>(reinterpret_cast<char*>(values), std::make_index_sequence<kEights>()), true);
  (void)is_written;
  return static_cast<const Value*>(values);
}
#else
template <const auto& kValues>
const auto* late_constants() {
  return std::data(kValues);
}
#endif

}  // namespace sinew
#endif
