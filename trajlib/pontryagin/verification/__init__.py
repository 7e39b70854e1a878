"""Evidence for an extremal: certificate, theorems, second variation, proof in ball arithmetic."""
