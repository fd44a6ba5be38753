"""Runs short enough for tests of pages, and a browser."""

import os
import shutil
import time
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from forficula.analysis import measure
from forficula.design import load_design
from forficula.study import run_study
from forficula.study.files.study_file import study_of
from forficula.study.running.runs import run
from tests.show.page.goal_results import write_pages_of_goals
from tests.show.page.live_wing import HALF_SECOND, write_wing
from tests.show.page.page_kinds import write_pages

# drawn by the processor, because machines that run tests may lack a graphics chip; composed by the processor as well,
# which halves the time to open a page; one sample per pixel is a quarter of the work
FLAGS = (
    *("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing", "--no-sandbox"),
    "--webgl-antialiasing-mode=none",
    # pages of one context share a process, which compiles their script only once
    "--process-per-site",
)
# small, because the processor draws
DEFAULTS = {"reduced_motion": "reduce", "viewport": {"width": 800, "height": 600}}
RELEASE = {"drive": "none", "until": "rest", "hold": "10 ms", "time_limit": "0.1 s"}
SHORT = {
    "protocol.timestep": "0.4 ms",
    "stops.time_constant": "2 ms",
    "protocol.window": "10 ms",
    "protocol.stages.0.time_limit": "20 ms",
    "protocol.stages.1.time_limit": "0.1 s",
    "protocol.stages.2": RELEASE | {"name": "release folded"},
    # released sooner it would bounce off its stops and fold again
    "protocol.stages.3.hold": "0.1 s",
    "protocol.stages.3.time_limit": "0.2 s",
    "protocol.stages.4": RELEASE | {"name": "release opened"},
}


@pytest.fixture(scope="session")
def short_run():
    """The reference, folded and opened in half a second."""
    return run(load_design("binder2025", SHORT))


@pytest.fixture(scope="session")
def slow_run():
    """Like short_run with less torque: it folds later."""
    return run(load_design("binder2025", SHORT | {"protocol.fold_torque": "35 N cm"}))


@pytest.fixture(scope="session")
def large_record():
    """A wing of five fan units: its first milliseconds, settling."""
    stage = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "4 ms"}
    keys = {"pattern.units": 5, "pattern.sector_angle": "12 deg", "protocol.stages": [stage]}
    return run(load_design("binder2025", keys))


@pytest.fixture(scope="session")
def short_outcome(short_run):
    return measure(short_run)


@pytest.fixture(scope="session")
def searched(once, tmp_path_factory):
    """A search over six tendons at a coarse timestep (some fold, one opens again, one sticks), and its table."""
    study = study_of(
        {
            "name": "few",
            "source": "a test",
            "design": "binder2025",
            "ask": "least-torques",
            "settings": {"protocol.rest_speed": "10 deg/s", "protocol.stages.0.time_limit": "0.1 s"},
            "factors": {
                "tendon.stiffness": ["10 N/cm", "30 N/cm", "60 N/cm"],
                "tendon.rest_length": ["4 cm", "9 cm"],
            },
            "search": {
                "fold_torques": ["20 N cm", "50 N cm"],
                "fold_with": "500 N cm",
                "unfold_torques": ["50 N cm", "100 N cm"],
                "refinements": 0,
            },
        }
    )
    return study, once("searched", lambda: run_study(study, tmp_path_factory.mktemp("searched")))


def missing(what: str) -> None:
    """Skip, or fail if a browser is required."""
    reason = f"{what}: pages are not tested as a browser shows them"
    if os.environ.get("FORFICULA_NEED_BROWSER") == "1":
        pytest.fail(reason)
    pytest.skip(reason)


class Chromium:
    """Chromium from the system, started once for consecutive tests of this folder.

    While it runs, so does an event loop, therefore not beyond them.
    """

    def __init__(self):
        self._running = ExitStack()
        self._context = None

    def context(self):
        """Return a context for pages from files, without network; an open page keeps its shared process alive."""
        if self._context is None:
            self._context = self._start().new_context(offline=True, **DEFAULTS)
            blank = Path(self._running.enter_context(TemporaryDirectory())) / "blank.html"
            blank.write_text("<!doctype html><title>blank</title>", "utf-8")
            self._context.new_page().goto(blank.as_uri())
        return self._context

    def _start(self):
        try:
            from playwright.sync_api import sync_playwright
        except ImportError:
            missing("playwright is missing; install it with: pip install playwright")
        names = ("chromium", "chromium-browser", "google-chrome")
        result = os.environ.get("FORFICULA_CHROMIUM") or next(filter(None, map(shutil.which, names)), None)
        if not result:
            hint = "install it, as with: apt-get install chromium, or name it in FORFICULA_CHROMIUM"
            missing(f"Chromium is missing; {hint}")
        playwright = self._running.enter_context(sync_playwright())
        browser = playwright.chromium.launch(executable_path=result, args=FLAGS)
        self._running.callback(browser.close)
        return browser

    def end(self):
        self._context = None
        self._running.close()


