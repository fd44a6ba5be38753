"""Count lines, modules, imports, importers and repeated class names of a checkout of the repository.

`python benchmarks/size.py` counts this checkout, `python benchmarks/size.py FOLDER` another one, such as a worktree
of an earlier commit. It needs nothing but Python. `--short` leaves out the lists, `--json FILE` writes all counts.

A line of code is one that is neither blank, nor a comment, nor part of a docstring. The import share is the share of
lines of code that belong to import statements. An importer of a module is another module of the package that imports
the module or one of its names, directly or from a package that re-exports the name. The package that re-exports a
name is no importer.
"""

from __future__ import annotations

import argparse
import ast
import io
import json
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

AREAS = ("src", "tests", "docs", "benchmarks", "web")
TEXTS = {".py", ".pyi", ".js", ".mjs", ".css", ".md", ".toml"}
GENERATED = {"built", "_build", "gallery", "node_modules", "__pycache__"}
SHORT = 100  # lines
MANY = 20  # modules in a folder
PACKAGE = "forficula"
NO_CODE = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}


def counts(root: Path) -> dict[str, Any]:
    """Return all counts of a checkout, as data for JSON."""
    source = root / "src"
    modules = {_dotted(source, path): path for path in _files(source / PACKAGE) if path.suffix == ".py"}
    trees = {name: ast.parse(path.read_text(encoding="utf-8")) for name, path in modules.items()}
    code = {name: _code_lines(path, trees[name]) for name, path in modules.items()}
    imports = {name: code[name] & _import_lines(tree) for name, tree in trees.items()}
    code_total, import_total = (sum(map(len, lines.values())) for lines in (code, imports))
    length = {name: _lines(path) for name, path in modules.items()}
    importers = _importers(source, modules, trees)
    single = {name: sorted(by)[0] for name, by in importers.items() if len(by) == 1 and length[name] < SHORT}
    folders = defaultdict[str, int](int)
    for path in modules.values():
        folders[path.parent.relative_to(source).as_posix()] += path.name != "__init__.py"
    classes = defaultdict[str, list[str]](list)
    for name, tree in trees.items():
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                classes[node.name].append(f"{modules[name].relative_to(root).as_posix()}:{node.lineno}")
    return {
        "areas": {area: _area(root / area) for area in AREAS},
        "modules": len(modules),
        "lines_of_code": code_total,
        "import_lines": import_total,
        "import_share": import_total / code_total,
        "short_modules_with_one_importer": dict(sorted(single.items())),
        "classes_defined_twice": {name: at for name, at in sorted(classes.items()) if len(at) > 1},
        "folders_with_many_modules": {folder: count for folder, count in sorted(folders.items()) if count > MANY},
    }


def _files(folder: Path) -> Iterator[Path]:
    """Yield the text files that people write, in order."""
    for path in sorted(folder.rglob("*")):
        if path.suffix in TEXTS and path.is_file() and not GENERATED & set(path.relative_to(folder).parts):
            yield path


def _area(folder: Path) -> dict[str, int]:
    paths = list(_files(folder))
    return {"files": len(paths), "lines": sum(map(_lines, paths))}


def _lines(path: Path) -> int:
    return len(path.read_text(encoding="utf-8").splitlines())


def _dotted(source: Path, path: Path) -> str:
    parts = path.relative_to(source).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _code_lines(path: Path, tree: ast.Module) -> set[int]:
    """Return the numbers of the lines of code."""
    text = path.read_text(encoding="utf-8")
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    lines = {line for token in tokens if token.type not in NO_CODE for line in range(token.start[0], token.end[0] + 1)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            first = node.body[0] if node.body else None
            if (
                isinstance(first, ast.Expr)
                and isinstance(first.value, ast.Constant)
                and isinstance(first.value.value, str)
            ):
                lines -= set(range(first.lineno, (first.end_lineno or first.lineno) + 1))
    return lines


def _import_lines(tree: ast.Module) -> set[int]:
    nodes = (node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom))
    return {line for node in nodes for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)}


def _importers(source: Path, modules: dict[str, Path], trees: dict[str, ast.Module]) -> dict[str, set[str]]:
    """Return, by module, the modules that import it or one of its names."""
    packages = {name for name, path in modules.items() if path.name == "__init__.py"}
    stubs = {name: source.joinpath(*name.split("."), "__init__.pyi") for name in packages}
    exported: dict[tuple[str, str], str] = {}
    for package, stub in stubs.items():
        tree = ast.parse(stub.read_text(encoding="utf-8")) if stub.is_file() else trees[package]
        for module, name, alias in _imported(tree, package, is_package=True):
            exported[package, alias] = f"{module}.{name}" if f"{module}.{name}" in modules else module
    importers = defaultdict[str, set[str]](set)
    for importer, tree in trees.items():
        for module, name, _ in _imported(tree, importer, is_package=importer in packages):
            target = f"{module}.{name}" if f"{module}.{name}" in modules else module
            seen = set[str]()
            while (target, name) in exported and target not in seen:
                seen.add(target)
                target = exported[target, name]
            if target in modules and target != importer and not (importer in packages and target.startswith(importer)):
                importers[target].add(importer)
    return importers


def _imported(tree: ast.Module, module: str, *, is_package: bool) -> Iterator[tuple[str, str, str]]:
    """Yield the imports: the module, the name in the module or nothing, and the local name."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, "", alias.asname or alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = module.split(".")[: len(module.split(".")) - node.level + is_package] if node.level else []
            origin = ".".join([*above, *([node.module] if node.module else [])])
            yield from ((origin, alias.name, alias.asname or alias.name) for alias in node.names)


def table(totals: dict[str, Any]) -> str:
    """Return the counts as text."""
    single, twice, full = (
        totals[key] for key in ("short_modules_with_one_importer", "classes_defined_twice", "folders_with_many_modules")
    )
    return "\n".join(
        [
            *(f"{area:<11}{size['lines']:>8} lines in {size['files']} files" for area, size in totals["areas"].items()),
            f"{'all':<11}{sum(size['lines'] for size in totals['areas'].values()):>8} lines",
            "",
            f"package: {totals['modules']} modules, {totals['lines_of_code']} lines of code;"
            f" {100 * totals['import_share']:.1f} % of them ({totals['import_lines']}) are imports",
            "",
            f"modules below {SHORT} lines with a single importer: {len(single)}",
            *(f"  {name} <- {importer}" for name, importer in single.items()),
            "",
            f"class names that are defined more than once: {len(twice)}",
            *(f"  {name}: {', '.join(places)}" for name, places in twice.items()),
            "",
            f"folders with more than {MANY} modules: {len(full)}",
            *(f"  {folder}: {count}" for folder, count in full.items()),
        ]
    )


def main() -> None:
    """Print the counts."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    default = Path(__file__).parents[1]
    parser.add_argument("folder", nargs="?", type=Path, default=default, help="of the checkout; this one if not given")
    parser.add_argument("--json", type=Path, help="file to write the counts to")
    parser.add_argument("--short", action="store_true", help="print counts without the lists below them")
    choices = parser.parse_args()
    totals = counts(choices.folder)
    lines = table(totals).splitlines()
    print(
        "\n".join(line for line in lines if line and not line.startswith("  ")) if choices.short else "\n".join(lines)
    )
    if choices.json:
        choices.json.write_text(json.dumps(totals, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
