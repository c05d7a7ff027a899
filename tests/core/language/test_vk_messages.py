# SPDX-License-Identifier: LGPL-2.1-or-later
"""Codes, templates and arguments of messages fit together in every language, for any labels."""

from __future__ import annotations

import ast
import json
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from readers import LANGUAGES, German, Inches, Translated

from toolpaths import synthetic
from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.language import ENGLISH, ROUGH, Message, Reader, Unusable, render
from vkworkbench.language.table import PLAIN, TABLE

PACKAGE = Path(__file__).resolve().parents[3] / "vkworkbench"
PLACE = re.compile(r"\{(\w+)(?::([^{}\d]+)\d*)?\}")
VALUES = {"n": 3, "#": 12345, "g": 0.5, "mm": 2.5, "mm³": 212.0, "mm/min": 300.0, "s": 4.0, "estimate": 40.0, "clock": 75.0, "bytes": 2e6, "%": 0.5, "turns": 9.0,
          "strategy": "zigzag", "simulator": "legacy", "": "Face"}  # fmt: skip


def templates(code):
    known = TABLE[code]
    return [known] if isinstance(known, str) else list(known)


def places(code):
    """Return {placeholder: quantity, such as length or time} of the message with the given code."""
    return dict(place for template in templates(code) for place in PLACE.findall(template))


@pytest.fixture(scope="module")
def made(parse):
    """Return every message that the code makes: its file and line, and its call."""
    return [
        (f"{path.relative_to(PACKAGE)}:{node.lineno}", node)
        for path in sorted(PACKAGE.rglob("*.py"))
        for node in ast.walk(parse(path))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Message"
    ]


@pytest.mark.sources
def test_messages_have_a_template_with_exactly_their_arguments(made):
    wrong = []
    for where, call in made:
        if len(call.args) != 1 or not isinstance(call.args[0], ast.Constant):
            wrong.append(f"{where}: no literal code")
        elif call.args[0].value not in TABLE:
            wrong.append(f"{where}: no template for {call.args[0].value!r}")
        elif {keyword.arg for keyword in call.keywords} != set(places(call.args[0].value)):
            wrong.append(f"{where}: other arguments than the template has")
    assert wrong == []


@pytest.mark.sources
def test_every_template_of_a_message_is_used(made):
    assert set(TABLE) == {call.args[0].value for _, call in made}


@pytest.mark.sources
def test_templates_have_known_quantities_and_ascii_words():
    wrong = []
    for code in TABLE:
        for template in templates(code):
            words = PLACE.sub("", template)
            if not set(dict(PLACE.findall(template)).values()) <= set(VALUES):
                wrong.append((code, "a quantity that no value has"))
            if not words.isascii() or re.search("[{}]", words):
                wrong.append((code, "words that are not plain ASCII"))
        if len(templates(code)) > 1 and places(code).get("count") != "n":
            wrong.append((code, "two templates without a count"))
    assert wrong == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_message_is_rendered_in_every_language(language):
    reader = Translated(language)
    for code in TABLE:
        for count in (1, 3):
            arguments = {name: VALUES[quantity] for name, quantity in places(code).items()}
            if "count" in arguments:
                arguments["count"] = count
            message = Message(code, **arguments)
            shown = render(message, reader)
            assert shown and not re.search(r"[{}]", shown), shown
            for template in templates(code):
                assert ("Sentences", template) in reader.texts or not PLACE.sub("", template), template
            for name, quantity in places(code).items():
                assert quantity or "Face" in shown, (name, shown)


@pytest.mark.parametrize(
    "label", ["A; B", "{step:mm3}", "{label}", "{}", "%n %1 50%", "a: b", "⟦x⟧", "é\n\t", "", "; "]
)
def test_labels_in_messages_are_not_changed(label):
    message = Message("heaviest", label=label, time=3.0)
    assert render(message) == f" The slowest is {label} with 3.0 s."
    assert render(message, German()) == f" Am längsten braucht {label} mit 3,0 s."
    assert Message.from_data(json.loads(json.dumps(message.as_data()))) == message


