"""Oracles of the checks of estimation."""
