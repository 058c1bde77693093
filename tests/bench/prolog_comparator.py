#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Searches the contrapositives of a CNF file in plain SWI-Prolog, to compare inferences per second.

Every clause becomes its contrapositives m(Goal, Ancestors, Depth) as Stickel's PTTP would have
them: unification with occurs check, reduction against the ancestors, identical-ancestor pruning,
and a bound on the depth of paths that units and ground clauses are not charged for. All depths up
to DEPTH are searched, once to count the extension and reduction steps that succeed and once, without
counting, for the time. `latchwork prove --strategy plain --depth DEPTH --stats FILE` makes the same
search. Usage:

    tests/bench/prolog_comparator.py FILE.p DEPTH
    tests/bench/prolog_comparator.py --table LATCHWORK MOST FILE.p...

The second prints a table of the files without equality that have a depth whose search ends without a
proof after 100,000 to MOST steps: the deepest such one, the steps of both, their rates and the ratio.
"""
import pathlib
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

LEAST_STEPS = 100_000

ENGINE = r"""
:- initialization(main).
solve(G, Up, D) :- \+ (member(A, Up), A == G), step(G, Up, D).
step(G, Up, _) :- neg(G, N), member(A, Up), unify_with_occurs_check(N, A)COUNT.
step(G, Up, D) :-
    rule(G, H, Body, Cost), left(Cost, D, D1), unify_with_occurs_check(G, H)COUNT,
    solve_all(Body, [G|Up], D1).
left(0, D, D1) :- D1 is max(0, D - 1).
left(1, D, D1) :- D > 0, D1 is D - 1.
solve_all([], _, _).
solve_all([G|Gs], Up, D) :- solve(G, Up, D), solve_all(Gs, Up, D).
nb_inc :- nb_getval(count, C), C1 is C + 1, nb_setval(count, C1).
main :-
    nb_setval(count, 0), depth(Most), statistics(cputime, T0),
    ( between(1, Most, D), start(Body), solve_all(Body, [], D) -> R = proved ; R = not_found ),
    statistics(cputime, T1), nb_getval(count, C), T is max(T1 - T0, 1.0e-6),
    format("~w ~w ~6f~n", [R, C, T]), halt.