def wrong_reasons():
    """Yield the kind and the reason of each synthetic toolpath whose reason is not right in every language.

    One toolpath per kind is enough, because further toolpaths of a kind give no other message codes.
    """
    for kind, _, build in synthetic.SAMPLES:
        found = recognize(linearize(build(np.random.default_rng(0))), tool_diameter=6.0)
        if (
            Message.from_data(json.loads(json.dumps(found.why.as_data()))) != found.why
            or render(found.why) != found.reason
        ):
            yield kind, found.reason
        for reader in map(Translated, LANGUAGES):
            shown = render(found.why, reader)
            if re.search(r"\b(Phi|turns|over|the|and)\b|[{}]", shown):
                yield kind, shown
        for reader in (ENGLISH, *map(Translated, LANGUAGES)):
            shown = render(found.why, reader, plain=True)
            if not shown or re.search(r"\bPhi\b|φ|[{}]", shown):
                yield kind, shown


@pytest.mark.long
def test_reasons_of_recognitions_are_right_in_every_language():
    assert list(wrong_reasons()) == []


def test_reason_for_a_strategy_contains_measured_numbers():
    rows = [("G0", {"X": 0, "Y": 0, "Z": 0})]
    for i in range(12):
        rows += [("G1", {"X": 50 if i % 2 == 0 else 0}), ("G1", {"Y": 3.0 * (i + 1)})]
    found = recognize(linearize(rows), tool_diameter=5)
    arguments = found.why.arguments
    assert found.why.code == "rows" and arguments["strategy"] == "zigzag" and arguments["count"] == found.passes
    assert (arguments["low"], arguments["high"]) == found.phi_range
    assert arguments["spread"] == Message("apart", step=found.stepover)
    assert arguments["seen"] == Message("half-turns-alternate")


def test_numbers_are_written_in_the_readers_way():
    message = Message("passes-need", step=2.54, cell=0.635)
    assert render(message) == " Passes 2.54 mm apart need 0.64 mm."
    assert render(message, German()) == " Bahnen im Abstand von 2,54 mm brauchen 0,64 mm."
    assert render(message, Inches()) == " Passes 0.1 in apart need 0.025 in."
    german = German()
    assert (german.count(1234567), german.decimals(3.14159, 2)) == ("1.234.567", "3,14")
    assert (german.share(0.98), ENGLISH.share(0.98)) == ("98 %", "98%")
    assert (german.estimated_time(3.21, 2.5), german.estimated_time(3.21, 1.5)) == ("etwa 3 s", "3,2 s")


@pytest.mark.parametrize("kind, number, text", [
    ("time", [0.0123], "0.012 s"), ("time", [1.42], "1.4 s"), ("time", [180], "3.0 min"), ("time", [9000], "2.5 h"),
    ("time", [4e-5], "0.001 s"), ("time", [1e7], "2,778 h"),
    ("time", [0.9995], "1.0 s"), ("time", [60], "1.0 min"), ("time", [3600], "1.0 h"), ("length", [10_000], "10 m"),
    ("memory", [1.5e9], "1.5 GB"), ("memory", [999.9e3], "1.0 MB"), ("memory", [0], "0 kB"),
    ("length", [12.345], "12 mm"), ("length", [12_345], "12 m"),
    ("measure", [0.0123456, 2], "0.012 mm"), ("measure", [12345.6, 4], "12,346 mm"),
    ("measure", [1e-6, 6], "1e-06 mm"), ("measure", [float("nan"), 6], "nan mm"), ("measure", [10 / 3, 6], "3.33333 mm"),
    ("number", [10 / 3], "3.33333"), ("number", [1234567.8], "1,234,568"), ("volume", [10 / 3, 3], "3.33 mm³"),
    ("turns", [9.42478], "+1.50"), ("turns", [-1e-9], "0"), ("turns", [0.03], "0"), ("turns", [0.04], "+0.01"), ("share", [0.005], "0%"),
    ("simulator", ["z-buffer"], "Simulate Toolpaths simulator"), ("simulator", ["another"], "another"),
])  # fmt: skip
def test_numbers_have_two_or_three_digits_and_a_unit(kind, number, text):
    assert getattr(ENGLISH, kind)(*number) == text


