#!/usr/bin/env python3
"""The page of a survey in a headless Chromium: what a reader clicks, what is printed, and that nothing is fetched.

    report_page_test.py REPORT_TESTS     the program that writes a small survey
    report_page_test.py --page REPORT    a page that is there already

Exits 77 (skipped) where there is no Chromium: it is no dependency of the build.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import devtools

SKIPPED = 77
PAGE = None

VISIBLE_ROWS = "[...document.querySelectorAll('#stems tbody tr')].filter(r => !r.hidden)"
SELECTED = "[...document.querySelectorAll('.selected')].map(e => e.tagName.toLowerCase() + ':' + e.dataset.tree)"


def write_survey(program, folder):
    environment = {**os.environ, "BOLE_FIGURES_DIR": str(folder)}
    subprocess.run([program, "--gtest_filter=MakeReport.WritesEverything"], check=True, env=environment, stdout=subprocess.DEVNULL)
    return folder / "WritesEverything" / "report.html"


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = devtools.Browser(devtools.find_browser())
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.resize(1280, 900)
        self.browser.call("Emulation.setEmulatedMedia", media="")
        self.browser.forget()
        self.browser.open(PAGE)

    def run_js(self, script):
        return self.browser.run(script)

    def column(self, title):
        return self.run_js(
            f"(() => {{ const heads = [...document.querySelectorAll('#stems th')]; const c = heads.findIndex(h => h.textContent.startsWith('{title}'));"
            f" return {VISIBLE_ROWS}.map(r => parseFloat(r.cells[c].textContent)); }})()")

    def first_tree(self):
        return self.run_js("document.querySelector('#stems tbody tr').dataset.tree")

    def test_asks_for_nothing_and_has_no_errors(self):
        self.run_js("new Promise(done => setTimeout(done, 300))")
        self.assertEqual([url for url in self.browser.requests if not url.startswith(("file:", "data:", "blob:"))], [])
        self.assertEqual(len([url for url in self.browser.requests if url.startswith("file:")]), 1)
        self.assertEqual(self.browser.messages, [])

    def test_first_screen_answers(self):
        text = self.run_js(
            "[...document.querySelectorAll('#overview *')].filter(e => !e.children.length && e.getBoundingClientRect().top < innerHeight)"
            ".map(e => e.textContent).join(' ')")
        # The page of report_tests has no run that read a file; that of a whole run names it as "Input".
        for words in ("Recorded", "Sensor", "Plot", "Coordinates", "Basal area", "Stem volume", "Trees to look at"):
            self.assertIn(words, text)
        self.assertTrue(self.run_js("document.querySelector('.verdict h2').getBoundingClientRect().bottom < innerHeight / 2"))
        self.assertTrue(self.run_js("document.querySelector('svg.plan').getBoundingClientRect().top < innerHeight / 2"))
        self.assertGreater(self.run_js("document.querySelectorAll('ul.look li svg use').length"), 0)
        self.assertTrue(self.run_js("[...document.querySelectorAll('ul.look use')].every(u => document.querySelector(u.getAttribute('href')))"))

    def test_sorts(self):
        heading = "#stems th:nth-child({})".format(
            1 + self.run_js("[...document.querySelectorAll('#stems th')].findIndex(h => h.textContent.startsWith('DBH'))"))
        self.browser.click_on(heading)
        values = self.column("DBH")
        self.assertEqual(values, sorted(values))
        self.browser.click_on(heading)
        self.assertEqual(self.column("DBH"), sorted(values, reverse=True))
        self.assertGreater(len(values), 10)

    def test_filters_table_plan_and_slices_together(self):
        all_rows = self.run_js(VISIBLE_ROWS + ".length")
        self.run_js("document.querySelector('#quality').value = 'poor'; document.querySelector('#quality').dispatchEvent(new Event('input'))")
        rows = self.run_js(VISIBLE_ROWS + ".map(r => r.dataset.tree)")
        self.assertGreater(len(rows), 0)
        self.assertLess(len(rows), all_rows)
        self.assertEqual(self.run_js("[...document.querySelectorAll('.slices figure')].filter(f => !f.hidden).length"), len(rows))
        self.assertEqual(self.run_js("document.querySelectorAll('.plan g.tree:not(.dim)').length"), len(rows))
        self.assertEqual(self.run_js("document.querySelector('#shown').textContent"), f"{len(rows)} of {all_rows} shown")
        self.run_js("document.querySelector('#quality').value = ''; const f = document.querySelector('#find'); f.value = 'no such words';"
                    " f.dispatchEvent(new Event('input'))")
        self.assertEqual(self.run_js(VISIBLE_ROWS + ".length"), 0)

    def test_one_selection_everywhere(self):
        tree = self.run_js("document.querySelector('.plan g.tree').dataset.tree")
        self.browser.click_on(f".plan g.tree[data-tree='{tree}'] .halo")
        selected = self.run_js(SELECTED)
        for view in ("g", "tr", "figure"):
            self.assertIn(f"{view}:{tree}", selected)
        self.assertIn(f"Tree {tree}", self.run_js("document.querySelector('#tree').textContent"))
        self.assertTrue(self.run_js("!!document.querySelector('#tree svg')"))
        other = self.run_js(f"document.querySelector(\"#stems tbody tr:not([data-tree='{tree}'])\").dataset.tree")
        self.browser.click_on(f"#stems tbody tr[data-tree='{other}'] td")
        self.assertEqual({s.split(":")[1] for s in self.run_js(SELECTED)}, {other})
        self.browser.click_on(".slices figure")
        third = self.run_js("document.querySelector('.slices figure').dataset.tree")
        self.assertEqual({s.split(":")[1] for s in self.run_js(SELECTED)}, {third} if third != other else set())
        self.browser.call("Input.dispatchKeyEvent", type="keyDown", key="Escape")
        self.assertEqual(self.run_js(SELECTED), [])
        self.assertTrue(self.run_js("document.querySelector('#tree').hidden"))

    def test_hover_names_the_tree(self):
        x, y, tree = self.run_js("(() => { const g = document.querySelector('.plan g.tree'); g.scrollIntoView({block: 'center'});"
                                 " const b = g.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2, g.dataset.tree]; })()")
        self.browser.move(x, y)
        self.assertIn(f"Tree {tree}:", self.run_js("document.querySelector('#tip').textContent"))
        self.assertTrue(self.run_js(f"document.querySelector(\"#stems tr[data-tree='{tree}']\").classList.contains('hover')"))

    def pixels(self):
        """How many pixels of the view are not paper, and a sum that changes with the picture."""
        return self.run_js(
            "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => { const c = document.querySelector('#view');"
            " const copy = document.createElement('canvas'); copy.width = c.width; copy.height = c.height; const x = copy.getContext('2d');"
            " x.drawImage(c, 0, 0); const d = x.getImageData(0, 0, c.width, c.height).data; let n = 0, s = 0;"
            " for (let i = 0; i < d.length; i += 4) { const v = d[i] + d[i + 1] + d[i + 2]; if (v < 760) { ++n; s = (s * 31 + v + i) % 1000003; } }"
            " done([n, s]); })))")

    def test_view_draws_turns_cuts_and_selects(self):
        if not self.run_js("!!document.createElement('canvas').getContext('webgl')"):
            self.skipTest("this browser has no WebGL")
        self.run_js("document.querySelector('#view3d').scrollIntoView()")
        count, whole = self.pixels()
        self.assertGreater(count, 5000)
        box = self.run_js("(() => { const b = document.querySelector('#view').getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()")
        x, y = box[0] + box[2] / 2, box[1] + box[3] / 2
        self.browser.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", clickCount=1)
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 120, y=y, button="left", buttons=1)
        self.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + 120, y=y, button="left", clickCount=1)
        self.assertNotEqual(self.pixels()[1], whole)
        self.assertEqual(self.run_js(SELECTED), [])  # a drag selects nothing
        turned = self.pixels()[0]
        self.run_js("const s = document.querySelector('#view-cut'); s.value = 30; s.dispatchEvent(new Event('input'))")
        self.assertLess(self.pixels()[0], turned)
        self.assertIn("m above ground", self.run_js("document.querySelector('#view-cut-text').textContent"))
        self.run_js("const p = document.querySelector('#view-points'); p.checked = false; p.dispatchEvent(new Event('input'));"
                    " document.querySelector('#view-top').click()")
        plain = self.pixels()
        self.run_js(f"document.querySelector('#stems tbody tr').click()")
        self.assertNotEqual(self.pixels()[1], plain[1])  # the selected stem has another colour
        # Clicks over the view until one meets a stem.
        self.run_js("document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}))")
        found = None
        for k in range(400):
            self.browser.click(box[0] + box[2] * (0.25 + 0.5 * (k % 20) / 19), box[1] + box[3] * (0.15 + 0.7 * (k // 20) / 19))
            found = self.run_js("document.querySelector('tr.selected')?.dataset.tree")
            if found:
                break
        self.assertTrue(found)

    def test_prints_every_tree_and_the_signature(self):
        self.run_js("document.querySelector('#quality').value = 'poor'; document.querySelector('#quality').dispatchEvent(new Event('input'))")
        pdf = self.browser.pdf()
        self.assertTrue(pdf.startswith(b"%PDF"))
        pages = len(re.findall(rb"/Type\s*/Page\b", pdf))
        self.assertGreaterEqual(pages, 4)
        self.assertLess(pages, 40)
        self.browser.call("Emulation.setEmulatedMedia", media="print")
        shown = self.run_js("[...document.querySelectorAll('#stems tbody tr')].filter(r => getComputedStyle(r).display !== 'none').length")
        self.assertEqual(shown, self.run_js("document.querySelectorAll('#stems tbody tr').length"))
        self.assertEqual(self.run_js("getComputedStyle(document.querySelector('#signature')).breakBefore"), "page")
        self.assertEqual(self.run_js("getComputedStyle(document.querySelector('.tools')).display"), "none")

    def test_without_webgl_it_says_so(self):
        with devtools.Browser(devtools.find_browser(), arguments=["--disable-3d-apis"]) as plain:
            plain.open(PAGE)
            self.assertFalse(plain.run("document.querySelector('#view-trouble').hidden"))
            self.assertTrue(plain.run("document.querySelector('#view').hidden"))
            plain.click_on("#stems tbody tr td")
            self.assertGreater(plain.run("document.querySelectorAll('.selected').length"), 0)
            self.assertEqual(plain.messages, [])

    def test_narrow_screens_do_not_scroll_sideways(self):
        self.browser.resize(420, 800)
        self.assertLessEqual(self.run_js("document.documentElement.scrollWidth"), 430)


def main():
    global PAGE
    if devtools.find_browser() is None:
        print("skipped: there is no Chromium (apt install chromium, or set BOLE_CHROMIUM)")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        if sys.argv[1] == "--page":
            PAGE = pathlib.Path(sys.argv[2])
            del sys.argv[1:3]
        else:
            PAGE = write_survey(sys.argv.pop(1), pathlib.Path(folder))
        result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() else 1)


if __name__ == "__main__":
    main()
