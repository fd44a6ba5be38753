"""Who may ask a workbench: its own page, from this machine, and nobody else."""

from __future__ import annotations

from urllib.parse import urlsplit

_HOSTS = ("127.0.0.1", "localhost")
# of a page of its own, or of an address that a reader has typed
_SITES = ("same-origin", "none", "")


def refusal(port: int, host: str, origin: str, site: str) -> str:
    """Why a request is refused; "" where it may be answered.

    A page of another name that leads to this machine (DNS rebinding) comes with that name as the host, a page of
    another place with its origin.

    Args:
        port: of the workbench.
        host: header Host.
        origin: header Origin, "" where there is none.
        site: header Sec-Fetch-Site, alike.
    """
    allowed = [f"{name}:{port}" for name in _HOSTS]
    if host.lower() not in allowed:
        return f"this workbench answers to {' and '.join(allowed)}, not to {host[:100]}"
    if origin and not _is_own(origin, host):
        return "this workbench answers to its own page, not to one of another place"
    if site not in _SITES:
        return "this workbench answers to its own page, not to one of another place"
    return ""


def _is_own(origin: str, host: str) -> bool:
    try:
        parts = urlsplit(origin)
    except ValueError:
        # no origin at all, such as "http://["
        return False
    return (parts.scheme, parts.netloc.lower()) == ("http", host.lower())
