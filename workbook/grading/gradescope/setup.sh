#!/usr/bin/env bash
# Gradescope runs this once, as root, when the autograder is uploaded. It installs Python and the workbook, and adds a
# user for students' code.
set -euo pipefail

apt-get update
for version in 3.14 3.13 3.12 3.11; do
  if apt-get install -y --no-install-recommends "python$version" "python$version-venv"; then
    python="python$version"
    break
  fi
done
if [[ -z "${python:-}" ]]; then
  echo "The workbook needs Python 3.11 or newer: choose Ubuntu 22.04 or newer as the base image." >&2
  exit 1
fi

# The system's own Python is not changed, since Gradescope's harness runs on it.
"$python" -m venv /opt/workbook
wheel=$(echo /autograder/source/trajlib-*.whl)
/opt/workbook/bin/pip install --no-cache-dir --constraint /autograder/source/constraints.txt "${wheel}[workbook]"
useradd --system --no-create-home --shell /usr/sbin/nologin workbook-student
