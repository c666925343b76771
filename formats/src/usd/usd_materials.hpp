// SPDX-License-Identifier: MIT
// Materials of a glTF document as UsdPreviewSurface, and their pictures as files.
#ifndef SINEW_FORMATS_USD_USD_MATERIALS_HPP
#define SINEW_FORMATS_USD_USD_MATERIALS_HPP

#include <set>
#include <string>
#include <vector>

#include "gltf/tinygltf.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

class UsdMaterials {
 public:
  //   stem  pictures are called STEM_0.png and so on
  UsdMaterials(std::string stem, const tinygltf::Model& model);

  // "</Character/Materials/NAME>", "" for -1.
  std::string path_of(int material) const;
  bool two_sided(int material) const;
  // The scope with all of them; "" for none. Pictures are then in files().
  std::string text();
  const std::vector<NamedBytes>& files() const { return files_; }

 private:
  struct Picture;
  std::string material(size_t m);
  std::string shader(const std::string& at, const Picture& picture);
  std::string picture_of(int texture);

  const std::string stem_;
  const tinygltf::Model& model_;
  std::vector<std::string> names_;
  std::set<int> pictures_;
  std::vector<NamedBytes> files_;
};

}  // namespace sinew
#endif
