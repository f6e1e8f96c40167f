"""Options as users give them: by name in a dictionary, or in the wrong place."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from difflib import get_close_matches
from functools import wraps
from inspect import Parameter, signature
from typing import Any, TypeVar, cast

from sketch2shape.corrections import Corrections, corrections_from
from sketch2shape.errors import OptionError, UsageError
from sketch2shape.lifting import LiftOptions
from sketch2shape.lifting.options import length
from sketch2shape.reading import Limits

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


def limits_of(given: Limits | Mapping[str, Any] | None) -> Limits:
    """The limits: themselves, made of their fields by name, or the defaults. Raises UsageError."""
    if given is None:
        return Limits()
    if isinstance(given, Limits):
        return given
    names = [field.name for field in fields(Limits)]
    if not isinstance(given, Mapping) or not set(given) <= set(names):
        raise UsageError(f"limits is {given!r}", remedy=f"limits=sketch2shape.Limits(...) with {', '.join(names)}")
    return Limits(**given)


def corrections_of(given: Corrections | Mapping[str, Any] | None) -> Corrections | None:
    """The corrections: themselves, or what their file holds. Raises UsageError."""
    if given is None or isinstance(given, Corrections):
        return given
    return corrections_from(given)


def tolerance_of(given: str | float | None, unit: str) -> float | None:
    """A chord tolerance such as "0.1mm" or 0.1 as a number in a solid's unit; None stays None. Raises UsageError."""
    try:
        return length(given, unit)
    except UsageError as error:
        raise UsageError(f"tolerance {given!r} is not a length", remedy=error.remedy) from None


def refuse_unknown(function: Callable[..., Any], options: Iterable[str]) -> None:
    """Raise OptionError for an option that the function does not have, and say where it belongs."""
    parameters = signature(function).parameters
    for name in options:
        if name not in parameters:
            belongs = name in {field.name for field in fields(LiftOptions)}
            known = [own for own, p in parameters.items() if p.kind is Parameter.KEYWORD_ONLY]
            remedy = f"lift=sketch2shape.LiftOptions({name}=...)" if belongs else _near(name, known)
            raise OptionError(f"{function.__name__} has no option {name!r}", remedy=remedy)


def explained(function: Call) -> Call:
    """The function; an option that it does not have is told where it belongs."""

    @wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        refuse_unknown(function, options)
        return function(*arguments, **options)

    return cast("Call", call)


def _near(name: str, names: Iterable[str]) -> str:
    known = sorted(names)
    near = get_close_matches(name, known, n=1)
    return f"{near[0]}=..." if near else f"one of {', '.join(known)}"