CHROMIUM = Chromium()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(nextitem):
    """Close the browser if the next test is in another folder."""
    try:
        return (yield)
    finally:
        if nextitem is None or not nextitem.path.is_relative_to(Path(__file__).parent):
            CHROMIUM.end()


@pytest.fixture(scope="session")
def chromium():
    """Chromium, which is closed when tests end, even at a failure."""
    yield CHROMIUM
    CHROMIUM.end()


@pytest.fixture(scope="module")
def context(chromium):
    """A context of Chromium for pages from files, without network."""
    return chromium.context()


@pytest.fixture(scope="module")
def browser(context):
    return context.browser


def until(page, expression, seconds=20.0):
    """Wait until an expression is true; Playwright's own wait needs eval, which the pages forbid."""
    end = time.monotonic() + seconds
    while not page.evaluate(expression):
        assert time.monotonic() < end, f"never came: {expression}"
        page.wait_for_timeout(50)


class Watched:
    """A page in the browser, with the console messages and requests that it should not make.

    pixels: of the screen for one of the page, in one direction.
    """

    def __init__(self, context, path, viewport=DEFAULTS["viewport"], reduced_motion="reduce", pixels=1):
        self.page = context.new_page()
        self.evaluate = self.page.evaluate
        self.messages: list[str] = []
        self.requests: list[str] = []
        self.page.on("console", self.hear)
        self.page.on("pageerror", lambda error: self.messages.append(str(error)))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.set_viewport_size(viewport)
        self.page.emulate_media(reduced_motion=reduced_motion)
        if pixels != 1:
            screen = viewport | {"deviceScaleFactor": pixels, "mobile": False}
            context.new_cdp_session(self.page).send("Emulation.setDeviceMetricsOverride", screen)
        self.page.goto(path.as_uri())
        until(self.page, "window.forficula !== undefined || document.getElementById('data') === null")
        self.settle()
        self.time_when_opened = self.page.evaluate("window.forficula?.clock?.time")

    def show(self, width=DEFAULTS["viewport"]["width"], height=DEFAULTS["viewport"]["height"], scheme="light"):
        """Set the size of the window and the colour scheme."""
        self.page.set_viewport_size({"width": width, "height": height})
        self.page.emulate_media(color_scheme=scheme)
        self.settle()

    def hear(self, message):
        """Keep console messages, except Chromium's about its own flags."""
        if "GPU stall due to ReadPixels" not in message.text:
            self.messages.append(message.text)

    def settle(self):
        """Wait until changes are drawn, in front of other pages: pages in the background are drawn once per second."""
        self.page.bring_to_front()
        self.page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")


@contextmanager
def watching(context):
    opened = []

    def watch(path, **options):
        opened.append(Watched(context, path, **options))
        return opened[-1]

    yield watch
    for item in opened:
        item.page.close()


@pytest.fixture
def watch(context):
    """Open pages from files without network; without motion unless it is requested."""
    with watching(context) as watch:
        yield watch


@pytest.fixture(scope="module")
def watch_all(context):
    """As `watch`, for a page that all tests of a module share."""
    with watching(context) as watch:
        yield watch


@pytest.fixture(scope="session")
def recorded(tmp_path_factory):
    """A run of half a second, its outcome, and its page, in which it can be moved."""
    path = tmp_path_factory.mktemp("recorded") / "report.html"
    return *write_wing(path, HALF_SECOND), path


@pytest.fixture(scope="session")
def goals(once, tmp_path_factory):
    """Results of an optimisation, a tolerance analysis and an identification with their pages, by kind."""
    return once("goals", lambda: write_pages_of_goals(tmp_path_factory.mktemp("goals")))


@pytest.fixture(scope="session")
def pages(once, short_run, slow_run, surveyed, elastic_material, write_study_file, goals, tmp_path_factory):
    """A page of every kind, by its kind."""

    def write():
        folder = tmp_path_factory.mktemp("pages")
        return write_pages(folder, short_run, slow_run, surveyed("reference"), elastic_material, write_study_file)

    return once("pages", write) | {kind: path for kind, (_, path) in goals.items()}
