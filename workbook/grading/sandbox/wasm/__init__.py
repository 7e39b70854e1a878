"""Run a student's notebook in CPython inside WebAssembly, which needs no Linux."""
