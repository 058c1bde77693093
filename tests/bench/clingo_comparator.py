#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares `latchwork entail` with clingo (Debian: gringo) on exact cautious entailment.

Ground theories of three kinds, or the .circ files given. Random clauses of three literals, two
fifths of them negated; six atoms of ten minimized, two varying, two fixed and open. The same with
the minimized atoms on three levels of priority. A robot's obstacle layer with the latches of one
cycle (24 sonars: 258 atoms, 297 clauses, 20 queries, two levels), some of its sonars suspect.
Each query is put to a process of its own of either program, with the same limit. clingo gets the
saturation encoding: a model is guessed that falsifies the query, and a disjunctive program says
that each candidate below it is none. Priorities are encoded as they are defined: a candidate is
below when it is smaller on the first level on which the two differ. User and system time of the
process; what a process takes for next to nothing is stated apart and not subtracted. Usage:

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
ROBOTS = ((24, 0), (24, 15), (48, 15))  # Sonars, and how many of a hundred are suspect.

# With predicates of one argument: as many without are ten times slower to ground.
SATURATION = """
atom(1..%d). {t(A)} :- atom(A).
u(A) | n(A) :- atom(A). u(A) :- atom(A), bad. n(A) :- atom(A), bad.
bad :- fixed(A), u(A), not t(A). bad :- fixed(A), n(A), t(A).
same(A) :- minimized(A,_), not t(A). same(A) :- minimized(A,_), u(A).
same_to(0). same_to(L) :- level(L), same_to(L-1), same(A) : minimized(A,L).
bad :- same_to(L-1), minimized(A,L), u(A), not t(A).
bad :- same_to(%d).
:- not bad. #show. #defined fixed/1. #defined minimized/2. #defined level/1.
"""


class Theory:
    def __init__(self):
        self.atoms, self.clauses, self.queries = 0, [], []
        self.minimized, self.fixed, self.varying = [], [], []  # The minimized ones level by level.
        self.facts = []  # Of latches: literals over fixed atoms.

    def add(self, group):
        self.atoms += 1
        group.append(self.atoms)
        return self.atoms

    def circ(self, query):
        lines = ["p circ %d %d" % (self.atoms, len(self.clauses))]
        groups = [("P %d" % level, atoms) for level, atoms in enumerate(self.minimized, 1)]
        for key, atoms in (*groups, ("Z", self.varying), ("Q", self.fixed), ("F", self.facts)):
            lines.append("%s %s 0" % (key, " ".join(map(str, atoms))))
        lines += [" ".join(map(str, clause + [0])) for clause in self.clauses]
        lines.append("? q c %s 0" % " ".join(map(str, query)))
        return "\n".join(lines) + "\n"

    def saturation(self, query):
        """A stable model: a minimal model t that falsifies the query; u is any other."""
        rules = [SATURATION % (self.atoms, len(self.minimized))]
        for level, atoms in enumerate(self.minimized, 1):
            rules += ["level(%d)." % level] + ["minimized(%d,%d)." % (atom, level) for atom in atoms]
        rules += ["fixed(%d)." % atom for atom in self.fixed]
        for clause in self.clauses + [[fact] for fact in self.facts]:
            model = [("not t(%d)" if a > 0 else "t(%d)") % abs(a) for a in clause]
            lower = [("n(%d)" if a > 0 else "u(%d)") % abs(a) for a in clause]
            rules.append(":- %s. bad :- %s." % tuple(", ".join(b or ["#true"]) for b in (model, lower)))
        rules += [":- %st(%d)." % ("" if a > 0 else "not ", abs(a)) for a in query]
        return "\n".join(rules) + "\n"


def random_theory(atoms, ratio, seed, levels=1):
    dice, theory = random.Random(seed), Theory()
    theory.minimized = [[] for _ in range(levels)]
    for atom in range(atoms):
        roll = dice.randrange(10)
        minimized = theory.minimized[atom % levels]
        theory.add(minimized if roll < 6 else theory.varying if roll < 8 else theory.fixed)
    for _ in range(int(ratio * atoms)):
        clause = dice.sample(range(1, atoms + 1), 3)
        theory.clauses.append([-a if dice.randrange(5) < 2 else a for a in clause])
    for _ in range(QUERIES):
        size = dice.choice((1, 1, 2))
        theory.queries.append([dice.choice((-1, 1)) * dice.randint(1, atoms) for _ in range(size)])
    return theory


