#!/usr/bin/env python3
"""Classroom 50 runs this in the learner's checkout: writes result.json, annotations and the summary."""

import os
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
judge = here / "build" / "lessons" / "grade"
if not judge.exists():
    become_root = ["sudo"] if os.geteuid() != 0 else []
    subprocess.run([*become_root, str(here / "build.sh")], check=True, stdout=sys.stderr)
    subprocess.run([*become_root, "chmod", "-R", "go+rX", str(here / "keys")], check=True)
reports = ["classroom50=result.json", "github=-"]
if "GITHUB_STEP_SUMMARY" in os.environ:
    reports.append("summary=" + os.environ["GITHUB_STEP_SUMMARY"])
command = [str(judge), "--keys", str(here / "keys"), "--submission", os.getcwd()]
for report in reports:
    command += ["--report", report]
sys.exit(subprocess.run(command, check=False).returncode)
