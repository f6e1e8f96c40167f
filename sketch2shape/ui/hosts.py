"""Host names of requests: which of them mean this machine."""

from __future__ import annotations

LOCAL_NAMES = frozenset({"127.0.0.1", "localhost", "[::1]"})
"""Host names that mean this machine."""


def host_name(host: str) -> str:
    """The name in a Host header, lower case, without its port; "" if it is not of that form."""
    name, colon, port = host.rpartition(":")
    if colon and not host.endswith("]"):
        return name.lower() if port.isdigit() and len(port) <= 5 else ""
    return host.lower()
