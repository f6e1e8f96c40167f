"""InkML: formats of traces, differences, and what is none."""

import pytest

from sketch2shape.errors import LimitError, UnreadableError
from sketch2shape.reading.inkml import inkml_lines

HEAD = '<ink xmlns="http://www.w3.org/2003/InkML">'


def traces(body):
    return [line.points.tolist() for line in inkml_lines(f"{HEAD}{body}</ink>".encode())]


@pytest.mark.parametrize(
    ("text", "points"),
    [
        ("10 0, 9 14, 8 28", [[10, 0], [9, 14], [8, 28]]),
        ("10 0,9 14,", [[10, 0], [9, 14]]),
        ("-1.5 2e1", [[-1.5, 20]]),
        ("1-2,3-4", [[1, -2], [3, -4]]),
        ("#FF 1", [[255, 1]]),
        # the example of the Recommendation, section 3.2.1
        (
            "1125 18432,'23'43,\"7\"-8,3 -5,7 -3",
            [[1125, 18432], [1148, 18475], [1178, 18510], [1211, 18540], [1251, 18567]],
        ),
        ("10 10,'1'2,3 4,!50!60", [[10, 10], [11, 12], [14, 16], [50, 60]]),
        ("5 6,* 7", [[5, 6], [5, 7]]),
        ("", None),
    ],
)
def test_points(text, points):
    assert traces(f"<trace>{text}</trace>") == ([] if points is None else [points])


def test_channels_stand_in_the_order_of_the_format():
    form = '<traceFormat><channel name="F"/><channel name="Y"/><channel name="X"/></traceFormat>'
    assert traces(f"{form}<trace>9 1 2,9 3 4</trace>") == [[[2, 1], [4, 3]]]


def test_a_context_has_its_own_format_and_y_may_count_upwards():
    channels = '<channel name="Y" orientation="-ve"/><channel name="X"/>'
    one = f'<context xml:id="c"><traceFormat>{channels}</traceFormat></context>'
    other = '<traceFormat xml:id="f"><channel name="X"/><channel name="Y"/></traceFormat>'
    assert traces(f'{other}{one}<trace contextRef="#c">1 2,3 4</trace><trace>1 2</trace>') == [
        [[2, -1], [4, -3]],
        [[1, 2]],
    ]


def test_traces_in_groups_count_and_hovering_does_not():
    assert traces('<traceGroup><trace>1 2</trace><trace type="penUp">5 6</trace></traceGroup>') == [[[1, 2]]]


@pytest.mark.parametrize(
    "body", ["<trace>1</trace>", "<trace>a b</trace>", "<traceFormat><channel name='F'/></traceFormat>"]
)
def test_traces_without_two_values_are_refused(body):
    with pytest.raises(UnreadableError):
        traces(body)


def test_other_xml_and_too_many_points_are_refused():
    with pytest.raises(UnreadableError):
        inkml_lines(b"<html/>")
    with pytest.raises(LimitError):
        traces("<trace>" + "1 2," * 160_000 + "</trace>")
