#!/usr/bin/env python3
"""Mixed and broad-leaved stands with poles below the trees: what a survey finds, measures and tells.

    stands.py --bole PROGRAM --work FOLDER [--stands mixed_stand,broadleaf] [--seeds 1,2] [--size 20] [--poses true] [--list]

Simulates every stand of resources/plots with every seed, surveys it by pipelines/forest_plot.json and judges the stems
from 7.5 cm and from 4 cm: completeness and correctness, bias and RMSE of DBH up to 25 cm and beyond (relative), 95 %
intervals that hold, and ("silent") stems that nobody is asked to look at though they are off by more than twice their
interval. Stems are held against the tape, which lies on the ridges of the bark, and, in a second table, against the mean
bark that lasers see. Thin stems that are no trees (saplings.csv) are neither found nor false. Maps and results stay in
FOLDER, so that an interrupted table goes on where it stopped; --again measures the stems anew on the maps that are there.
"""

import argparse
import contextlib
import io
import json
import pathlib
import types

from stem_tables import Sample, judge, mean, number, rms, rows_of
from surveys import ENDED_EARLY, REPOSITORY, remove_recording, simulate, survey

LEAST_CM = (7.5, 4)
THICK_CM = 25  # up to here errors count in cm, beyond in per cent
BARK_SHARE = 0.284  # mean depth of simulated bark by the depth of its fissures: the mean square of its noise
# Thinner than what is judged: a stem at the limit may be measured below it.
SURVEY = ["stems.min_dbh=3", "plot.min_dbh=4"]
MAP_STAGES = {"io.read_scan", "slam.run", "slam.edit_loops", "survey.frame", "survey.edit_points", "ground.model"}


def forget_stems(cache):
    """Removes all stored results that depend on the stems."""
    for file in (cache / "results").glob("*.json"):
        if json.loads(file.read_text(encoding="utf-8")).get("entry", {}).get("stage") not in MAP_STAGES:
            file.unlink()


def recipe_of(stand, size_m):
    """The recipe of a stand; on a plot of another size as many trees per hectare."""
    recipe = json.loads((REPOSITORY / f"resources/plots/{stand}.json").read_text(encoding="utf-8"))
    recipe["trees"]["count"] = round(recipe["trees"]["count"] * (size_m / recipe["size_m"]) ** 2)
    recipe["size_m"], recipe["buffer_m"] = size_m, min(recipe["buffer_m"], 8)
    return recipe


def scanned(options, stand, seed):
    """The folder of a scan, which is simulated where it is not there yet."""
    plot = stand
    if options.size:
        plot = options.work / f"{stand}_{options.size:g}.json"
        plot.write_text(json.dumps(recipe_of(stand, options.size)), encoding="utf-8")
    return simulate(options.bole, ["--plot", plot, "--seed", seed, "--speed", options.speed], options.work / f"{stand}_{seed}")


def surveyed(options, stand, seed):
    """Folders of the survey and of the truth of one run; made where they are not there yet."""
    folder = options.work / f"{stand}_{seed}"
    scan, out, cache = folder / "scan", folder / f"survey_{options.poses}{options.name}", folder / f"cache_{options.poses}"
    if options.again or not (out / "summary.json").exists():
        if not cache.exists():
            scanned(options, stand, seed)
        forget_stems(cache)
        settings = [f"reference_trees.file={scan}/trees.csv", f"reference_path.file={scan}/trajectory.tum", *SURVEY, *options.set]
        settings += [f"slam.trajectory={scan}/trajectory.tum"] if options.poses == "true" else []
        survey(options.bole, scan, settings, out, ["--cache", cache], (0, ENDED_EARLY))
        if not options.keep:
            remove_recording(scan, out)
    return out, scan


def mean_bark(scan):
    """The trees of a scan with the diameters that their mean bark has."""
    usual = json.loads((scan / "recipe.json").read_text(encoding="utf-8"))["plot"]["trees"]["bark_mm"]
    trees = rows_of(scan / "trees.csv")
    for tree in trees:
        tree["dbh_cm"] = str(number(tree, "dbh_cm") - 0.2 * BARK_SHARE * float(tree.get("bark_mm") or usual))
    return trees