@pytest.mark.parametrize("memory, needed, allowed", [
    (3.1e9, "3.1 GB", "2.0 GB"), (2.04e9, "2.04 GB", "2.00 GB"), (2.0004e9, "2.0004 GB", "2.0000 GB"), (2e9, "2.0 GB", "2.0 GB"),
])  # fmt: skip
def test_rounded_values_in_a_sentence_differ_if_values_differ(memory, needed, allowed):
    """A sentence must not say "about 2.0 GB, which is over your 2.0 GB limit"."""
    told = render(Message("memory", simulator="legacy", memory=memory, allowed=2e9, instead=Message("smaller-image")))
    assert f"takes about {needed} for this operation, which is over your {allowed} limit." in told


def test_different_times_in_a_sentence_are_written_differently():
    close = Message("legacy-long-play", simulator="legacy", longer=602.0, time=598.0)
    assert "10.03 min in the legacy simulator. Use fast-forward, which takes about 9.97 min" in render(close)
    assert "10,03 min" in render(close, German()) and "9,97 min" in render(close, German())
    assert (ENGLISH.time(0.0501, extra_digits=2), ENGLISH.memory(50.25, 2)) == ("0.0501 s", "0.05025 kB")
    assert (ENGLISH.time(2.0, extra_digits=2), ENGLISH.time(36_000.0, extra_digits=1)) == ("2.000 s", "10.0 h")


def test_unit_of_a_volume_is_chosen_by_the_side_of_its_cube():
    class Large(Reader):
        def length_unit(self, millimetres):
            return (1000.0, "m") if millimetres > 1000 else (1.0, "mm")

    assert Large().volume(8e6, 2) == "8,000,000 mm³"
    assert Large().volume(8e9, 2) == "8 m³"


@pytest.mark.parametrize("seconds, two, one", [
    (0.393, "0.39 s", "0.4 s"), (1.42, "1.4 s", "1 s"), (186.0, "3.1 min", "3 min"), (6120.0, "1.7 h", "2 h"),
    (4e-5, "0.0010 s", "0.001 s"), (59.7, "1.0 min", "1 min"), (0.996, "1.0 s", "1 s"), (3580.0, "1.0 h", "1 h"),
    (9.96, "10 s", "10 s"), (96.0, "1.6 min", "2 min"), (1e7, "2,800 h", "3,000 h"), (0.0, "0 s", "0 s"),
    (float("inf"), "inf h", "inf h"),
])  # fmt: skip
def test_number_of_digits_of_a_time_depends_on_its_error(seconds, two, one):
    assert ENGLISH.time(seconds, 1.3) == ENGLISH.estimated_time(seconds, 1.9) == two
    assert ENGLISH.time(seconds, 2.0) == one and ENGLISH.estimated_time(seconds, 4.0) == f"about {one}"
    assert ENGLISH.time(seconds, 1.01) == ENGLISH.time(seconds)


@pytest.mark.parametrize("strategy", Strategy)
def test_english_names_of_strategies_are_their_values(strategy):
    """A message contains the value of the strategy, and the translations contain the name."""
    assert strategy.value == strategy.label
    assert all(("Strategy", strategy.value) in Translated(language).texts for language in LANGUAGES)


def test_plain_words_do_not_contain_the_papers_terms():
    """For a reason with the paper's terms, there is a template for machinists with the same numbers."""
    terms = re.compile(r"\b(Phi|half-turns|level)\b")
    spoken = {code for code in TABLE for template in templates(code) if terms.search(PLACE.sub("", template))}
    assert spoken - set(PLAIN) <= {"sections"}
    for code, known in PLAIN.items():
        for template in [known] if isinstance(known, str) else known:
            assert not terms.search(PLACE.sub("", template)), template
            assert set(PLACE.findall(template)) <= {
                place for t in templates(code.split()[0]) for place in PLACE.findall(t)
            }
    bites = Message("bites-overlap", count=132)
    spread = Message("apart-at-depths", step=1.0, depths=3)
    why = Message("strokes", low=-1.0, high=9.0, count=5, spread=spread, seen=bites, strategy=Strategy.ADAPTIVE)
    assert render(why, plain=True) == "132 overlapping engagements, 1 mm apart at 3 depths."
    assert render(why).startswith("Phi stays")


def test_singular_and_plural_of_messages_differ():
    assert "1 ramp at" in render(Message("legacy-ramp", simulator="legacy", count=1, error=2, way="", command=3))
    assert "2 ramps at" in render(Message("legacy-ramp", simulator="legacy", count=2, error=2, way="", command=3))


