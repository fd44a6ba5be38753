"""Arguments of the wrong type: every public function says what it accepts, in one line."""

import inspect
import pickle
import subprocess
import sys

import numpy as np
import pytest

import forficula as ff
from forficula.argument_checks import _by_annotation
from forficula.errors import InputError

FUNCTIONS = {
    f"{prefix}{name}": getattr(module, name)
    for prefix, module in (("", ff), ("pattern.", ff.pattern), ("material.", ff.material), ("make.", ff.make))
    for name in module.__all__
    if inspect.isfunction(getattr(module, name))
}
WRONG = (None, 3.5, True, b"bytes", {1: 2}, [object()], object(), "text", print)


def arguments_of(name):
    """Every parameter of a function with the values of WRONG that it is not annotated with."""
    for key, parameter in inspect.signature(FUNCTIONS[name]).parameters.items():
        accepted = _by_annotation(parameter.annotation)
        if parameter.kind is not parameter.VAR_KEYWORD and accepted.word:
            yield key, [value for value in WRONG if not accepted.holds(value)]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_an_argument_of_a_wrong_type_is_refused_with_what_is_accepted(name):
    function = FUNCTIONS[name]
    parameters = inspect.signature(function).parameters
    needed = [
        key
        for key, parameter in parameters.items()
        if parameter.default is parameter.empty and parameter.kind is not parameter.VAR_KEYWORD
    ]
    for key, values in arguments_of(name):
        assert values, f"{name}: {key}: takes anything"
        for value in values:
            # what comes before is of the right type
            others = {other: right(parameters[other].annotation) for other in needed if other != key}
            with pytest.raises(InputError, match=rf"^{key}: need \S.*, got ") as caught:
                function(**{**others, key: value})
            assert len(str(caught.value)) < 250
            assert "\n" not in str(caught.value)


def right(annotation):
    """Something that an annotation allows; it is not looked at."""
    accepted = _by_annotation(annotation)
    name = annotation.partition(" | ")[0].partition("[")[0]
    samples = ("text", {}, [], 1, 1.5, print, type(name, (), {})())
    return next(sample for sample in samples if accepted.holds(sample))


@pytest.mark.parametrize("wrong", [None, 3, "nowhere", object()])
def test_what_has_no_figures_and_cannot_be_saved_is_refused(wrong, tmp_path):
    with pytest.raises(InputError):
        ff.figure(wrong)
    with pytest.raises(InputError):
        ff.save(wrong, tmp_path)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: ff.run("letter-fold", progress=0), "progress: need a function, True, False or None, got 0 (int)"),
        (
            lambda: ff.landscape("letter-fold", points=None),
            "points: need a whole number, got None",
        ),
        (
            lambda: ff.material.size_tendons("letter-fold", ff.material.load_law("tpu-82a"), ""),
            'stiffnesses: need a list of numbers, got "" (str)',
        ),
        (
            lambda: ff.run_study("study.toml", "out"),
            'study: need a Study (as load_study or new_study returns it), got "study.toml" (str)',
        ),
        (
            lambda: ff.material.read_tensile_tests("a.csv"),
            'paths: need a list of paths, got "a.csv" (str)',
        ),
        (
            lambda: ff.material.characterise([1]),
            "tests: need a list of objects of class TensileTest (as material.read_tensile_test returns them),"
            " got [1] (list)",
        ),
    ],
)
def test_the_refusal_says_what_to_give(call, message):
    with pytest.raises(InputError) as caught:
        call()
    assert str(caught.value) == message


@pytest.mark.parametrize("number", [np.float32(0.0625), np.float64(0.0625), np.array(0.0625), np.array(0.0625, "f4")])
def test_numbers_of_numpy_are_numbers(number, reference):
    changed = reference.with_values({"tendon.rest_length": number, "membrane.proximal_rows": np.array([number, 0.25])})
    assert changed.tendon.rest_length == 0.0625
    assert changed.membrane.proximal_rows == (0.0625, 0.25)
    assert ff.scale_design("letter-fold", number).hash == ff.scale_design("letter-fold", 0.0625).hash
    share = {"membrane.poisson_ratio": [number, 0.3]}
    assert ff.new_study(reference, share).factors[0].values == (0.0625, 0.3)


def test_public_functions_are_those_of_their_modules_to_help_and_pickle():
    assert pickle.loads(pickle.dumps(ff.run)) is ff.run
    assert str(inspect.signature(ff.run)).startswith("(design: 'AnyDesign', progress: 'ProgressOption' = None, *, ")
    assert ff.run.__doc__.startswith("Run a design through its protocol")
    with pytest.raises(TypeError, match=r"run\(\) missing 1 required positional argument: 'design'"):
        ff.run()


def test_the_package_is_imported_without_what_its_functions_need():
    code = "import sys, forficula; print(sorted({'mujoco', 'numpy', 'xarray', 'scipy', 'pydantic'} & set(sys.modules)))"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ended.stdout == "[]\n"
