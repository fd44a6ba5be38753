"""Check that a release can be published: `make release-check`, from a clean checkout.

Builds the source distribution and the wheel from what git holds, compares their files with those that git tracks,
installs the wheel alone with each Python and once with the lowest versions of the dependencies, and uses it there
(`exercise.py`). A failure does not end the check, so that one run names all that is missing. The packages are left in
dist/.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import tomllib
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DIST = ROOT / "dist"
PYTHONS = ("3.11", "3.12", "3.13")
# what only the repository needs
NOT_IN_SOURCE = (".ci/", ".github/", ".pre-commit-config.yaml")


class ReleaseError(Exception):
    """A property that a release needs is missing."""


def project() -> dict[str, object]:
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def run(*command: str | Path, folder: Path = ROOT) -> str:
    # nothing of the checkout or of the environment of this script reaches the clean ones
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV"))}
    words = [str(word) for word in command]
    done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise ReleaseError(f"{' '.join(words)}: status {done.returncode}\n{done.stdout}{done.stderr}".rstrip())
    return done.stdout


def tool(name: str) -> str:
    """Return the path of a program beside this Python or on the path."""
    result = shutil.which(name, path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', '')}")
    if not result:
        raise ReleaseError(f"{name} is missing: make install brings it")
    return result


def tracked(*folders: str) -> set[str]:
    return set(run("git", "ls-files", *folders).split())


def build() -> str:
    """Build both packages from a clean copy of the last commit."""
    if changed := run("git", "status", "--porcelain"):
        raise ReleaseError(f"commit these first:\n{changed.rstrip()}")
    shutil.rmtree(DIST, ignore_errors=True)
    with tempfile.TemporaryDirectory() as copy:
        run("git", "clone", "--quiet", "--local", str(ROOT), copy)
        run(tool("uv"), "build", "--quiet", "--out-dir", DIST, copy)
    (DIST / ".gitignore").unlink(missing_ok=True)
    return ", ".join(f"{path.name} {path.stat().st_size / 1e6:.1f} MB" for path in sorted(DIST.iterdir()))


def wheel() -> Path:
    return only("*.whl")


def only(pattern: str) -> Path:
    paths = list(DIST.glob(pattern))
    if len(paths) != 1:
        raise ReleaseError(f"need one {pattern} in {DIST}, got {len(paths)}")
    return paths[0]


def contents() -> str:
    """Compare the files of both packages with those that git tracks."""
    with zipfile.ZipFile(wheel()) as package:
        in_wheel = {name for name in package.namelist() if ".dist-info/" not in name}
    needed = {name.removeprefix("src/") for name in tracked("src")}
    with tarfile.open(only("*.tar.gz")) as archive:
        in_source = {name.partition("/")[2] for name in archive.getnames()} - {"PKG-INFO"}
    source = {name for name in tracked() if not name.startswith(NOT_IN_SOURCE)}
    for where, result, expected in (("wheel", in_wheel, needed), ("source distribution", in_source, source)):
        if result != expected:
            more, less = sorted(result - expected), sorted(expected - result)
            raise ReleaseError(f"the {where} has too much: {more[:10]}; lacks: {less[:10]}")
    return f"{len(in_wheel)} files in the wheel, {len(in_source)} in the source distribution, as tracked"


def description() -> str:
    """Let twine render the description that the package index will show."""
    run(tool("uv"), "tool", "run", "--quiet", "twine", "check", "--strict", *sorted(DIST.iterdir()))
    return "twine check --strict passes"


def interpreter(version: str) -> str:
    """Return the path of a Python, from the path or from pyenv."""
    homes = [Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"]
    in_pyenv = [str(path) for home in homes for path in sorted(home.glob(f"{version}*/bin/python{version}"))]
    for path in (*in_pyenv, shutil.which(f"python{version}")):
        if path and not subprocess.run([path, "-c", ""], capture_output=True, check=False).returncode:
            return path
    raise ReleaseError(f"Python {version} is missing; pyenv install {version}")


def works_with(version: str, *options: str) -> str:
    """Install the wheel alone into a new environment and use it."""
    uv = tool("uv")
    with tempfile.TemporaryDirectory() as name:
        environment, folder = Path(name) / "environment", Path(name) / "work"
        folder.mkdir()
        run(uv, "venv", "--quiet", "--python", interpreter(version), environment)
        python = environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
        run(uv, "pip", "install", "--quiet", "--python", python, *options, wheel())
        size = sum(path.stat().st_size for path in environment.rglob("*") if path.is_file() and not path.is_symlink())
        packages = len(run(uv, "pip", "list", "--quiet", "--python", python).splitlines()) - 2
        run(python, ROOT / "release" / "exercise.py", folder=folder)
        return f"works; {packages} packages, {size / 1e6:.0f} MB installed"


def one_version() -> str:
    """Compare the version with the one in CITATION.cff, and look for its dated heading in the changelog."""
    version = str(project()["version"])
    cited = re.search(r"^version: (.+)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    if not cited or cited[1].strip('"') != version:
        raise ReleaseError(f"CITATION.cff: need version {version}, got {cited and cited[1]}")
    dated = rf"^## {re.escape(version)} \(\d{{4}}-\d\d-\d\d\)$"
    if not re.search(dated, (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE):
        raise ReleaseError(f'CHANGELOG.md: need a heading "## {version} (YYYY-MM-DD)"')
    return version


def addresses() -> str:
    """Look whether the project says where it can be found."""
    urls = project().get("urls")
    if not urls:
        raise ReleaseError("pyproject.toml: [project.urls] is empty; enter where source, documentation and issues are")
    return ", ".join(map(str, urls))


def steps() -> Iterator[tuple[str, Callable[[], str]]]:
    yield "one version", one_version
    yield "build", build
    yield "contents", contents
    yield "description", description
    for version in PYTHONS:
        yield f"Python {version}", lambda version=version: works_with(version)
    yield "lowest versions", lambda: works_with(PYTHONS[0], "--resolution", "lowest-direct")
    yield "addresses", addresses


def main() -> None:
    failed = 0
    for name, step in steps():
        start, before = time.monotonic(), failed
        try:
            result = step()
        except ReleaseError as error:
            failed += 1
            result = f"FAILED: {error}"
        print(f"{name:16} {time.monotonic() - start:5.0f} s  {result}", flush=True)
        if failed > before and name == "build":
            break
    if failed:
        sys.exit(f"{failed} of these must be mended before a release")


if __name__ == "__main__":
    main()
