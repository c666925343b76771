#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The same bytes from other native compilers and every kernel: the compiler of this build, and clang without optimization and with 128-bit products of
# our own. scripts/conformance.sh has more.
#   golden_test.sh SOURCE_DIR WORK_DIR HASH_STAGES   HASH_STAGES: the program as this build has it
#   golden_test.sh SOURCE_DIR WORK_DIR --update      rewrites samples.txt and conformance.txt
set -euo pipefail
[ "$3" != --update ] || exec "$1/scripts/conformance.sh" --work "$2" --update gcc-O3
mkdir -p "$2/built"
ln -sf "$3" "$2/built/hash_stages"
exec "$1/scripts/conformance.sh" --work "$2" built clang-O0
