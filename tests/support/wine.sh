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
  # Wine's server, which programs share, ends three seconds after the last one: a program that starts in that moment loses it. So it stays longer.
  wineserver -p300 </dev/null >/dev/null 2>&1 || true  # there is one
  # The first program waits for wine to fill its folder, which says so on stderr; a folder that wine left half filled is filled anew.
  local attempt
  for attempt in 1 2 3; do
    [ -f "$WINEPREFIX/system.reg" ] && break
    timeout 300 wine wineboot --init >"$WINEPREFIX/../wine.log" 2>&1 || { cat "$WINEPREFIX/../wine.log" >&2; rm -rf "${WINEPREFIX:?}"/*; }
  done
  # On a busy machine wine now and then does not get as far as the program and hands its file to `start`, which knows no application for it, or loses its
  # server. What wine itself ended may be run again; what a program that ran says and ends with stays as it is.
  local said=$WINEPREFIX/../wine-said.$BASHPID status=1
  for attempt in 1 2 3; do
    status=0
    timeout 600 wine "$@" >"$said.out" 2>"$said.err" || status=$?
    [ "$status" != 0 ] && grep -q -e '^Application could not be started' -e '^wine[a-z ]*:' "$said.err" || break
    echo "wine: $1 was not run by wine, attempt $attempt of 3" >&2
  done
  cat "$said.err" >&2
  tr -d '\r' <"$said.out"
  rm -f "$said.out" "$said.err"
  return "$status"
}
