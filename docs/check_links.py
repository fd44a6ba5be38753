"""Read the results of Sphinx's link check: which links to other hosts are gone, and which hosts did not answer."""

from __future__ import annotations

import json
import re
import sys
from collections import defaultdict
from pathlib import Path
from urllib.parse import urlsplit

# messages of a host that did not answer, so that its links were not checked
_NO_ANSWER = re.compile(
    r"Max retries|Failed to establish|NameResolution|Name or service|timed? ?out|Tunnel connection|ProxyError"
    r"|Connection (refused|reset|aborted)|Network is unreachable|CERTIFICATE_VERIFY_FAILED",
    re.I,
)
# status of hosts that refuse programs and not people, such as publishers behind a DOI
_REFUSED = re.compile(r"\b(401|403|405|406|429|503)\b")
GONE, NOT_CHECKED = 1, 2


def sorted_links(lines: list[str]) -> tuple[int, list[str], dict[str, set[str]], dict[str, set[str]]]:
    """Return the number of existing links, sentences on those gone, and by host those refused and those unchecked."""
    exist, gone = 0, []
    refused: dict[str, set[str]] = defaultdict(set)
    unchecked: dict[str, set[str]] = defaultdict(set)
    for result in map(json.loads, lines):
        link, message = result["uri"], result.get("info", "")
        if urlsplit(link).scheme not in ("http", "https"):
            continue  # within the pages, which check_pages.py checks
        host = urlsplit(link).hostname or ""
        if result["status"] in ("working", "redirected"):
            exist += 1
        elif result["status"] in ("timeout", "rate-limited") or _NO_ANSWER.search(message):
            unchecked[host].add(link)
        elif result["status"] == "broken" and _REFUSED.search(message):
            refused[host].add(link)
        elif result["status"] == "broken":
            gone.append(f"{result['filename']}:{result['lineno']}: {link}: {message}")
    return exist, gone, refused, unchecked


def main() -> None:
    """Print the results, and exit with 1 if a link is gone, with 2 if a host did not answer."""
    path = Path(sys.argv[1])
    if not path.is_file():
        sys.exit(f"{path}: no such file: see links.log beside its folder")
    exist, gone, refused, unchecked = sorted_links(path.read_text("utf-8").splitlines())
    print(f"{exist} links exist, {len(gone)} are gone")
    print(*gone, sep="\n", end="\n" if gone else "")
    for words, hosts in (("refused this program; open in a browser", refused), ("did not answer", unchecked)):
        for host, links in sorted(hosts.items()):
            print(f"{host}: {words}: {', '.join(sorted(links))}")
    if gone:
        sys.exit(GONE)
    if unchecked:
        print(f"{sum(map(len, unchecked.values()))} links were not checked, because their hosts did not answer")
        sys.exit(NOT_CHECKED)


if __name__ == "__main__":
    main()
