"""python3 -m bole: the command line program."""

import os
import sys

from . import _native
from ._errors import translated


def main():
    with translated():
        program = _native.program()
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    try:
        main()
    except Exception as error:
        print(f"bole: {error}", file=sys.stderr)
        sys.exit(getattr(error, "exit_code", 1))
