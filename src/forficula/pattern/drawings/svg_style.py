"""Styles of the elements of an SVG drawing: attributes, style sheets, colours and lengths."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable

Style = dict[str, str]
Rules = list[tuple[str, Style]]

_NAMED = {
    "black": "#000000",
    "red": "#ff0000",
    "blue": "#0000ff",
    "green": "#008000",
    "lime": "#00ff00",
    "yellow": "#ffff00",
    "magenta": "#ff00ff",
    "fuchsia": "#ff00ff",
    "gray": "#808080",
    "grey": "#808080",
    "silver": "#c0c0c0",
    "lightgray": "#d3d3d3",
    "lightgrey": "#d3d3d3",
    "darkgray": "#a9a9a9",
    "darkgrey": "#a9a9a9",
    "dimgray": "#696969",
    "white": "#ffffff",
    "cyan": "#00ffff",
    "aqua": "#00ffff",
    "navy": "#000080",
    "maroon": "#800000",
    "darkred": "#8b0000",
    "darkblue": "#00008b",
    "purple": "#800080",
    "orange": "#ffa500",
    "crimson": "#dc143c",
    "gold": "#ffd700",
}
_SIMPLE = re.compile(r"(\*|[\w-]+)?((?:[.#][\w-]+)*)")
_INHERITED = ("stroke", "stroke-opacity", "visibility")
_OWN = ("opacity", "display")
# m; in CSS, 96 px are one inch
_LENGTHS = {"mm": 1e-3, "cm": 1e-2, "in": 0.0254, "pt": 0.0254 / 72, "pc": 0.0254 / 6, "q": 2.5e-4, "m": 1.0}
PIXEL = 0.0254 / 96


def rules_of(root: ElementTree.Element) -> Rules:
    """List the rules of the style sheets of a drawing, those with the most general selectors first."""
    rules: Rules = []
    for sheet in root.iter():
        if sheet.tag.rpartition("}")[2] != "style":
            continue
        text = re.sub(r"/\*.*?\*/|<!--|-->", "", sheet.text or "", flags=re.S)
        for selectors, body in re.findall(r"([^{}]+)\{([^{}]*)\}", text):
            rules += [(selector.strip(), declarations(body)) for selector in selectors.split(",")]
    return sorted(rules, key=lambda rule: (rule[0].count("#"), rule[0].count(".")))


def declarations(text: str) -> Style:
    """Parse CSS declarations, such as "stroke:#f00; opacity:.5"."""
    pairs = (part.split(":", 1) for part in text.split(";") if ":" in part)
    return {key.strip().lower(): value.replace("!important", "").strip() for key, value in pairs}


def style_of(element: ElementTree.Element, above: Style, rules: Rules) -> Style:
    """Compute the style of an element; its opacity includes that of all groups around it."""
    style = {key: value for key, value in above.items() if key in _INHERITED}
    values = {key: element.attrib[key] for key in (*_INHERITED, *_OWN) if key in element.attrib}
    for selector, declared in rules:
        if _selects(selector, element):
            values |= declared
    values |= declarations(element.get("style", ""))
    style |= {key: value for key, value in values.items() if value != "inherit"}
    style["opacity"] = str(number_of(above.get("opacity")) * number_of(values.get("opacity")))
    return style


def is_simple(selector: str) -> bool:
    """Return whether a selector consists of tag, classes and id only, without combinators."""
    return bool(selector) and _SIMPLE.fullmatch(selector) is not None


def _selects(selector: str, element: ElementTree.Element) -> bool:
    """Return whether a selector without combinators selects an element."""
    match = _SIMPLE.fullmatch(selector)
    if match is None or not selector:
        return False
    tag, rest = match.groups()
    if tag not in (None, "*", element.tag.rpartition("}")[2]):
        return False
    classes = element.get("class", "").split()
    return all(
        part[1:] in classes if part[0] == "." else part[1:] == element.get("id")
        for part in re.findall(r"[.#][\w-]+", rest)
    )


def number_of(text: str | None) -> float:
    """Parse an opacity, such as "0.5" or "50%"; return 1 for other text."""
    match = re.fullmatch(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(%?)\s*", text or "", re.I)
    if match is None:
        return 1.0
    return min(max(float(match[1]) / (100 if match[2] else 1), 0.0), 1.0)


def colour_of(text: str) -> tuple[float, float, float, float] | None:
    """Parse a colour: "#f00", "#ff0000", "rgb(255, 0, 0)", "rgba(100%, 0%, 0%, .5)" or a name.

    Returns:
        Red, green, blue and opacity, 0 to 1; None for "none" and other text.
    """
    text = _NAMED.get(text.strip().lower(), text.strip().lower())
    if match := re.fullmatch(r"#([0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})", text):
        digits = match[1] if len(match[1]) > 4 else "".join(2 * digit for digit in match[1])
        return _four(int(digits[index : index + 2], 16) / 255 for index in range(0, len(digits), 2))
    if match := re.fullmatch(r"rgba?\(([^()]*)\)", text):
        parts = [part for part in re.split(r"[\s,/]+", match[1].strip()) if part]
        if len(parts) in (3, 4) and all(re.fullmatch(r"[+-]?[\d.]+%?", part) for part in parts):
            try:
                scale = [255.0, 255.0, 255.0, 1.0]
                shares = [
                    float(part.rstrip("%")) / (100 if part.endswith("%") else whole)
                    for part, whole in zip(parts, scale, strict=False)
                ]
            except ValueError:
                return None
            return _four(shares)
    return None


def _four(shares: Iterable[float]) -> tuple[float, float, float, float]:
    """Clip red, green, blue and opacity to 0 to 1; the opacity is 1 if it is missing."""
    red, green, blue, *opacity = (min(max(share, 0.0), 1.0) for share in shares)
    return red, green, blue, opacity[0] if opacity else 1.0


def length_of(text: str | None) -> tuple[float, float | None] | None:
    """Parse a length, such as "210mm".

    Returns:
        The number, and the length of its unit, m, or None for pixels and plain numbers; None for other text and "100%".
    """
    match = re.fullmatch(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([a-z]*)\s*", text or "", re.I)
    if match is None:
        return None
    number, unit = float(match[1]), match[2].lower()
    if not math.isfinite(number) or unit not in ("", "px", *_LENGTHS):
        return None
    return number, _LENGTHS.get(unit)
