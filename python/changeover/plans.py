"""Run sheets: which tests to make, in which order, for the least cost."""

from __future__ import annotations

import datetime
import importlib
import json
import os
from decimal import Decimal
from fractions import Fraction
from typing import Any, Dict, Iterable, List, Literal, Mapping, Optional, Tuple, Union, overload

from . import _core
from ._job import benches_of, document_of, names_in, result_of
from ._given import day_of, listed, of_search
from ._made import Made, Progress, check_calls, count_of, fact, made
from ._notebook import Shown
from .errors import BadInput
from .pictures import Picture, Theme, stays_of

Cost = Union[int, float, str, Decimal]
Part = Union[str, int]
Pair = Tuple[Part, Part]
Parts = Union[int, Iterable[Part], Mapping[Any, Cost], "os.PathLike[str]"]
Room = Union[int, Tuple[Optional[int], Optional[int]]]
Result = Union[bool, str, None]
CostUnit = Literal["money", "seconds", "minutes", "hours"]
Benches = Union[int, Iterable[Union[str, Mapping[str, Any]]]]
Day = Union[str, datetime.date]
Objective = Literal["makespan", "cost", "tests"]
Model = Union[str, "os.PathLike[str]"]


def _decimal(amount: Any) -> Decimal:
    """Exact, without decimals or with two at least."""
    whole = int(amount)
    if whole == amount:
        return Decimal(whole)
    text = str(amount).rstrip("0")
    return Decimal(text + "0" * (2 - len(text.partition(".")[2])))


def _step(step: Dict[str, Any]) -> Dict[str, Any]:
    return {"number": step["step"], "take_out": step["take_out"], "put_in": step["put_in"],
            "setup": step["set_up"], "places": step["places"],
            **({"values": step["values"]} if "values" in step else {}),
            "cost": _decimal(step["cost"]), "cost_so_far": _decimal(step["cost_so_far"])}


def _bench_step(step: Dict[str, Any]) -> Dict[str, Any]:
    """With the times of the step, of which some are in hours of a day."""
    return {**_step(step),
            **{key: _decimal(step[key]) for key in ("begin", "end", "hour") if key in step},
            **{key: step[key] for key in ("day", "date", "finish", "again") if key in step}}


class Answer(Dict[str, Any]):
    """A dict, with the document that it was made of."""

    _text = ""

    def __init__(self, entries: Dict[str, Any], text: str) -> None:
        super().__init__(entries)
        self._text = text

    def to_json(self) -> str:
        """The document that the command line writes with --json."""
        return self._text

    def __reduce__(self) -> Any:
        return Answer, (dict(self), self._text)


