#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Searches the contrapositives of a CNF file in plain SWI-Prolog, to compare inferences per second.

Every clause becomes its contrapositives m(Goal, Ancestors, Depth) as Stickel's PTTP would have
them: unification with occurs check, reduction against the ancestors, identical-ancestor pruning,
and a bound on the depth of paths that facts and units are not charged for. Extension and reduction
steps that succeed are counted. Usage, beside `latchwork prove --stats FILE`:

    tests/bench/prolog_comparator.py FILE.p DEPTH
"""
import re
import shutil
import subprocess
import sys
import tempfile

ENGINE = r"""
:- initialization(main).
solve(G, Up, _) :- neg(G, N), member(A, Up), unify_with_occurs_check(N, A), nb_inc.
solve(G, Up, D) :-
    \+ (member(A, Up), A == G), rule(G, H, Body),
    ( Body == [] -> D1 = D ; D > 0, D1 is D - 1 ),
    unify_with_occurs_check(G, H), nb_inc, solve_all(Body, [G|Up], D1).
solve_all([], _, _).
solve_all([G|Gs], Up, D) :- solve(G, Up, D), solve_all(Gs, Up, D).
nb_inc :- nb_getval(count, C), C1 is C + 1, nb_setval(count, C1).
main :-
    nb_setval(count, 0), depth(Most), statistics(cputime, T0),
    ( between(1, Most, D), start(Body), solve_all(Body, [], D) -> R = proved ; R = not_found ),
    statistics(cputime, T1), nb_getval(count, C), T is max(T1 - T0, 1.0e-6), S is C / T,
    format("~w inferences=~w cpu=~3f inferences_per_second=~0f~n", [R, C, T, S]), halt.
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
    return atom if positive != complement else f"n_{atom}"


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


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if shutil.which("swipl") is None:
        sys.exit("swipl is not installed: no comparison")
    text = re.sub(r"%.*", "", open(sys.argv[1], encoding="utf-8").read())
    rules, predicates = [], set()
    lines = [":- dynamic start/1, rule/3, neg/2.", ":- discontiguous start/1.", f"depth({int(sys.argv[2])})."]
    for role, body in re.findall(r"cnf\(\s*\w+\s*,\s*(\w+)\s*,(.*?)\)\s*\.", text, re.S):
        clause = literals(body)
        if not any(positive for positive, _ in clause):
            goals = ",".join(write(other, True) for other in clause)
            lines.append(f"start([{goals}]).")
        for i, head in enumerate(clause):
            goals = ",".join(write(o, True) for j, o in enumerate(clause) if j != i)
            name, arity = skeleton(write(head))
            predicates.add((name.removeprefix("n_"), arity))
            rules.append(f"rule({apply(name, ['_'] * arity)}, {write(head)}, [{goals}]).")
    for name, arity in sorted(predicates):
        names = [f"V{i}" for i in range(arity)]
        pair = apply(name, names), apply("n_" + name, names)
        lines += [f"neg({pair[0]}, {pair[1]}).", f"neg({pair[1]}, {pair[0]})."]
    lines += rules
    with tempfile.NamedTemporaryFile("w", suffix=".pl") as program:
        program.write("\n".join(lines) + ENGINE)
        program.flush()
        subprocess.run(["swipl", "-q", program.name], check=False)


if __name__ == "__main__":
    main()
