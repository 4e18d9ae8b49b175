"""Runs what a plan needs: starts attempts where there is room, tries again what was killed, keeps the ledger."""

import contextlib
import os
import pathlib
import signal
import socket
import time
import uuid

from . import attempt, cluster, costs, folders, geopackage, page, planning, states
from .errors import CANCELLED, FINISHED_EARLY, bad_input, failure
from .local import LocalWorkers
from .memory import machine_gib, processors
from .progress import Progress

WAIT_S = 0.2
PAGE_EVERY_S = 20
MOST_LOSSES = 10  # of one input: more often than that its workers are not killed by chance


class Room:
    """Places and memory of this machine. Elsewhere the scheduler of the cluster knows what fits."""

    def __init__(self, places, gib):
        self.places, self.gib, self.taken = places, gib, {}

    def fits(self, spec):
        return len(self.taken) < self.places and (not self.taken or sum(self.taken.values()) + spec["memory_gib"] <= self.gib)

    def take(self, spec):
        self.taken[spec["id"]] = spec["memory_gib"]

    def give_back(self, spec):
        self.taken.pop(spec["id"], None)


class Interrupts:
    """The first Ctrl-C lets what runs end and starts nothing more, the second cancels; so does SIGTERM. Told by files,
    which attempts on any machine see."""

    def __init__(self, out):
        self.finish_file, self.stop_file = (out / f".{word}-{uuid.uuid4().hex[:8]}" for word in ("finish", "stop"))
        self.asked = 0
        self.before = {number: signal.signal(number, self._take) for number in (signal.SIGINT, signal.SIGTERM)}

    def _take(self, number, _frame):
        self.asked = 2 if number == signal.SIGTERM else self.asked + 1
        self.finish_file.touch()
        if self.asked >= 2:
            self.stop_file.touch()
        print("\nCancelling." if self.asked >= 2 else "\nInputs that are at work run to their end; interrupt again to cancel them.", flush=True)

    def end(self):
        for number, handler in self.before.items():
            signal.signal(number, handler)
        for file in (self.finish_file, self.stop_file):
            file.unlink(missing_ok=True)


def start_workers(request, most):
    """The workers, and the room of this machine (None where a cluster decides)."""
    if request.get("scheduler"):
        if cluster.import_dask() is None:
            raise failure("Dask.distributed is not installed for this Python", "python3-distributed", "Or give a Python that has it: BOLE_PYTHON=PATH")
        return cluster.DaskWorkers(scheduler=request["scheduler"]), None
    gib = request.get("memory_gib") or machine_gib()
    engine = request.get("engine", "auto")
    if engine == "dask" and cluster.import_dask() is None:
        raise failure("Dask.distributed is not installed for this Python", "python3-distributed, or --engine local", "Or give a Python that has it: BOLE_PYTHON=PATH")
    places = max(1, min(request.get("workers") or processors(), most))
    uses_dask = engine == "dask" or (engine == "auto" and cluster.import_dask() is not None)
    return (cluster.DaskWorkers(workers=places) if uses_dask else LocalWorkers(places)), Room(places, gib)


@contextlib.contextmanager
def only_client(out):
    """Two clients in one folder would each think that the ledger is theirs."""
    with folders.lock(str(out / "lock")) as handle:
        if handle is None:
            other = folders.read_json(out / "client.json") or {}
            raise failure(f"another client works in '{out}' (process {other.get('pid', '?')} on {other.get('host', '?')})", "one client for a folder",
                          "Wait for its end: bole campaign status tells how far it is")
        folders.write_json(out / "client.json", {"pid": os.getpid(), "host": socket.gethostname()})
        for left in out.glob(".*"):
            if left.name.startswith((".finish-", ".stop-")):
                left.unlink()  # of a client that was killed
        yield


