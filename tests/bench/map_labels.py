#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Labels and pairs of strangers' skeletons for the scorer of maps, made from map_labels.txt (rules for joint names; its head says how they are written).

    map_labels.py FOLDER... OUT

FOLDERs hold NAME.rig.txt. OUT gets labels.tsv (rig, joint, label), pairs_A.tsv and pairs_B.tsv (kind, target, source) and rigs/ (links). Pairs are of two
makers and one kind; A has those of A's rigs and partners, B all with a rig of B. A name in the rules that a rig does not have, and a rig that no folder has,
end the program with a line."""
import itertools
import os
import re
import sys

SIDE = '(?P<side>Left|Right|left|right|L|R|l|r|esq|dir)'
SUFFIX = r'(?:_\d+|_Armature)*'
HERE = os.path.dirname(os.path.abspath(__file__))


def expand(pattern):
    """X{a,b} as [Xa, Xb]; regular repeats ({2}) are not used in the rules."""
    found = re.search(r'\{([^}]*)\}', pattern)
    if not found:
        return [pattern]
    return [pattern[:found.start()] + part + pattern[found.end():] for part in found.group(1).split(',')]


def read_rules(path):
    """({rig: (kind, half, [(label, [pattern])])}, {kind: [partner]})."""
    blocks, rigs, partners, rules = {}, {}, {}, None
    for number, line in enumerate(open(path, encoding='utf-8'), 1):
        line = line.split('#')[0].rstrip()
        words = line.split()
        if not words:
            continue
        if not line.startswith(' ') and words[0] == 'use':
            rules = blocks.setdefault(words[1], [])
        elif words[0] == 'use':
            rules.extend(blocks[words[1]])
        elif words[0] == 'rig':
            rules = []
            rigs[words[1]] = (words[2], words[3], rules)
        elif words[0] == 'partner':
            partners[words[1]] = words[2:]
        elif words[0].endswith(':'):
            rules.append((words[0][:-1], [p for word in words[1:] for p in expand(word)]))
        else:
            sys.exit(f'{path}:{number}: expected use, rig, partner or LABEL:, found {words[0]}')
    return rigs, partners


def read_rig(path):
    """Joint names in the file's order, and the depth of each."""
    names, parent = [], {}
    for line in open(path, encoding='utf-8'):
        words = line.split()
        if words and words[0] == 'joints':
            names.append(words[1])
        elif words and words[0] == 'hier':
            parent[words[2]] = words[1]
    depth = {}
    for name in names:
        count, above = 0, name
        while above in parent:
            above, count = parent[above], count + 1
        depth[name] = count
    return names, depth


def found_joints(pattern, names, depth):
    """[(side, joint)] that a pattern means, along the chain: whole names, else whole names without the numbers that exporters append."""
    whole = pattern.replace('.', r'\.').replace('@', SIDE)
    for end in ('', SUFFIX):
        hits = [(re.fullmatch(f'(?:{whole}){end}', name), name) for name in names]
        hits = [('' if '@' not in pattern else 'l_' if hit['side'][0] in 'lLe' else 'r_', name) for hit, name in hits if hit]
        if hits:
            return sorted(hits, key=lambda hit: depth[hit[1]])
    return []


def label_rig(rules, names, depth):
    labels = {}
    for label, patterns in rules:
        head, star, first = label.partition('*')
        chains = {}
        for pattern in patterns:
            for side, name in found_joints(pattern, names, depth):
                if name not in labels:
                    chains.setdefault(side, []).append(name)
        for side, chain in chains.items():
            for number, name in enumerate(chain, int(first or 1)):
                labels[name] = '|'.join(side + part + (str(number) if star else '') for part in head.split('|'))
    return labels


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folders, out = sys.argv[1:-1], sys.argv[-1]
    rigs, partners = read_rules(os.path.join(HERE, 'map_labels.txt'))
    os.makedirs(f'{out}/rigs', exist_ok=True)
    with open(f'{out}/labels.tsv', 'w', encoding='utf-8') as file:
        for rig in list(rigs) + sum(partners.values(), []):
            paths = [f'{folder}/{rig}.rig.txt' for folder in folders if os.path.exists(f'{folder}/{rig}.rig.txt')]
            if not paths:
                sys.exit(f'{rig}.rig.txt is in no folder given')
            link = f'{out}/rigs/{rig}.rig.txt'
            if not os.path.lexists(link):
                os.symlink(os.path.abspath(paths[0]), link)
            if rig not in rigs:
                continue
            names, depth = read_rig(link)
            labels = label_rig(rigs[rig][2], names, depth)
            if 'hips' not in '|'.join(labels.values()):
                sys.exit(f'{rig}: no joint is called hips by its rules')
            file.writelines(f'{rig}\t{name}\t{labels.get(name, "-")}\n' for name in names)
    maker = lambda rig: rig.split('__')[0]
    for half in 'AB':
        lines = []
        for kind in sorted({kind for kind, _, _ in rigs.values()}):
            side = {rig: at for rig, (of, at, _) in rigs.items() if of == kind}
            side.update({rig: 'A' for rig in partners.get(kind, [])})
            for target, source in itertools.permutations(side, 2):
                if maker(target) == maker(source) or not {target, source} & set(rigs):
                    continue
                if ('B' if 'B' in side[target] + side[source] else 'A') == half:
                    lines.append(f'{kind} {target} {source}\n')
        with open(f'{out}/pairs_{half}.tsv', 'w', encoding='utf-8') as file:
            file.writelines(lines)
        print(f'{half}: {len(lines)} pairs')
    print(f'{len(rigs)} rigs')


main()
