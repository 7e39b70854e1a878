"""Indirect methods: from a discrete solution to an extremal by multiple shooting over arcs."""
