"""Inputs at work through Dask.distributed: a cluster of this machine that starts by itself, or any with a scheduler.

Dask decides where and when an attempt runs. Points never travel through it: a spec goes out, a record comes back.
"""

import logging
import os
import queue
import signal
import shutil
import sys
import tempfile
import threading
import time
import uuid

from . import local
from .errors import failure

PATIENCE_S = 30.0  # for a scheduler that does not answer


def import_dask():
    """The modules of Dask, or None where they are not installed."""
    try:
        import cloudpickle
        import distributed
    except ImportError:
        return None
    return distributed, cloudpickle


def memory_of_worker(distributed):
    """A plugin: a worker that declares no GiB offers its own memory limit, or the memory of its machine."""

    class MemoryOfWorker(distributed.WorkerPlugin):
        name = "bole-memory"

        async def setup(self, worker):
            if "GiB" not in worker.state.total_resources:
                limit = worker.memory_manager.memory_limit or os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
                await worker.set_resources(GiB=limit / (1 << 30))

    return MemoryOfWorker()


class DaskWorkers:
    """`workers`: of a cluster of this machine; `scheduler`: the address, or the scheduler file, of another."""

    def __init__(self, workers=None, scheduler=None):
        self.distributed, cloudpickle = import_dask()
        # Workers need no Bole in their Python: functions travel by value.
        for module in (local, sys.modules[__name__]):
            cloudpickle.register_pickle_by_value(module)
        self.ended, self.running, self.cluster = queue.Queue(), {}, None
        self.remote, self.space = scheduler is not None, None
        self.lost_since = None
        if self.remote:
            self._join(scheduler)
        else:
            self._start(workers)

    def _start(self, workers):
        import dask

        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        # The children of a worker hold the memory: client.py counts what they declare.
        dask.config.set({"distributed.scheduler.allowed-failures": 0, "distributed.worker.daemon": True, "distributed.logging.distributed": "critical"})
        self.space = tempfile.mkdtemp(prefix="bole_dask_")  # else Dask writes into the working directory
        before = signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the client
        try:
            self.cluster = self.distributed.LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, memory_limit=None, dashboard_address=None, local_directory=self.space,
                                                         silence_logs=logging.CRITICAL)
            self.client = self.distributed.Client(self.cluster)
        finally:
            signal.signal(signal.SIGINT, before)
        self.name, self.workers = f"Dask {self.distributed.__version__} on this machine", workers

    def _join(self, scheduler):
        try:
            file = {"scheduler_file": scheduler} if os.path.isfile(scheduler) else {"address": scheduler}
            self.client = self.distributed.Client(**file, timeout=PATIENCE_S)
        except (OSError, ValueError, TimeoutError) as error:
            raise failure(f"no scheduler answers at '{scheduler}' ({error})", "the address of a running scheduler: tcp://HOST:8786", "Start one with dask-scheduler") from None
        try:
            self.client.wait_for_workers(1, timeout=PATIENCE_S)
        except (TimeoutError, self.distributed.TimeoutError):
            raise failure(f"the cluster at '{scheduler}' has no workers", "at least one", "Start one with dask-worker " + scheduler) from None
        register = getattr(self.client, "register_plugin", None) or self.client.register_worker_plugin  # its name before 2023.9
        register(memory_of_worker(self.distributed))
        workers = self.client.scheduler_info()["workers"]
        self.workers = sum(worker["nthreads"] for worker in workers.values())
        self.name = f"Dask at {scheduler}, {len(workers)} workers"
        self.largest_gib = max(self.client.run(lambda dask_worker: dask_worker.state.total_resources.get("GiB", 0.0)).values())
        # Attempts share the processors of a machine as the threads of its workers do.
        processors, places = {}, {}
        for address, count in self.client.run(lambda: len(os.sched_getaffinity(0))).items():
            host = workers[address]["host"] if address in workers else address
            processors[host] = max(count, processors.get(host, 1))
            places[host] = places.get(host, 0) + workers.get(address, {}).get("nthreads", 1)
        self.threads = max(1, min(processors[host] // places[host] for host in places))

    def start(self, spec):
        if self.remote:
            spec = {**spec, "threads": spec.get("threads") or self.threads, "memory_gib": min(spec["memory_gib"], self.largest_gib)}
        resources = {"GiB": spec["memory_gib"]} if self.remote else None
        future = self.client.submit(local.run_attempt_in_process, spec, key=f"bole-{uuid.uuid4().hex}", pure=False, resources=resources)
        self.running[future.key] = (future, spec)
        future.add_done_callback(self.ended.put)

    def finished(self, wait_s):
        """[(spec, result)] of attempts that ended by now, or within a time."""
        self._check_scheduler()
        ended = []
        try:
            future = self.ended.get(timeout=wait_s)
            while True:
                _, spec = self.running.pop(future.key, (None, None))
                if spec is not None:
                    ended.append((spec, self._result(future)))
                future = self.ended.get_nowait()
        except queue.Empty:
            return ended

    def _result(self, future):
        if future.status == "finished":
            return future.result()
        if future.status == "error":
            error = future.exception()
            killed = isinstance(error, self.distributed.scheduler.KilledWorker)
            return {"state": "lost", "error": "its worker was killed" if killed else str(error)}
        raise self._scheduler_is_gone()

    def _scheduler_is_gone(self):
        return failure("the scheduler cannot be reached any more", "a running scheduler", "Inputs that are done stay done: give the same command again")

    def _check_scheduler(self):
        if self.client.status == "running":
            self.lost_since = None
            return
        self.lost_since = self.lost_since or time.monotonic()
        if self.client.status == "closed" or time.monotonic() - self.lost_since > PATIENCE_S:
            raise self._scheduler_is_gone()

    def close(self):
        """Attempts that are still at work on this machine end with their workers; on a cluster the stop file ends them."""
        futures = [future for future, _ in self.running.values()]
        self.running = {}

        def end():
            try:
                if futures:
                    self.client.cancel(futures, force=True)
                self.client.close(timeout=5)
                if self.cluster is not None:
                    self.cluster.close(timeout=5)
            except Exception:  # a scheduler that is gone cannot be told
                pass

        ending = threading.Thread(target=end, daemon=True)
        ending.start()
        ending.join(15)
        if self.space:
            shutil.rmtree(self.space, ignore_errors=True)
