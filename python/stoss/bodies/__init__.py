"""Bodies, blocks and walls, who meets whom, and how they vibrate before.

`_solid` has what all have in common, by the table of kinds (`_kinds`), with losses (`_losses`) and faces (`_faces`);
`_encounter` chooses what was meant and
makes the contact of it; `_material` is the only place where a user's units are told to the core.
"""
