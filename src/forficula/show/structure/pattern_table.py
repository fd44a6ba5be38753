"""Facts about a crease pattern as text."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.names import listed
from forficula.pattern import ASSIGNMENTS, Freedoms, PatternFacts, Rigidity, fault_labels
from forficula.quantities import reading_unit

_MOST_ROWS, _MOST_NAMED = 12, 5


def print_pattern(facts: PatternFacts, remarks: Sequence[str] = ()) -> None:
    """Print facts about a crease pattern; args are those of `pattern_table`."""
    Console(width=110, highlight=False).print(pattern_table(facts, remarks))


def pattern_table(facts: PatternFacts, remarks: Sequence[str] = ()) -> RenderableType:
    """Return the parts of a pattern, its degrees of freedom, vertices that do not fold flat, and conclusions.

    Args:
        facts: facts to show.
        remarks: remarks of the reader of the pattern's file.
    """
    parts: list[RenderableType] = [Text(_heading(facts), style="bold"), Text(), _parts(facts)]
    if facts.freedoms is not None:
        parts += [Text(), _freedoms(facts.freedoms)]
    faults = [(item, words) for item in facts.inside if (words := fault_labels(item))]
    if faults:
        table = _columns("vertex that does not fold flat", "creases", "reason")
        for item, words in faults[:_MOST_ROWS]:
            table.add_row(str(item.vertex), str(item.creases), "; ".join(words))
        parts += [Text(), table]
        if len(faults) > _MOST_ROWS:
            parts.append(Text(f"and {len(faults) - _MOST_ROWS} more"))
    sentences = [*facts.flat_folding, *_rigid_folding(facts), *(f"{remark}." for remark in remarks)]
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
    table.add_row("shape", "flat" if facts.flat else "folded, or built as a solid shape")
    if facts.freedoms is not None:
        table.add_row("connected as", f"{_counted(facts.parts, 'piece')}, {_counted(facts.holes, 'hole')}")
        table.add_row("interior vertices", _inside(facts))
    table.add_row(
        "facets as a tree", f"no: {facts.loop.partition(':')[0]}" if facts.loop else "yes: no creases close a loop"
    )
    return table


def _inside(facts: PatternFacts) -> str:
    """Return the number of interior vertices by number of creases, and the sum of angles around them."""
    if not facts.inside:
        return "none"
    degrees = Counter(item.creases for item in facts.inside)
    counts = listed(f"{count} of {_counted(degree, 'crease')}" for degree, count in sorted(degrees.items()))
    totals = [item.total for item in facts.inside]
    least, most = (f"{math.degrees(total):.4g}" for total in (min(totals), max(totals)))
    return f"{counts}; {least} deg around each" if least == most else f"{counts}; {least} to {most} deg around them"


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
    """Yield sentences about folding with rigid facets."""
    freedoms = facts.freedoms
    if freedoms is None:
        yield f"Degrees of freedom are not counted: {facts.not_counted}."
        return
    if not (freedoms.rigid.clear and freedoms.bending.clear and (freedoms.folded is None or freedoms.folded.clear)):
        yield "Degrees of freedom are uncertain: one motion is nearly free, and rounding errors may hide whether it is."
    if not facts.flat:
        if freedoms.bending.mechanisms == 0:
            yield "The pattern cannot move from this shape unless edges stretch."
        elif freedoms.rigid.mechanisms == 0:
            yield "With rigid facets the pattern cannot move from this shape: it folds only if facets bend."
        return
    folds = any(letter in facts.edges for letter in "MV")
    if not folds:
        return
    stuck = [item.vertex for item in facts.inside if item.folds is False]
    if not freedoms.begins:
        yield "Rigid facets cannot fold with every crease in its sense: even the first-order motion does not exist."
    elif freedoms.folded is not None:
        yield (
            f"Rigid facets fold with every crease in its sense: a state folded by {_fold_range(freedoms)} was found;"
            " whether facets pass through one another is not checked."
        )
    elif not stuck:
        yield "Rigid facets may fold in the assigned sense to first order, but no folded state was found."
    if stuck:
        yield f"At {_places(stuck)} rigid facets cannot leave the flat state in the assigned sense: they have to bend."
    if freedoms.folded is not None and freedoms.folded.mechanisms < freedoms.rigid.mechanisms:
        yield "The flat sheet has more first-order motions than finite ones; the folded state has only the finite ones."


def _fold_range(freedoms: Freedoms) -> str:
    least, most = (f"{math.degrees(angle):.0f}" for angle in freedoms.fold_range or (0.0, 0.0))
    return f"{least} deg" if least == most else f"{least} to {most} deg"


def _places(vertices: Sequence[int]) -> str:
    """Return the first few vertices as text."""
    shown = ", ".join(map(str, vertices[:_MOST_NAMED]))
    more = f" and {len(vertices) - _MOST_NAMED} more" if len(vertices) > _MOST_NAMED else ""
    return f"{'vertex' if len(vertices) == 1 else 'vertices'} {shown}{more}"


def _columns(*headings: str) -> Table:
    """Return a table without lines whose first column is text."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in headings:
        table.add_column(heading)
    return table


def _counted(count: int, one: str, many: str | None = None) -> str:
    return f"{count} {one if count == 1 else many or f'{one}s'}"
