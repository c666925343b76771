// SPDX-License-Identifier: MIT
// A .usdz: a zip of stored files whose bytes begin at multiples of 64 (openusd.org, "Usdz File Format Specification").
#ifndef SINEW_FORMATS_USD_USD_PACKAGE_HPP
#define SINEW_FORMATS_USD_USD_PACKAGE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/io.hpp"

namespace sinew {

// Names are those inside, in this order: the first file is the one that programs open. The same bytes for the same files.
// Throws Error naming `path` above 4 GiB.
std::vector<uint8_t> usd_package(const std::string& path, const std::vector<NamedBytes>& files);

}  // namespace sinew
#endif
