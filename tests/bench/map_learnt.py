#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A learnt cost for maps, measured: a small network says of two joints, by places and hierarchy alone, whether they are counterparts.

    map_learnt.py EVAL LABELS --train PAIRS.tsv:RIGS[:MAPS]... [--test PAIRS.tsv:RIGS:MAPS]

EVAL is the folder of mapping_eval.py, LABELS its label files, joined by commas. MAPS holds what map_pairs.py wrote. With --test the network is trained on all of
--train and reported on --test; without, the first list's pairs are dealt to five folds by maker as map_pairs.py does, and pairs with a rig of a fold's makers are
reported by the network that saw none of them. Reported is the mean F1 of the command's maps, of the network alone (assignment of highest sums), and of both: the
network's logits plus a bonus for what the command maps, bonus and bound chosen on pairs of makers that neither trained on nor reported are. Needs numpy and scipy."""
import os
import sys
import numpy as np
from scipy.optimize import linear_sum_assignment

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
FOLDS, HIDDEN, STEPS, BATCH = 5, (48, 24), 1500, 4096
CERTAIN = 6  # of logits: of what it never saw a network says anything
MOST = 150  # pairs of a fold that are reported


def maker(rig):
    return rig.split('_')[0]


def joint_features(rig):
    """[J, D]: places in the rig's box, the bone to the parent, what is below and above, whether there is a mirror image."""
    names = rig.names
    index = {name: i for i, name in enumerate(names)}
    place = np.array([rig.pos[name] for name in names])
    parent = np.array([index.get(rig.parent.get(name), -1) for name in names])
    low, high = place.min(0), place.max(0)
    size = (high - low).max() or 1.0
    middle = (low + high) / 2
    middle[1] = low[1]
    p = (place - middle) / size
    count = len(names)
    children = [[] for _ in names]
    for j, up in enumerate(parent):
        if up >= 0:
            children[up].append(j)
    order, stack = [], [j for j in range(count) if parent[j] < 0]
    while stack:
        j = stack.pop()
        order.append(j)
        stack.extend(children[j])
    depth, along, since = np.zeros(count), np.zeros(count), np.zeros(count)
    bone = np.zeros((count, 3))
    for j in order:
        up = parent[j]
        if up < 0:
            continue
        bone[j] = p[j] - p[up]
        depth[j] = depth[up] + 1
        along[j] = along[up] + np.linalg.norm(bone[j])
        since[j] = 0 if len(children[up]) > 1 else since[up] + 1
    below, leaves, reach, until = np.ones(count), np.zeros(count), np.zeros(count), np.zeros(count)
    least, most, far = p.copy(), p.copy(), p.copy()
    for j in reversed(order):
        leaves[j] = max(leaves[j], 1 if not children[j] else 0)
        until[j] = until[children[j][0]] + 1 if len(children[j]) == 1 else 0
        for c in children[j]:
            below[j] += below[c]
            leaves[j] += leaves[c]
            least[j], most[j] = np.minimum(least[j], least[c]), np.maximum(most[j], most[c])
            if np.linalg.norm(bone[c]) + reach[c] > reach[j]:
                reach[j], far[j] = np.linalg.norm(bone[c]) + reach[c], far[c]
    image = np.linalg.norm((p * [-1, 1, 1])[:, None] - p[None], axis=2).min(1)
    up = np.where(parent < 0, np.arange(count), parent)
    ranks = np.zeros((count, 3))
    for j in range(count):
        others = children[parent[j]] if parent[j] >= 0 else [j]
        ranks[j] = [(p[others, a] < p[j, a] - 1e-6).sum() / max(1, len(others) - 1) for a in range(3)]
    columns = [p, p[up], p[up[up]], bone, (high - low) / size + 0 * p, np.abs(p[:, :1]), least - p, most - p, far - p, ranks,
               np.stack([depth / 10, depth / max(1, depth.max()), along, since / 5, until / 5, below / count, np.log(below), np.log(leaves), reach, image,
                         np.array([len(c) for c in children]) / 5.0, np.array([len(children[u]) for u in up]) / 5.0, np.log(count) * np.ones(count)], 1)]
    return np.concatenate(columns, 1).astype(np.float32)


