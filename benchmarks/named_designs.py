"""Run every named design and print verdict, times with their numerical uncertainty, and confirmation as a table.

`python benchmarks/named_designs.py` takes minutes; names after it run these designs alone. The table of
docs/model/reliability.md is its output. Versions without confirmation print the first three columns.
"""

from __future__ import annotations

import argparse
import inspect
import time

import forficula as ff


def row_of(name: str) -> str:
    """Return a line of the table about one design."""
    began = time.process_time()
    record = ff.run(ff.load_design(name))
    outcome = ff.measure(record)
    took = time.process_time() - began
    times = []
    for made, transition in outcome.transitions.items():
        if transition is not None and transition.time is not None:
            times.append(f"{made} {_with_uncertainty(outcome, f'{made}.time', transition.time)}")
    confirmation = getattr(outcome, "confirmation", None)
    confirmed = "-" if confirmation is None else "yes" if confirmation.agree else "no"
    return f"| {name} | {outcome.status} | {', '.join(times) or '-'} | {confirmed} | {took:.1f} |"


def _with_uncertainty(outcome: ff.Outcome, name: str, value: float) -> str:
    confirmation = getattr(outcome, "confirmation", None)
    half = None if confirmation is None else confirmation.of(name)
    return f"{1e3 * value:.4g} ms" if half is None else f"{1e3 * value:.4g} ± {1e3 * half:.2g} ms"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", help="of the designs; all if not given")
    names = parser.parse_args().names
    confirms = "confirm" in inspect.signature(ff.run).parameters
    print(f"| design | outcome | times | {'confirmed' if confirms else '-'} | CPU s |")
    print("| --- | --- | --- | --- | --- |")
    for name in names or list(ff.examples()):
        print(row_of(name), flush=True)


if __name__ == "__main__":
    main()
