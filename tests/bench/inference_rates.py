#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Inferences per second of `latchwork prove` on problems that are not solved at once.

Each FILE is searched for SECONDS of processor time with one strategy (default: complete). The rate
is inferences over the whole processor time, start-up and reading included. Files that take less
than half of SECONDS are left out. Several commands are run in turn on each file, and compared on
those that none of them solved at once. Usage:

    tests/bench/inference_rates.py [--seconds 1] [--strategy complete] LATCHWORK... --files FILE.p...
"""
import argparse
import re
import resource
import statistics
import subprocess


def rate(command, strategy, seconds, file):
    """Millions of inferences a second; None for what is solved at once."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    args = [command, "prove", "--stats", "--strategy", strategy, "--time", str(seconds), file]
    said = subprocess.run(args, capture_output=True, text=True, check=False).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    count = re.search(r"inferences (\d+)", said)
    if count is None or spent < seconds / 2:
        return None
    return int(count.group(1)) / spent / 1e6


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("Usage:")[1].strip())
    parser.add_argument("--seconds", type=float, default=1)
    parser.add_argument("--strategy", default="complete")
    parser.add_argument("commands", nargs="+")
    parser.add_argument("--files", nargs="+", required=True)
    args = parser.parse_args()
    rows = []
    for file in args.files:
        row = [rate(command, args.strategy, args.seconds, file) for command in args.commands]
        if None not in row:
            rows.append(row)
            print(file.rsplit("/", 1)[-1], *(f"{value:.2f}" for value in row), flush=True)
    for command, *values in zip(args.commands, *rows):
        print(f"{command}: {len(values)} problems, M/s: least {min(values):.1f}, "
              f"median {statistics.median(values):.1f}, most {max(values):.1f}")


if __name__ == "__main__":
    main()
