"""Refuse words that readers stumble over, and references to files that are not in the repository.

`make check` runs this script. It reads the pages, the named designs, the scripts of the HTML pages, and the Python
files: comments, docstrings, names of tests, names of variables, and in the package every string. With --count the
script prints the number of faults in each folder instead of the faults.

A word that is right in its place is listed in docs/language-exceptions.txt. Each line has a pattern of paths, a colon,
a space, and the word, a piece of the line with the word, or "*". An exception that is no longer needed is a fault, too.
"""

from __future__ import annotations

import ast
import io
import re
import subprocess
import sys
import tokenize
from collections import Counter
from collections.abc import Iterator
from fnmatch import fnmatch
from pathlib import Path

ROOT = Path(__file__).parents[1]
EXCEPTIONS = Path(__file__).with_name("language-exceptions.txt")
# a pattern, with a space for any white space, and what to write instead
WORDS = {
    r"tells?|telling|told": "report, distinguish",
    r"came to(?! (rest|a stop|an end))": "result, outcome",
    r"(hangs?|hung|hanging) on": "depend on",
    r"stands? (in|beside|there|here|under|below|above) (the|a|it|them|each|its)": "is, is listed",
    r"alike": "identically, the same",
    r"so (many|much)": "the number, the amount",
    r"of which|as of|whoever|whichever": "another sentence",
    r"what is asked|what was asked|asked of": "the request, the question, the query",
    r"lost values?|values? that (is|are|were) lost|that are lost": "values that the paper does not report",
    r"what (was|is|were) seen": "observations",
    r"keeps? doing it": "robust",
    r"the other way round|turn(s|ed)? (it |them )?round": "inverse",
    r"off by(?! default)": "deviate by",
    r"not to be trusted": "unreliable",
    r"knows? (no|nothing)|takes? no(?! (argument|longer))": "ignore, do not model",
    r"go(es)? with": "is proportional to, grows with",
}
NAMES = {"each", "found", "given", "own", "here", "there", "told", "asked"}
_SPACE = r"\s+(?:(?:#|//|\*)\s+)?"  # a comment may go on in the next line
NOUN = "a noun as the name"
_WORDS = re.compile("|".join(rf"\b({word})\b".replace(" ", _SPACE) for word in WORDS), re.I)
_OUTSIDE = re.compile(r"\.\./shared|\bshared/(?=[\w./]*\.(md|txt))|/work/")
_MARKDOWN_FILE = re.compile(r"(?<![\w./-])(?:[\w-]+/)*[\w-]+\.md\b")
_INLINE_CODE = re.compile(r"``?[^`\n]+``?")
_CODE = re.compile(r"^( *)(```+|~~~+)[^\n]*\n.*?^ *\2$|^    [^\n]*$|`[^`\n]+`|\]\([^)]*\)|https?://\S+", re.M | re.S)


def prose(page: str) -> str:
    """Return a page without code, links and addresses; all lines keep their numbers."""
    return _CODE.sub(lambda code: "\n" * code[0].count("\n"), page)


def texts_of_python(source: str, *, strings: bool, test_names: bool) -> Iterator[tuple[int, str]]:
    """Yield line number and text of comments and docstrings, on request also of strings and of the names of tests."""
    tree = ast.parse(source)
    docstrings = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and (strings or id(node) in docstrings):
            yield node.lineno, _INLINE_CODE.sub("", node.value)
        elif test_names and isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
            yield node.lineno, node.name.replace("_", " ")
    last, block = 0, ""
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT and token.start[0] == last + 1 and block:
            last, block = token.start[0], f"{block}\n{token.string}"
        elif token.type == tokenize.COMMENT:
            yield last - block.count("\n"), block
            last, block = token.start[0], token.string
    yield last - block.count("\n"), block


def names_of_python(source: str) -> Iterator[tuple[int, str]]:
    """Yield line number and name of variables, functions and classes whose name is one of NAMES."""
    for node in ast.walk(ast.parse(source)):
        name = ""
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            name = node.id
        elif isinstance(node, ast.arg):
            name = node.arg
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            name = node.name
        if name.strip("_") in NAMES:
            yield node.lineno, name


def faults(path: str, source: str) -> Iterator[tuple[int, str, str]]:
    """Yield line number, word and advice for everything that is refused in a file."""
    python = path.endswith((".py", ".pyi"))
    if python:
        in_package = path.startswith("src/")
        texts = list(texts_of_python(source, strings=in_package, test_names=path.startswith("tests/")))
        for line, name in names_of_python(source):
            yield line, name, NOUN
    elif path == "CHANGELOG.md":  # what is released stays as it was
        texts = [(1, prose("## ".join(source.split("\n## ")[:2])))]
    else:
        texts = [(1, prose(source) if path.endswith(".md") else source)]
    for start, text in texts:
        for result in _WORDS.finditer(text):
            advice = next(to for word, to in WORDS.items() if re.fullmatch(word.replace(" ", _SPACE), result[0], re.I))
            yield start + text.count("\n", 0, result.start()), result[0], advice
        for result in _OUTSIDE.finditer(text):
            yield start + text.count("\n", 0, result.start()), result[0], "a file of this repository"
        for result in _MARKDOWN_FILE.finditer(text) if python and not path.startswith("docs/") else ():
            if not (ROOT / result[0]).exists():
                yield start + text.count("\n", 0, result.start()), result[0], "a file of this repository, with its path"


def files() -> list[str]:
    """Return the paths of all files that are read, relative to the repository."""
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, encoding="utf-8", check=True)
    folders = ("src/", "tests/", "docs/", "benchmarks/", "release/", "web/src/")
    kinds = (".py", ".pyi", ".md", ".rst", ".js", ".toml")
    return [
        path
        for path in listed.stdout.splitlines()
        if path.endswith(kinds) and (path.startswith(folders) or path.endswith(".md")) and "/built/" not in path
    ]


def main() -> None:
    """Print all faults, or their number in each folder, and exit with 1 where there are any."""
    lines = EXCEPTIONS.read_text("utf-8").splitlines()
    exceptions = [
        (paths, piece)
        for paths, _, piece in (line.partition(": ") for line in lines if line.strip() and not line.startswith("#"))
    ]
    needed, words, names = set(), Counter[str](), Counter[str]()
    for path in files():
        source = (ROOT / path).read_text("utf-8")
        lines = source.splitlines()
        for number, fault, advice in faults(path, source):
            word, line = " ".join(fault.split()), lines[number - 1]
            allowed = {
                (paths, piece)
                for paths, piece in exceptions
                if fnmatch(path, paths) and (piece in ("*", word) or (word in piece and piece in line))
            }
            needed |= allowed
            if not allowed:
                (names if advice == NOUN else words)["/".join(path.split("/")[:-1][:3]) or "."] += 1
                if "--count" not in sys.argv:
                    print(f"{path}:{number}: {word!r}: write {advice}")
    for exception in exceptions:
        if exception not in needed:
            print(f"{EXCEPTIONS.relative_to(ROOT)}: no longer needed: {': '.join(exception)}")
    if "--count" in sys.argv:
        print(" words  names  folder")
        print(*(f"{words[folder]:6} {names[folder]:6}  {folder}" for folder in sorted(words | names)), sep="\n")
    sys.exit(1 if words or names or set(exceptions) - needed else 0)


if __name__ == "__main__":
    main()
