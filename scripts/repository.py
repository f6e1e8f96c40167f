"""The repository's root, put on the import path: a script run by its path sees its own folder and what is installed.

Imported first by every script that uses the packages which are not installed: `synthetic`, `evaluation`.
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

if str(ROOT) not in sys.path:
    sys.path.insert(0, str(ROOT))
