// SPDX-License-Identifier: MIT
// Fuzz target: pictures of strangers, down to their meshes. PNG and JPEG by their first bytes; all others are a side, and colors of pixels.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "fuzz.hpp"
#include "sinew_character/picture/figure.hpp"
#include "sinew_character/picture/picture_mesh.hpp"
#include "sinew_formats/error.hpp"

namespace {

using sinew::test::demand;

sinew::PictureFile picture_of(const uint8_t* data, size_t size) {
  if (size > 0 && (data[0] == 0x89 || data[0] == 0xff)) return sinew::decode_picture("input", {data, data + size});
  sinew::test::Bytes bytes(data, size);
  sinew::PictureFile out;
  out.name = "input";
  out.bytes = std::make_shared<const std::vector<uint8_t>>();
  out.pixels.width = 1 + bytes.u8() % 64u;
  out.pixels.height = 1 + bytes.u8() % 64u;
  for (size_t p = 0; p < size_t{out.pixels.width} * out.pixels.height; ++p) {
    const uint8_t color = bytes.u8();  // 2 bits a channel
    for (const int shift : {6, 4, 2}) out.pixels.rgba.push_back(static_cast<uint8_t>((color >> shift & 3) * 85));
    out.pixels.rgba.push_back((color & 3) == 3 ? 0 : 255);
  }
  return out;
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const sinew::PictureFile picture = picture_of(data, size);
    const sinew::Pixels& pixels = picture.pixels;
    demand(pixels.rgba.size() == size_t{4} * pixels.width * pixels.height, "pixels are whole");
    if (pixels.rgba.size() > size_t{4} * 128 * 128) return 0;  // the same work, only more of it
    const sinew::Character mesh = sinew::picture_mesh(picture, sinew::find_figure(picture));
    demand(mesh.face_vertices.size() == 3 * mesh.face_count(), "faces are triangles");
    demand(mesh.corner_uvs.size() == mesh.face_vertices.size(), "every corner has its place in the picture");
    for (const uint32_t v : mesh.face_vertices) demand(v < mesh.vertices.size(), "corners name vertices");
    for (const sinew::Vec3& v : mesh.vertices)
      demand(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "places are finite");
    for (const auto& uv : mesh.corner_uvs)
      demand(uv[0] >= 0 && uv[0] <= 1 && uv[1] >= 0 && uv[1] <= 1, "UVs are in the picture");
  } catch (const sinew::Error& error) {
    const std::string text = error.what();
    demand(text.rfind("input: ", 0) == 0, "an error begins with its file: " + text);
    demand(text.find('\n') == std::string::npos && text.size() < 1000, "an error is a short line: " + text);
  }
  return 0;
}
