import pytest

from forficula.names import listed, near_name, one_line, one_of, ordinal


@pytest.mark.parametrize(
    ("number", "word"), [(0, "first"), (9, "tenth"), (10, "11th"), (20, "21st"), (21, "22nd"), (112, "113th")]
)
def test_numbers_from_0_are_shown_counted_from_1(number, word):
    assert ordinal(number) == word


@pytest.mark.parametrize(
    ("words", "text"), [([], ""), (["a"], "a"), (["a", "b"], "a or b"), (["a", "b", "c"], "a, b or c")]
)
def test_words_are_listed_as_sentences_have_them(words, text):
    assert listed(iter(words), "or") == text
    assert listed(words) == text.replace(" or ", " and ")


def test_allowed_names_are_listed_with_the_nearest_one():
    assert (
        one_of(["fold", "none"], "flod", ["a bound"]) == '"fold", "none" or a bound, got "flod"; did you mean "fold"?'
    )
    assert one_of(["fold"], 5) == '"fold", got 5'
    assert one_of(["time"], "rnig", near_to=["ring"]) == '"time", got "rnig"; did you mean "ring"?'
    assert near_name("sideways", ["fold"]) == ""


def test_a_text_of_another_file_is_one_line_that_steers_no_terminal():
    assert one_line("Miura\n\x1b[31mred\u202e 日本 ") == "Miura [31mred 日本"
