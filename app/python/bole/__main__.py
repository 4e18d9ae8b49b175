"""python3 -m bole: the command line program."""

import os
import sys

from . import _native
from ._errors import Failed, translated


def main():
    with translated():
        program = _native.program()
    try:
        os.execv(program, [program, *sys.argv[1:]])
    except OSError as error:
        raise Failed(f"cannot start the program '{program}' ({error.strerror}); needed: its place. Set the environment variable BOLE_PROGRAM") from None


if __name__ == "__main__":
    try:
        main()
    except Exception as error:
        print(f"bole: {error}", file=sys.stderr)
        sys.exit(getattr(error, "exit_code", 1))
