"""Jobs as Python tells them, made into the document "changeover-job/1"."""

from __future__ import annotations

import csv
import io
import itertools
import json
import operator
import os
import re
from collections.abc import Mapping
from decimal import Decimal
from typing import Any, Iterable, Iterator, NoReturn, Optional

from . import _core
from ._given import (
    attempt, has_numbered_rows, is_bytes, is_data_frame, is_missing, is_text, is_whole,
    leads_from_keys, listed, rows_of, truth_of, words_of)
from .errors import BadInput

_most_parts = 1000
_most_rows = 1 << 22  # as in a file
_wanted_of_done = ("done has set-ups, lists of parts, each alone or as (set-up, result), where "
                   "result is True, False, None or a text")


def _written_out(value: Any) -> str:
    """A number as it is written, without an exponent."""
    words = words_of(value)
    if not is_text(value) and re.fullmatch(r"-?[0-9.]+[eE][+-]?[0-9]{1,2}", words):
        words = format(Decimal(words), "f")
    return words


def _count(value: Any) -> str:
    """A count as it is written; pandas makes floats of whole numbers where one is missing."""
    is_whole_float = not is_text(value) and attempt(float.is_integer, value)
    return str(int(value)) if is_whole_float else words_of(value)


def _amount(argument: str, value: Any) -> str:
    """Numbers, strings and decimals alike, exactly as they are written."""
    words = _written_out(value)
    _core.check_amount(argument, words)
    return words


def names_in(argument: str, parts: Any) -> list[str]:
    names: list[str] = []
    for part in listed(argument, "parts", parts):
        if len(names) > _most_parts:
            raise BadInput(f"{argument} names more parts than there are")
        names.append(words_of(part))
    return names


def _in_places(setup: Any) -> list[Optional[str]]:
    """A set-up that was done: parts in the order of their places, None where nothing was."""
    parts: list[Optional[str]] = []
    for part in listed("done", "parts", setup):
        if len(parts) > _most_parts:
            raise BadInput("done names more parts than there are")
        parts.append(None if is_missing(part) else words_of(part))
    return parts


def _rows(argument: str, rows: Iterable[Any]) -> Iterator[Any]:
    for number, row in enumerate(rows):
        if number == _most_rows:
            raise BadInput(f"{argument} has more than 4194304 rows; remove repetitions")
        yield row


def _pair(argument: str, pair: Any) -> list[str]:
    names = names_in(argument, pair)
    if len(names) != 2 or names[0] == names[1]:
        raise BadInput(f"{argument} has a pair that is not two different parts; correct it")
    return names


def _pairs(argument: str, pairs: Any) -> list[list[str]]:
    listed_pairs = [_pair(argument, pair)
                    for pair in _rows(argument, rows_of(argument, "pairs of parts", pairs))]
    if not listed_pairs:
        raise BadInput(f"{argument}: no pair is listed; give (a, b) for each")
    return listed_pairs


def _forbidden(pairs: Any) -> list[list[str]]:
    """Pairs, or (a, b, why)."""
    forbidden = []
    for row in _rows("never", rows_of("never", "pairs of parts", pairs)):
        names = names_in("never", row)
        if len(names) not in (2, 3) or names[0] == names[1]:
            raise BadInput("never has a row that is not two different parts; give (a, b) or "
                           "(a, b, why)")
        forbidden.append(names)
    return forbidden


def _items(argument: str, value: Any) -> list[tuple[Any, Any]]:
    """What is in a dict now: to read it runs code of the caller, which may change it."""
    if not leads_from_keys(value):
        raise TypeError(f"{argument} is a dict, not {_core.quoted(words_of(repr(value)))}")
    return list(value.items())


def result_of(result: Any) -> Optional[str]:
    """'pass', 'fail', '' (nothing is known) or a text; None for what is not a result."""
    if is_missing(result):
        return ""
    if isinstance(result, bool) or getattr(getattr(result, "dtype", None), "kind", "") == "b":
        return "pass" if result else "fail"
    return words_of(result) if isinstance(result, str) else None


def _done_setup(setup: Any, of_model: bool) -> Any:
    if of_model and isinstance(setup, Mapping):
        return _setup("done", setup, of_model)
    return _in_places(setup)


