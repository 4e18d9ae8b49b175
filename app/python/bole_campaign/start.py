"""Entry of the engine as a program of its own: `bole campaign` starts it with a request (JSON)."""

import sys

if sys.version_info < (3, 9):
    sys.exit("bole: Python %d.%d runs the campaign engine; needed: Python 3.9 or later. Give another with BOLE_PYTHON=PATH" % sys.version_info[:2])

import pathlib

# The folder above, so that this one is a package: and not the folder of the user, whose files may have any name.
sys.path[0] = str(pathlib.Path(__file__).resolve().parents[1])

if __name__ == "__main__":
    if sys.argv[1:] == ["attempt"]:
        from bole_campaign.attempt import main
    else:
        from bole_campaign.command import main
    sys.exit(main())
