"""One input from start to end: read, reconstructed, encoded, written, reported."""
