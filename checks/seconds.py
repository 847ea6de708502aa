#!/usr/bin/env python3
"""Seconds of the tests by group (crate and program), with their share of all, beside the share that was recorded.

    python3 checks/seconds.py tests.log             the table, of the output of `cargo test --workspace`
    python3 checks/seconds.py tests.log --record    writes the shares into checks/seconds.json

Shares can be compared on machines of different speeds; seconds cannot.
"""

import json
import re
import sys
from pathlib import Path

RECORD = Path(__file__).resolve().parent / "seconds.json"
GROUP = re.compile(r"Running (unittests )?(\S+) \(\S*/deps/(\w+)-\w+\)")
RESULT = re.compile(r"test result: .* (\d+) passed.* finished in ([0-9.]+)s")


def seconds_by_group(log):
    groups, crate, group = {}, "", None
    for line in log.splitlines():
        if found := GROUP.search(line):
            is_unit, file, program = found.groups()
            # The unit tests of a crate are run before those in its folder `tests`.
            crate = program if is_unit else crate
            group = f"{crate} {file}"
        elif (found := RESULT.search(line)) and group:
            groups[group] = (int(found[1]), float(found[2]))
            group = None
    return groups


def main():
    groups = seconds_by_group(Path(sys.argv[1]).read_text())
    total = sum(seconds for _, seconds in groups.values()) or 1.0
    recorded = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    print(f"{'seconds':>8} {'share':>6} {'before':>6} {'tests':>6}  group")
    for group, (tests, seconds) in sorted(groups.items(), key=lambda g: -g[1][1]):
        before = recorded.get(group)
        before = "" if before is None else f"{before:.1%}"
        if tests:
            print(
                f"{seconds:8.1f} {seconds / total:6.1%} {before:>6} {tests:6}  {group}"
            )
    print(f"{total:8.1f}  in all")
    if "--record" in sys.argv:
        shares = {
            group: round(seconds / total, 4)
            for group, (tests, seconds) in sorted(groups.items())
            if tests
        }
        RECORD.write_text(json.dumps(shares, indent=1) + "\n")


main()
