#!/usr/bin/env python3
"""The comparison of tables finds every kind of difference."""

import pathlib
import tempfile
import unittest

from compare_tables import SpecError, compare, parsed

TREES = "tree,x_m,y_m,dbh_cm,state\n1,0,0,20,auto\n2,5,0,30,auto\n3,0,5,,check\n"
NEAREST = "found.csv = {truth}, nearest x_m y_m within 0.5, "
KEY = "found.csv = {truth}, key tree, "


class Tables(unittest.TestCase):
    def complaints(self, found, expected, line):
        with tempfile.TemporaryDirectory() as folder:
            at = pathlib.Path(folder)
            (at / "found.csv").write_text(found)
            (at / "truth.csv").write_text(expected)
            return compare(line, at, truth=str(at / "truth.csv"))[0]

    def agrees(self, found, line, expected=TREES):
        self.assertEqual(self.complaints(found, expected, line), [])

    def differs(self, found, line, text, expected=TREES):
        complaints = self.complaints(found, expected, line)
        self.assertEqual(len(complaints), 1, complaints)
        self.assertIn(text, complaints[0])

    def test_a_table_agrees_with_itself_in_every_order(self):
        first, *rows = TREES.splitlines()
        turned = "\n".join([first, *reversed(rows)])
        for found in (TREES, turned):
            self.agrees(found, KEY + "x_m 0, y_m 0, dbh_cm 0, state 0")
            self.agrees(found, NEAREST + "dbh_cm 0, state 0")

    def test_a_number_beyond_its_tolerance(self):
        found = TREES.replace("5,0,30", "5,0,30.3")
        self.agrees(found, KEY + "dbh_cm 0.3")
        self.agrees(found, KEY + "dbh_cm 1%")
        self.differs(found, KEY + "dbh_cm 0.29", "dbh_cm is 30.3 in place of 30 at tree 2")
        self.differs(found, KEY + "dbh_cm 0.9%", "dbh_cm is 30.3")
        self.differs(found, KEY + "dbh_cm 0", "dbh_cm is 30.3")
        self.differs(found, NEAREST + "dbh_cm 0.2", "at x_m 5, y_m 0")

    def test_each_column_has_its_own_tolerance(self):
        found = TREES.replace("5,0,30", "5.1,0.1,30")
        self.agrees(found, KEY + "x_m 0.2, y_m 0.2")
        self.differs(found, KEY + "x_m 0.2, y_m 0.05", "y_m is 0.1")

    def test_an_empty_cell_is_no_number(self):
        self.differs(TREES.replace("20", ""), KEY + "dbh_cm 100", "dbh_cm is empty in place of 20")
        self.differs(TREES.replace("20", "nan"), KEY + "dbh_cm 100", "dbh_cm is nan")
        self.differs(TREES.replace("0,5,,", "0,5,12,"), KEY + "dbh_cm 100", "dbh_cm is 12 in place of nothing")
        self.agrees(TREES.replace("0,5,,", "0,5,nan,"), KEY + "dbh_cm 1")

    def test_words_are_equal_or_not(self):
        self.differs(TREES.replace("check", "auto"), KEY + "state 0", "state is auto in place of check")

    def test_rows_missing_and_extra_are_counted(self):
        less = "\n".join(TREES.splitlines()[:-1])
        self.differs(less, KEY + "dbh_cm 1", "1 rows missing (0 allowed)")
        self.agrees(less, KEY + "dbh_cm 1, missing 1")
        more = TREES + "4,9,9,40,auto\n"
        self.differs(more, NEAREST + "dbh_cm 1", "1 rows extra (0 allowed)")
        self.agrees(more, NEAREST + "dbh_cm 1, extra 1")

    def test_nearest_takes_each_row_once_and_only_within_reach(self):
        twice = TREES + "4,0.1,0.1,20,auto\n"  # a second stem at the place of the first
        self.differs(twice, NEAREST + "dbh_cm 1", "1 rows extra")
        far = TREES.replace("1,0,0", "1,0.6,0")
        complaints = self.complaints(far, TREES, NEAREST + "dbh_cm 1")
        self.assertEqual(len(complaints), 2)  # one missing, one extra

    def test_rows_that_need_not_be_found(self):
        wanted = KEY + "where state=auto, dbh_cm 1"
        less = "\n".join(TREES.splitlines()[:-1])
        self.agrees(less, wanted)
        self.agrees(TREES.replace("0,5,,", "0,5,77,"), wanted)  # may be found, and is not compared
        self.differs(less.replace("5,0,30", "5,0,32"), wanted, "dbh_cm is 32")
        self.differs(TREES.replace("2,5", "7,5"), KEY + "where state=auto, dbh_cm 1, extra 1", "1 rows missing")
        with self.assertRaisesRegex(SpecError, "no such rows"):
            self.complaints(TREES, TREES, KEY + "where state=dead, dbh_cm 1")

    def test_nothing_compared_is_no_agreement(self):
        nothing = TREES.splitlines()[0] + "\n"
        self.differs(nothing, KEY + "dbh_cm 1, missing 3", "no row has a partner")
        with self.assertRaisesRegex(SpecError, "no such rows"):
            self.complaints(TREES, nothing, KEY + "dbh_cm 1, extra 3")

    def test_a_column_may_have_another_name(self):
        expected = TREES.replace("dbh_cm", "diameter")
        self.agrees(TREES, KEY + "dbh_cm=diameter 0", expected)
        self.differs(TREES, KEY + "dbh_cm=diameter 0", "dbh_cm is 20", expected.replace("20", "21"))

    def test_a_key_may_have_another_name_and_be_empty(self):
        found = TREES.replace("tree,", "ref,") + ",9,9,40,false\n,8,8,41,false\n"
        line = "found.csv = {truth}, key ref=tree, dbh_cm 0, "
        self.differs(found, line + "missing 0", "2 rows extra")
        self.agrees(found, line + "extra 2")
        self.differs(found.replace("5,0,30", "5,0,31"), line + "extra 2", "dbh_cm is 31 in place of 30 at tree 2")

    def test_what_is_not_there_is_an_error(self):
        for line, text in ((KEY + "height_m 1", "found.csv has no column height_m"), (KEY, "cannot read ''"),
                           ("found.csv = {truth}, dbh_cm 1", "which rows belong together"),
                           ("found.csv = {truth}, key tree", "compares no column"),
                           ("found.csv {truth}", "does not begin with"), (KEY + "dbh_cm -1", "cannot read"),
                           ("other.csv = {truth}, key tree, dbh_cm 1", "there is no table")):
            with self.subTest(line), self.assertRaisesRegex(SpecError, text.replace("'", ".")):
                self.complaints(TREES, TREES, line)
        with self.assertRaisesRegex(SpecError, "two rows have the key"):
            self.complaints(TREES.replace("2,5", "1,5"), TREES, KEY + "dbh_cm 1")

    def test_a_line_is_read(self):
        comparison = parsed("stems.csv = a/b.csv, nearest x_m y_m within 0.5, dbh_cm=d 5%, missing 2")
        self.assertEqual((comparison.pair, comparison.within, comparison.missing, comparison.extra),
                         ([("x_m", "x_m"), ("y_m", "y_m")], 0.5, 2, 0))
        self.assertEqual((comparison.columns[0].expected, comparison.columns[0].tolerance), ("d", 0.05))


if __name__ == "__main__":
    unittest.main()