def test_equal_messages_are_equal_values():
    one = Message("x", b=np.float64(2), a=np.int64(1), strategy=Strategy.ZIGZAG, parts=[Message("y"), "z"], no=None)
    same = Message("x", a=1, b=2.0, strategy="zigzag", parts=(Message("y"), "z"), no=None)
    assert one == same and hash(one) == hash(same) and one != Message("x", a=1)
    assert type(one.arguments["a"]) is int and type(one.arguments["strategy"]) is str
    assert Message("x", d=float("nan")) == Message("x", d=float("nan"))
    assert repr(Message("x", a=1, b="c")) == "Message('x', a=1, b='c')"
    with pytest.raises(AttributeError):
        one.code = "y"
    with pytest.raises(TypeError):
        Message("x", a=object())


def test_codes_of_a_message_include_the_codes_of_its_parts():
    inner = Message("seen", parts=[Message("one"), "a text", Message("more")])
    assert Message("all", a=inner, b=Message("last"), c=2).codes == ("all", "seen", "one", "more", "last")


plain = st.none() | st.integers(-(2**60), 2**60) | st.floats() | st.text(max_size=9)
messages = st.recursive(
    st.builds(lambda code, arguments: Message(code, **arguments), st.text(), st.dictionaries(st.text(), plain)),
    lambda inner: st.builds(
        lambda code, arguments: Message(code, **arguments),
        st.text(), st.dictionaries(st.text(), plain | inner | st.lists(plain | inner, max_size=3)),
    ),
    max_leaves=5,
)  # fmt: skip


@pytest.mark.long
@given(messages)
def test_message_is_unchanged_by_writing_and_reading(message):
    written = json.dumps(message.as_data(), allow_nan=False)
    assert Message.from_data(json.loads(written)) == message


anything = st.recursive(
    plain | st.booleans(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text() | st.just("code"), inner),
    max_leaves=20,
)


@given(anything)
def test_invalid_message_data_raise_value_error(data):
    for one in (data, {"code": data, "arguments": data}, {"code": "image", "arguments": {"width": data}}):
        try:
            message = Message.from_data(one)
        except ValueError:
            continue
        with pytest.raises((LookupError, TypeError, ValueError)):
            render(message)


def test_exception_unusable_contains_its_message():
    error = Unusable(Message("tip-angle", angle=4.0))
    assert isinstance(error, ValueError) and error.what.code == "tip-angle"
    assert str(error) == "The tip angle must be between 0 and pi, not 4."


def test_number_in_a_sentence_has_six_digits():
    assert str(Unusable(Message("tip-angle", angle=10 / 3))).endswith("not 3.33333.")


def test_list_argument_is_joined_for_the_reader():
    several = Message("tip-angle", angle=(0.5, 4.0))
    assert render(several).endswith("not 0.5, 4.") and "0,5, 4" in render(several, German())
    both = Message("in-commands", sentence=(Message("no-moves"), Message("only-rapids")), count=1, command=3)
    assert render(both) == f"Command 3: {render(Message('no-moves'))} {render(Message('only-rapids'))}"


@pytest.mark.parametrize("text, seconds", [
    ("0:45", 45), (" 17:30 ", 1050), ("1:02:30", 3750), ("90:00", 5400), ("17", None), ("1:75", None), ("", None),
    ("-1:00", None), ("1:2:3:04", None),
])  # fmt: skip
def test_machining_time_in_minutes_and_seconds_is_read(text, seconds):
    assert ENGLISH.seconds_of(text) == seconds
    assert seconds is None or ENGLISH.seconds_of(ENGLISH.clock(seconds)) == seconds


@pytest.mark.parametrize("reader", [ENGLISH, German(), *map(Translated, LANGUAGES)])
def test_time_in_a_sentence_equals_the_time_in_the_tree(reader):
    for seconds in np.geomspace(0.004, 90_000, 30):
        mark = reader.time(seconds, ROUGH)
        for code in ("started-takes", "over-budget"):
            told = Message(code, simulator="legacy", bound=Message("bound-about"), time=seconds, allowed=1.0, better="")
            assert mark in render(told, reader) and mark in reader.estimated_time(seconds, 4.0)
        assert mark in render(Message("opengl-long-play", simulator="OpenGL", time=seconds), reader)
