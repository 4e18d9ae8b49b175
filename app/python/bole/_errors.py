"""What can go wrong: each with what was found and what was needed, and with the exit code that the program has for it."""

import contextlib
import pathlib
import re


class _Told:
    """The text as the program prints it, and its parts.

    found, needed   what was met, and what would have served, with the remedy (empty where nothing is said)
    stage           the stage that it happened in, or None
    results         folder with what the run wrote before it failed, not complete; None where nothing was kept
    survey_kept     whether the results of an earlier run are still in the output folder
    summary         what summary.json says of the run (dict), or None
    findings        [{"code", "severity", "text", "stage"}] of the run
    """

    exit_code = 1

    def __init__(self, text="", **known):
        super().__init__(text)
        stage = re.match(r"(?:the )?stage '([^']+)'", text)
        self.found, _, self.needed = text.partition("; needed: ")
        self.stage = stage.group(1) if stage else None
        self.results, self.survey_kept, self.summary, self.findings = None, False, None, []
        for name, value in known.items():
            setattr(self, name, value)


class BoleError(_Told, Exception):
    """All errors but Cancelled."""


class Failed(BoleError, RuntimeError):
    """The work went wrong, an output could not be written, or an input could be read in part only (exit code 1)."""


class BadInput(BoleError, ValueError):
    """A file, an array, an option or a pipeline cannot be used as it is (exit code 2)."""

    exit_code = 2


class BadOption(BadInput):
    """There is no such option, or it does not take this value (exit code 2). `option`: its name; `suggestions`: the nearest."""

    option, suggestions = None, ()


class PartialOutput(BoleError):
    """The run was asked to finish early: outputs were written, of a result that is not complete (exit code 4). `result` has it."""

    exit_code, result = 4, None


class Cancelled(_Told, KeyboardInterrupt):
    """The run was cancelled, and nothing was changed (exit code 3).

    A KeyboardInterrupt, so that Ctrl-C also ends the loop of a script that goes on after a BoleError.
    """

    exit_code = 3


class NoSuchName(KeyError):
    """A result has nothing of this name. Its text is a sentence, which KeyError would show in quotes."""

    def __str__(self):
        return str(self.args[0])


OF_CODE = {1: Failed, 2: BadInput, 3: Cancelled, 4: PartialOutput}


def in_python(text):
    """A message of the program with its remedies as they are written in Python."""
    text = re.sub(r"--set (\w+\.\w+)=(\S+?)(?=[\s.,;)]*(?:\s|$))", r'set={"\1": "\2"}', text)
    return text.replace("--accept-partial", "accept_partial=True").replace("--force", "force=True")


def suggested(text):
    """The names that a message suggests: "Did you mean slam or slice?"."""
    found = re.search(r"Did you mean (.+?)\?", text)
    return tuple(re.split(r", | or ", found.group(1))) if found else ()


def of_code(code, text, **known):
    return OF_CODE.get(code, Failed)(in_python(text), **known)


@contextlib.contextmanager
def translated():
    """Errors of the engine of campaigns as those of this package."""
    from bole_campaign.errors import CampaignError

    try:
        yield
    except CampaignError as error:
        raise of_code(error.exit_code, str(error)) from None


def path_or_none(folder):
    return pathlib.Path(folder) if folder else None
