"""Speed, as ratios measured in one run: `python -m benchmarks` writes docs/performance.md."""
