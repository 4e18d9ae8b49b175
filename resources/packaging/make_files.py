#!/usr/bin/env python3
"""Writes what the packages need beside the build: manual pages, shell completions and change logs, compressed as Debian wants it.

The manual page and the completions of bole are printed by the program (`bole man`, `bole completion SHELL`). The Debian change log has
an entry for each version of CHANGELOG.md.
"""

import argparse
import datetime
import email.utils
import gzip
import pathlib
import re
import shutil
import subprocess
import sys

COMPLETIONS = {
    "bash": "bash-completion/completions/bole",
    "zsh": "zsh/vendor-completions/_bole",
    "fish": "fish/vendor_completions.d/bole.fish",
}
VERSION_HEADING = re.compile(r"^## (\d+\.\d+\.\d+) \((\d{4}-\d{2}-\d{2})\)$", re.M)


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def write_compressed(path, text):
    """gzip -9n: without a time, so that equal sources give equal packages."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(gzip.compress(text.encode("utf-8"), compresslevel=9, mtime=0))


def printed(bole, *arguments):
    return subprocess.run([bole, *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=True).stdout


def debian_changelog(changes, version, maintainer):
    """One entry for each version of CHANGELOG.md; its text is read there."""
    entries = VERSION_HEADING.findall(changes)
    if not entries or entries[0][0] != version:
        sys.exit(f"make_files.py: the first version in CHANGELOG.md is {entries[0][0] if entries else 'missing'}, that of the project {version}: "
                 f"head the changes with '## {version} (YYYY-MM-DD)'")
    text = ""
    for number, day in entries:
        date = datetime.datetime.fromisoformat(day).replace(hour=12, tzinfo=datetime.timezone.utc)
        text += f"bole ({number}) unstable; urgency=medium\n\n  * Version {number}: see /usr/share/doc/bole/CHANGELOG.md.gz.\n\n"
        text += f" -- {maintainer}  {email.utils.format_datetime(date)}\n\n"
    return text.rstrip("\n") + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bole", required=True, help="the program")
    parser.add_argument("--source", type=pathlib.Path, required=True, help="top folder of the repository")
    parser.add_argument("--version", required=True)
    parser.add_argument("--maintainer", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    given = parser.parse_args()
    program, desktop = given.out / "program", given.out / "desktop"
    for folder in (program, desktop):
        shutil.rmtree(folder, ignore_errors=True)
    write_compressed(program / "man/man1/bole.1.gz", printed(given.bole, "man"))
    for shell, place in COMPLETIONS.items():
        write(program / place, printed(given.bole, "completion", shell))
    changes = (given.source / "CHANGELOG.md").read_text(encoding="utf-8")
    write_compressed(program / "doc/bole/CHANGELOG.md.gz", changes)
    write_compressed(given.out / "changelog.gz", debian_changelog(changes, given.version, given.maintainer))
    page = (given.source / "resources/packaging/bole-desktop.1").read_text(encoding="utf-8").replace("@VERSION@", given.version)
    write_compressed(desktop / "man/man1/bole-desktop.1.gz", page)


if __name__ == "__main__":
    main()
