"""What the engine itself takes: a line in runs.jsonl for each run of the client that came to its end.

tests/bench/campaign/scaling.py computes from it what more workers would give.
"""

import contextlib
import json
import socket
import time

from .attempt import now


class Costs:
    """Seconds by the clock and of the processor, of this process, in the phases of a run:

        plan    what is to be done: keys, states, the ledger         start   workers
        work    from the first input to the last                     merge   tables, ledger and page
        wait    within work: nothing to do but wait for inputs
    """

    def __init__(self, inputs):
        self.began, self.inputs, self.attempts = now(), inputs, 0
        self.workers, self.engine = 0, ""
        self.wall, self.cpu = {}, {}

    @contextlib.contextmanager
    def phase(self, name):
        wall, cpu = time.monotonic(), time.process_time()
        try:
            yield
        finally:
            self.wall[name] = self.wall.get(name, 0.0) + time.monotonic() - wall
            self.cpu[name] = self.cpu.get(name, 0.0) + time.process_time() - cpu

    def note(self, out, exit_code):
        line = {"began": self.began, "ended": now(), "host": socket.gethostname(), "engine": self.engine, "workers": self.workers, "inputs": self.inputs,
                "attempts": self.attempts, "exit_code": exit_code, "wall_s": rounded(self.wall), "cpu_s": rounded(self.cpu)}
        with open(out / "runs.jsonl", "a", encoding="utf-8") as file:
            file.write(json.dumps(line) + "\n")


def rounded(seconds):
    return {name: round(value, 4) for name, value in seconds.items()}
