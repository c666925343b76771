// SPDX-License-Identifier: MIT
// Arrays of numbers of NumPy, from .npy and .npz.
#include "motion/npy.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr size_t kMostNumbers = size_t{1} << 27;
static_assert(std::endian::native == std::endian::little);

// The value behind 'key': in a header such as {'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }.
std::string_view value_of(std::string_view header, const char* key) {
  const size_t at = header.find("'" + std::string(key) + "'");
  const size_t colon = at == std::string_view::npos ? at : header.find(':', at);
  if (colon == std::string_view::npos) return {};
  size_t begin = colon + 1;
  while (begin < header.size() && header[begin] == ' ') ++begin;
  return header.substr(begin);
}

template <class T>
double number_at(const uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double half_at(const uint8_t* bytes) {
  const unsigned bits = bytes[0] | static_cast<unsigned>(bytes[1]) << 8, exponent = bits >> 10 & 31;
  const double fraction = bits & 1023;
  const double size = exponent == 0    ? std::ldexp(fraction, -24)
                      : exponent == 31 ? HUGE_VAL
                                       : std::ldexp(1024 + fraction, static_cast<int>(exponent) - 25);
  return (bits & 0x8000) != 0 ? -size : size;
}

struct NumberKind {
  const char* name;
  size_t bytes;
  double (*at)(const uint8_t*);
};
constexpr NumberKind kKinds[] = {
    {"<f4", 4, number_at<float>},   {"<f8", 8, number_at<double>},   {"<f2", 2, half_at},
    {"<i8", 8, number_at<int64_t>}, {"<i4", 4, number_at<int32_t>},  {"<u4", 4, number_at<uint32_t>},
    {"<i2", 2, number_at<int16_t>}, {"<u2", 2, number_at<uint16_t>}, {"|i1", 1, number_at<int8_t>},
    {"|u1", 1, number_at<uint8_t>}};

class NpyReader {
 public:
  NpyReader(std::string where, const std::vector<uint8_t>& bytes) : where_(std::move(where)), bytes_(bytes) {}

  // Nothing for an array of text or objects.
  std::optional<NpyArray> read() {
    read_header();
    const std::string_view type = value_of(header_, "descr");
    const NumberKind* kind = nullptr;
    for (const NumberKind& one : kKinds)
      if (type.substr(0, 5) == "'" + std::string(one.name) + "'") kind = &one;
    if (kind == nullptr) return std::nullopt;
    NpyArray array;
    array.shape = read_shape();
    size_t count = 1;
    for (const size_t side : array.shape) {
      if (side != 0 && count > kMostNumbers / side)
        fail("at most " + std::to_string(kMostNumbers) + " numbers", "more");
      count *= side;
    }
    if (bytes_.size() - data_ < count * kind->bytes)
      throw Error(where_ + ": truncated array, expected " + std::to_string(count) + " numbers, found " +
                  std::to_string((bytes_.size() - data_) / kind->bytes));
    for (size_t i = 0; i < count; ++i) array.values.push_back(kind->at(bytes_.data() + data_ + kind->bytes * i));
    if (value_of(header_, "fortran_order").substr(0, 4) == "True") by_rows(&array);
    return array;
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(where_ + ": expected " + expected + ", found " + found);
  }

  void read_header() {
    if (bytes_.size() < 12 || std::memcmp(bytes_.data(), "\x93NUMPY", 6) != 0)
      fail("a NumPy array (\\x93NUMPY)", "other bytes");
    const bool wide = bytes_[6] >= 2;
    const size_t begin = wide ? 12 : 10;
    const size_t size = static_cast<size_t>(wide ? number_at<uint32_t>(&bytes_[8]) : number_at<uint16_t>(&bytes_[8]));
    if (size > bytes_.size() - begin)
      throw Error(where_ + ": truncated array, expected a header of " + std::to_string(size) + " bytes");
    header_ = {reinterpret_cast<const char*>(bytes_.data()) + begin, size};
    data_ = begin + size;
  }

  std::vector<size_t> read_shape() const {
    std::string_view text = value_of(header_, "shape");
    const size_t end = text.find(')');
    if (text.empty() || text[0] != '(' || end == std::string_view::npos)
      fail("a 'shape' such as (3, 4)", in_quotes(text));
    std::vector<size_t> shape;
    std::string digits;
    for (const char c : text.substr(1, end)) {
      if (c >= '0' && c <= '9') {
        digits += c;
      } else if (c == ' ' || c == ',' || c == ')' || c == 'L') {
        if (digits.empty()) continue;
        const std::optional<int64_t> side = to_integer(digits);
        if (!side || shape.size() == 8) fail("a 'shape' such as (3, 4)", in_quotes(text));
        shape.push_back(static_cast<size_t>(*side));
        digits.clear();
      } else {
        fail("a 'shape' such as (3, 4)", in_quotes(text));
      }
    }
    return shape;
  }

  // From columns first to rows first.
  static void by_rows(NpyArray* array) {
    std::vector<double> rows(array->values.size());
    std::vector<size_t> at(array->shape.size(), 0);
    for (double& value : rows) {
      size_t from = 0, step = 1;
      for (size_t i = 0; i < at.size(); ++i) {
        from += step * at[i];
        step *= array->shape[i];
      }
      value = array->values[from];
      for (size_t i = at.size(); i-- > 0 && ++at[i] == array->shape[i];) at[i] = 0;
    }
    array->values = std::move(rows);
  }

  const std::string where_;
  const std::vector<uint8_t>& bytes_;
  std::string_view header_;
  size_t data_ = 0;
};

}  // namespace

NpyFile read_npy_file(const std::string& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  NpyFile file;
  if (!has_extension(path, ".npz")) {
    std::optional<NpyArray> array = NpyReader(path, bytes).read();
    if (!array)
      throw Error(path +
                  ": expected an array of numbers, found text or pickled objects; save numbers with numpy.save()");
    file.arrays[""] = std::move(*array);
    return file;
  }
  for (const auto& [name, content] : unzip(path, bytes)) {
    const std::string key = has_extension(name, ".npy") ? name.substr(0, name.size() - 4) : name;
    std::optional<NpyArray> array = NpyReader(path + ": " + in_quotes(key), content).read();
    if (array) {
      array->name = key;
      file.arrays[key] = std::move(*array);
    } else {
      file.left_out += (file.left_out.empty() ? "" : ", ") + in_quotes(key);
    }
  }
  return file;
}

}  // namespace sinew
