"""`python -m sketch2shape`."""

from __future__ import annotations

import sys

from sketch2shape.command.parser import main

if __name__ == "__main__":
    sys.exit(main())
