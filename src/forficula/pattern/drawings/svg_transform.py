"""Parsing of lists of numbers and of transforms in SVG drawings, in attributes and CSS."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ElementTree

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.drawings.svg_style import Rules, Style, is_simple
from forficula.quantities import as_written

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_FUNCTION = r"(\w+)\s*\(([^()]*)\)"
_NO_ORIGIN = re.compile(r"(?:(?:0|0px|0%|left|top)\s*)+")
# other CSS properties that move an element
_MOVES = ("translate", "rotate", "scale", "zoom", "offset-path")
_ANGLES = {"": 1.0, "deg": 1.0, "rad": 180 / math.pi, "grad": 0.9, "turn": 360.0}  # deg
_CSS_UNITS = {
    **{kind: {"": 1.0, "px": 1.0} for kind in ("translate", "translateX", "translateY")},
    **dict.fromkeys(("rotate", "skewX", "skewY"), _ANGLES),
}


def numbers_of(key: str, text: str) -> list[float]:
    """Parse a list of numbers separated by spaces or commas; SVG 2 allows a sign without a separator.

    Raises:
        InputError: other text between the numbers, a comma without a number, or a number that is not finite.
    """
    between = re.sub(NUMBER, lambda number: " " * len(number[0]), text)
    if other := re.search(r"[^\s,]+", between):
        raise InputError(f"{key}: need numbers, got {as_written(_word_at(text, other.start()))}")
    if re.search(r"(?:^|,)\s*,", text):
        raise InputError(f"{key}: need a number before every comma, got {as_written(text)}")
    numbers = [float(number) for number in re.findall(NUMBER, text)]
    for number, written in zip(numbers, re.findall(NUMBER, text), strict=True):
        if not math.isfinite(number):
            raise InputError(f"{key}: need finite numbers, got {written}")
    return numbers


def _word_at(text: str, place: int) -> str:
    """Return the word at a position, up to spaces and commas."""
    start = max((match.end() for match in re.finditer(r"[\s,]", text[:place])), default=0)
    return re.split(r"[\s,]", text[start:], maxsplit=1)[0]


def check_rules(rules: Rules) -> None:
    """Refuse rules with transforms whose selectors are not simple, because such selectors are not evaluated.

    Raises:
        InputError: a rule with a transform; the message names the selector.
    """
    for selector, declared in rules:
        if not is_simple(selector) and ({"transform", "transform-origin", *_MOVES} & declared.keys()):
            raise InputError(
                f"style: need a transform on the element itself, got one for {as_written(selector)}; write it there"
            )


def matrix_of(element: ElementTree.Element, style: Style) -> Array:
    """Compute the matrix of an element's transform, shape (3, 3); the style has priority over the attribute.

    Raises:
        InputError: the transform is not one in the plane, or has an origin other than 0 0.
    """
    for key in _MOVES:
        if style.get(key, "none") not in ("none", "normal", "auto"):
            raise InputError(f"{key}: need transform instead, got {as_written(style[key])} in the style")
    css = style.get("transform")
    text = element.get("transform", "") if css is None else css
    if text.strip() in ("", "none"):
        return np.eye(3)
    origin = style.get("transform-origin", element.get("transform-origin", "0 0")).strip()
    if not _NO_ORIGIN.fullmatch(origin):
        raise InputError(f"transform-origin: need 0 0, got {as_written(origin)}; apply it in a drawing program")
    matrix = np.eye(3)
    rest = re.sub(rf"{_FUNCTION}[\s,]*", "", text).strip()
    for kind, arguments in re.findall(_FUNCTION, text):
        values = _in_css(kind, arguments) if css is not None else numbers_of("transform", arguments)
        step = None if values is None else _step(kind, values)
        if step is None:
            rest = f"{kind}({arguments})"
            break
        matrix = matrix @ step
    if rest:
        raise InputError(f"transform: need translate, scale, rotate, skewX, skewY or matrix, got {as_written(rest)}")
    return matrix


def _in_css(kind: str, arguments: str) -> list[float] | None:
    """Parse the numbers of a CSS function, lengths in pixels and angles in degrees; return None for other units."""
    values = []
    for argument in arguments.split(","):
        for word in argument.split():
            match = re.fullmatch(rf"({NUMBER})([a-z]*)", word.strip())
            factor = _CSS_UNITS.get(kind, {"": 1.0}).get(match[2]) if match else None
            if match is None or factor is None or not math.isfinite(float(match[1])):
                return None
            values.append(float(match[1]) * factor)
    return values


def _step(kind: str, values: list[float]) -> Array | None:
    """Return the matrix of one transform function (SVG 2, section 8.5); None for an unknown one."""
    match kind, values:
        case "matrix", [a, b, c, d, e, f]:
            return np.array([[a, c, e], [b, d, f], [0.0, 0.0, 1.0]])
        case "translate", [x, *rest] if len(rest) < 2:
            return np.array([[1.0, 0.0, x], [0.0, 1.0, rest[0] if rest else 0.0], [0.0, 0.0, 1.0]])
        case "scale", [x, *rest] if len(rest) < 2:
            return np.diag([x, rest[0] if rest else x, 1.0])
        case "rotate", [angle, *centre] if len(centre) in (0, 2):
            c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            x, y = centre or (0.0, 0.0)
            return np.array([[c, -s, x - c * x + s * y], [s, c, y - s * x - c * y], [0.0, 0.0, 1.0]])
        case "translateX", [x]:
            return _step("translate", [x])
        case "translateY", [y]:
            return _step("translate", [0.0, y])
        case "scaleX", [x]:
            return np.diag([x, 1.0, 1.0])
        case "scaleY", [y]:
            return np.diag([1.0, y, 1.0])
        case "skewX", [angle]:
            return np.array([[1.0, math.tan(math.radians(angle)), 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
        case "skewY", [angle]:
            return np.array([[1.0, 0.0, 0.0], [math.tan(math.radians(angle)), 1.0, 0.0], [0.0, 0.0, 1.0]])
    return None
