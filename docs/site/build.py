#!/usr/bin/env python3
"""usage: build.py [--playground PAGE] FOLDER

Writes the pages of this tree as a web site: every *.md becomes a page, README.md the index of its folder, and a source
that a page links to becomes a page of its lines. The site needs no server: it opens from a file, and its search, too.
Then checks every link, anchor and picture of the site. Needs python3-markdown-it.
Status 0: written, 1: a link leads nowhere, 2: it could not be written, 77: python3-markdown-it is missing.
"""
import argparse
import html
import json
import os
import pathlib
import re
import shutil
import sys
import urllib.parse

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
try:
    from markdown_it import MarkdownIt
except ImportError:
    print("skipped: python3-markdown-it is not installed")
    sys.exit(77)
from check import wrong_links

PICTURES = {".png", ".svg", ".webp"}
SKIPPED = {"build", "out", "node_modules"}
ELSEWHERE = re.compile(r"[a-z]+:|//")
# A page may have parts that show: a title and its text, as the search lists them.
LONGEST_PART = 1500


def pages():
    """Returns the *.md of the tree, as paths from the root."""
    found = []
    for folder, folders, files in os.walk(ROOT):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name not in SKIPPED)
        found += [pathlib.Path(folder, name).relative_to(ROOT) for name in files if name.endswith(".md")]
    return sorted(found)


def place_of(path):
    """Returns where the site has a file of the tree."""
    if path.name == "README.md":
        return path.with_name("index.html")
    if path.suffix == ".md":
        return path.with_suffix(".html")
    return path if path.suffix in PICTURES else path.with_name(path.name + ".html")


def relative(target, page):
    return urllib.parse.quote(os.path.relpath(target, page.parent).replace(os.sep, "/"))


class Site:
    def __init__(self, out, playground):
        self.out = out
        self.template = (HERE / "page.html").read_text(encoding="utf-8")
        self.markdown = MarkdownIt("commonmark", {"html": False}).enable(["table", "strikethrough"])
        self.parts = []  # what the search finds: place, title of the page, title of the part, text
        self.linked = set()
        self.playground = playground

    def href(self, link, page):
        """Returns a link of a page of the tree as a link of the site."""
        if ELSEWHERE.match(link) or link.startswith("#"):
            return link
        path, _, anchor = link.partition("#")
        target = pathlib.Path(os.path.normpath(page.parent / urllib.parse.unquote(path)))
        if (ROOT / target).is_dir():
            target /= "README.md"
        if target.suffix != ".md":
            self.linked.add(target)
        return relative(place_of(target), page) + (f"#{anchor}" if anchor else "")

    def write(self, place, title, body):
        file = self.out / place
        file.parent.mkdir(parents=True, exist_ok=True)
        top = relative(pathlib.Path("."), place)
        text = self.template
        for name, value in (("title", html.escape(title)), ("top", top), ("nav", self.nav(place)), ("body", body)):
            text = text.replace(f"<!--{name}-->", value)
        file.write_text(text, encoding="utf-8")

    def nav(self, place):
        """Returns the table of docs/README.md as a list of links, with this page marked."""
        index = pathlib.Path("docs/README.md")
        playground = relative(pathlib.Path("playground.html"), place)
        lines = [f'<p><a href="{playground}">Playground</a></p>'] if self.playground else []
        for row in re.findall(r"^\| (?!you want|---)(.*?) \| (.*) \|$", (ROOT / index).read_text(encoding="utf-8"), re.M):
            links = [(text, link) for text, link in re.findall(r"\[([^]]*)\]\(([^)]*)\)", row[1])]
            if not links or row[0].startswith("`"):
                continue
            items = []
            for text, link in links:
                target, _, anchor = self.href(link, index).partition("#")
                at = pathlib.Path(os.path.normpath(pathlib.Path("docs") / target))
                here = ' aria-current="page"' if at == place and not anchor else ""
                items.append(f'<li><a href="{relative(at, place)}{"#" + anchor if anchor else ""}"{here}>'
                             f"{html.escape(text.strip('`'))}</a></li>")
            opened = " open" if any("aria-current" in item for item in items) else ""
            lines.append(f"<details{opened}><summary>{html.escape(row[0])}</summary><ul>{''.join(items)}</ul></details>")
        return "\n".join(lines)

    def page(self, path):
        place = place_of(path)
        tokens = self.markdown.parse((ROOT / path).read_text(encoding="utf-8"))
        names, title, part = {}, None, None
        for token, content in zip(tokens, tokens[1:] + [None]):
            if token.type == "heading_open":
                text = plain(content)
                token.attrSet("id", named(text, names))
                title = title or text
                part = [f"{place.as_posix()}#{token.attrGet('id')}", title, text, ""]
                self.parts.append(part)
            elif part and token.type in ("inline", "fence", "code_block") and plain(token) != part[2]:
                part[3] = f"{part[3]} {plain(token)}".strip()[:LONGEST_PART]
            for child in token.children or []:
                for name in ("href", "src"):
                    if child.attrGet(name) is not None:
                        child.attrSet(name, self.href(child.attrGet(name), path))
        body = self.markdown.renderer.render(tokens, self.markdown.options, {})
        # A wide table or figure scrolls, and the page does not.
        body = body.replace("<table>", '<div class="scroll" tabindex="0"><table>').replace("</table>", "</table></div>")
        self.write(place, title or path.stem, body)

    def source(self, path):
        """Writes a file that a page links to: a picture as it is, another one as a page of its lines."""
        place = place_of(path)
        if not (ROOT / path).is_file():
            return  # the check names the page that links to it
        if place == path:
            (self.out / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / path, self.out / place)
            return
        text = (ROOT / path).read_text(encoding="utf-8")
        self.write(place, path.as_posix(), f"<h1>{html.escape(path.as_posix())}</h1>\n"
                   f'<pre tabindex="0"><code>{html.escape(text, quote=False)}</code></pre>')


def plain(token):
    """Returns the text of a token without its marks."""
    if token.children is None:
        return " ".join(token.content.split())
    return "".join(" " if child.type in ("softbreak", "hardbreak") else child.content
                   for child in token.children if child.type != "image")


def named(text, names):
    """Returns the name that GitHub gives to a heading. A second heading of one name has a number."""
    name = re.sub(r"[^\w\- ]", "", text.lower()).strip().replace(" ", "-")
    names[name] = names.get(name, -1) + 1
    return f"{name}-{names[name]}" if names[name] else name


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n")[0].removeprefix("usage: "))
    parser.add_argument("--playground", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    given = parser.parse_args()
    site = Site(given.folder, given.playground)
    found = pages()
    for path in found:
        site.page(path)
    for path in sorted(site.linked):
        site.source(path)
    for name in ("site.css", "search.js"):
        shutil.copyfile(HERE / name, given.folder / name)
    if given.playground:
        shutil.copyfile(given.playground, given.folder / "playground.html")
    parts = json.dumps(site.parts, ensure_ascii=False, separators=(",", ":"))
    (given.folder / "parts.js").write_text(f"const parts = {parts};\n", encoding="utf-8")
    links, wrong = wrong_links(given.folder)
    print("\n".join([*wrong, f"{given.folder}: {len(found)} pages, {len(site.linked)} files that they link to, "
                     f"{links:,} links, {len(wrong)} of them wrong"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except OSError as error:
        print(f"build.py: {error}; name a folder that can be written", file=sys.stderr)
        sys.exit(2)
