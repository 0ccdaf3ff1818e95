#!/bin/bash
# The entry point of PrairieLearn's external grading.
set -u
mkdir -p /grade/results
/judge/build/lessons/grade --keys /judge/keys --submission /grade/student \
  --report prairielearn=/grade/results/results.json
