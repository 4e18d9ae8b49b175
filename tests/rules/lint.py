#!/usr/bin/env python3
"""Checks the format and the code of all sources that git tracks: clang-format, then clang-tidy on app and modules.

  lint.py --build build/headless             what ./do lint runs
  lint.py --build build/headless FILE...     those files alone
  lint.py --format                           formats instead (./do format)

A source that clang-tidy had nothing to say about is not examined again until it, a header of ours that it includes, its compile
command or .clang-tidy changes; BUILD/lint keeps that. --profile tells what the checks cost.
"""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
FOUND = re.compile(r"^\S+?:\d+:\d+: (?:error|warning): ")


def tracked():
    names = subprocess.run(["git", "ls-files", "app", "modules", "tests"], cwd=SOURCE, text=True, capture_output=True)
    if names.returncode != 0:
        sys.exit(f"git does not list the sources: {names.stderr.strip()}")
    return [SOURCE / n for n in names.stdout.split("\n") if n.endswith((".h", ".cpp", ".cxx")) and (SOURCE / n).exists()]


def batches(files, size=64):
    return [files[i:i + size] for i in range(0, len(files), size)]


class Includes:
    """The headers of ours that a source reaches, by the quoted includes. A name that two headers share counts for both."""

    def __init__(self, files):
        self.by_name = collections.defaultdict(list)
        for file in files:
            if file.suffix == ".h":
                self.by_name[file.name].append(file)
        self.direct = {}
        self.digests = {}

    def _of(self, file):
        if file not in self.direct:
            text = file.read_bytes()
            self.digests[file] = hashlib.sha256(text).digest()
            names = INCLUDE.findall(text.decode(errors="replace"))
            self.direct[file] = [h for n in names for h in self.by_name[n.rpartition("/")[2]] if str(h).endswith(n.lstrip("./"))]
        return self.direct[file]

    def digest(self, file):
        seen, todo = set(), [file]
        while todo:
            current = todo.pop()
            if current not in seen:
                seen.add(current)
                todo += self._of(current)
        return b"".join(self.digests[f] for f in sorted(seen))


def singles(entry):
    """A unit of files that are compiled together as one entry for each of them: the analyzer looks at the main file alone."""
    unit = pathlib.Path(entry["file"])
    if unit.parent.name != "Unity" or not unit.exists():
        return [entry]
    files = re.findall(r'^#include "(.+)"$', unit.read_text(), re.MULTILINE)
    return [{**entry, "file": f, "command": entry["command"].replace(str(unit), f)} for f in files]


def commands(build):
    """Compile commands by source, and the same in BUILD/lint for clang-tidy: without the launcher and GCC's precompiled headers, which clang cannot
    read. So a source that does not include what it uses is found, too."""
    database = build / "compile_commands.json"
    if not database.exists():
        sys.exit(f"{database} is absent: configure first (cmake --preset ci)")
    entries = [single for entry in json.loads(database.read_text()) for single in singles(entry)]
    for entry in entries:
        entry["command"] = re.sub(r"^env \S+ ccache | -Winvalid-pch| -include \S*cmake_pch\.hxx", "", entry["command"])
    (build / "lint").mkdir(exist_ok=True)
    (build / "lint/compile_commands.json").write_text(json.dumps(entries, indent=1))
    return {pathlib.Path(e["file"]).resolve(): e["command"] for e in entries}


def examine(file, args):
    command = ["clang-tidy", "--quiet", "-p", str(args.build / "lint"), str(file)]
    if args.profile:
        command[1:1] = ["--enable-check-profile", f"--store-check-profile={args.build / 'lint' / 'profile'}"]
    begun = time.monotonic()
    result = subprocess.run(command, text=True, capture_output=True)
    # GCC's compile commands make clang tell on stderr only how many warnings it left out; without a finding on stdout it is the reason.
    return file, result.returncode, result.stdout + (result.stderr if result.returncode and not result.stdout else ""), time.monotonic() - begun


def tidy(sources, everything, args):
    known = commands(args.build)
    kept = args.build / "lint"
    includes = Includes(everything)
    rules = (SOURCE / ".clang-tidy").read_bytes() + subprocess.run(["clang-tidy", "--version"], capture_output=True).stdout
    todo, left_out = {}, [f for f in sources if f not in known]
    for file in sources:
        if file in known:
            clean = kept / hashlib.sha256(b"\0".join([rules, known[file].encode(), str(file).encode(), includes.digest(file)])).hexdigest()
            if not clean.exists() or args.profile:
                todo[file] = clean
    print(f"clang-tidy: {len(todo)} of {len(sources)} sources to examine, {args.jobs} at a time", flush=True)
    if left_out:
        print(f"  {len(left_out)} are not in this build: {', '.join(str(f.relative_to(SOURCE)) for f in left_out)}")
    findings, bad = collections.Counter(), 0
    told = set()  # what a header has is found by every source that includes it
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for done, (file, code, text, seconds) in enumerate(pool.map(lambda f: examine(f, args), todo), 1):
            name = file.relative_to(SOURCE)
            if code == 0:
                todo[file].touch()
            bad += code != 0
            print(f"[{done}/{len(todo)}] {name}{'' if code == 0 else '  FINDINGS'}  {seconds:.0f} s", flush=True)
            for paragraph in re.split(r"\n(?=\S+?:\d+:\d+: (?:error|warning): )", text):
                if FOUND.match(paragraph) and paragraph in told:
                    continue
                told.add(paragraph)
                if code != 0:
                    print(paragraph.rstrip(), flush=True)
                    for check in re.findall(r"\[([\w.,-]+)\]$", paragraph.split("\n")[0]):
                        findings[check.replace(",-warnings-as-errors", "")] += 1
    for check, count in findings.most_common():
        print(f"{count:6} {check}")
    return bad


def costs(folder):
    """CPU seconds by check, of all files."""
    seconds = collections.Counter()
    for file in folder.glob("*.json"):
        for name, value in json.loads(file.read_text())["profile"].items():
            if name.endswith((".user", ".sys")):
                seconds[name.removeprefix("time.clang-tidy.").rsplit(".", 1)[0]] += value
    for name, value in seconds.most_common(25):
        print(f"{value:8.1f} s  {name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=SOURCE / "build/headless", help="build folder with compile_commands.json")
    parser.add_argument("--format", action="store_true", help="format the sources")
    parser.add_argument("--profile", action="store_true", help="examine all and print what the checks cost")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    args = parser.parse_args()
    args.build = args.build.resolve()
    everything = tracked()
    chosen = {f.resolve() for f in args.files}
    files = [f for f in everything if not chosen or f in chosen]
    if args.format:
        return max(subprocess.run(["clang-format", "-i", *batch]).returncode for batch in batches(files))

    misformed = [b for b in batches(files) if subprocess.run(["clang-format", "--dry-run", "-Werror", *b]).returncode]
    print(f"clang-format: {len(files)} files" + (", some are not formatted: ./do format" if misformed else ""), flush=True)
    sources = [f for f in files if f.suffix != ".h" and f.relative_to(SOURCE).parts[0] != "tests"]
    bad = tidy(sources, everything, args)
    if args.profile:
        costs(args.build / "lint" / "profile")
    print(f"lint: {'clean' if not bad and not misformed else 'not clean'} ({len(files)} files, {bad} of {len(sources)} sources with findings)")
    return 1 if bad or misformed else 0


if __name__ == "__main__":
    sys.exit(main())
