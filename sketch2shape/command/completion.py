"""Completion of the command in shells, made from its parser."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence

from sketch2shape.writing.formats import FORMATS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

SHELLS = ("bash", "zsh", "fish")

_BASH = """_sketch2shape() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
    case $before in
{cases}
    esac
    case $word in
        -*) COMPREPLY=($(compgen -W "{options}" -- "$word")) ;;
        *) COMPREPLY=($(compgen -f -- "$word")) ;;
    esac
}}
complete -o filenames -F _sketch2shape sketch2shape
"""


class PrintCompletion(argparse.Action):
    """Prints the completion for a shell and ends, as --version does."""

    def __init__(self, **options: Any) -> None:
        """Take one of the shells."""
        super().__init__(**{**options, "choices": SHELLS})

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        _: argparse.Namespace,
        values: str | Sequence[Any] | None,
        __: object = None,
    ) -> None:
        """Print it."""
        print(completion(parser, str(values)), end="")
        parser.exit()


def completion(parser: argparse.ArgumentParser, shell: str) -> str:
    """The script that a shell loads."""
    if shell == "fish":
        return "".join(_fish_lines(parser))
    cases = [
        f'        {"|".join(names)}) COMPREPLY=($(compgen -W "{" ".join(words)}" -- "$word")); return ;;'
        for names, words in _choices(parser)
    ]
    options = " ".join(name for action in parser._actions for name in action.option_strings)
    script = _BASH.format(cases="\n".join(cases), options=options)
    return "autoload -U +X bashcompinit && bashcompinit\n" + script if shell == "zsh" else script


def _choices(parser: argparse.ArgumentParser) -> Iterator[tuple[list[str], list[str]]]:
    """Options that take one of a few words, and the words."""
    for action in parser._actions:
        if "--format" in action.option_strings:
            yield list(action.option_strings), [*FORMATS]
        elif action.choices:
            yield list(action.option_strings), [str(choice) for choice in action.choices]


def _fish_lines(parser: argparse.ArgumentParser) -> Iterator[str]:
    known = {names[0]: words for names, words in _choices(parser)}
    for action in parser._actions:
        names = [f"-{'l' if name.startswith('--') else 's'} {name.lstrip('-')}" for name in action.option_strings]
        if names:
            words = known.get(action.option_strings[0])
            after = f" -xa '{' '.join(words)}'" if words else "" if action.nargs == 0 else " -r"
            about = (action.help or "").replace("'", "").replace("%%", "%")
            yield f"complete -c sketch2shape {' '.join(names)}{after} -d '{about}'\n"