class Run:
    def __init__(self, of_plan, request):
        self.plan, self.request = of_plan, request
        self.page_written = 0.0
        self.costs = costs.Costs(len(of_plan.tasks))
        self.crashes, self.losses, self.waiting, self.at_work = {}, {}, [], {}

    def run(self):
        """Returns the exit code."""
        self.plan.out.mkdir(parents=True, exist_ok=True)
        with only_client(self.plan.out):
            for task in self.plan.tasks:
                if (folder := pathlib.Path(task["folder"])).is_dir():
                    with folders.lock(str(folder / "lock")) as handle:
                        if handle is not None:
                            folders.adopt(folder)
            self.plan.keep()
            ledger = geopackage.Ledger(self.plan.out / "campaign.gpkg")
            try:
                code = self._run_with(ledger)
                self.costs.note(self.plan.out, code)
                return code
            finally:
                ledger.close()

    def _run_with(self, ledger):
        self.ledger = ledger
        asked = 0
        for tasks in self.plan.phases():
            asked = self._run_phase(tasks)
            if asked:
                break
        if asked >= 2:
            print(f"Cancelled. What was done before is kept in {self.plan.out}", flush=True)
            return CANCELLED
        with self.costs.phase("merge"):
            rows, notes = self.plan.merge(ledger)
        print_end(self.plan, rows, notes)
        return FINISHED_EARLY if asked == 1 and any(row["state"] in ("missing", "changed") for row in rows) else states.exit_code_of(rows)

    def _run_phase(self, tasks):
        """How often it was interrupted."""
        with self.costs.phase("plan"):
            looked = [(task, *planning.look_at(task, self.request.get("retry", False))[:2]) for task in tasks]
            self.waiting = [task for task, what, _ in looked if what in planning.TO_RUN]
            self.rows = {row["input_id"]: row for row in self.plan.rows()}
            self.ledger.write_inputs(list(self.rows.values()))
        return self._run_waiting(len(looked)) if self.waiting else 0

    def _run_waiting(self, of):
        interrupts = Interrupts(self.plan.out)
        workers = None
        try:
            with self.costs.phase("start"):
                workers, self.room = start_workers(self.request, len(self.waiting))
            self.costs.workers, self.costs.engine = workers.workers, workers.name
            self._fit_to(workers)
            print(f"{self.plan.named(self.waiting[0], of)}, {len(self.waiting)} to run, {workers.workers} at a time ({workers.name}"
                  + (f", {self.room.gib:.1f} GiB)" if self.room else ")"), flush=True)
            with self.costs.phase("work"):
                self._loop(workers, interrupts)
            return interrupts.asked
        except BaseException:
            interrupts.stop_file.touch()
            raise
        finally:
            if workers is not None:
                workers.close()
            interrupts.end()

    def _fit_to(self, workers):
        """Every task gets no more memory than there is, and the threads of those that cannot run beside it; the largest
        begin, so that none is last alone."""
        for task in self.waiting:
            if self.room:
                beside = min(workers.workers, len(self.waiting), int(self.room.gib // task["memory_gib"]))
                task["threads"] = task.get("threads") or processors() // max(1, beside) or 1
                if task["memory_gib"] > self.room.gib:
                    print(f"{task['id']} declares {task['memory_gib']:.1f} GiB, there are {self.room.gib:.1f}: it runs alone, within these", flush=True)
                    task["memory_gib"] = self.room.gib
        self.waiting.sort(key=lambda task: -task["memory_gib"])
        self.progress = Progress({task["id"]: task["memory_gib"] for task in self.waiting})

    def _loop(self, workers, interrupts):
        files = {"finish_file": str(interrupts.finish_file), "stop_file": str(interrupts.stop_file)}
        cancel_began = None
        while self.at_work or (self.waiting and not interrupts.asked):
            while not interrupts.asked and (task := next((t for t in self.waiting if self.room is None or self.room.fits(t)), None)):
                self.waiting.remove(task)
                self.at_work[task["id"]] = task
                self._show({**self.rows[self.plan.row_id(task)], "state": "running"})
                if self.room:
                    self.room.take(task)
                self.costs.attempts += 1
                workers.start({**task, **files, "retry": self.request.get("retry", False)})
            self.progress.draw(len(self.at_work))
            with self.costs.phase("wait"):
                ended = workers.finished(WAIT_S)
            for spec, result in ended:
                self._take(self.at_work.pop(spec["id"]), result)
            if interrupts.asked >= 2:
                cancel_began = cancel_began or time.monotonic()
                if time.monotonic() - cancel_began > attempt.PATIENCE_AFTER_CANCEL_S + 5:
                    return
        self.progress.clear()

    def _take(self, task, result):
        """What became of an attempt: it is recorded, or tried again."""
        if self.room:
            self.room.give_back(task)
        state = result["state"]
        if state == "cancelled":
            return
        if state == "busy":
            self.waiting.append(task)  # a task of a job array works on it
            return
        if state == "lost":
            self.losses[task["id"]] = self.losses.get(task["id"], 0) + 1
            if self.losses[task["id"]] <= MOST_LOSSES:
                self.progress.line(f"{task['id']:<16} lost ({result.get('error', '')}): once more")
                self.waiting.insert(0, task)
                return
            result = attempt.record_loss(task, f"its workers were lost {self.losses[task['id']]} times ({result.get('error', '')})")
        elif state == "crashed" and self._tries_again(task, result):
            self.progress.line(f"{task['id']:<16} {result['error']}: once more")
            self.waiting.insert(0, task)
            return
        self.progress.end(result)
        self._show(self.plan.row_of(task, running=False))

    def _show(self, row):
        """In the ledger now, on the page from time to time."""
        self.rows[row["input_id"]] = row
        self.ledger.update_input(row)
        if time.monotonic() - self.page_written > PAGE_EVERY_S:
            page.write(self.plan.out / "campaign.html", self.plan.title, list(self.rows.values()), ["The campaign is at work: this page is of " + time.strftime("%Y-%m-%d %H:%M:%S")])
            self.page_written = time.monotonic()

    def _tries_again(self, task, result):
        self.crashes[task["id"]] = self.crashes.get(task["id"], 0) + 1
        if self.crashes[task["id"]] > self.plan.retries or result.get("before"):
            return False
        if result.get("why") == "memory":
            most = self.room.gib if self.room else float("inf")
            if task["memory_given"] or task["memory_gib"] >= most:
                return False  # what the document declares is kept to
            task["memory_gib"] = round(min(2 * task["memory_gib"], most), 2)
        return result.get("why") != "time"


def print_end(of_plan, rows, notes):
    for note in notes:
        print(f"note: {note}")
    for row in sorted(rows, key=states.badness):
        if row["state"] != "done":
            print(f"{row['input_id']:<16} {row['state'].replace('_', ' '):<10} {row['error']}")
    print(f"{len(rows)} {of_plan.rows_are}: {states.in_words(states.counts_of(rows))}")
    print(f"Results are in {of_plan.out}: {', '.join(of_plan.results)}", flush=True)


def run_task(of_plan, request):
    """One input of a job array. Arrays that count from 0 and from 1 both reach every input once."""
    out = of_plan.out
    if folders.read_json(out / "plan.json") is None:
        of_plan.keep()
    task, waits = of_plan.task_of_array(request["task"])
    if task is None:
        print(waits, flush=True)
        return 0
    task["threads"] = task.get("threads") or processors()
    task["memory_gib"] = task["memory_gib"] if task["memory_given"] else min(task["memory_gib"], machine_gib())
    interrupts = Interrupts(out)
    try:
        spec = {**task, "stop_file": str(interrupts.stop_file), "finish_file": "", "retry": request.get("retry", False)}
        for turn in range(of_plan.retries + 1):
            record = attempt.run_attempt(spec)
            if record["state"] != "crashed" or record.get("why") == "time" or interrupts.asked:
                break
            if record.get("why") == "memory":
                if task["memory_given"]:
                    break
                spec["memory_gib"] *= 2
    finally:
        interrupts.end()
    Progress({task["id"]: 1.0}).end({"input_id": task["id"], **record})
    with folders.lock(str(out / "lock"), attempt.PATIENCE_S) as handle:
        # The last of the array puts the tables together; earlier ones see that others are missing.
        if handle is not None and of_plan.is_through():
            print_end(of_plan, *of_plan.merge())
    return {"done": 0, "bad_input": 2, "cancelled": CANCELLED}.get(record["state"], 1)
