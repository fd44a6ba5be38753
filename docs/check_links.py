"""Read what Sphinx found of outside links: which are gone, and which hosts could not be asked at all."""

from __future__ import annotations

import json
import re
import sys
from collections import defaultdict
from pathlib import Path
from urllib.parse import urlsplit

# what is said where no host answered: a link that was not looked at is neither there nor gone
_NO_ANSWER = re.compile(
    r"Max retries|Failed to establish|NameResolution|Name or service|timed? ?out|Tunnel connection|ProxyError"
    r"|Connection (refused|reset|aborted)|Network is unreachable|CERTIFICATE_VERIFY_FAILED",
    re.I,
)
# refuses programs, not people: publishers behind a doi
_REFUSED = re.compile(r"\b(401|403|405|406|429|503)\b")
GONE, NOT_ASKED = 1, 2


def sorted_links(lines: list[str]) -> tuple[int, list[str], dict[str, set[str]], dict[str, set[str]]]:
    """How many links are there, sentences on those that are gone, and by host those refused and those not asked."""
    there, gone = 0, []
    refused: dict[str, set[str]] = defaultdict(set)
    unasked: dict[str, set[str]] = defaultdict(set)
    for found in map(json.loads, lines):
        link, told = found["uri"], found.get("info", "")
        if urlsplit(link).scheme not in ("http", "https"):
            continue  # within the pages, which check_pages.py looks at when they are built
        host = urlsplit(link).hostname or ""
        if found["status"] in ("working", "redirected"):
            there += 1
        elif found["status"] in ("timeout", "rate-limited") or _NO_ANSWER.search(told):
            unasked[host].add(link)
        elif found["status"] == "broken" and _REFUSED.search(told):
            refused[host].add(link)
        elif found["status"] == "broken":
            gone.append(f"{found['filename']}:{found['lineno']}: {link}: {told}")
    return there, gone, refused, unasked


def main() -> None:
    """Say what was found; end with 1 where a link is gone, with 2 where a host could not be asked."""
    path = Path(sys.argv[1])
    if not path.is_file():
        sys.exit(f"{path}: no such file: see links.log beside its folder")
    there, gone, refused, unasked = sorted_links(path.read_text("utf-8").splitlines())
    print(f"{there} links are there, {len(gone)} are gone")
    print(*gone, sep="\n", end="\n" if gone else "")
    for words, hosts in (("refused a program; open it yourself", refused), ("could not be asked", unasked)):
        for host, links in sorted(hosts.items()):
            print(f"{host}: {words}: {', '.join(sorted(links))}")
    if gone:
        sys.exit(GONE)
    if unasked:
        print(
            f"{sum(map(len, unasked.values()))} links were not looked at, for their hosts could not be asked from here"
        )
        sys.exit(NOT_ASKED)


if __name__ == "__main__":
    main()