def _test(test: Any, of_model: bool) -> Any:
    if of_model and isinstance(test, Mapping) and "parts" not in test:
        return _done_setup(test, of_model)
    bench: dict[str, str] = {}
    if isinstance(test, Mapping):
        if not {"parts"} <= test.keys() <= {"parts", "result", "bench"}:
            raise BadInput('a dict in done has "parts", and may have "result" and "bench"; '
                           "remove other keys")
        bench = _bench_of(test)
        if "result" not in test:
            names = _done_setup(test["parts"], of_model)
            return {"parts": names, **bench} if bench else names
        setup, result = test["parts"], test["result"]
    elif (isinstance(test, tuple) and len(test) == 2 and hasattr(type(test[0]), "__iter__")
          and not is_text(test[0])):
        setup, result = test
    else:
        return _in_places(test)
    said = result_of(result)
    if said is None:
        raise BadInput(f"{_wanted_of_done}, not {_core.quoted(words_of(repr(result)))}")
    return {"parts": _done_setup(setup, of_model), "result": said, **bench}


def _bench_of(setup: Mapping[str, Any]) -> dict[str, str]:
    """On which bench a set-up is, by name or number, if that is said."""
    bench = setup.get("bench")
    return {} if is_missing(bench) else {"bench": words_of(bench)}


def _first(setup: Any, of_model: bool) -> Any:
    if of_model or not isinstance(setup, Mapping):
        return _setup("first", setup, of_model)
    if not {"parts"} <= setup.keys() <= {"parts", "bench"}:
        raise BadInput('a dict in first has "parts", and may have "bench"; remove other keys')
    return {"parts": names_in("first", setup["parts"]), **_bench_of(setup)}


_of_benches = {
    "name": "words", "at_once": "count", "test_cost": "amount", "change_factor": "amount",
    "slots": "slots", "mounted": "names", "start": "names", "own": "names", "without": "names",
    "hours": "amount", "down": "choice"}


def _bench(given: Any) -> Any:
    """A bench by its name, or as a dict of what it does not have from the job."""
    if not leads_from_keys(given):
        return {"name": _part_named(given, "benches")}
    bench: dict[str, Any] = {}
    for key, value in given.items():
        kind = _of_benches.get(key)
        argument = f"benches: {key}"
        if kind is None:
            raise BadInput(f"a dict in benches has the keys {', '.join(_of_benches)} only; remove "
                           f"{_core.quoted(words_of(key))}")
        if is_missing(value):
            continue
        if kind == "names":
            bench[key] = names_in(argument, value)
        elif kind == "slots":
            bench[key] = [_slot(words_of(name), room) for name, room in _items(argument, value)]
        elif kind == "amount":
            bench[key] = _amount(argument, value)
        elif kind == "choice":
            bench[key] = truth_of(argument, value)
        elif kind == "count":
            bench[key] = _count(value)
        else:
            bench[key] = words_of(value)
    return bench


def _benches_listed(given: Any) -> Iterable[Any]:
    """Of a table of columns a dict for each row."""
    if not is_data_frame(given):
        return listed("benches", "names or dicts", given, True)
    if not has_numbered_rows(given):
        raise TypeError("benches: the index of the DataFrame would be lost; give reset_index() of "
                        "it")
    heads = list(map(words_of, given.columns))
    rows: Iterable[Any] = given.itertuples(index=False, name=None)
    return (dict(zip(heads, row)) for row in rows)


def benches_of(given: Any) -> Any:
    """How many benches that are alike, or one after another."""
    if is_whole(given):
        return operator.index(given)
    rows = [_bench(bench)
            for bench in _rows("benches", _benches_listed(given))]
    if not rows:
        raise BadInput("benches names none; give how many, or a name or dict for each")
    return rows


def _slot(name: str, room: Any) -> dict[str, Any]:
    def refuse() -> NoReturn:
        raise BadInput(f"slots says how many parts are in {_core.quoted(name)}: a number, or "
                       "(least, most) with None for no limit, not "
                       f"{_core.quoted(words_of(repr(room)))}")

    def number(given: Any) -> str:
        if not is_whole(given) or not 0 <= operator.index(given) < 1 << 64:
            refuse()
        return str(operator.index(given))

    if is_whole(room):
        return {"name": name, "least": number(room), "most": number(room)}
    try:
        limits = list(itertools.islice(listed("slots", "limits", room, True), 3))
    except TypeError:
        refuse()
    if len(limits) != 2:
        refuse()
    return {"name": name, **{key: number(limit) for key, limit in zip(("least", "most"), limits)
                             if limit is not None}}


def _table(costs: Any) -> list[list[str]]:
    """What a change costs by what is replaced: a dict from (out, in) to costs, as a square table
    with its heads."""
    by_pair: dict[tuple[str, str], str] = {}
    heads: dict[str, None] = {}
    for pair, cost in _items("change_costs", costs):
        out, into = _pair("change_costs", pair)
        heads.update({out: None, into: None})
        if len(heads) > _most_parts:
            raise BadInput(f"change_costs names more than {_most_parts} parts; give fewer")
        by_pair[out, into] = _amount("change_costs", cost)
    return [["", *heads],
            *([out, *(by_pair.get((out, into), "") for into in heads)] for out in heads)]


