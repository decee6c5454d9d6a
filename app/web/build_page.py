#!/usr/bin/env python3
"""usage: build_page.py MODULE.wasm PAGE.html

Writes the playground: page/page.html with the style, the scripts, the library and the module in it. The scripts of
page/ are ES modules. They become one script, in the order of ORDER, because a page that is opened from a file cannot
import. The policy of the page allows only this script and this style, by SHA-256. Status 1 if a file is not what it
should be.
"""
import base64
import gzip
import hashlib
import html
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
# A script comes after the scripts that it imports.
ORDER = ("wasm", "state", "parts", "number", "formula", "operation", "trace", "scenes", "cases", "main")
IMPORT = re.compile(r'^import (\{.*\}) from "(?:\./|\.\./vendor/)([\w-]+)\.m?js";$', re.M)
EXPORT = re.compile(r"^export (?=(?:async )?(?:function|const) (\w+))", re.M)


def as_object(name, body, exports):
    """Returns a module as an object of its exports, so that its other names stay private."""
    members = ", ".join(f"{key}: {value}" for key, value in exports.items())
    return f"const ${name.replace('-', '_')} = (() => {{{body}\nreturn {{{members}}};}})();\n"


def library():
    file = HERE / "vendor/lit-html.js"
    wanted = (HERE / "vendor/SHA512SUMS").read_text().split()[0]
    if hashlib.sha512(file.read_bytes()).hexdigest() != wanted:
        sys.exit(f"{file}: its digest is not that in vendor/SHA512SUMS; take the file from the npm package again")
    text = re.sub(r"\n//# sourceMappingURL=.*", "", file.read_text())
    body, exports = re.fullmatch(r"(.*)export\{([^}]*)\};?\s*", text, re.S).groups()
    return as_object("lit-html", body, dict(reversed(pair.split(" as ")) for pair in exports.split(",")))


def scripts():
    text = library()
    seen = {"lit-html"}
    for name in ORDER:
        source = (HERE / f"page/{name}.mjs").read_text()
        for _, imported in IMPORT.findall(source):
            if imported not in seen:
                sys.exit(f"page/{name}.mjs imports {imported}, which must come before it in ORDER of {__file__}")
        body = IMPORT.sub(lambda found: f"const {found[1]} = ${found[2].replace('-', '_')};", source)
        exports = {export: export for export in EXPORT.findall(body)}
        body = EXPORT.sub("", body)
        if re.search(r"^(import|export)\b", body, re.M):
            sys.exit(f"page/{name}.mjs: an import or export has another form than the others; write it on one line")
        # The last script starts the page. It is not in a function, because it waits for the module.
        text += body if name == ORDER[-1] else as_object(name, f"\n{body}", exports)
        seen.add(name)
    extra = {file.stem for file in (HERE / "page").glob("*.mjs")} - set(ORDER)
    if extra:
        sys.exit(f"page/: add {', '.join(sorted(extra))} to ORDER in {__file__}")
    return text


def compact(text):
    """Returns a script or a style without indentation, blank lines and lines that are comments: a tenth of the page."""
    lines = (line.strip() for line in text.splitlines())
    return "".join(line + "\n" for line in lines if line and not line.startswith("//") and
                   not re.fullmatch(r"/\*.*\*/", line))


def as_characters(data):
    """Returns bytes as characters of 7 bits, the highest first, which take an eighth less of UTF-8 than base64 does.

    HTML changes NUL and CR, and `<` may end a script. These three have the next higher bit, which a reader drops.
    """
    bits = "".join(f"{byte:08b}" for byte in data)
    sevens = (int(bits[at:at + 7].ljust(7, "0"), 2) for at in range(0, len(bits), 7))
    return "".join(chr(seven + 128 if seven in b"\0\r<" else seven) for seven in sevens)


def source_hash(text):
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def main():
    module, out = map(pathlib.Path, sys.argv[1:3])
    style = "\n" + compact((HERE / "page/page.css").read_text())
    script = "\n" + compact(scripts())
    packed = as_characters(gzip.compress(module.read_bytes(), 9, mtime=0))
    policy = (f"default-src 'none'; script-src {source_hash(script)} 'wasm-unsafe-eval'; "
              f"style-src {source_hash(style)}; base-uri 'none'; form-action 'none'")
    licences = [html.escape(file.read_text(), quote=False)
                for file in (HERE / "vendor/lit-html.LICENSE", HERE.parents[1] / "LICENSE")]
    page = (HERE / "page/page.html").read_text()
    for place, text in (("policy", policy), ("style", style), ("module", packed), ("script", script),
                        ("library-licence", licences[0]), ("own-licence", licences[1])):
        if page.count(f"<!--{place}-->") != 1:
            sys.exit(f"page/page.html: there must be exactly one <!--{place}-->")
        page = page.replace(f"<!--{place}-->", text)
    out.write_text(page, encoding="utf-8")
    print(f"{out}: {out.stat().st_size:,} bytes")


main()
