"""Gerl and Zippelius, Coefficient of restitution for elastic disks, PRE 59, 2361 (1999), again.

    PYTHONPATH=studies python -m gerl_zippelius_1999 --output out/paper        (make paper)

One module for each figure, for the table, and for what the text says about the modes. Each defines

    TITLE, CAPTION                what it is, in a line and in a paragraph of plain text
    compute(quick) -> tables      {"table": {"column[unit]": 1-D array}}; all that costs time
    draw(tables) -> Figure        from the tables only
    numbers(tables) -> rows       (quantity, paper, protocol, converged), as text
    meaning(tables) -> str        what it means, in two or three sentences
    ALT                           optional: the picture in a sentence, for those who do not see it

`runner` computes them and keeps their tables (`store`), `report` writes report.html with the text
in `words`.
"""
