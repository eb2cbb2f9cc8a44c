"""Runs the examples of the package's docstring and of the pages that are named."""

import doctest
import sys

import changeover

ran = doctest.testmod(changeover)
failed, attempted = ran.failed, [ran.attempted]
for page in sys.argv[1:]:
    ran = doctest.testfile(page, module_relative=False)
    failed += ran.failed
    attempted.append(ran.attempted)
if failed or 0 in attempted:
    sys.exit(f"{failed} examples failed; examples on each page: {attempted}")
