"""Force laws and collision rules of simulation programs, with constants fitted to elasticity.

A law knows its equation and what it makes of an impact; `_fit` brings its constants near to what
stoss computes; a program writes them in its own words.
"""