def quietly(options, *arguments):
    """judge() without its words, unless they are asked for."""
    with contextlib.nullcontext() if options.list else contextlib.redirect_stdout(io.StringIO()):
        return judge(*arguments)


def diameters(sample):
    thin, thick = sample.part(0, THICK_CM), sample.part(THICK_CM, 1000)
    relative = [100 * e / d for e, d in zip(thick.error, thick.dbh)]
    beyond = f"{mean(relative):+.1f} / {rms(relative):.1f}" if relative else ""
    return f"{mean(thin.error):+.2f} / {rms(thin.error):.2f} | {beyond} | {100 * mean(sample.covered):.1f} % within +-{mean(sample.half):.2f}"


def share(part, whole):
    return f"{100 * part / max(1, whole):.1f} % ({part} of {whole})"


def counts(sample):
    found = sample.trees - sample.missed
    return f"{share(found, sample.trees)} | {share(found, found + sample.false)}"


def silent(sample):
    """Stems that nobody is asked to look at and that are wrong by more than twice their interval."""
    return sum(state == "auto" and abs(e) > 2 * h for state, e, h in zip(sample.state, sample.error, sample.half))


def told(runs):
    """Verdicts, error of the path and time of each run."""
    lines = []
    for name, (out, _) in runs.items():
        summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
        stages = {s["id"]: s for s in summary["stages"]}
        ate = stages["evaluate"].get("metrics", {}).get("ate_rmse", {}).get("value")
        slam = stages["slam"]
        lines.append(f"| {name} | {summary['verdict']} | {'' if ate is None else f'{100 * ate:.1f}'} | "
                     f"{1000 * slam['seconds'] / max(1, slam['counts'].get('frames', 0)):.0f} | {stages['stems']['seconds']:.0f} | "
                     f"{', '.join(sorted({f['code'] for f in summary['findings'] if f['severity'] != 'note'}))} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path, help="folder for runs and their logs")
    parser.add_argument("--stands", default="mixed_stand,broadleaf")
    parser.add_argument("--seeds", default="1")
    parser.add_argument("--poses", choices=("slam", "true"), default="slam")
    parser.add_argument("--size", type=float, help="side of the plots in m, with as many trees per hectare")
    parser.add_argument("--speed", type=float, default=1, help="of the walk, m/s")
    parser.add_argument("--set", action="append", default=[], metavar="STAGE.OPTION=VALUE", help="of the survey")
    parser.add_argument("--name", default="", help="of these settings: results with others stay beside theirs")
    parser.add_argument("--again", action="store_true", help="measure stems anew on the maps that are kept")
    parser.add_argument("--keep", action="store_true", help="keep recordings")
    parser.add_argument("--list", action="store_true", help="print every tree, and those missed and false")
    options = parser.parse_args()
    options.work = options.work.resolve()
    options.work.mkdir(parents=True, exist_ok=True)
    rows, bark_rows, lines = [], [], []
    for stand in options.stands.split(","):
        runs = {f"{stand} {seed}": surveyed(options, stand, int(seed)) for seed in options.seeds.split(",")}
        lines += told(runs)
        for least in LEAST_CM:
            matching = types.SimpleNamespace(gate=0.3, min_dbh=least, list=options.list)
            tape, bark = Sample(), Sample()
            for out, scan in runs.values():
                tape.extend(quietly(options, out, scan, matching))
                bark.extend(quietly(types.SimpleNamespace(list=False), out, scan, matching, mean_bark(scan)))
            rows.append(f"| {stand}, from {least:g} cm | {counts(tape)} | {diameters(tape)} | {silent(tape)} |")
            bark_rows.append(f"| {stand}, from {least:g} cm | {diameters(bark)} | {silent(bark)} |")
    heads = f"bias / RMSE to {THICK_CM} cm, cm | beyond, % | 95 % interval | silent |"
    print(f"| against the tape | found | right | {heads}\n|---|---|---|---|---|---|---|\n" + "\n".join(rows))
    print(f"\n| against the mean bark | {heads}\n|---|---|---|---|---|\n" + "\n".join(bark_rows))
    print("\n| run | verdict | ATE, cm | SLAM, ms/frame | stems, s | findings |\n|---|---|---|---|---|---|\n" + "\n".join(lines))


if __name__ == "__main__":
    main()
