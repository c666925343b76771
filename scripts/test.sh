#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds with warnings as errors, and runs every test; then the engine on emulated processors and the tests of engine,
# formats and quant again under AddressSanitizer and UndefinedBehaviorSanitizer. `scripts/test.sh quick` leaves both out.
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck disable=SC2046  # several packages
scripts/setup.sh $(scripts/conformance.sh --packages ci) $(samples/web/build.sh --packages) $(samples/python/build.sh --packages) \
  $(tests/integration/csharp_test.sh --packages)
jobs=$(nproc)

echo "== format"
scripts/format.sh --check
echo "== release build"
cmake --preset ci >/dev/null
cmake --build --preset ci -j "$jobs"
ctest --test-dir build/release --output-on-failure -j "$jobs"
if [ "${1:-}" != quick ]; then
  echo "== conformance"
  # Native targets were tests above.
  scripts/conformance.sh ci
  scripts/conformance.sh --kernels aarch64 cortex-m7
  echo "== sanitizer build"
  # Engine, formats and quant: what reads files from strangers. The trainer under sanitizers is `cmake --preset dev` by hand.
  cmake --preset dev -DSINEW_BUILD_TRAINER=OFF -DSINEW_BUILD_SAMPLES=OFF >/dev/null
  cmake --build --preset dev -j "$jobs"
  # Without the data folder, which is large: those cases ran above.
  SINEW_SHARED_DIR=none ctest --test-dir build/dev --output-on-failure -j "$jobs" -LE 'slow|tools'
fi
echo "all tests passed"
