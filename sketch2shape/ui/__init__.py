"""The web app (extra `ui`): see a drawing turn into a solid in the browser, and put it right by hand.

`serve` runs it; `sketch2shape.ui.app.create_app` gives the ASGI application.
"""

from sketch2shape.ui.serve import serve

__all__ = ["serve"]
