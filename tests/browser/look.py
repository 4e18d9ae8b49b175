#!/usr/bin/env python3
"""look.py PAGE.html OUT.png [--width 1280] [--full] [--at '#section'] [--pdf OUT.pdf] [--script JS]: a page as a reader sees it."""

import argparse
import pathlib

import devtools


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--width", type=int, default=1280)
    parser.add_argument("--height", type=int, default=900)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--at")
    parser.add_argument("--script")
    parser.add_argument("--pdf", type=pathlib.Path)
    a = parser.parse_args()
    with devtools.Browser(devtools.find_browser(), a.width, a.height) as browser:
        browser.open(a.page)
        if a.script:
            browser.run(a.script)
        if a.at:
            browser.run(f"document.querySelector('{a.at}').scrollIntoView()")
        browser.run("new Promise(done => requestAnimationFrame(() => setTimeout(done, 500)))")
        browser.picture(a.out, a.full)
        if a.pdf:
            a.pdf.write_bytes(browser.pdf())
        for message in browser.messages:
            print("page:", message)


if __name__ == "__main__":
    main()
