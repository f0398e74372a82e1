"""python -m gerl_zippelius_1999: see `runner`."""

import sys

from gerl_zippelius_1999.runner import main

if __name__ == "__main__":
    sys.exit(main())