class Network:
    """Two features and their difference in, a logit out."""

    def __init__(self, width, seed=0):
        rng = np.random.RandomState(seed)
        sizes = (width,) + HIDDEN + (1,)
        self.w = [rng.randn(a, b).astype(np.float32) * np.sqrt(2 / a) for a, b in zip(sizes, sizes[1:])]
        self.b = [np.zeros(b, np.float32) for b in sizes[1:]]
        self.mean, self.scale = np.zeros(width, np.float32), np.ones(width, np.float32)

    def forward(self, x):
        layers = [(x - self.mean) / self.scale]
        for k, (w, b) in enumerate(zip(self.w, self.b)):
            y = layers[-1] @ w + b
            layers.append(np.maximum(y, 0) if k + 1 < len(self.w) else y)
        return layers

    def train(self, x, y, seed=0):
        rng = np.random.RandomState(seed)
        self.mean, self.scale = x.mean(0), x.std(0) + 1e-3
        values = self.w + self.b
        first, second = [np.zeros_like(v) for v in values], [np.zeros_like(v) for v in values]
        for step in range(STEPS):
            pick = rng.randint(len(x), size=BATCH)
            layers = self.forward(x[pick])
            grad = ((1 / (1 + np.exp(-np.clip(layers[-1][:, 0], -30, 30))) - y[pick]) / BATCH)[:, None].astype(np.float32)
            gw, gb = [], []
            for k in reversed(range(len(self.w))):
                gw.insert(0, layers[k].T @ grad + 1e-5 * self.w[k])
                gb.insert(0, grad.sum(0))
                grad = (grad @ self.w[k].T) * (layers[k] > 0)
            rate = 3e-3 * (1 - step / STEPS)
            for v, g, m, s in zip(values, gw + gb, first, second):
                m += 0.1 * (g - m)
                s += 0.001 * (g * g - s)
                v -= rate * (m / (1 - 0.9 ** (step + 1))) / (np.sqrt(s / (1 - 0.999 ** (step + 1))) + 1e-8)


def pair_input(a, b):
    return np.concatenate([a, b, np.abs(a - b)], -1)


class Study:
    def __init__(self, folder, labels):
        sys.path.insert(0, folder)
        import mapping_eval
        self.scorer = mapping_eval
        self.labels = mapping_eval.read_labels(labels)
        self.rigs, self.features, self.truths = {}, {}, {}

    def read(self, text):
        """Rows (target, source, rigs' folder, maps' folder or '')."""
        pairs, rigs, maps = (text.split(':') + [''])[:3]
        return [(t, s, rigs, maps) for _, t, s in (line.split() for line in open(pairs, encoding='utf-8') if line.strip())]

    def rig(self, name, folder):
        if name not in self.rigs:
            self.rigs[name] = self.scorer.Rig(f'{folder}/{name}.rig.txt', self.labels)
            self.features[name] = joint_features(self.rigs[name])
        return self.rigs[name]

    def truth(self, row):
        """[T, S] of joints that are counterparts."""
        if row[:2] not in self.truths:
            T, S = self.rig(row[0], row[2]), self.rig(row[1], row[2])
            self.truths[row[:2]] = np.array([[self.scorer.accept(T, t, S, s) for s in S.names] for t in T.names])
        return self.truths[row[:2]]

    def samples(self, rows, seed=0):
        rng = np.random.RandomState(seed)
        x, y = [], []
        for row in rows:
            truth = self.truth(row)
            T = self.rig(row[0], row[2])
            said = np.array([bool(T.alts[t]) for t in T.names])
            right = np.argwhere(truth)
            wrong = np.argwhere(~truth & said[:, None])
            wrong = wrong[rng.randint(len(wrong), size=min(len(wrong), 4 * len(right) + 20))]
            for found, value in ((right, 1.0), (wrong, 0.0)):
                if len(found):
                    x.append(pair_input(self.features[row[0]][found[:, 0]], self.features[row[1]][found[:, 1]]))
                    y.append(np.full(len(found), value, np.float32))
        return np.concatenate(x), np.concatenate(y)

    def logits(self, network, row):
        a, b = self.features[row[0]], self.features[row[1]]
        self.rig(row[0], row[2]), self.rig(row[1], row[2])
        x = pair_input(np.broadcast_to(a[:, None], (len(a), len(b), a.shape[1])), np.broadcast_to(b[None], (len(a), len(b), b.shape[1])))
        return np.clip(network.forward(x.reshape(-1, x.shape[2]))[-1].reshape(len(a), len(b)), -CERTAIN, CERTAIN)

    def command_map(self, row):
        T, S = self.rig(row[0], row[2]), self.rig(row[1], row[2])
        return self.scorer.read_map(f'{row[3]}/{row[0]}~{row[1]}.map', T, S)

    def score(self, row, own):
        return self.scorer.score(self.rig(row[0], row[2]), self.rig(row[1], row[2]), own)['f1']

    def assigned(self, row, logits, bonus, bound):
        T, S = self.rig(row[0], row[2]), self.rig(row[1], row[2])
        value = logits.copy()
        if bonus > 0:
            at = {s: k for k, s in enumerate(S.names)}
            own = self.command_map(row)
            for i, t in enumerate(T.names):
                if t in own:
                    value[i, at[own[t]]] += bonus
        gain = np.maximum(value - bound, 0)
        return {T.names[i]: S.names[j] for i, j in zip(*linear_sum_assignment(-gain)) if gain[i, j] > 0}

    def choose(self, network, rows):
        """(bound alone, bonus, bound of both) with the best mean over rows."""
        logits = [self.logits(network, row) for row in rows]

        def best(options):
            return max(options, key=lambda o: np.mean([self.score(row, self.assigned(row, l, *o)) for row, l in zip(rows, logits)]))
        alone = best([(0, bound) for bound in (-2, -1, 0, 1, 2)])
        both = best([(bonus, bound) for bonus in (2, 4, 8, 16) for bound in (-2, 0, 2, 4)])
        return alone, both


