"""Worker processes, started without changing anything in the process that starts them. Light: standard library only."""
