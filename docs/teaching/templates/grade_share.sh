#!/bin/sh
# Grades every n-th submission of a folder: the share of one of n jobs.
#
#   grade_share.sh COURSE SUBMISSIONS OUT INDEX TOTAL      INDEX from 1
#
# The reports of each submission are in OUT/<number>, for `course teach merge`. Goes on after a submission that could
# not be graded, and ends with 70 then. The environment is that of grade_one.sh.
set -eu
[ $# -eq 5 ] || { echo "usage: grade_share.sh COURSE SUBMISSIONS OUT INDEX TOTAL" >&2; exit 4; }
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
number=0
worst=0
for submission in "$2"/*; do
  [ -e "$submission" ] || continue
  number=$((number + 1))
  [ $(((number - 1) % $5 + 1)) -eq "$4" ] || continue
  code=0
  sh "$here/grade_one.sh" "$1" "$submission" "$3/$number" || code=$?
  [ "$code" -eq 0 ] || { worst=70; echo "not graded ($code): submission $number" >&2; }
done
exit "$worst"
