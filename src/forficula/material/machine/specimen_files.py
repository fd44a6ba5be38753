"""Tensile or folding tests of a material from several files."""

from __future__ import annotations

import glob
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from forficula.errors import InputError
from forficula.material.folding.folding_test import FoldingTest
from forficula.material.machine.folding_file import has_angles, read_folding_tests
from forficula.material.machine.machine_file import read_tensile_tests
from forficula.material.machine.machine_names import Test
from forficula.material.tensile.tensile_test import TensileTest
from forficula.quantities import as_written

_MOST_NAMED = 6


@dataclass(frozen=True, kw_only=True, eq=False)
class SpecimenFiles:
    """The tensile tests of some files.

    Attributes:
        files: paths as given, with patterns expanded.
        tests: tests in the order of the files, with unique names.
    """

    files: tuple[str, ...]
    tests: tuple[TensileTest, ...]

    @property
    def source(self) -> str:
        """Source of a law that is fitted to the tests, in one line."""
        return _source(self.files, "tensile")


@dataclass(frozen=True, kw_only=True, eq=False)
class FoldingFiles:
    """The folding tests of some files.

    Attributes:
        files: paths as given, with patterns expanded.
        tests: tests in the order of the files.
    """

    files: tuple[str, ...]
    tests: tuple[FoldingTest, ...]

    @property
    def source(self) -> str:
        """Source of a law that is fitted to the tests, in one line."""
        return _source(self.files, "folding")


def is_folding(patterns: Sequence[str]) -> bool:
    """Return whether the first file has a column of angles or moments, and is therefore a folding test."""
    return bool(patterns) and has_angles(_expanded(patterns[0])[0])


def read_strips(
    patterns: Sequence[str], *, width: float | None = None, thickness: float | None = None, lever: float | None = None
) -> FoldingFiles:
    """Read the folding tests of strips.

    Args:
        patterns: paths of files, or patterns such as "fold-*.csv" that the shell did not expand.
        width: length of every crease, m; needed if a file does not give it.
        thickness: thickness of every strip, m, if a file does not give it.
        lever: lever arm of every test, m; needed with a travel or a force if a file does not give it.

    Raises:
        InputError: no file, a folder, a file given twice, or a file that cannot be read; the message names it.
    """
    files = _files(patterns, "folding")
    return FoldingFiles(
        files=tuple(files), tests=read_folding_tests(files, width=width, thickness=thickness, lever=lever)
    )


def _source(files: Sequence[str], test: Test) -> str:
    count, named = len(files), [Path(file).name for file in files[:_MOST_NAMED]]
    rest = f" and {count - _MOST_NAMED} more" if count > _MOST_NAMED else ""
    return f"fitted by forficula to the {test} tests in {', '.join(named)}{rest}"


def read_specimens(patterns: Sequence[str], *, length: float | None = None, area: float | None = None) -> SpecimenFiles:
    """Read the specimens of a material.

    Args:
        patterns: paths of files, or patterns such as "tpu-*.csv" that the shell did not expand.
        length: length of every specimen, m; needed if a file does not give it.
        area: cross-section of every specimen, m2; needed if a file does not give it.

    Raises:
        InputError: no file, a folder, a file given twice, or a file that cannot be read; the message names it.
    """
    files = _files(patterns, "tensile")
    tests = [(file, test) for file in files for test in read_tensile_tests([file], length=length, area=area)]
    times = Counter(test.name for _, test in tests)
    named = [test if times[test.name] == 1 else _named_by_folder(file, test) for file, test in tests]
    return SpecimenFiles(files=tuple(files), tests=tuple(named))


def _files(patterns: Sequence[str], test: Test) -> list[str]:
    """Return the files of patterns, each once."""
    if not patterns:
        raise InputError(f"need at least one file of a {test} test, got none")
    files = [file for pattern in patterns for file in _expanded(pattern)]
    seen: dict[Path, str] = {}
    for file in files:
        if Path(file).is_dir():
            raise InputError(f"{file}: need a file of a {test} test, got a folder; name its files, as in {file}/*.csv")
        first = seen.setdefault(Path(file).resolve(), file)
        if first is not file:
            raise InputError(f"{file}: is given twice; every file counts as further specimens")
    return files


def _named_by_folder(file: str, test: TensileTest) -> TensileTest:
    folder = Path(file).parent.as_posix()
    return test if folder == "." else replace(test, name=f"{folder}/{test.name}")


def _expanded(pattern: str) -> list[str]:
    """Return the files of a pattern, sorted; the path of an existing file is not a pattern."""
    if not glob.has_magic(pattern) or Path(pattern).exists():
        return [pattern]
    files = sorted(glob.glob(pattern))  # noqa: PTH207, Path.glob rejects patterns with a drive or a root
    if not files:
        raise InputError(f"{as_written(pattern)}: no file has such a name")
    return files
