PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
INSTALLED_DOCS := $(VENV)/.installed-docs

.PHONY: demo test browsers check format page docs docs-all docs-links validation clean

demo: $(INSTALLED)  ## fold and open the reference wing; results in out/binder2025/
	$(BIN)/forficula run binder2025 --out out/binder2025

test: $(INSTALLED)  ## run all tests
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -n auto  # the cores are taken: more threads would only wait for one another

browsers: $(INSTALLED)  ## every kind of page in a second browser, which must be there: Firefox; before a release
	FORFICULA_NEED_FIREFOX=1 $(BIN)/python -m pytest tests/show/page/test_pages_in_firefox.py

check: $(INSTALLED)  ## lint, types, layers
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/lint-imports

format: $(INSTALLED)
	$(BIN)/ruff check --fix
	$(BIN)/ruff format

page:  ## build the script of the HTML pages, which is kept in the package; needs Node.js
	cd web && npm ci && npm run build

docs: $(INSTALLED_DOCS)  ## build the documentation into docs/_build/html; it runs all that it shows
	$(BIN)/python -m sphinx -W --keep-going -q -j 2 -d docs/_build/doctrees docs docs/_build/html
	$(BIN)/python docs/check_pages.py docs/_build/html

docs-all: validation  ## the same with what takes minutes: all validation tests, and the study beside the paper
	FORFICULA_DOCS=all $(MAKE) docs

docs-links: $(INSTALLED_DOCS)  ## ask the network whether what the documentation links to is there
	$(BIN)/python -m sphinx -q -b linkcheck -d docs/_build/doctrees docs docs/_build/links

validation: $(INSTALLED_DOCS)  ## run all validation tests; the next make docs tells of all of them
	mkdir -p docs/_build
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -n auto tests/validation --junitxml=docs/_build/validation.xml

clean:
	rm -rf $(VENV) out docs/_build docs/gallery

$(INSTALLED): pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade "pip>=25.1"
	$(BIN)/python -m pip install --quiet --editable . --group dev
	touch $@

$(INSTALLED_DOCS): $(INSTALLED)
	$(BIN)/python -m pip install --quiet --group docs
	touch $@