class _Sheets(Shown, Made):
    """What the run sheets of one bench and of several have in common."""

    _columns: Tuple[str, ...] = ("number", "take_out", "put_in", "setup", "places", "cost", "cost_so_far")

    tests: int = fact("Of all benches.")
    changes: int = fact("Of all benches.")
    complete: bool = fact(
        "All that must meet does, on one bench or another; a budget may not pay for it.")
    pairs_tested: int = fact("Of the pairs that must meet.")
    pairs_needed: int = fact("Pairs that must meet.")
    triples_tested: int = fact("Of three parts that must meet, with strength 3.")
    triples_needed: int = fact("Triples that must meet, with strength 3.")
    cost: Decimal = fact("Exact, of all benches.")
    lower_bound: Decimal = fact("No list of tests that does the job costs less.")
    reason: str = fact("Of the bound.")
    why_stopped: str = fact(
        "'found' (nothing better is possible), 'step limit' (it ended by itself), 'time limit' or "
        "'interrupted'.")
    interrupted: bool = fact("Ctrl-C ended the search.")
    candidates: List[Dict[str, Any]] = fact(
        "What it was compared with, the best first: dicts with name, how, tests, changes, cost, "
        "and of several benches makespan.")
    notes: List[str] = fact(
        "What else is to be said of the job, a line each: results that are not understood, pairs "
        "that cannot meet.")

    def _kept(self) -> Any:
        return self._core.state()

    @classmethod
    def _core_again(cls, kept: Any, facts: Dict[str, Any]) -> Any:
        """Counted again: the request and the set-ups must give what the pickle says."""
        try:
            core = _core.Planned.again(kept)
        except (BadInput, RuntimeError, TypeError) as fault:
            raise BadInput(f"another version of changeover pickled this {cls.__name__}, which "
                           f"does not fit this one: {fault}; create it again")
        if _facts(core) != facts:
            raise BadInput(f"another version of changeover pickled this {cls.__name__}, and "
                           "counted it differently; create it again")
        return core

    def _rows(self) -> List[Dict[str, Any]]:
        """The tests, in the order in which they are made."""
        raise NotImplementedError

    def to_frame(self) -> Any:
        """A pandas.DataFrame with one row for each test, by its number or, of several benches, by
        bench and number. Raises ImportError without pandas."""
        pandas: Any = importlib.import_module("pandas")
        rows = self._rows()
        columns = list(rows[0]) if rows else list(self._columns)
        keys = [name for name in ("bench", "number") if name in columns]
        return pandas.DataFrame(rows, columns=columns).set_index(keys if keys[1:] else keys[0])

    def _panels(self) -> List[Tuple[str, str, List[Dict[str, Any]]]]:
        """For each bench headline, note, tests."""
        raise NotImplementedError

    def draw(self, *, theme: Theme = "light") -> Picture:
        """A picture: a row for each part, a bar for each time that it is on the bench, test by
        test; benches below each other. Raises BadInput if there is no test."""
        panels = []
        for headline, note, steps in self._panels():
            places: Dict[str, int] = {}
            tests = [[places.setdefault(part, len(places)) for part in step["setup"]]
                     for step in steps]
            if tests:
                panels.append((headline, note, list(places), tests))
        if not panels:
            raise BadInput("there is no test to draw")
        return stays_of(panels, "part", "test", theme)

    def _repr_svg_(self) -> Optional[str]:
        most_tests, most_parts = 300, 100
        steps = [step for _, _, steps in self._panels() for step in steps]
        parts = {part for step in steps for part in step["setup"]}
        if not 0 < len(steps) <= most_tests or len(parts) > most_parts:
            return None
        return self.draw().svg

    def _on_page(self) -> Any:
        rows = self._rows()
        heads = [key for key in ("bench", "number", "take_out", "put_in", "setup", "cost_so_far")
                 if rows and key in rows[0]]
        lines = [f"at least {self.lower_bound}: {self.reason}", *self.notes]
        return (repr(self)[1:-1], lines, [head.replace("_", " ") for head in heads],
                ([row[head] for head in heads] for row in rows), len(rows))

    def to_csv(self) -> str:
        """CSV, one line for each test."""
        return self._written("csv")

    def to_html(self) -> str:
        """A page of HTML that prints well."""
        return self._written("html")

    def to_json(self) -> str:
        """The document that the command line writes with --json, byte for byte."""
        return self._written("json")

    def to_markdown(self) -> str:
        """A table in Markdown."""
        return self._written("markdown")

    def to_text(self) -> str:
        """The table that the command line prints."""
        return self._written("table")

    def to_xlsx(self) -> bytes:
        """The bytes of a workbook."""
        workbook: bytes = self._core.written("xlsx")
        return workbook

    def request_json(self) -> str:
        """What was asked, as the document that `changeover plan --request` reads."""
        text: str = self._core.request_json()
        return text

    def _written(self, format: str) -> str:
        text: bytes = self._core.written(format)
        return text.decode()


