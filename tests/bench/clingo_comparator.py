#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares `latchwork entail` with clingo (Debian: gringo) on exact cautious entailment.

Random ground theories (clauses of three literals, two fifths of them negated; six atoms of ten
minimized, two varying, two fixed and open), or the .circ files given if they have one level only.
Each query is put to a process of its own of either program, with the same limit. clingo gets the
saturation encoding: a model is guessed that falsifies the query, and a disjunctive program says
that each candidate below it is none. User and system time of the process; what a process takes
for next to nothing is stated apart and not subtracted. Usage:

    tests/bench/clingo_comparator.py LATCHWORK [--seconds S] [--instances N] [FILE.circ...]
"""
import argparse
import os
import pathlib
import random
import resource
import statistics
import subprocess
import sys
import tempfile

SIZES = (50, 100, 200)
RATIOS = (1.5, 2.5, 4.0)
QUERIES = 4

# With predicates of one argument: as many without are ten times slower to ground.
SATURATION = """
atom(1..%d). {t(A)} :- atom(A).
u(A) | n(A) :- atom(A). u(A) :- atom(A), bad. n(A) :- atom(A), bad.
bad :- fixed(A), u(A), not t(A). bad :- fixed(A), n(A), t(A).
bad :- minimized(A), u(A), not t(A).
same(A) :- minimized(A), not t(A). same(A) :- minimized(A), u(A).
bad :- same(A) : minimized(A).
:- not bad. #show. #defined fixed/1. #defined minimized/1.
"""


class Theory:
    def __init__(self):
        self.atoms, self.clauses, self.queries = 0, [], []
        self.minimized, self.fixed, self.varying = [], [], []

    def circ(self, query):
        lines = ["p circ %d %d" % (self.atoms, len(self.clauses))]
        for key, atoms in (("P 1", self.minimized), ("Z", self.varying), ("Q", self.fixed)):
            lines.append("%s %s 0" % (key, " ".join(map(str, atoms))))
        lines += [" ".join(map(str, clause + [0])) for clause in self.clauses]
        lines.append("? q c %s 0" % " ".join(map(str, query)))
        return "\n".join(lines) + "\n"

    def saturation(self, query):
        """A stable model: a minimal model t that falsifies the query; u is any other."""
        rules = [SATURATION % self.atoms]
        rules += ["minimized(%d)." % atom for atom in self.minimized]
        rules += ["fixed(%d)." % atom for atom in self.fixed]
        for clause in self.clauses:
            model = [("not t(%d)" if a > 0 else "t(%d)") % abs(a) for a in clause]
            lower = [("n(%d)" if a > 0 else "u(%d)") % abs(a) for a in clause]
            rules.append(":- %s. bad :- %s." % tuple(", ".join(b or ["#true"]) for b in (model, lower)))
        rules += [":- %st(%d)." % ("" if a > 0 else "not ", abs(a)) for a in query]
        return "\n".join(rules) + "\n"


def random_theory(atoms, ratio, seed):
    dice, theory = random.Random(seed), Theory()
    theory.atoms = atoms
    for atom in range(1, atoms + 1):
        roll = dice.randrange(10)
        (theory.minimized if roll < 6 else theory.varying if roll < 8 else theory.fixed).append(atom)
    for _ in range(int(ratio * atoms)):
        clause = dice.sample(range(1, atoms + 1), 3)
        theory.clauses.append([-a if dice.randrange(5) < 2 else a for a in clause])
    for _ in range(QUERIES):
        size = dice.choice((1, 1, 2))
        theory.queries.append([dice.choice((-1, 1)) * dice.randint(1, atoms) for _ in range(size)])
    return theory


def read_circ(path):
    """Facts become clauses; nothing where there are several levels."""
    theory, levels = Theory(), set()
    for line in path.read_text().splitlines():
        words = line.split()
        if not words or words[0] in "c=xn":
            continue
        key, numbers = words[0], words[1:-1]
        if key == "p":
            theory.atoms = int(words[2])
        elif key == "P":
            levels.add(words[1])
            theory.minimized += map(int, numbers[1:])
        elif key in "ZQ":
            (theory.varying if key == "Z" else theory.fixed).extend(map(int, numbers))
        elif key == "F":
            theory.clauses += [[int(a)] for a in numbers]
        elif key == "?":
            if words[2] == "c" and len(words) > 4:
                theory.queries.append([int(a) for a in words[3:-1]])
        else:
            theory.clauses.append([int(a) for a in words[:-1]])
    return theory if len(levels) <= 1 else None


def run(command, text, seconds):
    """What the program prints, and its processor time in seconds; nothing at the limit."""
    with tempfile.NamedTemporaryFile("w", suffix=".circ" if command[-1] == "entail" else ".lp") as file:
        file.write(text)
        file.flush()

        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))

        process = subprocess.Popen(command + [file.name], stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, text=True, preexec_fn=limit)
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = status
    return None if os.WIFSIGNALED(status) else output, usage.ru_utime + usage.ru_stime


def by_latchwork(latchwork, theory, query, seconds):
    output, spent = run([latchwork, "entail"], theory.circ(query), seconds)
    answer = output.split()[1] if output else "unknown"
    return (None if answer == "unknown" else answer), spent


def by_clingo(theory, query, seconds):
    output, spent = run(["clingo", "--verbose=1", "--warn=none"], theory.saturation(query), seconds)
    if output and "UNSATISFIABLE" in output:
        return "yes", spent
    return ("no" if output and "SATISFIABLE" in output else None), spent


def row(name, instances, latchwork, seconds):
    times, undecided, differ = ([], []), [0, 0], 0
    for theory in instances:
        for query in theory.queries:
            answers = []
            for i, (answer, spent) in enumerate((by_latchwork(latchwork, theory, query, seconds),
                                                 by_clingo(theory, query, seconds))):
                times[i].append(seconds if answer is None else spent)
                undecided[i] += answer is None
                answers.append(answer)
            differ += None not in answers and answers[0] != answers[1]
    if times[0]:
        cells = ["%.4f / %.4f / %d" % (statistics.median(t), sorted(t)[int(0.9 * (len(t) - 1))], u)
                 for t, u in zip(times, undecided)]
        print("| %s | %d | %s | %s |" % (name, len(times[0]), *cells), flush=True)
    return differ


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("latchwork")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=5)
    parser.add_argument("--instances", type=int, default=3)
    options = parser.parse_intermixed_args()
    empty = random_theory(4, 0, 0)
    start = [statistics.median(each() for _ in range(9)) for each in (
        lambda: by_latchwork(options.latchwork, empty, [1], 5)[1],
        lambda: by_clingo(empty, [1], 5)[1])]
    print("start-up: latchwork %.4f s, clingo %.4f s; limit %d s" % (*start, options.seconds))
    print("| theories | queries | latchwork: median / p90 / undecided | clingo |\n|---|---|---|---|")
    differ = 0
    if options.files:
        theories = [theory for theory in map(read_circ, options.files) if theory]
        differ += row("files", theories, options.latchwork, options.seconds)
    else:
        for atoms in SIZES:
            for ratio in RATIOS:
                theories = [random_theory(atoms, ratio, seed) for seed in range(options.instances)]
                differ += row("%d atoms, ratio %.1f" % (atoms, ratio), theories, options.latchwork,
                              options.seconds)
    print("answers that differ: %d" % differ)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
