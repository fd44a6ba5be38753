"""Open a workbench: serve it, say where, and show it in a browser."""

from __future__ import annotations

import threading
import webbrowser
from collections.abc import Mapping

from forficula.workbench.asked import Opened
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
        InputError: the port cannot be had.
        KeyboardInterrupt: ctrl-C.
    """

    def ready(address: str) -> None:
        print(f"open at {address}\nctrl-C ends it", flush=True)
        if browser:
            # some browsers are waited for
            threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()

    serve(Opened(design=design, settings=settings, unit=unit), port, ready)