class RunSheet(_Sheets):
    """A run sheet, counted by code that shares nothing with what made it."""

    steps: List[Dict[str, Any]] = fact(
        "A dict for each test: number, take_out, put_in, setup (names), places, cost, cost_so_far; "
        "of a model also values, a dict from parameters to their values. "
        "places is what is mounted in each of RunSheet.places, None where nothing is: a part that "
        "stays keeps its place, also if these are given as done, (places, result).")
    places: List[Dict[str, Any]] = fact(
        "The places of the bench: dicts with number and slot (None if it is of no slot).")
    met_only_in_failed: int = fact(
        "Pairs (triples with strength 3) that met only in tests that failed or whose result is "
        "not understood.")
    cheapest: bool = fact("Proved: nothing is cheaper.")
    fewest: Optional[bool] = fact("Proved: nothing has fewer tests; None if there is no model.")

    def what_if(
        self, *, time: Optional[float] = None, threads: int = 1, seed: int = 1,
        progress: Progress = None,
    ) -> Answer:
        """Which plan is cheapest when changes cost more or less relative to tests, and where it
        breaks even.

        A dict: ranges, by ratio of the cost of a change to that of a test (of a factor of all
        change costs, if these differ: by_factor) without gaps, each with from and to (Fractions;
        None: from 0, without end), name, how, tests, changes and setups; asked, where the sheet
        stands (None if tests cost nothing); interrupted. time: seconds; None: a fixed amount of
        search for each ratio.

        Raises BadInput if costs depend on what is replaced.
        """
        text: str = self._core.what_if(time, threads, seed, progress)
        said: Dict[str, Any] = json.loads(text)

        def ratio(exactly: Optional[str]) -> Optional[Fraction]:
            return None if exactly is None else Fraction(exactly)

        ranges = [{"from": ratio(each["from_exact"]), "to": ratio(each["to_exact"]),
                   **{key: each["plan"][key] for key in ("name", "how", "tests", "changes")},
                   "setups": each["plan"]["set_ups"]} for each in said["ranges"]]
        return Answer({"by_factor": said["by"].startswith("factor"),
                       "asked": ratio(said["asked_exact"]), "ranges": ranges,
                       "interrupted": said["why_stopped"] == "interrupted"}, text)

    def diagnose(self,
        results: Iterable[Union[Result,
                                Tuple[Iterable[Part], Union[bool, str]]]]) -> Answer:
        """Which faults explain the results, and the one test to run next.

        results: for each of the first tests of the sheet True if it passed, False if it failed,
        None if nothing is known, or a text such as 'FAILED - hang'; or tuples (set-up, result) for
        tests of other set-ups.

        A dict: passed, failed; unread, the texts that are not understood, each with its place in
        results; faults, which are proven, each a tuple of one part or of two that do not work
        together; suspects, each of which explains all by itself; at_least, how many faults are
        needed; explanations, sets of so many that explain all together, tuples of faults, at most
        100 of explanations_known, which are all if all_explanations; looked_at, the failed test
        whose suspects these are where more faults are needed than are looked for together (else
        None); contradictions, (what failed, what passed though it had all of it, or None); next,
        the test to run next (None: none tells more), a dict with setup, take_out, put_in, places
        (numbers to parts or None), cost, proves (the fault that it proves if it fails, or None),
        why, if_it_fails and if_it_passes (left, their number, and explanations); least_tests, so
        many may be needed whatever is asked. Run it, add its result, and ask again. Raises
        BadInput for other results.
        """
        wanted = ("results has True (passed), False (failed), None or a text for each of the first "
                  "tests, or (set-up, result)")
        steps = self.steps
        tested: List[Tuple[List[str], bool]] = []
        unread = []
        of_sheet = 0
        for place, result in enumerate(
                listed("results", "a result for each test", results, True)):
            setup: Any = None
            if isinstance(result, tuple):
                if len(result) != 2:
                    raise BadInput(wanted)
                setup, result = result
                setup = names_in("results", setup)
                self._core.check_parts(setup)
            elif of_sheet == len(steps):
                raise BadInput(
                    "results has more entries than the sheet has tests; give at most one per test"
                )
            else:
                of_sheet += 1
            said = result_of(result)
            if said is None or (result is None and setup is not None):
                raise BadInput(wanted)
            read = _core.read_as("result", said)
            if read in ("pass", "fail"):
                tested.append((steps[of_sheet - 1]["setup"] if setup is None else setup,
                               read == "fail"))
            elif read == "unread":
                unread.append((place, result))
        text: str = self._core.diagnose(tested)
        found: Dict[str, Any] = json.loads(text, parse_float=Decimal)

        def suspects(all_of_them: List[List[str]]) -> List[Tuple[str, ...]]:
            return [tuple(each) for each in all_of_them]

        def sets(all_of_them: List[List[List[str]]]) -> List[Tuple[Tuple[str, ...], ...]]:
            return [tuple(suspects(each)) for each in all_of_them]

        def after(result: Dict[str, Any]) -> Dict[str, Any]:
            return {"left": result["left"], "explanations": sets(result["explanations"])}

        then: Optional[Dict[str, Any]] = found["next"]
        return Answer({
            **{key: found[key] for key in ("passed", "failed", "at_least", "explanations_known",
                                           "all_explanations", "looked_at", "least_tests")},
            "faults": suspects(found["faults"]), "suspects": suspects(found["suspects"]),
            "explanations": sets(found["explanations"]),
            "contradictions": [(each["failed"], each["passed"])
                               for each in found["contradictions"]],
            "next": then and {
                "setup": then["set_up"], "take_out": then["take_out"], "put_in": then["put_in"],
                "places": {each["number"]: each["part"] for each in then["places"]},
                "cost": _decimal(then["cost"]), "why": then["why"],
                "proves": then["proves"] and tuple(then["proves"]),
                "if_it_fails": after(then["if_it_fails"]),
                "if_it_passes": after(then["if_it_passes"])}, "unread": unread}, text)

    def _rows(self) -> List[Dict[str, Any]]:
        return self.steps

    def _panels(self) -> List[Tuple[str, str, List[Dict[str, Any]]]]:
        return [("Run sheet", repr(self)[len("<RunSheet: "):-1], self.steps)]

    def __len__(self) -> int:
        return self.tests

    def __repr__(self) -> str:
        return (f"<RunSheet: {count_of(self.tests, 'test')}, {count_of(self.changes, 'change')}, "
                f"cost {self.cost}>")