def _check_columns(columns: list[Any]) -> None:
    """Refuses a column that would be dropped, or read as something else than it says."""
    headings = [words_of(column) for column in columns]
    if len(columns) <= 2 and all(hasattr(type(column), "__index__") for column in columns):
        return  # names and costs, without a heading
    of: dict[str, list[str]] = {"name": [], "slot": [], "cost": [], "quantity": [], "": []}
    for heading in headings:
        of[_core.read_as("heading", heading)].append(heading)
    others = of[""]
    if not of["name"] and others:
        of["name"].append(others.pop(0))
    if not of["name"]:
        raise BadInput("parts: no column has the names; call one of them name")
    others += [heading for key in ("name", "slot", "cost", "quantity")
               for heading in of[key][1:]]
    if others:
        raise BadInput(f"parts: the column {_core.quoted(others[0])} is not read; leave it out, or "
                       "have one column each called name, cost, slot and quantity")


def _parts_in_columns(frame: Any) -> list[dict[str, str]]:
    """A table of columns is read as a file of it would be: the same headers, the same refusals."""
    index = frame.index
    has_names = any(
        _core.read_as("heading", words_of(column)) == "name" for column in frame.columns
    )
    # Rows that were left out leave numbers that say nothing.
    says_nothing = type(index).__name__ == "RangeIndex" or (has_names and has_numbered_rows(frame))
    if index.name is not None or not says_nothing:
        if hasattr(index, "levels"):
            raise TypeError("parts: an index of several levels; give reset_index() of it")
        frame = frame.rename_axis(("index" if has_names else "name") if index.name is None
                                  else index.name)
        frame = frame.reset_index()  # The names are beside the columns.
    _check_columns(list(frame.columns))
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(frame.columns)
    readers = [{"quantity": _count, "cost": _written_out}.get(
        _core.read_as("heading", words_of(column)), words_of) for column in frame.columns]
    rows = [["" if is_missing(field) else read(field) for read, field in zip(readers, row)]
            for row in frame.itertuples(index=False, name=None)]
    writer.writerows(rows)
    parts: list[dict[str, str]] = json.loads(_core.read_as("parts", words_of(text.getvalue())))
    if any(all(field == "" for field in row) for row in rows):
        raise BadInput("parts: a row without a name; name the part")
    return parts


def _part_named(part: Any, argument: str = "parts") -> str:
    """What has items inside is not a name, nor is what is missing."""
    if not is_text(part) and (is_bytes(part) or hasattr(type(part), "__iter__")
                              or is_missing(part)):
        shown = _core.quoted(words_of(repr(part)))
        raise TypeError(f"{argument} has names, texts or numbers, not {shown}")
    return words_of(part)


def _parts_one_by_one(given: Any) -> list[dict[str, str]]:
    if not leads_from_keys(given):
        rows: Iterable[Any] = ((part, None)
            for part in listed("parts", "names, or their number", given, True))
    elif hasattr(given, "index") and has_numbered_rows(given):
        raise TypeError("parts is a Series with numbers as its index; give list(...) of it if its "
                        "values are names, to_dict() of it if they are costs")
    else:
        rows = list(given.items())
    has_costs = leads_from_keys(given)
    parts: list[dict[str, str]] = []
    for part, cost in rows:
        if len(parts) > _most_parts:
            break  # one too many, which is refused
        parts.append({"name": _part_named(part)})
        if has_costs:
            parts[-1]["cost"] = _amount("parts", cost)
    return parts


