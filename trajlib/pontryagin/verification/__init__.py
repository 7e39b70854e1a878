"""Verification of extremals: certificate, sufficiency theorems, second variation, proof."""