class BenchSheets(_Sheets):
    """Run sheets for several benches, counted by code that shares nothing with what made them."""

    sheets: List[List[Dict[str, Any]]] = fact(
        "For each bench a list of its tests, as RunSheet.steps, and begin and end, when; with "
        "hours a day also day and hour, date if the first day is known; again, parts that stayed "
        "and were lent to another bench meanwhile.")
    _columns = ("bench", *_Sheets._columns, "begin", "end")

    benches: List[str] = fact("The name of each bench.")
    makespan: Decimal = fact(
        "When the last test ends; where no bench waits or rests, the cost of the bench that costs "
        "most. Exact.")
    makespan_bound: Decimal = fact("Nothing is done earlier.")
    makespan_reason: str = fact("Of that bound.")
    finish: Optional[Dict[str, Any]] = fact(
        "With hours a day: day, hour (in the unit of costs) and, if the first day is known, date "
        "of the end; else None.")

    def _rows(self) -> List[Dict[str, Any]]:
        return [{"bench": bench, **step} for bench, sheet in zip(self.benches, self.sheets)
                for step in sheet]

    def _panels(self) -> List[Tuple[str, str, List[Dict[str, Any]]]]:
        return [(bench, count_of(len(sheet), "test"), sheet)
                for bench, sheet in zip(self.benches, self.sheets)]

    def __len__(self) -> int:
        return len(self.sheets)

    def __repr__(self) -> str:
        return (f"<BenchSheets: {count_of(len(self), 'bench', 'benches')}, "
                f"{count_of(self.tests, 'test')}, makespan {self.makespan}>")


def _facts(core: Any) -> Dict[str, Any]:
    """What the document of an answer says, under the names that it has in Python."""
    said: Dict[str, Any] = json.loads(core.written("json"), parse_float=Decimal)
    bound = said["lower_bound"]
    facts = {
        **said, "complete": core.complete, "interrupted": said["why_stopped"] == "interrupted",
        "cost": _decimal(said["cost"]),
        "lower_bound": _decimal(bound["cost"]), "candidates": [
            {key: _decimal(each[key]) if key in ("cost", "makespan") else each[key]
             for key in ("name", "how", "tests", "changes", "cost",
                         "makespan") if key in each} for each in said["candidates"]]}
    if "sheets" not in said:
        return {**facts, "steps": [_step(step) for step in said["steps"]],
                "reason": bound["reason"],
                "cheapest": said["proved_cheapest"], "fewest": said.get("proved_fewest_tests")}
    return {**facts,
            "sheets": [[_bench_step(step) for step in sheet["steps"]] for sheet in said["sheets"]],
            "benches": [sheet["name"] for sheet in said["sheets"]],
            "finish": said.get("finish"),
            "reason": bound["cost_reason"], "makespan": _decimal(said["makespan"]),
            "makespan_bound": _decimal(bound["makespan"]),
            "makespan_reason": bound["makespan_reason"]}


