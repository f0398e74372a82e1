"""Bodies, blocks and walls, who meets whom, and how they vibrate before.

`_solid` has what all have in common, by the core's table of kinds; `_encounter` chooses what was meant and
makes the contact of it; `_material` is the only place where a user's units are told to the core.
"""
