"""Check built pages: all that they load or link to within the pages exists, and they load nothing from other hosts."""

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
# relations that name a page and load nothing
_NAMES = {"canonical", "next", "prev", "search", "index", "genindex"}
_IN_CSS = re.compile(r"url\(\s*['\"]?([^'\")]+)|@import\s+['\"]([^'\"]+)")


class Page(HTMLParser):
    """Page of HTML: what it loads, what it links to, and its anchors."""

    def __init__(self) -> None:
        """Create a page without content."""
        super().__init__()
        self.loads: list[str] = []
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self._in_style = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        attributes = {name: value or "" for name, value in attrs}
        self.anchors |= {attributes[name] for name in ("id", "name") if name in attributes}
        self._in_style = tag == "style"
        for name, value in attributes.items():
            if (tag, name) in _LOADS and not (tag == "link" and attributes.get("rel") in _NAMES):
                self.loads += [source.split()[0] for source in value.split(", ")] if name == "srcset" else [value]
            elif tag == "a" and name == "href":
                self.links.append(value)
            elif name == "style":
                self.loads += in_css(value)

    def handle_data(self, data: str) -> None:
        if self._in_style:
            self.loads += in_css(data)


def in_css(text: str) -> list[str]:
    """Return the addresses that a style sheet loads."""
    return [first or second for first, second in _IN_CSS.findall(text)]


def faults(folder: Path) -> Iterator[str]:
    """Yield a sentence for each fault of the pages of a folder."""
    pages = {path: read(path) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for target in page.loads:
            if outside(target):
                yield f"{path.relative_to(folder)}: loads {target} from another host"
        for target in {*page.loads, *page.links}:
            if not outside(target) and (why := missing(folder, path, target, pages)):
                yield f"{path.relative_to(folder)}: {target}: {why}"
    for path in sorted(folder.rglob("*.css")):
        for target in in_css(path.read_text("utf-8")):
            if outside(target):
                yield f"{path.relative_to(folder)}: loads {target} from another host"


def read(path: Path) -> Page:
    """Parse a page."""
    page = Page()
    page.feed(path.read_text("utf-8"))
    return page


def outside(target: str) -> bool:
    """Return whether a target is on another host; data in the page itself are not."""
    return target.startswith("//") or urlsplit(target).scheme in ("http", "https", "ftp")


def missing(folder: Path, path: Path, target: str, pages: dict[Path, Page]) -> str:
    """Return why a target within the pages does not exist; empty if it exists."""
    split = urlsplit(target)
    if split.scheme or not target:
        return ""
    file = (path.parent / unquote(split.path)).resolve() if split.path else path
    if file.is_dir():
        file /= "index.html"
    if not file.exists() or folder.resolve() not in file.resolve().parents:
        return "does not exist"
    anchor, page = unquote(split.fragment), pages.get(file)
    if anchor and page is not None and anchor not in page.anchors:
        return f"has no anchor {anchor}"
    return ""


def main() -> None:
    """Check the pages of a folder, print their faults, and exit with 1 if there are any."""
    folder = Path(sys.argv[1]).resolve()
    sentences = list(faults(folder))
    print(*sentences, sep="\n", end="\n" if sentences else "")
    if not (folder / "index.html").exists():
        sys.exit(f"{folder}: no pages")
    sys.exit(1 if sentences else 0)


if __name__ == "__main__":
    main()