def add_sonars(theory, sonars, sectors, ahead):
    """What is heard is an object unless the sonar is abnormal; of a suspect one and its neighbour
    one is."""
    first, second = theory.minimized
    made = [{"object": theory.add(second), "abnormal": theory.add(first),
             "suspect": theory.add(theory.fixed),
             "distance": [theory.add(second) for _ in range(3)],
             "echo": [theory.add(theory.fixed) for _ in range(3)]} for _ in range(sonars)]
    for i, sonar in enumerate(made):
        thing, near, abnormal = sonar["object"], sonar["distance"], sonar["abnormal"]
        blocked = sectors[i * len(sectors) // sonars]["blocked"]
        for echo, distance in zip(sonar["echo"], near):
            theory.clauses += [[-echo, abnormal, thing], [-echo, abnormal, distance]]
        theory.clauses += [[-thing, -near[0], blocked], [-thing, -near[1], blocked]]
        theory.clauses.append([-thing, -near[0], ahead] if 2 * i < sonars else [-near[0], -near[2]])
        theory.clauses.append([-sonar["suspect"], abnormal, made[(i + 1) % sonars]["abnormal"]])
        theory.clauses.append([-near[0], -near[1]])
    return made


def robot_theory(sonars, suspects, seed):
    """The theory of tests/reasoners/circumscription/robot_theory.h, and the latches of a cycle."""
    dice, theory = random.Random(seed), Theory()
    theory.minimized = [[], []]
    first, second = theory.minimized
    sectors = [{"virtual": theory.add(second), "blocked": theory.add(second),
                "given_up": theory.add(first), "push": theory.add(theory.fixed),
                "go": theory.add(theory.varying)} for _ in range(8)]
    ahead, halt = theory.add(second), theory.add(second)
    made = add_sonars(theory, sonars, sectors, ahead)
    for each in sectors:
        theory.clauses += [[-each["push"], each["given_up"], each["virtual"]],
                           [-each["virtual"], each["blocked"]], [each["blocked"], each["go"]],
                           [-each["blocked"], -each["go"]]]
        theory.queries += [[each["go"]], [-each["blocked"]]]
    theory.clauses.append([-ahead, halt])
    theory.queries += [[halt], [-halt], [ahead], [-ahead]]
    holds = {sonar["echo"][dice.randrange(3)] for sonar in made if dice.randrange(100) < 40}
    holds |= {sonar["suspect"] for sonar in made if dice.randrange(100) < suspects}
    holds |= {each["push"] for each in sectors if dice.randrange(100) < 10}
    theory.facts = [atom if atom in holds else -atom for atom in theory.fixed]
    return theory


def read_circ(path):
    """Facts become clauses, which is the same."""
    theory, levels = Theory(), {}
    for line in path.read_text().splitlines():
        words = line.split()
        if not words or words[0] in "c=xn":
            continue
        key, numbers = words[0], words[1:-1]
        if key == "p":
            theory.atoms = int(words[2])
        elif key == "P":
            levels.setdefault(int(words[1]), []).extend(map(int, numbers[1:]))
        elif key in "ZQ":
            (theory.varying if key == "Z" else theory.fixed).extend(map(int, numbers))
        elif key == "F":
            theory.clauses += [[int(a)] for a in numbers]
        elif key == "?":
            if words[2] == "c" and len(words) > 4:
                theory.queries.append([int(a) for a in words[3:-1]])
        else:
            theory.clauses.append([int(a) for a in words[:-1]])
    theory.minimized = [levels[level] for level in sorted(levels)]
    return theory


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


def made_families(seeds):
    for atoms in SIZES:
        for ratio in RATIOS:
            yield ("%d atoms, ratio %.1f" % (atoms, ratio),
                   [random_theory(atoms, ratio, seed) for seed in seeds])
    for atoms in SIZES:
        yield ("%d atoms, ratio 2.5, three levels" % atoms,
               [random_theory(atoms, 2.5, seed, 3) for seed in seeds])
    for sonars, suspects in ROBOTS:
        yield ("robot, %d sonars, %d %% suspect" % (sonars, suspects),
               [robot_theory(sonars, suspects, seed) for seed in seeds])


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
        families = [("files", [read_circ(path) for path in options.files])]
    else:
        families = list(made_families(range(options.instances)))
    for name, theories in families:
        differ += row(name, theories, options.latchwork, options.seconds)
    print("answers that differ: %d" % differ)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
