PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed

.PHONY: demo test check format page clean

demo: $(INSTALLED)  ## fold and open the reference wing; results in out/binder2025/
	$(BIN)/forficula run binder2025 --out out/binder2025

test: $(INSTALLED)  ## run all tests
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -n auto  # the cores are taken: more threads would only wait for one another

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

clean:
	rm -rf $(VENV) out

$(INSTALLED): pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade "pip>=25.1"
	$(BIN)/python -m pip install --quiet --editable . --group dev
	touch $@
