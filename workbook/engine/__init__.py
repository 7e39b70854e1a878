"""Python for the answer boxes of pages: `pack` writes the folder that a site serves as run/."""
