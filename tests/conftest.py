"""What several test modules need: the reference run, and one tendon across one hinge."""

import gc
import io
import math
import os
import pickle
import tempfile
from collections.abc import Callable, Mapping
from contextlib import redirect_stderr
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TypeVar

import numpy as np
import pytest
from hypothesis import settings

import forficula as ff
from forficula.design import Design, with_values
from forficula.dynamics import Model, Record, simulate
from forficula.lock import hold_lock
from forficula.statics import EnergyLandscape, energy_landscape
from forficula.structure.fans.veins import structure_of_veins
from tests.landscapes import design_of
from tests.structures import compiled, straight_vein

T = TypeVar("T")

# thousands of tests and what they import stay to the end: garbage is not looked for among them
gc.disable()


def pytest_collection_finish():
    """Look for garbage rarely: with Python's usual threshold this takes 2 % of the time of all tests."""
    gc.freeze()
    gc.set_threshold(50_000)
    gc.enable()


def pytest_xdist_auto_num_workers():
    """One worker more than cores, because tests wait for browsers and other processes while a core is idle."""
    return (os.cpu_count() or 1) + 1


# No deadline: how long an example takes depends more on the machine than on the code. A run of all tests tries 30 new
# examples of every property. FORFICULA_THOROUGH tries 300, before a release. In CI the examples are always the same.
settings.register_profile("usual", deadline=None, max_examples=30)
settings.register_profile("thorough", deadline=None, max_examples=300)
settings.register_profile("repeatable", deadline=None, derandomize=True, max_examples=30)
settings.load_profile(
    "repeatable"
    if os.environ.get("FORFICULA_REPEATABLE")
    else "thorough"
    if os.environ.get("FORFICULA_THOROUGH")
    else "usual"
)


@pytest.fixture(scope="session")
def once(tmp_path_factory):
    """Compute a result once in a session, in the worker that needs it first; every worker gets a copy.

    Results are pickled. Tests whose claim is that a result is reproducible compute the result themselves.
    """
    worker_folder = tmp_path_factory.getbasetemp()
    # each worker has a folder in that of the session; without workers the folder above is that of all sessions
    folder = worker_folder.parent if "PYTEST_XDIST_WORKER" in os.environ else worker_folder

    def shared(name: str, compute: Callable[[], T]) -> T:
        path = folder / f"once-{name}.pickle"
        # who waits for a lock says so, which tests of commands would read
        with redirect_stderr(io.StringIO()), hold_lock(path.with_suffix(".lock")):
            if path.exists():
                return pickle.loads(path.read_bytes())
            computed = compute()
            with tempfile.NamedTemporaryFile(dir=folder, delete=False) as unfinished:
                unfinished.write(pickle.dumps(computed))
            Path(unfinished.name).replace(path)
            return computed

    known: dict[str, object] = {}

    def once(name: str, compute: Callable[[], T]) -> T:
        if name not in known:
            known[name] = shared(name, compute)
        return known[name]

    return once


@pytest.fixture(scope="session")
def landscape_of(once):
    """Return the landscape of a design, computed once in a session."""

    def landscape_of(design: Design, points: int = 61) -> EnergyLandscape:
        return once(f"landscape-{design.name}-{design.hash}-{points}", lambda: energy_landscape(design, points))

    return landscape_of


@pytest.fixture(scope="session")
def surveyed(landscape_of, tmp_path_factory):
    """Return the landscape of a design by its name in tests/landscapes.py, computed once in a session."""

    @cache
    def surveyed(name: str) -> EnergyLandscape:
        return landscape_of(design_of(name, tmp_path_factory.mktemp("designs")))

    return surveyed


@pytest.fixture(scope="session")
def reference() -> Design:
    """The reference design."""
    return ff.load_design("binder2025")


@pytest.fixture(scope="session")
def reference_run(reference) -> Record:
    """The reference design, run; do not change it."""
    return ff.run(reference, confirm=False).record


