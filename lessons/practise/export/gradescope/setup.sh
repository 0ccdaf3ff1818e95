#!/bin/bash
# Gradescope runs this once, when it builds the image.
set -euo pipefail
bash /autograder/source/build.sh
