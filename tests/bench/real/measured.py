"""What real_clouds.py and mutants.py share: runs of the stem map of a cloud, and its stems beside a list."""
import csv
import json
import math
import pathlib
import statistics
import subprocess
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
PIPELINE = REPOSITORY / "pipelines/stem_map_from_cloud.json"
WITHOUT_REPORT = ["report.figures=false", "report.page=false", "report.cloud=false"]


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(text):
    return float(text) if text else math.nan


def survey(bole, cloud, out, settings=(), report=False, limit_s=900):
    """Runs the stem map: its stems, verdict, findings, exit code and wall seconds. `trouble` is the error where there are no stems."""
    command = [bole, "run", PIPELINE, "--out", out, "--no-cache", "--set", f"scan.file={cloud}"]
    for setting in [*settings, *([] if report else WITHOUT_REPORT)]:
        command += ["--set", setting]
    start = time.perf_counter()
    try:
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=limit_s)
        code, errors = done.returncode, done.stderr
    except subprocess.TimeoutExpired:
        code, errors = 124, f"stopped after {limit_s} s"
    result = {"code": code, "seconds": time.perf_counter() - start, "stems": [], "verdict": "", "findings": [], "trouble": ""}
    summary = pathlib.Path(out) / "summary.json"
    if summary.exists():
        told = json.loads(summary.read_text(encoding="utf-8"))
        result["verdict"] = told.get("verdict", "")
        result["findings"] = [f for f in told.get("findings", []) if f["code"] != "warning"]
    stems = pathlib.Path(out) / "stems.csv"
    if stems.exists():
        for r in rows_of(stems):
            if r.get("state") != "rejected":
                result["stems"].append({"x": float(r["x_m"]), "y": float(r["y_m"]), "z": number(r["z_m"]), "dbh": number(r["dbh_cm"]),
                                        "low": number(r["dbh_lo_cm"]), "high": number(r["dbh_hi_cm"]), "quality": r["quality"],
                                        "height": number(r.get("height_m", "")) if r.get("height_seen") == "1" else math.nan,
                                        "flagged": r["state"] == "check" or r["quality"] == "poor"})
    if code != 0:
        lines = [line for line in errors.splitlines() if line.strip() and not line.startswith("Results are")]
        result["trouble"] = next((line for line in lines if "rror" in line or "failed" in line), lines[-1] if lines else f"ended with {code}")
    elif not result["stems"] and not result["verdict"]:
        result["trouble"] = "no stems"
    return result


def codes(result):
    order = {"refused": 0, "look": 1, "note": 2}
    found = {}
    for f in sorted(result["findings"], key=lambda f: order[f["severity"]]):
        found.setdefault(f["code"], f["severity"])
    return ", ".join(code if severity != "note" else f"({code})" for code, severity in found.items())


def pairs_of(reference, stems, gate_m=0.5):
    """Nearest first, each once: index in the list -> index of the stem. A reference without a place takes the stem nearest in diameter."""
    if len(reference) == 1 and math.isnan(reference[0]["x"]):
        if not stems:
            return {}
        return {0: min(range(len(stems)), key=lambda k: abs(stems[k]["dbh"] - reference[0]["dbh"]) if not math.isnan(stems[k]["dbh"]) else math.inf)}
    offers = sorted((math.hypot(r["x"] - s["x"], r["y"] - s["y"]), i, k) for i, r in enumerate(reference) for k, s in enumerate(stems))
    pairs, used = {}, set()
    for distance, i, k in offers:
        if distance <= gate_m and i not in pairs and k not in used:
            pairs[i] = k
            used.add(k)
    return pairs


def compared(reference, stems, gate_m=0.5):
    """found, extra, flagged extra, DBH differences of the sound references in cm, and how many intervals of them hold the reference."""
    pairs = pairs_of(reference, stems, gate_m)
    extra = [s for k, s in enumerate(stems) if k not in pairs.values()]
    differences, holding, intervals = [], 0, 0
    for i, k in pairs.items():
        r, s = reference[i], stems[k]
        if r["quality"] not in ("good", "") or not r["dbh"] > 0 or not s["dbh"] > 0:
            continue
        differences.append(s["dbh"] - r["dbh"])
        if not math.isnan(s.get("low", math.nan)):
            intervals += 1
            holding += s["low"] <= r["dbh"] <= s["high"]
    return {"found": len(pairs), "of": len(reference), "extra": len(extra), "extra_flagged": sum(s["flagged"] for s in extra),
            "flagged": sum(stems[k]["flagged"] for k in pairs.values()), "differences": differences, "holding": holding, "intervals": intervals}


def bias_rmse(differences):
    if not differences:
        return ""
    return f"{statistics.fmean(differences):+.2f} / {math.sqrt(statistics.fmean([d * d for d in differences])):.2f} ({len(differences)})"
