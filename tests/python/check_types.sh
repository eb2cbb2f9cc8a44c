#!/usr/bin/env bash
# Are the types of the Python package whole, and can a program that uses it be checked by them? A
# wrong use must be found, too.
# usage: check_types.sh PYTHON PACKAGES
set -euo pipefail
python=$1 packages=$2
"$python" -c 'import mypy' 2>/dev/null || {
  printf 'skipped: mypy is not installed\n'
  exit 77
}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export MYPYPATH=$packages
"$python" -m mypy --strict -p changeover
cat >right.py <<'END'
import changeover

design = changeover.design(61, 4, kind="circular")
assert design is not None
rows: list[list[int]] = design.blocks.tolist()
bound: int | None = changeover.bounds(20, 5).lower_bound
for evict, load in changeover.load_order(12, 4):
    print(len(evict) + len(load))
steps: list[list[object]] = [[step["setup"]] for step in changeover.plan(9, 3, test_cost=1, change_cost=5).steps]
both: int = len(changeover.plan(9, 3, test_cost=1, change_cost="5", benches=2).sheets)
END
"$python" -m mypy --strict right.py
cat >wrong.py <<'END'
import changeover
changeover.design(61, 4, kind="round")
changeover.bounds("v", 4)
changeover.plan(9, 3, test_cost=1, change_cost=5).makespan
changeover.load_order(12, 4, workers=2).lower_bound
changeover.plan(9, 3, test_costs=1)
changeover.load_order(12, 4, epochs="2")
END
if "$python" -m mypy --strict wrong.py >said; then
  printf 'wrong uses were not found\n' >&2
  exit 1
fi
[[ $(grep -c 'error:' said) -eq 6 ]]
