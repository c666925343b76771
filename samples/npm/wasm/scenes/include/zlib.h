/* SPDX-License-Identifier: MIT
 * zlib's names for miniz, as far as Assimp's Compression.cpp uses them. */
#ifndef SINEW_SCENES_ZLIB_H
#define SINEW_SCENES_ZLIB_H

#define MINIZ_HEADER_FILE_ONLY
#define MINIZ_NO_STDIO
#define MINIZ_NO_TIME
#define MINIZ_NO_ARCHIVE_APIS
#ifdef __cplusplus
#include <cstdint> /* before Byte and the like */
#include <vector>
#endif
#include "miniz.h"

#ifndef Z_BINARY
#define Z_BINARY 0
#define Z_ASCII 1
#endif
#ifndef Z_TREES
#define Z_TREES 6
#endif
/* Of MSZIP in .x files, which are not read here. */
static inline int inflateReset(mz_streamp stream) { return stream == NULL; }
static inline int inflateSetDictionary(mz_streamp stream, const unsigned char* bytes, unsigned size) {
  return stream == NULL && bytes == NULL && size == 0;
}

#endif
