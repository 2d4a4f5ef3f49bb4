#!/usr/bin/env python3
"""Checks the HTML of the manual: every link to a page, anchor, picture, style or script exists, and nothing
that a page needs comes from a network.

check_links.py HTML STEM…

STEM: pages that other parts of the program refer to.
"""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.anchors, self.links, self.needs = set(), [], []

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.anchors.update(value for key, value in attrs if key in ("id", "name") and value)
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if tag in ("img", "script", "iframe") and given.get("src"):
            self.needs.append(given["src"])
        if tag == "link" and given.get("href") and given.get("rel") != "canonical":
            self.needs.append(given["href"])


def read(path):
    page = Page()
    page.feed(path.read_text(encoding="utf-8"))
    return page


def check(path, page, pages):
    problems = []
    for target in page.links + page.needs:
        url = urllib.parse.urlsplit(target)
        if url.scheme in ("http", "https") or url.netloc:
            if target in page.needs:
                problems.append(f"needs a network: {target}")
            continue
        if url.scheme:
            continue
        file = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
        if not file.is_file():
            problems.append(f"no such file: {target}")
        elif url.fragment and file in pages and urllib.parse.unquote(url.fragment) not in pages[file].anchors:
            problems.append(f"no such anchor: {target}")
    return [f"{path.name}: {problem}" for problem in problems]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = {path: read(path) for path in sorted(root.rglob("*.html"))}
    problems = [f"no page {stem}" for stem in sys.argv[2:] if root / f"{stem}.html" not in pages]
    for path, page in pages.items():
        problems += check(path, page, pages)
    if not (root / "searchindex.js").is_file():
        problems.append("no search index")
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"{len(pages)} pages, {len(problems)} problems")
    sys.exit(1 if problems or len(pages) < 20 else 0)


if __name__ == "__main__":
    main()
