import socket

import pytest

from sketch2shape.command.parser import main
from sketch2shape.errors import UsageError
from sketch2shape.ui import serve
from sketch2shape.ui.serve import build_parser


def test_it_listens_on_this_machine_only_unless_told_otherwise() -> None:
    assert build_parser().parse_args([]).host == "127.0.0.1"


def test_a_port_in_use_is_said_in_words(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert main(["ui", "--no-browser", "--port", str(port)]) == 2
    assert f"cannot listen on 127.0.0.1 port {port}" in capsys.readouterr().err


@pytest.mark.parametrize("options", [{"port": 70000}, {"seconds": 0}, {"max_upload": 0}])
def test_impossible_settings_are_refused(options: dict[str, float]) -> None:
    with pytest.raises(UsageError):
        serve(**{"port": 0, **options})  # type: ignore[arg-type]
