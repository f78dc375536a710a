#!/usr/bin/env bash
# tasks_list.sh TASKS: the page of tasks has forty, and each has its test.
tests=$(cd "$(dirname "$0")" && pwd)
listed=$(sed -n 's/^| \([0-9]*\) | .*/\1/p' "$1")
[ "$listed" = "$(seq 40)" ] || { echo "FAILED: $1 does not count from 1 to 40" >&2; exit 1; }
tested=$(sed -n 's/^ *task \([0-9]*\) .*/\1/p' "$tests"/tasks_{particles,volumes}.sh | sort -n)
[ "$tested" = "$listed" ] ||
  { diff <(echo "$listed") <(echo "$tested") >&2; echo "FAILED: tasks and tests differ" >&2; exit 1; }
