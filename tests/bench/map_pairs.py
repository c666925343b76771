#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Maps a list of pairs of skeletons with the sinew command, for a scorer of maps.

    map_pairs.py SINEW PAIRS.tsv RIGS OUT [options of `sinew map`, such as --no-names --ends ends.tsv]
    map_pairs.py --folds SCORES.json

PAIRS.tsv has lines GROUP TARGET SOURCE; RIGS holds NAME.rig.txt; OUT gets TARGET~SOURCE.map. SCORES.json of the scorer has a row "GROUP TARGET SOURCE"
with "f1" and "errors" (pairs TARGET_JOINT SOURCE_JOINT) for each. --folds reports them by maker: a maker is what stands before the first `_` of a rig's
name (`q_fish__Shark`: Quaternius), makers are dealt to five folds, those with most pairs first, each to the fold with the fewest; a fold's pairs are those with a rig of its makers. What
is chosen on the other four is reported on the fifth."""
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor


FOLDS = 5


def maker(rig):
    return rig.split('_')[0]


def deal(pairs):
    """The makers of every fold: [FOLDS] lists of (maker, its pairs)."""
    of_maker = {}
    for target, source in pairs:
        for name in {maker(target), maker(source)}:
            of_maker.setdefault(name, []).append((target, source))
    folds = [[] for _ in range(FOLDS)]
    for name, own in sorted(of_maker.items(), key=lambda item: (-len(item[1]), item[0])):
        min(folds, key=lambda fold: sum(len(pairs) for _, pairs in fold)).append((name, own))
    return folds


def report_folds(path):
    with open(path, encoding='utf-8') as file:
        scores = {tuple(key.split()[1:]): row for key, row in json.load(file).items()}
    means = []
    for number, fold in enumerate(deal(scores), 1):
        own = sorted({pair for _, pairs in fold for pair in pairs})
        f1 = [scores[pair]['f1'] for pair in own]
        means.append(sum(f1) / len(f1))
        print(f'fold {number}  F1 {means[-1]:.3f}  {len(own)} pairs')
        for name, pairs in fold:
            print(f'    {name:12s} F1 {sum(scores[pair]["f1"] for pair in pairs) / len(pairs):.3f}  {len(pairs)} pairs')
        worst = {}
        for pair in own:
            for rig in pair:
                worst.setdefault(rig, []).append(scores[pair]['f1'])
        lines = sorted((sum(values) / len(values), rig) for rig, values in worst.items() if maker(rig) in {name for name, _ in fold})
        print('    worst: ' + ', '.join(f'{rig} {value:.3f}' for value, rig in lines[:5]))
    print(f'mean of folds F1 {sum(means) / len(means):.3f}')


def main():
    if len(sys.argv) == 3 and sys.argv[1] == '--folds':
        return report_folds(sys.argv[2])
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
