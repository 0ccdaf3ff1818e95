#!/bin/bash
# prices.sh check PROGRAM [COUNT [SEED]]: holds the costs that lesson 9 counts against callgrind's instructions.
# prices.sh fit PROGRAM > lessons/catalogue/prices.inc: measures the prices anew, three minutes.
set -euo pipefail
command=$1 program=$(readlink -f -- "$2") count=${3:-6000} seed=${4:-1}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
valgrind -q --tool=callgrind --callgrind-out-file=counts "$program" run "$count" "$seed" >counted
"$program" "$command" counted counts.* || { [ "$command" = fit ] || echo "Again: with --seed=$seed" >&2; exit 1; }
