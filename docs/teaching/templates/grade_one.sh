#!/bin/sh
# Grades one submission, as jobs of CI systems and the autograder of Gradescope do.
#
#   grade_one.sh COURSE SUBMISSION OUT
#
# COURSE is the teacher's copy of the course, SUBMISSION a folder, archive or repository, OUT where the reports go.
# From the environment:
#   STUDENT        the student's name; without: the name of the submission
#   COURSE_FILE    the course file, from COURSE; without: all exercises
#   COURSE_SECRET  the secret of the seeds, written beside the course file under the name that it has there
#   CAROM_TRUST    yes: grade even where no sandbox can be had
#   CAROM_COURSE   the program that grades; without: COURSE/course
# The exit code is the grader's: 0 graded, 70 not graded through a fault of ours.
set -eu
[ $# -eq 3 ] || { echo "usage: grade_one.sh COURSE SUBMISSION OUT" >&2; exit 4; }
course=$1
submission=$2
out=$3

set -- teach grade "$submission" --out "$out"
[ -z "${STUDENT:-}" ] || set -- "$@" --student "$STUDENT"
if [ -n "${COURSE_FILE:-}" ]; then
  file=$course/$COURSE_FILE
  if [ -n "${COURSE_SECRET:-}" ]; then
    name=$(sed -n 's/^secret *= *//p' "$file" | head -n 1)
    [ -n "$name" ] || { echo "$file names no secret, but COURSE_SECRET is given" >&2; exit 4; }
    (umask 077 && printf '%s\n' "$COURSE_SECRET" >"$(dirname -- "$file")/$name")
  fi
  set -- "$@" --course "$file"
fi
[ "${CAROM_TRUST:-}" != yes ] || set -- "$@" --trust-submissions
unset COURSE_SECRET
exec "${CAROM_COURSE:-$course/course}" "$@"
