"""What is computed, as functions and as the results that they return.

`_result` is the base of all results, `_si` adds values in SI. Files of a result come before those that
compute it: a result knows no function but those of its own methods, and no pictures.
"""
