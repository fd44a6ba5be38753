"""The one exception for input that cannot be used."""


class InputError(ValueError):
    """What the user gave cannot be used; the message is one line that names the key, the rule and the value."""
