"""Test drawings with truth: random two-face objects in every style and medium, from a seed."""
