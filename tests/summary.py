#!/usr/bin/env python3
"""Prints what a run of ctest passed, failed and skipped, from the JUnit files that ctest writes.

The tests left out are listed with their reason. The last line counts: '817 passed, 21 skipped (19 for want of ../shared/data)'.
"""

import argparse
import collections
import pathlib
import re
import sys
import xml.etree.ElementTree

REAL_DATA = "for want of ../shared/data"  # tests/synthetic/shared_data.h and tests/cases/run_case.py say this
REASONS = (
    re.compile(r"Skipped\n(.+)"),  # GoogleTest
    re.compile(r"^SKIPPED: (.+)", re.MULTILINE),  # run_case.py
)
SKIPPED_PARTS = (
    re.compile(r"^SKIP   : (.+)", re.MULTILINE),  # one function of a Qt test program
    re.compile(r"skipped '(.+)'$", re.MULTILINE),  # one method of a Python test
)


def read(path, counts, reasons):
    for case in xml.etree.ElementTree.parse(path).getroot().iter("testcase"):
        name, output = case.get("name"), case.findtext("system-out") or ""
        skipped = case.find("skipped")
        # A program that is missing is "skipped" too in this file; for ctest, and here, it has failed.
        if skipped is not None and skipped.get("message", "").startswith("SKIP_") or case.get("status") == "disabled":
            found = next((m for m in (r.search(output) for r in REASONS) if m), None)
            reason = found.group(1).strip() if found else "no reason given"
            counts["skipped"] += 1
            counts["real data"] += REAL_DATA in reason
            reasons[reason].append(name)
            continue
        counts["passed" if case.get("status") == "run" else "failed"] += 1
        for pattern in SKIPPED_PARTS:
            for match in pattern.finditer(output):
                reasons[match.group(1).strip()].append(f"part of {name}")


def counted(counts):
    line = f"{counts['passed']} passed"
    if counts["failed"]:
        line += f", {counts['failed']} failed"
    line += f", {counts['skipped']} skipped"
    if counts["real data"]:
        line += f" ({counts['real data']} {REAL_DATA})"
    return line


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", nargs="+", type=pathlib.Path, help="JUnit files of ctest")
    args = parser.parse_args()
    counts, reasons = collections.Counter(), collections.defaultdict(list)
    for path in args.results:
        if not path.exists():
            sys.exit(f"{path} is absent: run the tests first (./do test)")
        read(path, counts, reasons)
    for reason, names in sorted(reasons.items()):
        print(f"skipped: {reason}\n    {', '.join(sorted(names))}")
    print(counted(counts))
    return 1 if counts["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
