"""Look at built pages: whatever they load or link to within must be there, and nothing is loaded from elsewhere."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

_LOADS = {
    ("script", "src"),
    ("img", "src"),
    ("img", "srcset"),
    ("iframe", "src"),
    ("source", "src"),
    ("video", "src"),
    ("link", "href"),
}
# a relation that names a page and loads nothing
_NAMES = {"canonical", "next", "prev", "search", "index", "genindex"}
_IN_CSS = re.compile(r"url\(\s*['\"]?([^'\")]+)|@import\s+['\"]([^'\"]+)")


class Page(HTMLParser):
    """What a page loads, what it links to, and the places in it."""

    def __init__(self) -> None:
        """Begin with nothing."""
        super().__init__()
        self.loads: list[str] = []
        self.links: list[str] = []
        self.places: set[str] = set()
        self._in_style = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.places |= {given[name] for name in ("id", "name") if name in given}
        self._in_style = tag == "style"
        for name, value in given.items():
            if (tag, name) in _LOADS and not (tag == "link" and given.get("rel") in _NAMES):
                self.loads += [each.split()[0] for each in value.split(", ")] if name == "srcset" else [value]
            elif tag == "a" and name == "href":
                self.links.append(value)
            elif name == "style":
                self.loads += in_css(value)

    def handle_data(self, data: str) -> None:
        if self._in_style:
            self.loads += in_css(data)


def in_css(text: str) -> list[str]:
    """What a style sheet loads."""
    return [first or second for first, second in _IN_CSS.findall(text)]


def faults(folder: Path) -> Iterator[str]:
    """What is wrong with the pages of a folder, a sentence each."""
    pages = {path: read(path) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for target in page.loads:
            if outside(target):
                yield f"{path.relative_to(folder)}: loads {target} from elsewhere"
        for target in {*page.loads, *page.links}:
            if not outside(target) and (why := missing(folder, path, target, pages)):
                yield f"{path.relative_to(folder)}: {target}: {why}"
    for path in sorted(folder.rglob("*.css")):
        for target in in_css(path.read_text("utf-8")):
            if outside(target):
                yield f"{path.relative_to(folder)}: loads {target} from elsewhere"


def read(path: Path) -> Page:
    """Parse a page."""
    page = Page()
    page.feed(path.read_text("utf-8"))
    return page


def outside(target: str) -> bool:
    """Whether a target is on another machine; what a page holds itself is not."""
    return target.startswith("//") or urlsplit(target).scheme in ("http", "https", "ftp")


def missing(folder: Path, path: Path, target: str, pages: dict[Path, Page]) -> str:
    """Why a target within the pages leads nowhere; empty where it does not."""
    split = urlsplit(target)
    if split.scheme or not target:
        return ""
    there = (path.parent / unquote(split.path)).resolve() if split.path else path
    if there.is_dir():
        there /= "index.html"
    if not there.exists() or folder.resolve() not in there.resolve().parents:
        return "is not there"
    place, found = unquote(split.fragment), pages.get(there)
    if place and found is not None and place not in found.places:
        return f"has no place {place}"
    return ""


def main() -> None:
    """Look at the pages of the folder that is named, and end with 1 where something is wrong."""
    folder = Path(sys.argv[1]).resolve()
    found = list(faults(folder))
    print(*found, sep="\n", end="\n" if found else "")
    if not (folder / "index.html").exists():
        sys.exit(f"{folder}: no pages")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