@overload
def plan(
    parts: Optional[Parts] = None, at_once: Optional[int] = None, *,
    model: Optional[Model] = None, test_cost: Optional[Cost] = None,
    change_cost: Optional[Cost] = None, change_costs: Optional[Mapping[Any, Cost]] = None,
    cost_column: Optional[str] = None, cost_unit: Optional[CostUnit] = None, strength: int = 2,
    pairs: Any = None, never: Any = (), slots: Optional[Mapping[str, Room]] = None,
    slot_of: Optional[Mapping[Any, str]] = None, mounted: Any = (), start: Any = (),
    first: Any = (), weights: Optional[Mapping[Pair, Cost]] = None, done: Any = (),
    trust_failed: bool = False, budget: Optional[Cost] = None, benches: None = None,
    objective: Optional[Objective] = None, time: Optional[float] = None, threads: int = 1,
    seed: int = 1, progress: Progress = None, done_first: Optional[int] = None,
    shuffle: Optional[int] = None, title: Optional[str] = None, compact: bool = False,
    steps: Optional[int] = None, without: Iterable[Part] = (),
    quantities: Optional[Mapping[Any, int]] = None, hours: Optional[Cost] = None,
    first_day: Optional[Day] = None, weekends: bool = False,
) -> RunSheet: ...
@overload
def plan(
    parts: Optional[Parts] = None, at_once: Optional[int] = None, *,
    model: Optional[Model] = None, test_cost: Optional[Cost] = None,
    change_cost: Optional[Cost] = None, change_costs: Optional[Mapping[Any, Cost]] = None,
    cost_column: Optional[str] = None, cost_unit: Optional[CostUnit] = None, strength: int = 2,
    pairs: Any = None, never: Any = (), slots: Optional[Mapping[str, Room]] = None,
    slot_of: Optional[Mapping[Any, str]] = None, mounted: Any = (), start: Any = (),
    first: Any = (), weights: Optional[Mapping[Pair, Cost]] = None, done: Any = (),
    trust_failed: bool = False, budget: Optional[Cost] = None, benches: Benches,
    objective: Optional[Objective] = None, time: Optional[float] = None, threads: int = 1,
    seed: int = 1, progress: Progress = None, done_first: Optional[int] = None,
    shuffle: Optional[int] = None, title: Optional[str] = None, compact: bool = False,
    steps: Optional[int] = None, without: Iterable[Part] = (),
    quantities: Optional[Mapping[Any, int]] = None, hours: Optional[Cost] = None,
    first_day: Optional[Day] = None, weekends: bool = False,
) -> BenchSheets: ...


