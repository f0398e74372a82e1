"""Sweeps: grids of cases, their store, and what a store holds.

`_grid` has the cases, `_specification` bodies as mappings; `_store` reads and writes the files;
`_sweep` computes, `_values` are the result.
"""