"""


def literals(text):
    """The literals of `( a | ~ b )`, split at the outermost bars."""
    text = text.strip()
    while text.startswith("(") and text.endswith(")"):
        text = text[1:-1].strip()
    parts, level = [""], 0
    for char in text:
        level += {"(": 1, ")": -1}.get(char, 0)
        if char == "|" and level == 0:
            parts.append("")
        else:
            parts[-1] += char
    result = []
    for part in map(str.strip, parts):
        positive = not part.startswith("~")
        atom = part.lstrip("~ ")
        if "!=" in atom:
            positive, atom = False, atom.replace("!=", "=")
        equation = re.fullmatch(r"(.+?)\s*=\s*(.+)", atom)
        result.append((positive, f"equal({equation[1]},{equation[2]})" if equation else atom))
    return result


def write(literal, complement=False):
    positive, atom = literal
    return atom if positive != complement else negated(atom)


def negated(atom):
    return f"'n_{atom[1:]}" if atom.startswith("'") else f"n_{atom}"


def skeleton(atom):
    """p(_, _) for p(X, f(Y)): clauses are found by the predicate of the goal."""
    name, _, rest = atom.partition("(")
    level, arguments = 0, 1 if rest else 0
    for char in rest[:-1]:
        level += {"(": 1, ")": -1}.get(char, 0)
        arguments += char == "," and level == 0
    return name, arguments


def apply(name, arguments):
    return f"{name}({','.join(arguments)})" if arguments else name


def translate(path):
    """The program without its engine and depth."""
    text = re.sub(r"%.*", "", open(path, encoding="utf-8").read())
    rules, predicates = [], set()
    lines = [":- dynamic start/1, rule/4, neg/2.", ":- discontiguous start/1."]
    for role, body in re.findall(r"cnf\(\s*\w+\s*,\s*(\w+)\s*,(.*?)\)\s*\.", text, re.S):
        clause = literals(body)
        if not any(positive for positive, _ in clause):
            goals = ",".join(write(other, True) for other in clause)
            lines.append(f"start([{goals}]).")
        open_clause = any(re.search(r"\b[A-Z]", re.sub("'[^']*'", "", atom)) for _, atom in clause)
        for i, head in enumerate(clause):
            goals = ",".join(write(o, True) for j, o in enumerate(clause) if j != i)
            name, arity = skeleton(write(head))
            predicates.add((skeleton(head[1])[0], arity))
            cost = 1 if goals and open_clause else 0
            rules.append(f"rule({apply(name, ['_'] * arity)}, {write(head)}, [{goals}], {cost}).")
    for name, arity in sorted(predicates):
        names = [f"V{i}" for i in range(arity)]
        pair = apply(name, names), negated(apply(name, names))
        lines += [f"neg({pair[0]}, {pair[1]}).", f"neg({pair[1]}, {pair[0]})."]
    return "\n".join(lines + rules)


def run_prolog(program, depth, count, seconds):
    """What came out, steps (0 without count) and processor time; None when that is not enough."""
    engine = ENGINE.replace("COUNT", ", nb_inc" if count else "")
    with tempfile.NamedTemporaryFile("w", suffix=".pl") as file:
        file.write(f"{program}\ndepth({depth}).\n{engine}")
        file.flush()
        limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        output = subprocess.run(["swipl", "-q", file.name], check=False, capture_output=True,
                                text=True, preexec_fn=limit).stdout
    found = re.fullmatch(r"(\w+) (\d+) ([\d.]+)\n", output)
    return found and (found[1], int(found[2]), float(found[3]))


def compare(path, depth, seconds):
    program = translate(path)
    counted = run_prolog(program, depth, True, 2 * seconds)
    timed = counted and run_prolog(program, depth, False, seconds)
    return timed and (counted[0], counted[1], timed[2])


def run_latchwork(command, path, depth, most):
    """Status, steps and processor time, starting and reading included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    output = subprocess.run([command, "prove", "--stats", "--strategy", "plain", "--depth",
                             str(depth), "--time", "1000", "--inferences", str(most), path],
                            check=False, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    time = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    steps = re.search(r"inferences (\d+)", output)
    return re.search(r"SZS status (\w+)", output)[1], int(steps[1]) if steps else 0, time


def deepest(command, path, most):
    """The deepest level that ends without a proof after no more than so many steps, and those."""
    best, steps = None, -1
    for depth in range(1, 100):
        before = steps
        status, steps, _ = run_latchwork(command, path, depth, most + 1)
        if status != "GaveUp" or steps > most or steps == before:
            break
        if steps >= LEAST_STEPS:
            best = depth, steps
    return best


def table(command, most, paths):
    print("| problem | depth | steps | Prolog, M/s | latchwork, M/s | ratio |\n|---|---|---|---|---|---|")
    ratios = []
    for path in paths:
        text = re.sub(r"%.*", "", open(path, encoding="utf-8").read())
        if "cnf(" not in text or "=" in text or not (found := deepest(command, path, most)):
            continue
        depth, own_steps = found
        _, steps, time = compare(path, depth, 1000)
        own_time = min(run_latchwork(command, path, depth, most + 1)[2] for _ in range(3))
        rates = steps / time / 1e6, own_steps / own_time / 1e6
        same = str(steps) if steps == own_steps else f"{steps} against {own_steps}"
        ratios.append(rates[1] / rates[0])
        print(f"| {pathlib.Path(path).stem} | {depth} | {same} | {rates[0]:.2f} | {rates[1]:.1f} "
              f"| {ratios[-1]:.0f} |", flush=True)
    if ratios:
        print(f"| median | | | | | {statistics.median(ratios):.0f} |")


def main():
    if shutil.which("swipl") is None:
        sys.exit("swipl is not installed: no comparison")
    if len(sys.argv) > 3 and sys.argv[1] == "--table":
        table(sys.argv[2], int(sys.argv[3]), sys.argv[4:])
    elif len(sys.argv) == 3:
        result = compare(sys.argv[1], int(sys.argv[2]), 3600)
        print("{} inferences={} cpu={:.3f}".format(*result) if result else "no result in an hour")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
