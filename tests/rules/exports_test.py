#!/usr/bin/env python3
"""No library of ours exports how Eigen takes memory (resources/cmake/own_eigen_memory.map): exports_test.py FOLDER_OF_LIBRARIES"""
import pathlib
import subprocess
import sys
import unittest

FOLDER = pathlib.Path(sys.argv.pop())


class Exports(unittest.TestCase):
    def test_eigen_memory_stays_inside(self):
        libraries = sorted(FOLDER.glob("libbole_*.so"))
        self.assertGreater(len(libraries), 10, f"no libraries in {FOLDER}")
        for library in libraries:
            names = subprocess.run(["nm", "-D", "-C", "--defined-only", library], check=True, capture_output=True, text=True).stdout
            found = [line for line in names.splitlines() if "Eigen::internal::" in line and "aligned_" in line.split("(")[0]]
            self.assertEqual(found, [], f"{library.name}: PCL would take memory by this")


if __name__ == "__main__":
    unittest.main()
