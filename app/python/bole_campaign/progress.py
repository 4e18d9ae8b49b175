"""What a person sees while a campaign runs: a line per input that ended, and a bar with the time left on a terminal."""

import sys
import time

WIDTH = 24


def clock(seconds):
    seconds = int(seconds + 0.5)
    if seconds < 60:
        return f"{seconds} s"
    return f"{seconds // 60}:{seconds % 60:02} min" if seconds < 3600 else f"{seconds // 3600}:{seconds // 60 % 60:02} h"


class Progress:
    """`costs`: of each input that runs, in any unit that grows with its time."""

    def __init__(self, costs):
        self.costs, self.total = costs, sum(costs.values())
        self.begin, self.done_cost, self.ended, self.bad, self.drawn = time.monotonic(), 0.0, 0, 0, False
        self.terminal = sys.stderr.isatty()

    def left(self):
        """Time left in words, once there is something to judge by."""
        spent = time.monotonic() - self.begin
        return f", {clock(spent * (self.total - self.done_cost) / self.done_cost)} left" if self.done_cost > 0 and self.ended < len(self.costs) else ""

    def end(self, record):
        """Tells about an input that ended."""
        self.ended += 1
        self.done_cost += self.costs.get(record["input_id"], 0.0)
        self.bad += record["state"] != "done"
        facts = f"{record.get('seconds', 0):8.1f} s {record.get('peak_mib', 0):6.0f} MiB"
        told = record.get("error") or ", ".join(t for t in (record.get("verdict", ""), "" if record.get("stems") is None else f"{record['stems']} stems") if t)
        self.line(f"{record['input_id']:<16} {record['state'].replace('_', ' '):<10} {facts}  {told}" + ("" if self.terminal else f"  [{self.ended}/{len(self.costs)}{self.left()}]"))

    def line(self, text):
        self.clear()
        print(text, flush=True)

    def draw(self, running):
        if not self.terminal:
            return
        share = self.done_cost / self.total if self.total else 1.0
        bar = "=" * int(share * WIDTH)
        bad = f", {self.bad} not done" if self.bad else ""
        sys.stderr.write(f"\r\033[K[{bar:<{WIDTH}}] {self.ended}/{len(self.costs)}, {running} at work{bad}{self.left()}")
        sys.stderr.flush()
        self.drawn = True

    def clear(self):
        if self.drawn:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()
        self.drawn = False
