import base64
import hashlib
import json
import re
from pathlib import Path

import pytest

from forficula.show.page.page import built, page_html
from forficula.show.page.parts.html import Cell, escaped, section, table

WEB = Path(__file__).parents[3] / "web"
HOSTILE = '</script><script>alert("1")</script><!--<img src=x onerror=alert(1)>&amp;'


def data_of(page):
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)[1])


def test_text_stays_text_in_the_title_and_in_the_data():
    page = page_html(HOSTILE, f"<p>{escaped(HOSTILE)}</p>", {"kind": "run", "name": HOSTILE})
    assert data_of(page)["name"] == HOSTILE
    assert page.count("<script") == 2
    assert "<img" not in page
    assert table("x", ("a", HOSTILE), [[HOSTILE, Cell(text=HOSTILE, note=HOSTILE)]]).count("<script") == 0


@pytest.mark.parametrize(("data", "script"), [({"kind": "run"}, "page.js"), (None, "still.js")])
def test_only_the_packed_script_may_run_and_nothing_may_be_fetched(data, script):
    page = page_html("wing", "", data)
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page)[1]
    digest = base64.b64encode(hashlib.sha256(built(script).encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}';" in policy
    assert policy.startswith("default-src 'none';")
    assert "http" not in policy
    # no element requests anything
    assert re.findall(r'<(?:script|link|img|iframe)[^>]*(?:src|href)="(?!data:)', page) == []


def test_nan_and_infinity_are_refused_in_page_data():
    with pytest.raises(ValueError, match="not JSON compliant"):
        page_html("wing", "", {"value": float("nan")})


@pytest.mark.skipif(not WEB.is_dir(), reason="the sources of the script are not there")
def test_the_packed_script_is_that_of_its_sources():
    """If this fails: make page."""
    files = sorted(path for path in (WEB / "src").iterdir() if path.is_file())
    first = ("build.js", "engine.js", "licences/mujoco.txt", "package-lock.json", "package.json")
    sources = [WEB / name for name in first] + files
    digest = hashlib.sha256()
    for path in sources:
        text = path.read_text("utf-8").replace("\r\n", "\n")
        digest.update(f"{path.relative_to(WEB).as_posix()}\n{text}".encode())
    for name in ("page.js", "still.js", "page.css", "engine.js"):
        assert digest.hexdigest() in built(name).partition("\n")[0], f"{name} is stale: run make page"


def test_the_licences_of_packed_code_are_included():
    licences = built("LICENSES.txt")
    for words in ("three", "Copyright © 2010", "uplot", "Copyright (c) 2022 Leon Sorokin"):
        assert words in licences
    licence = licences.partition("mujoco ")[0]
    assert licence.count("Permission is hereby granted") == 2


def test_a_page_without_javascript_has_a_notice_above_the_numbers():
    page = page_html("wing", "<h1>wing</h1>", {"kind": "run"})
    assert page.index("<noscript>") < page.index("<h1>")


def test_a_table_names_its_columns_and_rows_and_marks_what_it_should():
    made = table("Angles", ("vein", "deg"), [["0", Cell(text="3.0", marked=True)]], groups=[("", 1), ("flat", 1)])
    assert "<caption>Angles</caption>" in made
    assert '<th scope="colgroup" colspan="1">flat</th>' in made
    assert '<tr class="changed"><th scope="row">0</th><td><mark>3.0</mark></td></tr>' in made
    assert "<thead>" not in table("Plain", ("", ""), [["a", "b"]])
    # focusable elements have names, and no caption is empty
    named = table("", ("time", "angle"), [["1 s", "2 deg"]])
    assert 'tabindex="0" role="group" aria-label="time, angle"' in named
    assert "<caption>" not in named


# pairs of foreground and background: letters 4.5 : 1, lines, rings and bars 3 : 1 (WCAG 2.2, 1.4.3 and 1.4.11)
LETTERS = {
    "ink": ("page", "raised", "picture-top", "picture-foot", "band", "mark"),
    "muted": ("page", "raised", "picture-top", "picture-foot"),
    "accent": ("page",),
    "on-accent": ("accent",),
}
MARKS = {
    "accent": ("page", "raised", "picture-top", "picture-foot"),
    "bar": ("page", "picture-top", "picture-foot"),
    **{f"line-{number}": ("page", "band") for number in range(7)},
}


def luminance(colour):
    """Return the relative luminance of sRGB as in WCAG."""
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return sum(share * part for share, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


@pytest.mark.skipif(not WEB.is_dir(), reason="the sources of the style are not there")
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_colours_have_sufficient_contrast_in_light_and_dark_pages(scheme):
    light, dark = re.findall(r":root \{(.*?)\}", (WEB / "src" / "page.css").read_text("utf-8"), re.S)
    colours = dict(re.findall(r"--([\w-]+): (#\w{6});", light + dark * (scheme == "dark")))
    for pairs, least in ((LETTERS, 4.5), (MARKS, 3.0)):
        for above, grounds in pairs.items():
            for ground in grounds:
                low, high = sorted(luminance(colours[item]) for item in (above, ground))
                assert (high + 0.05) / (low + 0.05) >= least, (above, ground)


def test_a_section_without_content_is_left_out():
    assert section("Nothing", "", "") == ""
