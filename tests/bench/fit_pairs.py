#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which pairs of skeletons are refused as no fit (sinew map --json: "cover" below 0.5), for pairs that fit and for those that a person refuses.

    fit_pairs.py SINEW PAIRS.tsv RIGS LABELS.tsv OUT [options of `sinew map`, such as --no-names]
    fit_pairs.py --list RIGS LABELS.tsv > PAIRS.tsv

PAIRS.tsv has lines GROUP TARGET SOURCE, RIGS holds NAME.rig.txt, LABELS.tsv has lines RIG JOINT LABEL. Pairs of group `cross` (people and four-legged
animals) are to be refused, all others fit. Of the sources that people have, halves are made by their labels and are to be refused on
everybody: `upper` has no legs, `lower` nothing above the hips. OUT gets them. --list draws 260 pairs of people, 80 of four-legged animals and 260 of one
of each from the labelled rigs of a folder, families (what stands before `__`) alike often, people from two families. People have labelled arms and
legs and go upright."""
import json
import math
import os
import random
import re
import subprocess
import sys
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor

LEG = re.compile(r'^[lr]_(hipjoint|upleg|lowleg|foot|toe)')
UPPER = re.compile(r'^([lr]_(shoulder|upperarm|lowerarm|hand)|neck|head|spine[2-9])')
PEOPLE = ('biped', 'motion', 'added_biped')


def half(source, target, labels, cut):
    """The rig without the joints whose label matches `cut`, and all below them."""
    with open(source, encoding='utf-8') as file:
        lines = [line.split() for line in file if line.split() and line.split()[0] in ('joints', 'root', 'hier')]
    below = defaultdict(list)
    for line in lines:
        if line[0] == 'hier':
            below[line[1]].append(line[2])
    gone, open_ = set(), [line[1] for line in lines if line[0] == 'joints' and cut.match(labels.get(line[1], '-'))]
    if not open_:
        return False
    while open_:
        joint = open_.pop()
        if joint not in gone:
            gone.add(joint)
            open_ += below[joint]
    kept = [line for line in lines if not any(word in gone for word in (line[1:3] if line[0] == 'hier' else line[1:2]))]
    with open(target, 'w', encoding='utf-8') as file:
        file.writelines(' '.join(line) + '\n' for line in kept)
    return True


def read_labels(path):
    labels = defaultdict(dict)
    with open(path, encoding='utf-8') as file:
        for line in file:
            rig, joint, label = line.rstrip('\n').split('\t')[:3]
            labels[rig][joint] = label
    return labels


def goes_upright(path, labels):
    """Upper arms are more above the thighs than beside them (y up)."""
    ends = {'upperarm': [], 'upleg': []}
    with open(path, encoding='utf-8') as file:
        for words in map(str.split, file):
            if words[:1] != ['joints']:
                continue
            name = re.sub(r'^[lr]_', '', labels.get(words[1], '-').split('|')[0].rstrip('?'))
            if name in ends:
                ends[name].append([float(word) for word in words[2:5]])
    arms, legs = ([sum(axis) / len(points) for axis in zip(*points)] for points in ends.values())
    return arms[1] - legs[1] > math.hypot(arms[0] - legs[0], arms[2] - legs[2])


def list_pairs(rigs, labels):
    people, animals = defaultdict(list), defaultdict(list)
    for rig in sorted(labels):
        path = f'{rigs}/{rig}.rig.txt'
        names = {label.split('|')[0].rstrip('?') for label in labels[rig].values()}
        if not os.path.exists(path):
            continue
        family = rig.split('__')[0]
        if {'l_upperarm', 'l_lowerarm', 'r_upperarm', 'l_upleg', 'l_lowleg', 'r_upleg'} <= names:
            if goes_upright(path, labels[rig]):
                people[family].append(rig)
        elif any(name.startswith('l_foreleg') for name in names) and any(name.startswith('l_hindleg') for name in names):
            animals[family].append(rig)
    draw = random.Random(33)

    def some(kind):
        return draw.choice(kind[draw.choice(sorted(kind))])

    pairs = set()
    for group, count, targets, sources in (('biped', 260, people, people), ('quad', 80, animals, animals), ('cross', 130, people, animals),
                                           ('cross', 130, animals, people)):
        wanted = len(pairs) + count
        for _ in range(100 * count):
            target, source = some(targets), some(sources)
            alike = target.split('__')[0] == source.split('__')[0]
            if len(pairs) < wanted and target != source and not (group == 'biped' and alike):
                pairs.add((group, target, source))
    for pair in sorted(pairs):
        print(*pair)


def main():
    if len(sys.argv) == 4 and sys.argv[1] == '--list':
        return list_pairs(sys.argv[2], read_labels(sys.argv[3]))
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    program, pairs, rigs, labels_file, out, options = *sys.argv[1:6], sys.argv[6:]
    os.makedirs(out, exist_ok=True)
    labels = read_labels(labels_file)
    work = []
    with open(pairs, encoding='utf-8') as file:
        for line in file:
            group, target, source = line.split()
            work.append((group, f'{rigs}/{target}.rig.txt', f'{rigs}/{source}.rig.txt'))
            for name, cut in (('upper', LEG), ('lower', UPPER)) if group in PEOPLE else ():
                made = f'{out}/{source}.{name}.rig.txt'
                if os.path.exists(made) or half(f'{rigs}/{source}.rig.txt', made, labels[source], cut):
                    work.append((name, f'{rigs}/{target}.rig.txt', made))

    def run(pair):
        done = subprocess.run([program, 'map', pair[1], '--from', pair[2], '--json'] + options, capture_output=True, text=True)
        found = json.loads(done.stdout) if done.returncode == 0 else {'cover': 0, 'missing': done.stderr.strip()}
        return pair, found

    groups = defaultdict(list)
    with ThreadPoolExecutor(os.cpu_count()) as pool, open(f'{out}/fits.tsv', 'w', encoding='utf-8') as file:
        for (group, target, source), found in pool.map(run, work):
            groups[group].append(found['cover'] < 0.5)
            names = [os.path.basename(path).replace('.rig.txt', '') for path in (target, source)]
            file.write(f"{group}\t{names[0]}\t{names[1]}\t{found['cover']:.3f}\t{found.get('missing', '')}\n")
    refused = {True: [], False: []}
    for group, all_of in groups.items():
        print(f'{group:12s} {100 * sum(all_of) / len(all_of):6.2f} % of {len(all_of)} refused')
        refused[group in ('cross', 'upper', 'lower')] += all_of
    print(f'to be refused: {100 * sum(refused[True]) / max(1, len(refused[True])):.2f} %   that fit: {100 * sum(refused[False]) / max(1, len(refused[False])):.2f} %')


main()
