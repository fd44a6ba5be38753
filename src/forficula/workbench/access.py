"""Access to a workbench: an address that works once is exchanged for a cookie."""

from __future__ import annotations

import secrets
from collections.abc import Callable
from pathlib import Path
from urllib.parse import urlsplit

# Other accounts of this machine reach its ports and see the command line of every process, a browser's included.
#
# - No secret is on a command line. A browser is started with the path of a redirect file, which only its owner can
#   read (as Jupyter does). The file and the terminal have a token each.
# - A token works once. The browser that presents it receives a cookie, and a page with a secret path. If somebody else
#   used the token first, the owner's browser is refused, and the owner sees it.
# - The path of the cookie is the secret path. Browsers send the cookies of a host to all of its ports. Without the
#   path, a browser that visits the server of another account on another port would send it the cookie. The path alone
#   does not give access, because the address bar and the history of a browser show it.

_REDIRECT = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>forficula</title><meta name="referrer" content="no-referrer">
<link rel="icon" href="data:,"><meta http-equiv="refresh" content="0; url={address}"></head>
<body><p>The workbench opens. If it does not, <a href="{address}">open it</a>.</p></body></html>
"""
_HOSTS = ("127.0.0.1", "localhost")
# values of Sec-Fetch-Site for the own page, and for an address that was typed
_SITES = ("same-origin", "none", "")


class Access:
    """Unused tokens, and the cookie for which a browser exchanges one."""

    def __init__(self, origin: str, port: int) -> None:
        self._origin = origin
        # cookies ignore ports: two workbenches on one machine must not overwrite each other's cookie
        self.cookie_name = f"forficula-{port}"
        self.cookie = secrets.token_urlsafe(32)
        self.path = f"/{secrets.token_urlsafe(16)}/"
        self._tokens: dict[str, Callable[[], None]] = {}

    def new_address(self, used: Callable[[], None] = lambda: None) -> str:
        """Return an address that lets one browser in.

        Args:
            used: is called when a browser has used the address.
        """
        token = secrets.token_urlsafe(16)
        self._tokens[token] = used
        return f"{self._origin}/open/{token}"

    def exchange(self, token: str) -> bool:
        """Use a token up, and return whether it was valid."""
        matching = [known for known in self._tokens if secrets.compare_digest(known.encode(), token.encode())]
        for known in matching:
            self._tokens.pop(known)()
        return bool(matching)

    def admits(self, cookie: str | None) -> bool:
        """Return whether a browser that sends a cookie has been let in."""
        return cookie is not None and secrets.compare_digest(cookie.encode(), self.cookie.encode())


def redirect_page(address: str) -> str:
    """Return a page that leads to an address at once.

    A redirect by HTTP status does not work: browsers attribute it to the page that led there, and withhold a cookie
    that is restricted to its own site.
    """
    return _REDIRECT.format(address=address)


def write_redirect(address: str, path: Path) -> None:
    """Write a page that leads to an address, into a file that only its owner can read."""
    # restrict access before the secret is in the file
    path.touch(mode=0o600, exist_ok=False)
    path.write_text(redirect_page(address), "utf-8")


def refused_page(reason: str) -> str:
    """Return a page that explains to a reader why a browser is not let in."""
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>forficula: not let in</title>'
        '<link rel="icon" href="data:,"></head>\n'
        f"<body><h1>This browser is not let in</h1>\n<p>{reason}</p>\n"
        "<p>The terminal in which <code>forficula open</code> runs shows an address that works once. After its use the"
        " terminal shows the next one. If this browser has the workbench open in another tab, go on there.</p>\n"
        "<p>If the terminal reports that an address was used, and you did not use it, somebody else did: end the"
        " workbench with ctrl-C.</p></body></html>\n"
    )


def refusal(port: int, host: str, origin: str, site: str) -> str:
    """Return the reason for which a request is refused; "" if it may be answered.

    A page with another host name that resolves to this machine (DNS rebinding) sends that name as the host. A page of
    another site sends its origin.

    Args:
        port: port of the workbench.
        host: header Host.
        origin: header Origin, "" without one.
        site: header Sec-Fetch-Site, "" without one.
    """
    allowed = [f"{name}:{port}" for name in _HOSTS]
    if host.lower() not in allowed:
        return f"this workbench answers requests to {' and '.join(allowed)}, not to {host[:100]}"
    if origin and not _is_own(origin, host):
        return "this workbench answers requests of its own page, not of another site"
    if site not in _SITES:
        return "this workbench answers requests of its own page, not of another site"
    return ""


def _is_own(origin: str, host: str) -> bool:
    try:
        parts = urlsplit(origin)
    except ValueError:
        # not a URL, such as "http://["
        return False
    return (parts.scheme, parts.netloc.lower()) == ("http", host.lower())
