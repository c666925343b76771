// SPDX-License-Identifier: MIT
// Weights of corrective shapes over time, in the animations of a glTF document.
#ifndef SINEW_FORMATS_GLTF_MORPH_ANIMATIONS_HPP
#define SINEW_FORMATS_GLTF_MORPH_ANIMATIONS_HPP

#include <string>
#include <vector>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

class MorphAnimations {
 public:
  // model: of the document as it was given. The last `new_animations` of the document are the caller's.
  MorphAnimations(const std::string& path, const Morphs& morphs, size_t new_animations, const tinygltf::Model& model,
                  GltfSource* source)
      : path_(path),
        morphs_(morphs),
        new_animations_(new_animations),
        model_(model),
        source_(*source),
        document_(source->document) {}

  // For a node whose mesh had `before` targets and gets these shapes after them.
  void write(size_t node, const std::vector<size_t>& shapes, size_t before);
  // Accessors that may be used no more.
  const std::vector<int>& orphans() const { return orphans_; }

 private:
  void add_channel(const MorphClip& clip, size_t node, const std::vector<size_t>& shapes, size_t before,
                   Json* animation);
  void extend_channel(const MorphClip* clip, const std::vector<size_t>& shapes, size_t before, size_t number,
                      Json* animation, Json* channel);
  int add_scalars(const std::vector<float>& values);

  const std::string& path_;
  const Morphs& morphs_;
  const size_t new_animations_;
  const tinygltf::Model& model_;
  GltfSource& source_;
  Json& document_;
  std::vector<int> orphans_;
};

}  // namespace sinew
#endif
