#!/usr/bin/env python3
"""What describes the program to systems and readers agrees: versions, dates, file types, icons. Tools that are installed check it too."""

import pathlib
import re
import shutil
import struct
import subprocess
import unittest
import xml.etree.ElementTree as xml

TOP = pathlib.Path(__file__).resolve().parents[2]
PACKAGING = TOP / "resources" / "packaging"


def text(path):
    return (TOP / path).read_text(encoding="utf-8")


def desktop_entry(key):
    return re.search(rf"^{key}=(.*)$", text("resources/packaging/bole-desktop.desktop"), re.M)[1]


def listed(key):
    return [item for item in desktop_entry(key).split(";") if item]


class Descriptions(unittest.TestCase):
    def setUp(self):
        self.version = re.search(r"^project\(Bole VERSION (\S+)", text("CMakeLists.txt"), re.M)[1]
        self.metainfo = xml.parse(PACKAGING / "bole-desktop.metainfo.xml").getroot()

    def test_versions_and_dates_agree(self):
        number, day = re.search(r"^## (\d\S*) \((\S+)\)$", text("CHANGELOG.md"), re.M).groups()
        release = self.metainfo.find("releases/release")
        citation = text("CITATION.cff")
        self.assertEqual(number, self.version, "CHANGELOG.md")
        self.assertEqual((release.get("version"), release.get("date")), (number, day), "metainfo")
        self.assertEqual(re.search(r"^version: (\S+)$", citation, re.M)[1], number, "CITATION.cff")
        self.assertEqual(re.search(r'^date-released: "(\S+)"$', citation, re.M)[1], day, "CITATION.cff")

    def test_file_types_agree_and_are_known(self):
        types = listed("MimeType")
        self.assertEqual(types, [e.text for e in self.metainfo.findall("provides/mediatype")])
        own = {e.get("type") for e in xml.parse(PACKAGING / "bole.mime.xml").getroot()}
        self.assertLessEqual(own, set(types))
        self.assertEqual(set(types) - own, {"application/vnd.tcpdump.pcap"})  # which shared-mime-info has

    def test_names_refer_to_files(self):
        self.assertEqual(self.metainfo.find("launchable").text, "bole-desktop.desktop")
        self.assertEqual(self.metainfo.find("icon").text, desktop_entry("Icon"))
        self.assertEqual(self.metainfo.find("provides/binary").text, desktop_entry("Exec").split()[0])
        self.assertTrue(set(e.text for e in self.metainfo.findall("categories/category")) <= set(listed("Categories")))

    def test_icons_have_their_sizes(self):
        folder = TOP / "resources" / "icons" / "hicolor"
        self.assertTrue((folder / "scalable" / "apps" / "bole.svg").is_file())
        pictures = sorted(folder.glob("*/apps/bole.png"))
        self.assertGreaterEqual(len(pictures), 5)
        for picture in pictures:
            size = struct.unpack(">II", picture.read_bytes()[16:24])
            self.assertEqual(picture.parents[1].name, f"{size[0]}x{size[1]}")

    def test_the_tools_of_the_desktop_agree(self):
        checks = {
            "desktop-file-validate": [PACKAGING / "bole-desktop.desktop"],
            "appstreamcli": ["validate", "--no-net", PACKAGING / "bole-desktop.metainfo.xml"],
            "man": ["--warnings", "-l", PACKAGING / "bole-desktop.1"],
        }
        found = {tool: arguments for tool, arguments in checks.items() if shutil.which(tool)}
        if not found:
            self.skipTest("none of " + ", ".join(checks) + " is installed")
        for tool, arguments in found.items():
            told = subprocess.run([tool, *arguments], capture_output=True, text=True)
            self.assertEqual((told.returncode, told.stderr), (0, ""), f"{tool}: {told.stdout}{told.stderr}")


if __name__ == "__main__":
    unittest.main()
