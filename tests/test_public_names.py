"""Public names: what functions return is public, too, and the modules list nothing else."""

import ast
import inspect
import subprocess
import sys

import pytest

import forficula as ff

MODULES = {"": ff, "pattern.": ff.pattern, "material.": ff.material, "make.": ff.make, "results.": ff.results}
PUBLIC = {f"{prefix}{name}": getattr(module, name) for prefix, module in MODULES.items() for name in module.__all__}
CLASSES = {name.rpartition(".")[2] for name, value in PUBLIC.items() if inspect.isclass(value)}
FUNCTIONS = {name: value for name, value in PUBLIC.items() if inspect.isfunction(value)}
# aliases and classes of Python and of libraries
OTHERS = {
    *("Any", "Array", "DataFrame", "Dataset", "Figure", "Frame", "Indices", "Iterator", "Literal", "Mapping"),
    *("None", "Self", "Sequence", "Series"),
}


def returned_classes(function):
    """Names of classes in the annotation of what a function returns."""
    annotation = inspect.signature(function).return_annotation
    for node in ast.walk(ast.parse(annotation if isinstance(annotation, str) else "None", mode="eval")):
        if isinstance(node, ast.Name) and node.id[0].isupper():
            yield node.id


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_every_class_that_a_function_returns_is_public(name):
    assert set(returned_classes(FUNCTIONS[name])) <= CLASSES | OTHERS


@pytest.mark.parametrize("name", sorted(["Run", "Study", "EnergyLandscape", "Outcome", "results.Result"]))
def test_every_class_that_a_method_of_a_main_class_returns_is_public(name):
    for method, value in vars(PUBLIC[name]).items():
        function = getattr(value, "func", None) or getattr(value, "fget", None) or value
        if not method.startswith("_") and inspect.isfunction(function):
            assert set(returned_classes(function)) <= CLASSES | OTHERS, method


def test_there_are_about_thirty_names_at_the_top():
    assert 30 <= len(ff.__all__) <= 42


@pytest.mark.parametrize("module", ["pattern", "material", "make", "results"])
def test_modules_list_their_public_names(module):
    listed = getattr(ff, module)
    names = [name for name in dir(listed) if not name.startswith("_")]
    assert sorted(names) == sorted(listed.__all__)
    with pytest.raises(AttributeError, match="nothing"):
        listed.nothing  # noqa: B018


def test_a_module_of_the_package_does_not_replace_a_function_of_its_name():
    code = (
        "import forficula.pattern.facet_tree, forficula.pattern.crease_pattern, forficula as ff;"
        "from forficula.pattern import facet_tree; assert callable(facet_tree);"
        "import forficula.make.make_parts; assert callable(ff.make.parts)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
