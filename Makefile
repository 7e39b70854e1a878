# The workbook: `make help` lists what can be made.

PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do \
  $$p -c 'import sys; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 14))' 2>/dev/null && { echo $$p; break; }; done)
VENV ?= .venv
BIN := $(VENV)/bin
# The environment is ready when this file is newer than what it is made from.
INSTALLED ?= $(VENV)/.installed
PYTEST := $(BIN)/python -m pytest
# `make book PAGE=no` builds the pages without answer boxes, which need 80 MB.
PAGE ?= yes
CORES := $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
# Hundreds of processes import the library; compiled once, it is read by all.
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.PHONY: help book book-student outputs mistakes again page wheels serve pdf bundle release test test-quick test-page test-pdf test-problem \
  test-units test-sandboxes clean

help:  ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-15s%s\n", $$1, $$2}' $(MAKEFILE_LIST)

# On Windows `py book\build.py` takes these steps.
book: outputs mistakes again page wheels  ## execute what is stale and build the site in _build/html
	$(BIN)/python book/build.py site

book-student: outputs again page wheels  ## build the edition without solutions in _build/student/html
	$(BIN)/python book/build.py student

outputs: $(INSTALLED)
	$(BIN)/python book/build.py outputs

# Each uses all cores: one after the other.
mistakes: outputs
	$(BIN)/python book/build.py mistakes

again: $(INSTALLED)
	$(BIN)/python book/build.py again

# Python for the answer boxes of the pages, in _build/run.
page: $(INSTALLED)
	$(if $(filter no,$(PAGE)),rm -rf _build/run,$(BIN)/python book/build.py page)

# The page of downloads then offers what was made.
pdf: book  ## print the site as PDF with Chromium, chapter by chapter and whole, in _build/pdf
	$(BIN)/python book/pdf.py
	@$(MAKE) --no-print-directory book

bundle: book  ## pack the site with notebooks and wheels for a memory stick, in _build/bundle
	@rm -rf _build/bundle _build/html/bundle && mkdir _build/bundle
	cd _build/html && $(abspath $(BIN))/python -m zipfile -c ../bundle/controlled-motion.zip *
	@$(MAKE) --no-print-directory book

release: $(INSTALLED)  ## make all that is published from a fresh clone, in _build/release; list it
	$(BIN)/python book/release.py

serve:  ## show the built site at http://127.0.0.1:8000
	@test -f _build/html/index.html || { echo "There is no site yet: run make book first." >&2; exit 1; }
	@echo "The site is at http://127.0.0.1:8000 (Ctrl-C ends)"
	@$(BIN)/python -m http.server --bind 127.0.0.1 --directory _build/html 8000

# The tests of the grader mostly wait, so they run beside all others. Those compute, and two processes for one core would
# take a sixth longer than one after the other.
test: $(INSTALLED)  ## the style of the code, its types and arrows, and all tests
	$(BIN)/ruff format --check --quiet
	$(BIN)/ruff check --quiet
	$(BIN)/lint-imports --no-cache --no-logo
	$(BIN)/mypy --no-error-summary
	@mkdir -p _build/tests
	@$(PYTEST) -n 2 tests/grading --junitxml=_build/tests/grader.xml > _build/tests/grader.log 2>&1 & grader=$$!; \
	  trap 'kill $$grader' INT TERM; \
	  $(PYTEST) -n $(CORES) --ignore=tests/grading --ignore=tests/site --junitxml=_build/tests/others.xml; others=$$?; \
	  $(PYTEST) -n $(CORES) tests/site --junitxml=_build/tests/site.xml; site=$$?; \
	  wait $$grader; graded=$$?; cat _build/tests/grader.log; exit $$((others | site | graded))

test-problem: $(INSTALLED)  ## all tests of one problem: make test-problem N=2.30
	@test -n "$(N)" || { echo "Name the problem: make test-problem N=2.30" >&2; exit 2; }
	@$(BIN)/workbook exercises $(N)
	$(PYTEST) -n 0 tests/problems tests/authoring/test_rules.py -k "[$(N)] or test_rule"

test-page: $(INSTALLED)  ## judge all masters and trials by the Python of the pages, in Chromium
	WORKBOOK_ALL_PROBLEMS=1 $(PYTEST) -n 0 tests/page

test-pdf: $(INSTALLED)  ## print all chapters as PDF and look at every sheet
	WORKBOOK_ALL_PROBLEMS=1 $(PYTEST) -n 0 tests/site/test_pdf.py

test-quick: $(INSTALLED)  ## a sample of each layer in two minutes: what tests/quick.txt lists
	$(PYTEST) -n logical $$(sed 's/ *#.*//' tests/quick.txt)

test-lectures: $(INSTALLED)  ## play every lecture to the end, as slides and in JupyterLab
	WORKBOOK_EVERY_LECTURE=1 $(PYTEST) -n 0 tests/live/test_playing.py

test-units: $(INSTALLED)  ## all problems of optimal control in other units and from other origins
	WORKBOOK_ALL_PROBLEMS=1 $(PYTEST) -n $(CORES) tests/library/test_pontryagin_units.py tests/problems/test_rescaling.py

test-sandboxes: $(INSTALLED)  ## all attacks in WebAssembly, and a large class in both sandboxes
	WORKBOOK_ALL_PROBLEMS=1 $(PYTEST) -n 0 tests/grading/test_wasm.py tests/grading/hostile/test_hostile.py -k "wasm"

clean:  ## remove everything built, but not the environment
	rm -rf _build conf.py

wheels: $(INSTALLED)
	$(BIN)/python book/build.py wheels

$(VENV)/.installed: requirements.txt pyproject.toml
	@test -n "$(PYTHON)" || { echo "Python 3.11, 3.12, 3.13 or 3.14 is needed and none was found (make PYTHON=... names one)." >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 14))' || \
	  { echo "Python 3.11, 3.12, 3.13 or 3.14 is needed; $(PYTHON) is another version." >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo "Python's venv is missing; on Debian and Ubuntu install the package python3-venv." >&2; exit 1; }
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet -r requirements.txt
	$(BIN)/pip install --quiet --no-deps -e .
	@touch $@
