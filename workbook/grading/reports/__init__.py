"""What a lecturer and a student read: points, pages, tables for the learning platform."""
