// SPDX-License-Identifier: MIT
// Arrays of numbers of NumPy: .npy, and .npz, which is a zip of them.
#ifndef SINEW_FORMATS_MOTION_NPY_HPP
#define SINEW_FORMATS_MOTION_NPY_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sinew {

struct NpyArray {
  std::string name;            // "" of a .npy
  std::vector<size_t> shape;   // empty: one number
  std::vector<double> values;  // row by row; not all need be finite

  size_t rows() const { return shape.empty() ? 1 : shape[0]; }
  size_t width() const { return rows() == 0 ? 0 : values.size() / rows(); }  // numbers of a row
};

// Arrays without numbers (text, objects) are left out; `left_out` names them. Throws Error.
struct NpyFile {
  std::map<std::string, NpyArray> arrays;  // by name
  std::string left_out;
};
NpyFile read_npy_file(const std::string& path);

// The bytes of every file of a zip by its name: stored or deflated.
std::map<std::string, std::vector<uint8_t>> unzip(const std::string& path, const std::vector<uint8_t>& bytes);

}  // namespace sinew
#endif
