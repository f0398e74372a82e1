"""Bodies on a line that may all touch at once: who stands in it, velocities after, one motion in time."""
