#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Maps a list of pairs of skeletons with the sinew command, for a scorer of maps.

    map_pairs.py SINEW PAIRS.tsv RIGS OUT [options of `sinew map`, such as --no-names --ends ends.tsv]

PAIRS.tsv has lines GROUP TARGET SOURCE; RIGS holds NAME.rig.txt; OUT gets TARGET~SOURCE.map."""
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    program, pairs, rigs, out, options = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4], sys.argv[5:]
    os.makedirs(out, exist_ok=True)

    def run(line):
        _, target, source = line.split()
        done = subprocess.run(
            [program, 'map', f'{rigs}/{target}.rig.txt', '--from', f'{rigs}/{source}.rig.txt', '-o', f'{out}/{target}~{source}.map'] + options,
            capture_output=True, text=True)
        return done.stderr.strip()

    with open(pairs, encoding='utf-8') as file:
        lines = [line for line in file if line.strip()]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        failed = [error for error in pool.map(run, lines) if error]
    print(f'{len(lines)} pairs, {len(failed)} failed')
    for error in failed[:5]:
        print(error)
    sys.exit(1 if failed else 0)


main()