@pytest.fixture(scope="session")
def reference_outcome(reference_run) -> ff.Outcome:
    return ff.measure(reference_run)


@pytest.fixture(scope="session")
def stored_run() -> Record:
    """The wing that lies folded for a month and is left open for one, averaged over half as long as it has it."""
    return ff.run(ff.load_design("binder2025-stored", {"protocol.window": "50 ms"}), confirm=False).record


@dataclass(frozen=True, kw_only=True)
class OneHinge:
    """A bar on a fixed bar, a hinge square to both, a tendon across it, no damping; angles are > 0 when folding."""

    wing: Model
    inertia: float  # kg m2, about the hinge
    start: float  # rad

    @property
    def time_scale(self) -> float:
        tendon = self.wing.design.tendon
        return math.sqrt(self.inertia / (tendon.stiffness * tendon.proximal_attachment * tendon.distal_attachment))

    def length(self, angle):
        """Of the tendon, m: law of cosines, as a sum that keeps its digits where the ends meet."""
        a, b = self.wing.design.tendon.proximal_attachment, self.wing.design.tendon.distal_attachment
        return np.sqrt((a - b) ** 2 + 4 * a * b * np.cos(angle / 2) ** 2)

    def energy(self, angle):
        """Of the tendon, J."""
        tendon = self.wing.design.tendon
        return tendon.stiffness / 2 * np.maximum(self.length(angle) - tendon.rest_length, 0) ** 2

    def moment(self, angle):
        """That the tendon has about the hinge, N m, towards folding where > 0."""
        tendon = self.wing.design.tendon
        length = self.length(angle)
        # where the ends meet, the tendon is slack or its force vanishes with its length
        by_length = tendon.stiffness * np.maximum(length - tendon.rest_length, 0) / np.maximum(length, 1e-300)
        return by_length * tendon.proximal_attachment * tendon.distal_attachment * np.sin(angle)

    def run(self):
        """Angle at every step, rad, and the record."""
        record = simulate([self.wing])[0]
        return -record.angles("ring")[:, 0], record


@pytest.fixture(scope="session")
def one_hinge(reference):
    """Build a `OneHinge` that is let go at `start` and swings for `duration`."""

    def build(
        rest_length: float = 0.0,
        proximal: float = 0.055,
        distal: float = 0.055,
        *,
        timestep: float = 1e-5,
        duration: float = 0.1,
        start: float = math.radians(1),
        values: Mapping[str, object] | None = None,
    ) -> OneHinge:
        swing = {"name": "swing", "drive": "none", "until": "time", "hold": 0.0, "time_limit": duration}
        design = with_values(
            reference,
            {
                "hinge.damping": 0.0,
                # one bar has no neighbour
                "guard.stretch": 1e3,
                "tendon.damping": 0.0,
                "tendon.rest_length": rest_length,
                "tendon.proximal_attachment": proximal,
                "tendon.distal_attachment": distal,
                "protocol.timestep": timestep,
                "protocol.sample_interval": timestep,
                "protocol.initial_overbend": -start,
                "protocol.stages": [swing],
            },
        )
        design = with_values(design, values or {})
        wing = compiled(design, lambda changed, _: structure_of_veins(changed, (straight_vein(changed),)))
        vein, length = design.vein, design.pattern.distal_length
        radius = vein.diameter / 2
        mass = vein.density * math.pi * radius**2 * length
        # a solid cylinder about a diameter of its end
        inertia = mass * (radius**2 / 4 + length**2 / 3) + design.hinge.armature
        return OneHinge(wing=wing, inertia=inertia, start=start)

    return build


