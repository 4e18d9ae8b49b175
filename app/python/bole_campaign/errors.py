"""Errors as everywhere in Bole: what was found, what was needed, what to do (modules/base/error.h)."""

import difflib


class CampaignError(Exception):
    """Ends a command with a sentence and an exit code of Bole (bole --help lists them)."""

    def __init__(self, exit_code, found, needed="", remedy=""):
        self.exit_code, self.found, self.needed, self.remedy = exit_code, found, needed, remedy
        text = found + (f"; needed: {needed}" if needed else "") + (f". {remedy}" if remedy else "")
        super().__init__(text)


DONE, FAILED, BAD_INPUT, CANCELLED, FINISHED_EARLY = 0, 1, 2, 3, 4


def bad_input(found, needed="", remedy=""):
    return CampaignError(BAD_INPUT, found, needed, remedy)


def failure(found, needed="", remedy=""):
    return CampaignError(FAILED, found, needed, remedy)


def did_you_mean(word, names):
    near = difflib.get_close_matches(str(word), list(names), n=2)
    return f"Did you mean {' or '.join(near)}?" if near else ""
