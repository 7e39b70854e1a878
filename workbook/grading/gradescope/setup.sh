#!/usr/bin/env bash
# Gradescope runs this once, as root, when the autograder is uploaded. It adds a user for students' code, installs Python
# and the workbook, and runs a notebook as that user.
set -euo pipefail

useradd --system --no-create-home --shell /usr/sbin/nologin workbook-student
as_student() {
  setpriv --reuid workbook-student --regid "$(id -g workbook-student)" --clear-groups "$@"
}

apt-get update
for version in 3.14 3.13 3.12 3.11; do
  apt-get install -y --no-install-recommends "python$version" "python$version-venv" || continue
  # The first one on the path may be root's own, which the student's user can neither read nor run.
  for candidate in $(type -aP "python$version"); do
    if as_student "$candidate" -I -c "import ssl, venv"; then
      python="$candidate"
      break 2
    fi
  done
done
if [[ -z "${python:-}" ]]; then
  echo "The workbook needs a Python 3.11 or newer that every user can run: choose Ubuntu 22.04 or newer as the base image." >&2
  exit 1
fi

# The system's own Python is not changed, since Gradescope's harness runs on it.
"$python" -m venv /opt/workbook
wheel=$(echo /autograder/source/trajlib-*.whl)
/opt/workbook/bin/pip install --no-cache-dir --constraint /autograder/source/constraints.txt "${wheel}[workbook]"
/opt/workbook/bin/python -I -c "from workbook.grading.gradescope import autograder; autograder.trial()"
