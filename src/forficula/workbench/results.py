"""Results of a design that take a while: its landscape and its run, each written as a folder with a page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from forficula.analysis import measure
from forficula.reproduction import shown_tendon
from forficula.show.folder.landscape_folder import write_landscape
from forficula.show.folder.run_folder import write_run
from forficula.statics import energy_landscape
from forficula.study.runs import run
from forficula.workbench.asked import Asked, Opened, asked_design

# is told what is being done
Tell = Callable[[str], None]


def leave_landscape(asked: Asked, opened: Opened, folder: Path, tell: Tell) -> None:
    """Survey a design's energy by statics, as `forficula landscape --no-simulation` does, and write what it leaves.

    Raises:
        InputError: the design cannot be read or built.
    """
    design = asked_design(asked, opened)
    tell("building the structure")
    landscape = energy_landscape(design, progress=lambda step: tell(f"surveying: {step}"))
    tell("drawing")
    write_landscape(landscape, folder, None, shown_tendon(design))


def leave_run(asked: Asked, opened: Opened, folder: Path, tell: Tell) -> None:
    """Take a design through its protocol, as `forficula run` does, and write what that leaves.

    Raises:
        InputError: the design cannot be read or built.
    """
    design = asked_design(asked, opened)
    tell("building the structure")
    record = run(
        design,
        lambda stage, time, longest: tell(f"{stage}: {time:.3g} s of at most {longest:.3g} s simulated"),
        confirm=True,
    )
    tell("drawing")
    write_run(record, measure(record), folder, engine=False)
