// SPDX-License-Identifier: MIT
// Draco's functions that gltf_draco.cpp calls, from its shared library (late_library.hpp). Only where SINEW_LATE_DRACO is that library's name
// (formats/CMakeLists.txt).
#include <draco/compression/decode.h>

#include "gltf/late_library.hpp"

namespace {

template <class Result, class... Arguments>
Result draco_call(const char* name, Arguments... arguments) {
  static const sinew::LateLibrary draco(SINEW_LATE_DRACO, "Draco", "libdraco-dev");
  return draco.call<Result>(name, arguments...);
}

}  // namespace

namespace draco {

DecoderBuffer::DecoderBuffer() { draco_call<void>("_ZN5draco13DecoderBufferC1Ev", this); }
DecoderBuffer::BitDecoder::BitDecoder() : bit_buffer_(nullptr), bit_buffer_end_(nullptr), bit_offset_(0) {
  draco_call<void>("_ZN5draco13DecoderBuffer10BitDecoderC1Ev", this);
}
DecoderBuffer::BitDecoder::~BitDecoder() { draco_call<void>("_ZN5draco13DecoderBuffer10BitDecoderD1Ev", this); }
void DecoderBuffer::Init(const char* data, size_t bytes) {
  draco_call<void>("_ZN5draco13DecoderBuffer4InitEPKcm", this, data, bytes);
}
StatusOr<std::unique_ptr<Mesh>> Decoder::DecodeMeshFromBuffer(DecoderBuffer* buffer) {
  return draco_call<StatusOr<std::unique_ptr<Mesh>>>("_ZN5draco7Decoder20DecodeMeshFromBufferEPNS_13DecoderBufferE",
                                                     this, buffer);
}
const PointAttribute* PointCloud::GetAttributeByUniqueId(uint32_t id) const {
  return draco_call<const PointAttribute*>("_ZNK5draco10PointCloud22GetAttributeByUniqueIdEj", this, id);
}

}  // namespace draco
