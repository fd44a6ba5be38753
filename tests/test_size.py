import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[1] / "benchmarks" / "size.py"
FILES = {
    "src/forficula/__init__.py": '"""Package."""\n',
    "src/forficula/a/__init__.py": "from forficula.a.one import One\nfrom forficula.a import two\n",
    "src/forficula/a/one.py": '"""One."""\n\n\nclass One:\n    """Is one."""\n\n    value = 1  # of it\n',
    "src/forficula/a/two.py": "from forficula.a.one import One\n\n\nclass One(One): ...\n",
    "src/forficula/b.py": "from forficula.a import One, two\n",
    "web/src/page.js": "let one;\n",
    "web/node_modules/other.js": "let two;\n",
}


@pytest.mark.skipif(not SCRIPT.is_file(), reason="the script is not there")
def test_the_size_of_a_checkout_is_counted_through_what_packages_export(tmp_path):
    spec = importlib.util.spec_from_file_location("size", SCRIPT)
    size = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(size)
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    totals = size.counts(tmp_path)
    assert totals["areas"]["web"] == {"files": 1, "lines": 1}
    assert (totals["modules"], totals["lines_of_code"], totals["import_lines"]) == (5, 7, 4)
    # b imports One through the package, and is the only one that imports two
    assert totals["short_modules_with_one_importer"] == {"forficula.a.two": "forficula.b"}
    assert totals["classes_defined_twice"] == {"One": ["src/forficula/a/one.py:4", "src/forficula/a/two.py:4"]}
    assert totals["folders_with_many_modules"] == {}
    assert "class names that are defined more than once: 1" in size.table(totals)
