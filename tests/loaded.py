"""A script of the repository as a module: scripts are no package."""

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

SCRIPTS = Path(__file__).parent.parent / "scripts"


def loaded(name):
    """The script of this name, without `.py`, loaded as when it runs: beside its neighbours."""
    sys.path.insert(0, str(SCRIPTS))
    try:
        spec = spec_from_file_location(name, SCRIPTS / f"{name}.py")
        module = sys.modules[name] = module_from_spec(spec)
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(SCRIPTS))
    return module