def thinned(rows, most, seed=0):
    return rows if len(rows) <= most else [rows[k] for k in np.random.RandomState(seed).permutation(len(rows))[:most]]


def measure(study, train, test):
    """(F1 of the command, of the network, of both) for each row of test; a fifth of the training makers chooses."""
    makers = sorted({maker(name) for row in train for name in row[:2]})
    held = set(makers[::5])
    chooses = [row for row in train if row[3] and {maker(row[0]), maker(row[1])} & held]
    trains = [row for row in train if not {maker(row[0]), maker(row[1])} & held]
    x, y = study.samples(trains)
    network = Network(x.shape[1])
    network.train(x, y)
    alone, both = study.choose(network, thinned(chooses, 40))
    print(f'  {len(trains)} pairs train, {len(x)} samples; bound alone {alone[1]}, bonus and bound of both {both}', flush=True)
    out = []
    for row in test:
        logits = study.logits(network, row)
        out.append([study.score(row, study.command_map(row))] + [study.score(row, study.assigned(row, logits, *o)) for o in (alone, both)])
    return np.array(out)


def report(name, found):
    print(f'{name:10s} {len(found):5d} pairs  command {found[:, 0].mean():.3f}  network {found[:, 1].mean():.3f}  both {found[:, 2].mean():.3f}', flush=True)


def main():
    argv, test = sys.argv[1:], None
    if len(argv) < 4 or argv[2] != '--train':
        sys.exit(__doc__)
    study = Study(argv[0], argv[1].split(','))
    if '--test' in argv:
        test = argv[argv.index('--test') + 1]
        argv = argv[:argv.index('--test')]
    lists = [study.read(text) for text in argv[3:]]
    every = [row for rows in lists for row in rows]
    for row in every + (study.read(test) if test else []):
        study.rig(row[0], row[2]), study.rig(row[1], row[2])
    if test:
        rows = study.read(test)
        seen = {maker(name) for row in rows for name in row[:2]}
        report('test', measure(study, every, rows))
        print(f'  makers of both: {len(seen & {maker(name) for row in every for name in row[:2]})} of {len(seen)}')
        return
    count = {}
    for row in lists[0]:
        for name in {maker(row[0]), maker(row[1])}:
            count.setdefault(name, []).append(row)
    folds = [[] for _ in range(FOLDS)]
    for name, own in sorted(count.items(), key=lambda item: (-len(item[1]), item[0])):
        min(folds, key=lambda fold: sum(len(count[n]) for n in fold)).append(name)
    means = []
    for number, fold in enumerate(folds, 1):
        def of_fold(row):
            return bool({maker(row[0]), maker(row[1])} & set(fold))
        found = measure(study, [row for row in every if not of_fold(row)], thinned([row for row in lists[0] if of_fold(row)], MOST))
        report(f'fold {number}', found)
        means.append(found.mean(0))
    print('mean of folds: command %.3f  network %.3f  both %.3f' % tuple(np.mean(means, 0)))


main()
