"""The keys of a goal file, and what each means."""

from __future__ import annotations

from forficula.design.key_table import file_key

_SIZE = 'share such as "10 %", or as in a design'


# KEY stands for a key of the design, QUANTITY for what a run, statics or the parts tell, or for a KEY
GOAL_KEYS = (
    file_key("name", "text", "the file's name", "what outputs call it"),
    file_key("source", "text", "", "where the question comes from"),
    file_key("design", "text", "needed", "a named design, or the path of a design file, that is varied"),
    file_key("simulate", "true or false", "true", "whether a run must do what its protocol asks for; false: statics"),
    file_key("settings.KEY", "as in a design", "", "replaces a value of the design in all that is tried"),
    file_key("vary.KEY", 'list of choices, or range such as "10..60 N/cm step 10"', "", "values that the key may have"),
    file_key("vary.KEY.low", "as in a design", "", "least value of a key that varies between two"),
    file_key("vary.KEY.high", "as in a design", "", "largest value, alike"),
    file_key("vary.KEY.step", "as in a design", "", "from one value to the next; without it, any value between"),
    file_key("limits.QUANTITY", '">= 5 N cm", "<= 5 N cm", or a list', "", "what it must not fall below, or exceed"),
    file_key("objectives.QUANTITY", '"least" or "largest"', "needed", "what is to be so; two or three give a front"),
    file_key("tolerances.all", "share", "", "of every positive number with a unit that is not the protocol's, uniform"),
    file_key("tolerances.KEY", f'{_SIZE}, or "none"', "", "how far off the key may be, uniform either way"),
    file_key("tolerances.KEY.distribution", '"uniform" or "normal"', "uniform", "of the values that are built"),
    file_key("tolerances.KEY.size", _SIZE, "", "up to which it is off; of a normal one, the standard deviation"),
    file_key("tolerances.KEY.intervals_of", "path", "", "of a tendon's law: a fitted law whose intervals are taken"),
    file_key("search.runs", "whole number, >= 1", "512", "designs that are tried at most; the first fill the space"),
    file_key("search.batch", "whole number, >= 4", "32", "how many side by side"),
    file_key("search.neighbours", "whole number, >= 8", "64", "how many within the tolerances are tried of one"),
    file_key("search.seed", "whole number, >= 0", "0", "of the random numbers"),
    file_key("search.DRIVE_torques", "as in a study", "the drive's", "torques that are tried for a least torque"),
    file_key("search.DRIVE_with", "as in a study", "the drive's", "with which the first drive goes on to the second"),
    file_key("search.refinements", "whole number, >= 0, <= 20", "0", "how often their last step is halved"),
)
