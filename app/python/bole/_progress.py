"""How far a run is: a bar in a terminal, one line that changes in a notebook, lines elsewhere, or a function of yours."""

import sys
import time

from bole_campaign.progress import WIDTH, clock


def in_notebook():
    """Whether the program runs in a kernel of Jupyter. IPython is not imported for it."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None and hasattr(ipython, "get_ipython") else None
    return shell is not None and hasattr(shell, "kernel")


class Silent:
    def update(self, stage, fraction, text):
        """Called a few times a second."""

    def end(self, word):
        """Called once: "done", "finished early", "cancelled" or "failed"."""


class Function(Silent):
    def __init__(self, function):
        self.function, self.before = function, None

    def update(self, stage, fraction, text):
        if stage and (stage, fraction, text) != self.before:
            self.before = (stage, fraction, text)
            self.function(stage, fraction, text)


class Shown(Silent):
    """`step`: the least seconds between two pictures."""

    step = 0.1

    def __init__(self, name):
        self.name, self.stage, self.drawn = name, "", 0.0
        self.begin = self.stage_begin = time.monotonic()

    def update(self, stage, fraction, text):
        now = time.monotonic()
        if stage != self.stage:
            self.stage, self.stage_begin = stage, now
        if stage and now - self.drawn >= self.step:
            self.drawn = now
            spent = now - self.stage_begin
            left = f", {clock(spent * (1 - fraction) / fraction)} left" if fraction > 0.02 and spent > 2 else ""
            bar = "=" * int(fraction * WIDTH)
            self.draw(f"{stage:<10} [{bar:<{WIDTH}}] {100 * fraction:3.0f} % {text}{left}")

    def end(self, word):
        self.close(f"{self.name}: {word} after {clock(time.monotonic() - self.begin)}")


class Terminal(Shown):
    def draw(self, line):
        sys.stderr.write(f"\r\033[K{line}")
        sys.stderr.flush()

    def close(self, _line):
        if self.drawn:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()


class Lines(Shown):
    """A line for every stage and tenth."""

    step, told = 0.0, None

    def update(self, stage, fraction, text):
        if (stage, int(10 * fraction)) != self.told:
            self.told = (stage, int(10 * fraction))
            super().update(stage, fraction, text)

    def draw(self, line):
        print(line, file=sys.stderr, flush=True)

    close = draw


class Notebook(Shown):
    step = 0.25

    def __init__(self, name):
        super().__init__(name)
        from IPython.display import display

        self.handle = display({"text/plain": f"{name}: starting"}, raw=True, display_id=True)

    def draw(self, line):
        self.handle.update({"text/plain": line}, raw=True)

    close = draw


def shown(wanted, name):
    """`wanted`: None (where a person looks), True, False, or a function of stage, fraction and text."""
    if callable(wanted):
        return Function(wanted)
    if wanted is False:
        return Silent()
    if in_notebook():
        return Notebook(name)
    if sys.stderr is not None and sys.stderr.isatty():
        return Terminal(name)
    return Lines(name) if wanted else Silent()
