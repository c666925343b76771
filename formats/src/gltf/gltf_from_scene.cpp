// SPDX-License-Identifier: MIT
#include "gltf/gltf_from_scene.hpp"

#include <utility>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

bool is_scene_file(const std::string& path) {
  const FileKind* kind = file_kind(path);
  return kind != nullptr && (kind->reader == FileReader::kScene || kind->reader == FileReader::kIqm);
}

GltfSource gltf_from_scene(const std::string& path) {
  std::vector<std::string> notes;
  const bool iqm = file_kind(path)->reader == FileReader::kIqm;
  GltfSource source = load_gltf(path, iqm ? iqm_to_glb(path, &notes) : scene_to_glb(path, &notes));
  source.notes = std::move(notes);
  source.path.clear();
  return source;
}

#if !defined(SINEW_HAS_ASSIMP) && !defined(SINEW_SCENES_ELSEWHERE)

std::vector<uint8_t> scene_to_glb(const std::string& path, std::vector<std::string>*) {
  (void)read_file(path);  // reports a missing file as such
  throw Error(path + ": cannot read " + file_kind(path)->name +
              ", this sinew was built without Assimp; install libassimp-dev and build again, or export as .glb");
}

#endif

}  // namespace sinew
