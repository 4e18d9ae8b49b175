"""The verbs of `bole campaign`. Their options are declared in app/cli/commands/campaign.cpp and come as JSON."""

import json
import os
import sqlite3
import sys

from . import client, planning, states
from .errors import CANCELLED, CampaignError, bad_input
from .memory import machine_gib


def kept_plan(out):
    found = planning.Plan.of_folder(out) if os.path.isdir(out) else None
    if found is None:
        raise bad_input(f"'{out}' holds no campaign", "the folder of a campaign", "bole campaign run campaign.json --out DIR makes one")
    return found


def planned(request):
    return planning.Plan.of_document(request["campaign"], request["out"], request["program"], request["version"])


def plan_rows(request):
    """What a run would do with each input, in the order of the document."""
    looked = ((task, *planning.look_at(task, request.get("retry", False))[:2]) for task in planned(request).tasks)
    return [{"task": i, "id": task["id"], "what": what, "why": why, "runs": what in planning.TO_RUN, "memory_gib": task["memory_gib"], "set": task["set"]}
            for i, (task, what, why) in enumerate(looked, 1)]


def print_plan(request):
    rows = plan_rows(request)
    if request.get("json"):
        print(json.dumps(rows, indent=1))
        return 0
    print(f"{'task':>5} {'input':<16} {'GiB':>6}  why")
    for row in rows:
        what = "runs" if row["runs"] else row["what"].replace("_", " ")
        print(f"{row['task']:>5} {row['id']:<16} {row['memory_gib']:>6.2f}  {what}{': ' + row['why'] if row['why'] else ''}")
    print(f"{sum(row['runs'] for row in rows)} of {len(rows)} inputs run; this machine has {machine_gib():.1f} GiB for them")
    return 0


def run(request):
    found = planned(request)
    return client.run_task(found, request) if "task" in request else client.Run(found, request).run()


def print_status(request):
    found = kept_plan(request["out"])
    rows = sorted(found.rows(), key=states.badness)
    if request.get("json"):
        print(json.dumps({"title": found.title, "folder": str(found.out), "counts": states.counts_of(rows), "exit_code": states.exit_code_of(rows), "inputs": rows}, indent=1))
        return 0
    print(f"{'input':<16} {'state':<10} {'verdict':<8} {'stems':>6} {'time (s)':>9} {'MiB':>7} {'tries':>5}  error")
    for row in rows:
        stems = "" if row["stems"] is None else row["stems"]
        seconds, peak = ("" if row[name] is None else format(row[name], form) for name, form in (("seconds", ".1f"), ("peak_mib", ".0f")))
        print(f"{row['input_id']:<16} {row['state'].replace('_', ' '):<10} {row['verdict']:<8} {stems:>6} {seconds:>9} {peak:>7} {row['attempts']:>5}  {row['error']}")
    print(f"{len(rows)} {found.rows_are}: {states.in_words(states.counts_of(rows))}")
    return 0


def merge_results(request):
    found = kept_plan(request["out"])
    with client.only_client(found.out):
        rows, notes = found.merge()
    client.print_end(found, rows, notes)
    return states.exit_code_of(rows)


VERBS = {"plan": print_plan, "run": run, "status": print_status, "merge": merge_results}


def main():
    request = json.loads(sys.argv[1])
    try:
        return VERBS[request["verb"]](request)
    except CampaignError as error:
        print(f"bole: {error}", file=sys.stderr)
        return error.exit_code
    except (OSError, sqlite3.Error) as error:
        print(f"bole: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return CANCELLED
