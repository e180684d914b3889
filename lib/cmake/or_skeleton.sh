#!/bin/sh
# or_skeleton.sh MINE SKELETON COMMAND...: compiles a student's file, and the skeleton in its place where that fails or
# lacks a function that the skeleton has.
mine=$1
given=$2
shift 2

object=
previous=
for word in "$@"; do
  [ "$previous" = -o ] && object=$word
  previous=$word
done

defined() { nm -g --defined-only "$1" 2>/dev/null | awk '$2 == "T" { print $3 }' | sort; }

# instead FILE OBJECT COMMAND...: the command on the skeleton, its output to another object.
instead() {
  to=$1
  shift
  for word in "$@"; do
    shift
    case $word in
    "$mine") word=$given ;;
    "$object") word=$to ;;
    "$object.d") word=$to.d ;;
    esac
    set -- "$@" "$word"
  done
  "$@"
}

if "$@" 2>"$object.said"; then
  cat "$object.said" >&2
  if instead "$object.given" "$@" 2>/dev/null; then
    lacking=$(defined "$object" >"$object.has"; defined "$object.given" | comm -23 - "$object.has")
    rm -f "$object.given" "$object.given.d" "$object.has" "$object.said"
    [ -z "$lacking" ] && exit 0
  fi
  echo "$mine lacks a function that others call: the library goes without it" >&2
else
  echo "$mine does not compile: the library goes without it" >&2
fi
rm -f "$object.said"
instead "$object" "$@"
