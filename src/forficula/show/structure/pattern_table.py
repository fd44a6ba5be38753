"""What a crease pattern is as text that a person understands."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.names import listed
from forficula.pattern import ASSIGNMENTS, Freedoms, PatternFacts, Rigidity, fault_words
from forficula.quantities import reading_unit

_MOST_ROWS, _MOST_NAMED = 12, 5


def print_pattern(facts: PatternFacts, remarks: Sequence[str] = ()) -> None:
    """Print what a crease pattern is; args are those of `pattern_table`."""
    Console(width=110, highlight=False).print(pattern_table(facts, remarks))


def pattern_table(facts: PatternFacts, remarks: Sequence[str] = ()) -> RenderableType:
    """Lay out what there is, in how many ways it moves, vertices that do not fold flat, and what follows of it.

    Args:
        facts: what to show.
        remarks: on how the pattern was read.
    """
    parts: list[RenderableType] = [Text(_heading(facts), style="bold"), Text(), _parts(facts)]
    if facts.freedoms is not None:
        parts += [Text(), _freedoms(facts.freedoms)]
    faults = [(each, words) for each in facts.inside if (words := fault_words(each))]
    if faults:
        table = _columns("vertex that does not fold flat", "creases", "why")
        for each, words in faults[:_MOST_ROWS]:
            table.add_row(str(each.vertex), str(each.creases), "; ".join(words))
        parts += [Text(), table]
        if len(faults) > _MOST_ROWS:
            parts.append(Text(f"and {len(faults) - _MOST_ROWS} more"))
    sentences = [*facts.flat_folding, *_rigid_folding(facts), *(f"{each}." for each in remarks)]
    return Group(*parts, Text(), *map(Text, sentences))


def _heading(facts: PatternFacts) -> str:
    x, y, z = facts.size
    unit, factor = reading_unit("m", max(facts.size))
    extent = " by ".join(f"{factor * length:.4g} {unit}" for length in ((x, y) if facts.flat else (x, y, z)))
    vertices, facets = _counted(facts.vertices, "vertex", "vertices"), _counted(facts.facets, "facet")
    return f"{facts.title}: {vertices}, {facets}, {extent}"


def _parts(facts: PatternFacts) -> Table:
    table = _columns("", "")
    table.show_header = False
    letters = ", ".join(f"{count} {ASSIGNMENTS[letter]}" for letter, count in facts.edges.items())
    table.add_row("edges", f"{sum(facts.edges.values())}: {letters}")
    if facts.roles:
        table.add_row("roles", ", ".join(facts.roles))
    table.add_row("lies", "flat" if facts.flat else "folded, or built as a solid shape")
    if facts.freedoms is not None:
        table.add_row("hangs together as", f"{_counted(facts.parts, 'piece')}, {_counted(facts.holes, 'hole')}")
        table.add_row("interior vertices", _inside(facts))
    table.add_row(
        "facets as a tree", f"no: {facts.loop.partition(':')[0]}" if facts.loop else "yes: no creases close a loop"
    )
    return table


def _inside(facts: PatternFacts) -> str:
    """How many vertices there are inside, by how many creases meet there, and those that are no flat sheet."""
    if not facts.inside:
        return "none"
    degrees = Counter(each.creases for each in facts.inside)
    counts = listed(f"{count} of {_counted(degree, 'crease')}" for degree, count in sorted(degrees.items()))
    if all(each.developable for each in facts.inside):
        return f"{counts}; 360 deg around each"
    totals = [math.degrees(each.total) for each in facts.inside]
    return f"{counts}; {min(totals):.4g} to {max(totals):.4g} deg around them"


def _freedoms(freedoms: Freedoms) -> Table:
    table = _columns("first order", "degrees of freedom", "states of self-stress")
    rows: list[tuple[str, Rigidity | None]] = [("rigid facets, as given", freedoms.rigid)]
    if freedoms.folded is not None:
        rows.append((f"rigid facets, creases folded by {_fold_range(freedoms)}", freedoms.folded))
    for name, counted in (*rows, ("facets that bend along a diagonal, as given", freedoms.bending)):
        if counted is not None:
            table.add_row(name, str(counted.mechanisms), str(counted.self_stress))
    return table


def _rigid_folding(facts: PatternFacts) -> Iterator[str]:
    """What is to say of facets that are rigid, in sentences."""
    freedoms = facts.freedoms
    if freedoms is None:
        yield f"Degrees of freedom are not counted: {facts.not_counted}."
        return
    if not (freedoms.rigid.clear and freedoms.bending.clear and (freedoms.folded is None or freedoms.folded.clear)):
        yield "Degrees of freedom are in doubt: a motion is nearly free, and rounding may hide whether it is."
    if not facts.flat:
        if freedoms.rigid.mechanisms == 0:
            yield "With rigid facets it does not move from here: it folds only where facets bend."
        return
    folds = any(letter in facts.edges for letter in "MV")
    if not folds:
        return
    stuck = [each.vertex for each in facts.inside if each.folds is False]
    if not freedoms.begins:
        yield "Rigid facets cannot fold with every crease in its sense: they cannot begin to, at first order already."
    elif freedoms.folded is not None:
        yield (
            f"Rigid facets fold with every crease in its sense: found folded by {_fold_range(freedoms)}; whether facets"
            " pass through one another is not checked."
        )
    elif not stuck:
        yield "Rigid facets may fold in the assigned sense at first order; no such state was found, so they may not."
    if stuck:
        yield f"At {_places(stuck)} rigid facets do not leave the flat state in the assigned sense: they have to bend."
    if freedoms.folded is not None and freedoms.folded.mechanisms < freedoms.rigid.mechanisms:
        yield "A flat sheet has more motions at first order than become folds; the folded state has those that last."


def _fold_range(freedoms: Freedoms) -> str:
    least, most = (f"{math.degrees(angle):.0f}" for angle in freedoms.fold_range or (0.0, 0.0))
    return f"{least} deg" if least == most else f"{least} to {most} deg"


def _places(vertices: Sequence[int]) -> str:
    """Name the first few vertices."""
    shown = ", ".join(map(str, vertices[:_MOST_NAMED]))
    more = f" and {len(vertices) - _MOST_NAMED} more" if len(vertices) > _MOST_NAMED else ""
    return f"{'vertex' if len(vertices) == 1 else 'vertices'} {shown}{more}"


def _columns(*headings: str) -> Table:
    """A table without lines whose first column is text."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in headings:
        table.add_column(heading)
    return table


def _counted(count: int, one: str, many: str | None = None) -> str:
    return f"{count} {one if count == 1 else many or f'{one}s'}"
