// SPDX-License-Identifier: MIT
// A character's mesh without its skeleton, for programs that animate vertices without skinning.
#ifndef SINEW_FORMATS_STILL_MESH_HPP
#define SINEW_FORMATS_STILL_MESH_HPP

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct GltfSource;

// Vertices are those of the written file, primitive by primitive: a vertex of the Character is split where normals or
// texture coordinates differ.
class StillMesh {
 public:
  // Throws Error, which begins with `path`, for a mesh without faces.
  StillMesh(const std::string& path, const Character& character);

  const std::vector<uint32_t>& vertices() const { return vertices_; }  // [N] the Character's vertex of each
  const std::vector<Vec3>& normals() const { return normals_; }        // [N] in the rest pose, world axes, of length 1

  // Writes a GLB with the character's mesh nodes without transforms, its materials and pictures. TEXCOORD_1 has the
  // given coordinates; the character's own sets from 1 on, and materials that use them, are moved up by one. glTF
  // allows no gap, so a mesh without a set 0 has the given ones there too. Skins, animations, blend shapes, tangents
  // and vendor extensions of the document are left out.
  //   positions  [N] y up
  //   normals    [N] of length 1
  //   texels     [N]
  // Throws Error for a document that cannot be written.
  std::vector<uint8_t> glb(const std::vector<Vec3>& positions, const std::vector<Vec3>& normals,
                           const std::vector<std::array<float, 2>>& texels) const;

 private:
  std::string path_;
  std::shared_ptr<const GltfSource> source_;
  std::vector<uint32_t> vertices_;
  std::vector<Vec3> normals_;
};

}  // namespace sinew
#endif