def plan(
    parts: Optional[Parts] = None, at_once: Optional[int] = None, *,
    model: Optional[Model] = None, test_cost: Optional[Cost] = None,
    change_cost: Optional[Cost] = None, change_costs: Optional[Mapping[Any, Cost]] = None,
    cost_column: Optional[str] = None, cost_unit: Optional[CostUnit] = None, strength: int = 2,
    pairs: Any = None, never: Any = (), slots: Optional[Mapping[str, Room]] = None,
    slot_of: Optional[Mapping[Any, str]] = None, mounted: Any = (), start: Any = (),
    first: Any = (), weights: Optional[Mapping[Pair, Cost]] = None, done: Any = (),
    trust_failed: bool = False, budget: Optional[Cost] = None, benches: Optional[Benches] = None,
    objective: Optional[Objective] = None, time: Optional[float] = None, threads: int = 1,
    seed: int = 1, progress: Progress = None, done_first: Optional[int] = None,
    shuffle: Optional[int] = None, title: Optional[str] = None, compact: bool = False,
    steps: Optional[int] = None, without: Iterable[Part] = (),
    quantities: Optional[Mapping[Any, int]] = None, hours: Optional[Cost] = None,
    first_day: Optional[Day] = None, weekends: bool = False,
) -> Union[RunSheet, BenchSheets]:
    """The cheapest list of tests that was found in which every two parts are mounted together at
    least once.

    parts: how many, a list of names, or a dict from names to what it costs to mount them; at_once
    of them fit (None: as many as the slots hold). Costs are numbers, Decimals or strings, and
    exact. Or parts is the path of a parts list or a workbook, as the command line reads it: a
    workbook may have slots, forbidden pairs and the like on sheets of these names, and one that
    was made as a run sheet has the question that it was made for, which is then planned again with
    the results that were filled in; notes say what was taken from where.

    change_cost: of a part whose cost is not given. change_costs: a dict from (out, in) to the cost
    of putting in one part where the other was taken out, for every two parts. cost_column: the head
    of the column of a file that has the change costs, '-' for none (None: found by its words).
    cost_unit: 'minutes' and the like if all costs are times, for a clock on the sheets. strength:
    2, every two parts must meet, or 3, every three. pairs: only these must; never: these must not,
    (a, b) or (a, b, why). slots: a dict from the name of a slot to how many of its parts a set-up
    has, a number or (least, most), None for no limit, with slot_of, a dict from parts to their
    slots; parts that cannot meet then need not. mounted: parts that stay; start: parts that are
    mounted before the first test; first: set-ups that must be run first; weights: a dict from pairs
    to what testing them is worth (others 1); done: tests that were done, lists of names, each alone
    or as (names, result), where result is True (passed), False (failed), None or a text such as
    'FAILED - hang'. Pairs that met only in tests that failed, or whose text is not understood, are
    needed again, unless trust_failed. budget: test as much as it pays for. benches: how many work
    side by side, or a name or a dict for each, which gives BenchSheets, else it is a RunSheet; a
    dict has any of name, at_once, test_cost, change_factor, slots, mounted, start, own (parts of
    which it has its own piece), without (parts that it cannot have), hours (of work a day) and
    down. objective: 'makespan' (None), the last test ends as early as can be, or 'cost', of all of
    them. quantities: a dict from parts to how many there are, for all benches and for slots that
    need several; of others there is one, without quantities one for each bench. hours: of work a
    day on benches that say nothing else, with costs in hours; first_day: of the first tests, as
    '2025-03-31'; weekends: they are worked on. With benches, done and first may have dicts with
    parts, bench and result. without: parts that broke; other arguments may name them. time: seconds
    of search; None: a fixed amount of it, or steps, moves of each local search. done_first: how
    many of done, from the first on, were done. shuffle: a seed with which interchangeable parts are
    swapped. title, compact: of what is written.

    model: instead of parts and at_once, parameters with their values and rules in the language of
    PICT or ACTS, a string, or a file as a pathlib.Path. Every test then has one value of each
    parameter, and all values of different parameters meet that the rules allow. Parts are the
    values, 'Debian' or 'OS: Debian'; set-ups in first and done may be dicts from parameters to
    values, and lack some in first. change_costs: a dict from 'OS', ('OS', 'Debian') or
    ('OS', 'Debian', 'Fedora'), Fedora in place of Debian, to costs; ('OS', 'Debian', 'quantity')
    is how many benches can have Debian at once. objective: 'cost' (None), or 'tests', the fewest
    tests, which asks for no costs: on one bench then at the least cost, on several, of all of them
    together, done as early as can be.

    Raises BadInput with the reason if no list can do it.
    """
    given = locals()
    document = document_of(given)
    if benches is not None:
        document["benches"] = benches_of(benches)
    for argument in ("at_once", "cost_column", "cost_unit", "strength", "objective", "done_first",
                     "shuffle", "steps"):
        if given[argument] is not None:
            document[argument] = given[argument]
    document.update({key: value for key,
        value in (("trust_failed", trust_failed), ("compact", compact), ("title", title),
                  ("first_day", first_day and day_of("first_day", first_day)),
                  ("weekends", weekends)) if value})
    document.update(of_search(time, threads, seed))
    core = _core.Planned.of(json.dumps(document), progress)
    facts = _facts(core)  # What a workbook asks for may be of several benches.
    return made(BenchSheets, facts, core) if "sheets" in facts else made(RunSheet, facts, core)


check_calls(globals())
