#!/usr/bin/env bash
# Gradescope runs this once, when the image is made. Zip setup.sh, run_autograder and a copy of the course in a folder
# `carom` (with course.ini and the file of its secret), and upload the zip as the autograder.
set -euo pipefail
source=${AUTOGRADER:-/autograder}/source
export DEBIAN_FRONTEND=noninteractive
# Ubuntu 22.04 has a newer compiler beside the usual one.
if ! g++ -dumpversion | grep -qE '^1[2-9]'; then
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends g++-12
  export CXX=g++-12
fi
apt-get update -qq
apt-get install -y -qq --no-install-recommends bubblewrap
cd "$source/carom"
# Installs what is missing, configures and builds the runner; then every grader, so that no submission waits for it.
./course list >/dev/null
cmake --build build/default --target graders
