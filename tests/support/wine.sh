# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced with a folder for wine's files as argument: run_wine PROGRAM.exe ARGUMENT... runs a Windows program there, without a display and
# without a trace in the user's home, and gives its lines without carriage returns.
if ! command -v wine >/dev/null; then
  echo "wine: wine is not installed: scripts/setup.sh wine wine64" >&2
  exit 1
fi
mkdir -p "$1"
WINEPREFIX=$(cd "$1" && pwd)
export WINEPREFIX WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml,winemenubuilder.exe="
run_wine() {
  # The first program waits for wine to fill its folder, which says so on stderr.
  [ -f "$WINEPREFIX/system.reg" ] || timeout 300 wine wineboot --init >"$WINEPREFIX/../wine.log" 2>&1 || { cat "$WINEPREFIX/../wine.log" >&2; return 1; }
  timeout 600 wine "$@" | tr -d '\r'
}
