#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The same bytes from every native compiler, optimisation level and kernel: scripts/conformance.sh with the native targets.
#   golden_test.sh SOURCE_DIR WORK_DIR [--update]     --update rewrites samples.txt and conformance.txt from the first build
set -euo pipefail
exec "$1/scripts/conformance.sh" --work "$2" ${3:+"$3"} gcc-O3 gcc-O0 clang-O3 clang-O0
