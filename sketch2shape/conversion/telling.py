"""What the command says of each input, in lines for standard error."""

from __future__ import annotations

from sketch2shape.conversion.convert import Outcome, Task
from sketch2shape.errors import on_one_line, one_line
from sketch2shape.model import TRUSTED

_DOUBT = "--overlay FILE.png shows it, sketch2shape ui puts it right, --min-confidence refuses it"


class Teller:
    """Puts what became of an input into lines; advice that was given already is not repeated."""

    def __init__(self) -> None:
        """Begin with no advice given."""
        self._given: set[str] = set()

    def failure(self, task: Task, outcome: Outcome) -> str:
        """`FILE: what happened. Try: what helps`, or "as above"."""
        remedy = outcome.remedy or ""
        again = remedy in self._given
        self._given.add(remedy)
        return one_line(task.source, outcome.message or "", "as above" if again else remedy)

    def success(self, task: Task, outcome: Outcome) -> list[str]:
        """What was found and written, and a word of warning where the answer is not sure."""
        written = ", ".join(o.path if o.path != "-" else "standard output" for o in task.outputs)
        lines = [on_one_line(f"{task.source}: {outcome.found or 'done'} -> {written}")]
        if outcome.confidence is not None and outcome.confidence < TRUSTED:
            what = f"please check it, confidence {outcome.confidence:.2f} is low"
            lines.append(self.failure(task, Outcome(outcome.name, message=what, remedy=_DOUBT)))
        return lines