def _parts(given: Any, slots: Any, slot_of: Any, quantities: Any, needs_costs: bool) -> Any:
    """The parts by number, by name, or by name with their costs, slots and quantities; or the
    file of them."""
    if isinstance(given, os.PathLike):
        for argument, said in (("slot", slot_of), ("quantity", quantities)):
            if said is not None:
                given_twice = "slot_of" if argument == "slot" else "quantities"
                raise BadInput(f"parts is a file, whose column {argument} says what {given_twice} "
                               "would; leave it out")
        return {"file": words_of(os.fsdecode(given))}
    if is_whole(given):
        count = operator.index(given)
        if slot_of is None and quantities is None:
            return count
        parts = [{"name": str(number)} for number in range(1, min(count, _most_parts + 1) + 1)]
    else:
        parts = _parts_in_columns(given) if is_data_frame(given) else _parts_one_by_one(given)
        if not parts:
            raise BadInput("parts: no part is listed; give a name for each")
    has_column = any("slot" in part for part in parts)
    if has_column and slot_of is not None:
        raise BadInput("parts has a column slot, and slot_of says the same; give one of them")
    if (slots is None) == (has_column or slot_of is not None):
        raise BadInput(
            "parts has a column slot; give slots, how many parts each has, or leave the column out"
            if has_column else "slots (how many parts a slot has) and slot_of (the slot of each "
            "part) belong together; give both")
    by_name = {part["name"]: part for part in parts}
    for argument, key, said in (("slot_of", "slot", slot_of),
                                ("quantities", "quantity", quantities)):
        for part, value in _items(argument, said) if said is not None else ():
            name = words_of(part)
            if name not in by_name:
                raise BadInput(
                    f"{argument}: there is no part {_core.quoted(name)}; give a name that "
                    "parts has"
                )
            by_name[name][key] = _count(value) if key == "quantity" else words_of(value)
    if needs_costs and not all(part.get("cost") for part in parts):
        raise BadInput("give change_cost, or parts as a dict from names to their change costs")
    return parts


def _model(model: Any) -> Any:
    """A string is a model, a path the file of one."""
    if is_text(model):
        return words_of(model)
    if not hasattr(model, "__fspath__"):
        raise TypeError("model is a string, or a pathlib.Path for the file of one")
    return {"file": words_of(os.fsdecode(model))}


def _value_costs(costs: Any) -> list[list[str]]:
    """What setting values costs: by parameter, by parameter and value, by what is replaced."""
    rows: list[list[str]] = []
    for key, cost in _items("change_costs", costs):
        names = [words_of(key)] if is_text(key) else names_in("change_costs", key)
        if not 1 <= len(names) <= 3:
            raise BadInput("a key of change_costs does not fit; give parameter, "
                           "(parameter, value) or (parameter, value taken out, value put in)")
        rows.append([*names, _amount("change_costs", cost)])
    return rows


def _setup(argument: str, setup: Any, of_model: bool) -> list[str]:
    """Names of parts; of a model also a dict from parameters to values."""
    if of_model and isinstance(setup, Mapping):
        return [f"{words_of(name)}: {words_of(value)}" for name, value in setup.items()]
    return names_in(argument, setup)


def document_of(given: dict[str, Any]) -> dict[str, Any]:
    """The document of the arguments of plan() that are objects."""
    change_cost, change_costs = given["change_cost"], given["change_costs"]
    of_model = given["model"] is not None
    document: dict[str, Any] = {}
    if of_model:
        if given["slot_of"] is not None:
            raise BadInput("slot_of has no meaning with model; leave it out")
        if given["quantities"] is not None:
            raise BadInput("quantities is for parts; of a model, change_costs says how many there "
                           'are of a value, as {("OS", "ARM", "quantity"): 1}')
        document["model"] = _model(given["model"])
    elif given["parts"] is None:
        raise TypeError("plan() needs parts or model; give one of them")
    if given["parts"] is not None:
        document["parts"] = _parts(given["parts"], given["slots"], given["slot_of"],
                                   given["quantities"],
                                   not of_model and change_cost is None and change_costs is None)
    for argument in ("test_cost", "change_cost", "budget", "hours"):
        if given[argument] is not None:
            document[argument] = _amount(argument, given[argument])
    if change_costs is not None:
        rows = _value_costs(change_costs) if of_model else _table(change_costs)
        if not of_model and isinstance(document["parts"], list):
            names = [part["name"] for part in document["parts"]]
            lacks = next((name for name in names if name not in rows[0]), None)
            if lacks is not None:
                raise BadInput(f"change_costs has no cost for {_core.quoted(lacks)}; give one for "
                               "every two parts")
        document["change_costs"] = rows
    if given["slots"] is not None:
        document["slots"] = [_slot(words_of(name), room) for name,
                             room in _items("slots", given["slots"])]
    if given["pairs"] is not None:
        document["pairs"] = _pairs("pairs", given["pairs"])
    lists = {"never": _forbidden(given["never"]),
             "mounted": names_in("mounted", given["mounted"]),
             "start": names_in("start", given["start"]),
             "without": names_in("without", given["without"]),
             "first": [_first(setup, of_model)
                       for setup in _rows("first",
                           rows_of("first", "set-ups, lists of parts", given["first"], True))]}
    if given["weights"] is not None:
        lists["weights"] = [[*_pair("weights", pair), _amount("weights", weight)]
                            for pair, weight in _items("weights", given["weights"])]
    lists["done"] = [_test(test, of_model)
        for test in _rows("done", rows_of("done", "set-ups, lists of parts", given["done"]))]
    return {**document, **{key: rows for key, rows in lists.items() if rows}}
