// SPDX-License-Identifier: MIT
// sinew/character.h for JavaScript: src/character.js makes its calls (CMakeLists.txt lists them), this reports their progress.
#include "sinew/character.h"

#include <emscripten.h>

EM_JS(int, tell_progress, (uint32_t permille),
      { return Module["onProgress"] && Object.is(Module["onProgress"](permille / 1000), true) ? 1 : 0; });

extern "C" EMSCRIPTEN_KEEPALIVE sinew_progress character_progress() {
  return [](void*, uint32_t permille) -> int { return tell_progress(permille); };
}
