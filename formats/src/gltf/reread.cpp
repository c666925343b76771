// SPDX-License-Identifier: MIT
#include "gltf/reread.hpp"

#include <utility>

#include "gltf/gltf_container.hpp"

namespace sinew {

std::shared_ptr<GltfSource> read_again(const std::string& name, GltfSource changed) {
  auto fresh = std::make_shared<GltfSource>(std::move(changed));
  GltfSource read = load_gltf(fresh->path.empty() ? name : fresh->path, pack_glb(name, &fresh->document, fresh->bytes));
  fresh->model = std::move(read.model);
  fresh->document = std::move(read.document);
  fresh->bytes = std::move(read.bytes);
  return fresh;
}

}  // namespace sinew
