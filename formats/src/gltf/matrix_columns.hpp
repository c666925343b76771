// SPDX-License-Identifier: MIT
// Transforms as glTF has matrices: 4x4, column by column.
#ifndef SINEW_FORMATS_GLTF_MATRIX_COLUMNS_HPP
#define SINEW_FORMATS_GLTF_MATRIX_COLUMNS_HPP

#include <vector>

#include "sinew_formats/base/affine.hpp"

namespace sinew {

inline void append_columns(const Affine& m, std::vector<float>* values) {
  for (size_t c = 0; c < 4; ++c)
    for (size_t r = 0; r < 4; ++r) values->push_back(r < 3 ? static_cast<float>(m[r * 4 + c]) : (c == 3 ? 1.0f : 0.0f));
}
inline std::vector<float> columns_of(const Affine& m) {
  std::vector<float> out;
  append_columns(m, &out);
  return out;
}

}  // namespace sinew
#endif
