// SPDX-License-Identifier: MIT
// A document that was changed, read again, so that its model and its JSON are one.
#ifndef SINEW_FORMATS_GLTF_REREAD_HPP
#define SINEW_FORMATS_GLTF_REREAD_HPP

#include <memory>
#include <string>

#include "gltf/gltf_source.hpp"

namespace sinew {

// Everything but the model stays as it is in `changed`. Throws Error for a document that cannot be written.
std::shared_ptr<GltfSource> read_again(const std::string& name, GltfSource changed);

}  // namespace sinew
#endif
