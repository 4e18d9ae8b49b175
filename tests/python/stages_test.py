#!/usr/bin/env python3
"""bole.stages(), bole.pipelines(), python3 -m bole and bole.campaign against the program."""

import json
import pathlib
import pydoc
import subprocess
import sys
import tempfile
import unittest

import bole
import bole.campaign
import plot


def told(*arguments, **more):
    return subprocess.run(list(map(str, arguments)), capture_output=True, text=True, timeout=120, check=False, **more)


class Stages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.declared = {stage["type"]: stage for stage in json.loads(told(plot.PROGRAM, "stages", "--json").stdout)}

    def test_every_stage_and_option_has_its_facts(self):
        stages = bole.stages()
        self.assertEqual(set(stages), set(self.declared))
        count = 0
        for name, declared in self.declared.items():
            page = stages[name].__doc__
            words = " ".join(page.split())
            self.assertIn(" ".join(declared["help"].split()), words)
            for option in declared["options"]:
                line = next(line for line in page.partition("\nOptions\n")[2].splitlines() if line.startswith(f"{option['name']} : "))
                self.assertIn(" ".join(option["help"].split()), words, f"{name}.{option['name']}")
                for fact in (option["unit"], *(f"{option[key]:.15g}" for key in ("min", "max") if key in option), *(option.get("choices", ()) if option["type"] == "choice" else ())):
                    self.assertIn(fact, line, f"{name}.{option['name']}")
                default = option["default"]
                self.assertIn("default " + ("empty" if default == "" else default if isinstance(default, str) else json.dumps(default)), line)
                count += 1
        self.assertGreater(count, 300)

    def test_help_shows_the_stage(self):
        page = pydoc.plain(pydoc.render_doc(bole.stages()["stems.slice"]))
        self.assertIn("height : number, m, ", page)
        self.assertIn("height : number, m, ", repr(bole.stages()["stems.slice"]))
        self.assertIn("# stems.slice", bole.stages()["stems.slice"]._repr_markdown_())
        option = bole.stages()["stems.slice"].options["height"]
        self.assertEqual((option.unit, option.type), ("m", "number"))
        self.assertLess(option.min, option.default)

    def test_conditions_are_told(self):
        name, option = next((name, o) for name, d in self.declared.items() for o in d["options"] if o.get("conditions"))
        self.assertIn("Only if", bole.stages()[name].options[option["name"]].__doc__)

    def test_listings(self):
        self.assertIn("stems.measure", repr(bole.stages()))
        with self.assertRaisesRegex(bole.BadInput, "Did you mean stems.measure"):
            bole.stages()["stems.mesure"]
        pipelines = bole.pipelines()
        self.assertEqual(set(pipelines), {p.stem for p in (plot.TOP / "pipelines").glob("*.json")})
        self.assertIn("io.read_scan", repr(pipelines["forest_plot"]))
        self.assertNotIn("--set", repr(pipelines["forest_plot"]))

    def test_run_tells_of_its_arguments(self):
        for name in bole.run.__kwdefaults__:
            self.assertRegex(bole.run.__doc__, rf"(?m)^    {name} ")


class Module(unittest.TestCase):
    def test_hands_over_to_the_program(self):
        for arguments in (["--version"], ["--help"], ["stages", "stems.slice"], ["no_such_command"]):
            ours, theirs = told(sys.executable, "-m", "bole", *arguments), told(plot.PROGRAM, *arguments)
            self.assertEqual((ours.returncode, ours.stdout, ours.stderr), (theirs.returncode, theirs.stdout, theirs.stderr))
        self.assertIn(bole.__version__, told(sys.executable, "-m", "bole", "--version").stdout)

    def test_says_what_is_missing(self):
        ours = told(sys.executable, "-m", "bole", "--version", env={**plot.os.environ, "BOLE_PROGRAM": "/no/such/program"})
        self.assertNotEqual(ours.returncode, 0)
        self.assertRegex(ours.stderr, "^bole: .*/no/such/program")
        self.assertEqual(len(ours.stderr.splitlines()), 1)


class Campaign(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bole_python_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_plan_run_status_merge(self):
        plot.written(plot.plot_points(), self.folder / "a.xyz")
        document = {"pipeline": "stem_map_from_cloud", "set": plot.QUICK,
                    "inputs": [{"id": name, "set": {"scan.file": str(self.folder / f"{name}.xyz")}} for name in ("a", "absent")]}
        out = self.folder / "out"
        self.assertEqual([row["runs"] for row in bole.campaign.plan(document, out)], [True, True])
        self.assertEqual(bole.campaign.run(document, out, workers=1, engine="local"), 2)
        self.assertEqual([(row["input_id"], row["state"]) for row in bole.campaign.status(out)], [("a", "done"), ("absent", "bad_input")])
        table = (out / "stems.csv").read_text()
        (out / "stems.csv").unlink()
        self.assertEqual(len(bole.campaign.merge(out)), 2)
        self.assertEqual((out / "stems.csv").read_text(), table)
        self.assertEqual(len(table.splitlines()), 1 + len(plot.STEMS))
        # The command line goes on with the same campaign.
        planned = told(plot.PROGRAM, "campaign", "plan", out / "campaign.json", "--out", out)
        self.assertIn("0 of 2 inputs run", planned.stdout)

    def test_errors_are_those_of_the_package(self):
        with self.assertRaisesRegex(bole.BadInput, "Did you mean forest_plot"):
            bole.campaign.plan({"pipeline": "forest_plt", "inputs": []}, self.folder / "out")
        with self.assertRaises(bole.BadInput) as caught:
            bole.campaign.status(self.folder / "absent")
        self.assertEqual(caught.exception.exit_code, 2)


if __name__ == "__main__":
    unittest.main()
