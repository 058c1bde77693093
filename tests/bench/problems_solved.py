#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How many TPTP problems `latchwork prove` solves, and whether its answers and proofs are right.

The problems stand in tptp_problems.csv beside this script: names and status of TPTP v9, whether
they have equality, their rating, and whether they are of the sample of 120. Their files are looked
for in FOLDER (default: $TPTP), as Problems/PUZ/PUZ001+1.p or Problems/PUZ001+1.p.

    tests/bench/problems_solved.py LATCHWORK [--tptp FOLDER] [--time 10] [--proofs] [--sample]
                                             [PROVE-OPTION...]

--proofs checks each proof with `latchwork check-proof`; --sample takes the sample alone; --list
prints the files, for other scripts. Options that are not known here go to `latchwork prove`.
Exit code: 0 all answers and proofs are right; 1 some are not; 2 wrong usage.
"""
import argparse
import csv
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

PROVED = {"Theorem", "Unsatisfiable", "ContradictoryAxioms"}
REFUTED = {"CounterSatisfiable", "Satisfiable"}


def problems(folder, sample):
    with open(pathlib.Path(__file__).with_name("tptp_problems.csv"), encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if sample and row["sample"] != "yes":
                continue
            name = row["name"] + ".p"
            places = [folder / "Problems" / name[:3] / name, folder / "Problems" / name]
            row["file"] = next((place for place in places if place.exists()), None)
            yield row


def cpu_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def prove(args, options, row):
    """Adds to the row: said, cpu, and with --proofs the verdict on the proof."""
    command = [args.latchwork, "prove", "--time", str(args.time), "--tptp", str(args.tptp), *options]
    before = cpu_of_children()
    result = subprocess.run(command + ["--proof"] * args.proofs + [row["file"]],
                            capture_output=True, text=True, check=False)
    row["cpu"] = cpu_of_children() - before
    status = re.search(r"SZS status (\w+)", result.stdout)
    row["said"] = status.group(1) if status else "nothing"
    row["solved"] = row["said"] in PROVED | REFUTED and row["cpu"] <= args.time + 0.5
    row["wrong"] = row["said"] in (REFUTED if row["status"] in PROVED else PROVED)
    row["proof"] = ""
    if args.proofs and row["said"] in PROVED:
        with tempfile.NamedTemporaryFile("w", suffix=".out") as proof:
            proof.write(result.stdout)
            proof.flush()
            check = subprocess.run([args.latchwork, "check-proof", row["file"], proof.name],
                                   capture_output=True, text=True, check=False)
        row["proof"] = check.stdout.partition(":")[0] or "unreadable"


def report(rows):
    def line(title, part):
        part = list(part)
        solved = sum(row["solved"] for row in part)
        share = 100 * solved / len(part) if part else 0
        print(f"| {title} | {solved} of {len(part)} | {share:.1f} % |")

    print("| problems | solved | |\n|---|---|---|")
    line("all", rows)
    line("without equality", (r for r in rows if r["equality"] == "no"))
    line("with equality", (r for r in rows if r["equality"] == "yes"))
    line("planning (PLA, PLG)", (r for r in rows if r["name"][:3] in ("PLA", "PLG")))
    easy = [r["cpu"] for r in rows if r["rating"] in ("0", "0.0", "0.00") and r["solved"]]
    if easy:
        median = 1000 * statistics.median(easy)
        print(f"processor time of those rated 0 that are solved: median {median:.1f} ms")
    print(f"wrong answers: {' '.join(r['name'] for r in rows if r['wrong']) or 'none'}")
    proofs = [r["proof"] for r in rows if r["proof"]]
    if proofs:
        bad = [f"{r['name']} ({r['proof']})" for r in rows if r["proof"] not in ("", "verified")]
        print(f"proofs verified: {proofs.count('verified')} of {len(proofs)} {' '.join(bad)}")
    return any(r["wrong"] or r["proof"] not in ("", "verified") for r in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("latchwork", nargs="?")
    parser.add_argument("--tptp", type=pathlib.Path, default=os.environ.get("TPTP"))
    parser.add_argument("--time", type=float, default=10)
    parser.add_argument("--proofs", action="store_true")
    parser.add_argument("--sample", action="store_true")
    parser.add_argument("--list", action="store_true")
    args, options = parser.parse_known_args()
    if args.tptp is None or not (args.list or args.latchwork):
        parser.error("name the program and the folder of TPTP (--tptp, or $TPTP)")
    args.tptp = pathlib.Path(args.tptp)
    rows = list(problems(args.tptp, args.sample))
    missing = [row["name"] for row in rows if row["file"] is None]
    rows = [row for row in rows if row["file"] is not None]
    if missing:
        print(f"not in {args.tptp}: {' '.join(missing)}", file=sys.stderr)
    if args.list:
        print(*(row["file"] for row in rows))
        return 0
    for number, row in enumerate(rows, 1):
        prove(args, options, row)
        print(f"{number}/{len(rows)} {row['name']} {row['said']} {row['cpu']:.3f} s {row['proof']}",
              file=sys.stderr, flush=True)
    return int(report(rows))


if __name__ == "__main__":
    sys.exit(main())
