"""Chromium as Debian packages it, without a screen and without any traffic of its own."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from selenium.webdriver import Chrome, ChromeOptions, ChromeService

QUIET = [
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--hide-scrollbars",
    "--window-size=1400,1000",
]


def missing() -> str | None:
    """Why there is no browser to test in, or None."""
    lacking = [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]
    return f"{' and '.join(lacking)} not installed (Debian: chromium, chromium-driver)" if lacking else None


@contextmanager
def start_browser(downloads: Path | None = None, *flags: str, many: bool = False) -> Iterator[Chrome]:
    """A browser with an empty profile; what it downloads goes to `downloads`. Many: it can hold several, each fresh."""
    options = ChromeOptions()
    options.enable_bidi = many
    options.binary_location = str(shutil.which("chromium"))
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        for flag in (*QUIET, *flags, f"--user-data-dir={profile}"):
            options.add_argument(flag)
        if downloads is not None:
            options.add_experimental_option("prefs", {"download.default_directory": str(downloads)})
        browser = Chrome(options=options, service=ChromeService(str(shutil.which("chromedriver"))))
        try:
            yield browser
        finally:
            browser.quit()
