"""What a stranger's files can do: campaigns of damage, each a module. `python -m benchmarks.faults --help`"""
