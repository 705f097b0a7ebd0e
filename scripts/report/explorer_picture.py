#!/usr/bin/python3
"""A picture of the explorer for docs/guide/explorer.md: scripts/report/explorer_picture.py build/explorer/index.html FILE.png"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import browser  # noqa: E402  (nothing is written beside the sources)

DRAWN = """new Promise((done) => { const look = () => ['map', 'curve', 'errors'].some((name) => globalThis.explorer?.work?.has(name))
  ? setTimeout(look, 100) : setTimeout(done, 3000); setTimeout(look, 1000); })"""


def main():
    address, file = Path(sys.argv[1]).resolve().as_uri(), Path(sys.argv[2])
    with browser.Browser(browser.installed()) as page:
        page.show(address + "#gait=sinusoidal&T=2", 1280, 1150, "light")
        page.run(DRAWN)
        file.write_bytes(page.picture((0, 0, 1280, 1150), 0.8))


if __name__ == "__main__":
    main()
