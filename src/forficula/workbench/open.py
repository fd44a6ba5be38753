"""Open a workbench: serve it, say where, and show it in a browser."""

from __future__ import annotations

import threading
import webbrowser
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from forficula.workbench.asked import opened_with
from forficula.workbench.server import serve


def open_workbench(
    design: str, settings: Mapping[str, str], unit: float | None, port: int | None, *, browser: bool
) -> None:
    """Serve a workbench until it is interrupted.

    Args:
        design: a named design, or the path of a file.
        settings: text by dotted key, with which its page begins.
        unit: length of the unit of a FOLD file or a drawing that names none, m.
        port: where it listens; any that is free if not given.
        browser: whether to show it there.

    Raises:
        InputError: the design cannot be read, or the port cannot be had.
        KeyboardInterrupt: ctrl-C.
    """
    told = False

    def announce(address: str) -> None:
        nonlocal told
        if told:
            text = f"that address has been used; for another browser open {address}"
        else:
            text = f"open at {address}\nthe address works once, then the next one is shown here\nctrl-C ends it"
        told = True
        # its terminal may be gone by then
        with suppress(OSError, ValueError):
            print(text, flush=True)

    def browse(file: Path) -> None:
        # some browsers are waited for
        threading.Thread(target=webbrowser.open, args=(file.as_uri(),), daemon=True).start()

    # what cannot be read is reported here, not on a page
    serve(opened_with(design, settings, unit), port, announce, browse if browser else None)
