"""Options as users give them: by name in a dictionary, or in the wrong place."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from difflib import get_close_matches
from functools import wraps
from inspect import Parameter, signature
from typing import Any, TypeVar, cast

from sketch2shape.errors import OptionError, UsageError
from sketch2shape.lifting import LiftOptions

Call = TypeVar("Call", bound=Callable[..., Any])


def lift_options_of(given: LiftOptions | Mapping[str, Any] | None) -> LiftOptions:
    """The options for lifting: themselves, made of their fields by name, or the defaults. Raises UsageError."""
    if given is None:
        return LiftOptions()
    if isinstance(given, LiftOptions):
        return given
    if not isinstance(given, Mapping):
        raise UsageError(
            f"lift is {type(given).__name__}, not LiftOptions", remedy="lift=sketch2shape.LiftOptions(width='40mm')"
        )
    names = [field.name for field in fields(LiftOptions)]
    for name in given:
        if name not in names:
            raise OptionError(f"LiftOptions has no {name!r}", remedy=_near(str(name), names))
    return LiftOptions(**given)


def explained(function: Call) -> Call:
    """The function; given an option that it does not have, it says where that belongs (OptionError)."""
    names = [name for name, p in signature(function).parameters.items() if p.kind is Parameter.KEYWORD_ONLY]
    known = {*signature(function).parameters}

    @wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        for name in options:
            if name not in known:
                belongs = name in {field.name for field in fields(LiftOptions)}
                remedy = f"lift=sketch2shape.LiftOptions({name}=...)" if belongs else _near(name, names)
                raise OptionError(f"{function.__name__} has no option {name!r}", remedy=remedy)
        return function(*arguments, **options)

    return cast("Call", call)


def _near(name: str, names: Iterable[str]) -> str:
    known = sorted(names)
    near = get_close_matches(name, known, n=1)
    return f"{near[0]}=..." if near else f"one of {', '.join(known)}"
