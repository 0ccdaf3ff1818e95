#!/bin/bash
# grade.sh SUBMISSION RESULTS: writes RESULTS/junit.xml.
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$2"
"$here/build/lessons/grade" --keys "$here/keys" --submission "$1" --report "junit=$2/junit.xml"
