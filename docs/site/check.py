#!/usr/bin/env python3
"""usage: check.py FOLDER

Checks that every link, anchor, picture, script and style of the pages in FOLDER leads to a file of the folder and to a
place on it. Links to other sites are not followed. Status 0: all do, 1: one does not.
"""
import html.parser
import os
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The links and the names of one page."""

    def __init__(self, file):
        super().__init__()
        self.links, self.names = [], set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        if "id" in given:
            self.names.add(given["id"])
        self.links += [given[key] for key in ("href", "src") if given.get(key)]


def wrong_links(folder):
    """Returns the number of links and a line for each that leads nowhere."""
    pages = {file: Page(file) for file in sorted(folder.rglob("*.html")) if file.name != "playground.html"}
    links, wrong = 0, []
    for file, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            links += 1
            target = pathlib.Path(os.path.normpath(file.parent / urllib.parse.unquote(parts.path))) if parts.path else file
            if target.is_dir():
                target /= "index.html"
            place = f"{file.relative_to(folder)}: {link}"
            if not target.is_file():
                wrong.append(f"{place} leads to no file of the site")
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].names:
                wrong.append(f"{place} leads to no heading")
    return links, wrong


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    count, errors = wrong_links(pathlib.Path(sys.argv[1]))
    print("\n".join([*errors, f"{count:,} links, {len(errors)} of them wrong"]))
    sys.exit(1 if errors or not count else 0)