# a coarse protocol that takes 0.5 s at most, and in which some tendons fold, some stick and some open again
SHORT_PROTOCOL = """
protocol.timestep = "0.4 ms"
stops.time_constant = "2 ms"
protocol.least_hold = 0.0
protocol.residual_limit = 0.02
protocol.window = "10 ms"
protocol.stages.0.time_limit = "20 ms"
protocol.stages.1.time_limit = "0.1 s"
protocol.stages.2 = {name = "release folded", drive = "none", until = "rest", hold = "10 ms", time_limit = "0.1 s"}
protocol.stages.3.hold = "10 ms"
protocol.stages.3.time_limit = "0.1 s"
protocol.stages.4 = {name = "release opened", drive = "none", until = "rest", hold = "10 ms", time_limit = "0.1 s"}
"""


@pytest.fixture(scope="session")
def write_study_file():
    """Write a study of short runs of the reference design at a path."""

    def write(path, factors: str, head: str = "", tail: str = ""):
        # a key that varies is not set, too
        short = "\n".join(line for line in SHORT_PROTOCOL.splitlines() if line.partition(" ")[0] not in factors)
        text = f'design = "binder2025"\n{head}\n[settings]\n{short}\n[factors]\n{factors}\n{tail}\n'
        path.write_text(text, "utf-8")
        return path

    return write


@pytest.fixture
def study_file(tmp_path, write_study_file):
    """Write a study of short runs of the reference design."""

    def write(factors: str, head: str = "", tail: str = "", name: str = "small.toml"):
        return write_study_file(tmp_path / name, factors, head, tail)

    return write


@pytest.fixture(scope="session")
def letter_run() -> Record:
    """The quickest named design, which closes and opens again."""
    return ff.run(ff.load_design("letter-fold"), confirm=False).record


@pytest.fixture(scope="session")
def kresling_run(once) -> Record:
    """A run of facets that bend, computed once in a session."""
    return once("kresling-run", lambda: ff.run("kresling-cell", confirm=False).record)


@pytest.fixture(scope="session")
def snap_run(once) -> Record:
    """A run of plates in a loop that snaps, computed once in a session."""
    return once("snap-run", lambda: ff.run("four-plate-snap", confirm=False).record)


@pytest.fixture
def no_column_figures(monkeypatch):
    """Leave figures as wide as a column empty, which take most of the time that a folder of results takes."""
    from forficula.files import write_bytes
    from forficula.show.style import COPIES, save_figure

    def save_page(figure, path):
        save_figure(figure, path) if path.parent.name != COPIES else write_bytes(path, b"")

    monkeypatch.setattr("forficula.show.style.save_figure", save_page)


def leave_figures_empty(monkeypatch, tell):
    """Leave the files of figures in folders of results empty, with the text that a function returns for a drawing."""
    from forficula.files import write_bytes
    from forficula.show.page.data.shown_path import Fold
    from forficula.show.style import COPY_ENDINGS, figure_files

    def save_nothing(drawings, folder, copies=COPY_ENDINGS):
        texts = {stem: tell(draw) for stem, draw in drawings.items()}
        for path in (folder / name for stem in texts for name in figure_files(stem)):
            if path.suffix in (".png", *copies):
                write_bytes(path, b"")
        return texts

    kinds = ("convergence", "cycling", "identify", "landscape", "material", "optimum", "run", "static_map", "study")
    for kind in (*kinds, "assumptions", "crease", "parts", "tolerance"):
        monkeypatch.setattr(f"forficula.show.folder.{kind}_folder.save_figures", save_nothing)
    # the fold path of a page takes as long as a figure
    for kind in ("run", "landscape"):
        monkeypatch.setattr(
            f"forficula.show.page.{kind}_page.fold_of", lambda _: Fold(path=None, missing="Not computed.")
        )


@pytest.fixture
def no_figures(monkeypatch):
    """Compose the figures of folders of results once, and leave their files empty: where the claim is about words."""
    from forficula.show.style import PAGE_WIDTH, description

    leave_figures_empty(monkeypatch, lambda draw: description(draw(PAGE_WIDTH)))


@pytest.fixture
def undrawn(monkeypatch):
    """Do not even compose them: where the claim is about neither figures nor what is in them."""
    leave_figures_empty(monkeypatch, lambda _: "A figure.")
